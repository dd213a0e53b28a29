"""Steady rolling of a disk: the derivatives of its equations, its energy and its linear integrals.

Without dissipation θ, ω1, ω2, ω3 move by themselves, on levels of two integrals that are linear in ω2 and ω3: along any
motion (ω2, ω3)′ = M(θ) (ω2, ω3). Carried along θ to the tilt of a steady motion they are J2, J3, which play the part of
Casimirs; their first and second derivatives there follow from M and M′ alone, thick or thin.

Source: Routh, *Advanced Rigid Dynamics* (1905), §244; O'Reilly, Nonlinear Dyn. 10 (1996) 287; for energy and linear
integrals Zenkov, J. Nonlinear Sci. 5 (1995) 503.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

import jax
import jax.numpy as jnp
import numpy as np

from polhode.errors import InvalidInput
from polhode.rolling.euler_disk._mechanics import RollingMechanics
from polhode.systems.steady_motion import SteadyMotion
from polhode.types import Array, Float64

WITHOUT_DISSIPATION = "`disk` must be without `dissipation`: with it no motion is steady. Judge the disk without."


class SteadyLimits(NamedTuple):
    """What decides whether a state is steady."""

    relative_acceleration: float = 1e-8  # of the terms of θ̈; more than a solver, or the digits of a typed state, leave


LIMITS = SteadyLimits()


def differentiate_rolling(mechanics: RollingMechanics, parts: Sequence[Float64[Array, ""]]) -> SteadyMotion:
    """Return the derivatives at θ, ω1, ω2, ω3 of one state.

    Raises:
        InvalidInput: for several states, or one that is not steady.
    """
    if jnp.ndim(parts[0]):
        raise InvalidInput(f"`state` must be one state (8,); got shape {(*jnp.shape(parts[0]), 8)}.")
    x = np.stack([np.asarray(part) for part in parts])
    flow, slope, curvature, dJ, ddJ, field = (np.asarray(v) for v in _matrices(mechanics, x))
    size = float(mechanics.gravity / mechanics.radius) + float(np.sum(np.asarray(x[1:]) ** 2))
    relative = LIMITS.relative_acceleration
    if abs(field[0]) > relative * math.sqrt(size) or abs(field[1]) > relative * size:
        raise InvalidInput(
            f"the state is not steady: θ̇ = {field[0]:.3g} rad/s and θ̈ = {field[1]:.3g} rad/s². "
            "Make one by `disk.rolling_state`."
        )
    return SteadyMotion(
        flow, slope, curvature, dJ, ddJ, ("J2", "J3"),
        "J2, J3 are ω2, ω3 carried to this tilt by their linear equations", ("tilt", "rates"), ("heading", "place"),
    )


@jax.jit
def _matrices(disk: RollingMechanics, x: Array) -> tuple[Array, ...]:
    """Return linearisation, dE, D²E, dJ (2, 4), D²J (2, 4, 4) and the field at x = (θ, ω1, ω2, ω3)."""

    def field(x: Array) -> Array:
        d2, d3 = disk.transport(x[0], x[2], x[3])
        return jnp.stack([x[1], disk.tilt_acceleration(x[0], x[2], x[3]), d2 * x[1], d3 * x[1]])

    def matrix(theta: Array) -> Array:
        columns = [jnp.stack(disk.transport(theta, *w)) for w in jnp.eye(2)]
        return jnp.stack(columns, axis=1)

    def energy(x: Array) -> Array:
        return disk.energy(x[0], x[1], x[2], x[3])

    w = x[2:]
    M, dM = matrix(x[0]), jax.jacfwd(matrix)(x[0])
    # J(θ, w) = Φ(θ) w with Φ = 1 here and Φ′ = −ΦM
    dJ = jnp.concatenate([(-M @ w)[:, None], jnp.zeros((2, 1)), jnp.eye(2)], axis=1)
    ddJ = jnp.zeros((2, 4, 4)).at[:, 0, 0].set((M @ M - dM) @ w).at[:, 0, 2:].set(-M).at[:, 2:, 0].set(-M)
    return jax.jacfwd(field)(x), jax.grad(energy)(x), jax.hessian(energy)(x), dJ, ddJ, field(x)
