"""Builds the programs that a system's motion needs: rates of change, watched functions, conserved quantities."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from functools import lru_cache
from itertools import chain
from typing import Any, NamedTuple

import jax
import jax.numpy as jnp
import numpy as np

from polhode._base.arrays import in_jax_numpy
from polhode._base.arrays.traced_checks import check_traced
from polhode._base.jaxprs import Listing, depends_on
from polhode._base.kept import kept_of_object
from polhode.systems._forms import distances, facts_of, rates_of_change
from polhode.systems.base import AbstractLiePoissonSystem, AbstractSystem, Event
from polhode.taylor.expressions import Expression, Tape, Untraceable, gradient
from polhode.taylor.jaxprs import numbers_in, operations_on, write_jaxpr
from polhode.taylor.operations import Operation
from polhode.taylor.program import Program, make_program
from polhode.taylor.sides import Branches, Sides, Signs
from polhode.taylor.structure import Structure, itself, take_structure
from polhode.taylor.tracing import evaluate, keep_numbers, list_operations
from polhode.types import Array, Double, Float64

TRACING = (jax.errors.ConcretizationTypeError, jax.errors.TracerArrayConversionError,
           jax.errors.TracerIntegerConversionError, jax.errors.TracerBoolConversionError)  # fmt: skip
Span = tuple[float, float] | None


class MachineLimits(NamedTuple):
    """Bounds of programs, and of the machines that are kept."""

    max_gradient_numbers: int = 600  # of the conserved quantities, from which projecting costs more than it gives
    time_rounding: float = 1e-12  # of a time: jumps that are nearer are one, named and detected again
    instants: int = 1024  # between two jumps, at which branches on the time must agree
    max_extended_power: int = 32  # with twice as many digits
    max_sides: int = 1000  # of a system, of which machines are kept


LIMITS = MachineLimits()


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

    def flat(self, states: Array) -> Float64[np.ndarray, "*batch n"]:
        """Return states (…, *shape) as real numbers (…, n)."""
        states = np.ascontiguousarray(states, complex if self.is_complex else float)
        leading = states.shape[: states.ndim - len(self.shape)]
        return states.reshape(*leading, -1).view(float)

    def back(self, numbers: Float64[Array, "*batch n"]) -> Double[np.ndarray, "..."]:
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
    """The programs of a system between two of its jumps.

    Attributes:
        form: of a state.
        program: of rates of change of the state, of integrals of balances, of the time; then of watched functions.
        integrals: of conserved quantities, then of their gradients.
        names: of conserved quantities.
        balances: names.
        events: names.
        clock: component that is the time, or −1.
        branches: on moving values, of which ``program`` has one side each, whose differences it gives last; or None.
        exact: program of rates whose first coefficients have twice as many digits: of the same state, then of
            ``numbers``, those of the system and of its formulas, so that what is computed of them, as one over a
            moment, has these digits too; or None.
    """

    form: Form
    program: Program
    integrals: Program
    names: tuple[str, ...]
    balances: tuple[str, ...]
    events: tuple[str, ...]
    clock: int
    branches: Branches | None
    exact: Program | None
    numbers: Float64[Array, "numbers"]


def build_machine(
    system: AbstractSystem, state: Array, between: Span, through: Event | None = None, extended: bool = False,
    signs: Signs | None = None,
) -> Machine:
    """Return the programs of a system for states like one.

    Args:
        state: one, as ``check_state`` gives it.
        between: two times [s] between which no jump is named.
        through: a function of time and state that is watched too, after the events.
        extended: whether first coefficients are to have twice as many digits.
        signs: the sides of branches on moving values, () to begin with those at the state; None if there may be none.

    Raises:
        Untraceable: if rates, balances or events are not made of operations that have a recurrence, or of those that
            have one with twice as many digits.
    """
    form = Form(np.shape(state), np.iscomplexobj(state))
    instants = between if len(facts_of(system).jumps) else None
    try:
        known = _machines_of(system, form, instants, through, extended)
    except TypeError:  # what cannot be hashed
        known = {}
    start = None
    if signs == ():
        assert between is not None
        start = *form.flat(np.asarray(state)).tolist(), float(between[0])
        signs = next((each for each, machine in known.items() if _serves(machine, start)), ())
    elif signs is None and () in known:  # the system has no branches
        signs = ()
    machine = known.get(signs)
    if machine is None:
        try:
            machine = _make_machine(system, form, instants, through, extended, signs, start)
        except Untraceable as error:
            if start is None:  # else it may have a machine from elsewhere
                known[signs] = str(error)
            raise
        if len(known) >= LIMITS.max_sides:
            known.clear()
        known[signs if machine.branches is None else machine.branches.signs] = machine
    elif isinstance(machine, str):  # a reason, which takes as long to determine as a machine takes
        raise Untraceable(machine)
    return machine


def _serves(machine: Machine | str, start: tuple[float, ...]) -> bool:
    """Whether a machine for any sides can be where a motion begins: at a border its own sides would tell the way."""
    if isinstance(machine, str) or machine.branches is None:
        return not isinstance(machine, str)
    y = np.zeros((1, machine.program.size))
    y[0, : machine.form.size] = start[:-1]
    if machine.clock >= 0:
        y[0, machine.clock] = start[-1]
    with np.errstate(all="ignore"):  # rates that are no numbers are refused by the run
        return not machine.branches.touches_border(y)


@kept_of_object
def _machines_of(*arguments: Any) -> dict[Signs | None, Machine | str]:
    """Return what ``_machines`` does, without comparing systems by their contents."""
    return _machines(*arguments)


@lru_cache(maxsize=256)
def _machines(*arguments: Any) -> dict[Signs | None, Machine | str]:
    """Return the machines of a system by the sides that they are for, or why there are none; empty at first."""
    return {}


def count_operations(system: AbstractSystem, state: Double[Array, "..."]) -> int:
    """Return about how many operations a system's rates, balances and events take at a state."""
    return _count_operations(system, Form(np.shape(state), np.iscomplexobj(state)))


