"""Motions by Taylor series, segment by segment between jumps."""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Sequence
from functools import partial
from typing import NamedTuple

import jax
import numpy as np

from polhode._base.arrays import arrays_for_few_calls
from polhode.systems._component_sizes import component_sizes
from polhode.systems._forms import FURTHER
from polhode.systems.base import AbstractSystem, Event
from polhode.taylor import kernel
from polhode.taylor.advancing import advance_copies, begin_copies, outcome
from polhode.taylor.kernel_space import HITS, MANY_KICKS, STEPS, Copies, Course, series_for
from polhode.taylor.kernels import python_kernel
from polhode.taylor.machine import Machine, build_machine
from polhode.taylor.program import Program
from polhode.taylor.sides import Signs
from polhode.taylor.switching import Watched, advance_past_branches, time_of_roundings
from polhode.types import Array, Double, Float64, Integer


class RunLimits(NamedTuple):
    """Bounds of runs that go back, and of the room that a search begins with."""

    max_growth: float = 1e3  # of a motion that goes back, over its size: one that reaches it does not return
    first_crossings: int = 256  # that there is room for at first


LIMITS = RunLimits()
NO_ORDERS = np.zeros(0, np.int64)  # of companions
KICKS = float(np.finfo(float).eps) * np.random.default_rng(2).choice([-1.0, 1.0], MANY_KICKS)


class Precision(NamedTuple):
    """How far a step reaches.

    Attributes:
        order: of the series.
        reach: of a step, in radii of convergence.
        extended: whether the state has twice as many digits.
    """

    order: int
    reach: float
    extended: bool = False


def choose_precision(tolerance: float | None, order: int | None = None, extended: bool = False) -> Precision:
    """Return order and reach of steps whose error is a tolerance times the state's size; rounding if it is None.

    Source: Jorba & Zou, Exp. Math. 14 (2005) 99, §3.1 for the order, §3.2 for the reach.
    """
    local = finest_tolerance(extended) if tolerance is None else tolerance
    if order is None:
        # without a tolerance, orders at which errors of single steps do not add up with one sign
        to_rounding = 28 if extended else 24
        order = to_rounding if tolerance is None else max(8, math.ceil(1.0 - 0.5 * math.log(local)))
    # Jorba & Zou 2005: the order 1 − ½ ln ε costs least, and a step of e⁻² radii makes its last term ε; the factor
    # e^(−0.7/(p−1)) is for safety (§3.2)
    return Precision(order, local ** (1.0 / order) * math.exp(-0.7 / (order - 1)), extended)


def finest_tolerance(extended: bool) -> float:
    """Return the tolerance of a step whose error is rounding, of states in double or in extended precision."""
    return 1e-22 if extended else 1e-19


class Runs(NamedTuple):
    """The result for each of C copies.

    Attributes:
        states: (C, T, *shape) samples; infinite after the end.
        received: (C, T, B) integrals of balances.
        status: (C,) numbers of ``Status``.
        event: (C,) which event ended it, −1 where none did.
        end: (C,) [s] the event's own time, or the last; NaN where steps shrank to nothing.
        end_state: (C, *shape) the state then.
        end_received: (C, B) integrals of balances until then.
        steps: (C,) how many were taken.
        gaps: (C, J, *shape) how far each number of companions was off, at most, where steps ended; infinite or NaN of
            those that left the numbers.
        sizes: (C, *shape) of each number itself, likewise; zero without companions.
        balances: their names.
    """

    states: Double[Array, "..."]
    received: Float64[Array, "copies time balances"]
    status: Integer[Array, "copies"]
    event: Integer[Array, "copies"]
    end: Float64[Array, "copies"]
    end_state: Double[Array, "..."]
    end_received: Float64[Array, "copies balances"]
    steps: Integer[Array, "copies"]
    gaps: Float64[Array, "..."]
    sizes: Float64[Array, "..."]
    balances: tuple[str, ...]

    def part(self, some: Integer[np.ndarray, "some"]) -> Runs:
        """Return those of some copies."""
        return Runs(*(x[some] for x in self[:-1]), balances=self.balances)  # type: ignore[misc]


def join_runs(parts: Sequence[Runs]) -> Runs:
    """Return runs of parts of a batch as those of the batch."""
    columns = zip(*(part[:-1] for part in parts), strict=True)
    return Runs(*(np.concatenate(each) for each in columns), balances=parts[0].balances)  # type: ignore[misc]


class Companions(NamedTuple):
    """Runs that take the steps of copies, and show how far these are from the motion.

    Attributes:
        starts: (J, C, *shape).
        orders: of their series.
    """

    starts: Double[Array, "..."]
    orders: tuple[int, ...]


