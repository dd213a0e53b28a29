"""The sizes of a state's components, as the system gives them, for many states in one compiled function."""

from __future__ import annotations

import jax
import jax.numpy as jnp
import numpy as np

from polhode._base.arrays import arrays_for_few_calls
from polhode.systems.base import AbstractSystem
from polhode.types import Array, Double, Float64


def component_sizes(system: AbstractSystem, states: Double[Array, "copies ..."]) -> Float64[np.ndarray, "copies ..."]:
    """Return ``system.scales`` of each of the states (C, *shape), one for each component."""
    return np.asarray(_sizes(system, np.asarray(states)))


@arrays_for_few_calls
def _sizes(system: AbstractSystem, states: Array) -> Array:
    return jnp.real(jax.vmap(lambda state: jnp.broadcast_to(system.scales(state), jnp.shape(state)))(states))
