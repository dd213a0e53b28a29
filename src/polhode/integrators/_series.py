"""``Taylor``: systems whose rates are products, powers and elementary functions, by Taylor series of the motion."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

import jax.numpy as jnp
import numpy as np

from polhode.errors import InvalidInput, NotConverged, shown
from polhode.integrators._adaptive import AdaptiveMotion, check_events
from polhode.integrators._difference import EPS, LARGE, difference, starts_a_rounding_away
from polhode.integrators._interrupts import keep_interrupts
from polhode.integrators.probing import jumps_between
from polhode.motion._outcome import Ends, Status
from polhode.systems.base import AbstractSystem
from polhode.taylor.advancing import LIMITS as ADVANCING
from polhode.taylor.array_series import Place, runs_of_arrays
from polhode.taylor.expressions import Untraceable
from polhode.taylor.machine import build_machine, count_operations
from polhode.taylor.runs import Precision, Runs, choose_precision, finest_tolerance, run_copies
from polhode.types import Array, Bool, Double, Float64

PRECISIONS = "double", "extended"


class SeriesLimits(NamedTuple):
    """Thresholds that refuse a series, choose its form, or bound its estimated error."""

    min_order: int = 4
    max_order: int = 60
    max_operations: int = 20_000  # of the rates of change; tracing more takes longer than what it may save
    min_size: float = 1e-150  # of a state, and one over it the largest: else products of its numbers vanish or overflow
    max_numbers_together: int = 1 << 22  # of samples, up to which runs for comparison are made side by side
    min_compared_times: int = 64  # as two runs may meet by chance at a few samples
    max_rounds: int = 6  # of shorter steps, until a tolerance is met
    extra_orders: int = 4  # of the run that shows the truncation error
    reach_share: float = 0.8  # of that run
    error_factor: float = 4.0  # as a few other runs show most of what roundings grow to, not all
    min_error_roundings: float = 4.0  # of the last step and of the sample itself


LIMITS = SeriesLimits()


class NoSeries(InvalidInput):
    """A motion that no series can follow, of whatever order.

    Attributes:
        why: a clause that ends "no series, as …".
        copies: (C,) which copies of a batch they cannot follow; None where it is all of them.
        part: of the rates of change, that has no series or leads to where none is; "" for other reasons.
        singular: when the motion comes to a singularity, in words; "" where it does not.
    """

    def __init__(
        self, message: str, why: str, copies: Bool[Array, "copies"] | None = None, part: str = "", singular: str = ""
    ) -> None:
        super().__init__(message)
        self.why, self.copies, self.part, self.singular = why, copies, part, singular


@dataclass(frozen=True)
class Taylor:
    """Taylor series of the motion, by steps that reach as far as the series converges fast.

    Coefficients follow from recurrences in the operations of which the rates of change consist: sums, products, powers,
    exponentials, logarithms, circular and hyperbolic functions. Rates with other functions are refused. A branch, as in
    an absolute value or a limit, is followed on the side where the state is, and a step ends where it comes to the
    other side; motions that go along such a border, or only touch it, are refused.
    Samples lie on the series, so that they cost and change no steps. After each step the state is put back onto
    energy, Casimirs and the system's other conserved quantities, where rounding has moved it away.

    With extended precision a state has twice as many digits, and so have the first coefficients of its series, with all
    numbers that are computed from the system's own, such as one over a moment. Roundings do not add up then: a heavy
    top is exact to 1e-15 after 1e5 seconds, and off by 1e-11 without it. A step takes some seven times as long, and
    rates must be made of sums, products, and powers that are halves of whole numbers.

    Args:
        order: of the series; by default 24, 28 with extended precision, and lower where a tolerance is given.
        precision: "double" or "extended".

    Raises:
        InvalidInput: for an order that is not between 4 and 60, or another precision.

    Source: Jorba & Zou, Exp. Math. 14 (2005) 99.
    """

    order: int | None = None
    precision: str = "double"

    def __post_init__(self) -> None:
        lowest, highest, order = LIMITS.min_order, LIMITS.max_order, self.order
        if order is not None and not (isinstance(order, int | np.integer) and lowest <= order <= highest):
            raise InvalidInput(f"`order` of Taylor must be from {lowest} to {highest}; got {shown(self.order)}.")
        if self.precision not in PRECISIONS:
            raise InvalidInput(
                f"`precision` of Taylor must be one of {', '.join(PRECISIONS)}; got {shown(self.precision)}."
            )

    @property
    def is_extended(self) -> bool:
        """Whether states have twice as many digits."""
        return self.precision == "extended"


def is_series(method: Any) -> bool:
    """Return whether a method is ``Taylor``, the class or an instance."""
    return method is Taylor or isinstance(method, Taylor)


def has_short_series(system: AbstractSystem, state: Double[Array, "..."]) -> bool:
    """Return whether the rates of change at states (batch…, …) are of so few operations that series pay off."""
    return system.series_of_arrays or count_operations(system, _one(system, state)) <= LIMITS.max_operations


def goes_by_arrays(system: AbstractSystem, state: Double[Array, "..."]) -> bool:
    """Return whether the system's series are of whole arrays; such a motion can be resumed bit for bit."""
    return system.series_of_arrays or count_operations(system, _one(system, state)) > LIMITS.max_operations