@kept_of_object
def _count_operations(system: AbstractSystem, form: Form) -> int:
    return _of_any_numbers(_write_programs, system, form, None)[0].operations


class _Written(NamedTuple):
    """A system's functions of time, real numbers of a state, and those of the system.

    Attributes:
        closed: of JAX: rates, those of balances, watched functions.
        listing: its operations.
        balances: names.
        timed: whether any of it uses the time.
        operations: about how many, on moving values.
    """

    closed: Any
    listing: Listing
    balances: tuple[str, ...]
    timed: bool
    operations: int


def _of_any_numbers(
    written_of: Callable[..., Any], system: AbstractSystem, *arguments: Any
) -> tuple[Any, Float64[Array, "numbers"]]:
    """Return the programs of a system's structure, and its numbers; of the system itself if it needs their values."""
    structure, numbers = take_structure(system)
    programs = _write_unless_traced(written_of, structure, *arguments)
    if programs is None:
        structure, numbers = itself(system)
        programs = _write_unless_traced(written_of, structure, *arguments)
    return programs, numbers


@lru_cache(maxsize=512)
def _write_unless_traced(written_of: Callable[..., Any], structure: Structure, *arguments: Any) -> Any:
    """Return the programs, or None where tracing needs the values of the numbers."""
    if not structure.size:
        with in_jax_numpy("systems"):
            return written_of(structure, *arguments)
    try:
        return written_of(structure, *arguments)
    except TRACING:
        return None


def _write_programs(structure: Structure, form: Form, through: Event | None) -> _Written:
    balances: list[str] = []

    def everything(t: Any, moving: Any, numbers: Any) -> Any:
        system, state = structure.with_numbers(numbers), form.state(moving)
        received = system.balances(t, state)
        balances[:] = received
        watched = list(distances(system, t, state)) if system.events else []
        watched += [] if through is None else [jnp.ravel(jnp.asarray(through(t, state), float))]
        rates = form.numbers(rates_of_change(system, t, state))
        return rates, *(jnp.ravel(balance.rate) for balance in received.values()), *watched

    closed = write_jaxpr(everything, (), (form.size,), (structure.size,))
    check_traced("a function of the system, or what is looked for along its motion,", closed)
    uses_time, count = depends_on(closed, 0), operations_on(closed, (0, 1))
    return _Written(closed, list_operations(closed), tuple(balances), uses_time, count)


