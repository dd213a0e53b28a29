"""The sizes of a state's components, as the system gives them, for many states in one compiled function."""

from __future__ import annotations

from typing import TypeGuard

import jax
import jax.numpy as jnp
import numpy as np

from polhode._base.arrays import arrays_for_few_calls
from polhode.systems._forms import facts_of, has_attitude
from polhode.systems.base import AbstractLiePoissonSystem, AbstractSystem
from polhode.types import Array, Double, Float64


def has_sizes_by_algebra(system: AbstractSystem) -> TypeGuard[AbstractLiePoissonSystem]:
    """Return whether the algebra defines the sizes of a state's parts, and the system names none of its own."""
    own = type(system).scales is not AbstractLiePoissonSystem.scales
    return isinstance(system, AbstractLiePoissonSystem) and not own


def component_sizes(system: AbstractSystem, states: Double[Array, "copies ..."]) -> Float64[np.ndarray, "copies ..."]:
    """Return ``system.scales`` of each of the states (C, *shape), one for each component."""
    states = np.asarray(states)
    if has_sizes_by_algebra(system) and facts_of(system).state_axes == 1:
        return _by_algebra(system, states)
    return np.asarray(_sizes(system, states))


def _by_algebra(
    system: AbstractLiePoissonSystem, states: Double[np.ndarray, "copies n"]
) -> Float64[np.ndarray, "copies n"]:
    """Return what ``AbstractLiePoissonSystem.scales`` does, by NumPy: one for the attitude, for the point its size."""
    turns = 4 if has_attitude(system, states.shape[1]) else 0
    sizes = np.ones(states.shape)
    largest = np.abs(states[:, turns:]).max(axis=1, initial=0.0, keepdims=True)
    sizes[:, turns:] = np.where(largest > 0.0, largest, 1.0)
    return sizes


@arrays_for_few_calls
def _sizes(system: AbstractSystem, states: Array) -> Array:
    return jnp.real(jax.vmap(lambda state: jnp.broadcast_to(system.scales(state), jnp.shape(state)))(states))