def _one(system: AbstractSystem, state: Double[Array, "..."]) -> Array:
    return np.reshape(np.asarray(state), (-1, *np.shape(state)[np.ndim(state) - system.state_axes :]))[0]


def find_obstacle(
    system: AbstractSystem, state: Double[Array, "..."], times: tuple[float, float], extended: bool = False
) -> NoSeries | None:
    """Return why motions between two times have no series, as far as their starts show it."""
    one = _one(system, state)
    try:
        check_sizes(np.reshape(np.asarray(state), (-1, *one.shape)))
        if goes_by_arrays(system, state):
            return None
        build_machine(system, one, times, extended=extended, signs=None if extended else ())
    except NoSeries as error:
        return error
    except Untraceable as error:
        return _refuse(system, error, extended)
    return None


def has_series(system: AbstractSystem, state: Double[Array, "*shape"], times: tuple[float, float]) -> bool:
    """Return whether a motion of one state between two times has a series, and one that is short enough to pay."""
    return not goes_by_arrays(system, state) and find_obstacle(system, state, times) is None


def _refuse(system: AbstractSystem, error: Untraceable, extended: bool = False) -> NoSeries:
    instead = 'Give `precision` "double".' if extended else "Leave out `method`, or give a solver of diffrax."
    return NoSeries(
        f"{type(system).__name__} cannot be moved by Taylor series: its rates of change contain {error}. {instead}",
        f"its rates contain {error}", error.copies, str(error),
    )


