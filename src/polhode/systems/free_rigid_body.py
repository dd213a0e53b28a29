"""The free rigid body on so(3)*, the first example."""

from __future__ import annotations

from typing import ClassVar

import jax.numpy as jnp

from polhode._base import check
from polhode._base.arrays import known_numbers_only
from polhode.algebra.base import AbstractLieAlgebra
from polhode.algebra.so3 import SO3
from polhode.systems._checks import as_floats
from polhode.systems.base import AbstractLiePoissonSystem, Components, Flow
from polhode.types import Array, ArrayLike, ArrayOrFloat, Float64, Real


class FreeRigidBody(AbstractLiePoissonSystem):
    """L̇ = L × Ω, Ω = L/I, along principal axes; state L (…, 3), or attitude and L (…, 7).

    Its exact motion is ``polhode.FreeMotion``. Flows: rotation about each axis, from H = Σ L_i²/2I_i.

    Args:
        moments: (3,) principal moments [kg m²], positive.
    """

    title: ClassVar[str] = "Free motion"
    algebra: AbstractLieAlgebra
    moments: Float64[Array, "3"]

    @known_numbers_only
    def __init__(self, moments: Real[ArrayLike, "3"]) -> None:
        self.algebra, self.moments = SO3(), checked_moments(moments)

    def energy(self, point: Float64[Array, "*batch 3"]) -> Float64[Array, "*batch"]:
        return 0.5 * jnp.sum(point * (point / self.moments), axis=-1)

    def velocity(self, point: Float64[Array, "*batch 3"]) -> Float64[Array, "*batch 3"]:
        return point / self.moments

    @property
    def free_moments(self) -> Float64[Array, "3"]:
        return self.moments

    @property
    def flows(self) -> dict[str, Flow]:
        return axis_flows(self.moments, vectors=1)


def axis_flows(moments: Float64[Array, "3"], vectors: int) -> dict[str, Flow]:
    """Return the flows of the three parts L_i²/2I_i of a free body's energy; see ``axis_flow``."""
    return {f"rotation about axis {k + 1}": axis_flow(moments, k, vectors) for k in range(3)}


def axis_flow(
    moments: Float64[Array, "3"], axis: int, vectors: int, offset: Float64[ArrayOrFloat, ""] = 0.0
) -> Flow:
    """Return the flow of (L_i − h)²/2I_i: vectors turn about axis i by −t(L_i − h)/I_i, the attitude by the inverse.

    Args:
        moments: (3,) [kg m²].
        axis: i, from 0.
        vectors: how many of three components a point has, the first the momentum; a quaternion may stand in front.
        offset: h [kg m²/s].
    """
    i, j, k = axis, (axis + 1) % 3, (axis + 2) % 3

    def flow(time: Array, state: Components) -> Components:
        start = len(state) - 3 * vectors
        # from a quarter of the angle, so that neither cosine less one cancels, without a branch
        quarter = (0.25 * time / moments[i]) * (state[start + i] - offset)
        # sin(α/2) = 2 s c and cos(α/2) − 1 = −2s² from the quarter, sin α and cos α − 1 from the half
        s, c = jnp.sin(quarter), jnp.cos(quarter)
        sine, less_half = 2.0 * s * c, -2.0 * s * s
        s, less = 2.0 * sine * (1.0 + less_half), -2.0 * sine * sine
        changes = [jnp.zeros_like(x) for x in state]
        for n in range(start, len(state), 3):
            x, y = state[n + j], state[n + k]
            # v̇ = v × e_i (L_i − h)/I_i: a turn about e_i by −α
            changes[n + j], changes[n + k] = less * x + s * y, less * y - s * x
        if start:
            w, a, b, c = state[0], state[1 + i], state[1 + j], state[1 + k]
            # q (cos α/2, e_i sin α/2) − q
            changes[0], changes[1 + i] = less_half * w - sine * a, less_half * a + sine * w
            changes[1 + j], changes[1 + k] = less_half * b + sine * c, less_half * c - sine * b
        return tuple(changes)

    return flow


def checked_moments(moments: Real[ArrayLike, "3"]) -> Float64[Array, "3"]:
    """Return three positive finite moments as an array.

    Raises:
        InvalidInput: otherwise.
    """
    remedy = "A matrix makes a `Body.from_inertia`; take its `principal_moments`, or `RigidBody.from_body` of it."
    is_tensor = as_floats(moments).shape == (3, 3)
    return jnp.asarray(check.array("moments", moments, (3,), "kg m²", above=0, remedy=remedy if is_tensor else ""))