class Plan(NamedTuple):
    """The plan shared by all copies: where steps must end, the machine up to there, and the reach of steps.

    ``build`` gives the machine between two borders for other sides of branches; ``late`` and ``changes`` are as in
    ``switching.Watched``, and the ``detected`` jumps are those whose times bisection gave, to a rounding.
    """

    borders: list[float]
    machines: list[Machine]
    times: Float64[np.ndarray, "time"]
    precision: Precision
    longest: float
    forth: float
    build: Callable[..., Machine]
    late: Float64[np.ndarray, "copies"] | None = None
    changes: int = 0
    detected: frozenset[float] = frozenset()
    orders: tuple[int, ...] = ()

    @property
    def takes_companions(self) -> bool:
        """Whether companions can take the steps: past a border or a detected jump they go at times of their own."""
        branching = any(machine.branches is not None for machine in self.machines)
        return not (self.precision.extended or self.detected or branching)


def _plan(
    system: AbstractSystem, state: Array, times: np.ndarray, precision: Precision, longest: float,
    through: Event | None = None, branching: bool = False,
) -> Plan:
    times = np.ascontiguousarray(times, float)  # as compiled kernels read them one beside the other in memory
    forth = 1.0 if times[-1] > times[0] else -1.0
    borders = _borders(system, times, forth)
    build = partial(build_machine, system, state, through=through, extended=precision.extended)
    if branching and not precision.extended:
        machines = [build((borders[0], borders[1]), signs=())]
        if machines[0].branches is None:
            machines += [build(between, signs=()) for between in itertools.pairwise(borders[1:])]
        # else the others by the sides where the motion comes to them
    else:
        machines = [build(between) for between in itertools.pairwise(borders)]
    return Plan(borders, machines, times, precision, longest, forth, build, changes=system.count_of_changes,
                detected=frozenset(np.ravel(getattr(system, FURTHER, ())).tolist()))


def takes_companions(
    system: AbstractSystem, states: Double[Array, "..."], times: Float64[np.ndarray, "time"], precision: Precision
) -> bool:
    """Return whether motions of states (C, *shape) can have companions.

    Raises:
        Untraceable: as ``run_copies`` does.
    """
    return _plan(system, states[0], times, precision, math.inf, branching=True).takes_companions


def run_copies(
    system: AbstractSystem,
    states: Double[Array, "..."],
    times: Float64[np.ndarray, "time"],
    precision: Precision,
    longest: float = math.inf,
    check: Callable[[float], None] = lambda share: None,
    scales: Float64[Array, "copies n"] | None = None,
    late: Float64[np.ndarray, "copies"] | None = None,
    companions: Companions | None = None,
) -> Runs:
    """Return the motions of states at times, which need not be ends of steps.

    Args:
        system: whose motion it is.
        states: (C, *shape).
        times: (T,) [s], in one direction.
        precision: of the steps.
        longest: step [s].
        check: called with the completed share, between parts of a long run.
        scales: sizes of the components, infinite of those that have none of their own; by default the system's.
        late: (C,) roundings of the time by which each copy passes borders of branches too late, to show their effect.
        companions: of motions that can have them.

    Raises:
        Untraceable: if the system's rates are not made of operations that have a recurrence.
    """
    orders = () if companions is None else companions.orders
    plan = _plan(system, states[0], times, precision, longest, branching=True)._replace(late=late, orders=orders)
    form, program = plan.machines[0].form, plan.machines[0].program
    y = np.zeros((len(states), program.size))
    y[:, : form.size] = form.flat(states)
    if scales is None:
        scale = _scales(system, states, times[0], plan.machines[0], program.size)
    else:
        scale = np.full((len(states), program.size), np.inf)
        scale[:, : form.size] = scales
    samples = np.full((len(states), len(times), program.size), np.inf)
    samples[:, 0] = y  # without the time, which no state has
    others = np.zeros((len(states), len(orders), program.size))
    if companions is not None:
        others[:, :, : form.size] = np.moveaxis(form.flat(companions.starts), 0, 1)
    copies = begin_copies(plan.machines[0], y, scale, samples, times[0], 1, others)
    _advance_through(plan, copies, check)
    balances = plan.machines[0].balances
    extra = slice(form.size, form.size + len(balances))
    ended = outcome(copies)
    return Runs(form.back(samples), samples[..., extra], *ended, form.back(y), y[:, extra].copy(),
                copies.counts[:, STEPS], np.abs(form.back(copies.gaps)), np.abs(form.back(copies.sizes)), balances)