def solve_by_series(
    system: AbstractSystem, method: Taylor, state: Double[Array, "..."], times: Float64[np.ndarray, "time"],
    meter: Any = None, step: float | None = None, tolerance: float | None = None, every: int = 1,
    memory: Sequence[Array] | None = None,
) -> AdaptiveMotion:
    """Return the motion at times, or up to the first of the system's events; see ``solve_adaptively``.

    Raises:
        InvalidInput: if the system's rates are not made of operations that have a recurrence, or if an event has
            already happened at the start.
        NotConverged: if it takes too many steps.
    """
    kept, longest = times[::every], math.inf if step is None else float(step)
    batch = np.shape(state)[: np.ndim(state) - system.state_axes]
    states = np.reshape(np.asarray(state), (-1, *np.shape(state)[len(batch) :]))
    check_events(system, times[0], state)
    check_sizes(states)
    jumps_between(times, system.jumps)  # refuses times that are not finite
    precision = choose_precision(tolerance, method.order, method.is_extended)
    place = None if memory is None else _find_place(memory, states, times[0])
    runs, place = _run_or_refuse(system, states, kept, times[-1], precision, longest, meter, place)
    shaped = lambda x: x.reshape((*batch, *x.shape[1:]))  # noqa: E731
    ends = Ends(shaped(runs.status), shaped(runs.event), shaped(runs.end), shaped(runs.end_state),
                tuple(system.events))
    fine = shaped(runs.status) != Status.NOT_CONVERGED
    received = {name: shaped(runs.received[..., k]) for k, name in enumerate(runs.balances)}
    steps = int(runs.steps.max())
    if batch or runs.status[0] != Status.EVENT:
        carried = None
        if place is not None and not batch:
            carried = tuple(map(np.asarray, (times[-1] - place.time, place.state, place.unit)))
        return AdaptiveMotion(kept, shaped(runs.states), received, None, fine, steps, ends, carried, shaped(runs.steps),
                              place is not None)
    before = np.abs(kept - times[0]) < abs(float(runs.end[0]) - times[0])
    # one row more, for the event itself
    received = {
        name: np.append(value[before], runs.end_received[0, k]) for k, (name, value) in enumerate(received.items())
    }
    rows = np.concatenate([runs.states[0][before], runs.end_state])
    event = tuple(system.events)[int(runs.event[0])]
    times = np.append(kept[before], runs.end[0])
    return AdaptiveMotion(times, rows, received, event, fine, steps, ends, steps_of_copies=shaped(runs.steps))


def solve_with_error(
    system: AbstractSystem, method: Taylor, state: Double[Array, "..."], times: Float64[np.ndarray, "time"],
    meter: Any = None, step: float | None = None, tolerance: float | None = None, every: int = 1,
    memory: Sequence[Array] | None = None,
) -> tuple[AdaptiveMotion, Float64[Array, "*batch"] | None]:
    """Return the motion, and its estimated error unless every copy failed.

    Raises:
        InvalidInput, NotConverged: as ``solve_by_series``.
    """
    # the times of comparison are samples of the motion already, unless an event adds a sample of its own
    samples, parts = (times, 1) if every > 1 or system.events else _refine(times)
    motion = solve_by_series(system, method, state, samples, meter, step, tolerance, every, memory)
    known = bool(np.any(motion.successful))
    error = series_error(system, method, state, samples, motion, step, tolerance) if known else None
    if parts == 1:
        return motion, error
    kept = (slice(None),) * np.ndim(motion.successful) + (slice(None, None, parts),)
    received = {name: np.array(value[kept]) for name, value in motion.received.items()}
    # copies, as a view would keep all samples in memory
    return motion._replace(times=np.array(times), states=np.array(motion.states[kept]), received=received), error


def _refine(times: Float64[np.ndarray, "time"]) -> tuple[Float64[np.ndarray, "more"], int]:
    """Return enough times for a comparison, and into how many parts each interval is divided."""
    parts = max(1, math.ceil(LIMITS.min_compared_times / (len(times) - 1)))
    return np.append(np.linspace(times[:-1], times[1:], parts, endpoint=False, axis=1), times[-1]), parts


