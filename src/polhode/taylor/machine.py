"""From a system to the programs that its motion needs: rates of change, what is watched, and what is conserved."""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import lru_cache
from typing import Any, NamedTuple

import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np

from polhode.arrays import in_jax_numpy
from polhode.systems.base import AbstractLiePoissonSystem, AbstractSystem, Event
from polhode.systems.forms import distances, rates_of_change
from polhode.taylor.expressions import Expression, Tape, Untraceable, gradient
from polhode.taylor.program import Program, program_of
from polhode.taylor.tracing import evaluated, size_of, traced, uses_first, written
from polhode.types import Array, Double, Float64

MOST_GRADIENTS = 600  # numbers in the gradients of what is conserved, from which projecting costs more than it gives
SAME_JUMP = 1e-12  # of a time: a jump that is named, and found again by trying times
INSTANTS = 1024  # at which branches on the time must come to the same
Span = tuple[float, float] | None


class Form(NamedTuple):
    """How a state lies in the real numbers of a kernel.

    Attributes:
        shape: of one state.
        is_complex: whether its parts are real and imaginary ones by turns.
    """

    shape: tuple[int, ...]
    is_complex: bool

    @property
    def size(self) -> int:
        """How many real numbers there are."""
        return math.prod(self.shape) * (2 if self.is_complex else 1)

    def flat(self, states: Array) -> Float64[Array, "*batch n"]:
        """Return states (…, *shape) as real numbers (…, n)."""
        states = np.ascontiguousarray(states, complex if self.is_complex else float)
        leading = states.shape[: states.ndim - len(self.shape)]
        return states.reshape(*leading, -1).view(float)

    def back(self, numbers: Float64[Array, "*batch n"]) -> Double[Array, "..."]:
        """Return states of their own shape."""
        numbers = np.ascontiguousarray(numbers[..., : self.size])
        if self.is_complex:
            numbers = numbers.view(complex)
        return numbers.reshape(*numbers.shape[:-1], *self.shape)

    def state(self, numbers: Any) -> Any:
        """Return one state within a function that is traced."""
        if self.is_complex:
            pairs = jnp.reshape(numbers, (-1, 2))
            numbers = jax.lax.complex(pairs[:, 0], pairs[:, 1])
        return jnp.reshape(numbers, self.shape)

    def numbers(self, state: Any) -> Any:
        """Return the real numbers of a state within a function that is traced."""
        flat = jnp.ravel(state)
        return jnp.ravel(jnp.stack([jnp.real(flat), jnp.imag(flat)], axis=-1)) if self.is_complex else flat


class Machine(NamedTuple):
    """What a kernel needs for a system between two of its jumps.

    Attributes:
        form: of a state.
        program: of rates of change of the state, of what balances receive, of the time; then of what is watched.
        integrals: of what is conserved, then of its gradients.
        names: of what is conserved.
        balances: names.
        events: names.
        clock: component that is the time, or −1.
    """

    form: Form
    program: Program
    integrals: Program
    names: tuple[str, ...]
    balances: tuple[str, ...]
    events: tuple[str, ...]
    clock: int


def machine_of(system: AbstractSystem, state: Array, between: Span, through: Event | None = None) -> Machine:
    """Return the programs of a system for states like one.

    Args:
        system: what moves.
        state: one, as ``check_state`` gives it.
        between: two times [s] between which no jump is named.
        through: a function of time and state that is watched too, after the events.

    Raises:
        Untraceable: if rates, balances or events are not made of operations that have a recurrence.
    """
    form = Form(np.shape(state), np.iscomplexobj(state))
    between = between if np.size(system.jumps) else None
    return _machine(*_hashable(system), form, between, through)


def operations_of(system: AbstractSystem, state: Double[Array, "..."]) -> int:
    """Return about how many operations a system's rates, balances and events take at a state."""
    form = Form(np.shape(state), np.iscomplexobj(state))
    return size_of(_written(*_hashable(system), form, None).closed.jaxpr)


class _Unhashable:
    """A system that cannot be hashed, which is traced each time."""

    def __init__(self, system: AbstractSystem) -> None:
        self.system = system


def _hashable(system: AbstractSystem) -> tuple[Any]:
    try:
        hash(system)
    except TypeError:
        return (_Unhashable(system),)
    return (system,)


class _Written(NamedTuple):
    """What a system's functions do to time and real numbers: rates, what balances receive, what is watched.

    Attributes:
        closed: of JAX.
        balances: names.
        timed: whether any of it uses the time.
    """

    closed: Any
    balances: tuple[str, ...]
    timed: bool