def runs_back(
    system: AbstractSystem, known: Float64[Array, "copies time some"], kicks: Float64[Array, "copies time n"],
    times: Float64[np.ndarray, "time"], precision: Precision, longest: float, scales: Float64[Array, "copies n"],
) -> tuple[Float64[Array, "copies n"], Float64[Array, "copies"]]:
    """Return the ends of motions that go back through times at which their first components are given.

    At each of the times these are set to the given values, and the kicks are added to all.

    Args:
        system: with one axis of real numbers.
        known: the first components, in the order of the times.
        kicks: zero for these.
        times: (T,) [s], of the motion ahead.
        precision: of the steps.
        longest: step [s].
        scales: sizes of the components, as of ``run_copies``.

    Returns:
        The states at the first time, with its kicks, and the largest distance of the way back from the given
        components, in their sizes; infinite where steps shrank to nothing.
    """
    size, some = kicks.shape[2], known.shape[2]
    plan = _plan(system, kicks[0, -1], times[::-1], precision, longest)
    machine = plan.machines[0]
    y, scale = np.zeros((len(known), machine.program.size)), np.full((len(known), machine.program.size), np.inf)
    scale[:, :size] = scales
    y[:, :some], y[:, some:size] = known[:, -1], kicks[:, -1, some:]
    copies = begin_copies(machine, y, scale, np.zeros((len(known), 0, machine.program.size)), times[-1], hits=1)
    follows, nothing, missed = _followers(machine.program, scale), np.zeros(0, bool), np.zeros(len(known))

    def give_up(share: float) -> None:
        """End copies that have diverged, as damped motions do backward in time, in ever shorter steps."""
        with np.errstate(invalid="ignore"):
            fine = (np.abs(y[:, :some]) < LIMITS.max_growth * scales[:, :some]).all(axis=1)
        copies.status[~fine] = kernel.FAILED

    for k in range(len(times) - 2, -1, -1):
        end = float(times[k])
        course = Course(times[:0], 0, precision.order, precision.reach, longest, plan.forth, nothing, nothing, end,
                        machine.clock, follows, len(follows), NO_ORDERS, 0, KICKS)
        advance_copies(copies, machine, course, give_up, lambda t: 0.0)
        off = np.abs(y[:, :some] - known[:, k]) / scales[:, :some]
        missed = np.maximum(missed, np.where(copies.status == kernel.DONE, off.max(axis=1, initial=0.0), np.inf))
        y[:, :some] = known[:, k]
        y[:, some:size] += kicks[:, k, some:]
    return y[:, :size], missed


class Crossings(NamedTuple):
    """Crossings of a motion with the zeros of a function.

    Attributes:
        times: (K,) [s].
        states: (K, *shape).
        status: one of ``Status``: of the run, which may have ended before all crossings.
        event: which of the system's events ended it, or −1.
        end: [s] up to when crossings were sought.
    """

    times: Float64[Array, "crossings"]
    states: Double[Array, "..."]
    status: int
    event: int
    end: float


def find_crossings(
    system: AbstractSystem,
    state: Double[Array, "..."],
    through: Event,
    times: Float64[np.ndarray, "2"],
    precision: Precision,
    most: int,
    falling: bool,
    check: Callable[[float], None] = lambda share: None,
) -> Crossings:
    """Return where the motion of one state goes through the zeros of a function of time and state.

    Args:
        system: whose motion it is.
        state: one.
        through: the function, written with JAX.
        times: first and last [s].
        precision: of the steps.
        most: how many crossings end the search.
        falling: whether only those from positive to negative count, in the direction of the motion.
        check: called between parts of a long run.

    Raises:
        Untraceable: if rates, events or the function are not made of operations that have a recurrence.
    """
    plan = _plan(system, state, times, precision, math.inf, through, branching=True)
    form, size = plan.machines[0].form, plan.machines[0].program.size
    y = np.zeros((1, size))
    y[0, : form.size] = form.flat(state)
    scale = _scales(system, np.asarray(state)[None], times[0], plan.machines[0], size)
    samples, room = np.full((1, 2, size), np.inf), min(most, LIMITS.first_crossings)
    copies = begin_copies(plan.machines[0], y, scale, samples, times[0], room)
    copies = _advance_through(plan, copies, check, Watch(falling, most))
    status, event, end = outcome(copies)
    hits = copies.hits[0, : copies.counts[0, HITS]]
    crossings = hits[hits[:, 1] == len(system.events)][:most]
    return Crossings(crossings[:, 0], form.back(crossings[:, 2:]), int(status[0]), int(event[0]), float(end[0]))


