"""Checks of the shapes of a system's rates of change and events."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from typing import Any, NamedTuple

import jax
import jax.numpy as jnp
import numpy as np

from polhode._base import check
from polhode._base.arrays import compiled_for_few_calls, is_jax
from polhode._base.kept import kept_of_object
from polhode.errors import InvalidInput, shown
from polhode.systems.base import AbstractLiePoissonSystem, AbstractSystem
from polhode.types import Array, Double, Float64

FURTHER = "further_jumps"  # the field of those jumps that a system does not name itself, see ``integrators.probing``


class StateLimits(NamedTuple):
    """What decides that a state is too large."""

    max_component: float = 1e150  # squares of larger numbers overflow


LIMITS = StateLimits()


class Facts(NamedTuple):
    """What a system says of itself whatever its state.

    Attributes:
        state_axes: how many of a state's last axes are its own.
        jumps: (J,) times [s] that it names, of NumPy.
        has_events: whether events may end its motion.
        names_all_jumps, series_of_arrays: as the system has them.
        is_of_package: whether its class is of this package, whose tests check that its descriptions agree.
    """

    state_axes: int
    jumps: Float64[np.ndarray, "jumps"]
    has_events: bool
    names_all_jumps: bool
    series_of_arrays: bool
    is_of_package: bool


@kept_of_object
def facts_of(system: AbstractSystem) -> Facts:
    """Return what a system says of itself."""
    kind = type(system)
    return Facts(system.state_axes, np.ravel(check.array("jumps", system.jumps, None, "s")), bool(system.events),
                 system.names_all_jumps, system.series_of_arrays, kind.__module__.partition(".")[0] == "polhode")


@kept_of_object
def has_attitude(system: AbstractLiePoissonSystem, width: int) -> bool:
    """Return whether states of so many numbers begin with the attitude."""
    return system.parts(np.zeros(width)).attitude is not None


def as_rows(system: AbstractSystem, state: Double[Array, "..."]) -> Double[np.ndarray, "copies ..."]:
    """Return states (batch…, *shape) one below the other, (C, *shape)."""
    state = np.asarray(state)
    return state.reshape(-1, *state.shape[state.ndim - facts_of(system).state_axes :])


def rates_of_change(
    system: AbstractSystem, t: Float64[Array, ""], state: Double[Array, "*shape"]
) -> Double[Array, "*shape"]:
    """Return the rates of change of a state (*shape), without broadcasting or dropped imaginary parts.

    Raises:
        InvalidInput: for rates that are not an array, rates of another shape, or complex rates of a real state.
    """
    field = system.vector_field(t, state)
    if not (is_jax(field) or isinstance(field, np.ndarray | np.generic | float | int | complex)):
        remedy = "Join the rates by jnp.stack([…])" if isinstance(field, list | tuple) else "Return the rates"
        raise InvalidInput(
            f"`vector_field` of {type(system).__name__} must give the rates of change of a state as an array; got a "
            f"{type(field).__name__}. {remedy}, in the state's shape {jnp.shape(state)}."
        )
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


def check_finite_rates(system: AbstractSystem, t: float, state: Double[Array, "..."]) -> None:
    """Refuse states (batch…, …) from which nothing can move, as their rates of change are not finite.

    States so large that their squares overflow are left to other checks.
    """
    batch = jnp.shape(state)[: jnp.ndim(state) - system.state_axes]
    if np.abs(np.asarray(state)).max(initial=0.0) > LIMITS.max_component:
        return
    for what, function in _rates_by_name(system):
        each = function
        for _ in batch:
            each = jax.vmap(each, (None, 0))
        rates = np.asarray(compiled_for_few_calls(each)(jnp.asarray(float(t)), jnp.asarray(state)))
        wrong = np.argwhere(~np.isfinite(rates.reshape(*batch, -1)).all(axis=-1))
        if len(wrong):
            which = f" in {len(wrong)} of {math.prod(batch)} copies, first {tuple(wrong[0].tolist())}" if batch else ""
            raise InvalidInput(
                f"{what} of {type(system).__name__} must be finite at the start{which}; got "
                f"{shown(rates[tuple(wrong[0])].tolist())} at {t:g} s. Start elsewhere, or write it so that it is "
                "finite there: no root or logarithm of what is negative, no division by zero."
            )


def _rates_by_name(system: AbstractSystem) -> Iterator[tuple[str, Any]]:
    """Yield functions of time and state that a motion takes its rates from, with what they are called."""
    if isinstance(system, AbstractLiePoissonSystem):
        yield "`velocity`, the gradient of the energy,", lambda t, state: system.velocity(system.parts(state).point)
    yield "`vector_field`", lambda t, state: rates_of_change(system, t, state)


def distances(system: AbstractSystem, t: Float64[Array, ""], state: Double[Array, "..."]) -> Float64[Array, "events"]:
    """Return the system's events at a state, positive until their zero.

    Raises:
        InvalidInput: for events that are not functions by name, or one that is not one real number.
    """
    events = system.events
    if not isinstance(events, Mapping) or not all(map(callable, events.values())):
        check.refuse(f"`events` of {type(system).__name__}", "functions of time and state by name, {name: function}",
                     events)
    return jnp.stack([one_number(f"the event {shown(name)}", event(t, state)) for name, event in events.items()])


def one_number(what: str, value: Any) -> Float64[Array, ""]:
    """Return the value, at a time and a state, of a function whose zeros are sought.

    Args:
        what: subject of the message.
        value: as the user's function gives it.

    Raises:
        InvalidInput: for what is not one real number, as comparisons are none.
    """
    rule = f"{what} must be one real number at a time and a state, whose zeros are sought; got"
    try:
        number = jnp.asarray(value)
    except (TypeError, ValueError):
        raise InvalidInput(f"{rule} {shown(value)}. Write it with jax.numpy.") from None
    if number.shape != ():
        raise InvalidInput(f"{rule} shape {number.shape}. Choose one component, as state[0], or put them together.")
    constant = isinstance(value, int) and not isinstance(value, bool)
    if not constant and not jnp.issubdtype(number.dtype, jnp.floating):
        raise InvalidInput(
            f"{rule} one of type {number.dtype}. Give what is compared instead, as state[0] - 0.5 for state[0] > 0.5; "
            "of complex numbers the real or the imaginary part."
        )
    return number.astype(float)


def refuse_other_objects(system: Any) -> None:
    """Refuse a `system` that is none.

    Raises:
        InvalidInput: naming what it is.
    """
    if not isinstance(system, AbstractSystem):
        raise InvalidInput(f"`system` must be one of polhode.systems, or your own; got {type(system).__name__}.")