def series_error(
    system: AbstractSystem, method: Taylor, state: Double[Array, "..."], times: Float64[np.ndarray, "time"],
    motion: AdaptiveMotion, step: float | None = None, tolerance: float | None = None,
) -> Float64[Array, "*batch"]:
    """Return the estimated error (batch…) of a motion, from further runs.

    A run of higher order, with shorter steps, shows the truncation error of the series. Two more runs, from starts a
    rounding away, have other roundings throughout, even where something else than the series limits the steps. The
    largest distance from the motion to any of the three is what roundings grow to, for instance beside a saddle. All
    three may come near the motion by chance: of 3,000 starts beside saddles one had an error of eight times the
    estimate. They are compared at many times, which cost next to nothing.
    """
    fine = _refine(times)[0]
    precision = choose_precision(tolerance, method.order, method.is_extended)
    order, reach = precision.order + LIMITS.extra_orders, LIMITS.reach_share * precision.reach
    better = precision._replace(order=order, reach=reach)
    batch = np.shape(state)[: np.ndim(state) - system.state_axes]
    longest = math.inf if step is None else float(step)

    def again(starts: Sequence[Array], by: Precision, late: Sequence[float] = (0.0,)) -> list[Runs]:
        states = np.concatenate([np.reshape(np.asarray(x), (-1, *np.shape(x)[len(batch) :])) for x in starts])
        if len(starts) > 1 and states.size * len(fine) > LIMITS.max_numbers_together:
            return [run for start, each in zip(starts, late, strict=True) for run in again([start], by, [each])]
        try:
            each = np.repeat(late, copies) if any(late) else None
            runs = _run_or_refuse(system, states, fine, fine[-1], by, longest, None, late=each)[0]
        except NoSeries as error:
            if error.copies is not None:
                error.copies = np.any(np.reshape(error.copies, (len(starts), copies)), axis=0)
            raise
        return [runs.part(k * copies, (k + 1) * copies) for k in range(len(starts))]

    # the bits of a run depend neither on its samples nor on other copies
    known, copies = np.array_equal(motion.times, fine), math.prod(batch)
    first = _as_copies(motion, batch) if known else again([state], precision)[0]
    # roundings are not those of doubles with extended precision
    kicked = [] if method.is_extended else starts_a_rounding_away(system, state)
    # runs from the other starts pass borders and jumps a rounding of the time too late and too early
    others = again([state, *kicked], better, [0.0, 1.0, -1.0][: 1 + len(kicked)])
    gaps, failed = zip(*(_apart(system, fine, first, other) for other in others), strict=True)
    off = np.max(gaps, axis=0)
    error = np.where(off > LARGE, off, np.maximum(LIMITS.error_factor * off, LIMITS.min_error_roundings * EPS))
    return np.where(np.any(failed, axis=0), np.inf, error).reshape(batch)


def series_to_tolerance(
    system: AbstractSystem, method: Taylor, state: Double[Array, "..."], times: Float64[np.ndarray, "time"],
    meter: Any, step: float | None, tolerance: float, every: int = 1,
) -> tuple[AdaptiveMotion, Float64[Array, "*batch"], float]:
    """Return a motion whose estimated error is within a tolerance, that error, and the tolerance of a step.

    Raises:
        NotConverged: if rounding alone makes more of it.
    """
    local, error, arguments = tolerance, np.inf, (system, method, state, times)
    least = finest_tolerance(method.is_extended)
    for k in range(LIMITS.max_rounds):
        motion, errors = solve_with_error(*arguments, meter, step, local, every)
        if errors is None:
            return motion, np.full(motion.successful.shape, np.inf), local
        error = float(np.max(np.where(motion.successful, errors, 0.0), initial=0.0))
        if error <= tolerance:
            return motion, errors, local
        if local == least or k == LIMITS.max_rounds - 1:
            break
        local = max(local * min(0.1 * tolerance / error, 0.1), least)
    raise NotConverged(
        f"`tolerance` {tolerance:g} could not be met: the estimated error is {error:.2g}, and shorter steps do not "
        "help, as it comes from rounding or chaos. Allow more, or shorten the time."
    )


class _Compared(NamedTuple):
    """The fields of ``Runs`` that are compared."""

    states: Array
    status: Array
    event: Array
    end: Array
    steps: Array


def _as_copies(motion: AdaptiveMotion, batch: tuple[int, ...]) -> _Compared:
    ends = motion.ends
    assert motion.steps_of_copies is not None
    copies = [np.reshape(x, (-1, *np.shape(x)[len(batch) :]))
              for x in (motion.states, ends.status, ends.event, ends.time, motion.steps_of_copies)]
    return _Compared(*copies)