class Watch(NamedTuple):
    """The function watched besides the system's events."""

    falling: bool
    most: int


def _advance_through(plan: Plan, copies: Copies, check: Callable[[float], None], watch: Watch | None = None) -> Copies:
    """Move copies to the last time, or as far as they come, and return them, with more room for crossings."""
    # the system's events fall from positive to zero, and end the motion
    falling = np.ones(len(plan.machines[0].events) + (watch is not None), bool)
    stops = falling.copy()
    if watch is not None:
        falling[-1], stops[-1] = watch.falling, False
    first, last = plan.borders[0], plan.borders[-1]
    share = lambda t: (t - first) / (last - first)  # noqa: E731
    watched = Watched(falling, stops, 1 if watch is None else watch.most, _enlarge, plan.late, plan.changes,
                      plan.machines[0].form.size)
    signs: Signs = ()
    for k, between in enumerate(itertools.pairwise(plan.borders)):
        machine = plan.machines[k] if k < len(plan.machines) else plan.build(between, signs=signs)
        if plan.late is not None and between[0] in plan.detected:
            before = plan.machines[k - 1] if k <= len(plan.machines) else machine
            jump = np.subtract(*(_rates(one, np.asarray(copies.y)) for one in (machine, before)))
            copies.y[:] -= time_of_roundings(k, between[0], plan.late)[:, None] * jump
        course_of = partial(_course, plan, between[1])
        if machine.branches is not None:
            build = partial(plan.build, between)
            copies, signs = advance_past_branches(copies, machine, build, course_of, check, share, watched)
            continue
        course = course_of(copies, machine, falling, stops)
        advance_copies(copies, machine, course, check, share)
        while watch is not None and copies.status[0] == kernel.FULL and copies.counts[0, HITS] < watch.most:
            copies = _enlarge(copies)
            copies.status[0] = kernel.RUNNING
            advance_copies(copies, machine, course, check, share)
    return copies


def _rates(machine: Machine, y: Float64[np.ndarray, "copies n"]) -> Float64[np.ndarray, "copies n"]:
    """Return the rates of copies by a machine for any sides."""
    rates, series = np.zeros_like(y), series_for(machine.program, 1, 1)
    python_kernel(1).conserved_values(series, y, np.zeros(len(y[0]) + 1), rates)
    return rates


def _enlarge(copies: Copies) -> Copies:
    return copies._replace(hits=np.concatenate([copies.hits, np.zeros_like(copies.hits)], axis=1))


def _course(plan: Plan, end: float, copies: Copies, machine: Machine, falling: Array, stops: Array) -> Course:
    follows = _followers(machine.program, copies.scale)
    orders = np.array(plan.orders, np.int64) if plan.orders else NO_ORDERS
    return Course(plan.times, len(plan.times), plan.precision.order, plan.precision.reach, plan.longest,
                  plan.forth, falling, stops, end, machine.clock, follows, len(follows), orders, len(orders), KICKS)


def _followers(program: Program, scale: Float64[Array, "copies n"]) -> Integer[Array, "followers"]:
    """Return the components that have no size of their own and change, but not evenly as the time does."""
    return np.flatnonzero(np.isinf(scale).all(axis=0) & program.moving)


def _borders(system: AbstractSystem, times: np.ndarray, forth: float) -> list[float]:
    jumps = np.ravel(np.asarray(system.jumps, float))
    inside = jumps[(forth * jumps > forth * times[0]) & (forth * jumps < forth * times[-1])]
    return [float(times[0]), *sorted({float(t) for t in inside}, key=lambda t: forth * t), float(times[-1])]


def _scales(system: AbstractSystem, states: Array, t: float, machine: Machine, size: int) -> Float64[Array, "copies n"]:
    """Return the sizes by which components are compared; infinite of the time, which never limits a step."""
    form = machine.form
    own = component_sizes(system, states)
    scale = np.full((len(states), size), np.inf)
    own = own.reshape(len(states), -1)
    scale[:, : form.size] = np.repeat(own, 2, axis=1) if form.is_complex else own
    values = _balances_at(system, np.asarray(states), np.asarray(t)) if machine.balances else {}
    for k, name in enumerate(machine.balances):
        value = np.abs(np.asarray(values[name]))
        scale[:, form.size + k] = np.where(value > 0.0, value, 1.0)
    return scale


@arrays_for_few_calls
def _balances_at(system: AbstractSystem, states: Array, t: Array) -> dict[str, Array]:
    """Return values (C,) of balances at states (C, *shape)."""
    return jax.vmap(lambda state: system.balance_values(t, state))(states)
