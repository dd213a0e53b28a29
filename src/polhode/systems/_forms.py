"""Checks of the shapes of a system's rates of change and events."""

from __future__ import annotations

import jax.numpy as jnp

from polhode.errors import InvalidInput
from polhode.systems.base import AbstractSystem
from polhode.types import Array, Double, Float64


def rates_of_change(
    system: AbstractSystem, t: Float64[Array, ""], state: Double[Array, "*shape"]
) -> Double[Array, "*shape"]:
    """Return the rates of change of a state (*shape), without broadcasting or dropped imaginary parts.

    Raises:
        InvalidInput: for rates of another shape, or complex rates of a real state.
    """
    field = system.vector_field(t, state)
    shape, wanted = jnp.shape(field), jnp.shape(state)
    if shape != wanted:
        raise InvalidInput(
            f"`vector_field` of {type(system).__name__} must give the rates of change of a state, in its shape; "
            f"got shape {shape} for {wanted}."
        )
    if jnp.iscomplexobj(field) and not jnp.iscomplexobj(state):
        raise InvalidInput(
            f"`vector_field` of {type(system).__name__} gives complex rates of change of a real state. Override "
            "`check_state` so that states are complex."
        )
    return jnp.asarray(field)


def distances(system: AbstractSystem, t: Float64[Array, ""], state: Double[Array, "..."]) -> Float64[Array, "events"]:
    """Return the system's events at a state, positive until their zero.

    Raises:
        InvalidInput: for an event that is not one number.
    """
    values = {name: event(t, state) for name, event in system.events.items()}
    for name, value in values.items():
        if jnp.shape(value) != ():
            shape = jnp.shape(value)
            raise InvalidInput(f"an event must be one number at a time and a state; {name} has shape {shape}.")
    return jnp.stack(list(values.values()))
