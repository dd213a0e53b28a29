"""Turns of many vectors at once, in components: spins about fields and bonds, vortices about pairs."""

from __future__ import annotations

from collections.abc import Sequence

import jax.numpy as jnp

from polhode import rotation
from polhode.systems.base import Components
from polhode.types import Array, ArrayOrFloat, Float64

Vector3 = Sequence[Array] | Sequence[float]


def turn(spin: Vector3, axis: Vector3) -> Components:
    """Return the change of spins by a turn about ``axis`` by its length [rad], in components."""
    # Rodrigues' formula: S′ − S = (sin θ/θ) a × S + ((1 − cos θ)/θ²) a × (a × S), θ = |a|; series to θ⁴, whose next
    # terms are below 1e-20 for θ² < 1e-6
    square = axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2]
    small = square < 1e-6
    safe = jnp.where(small, 1.0, square)
    angle = jnp.sqrt(safe)
    # 1 − cos θ = 2 sin²(θ/2), by one sine and one cosine of half the angle
    sine, cosine = jnp.sin(0.5 * angle), jnp.cos(0.5 * angle)
    first = jnp.where(small, 1.0 - square / 6.0 * (1.0 - square / 20.0), 2.0 * sine * cosine / angle)
    second = jnp.where(small, 0.5 - square / 24.0 * (1.0 - square / 30.0), 2.0 * sine * sine / safe)
    once = rotation.cross_of_parts(axis, spin)
    twice = rotation.cross_of_parts(axis, once)
    return tuple(first * a + second * b for a, b in zip(once, twice, strict=True))


def dot(one: Vector3, other: Vector3) -> Float64[ArrayOrFloat, "..."]:
    """Return the scalar product of vectors in components."""
    return one[0] * other[0] + one[1] * other[1] + one[2] * other[2]