def _make_machine(
    system: AbstractSystem, form: Form, between: Span, through: Event | None, extended: bool,
    signs: Signs | None = None, start: tuple[float, ...] | None = None,
) -> Machine:
    written, numbers = _of_any_numbers(_write_programs, system, form, through)
    inside = _instants(between)
    size = form.size + len(written.balances) + written.timed
    sides = None if signs is None else Sides(signs, _components(size, form, written, start))
    try:
        tape, rates, watched = _make_tape(written, form, numbers, inside, sides=sides)
    except (ArithmeticError, ValueError) as error:  # of the side of a branch that is not taken
        if sides is None:
            raise
        raise Untraceable(f"a branch on something that moves, of which one side has no value ({error})") from None
    branches = None if sides is None or not sides.list_moving() else Branches(tape, rates, sides)
    watched += [] if branches is None else branches.watched
    exact = None
    if extended:
        kept = numbers_in(written.closed)
        exact = _exact_program(*_make_tape(written, form, numbers, inside, kept=kept)[:2])
        numbers = np.append(numbers, kept)
    names, integrals = _integrals(system, form)
    return Machine(form, make_program(tape, rates + watched), integrals, names, written.balances, tuple(system.events),
                   size - 1 if written.timed else -1, branches, exact, numbers)


def _components(size: int, form: Form, written: _Written, start: tuple[float, ...] | None) -> Float64[np.ndarray, "n"]:
    """Return the components at a start: the state, nothing received, and the time."""
    y = np.zeros(size)
    if start is not None:
        y[: form.size] = start[:-1]
        y[-1] = start[-1] if written.timed else y[-1]
    return y


@np.errstate(all="ignore")  # the motion's own checks report values that are not finite
def _make_tape(
    written: _Written, form: Form, numbers: Array, inside: Array, sides: Sides | None = None,
    kept: list[float] | None = None,
) -> tuple[Tape, list[Expression], list[Expression]]:
    """Return a tape with rates and watched functions.

    With a list of numbers in formulas, those of the system and they are components that follow the state.
    """
    size = form.size + len(written.balances) + written.timed
    beside = [] if kept is None else [*numbers.tolist(), *kept]
    tape = Tape(size + len(beside), size - 1 if written.timed else None, inside)
    tape.sides, tape.values = sides, dict(enumerate(beside, size))
    first = size + len(numbers)
    tape.kept = None if kept is None else {x: first + k for k, x in enumerate(kept)}
    known = np.empty(tape.size, object)
    known[:] = tape.state()
    t = np.asarray(known[size - 1] if written.timed else 0.0, object if written.timed else float)
    with keep_numbers(tape):
        outputs = evaluate(written.listing, t, known[: form.size], numbers if kept is None else known[size:first])
    parts = [[tape_value(tape, x) for x in np.ravel(part)] for part in outputs]
    rates, watched = parts[: 1 + len(written.balances)], parts[1 + len(written.balances) :]
    return tape, [*chain(*rates), *([tape.constant(1.0)] if written.timed else [])], [*chain(*watched)]


def _exact_program(tape: Tape, rates: list[Expression]) -> Program:
    wrong = {node.operation for node in tape.nodes} - {Operation.AFFINE, Operation.PRODUCT, Operation.POWER}
    if wrong:
        name = "Kepler's equation" if Operation.ECCENTRIC in wrong else f"the operation '{min(wrong).name.lower()}'"
        raise Untraceable(f"{name}, which has no recurrence with twice as many digits")
    powers = [node.number for node in tape.nodes if node.operation is Operation.POWER]
    if other := [x for x in powers if not ((2.0 * x).is_integer() and abs(x) <= LIMITS.max_extended_power)]:
        raise Untraceable(
            f"the power {other[0]:g}, and with twice as many digits only halves of whole numbers up to "
            f"{LIMITS.max_extended_power} have a recurrence"
        )
    return make_program(tape, rates)


def _instants(between: Span) -> Float64[np.ndarray, "instants"]:
    """Return times between two jumps; a single one where the two are equal but for rounding."""
    if between is None:
        return np.zeros(0)
    low, high = between
    is_one = abs(high - low) <= LIMITS.time_rounding * max(abs(low), abs(high))
    count = 1 if is_one else LIMITS.instants
    return np.linspace(low, high, count + 2)[1:-1]


