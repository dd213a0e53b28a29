"""Hysteresis: equilibria of damped spins as the field changes along a path."""

from __future__ import annotations

from typing import NamedTuple

import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np

from polhode._base import check
from polhode._base.arrays import known_numbers_only
from polhode.errors import InvalidInput, shown
from polhode.fields.spin_lattice.system import SpinLattice
from polhode.integrators.spherical_midpoint import SphericalMidpoint
from polhode.solving import solve
from polhode.types import Array, ArrayLike, Float64, Real


class HysteresisLoop(NamedTuple):
    """Spins at rest along a path of fields.

    Attributes:
        fields: (F, 3).
        states: (F, L1, L2, L3, b, 3).
        mean_spin: (F, 3).
        torque: (F,) the largest |S × B| left, which shows whether the spins had come to rest.
    """

    fields: Float64[np.ndarray, "fields 3"]
    states: Float64[np.ndarray, "..."]
    mean_spin: Float64[np.ndarray, "fields 3"]
    torque: Float64[np.ndarray, "fields"]


@known_numbers_only
def hysteresis_loop(
    system: SpinLattice, state: Real[ArrayLike, "..."], fields: Real[ArrayLike, "fields 3"], wait: float, step: float
) -> HysteresisLoop:
    """Return the spins after waiting at each field in turn.

    Spins exactly at a saddle stay there, as nothing perturbs them; tilt the field or the start a little.

    Args:
        system: with damping and with a field, whose value does not matter.
        state: (L1, L2, L3, b, 3) to begin with.
        fields: (F, 3) in turn.
        wait: time at each field; some 10/(λB) to come to rest.
        step: of time.

    Raises:
        InvalidInput: for a system without damping or field, and steps that do not converge.

    Source: Stoner & Wohlfarth, Phil. Trans. R. Soc. A 240 (1948) 599, for one spin.
    """
    if not system.is_damped or system.field is None:
        raise InvalidInput("`system` must have damping, to come to rest, and a field that is not zero, to be replaced.")
    path = check.array("fields", fields, ("F", 3))

    def rest(now: Array, field: Array) -> tuple[Array, tuple[Array, Array]]:
        there = eqx.tree_at(lambda s: s.field, system, field)
        end = solve(there, now, jnp.array([0.0, wait]), SphericalMidpoint, step, order=2).end_state
        torque = jnp.cross(end, there.effective_field(end))
        return end, (end, jnp.max(jnp.linalg.norm(torque, axis=-1)))

    _, (states, torque) = jax.jit(lambda start: jax.lax.scan(rest, start, jnp.asarray(path)))(jnp.asarray(state, float))
    states = np.asarray(states)
    if not np.isfinite(states).all():
        raise InvalidInput(f"`step` must be shorter: at {shown(step)} the steps do not converge.")
    return HysteresisLoop(path, states, states.mean(axis=(1, 2, 3, 4)), np.asarray(torque))