def _apart(
    system: AbstractSystem, times: np.ndarray, one: Runs | _Compared, other: Runs
) -> tuple[Array, Array]:
    """Return how far runs are apart (C,) until either ends, and which of them failed."""
    distances, whole = np.zeros(len(one.states)), np.full(len(one.states), abs(times[-1] - times[0]))
    last = np.nanmin([np.abs(one.end - times[0]), np.abs(other.end - times[0]), whole], axis=0)
    counts = np.maximum(np.sum(np.abs(times - times[0]) <= last[:, None] * (1.0 - 1e-9), axis=1), 1)
    counts[(one.event == -1) & (other.event == -1)] = len(times)
    for count in np.unique(counts):
        some = counts == count
        with np.errstate(invalid="ignore"):
            distances[some] = difference(system, one.states[some, :count], other.states[some, :count])
    failed = (one.status == Status.NOT_CONVERGED) | (other.status == Status.NOT_CONVERGED)
    return np.nan_to_num(distances, nan=np.inf), failed


def _by_arrays_or_tape(
    system: AbstractSystem, states: Array, times: np.ndarray, precision: Precision, longest: float,
    check: Callable[[float], None], place: Place | None, late: Float64[np.ndarray, "copies"] | None,
) -> tuple[Runs, Place | None]:
    """Return runs by series of whole arrays where these pay and exist, otherwise by series of single numbers."""
    if goes_by_arrays(system, states):
        try:
            return runs_of_arrays(system, states, times, precision, longest, check, place)
        except Untraceable:
            if place is not None:
                raise
    return run_copies(system, states, times, precision, longest, check, late=late), None


def _find_place(memory: Sequence[Array], states: Double[Array, "copies ..."], first: float) -> Place:
    """Return where the last step of an earlier motion began; ``memory`` has the time from there to its end."""
    shapes = [np.shape(x) for x in memory]
    if shapes != [(), np.shape(states[0]), ()] or len(states) > 1:
        raise InvalidInput(
            f"`memory` must be that of an earlier run by Taylor from one state: a time, a state {np.shape(states[0])} "
            f"and a unit of time; got shapes {shapes}. Leave it out to begin afresh."
        )
    return Place(first - float(memory[0]), np.asarray(memory[1], states.dtype), float(memory[2]))


def _run_or_refuse(
    system: AbstractSystem, states: Array, times: np.ndarray, last: float, precision: Precision, longest: float,
    meter: Any, place: Place | None = None, late: Float64[np.ndarray, "copies"] | None = None,
) -> tuple[Runs, Place | None]:
    """Return runs up to a last time, which need not be a sample, and where to resume; or say why there are none."""
    with keep_interrupts() as check:
        shown_state = [None if meter is None else meter.init()]

        def report_progress(share: float) -> None:
            check()
            if meter is not None:
                shown_state[0] = meter.step(shown_state[0], jnp.asarray(share))

        whole = times if times[-1] == last else np.append(times, last)
        try:
            runs, place = _by_arrays_or_tape(system, states, whole, precision, longest, report_progress, place, late)
        except Untraceable as error:
            raise _refuse(system, error, precision.extended) from None
        if meter is not None:
            meter.close(shown_state[0])
    if (steps := int(runs.steps.max())) >= ADVANCING.max_steps:
        raise NotConverged(
            f"{steps:.1e} steps did not reach the last time, {last:g} s, and at most so many are taken. Give an "
            "earlier last time, which is `time.until` in a spec, or follow the motion in parts."
        )
    kept = runs._replace(states=runs.states[:, : len(times)], received=runs.received[:, : len(times)])
    return kept, place


def check_sizes(states: Double[Array, "copies ..."]) -> None:
    """Refuse states (C, …) whose products vanish or overflow."""
    sizes, smallest = np.abs(states).reshape(len(states), -1).max(axis=-1, initial=0.0), LIMITS.min_size
    wrong = (sizes > 0.0) & ((sizes < smallest) | (sizes > 1.0 / smallest))
    if wrong.any():
        raise NoSeries(
            f"`state` must be of a size within {smallest:g} to {1.0 / smallest:g} for Taylor, which multiplies its "
            f"numbers; got {sizes[np.argmax(wrong)]:.3g}. Choose units in which it is nearer to one.",
            "its state is so large or small that products of its numbers overflow or vanish", wrong,
        )
