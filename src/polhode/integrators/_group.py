"""The change of an attitude by a group element, without cancellation."""

from __future__ import annotations

import jax.numpy as jnp

from polhode.algebra.base import AbstractLieAlgebra
from polhode.algebra.so3 import half_angle_factors
from polhode.systems.base import attitude_change
from polhode.types import Array, Double, Float64


def attitude_by_exp(
    algebra: AbstractLieAlgebra, attitude: Float64[Array, "*batch 4"] | None, x: Double[Array, "..."]
) -> Float64[Array, "*batch 4"] | None:
    """Return the change of attitudes (…, 4) by exp of elements of an algebra."""
    if attitude is None:
        return None
    turn = algebra.of_rotations(x)
    s, c = half_angle_factors(turn)
    square = jnp.sum(turn * turn, axis=-1, keepdims=True)
    less = jnp.where(c > 0.0, -0.25 * s * s * square / (1.0 + c), c - 1.0)
    return attitude_change(attitude, 0.5 * s * turn, less)


def attitude_by_cayley(
    algebra: AbstractLieAlgebra, attitude: Float64[Array, "*batch 4"] | None, x: Double[Array, "..."]
) -> Float64[Array, "*batch 4"] | None:
    """Return the change of attitudes (…, 4) by Cayley's map."""
    if attitude is None:
        return None
    turn = algebra.of_rotations(x)
    tangent = 0.25 * jnp.sum(turn * turn, axis=-1, keepdims=True)
    w = 1.0 / jnp.sqrt(1.0 + tangent)
    return attitude_change(attitude, 0.5 * w * turn, -tangent * w * w / (1.0 + w))