def tape_value(tape: Tape, x: Any) -> Expression:
    """Return an element of an array as an expression."""
    return x if isinstance(x, Expression) else tape.constant(float(x))


def _integrals(system: AbstractSystem, form: Form) -> tuple[tuple[str, ...], Program]:
    """Return names and program of all conserved numbers of which gradients can be traced, one after the other.

    Of those whose gradients do not fit on a tape together, these are the first that the system names.
    """
    of_copies = frozenset(name for name, quantity in system.quantities.items() if quantity.of_copies)
    carries_attitude = isinstance(system, AbstractLiePoissonSystem) and _carries_attitude(system, form)
    (listing, places), numbers = _of_any_numbers(_write_conserved, system, form, of_copies, carries_attitude)
    try:
        names, tape, rows = _gradients(form, listing, [dict(sorted(places.items()))], numbers)
    except _Full:
        names, tape, rows = _gradients(form, listing, [{name: place} for name, place in places.items()], numbers)
    outputs = [value for value, _ in rows] + [x for _, slopes in rows for x in slopes]
    return tuple(names), make_program(tape, outputs)


class _Full(Exception):
    """A tape on which gradients do not fit together."""


def _gradients(
    form: Form, listing: Listing, groups: Sequence[dict[str, int]], numbers: Array
) -> tuple[list[str], Tape, list[tuple[Expression, list[Expression]]]]:
    """Return names, the tape, and values with their gradients on it: of one group after the other until it is full.

    Raises:
        _Full: if a single group does not fit.
    """
    names, rows = [], []
    tape = Tape(form.size)
    state = np.empty(form.size, object)
    state[:] = tape.state()
    for places in groups:
        evaluated = _evaluate_if_possible(listing, places, state, numbers)
        values = [(name, tape_value(tape, x)) for name, array in evaluated.items() for x in np.ravel(array)]
        try:
            rows.extend([(value, gradient(value)) for _, value in values])
        except Untraceable:
            if len(groups) == 1:
                raise _Full from None
            break
        names.extend(name for name, _ in values)
    return names, tape, rows


def _evaluate_if_possible(listing: Listing, places: dict[str, int], state: Array, numbers: Array) -> dict[str, Array]:
    """Return those named values of a jaxpr that have recurrences; all at once takes the least time."""
    try:
        return dict(zip(places, evaluate(listing, state, numbers, places=list(places.values())), strict=True))
    except Untraceable:
        each = places.items() if len(places) > 1 else ()
        alone = [_evaluate_if_possible(listing, {name: place}, state, numbers) for name, place in each]
        return {name: value for values in alone for name, value in values.items()}


def _write_conserved(
    structure: Structure, form: Form, of_copies: frozenset[str], carries_attitude: bool
) -> tuple[Listing, dict[str, int]]:
    """Return a listing of functions of state and system, and the places of conserved quantities in it.

    Vectors are left out, unless they hold one number for each copy (``of_copies``), and so are quantities with too many
    gradients, the last that the system names first.
    """
    order: list[str] = []

    def values(x: Any, numbers: Any) -> dict[str, Any]:
        invariants = structure.with_numbers(numbers).invariants(form.state(x))
        conserved = {name: jnp.real(value) for name, value in invariants.items()}
        conserved |= {"|q|²": jnp.sum(x[:4] ** 2)} if carries_attitude else {}
        order[:] = conserved
        return conserved

    sizes = form.size, structure.size
    arguments = [jax.ShapeDtypeStruct((size,), float) for size in sizes]
    closed, shapes = jax.make_jaxpr(values, return_shape=True)(*arguments)
    check_traced("an invariant of the system", closed)
    places, count = {}, 0
    at = {name: place for place, name in enumerate(sorted(shapes))}  # as JAX has the keys of a dictionary
    for name in order:
        size, is_number = math.prod(shapes[name].shape), shapes[name].ndim == 0
        fits = (count + size) * form.size <= LIMITS.max_gradient_numbers
        if fits and (is_number or name in of_copies):
            places[name] = at[name]
            count += size
    return list_operations(closed), places


def _carries_attitude(system: AbstractLiePoissonSystem, form: Form) -> bool:
    if form.is_complex or len(form.shape) != 1:
        return False
    return system.parts(np.zeros(form.shape)).attitude is not None
