"""The free rigid body on so(3)*, the first example."""

from __future__ import annotations

from typing import Any

import jax.numpy as jnp
import numpy as np

from polhode.algebra.base import AbstractLieAlgebra
from polhode.algebra.so3 import SO3
from polhode.errors import InvalidInput
from polhode.systems.base import AbstractLiePoissonSystem, Flow, attitude_change, joined

Array = Any


class FreeRigidBody(AbstractLiePoissonSystem):
    """L̇ = L × Ω, Ω = L/I, along principal axes; state L (…, 3), or attitude and L (…, 7).

    Its exact motion is ``polhode.FreeMotion``. Flows: rotation about each axis, from H = Σ L_i²/2I_i.

    Args:
        moments: (3,) principal moments [kg m²], positive.
    """

    algebra: AbstractLieAlgebra
    moments: Array

    def __init__(self, moments: Array) -> None:
        self.algebra, self.moments = SO3(), checked_moments(moments)

    def energy(self, point: Array) -> Array:
        return 0.5 * jnp.sum(point * point / self.moments, axis=-1)

    def velocity(self, point: Array) -> Array:
        return point / self.moments

    @property
    def flows(self) -> dict[str, Flow]:
        return {f"rotation about axis {k + 1}": axis_flow(self, k) for k in range(3)}


def axis_flow(system: AbstractLiePoissonSystem, axis: int) -> Flow:
    """Return the flow of L_i²/2I_i: all vectors (…, 3) of the point turn about axis i against the angle tL_i/I_i."""
    i, j, k = axis, (axis + 1) % 3, (axis + 2) % 3

    def flow(time: Array, state: Array) -> Array:
        attitude, point = system.parts(state)
        half = (0.5 * time) * point[..., i] / system.moments[i]  # type: ignore[attr-defined]
        sine, cosine = jnp.sin(half), jnp.cos(half)
        s, less = 2.0 * sine * cosine, -2.0 * sine * sine
        changes = []
        for start in range(0, point.shape[-1], 3):
            x, y = point[..., start + j], point[..., start + k]
            parts = [jnp.zeros_like(x)] * 3
            parts[j], parts[k] = less * x + s * y, less * y - s * x
            changes += parts
        if attitude is None:
            return jnp.stack(changes, axis=-1)
        # cos − 1 of the half angle, without cancellation
        small = -sine * sine / (1.0 + cosine)
        less_one = jnp.where(cosine > 0.0, small, cosine - 1.0)
        axis_sine = [sine * (n == i) for n in range(3)]
        turned = attitude_change(attitude, jnp.stack(axis_sine, axis=-1), less_one[..., None])
        return joined(turned, jnp.stack(changes, axis=-1))

    return flow


def checked_moments(moments: Array) -> Array:
    """Return three positive finite moments as an array.

    Raises:
        InvalidInput: otherwise.
    """
    values = np.asarray(moments, dtype=float)
    if values.shape != (3,) or not (np.isfinite(values).all() and (values > 0).all()):
        raise InvalidInput(f"`moments` must be three positive finite numbers [kg m²]; got {values.tolist()}.")
    return jnp.asarray(values)