@lru_cache(maxsize=256)
def _written(given: AbstractSystem | _Unhashable, form: Form, through: Event | None) -> _Written:
    system = given.system if isinstance(given, _Unhashable) else given
    balances: list[str] = []

    def everything(t: Any, numbers: Any) -> Any:
        state = form.state(numbers)
        received = system.balances(t, state)
        balances[:] = received
        watched = list(distances(system, t, state)) if system.events else []
        watched += [] if through is None else [jnp.ravel(jnp.asarray(through(t, state), float))]
        rates = form.numbers(rates_of_change(system, t, state))
        return rates, *(jnp.ravel(balance.rate) for balance in received.values()), *watched

    with in_jax_numpy("systems"):
        closed = written(everything, (), (form.size,))
    return _Written(closed, tuple(balances), uses_first(closed))


@lru_cache(maxsize=256)
def _machine(given: AbstractSystem | _Unhashable, form: Form, between: Span, through: Event | None) -> Machine:
    system = given.system if isinstance(given, _Unhashable) else given
    closed, balances, timed = _written(given, form, through)
    size = form.size + len(balances) + timed
    inside = _instants(between)
    tape = Tape(size, size - 1 if timed else None, inside)
    known = tape.state()
    t = np.asarray(known[-1] if timed else 0.0, object if timed else float)
    state = np.empty(form.size, object)
    state[:] = known[: form.size]
    found = [np.ravel(x) for x in evaluated(closed, t, state)]
    rates = [tape_value(tape, x) for part in found[: 1 + len(balances)] for x in part]
    if timed:
        rates.append(tape.constant(1.0))
    watched = [tape_value(tape, x) for part in found[1 + len(balances) :] for x in part]
    names, integrals = _integrals(system, form)
    return Machine(form, program_of(tape, rates + watched), integrals, names, balances, tuple(system.events),
                   size - 1 if timed else -1)  # fmt: skip


def _instants(between: Span) -> Float64[np.ndarray, "instants"]:
    """Return times between two jumps; one alone where they are the same but for rounding."""
    if between is None:
        return np.zeros(0)
    low, high = between
    count = 1 if abs(high - low) <= SAME_JUMP * max(abs(low), abs(high)) else INSTANTS
    return np.linspace(low, high, count + 2)[1:-1]


def tape_value(tape: Tape, x: Any) -> Expression:
    """Return an element of an array as an expression."""
    return x if isinstance(x, Expression) else tape.constant(float(x))


def _integrals(system: AbstractSystem, form: Form) -> tuple[tuple[str, ...], Program]:
    """Return names and program of all conserved numbers of which gradients can be traced, one after the other."""
    names, outputs = [], []
    tape = Tape(form.size)
    state = np.empty(form.size, object)
    state[:] = tape.state()
    for name, found in _traced_if_possible(*_conserved(system, form), state).items():
        values = [tape_value(tape, x) for x in np.ravel(found)]
        outputs.extend((value, gradient(value)) for value in values)
        names.extend([name] * len(values))
    rows = [value for value, _ in outputs] + [x for _, slopes in outputs for x in slopes]
    return tuple(names), program_of(tape, rows)


def _traced_if_possible(
    names: list[str], function: Callable[[Any], dict[str, Any]], state: Array
) -> dict[str, Array]:
    """Return those named values of a function that can be traced; all at once takes the least time."""
    try:
        return dict(zip(names, traced(lambda x: _chosen(function(x), names), state), strict=True))
    except Untraceable:
        alone = [_traced_if_possible([name], function, state) for name in names] if len(names) > 1 else []
        return {name: value for found in alone for name, value in found.items()}


def _chosen(found: dict[str, Any], names: list[str]) -> list[Any]:
    return [found[name] for name in names]


def _conserved(system: AbstractSystem, form: Form) -> tuple[list[str], Callable[[Any], dict[str, Any]]]:
    """Return names of conserved numbers, and the function of a state's real numbers that gives them.

    Vectors are left out, unless they hold one number for each copy, and so is what would have too many gradients.
    """
    carries_attitude = isinstance(system, AbstractLiePoissonSystem) and _carries_attitude(system, form)

    def values(x: Any) -> dict[str, Any]:
        found = {name: jnp.real(value) for name, value in system.invariants(form.state(x)).items()}
        return found | ({"|q|²": jnp.sum(x[:4] ** 2)} if carries_attitude else {})

    quantities, names, count = system.quantities, [], 0
    for name, shape in jax.eval_shape(values, jnp.zeros(form.size)).items():
        fits = (count + shape.size) * form.size <= MOST_GRADIENTS
        if fits and (shape.ndim == 0 or (name in quantities and quantities[name].of_copies)):
            names.append(name)
            count += shape.size
    return names, values


def _carries_attitude(system: AbstractLiePoissonSystem, form: Form) -> bool:
    if form.is_complex or len(form.shape) != 1:
        return False
    return eqx.filter_eval_shape(system.parts, jax.ShapeDtypeStruct(form.shape, float)).attitude is not None
