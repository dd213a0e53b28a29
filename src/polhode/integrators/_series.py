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
from polhode.integrators._interrupts import keep_interrupts
from polhode.motion._outcome import Ends, Status
from polhode.systems._forms import as_rows, facts_of
from polhode.systems.base import AbstractSystem
from polhode.taylor.advancing import LIMITS as ADVANCING
from polhode.taylor.array_series import Place, runs_of_arrays
from polhode.taylor.expressions import Untraceable
from polhode.taylor.machine import build_machine, count_operations
from polhode.taylor.runs import Companions, Precision, Runs, choose_precision, run_copies
from polhode.types import Array, Bool, Double, Float64

PRECISIONS = "double", "extended"


class SeriesLimits(NamedTuple):
    """Thresholds that refuse a series, or choose its form."""

    min_order: int = 4
    max_order: int = 60
    max_operations: int = 20_000  # of the rates of change; tracing more takes longer than what it may save
    min_size: float = 1e-150  # of a state, and one over it the largest: else products of its numbers vanish or overflow


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
    return facts_of(system).series_of_arrays or _operations(system, state) <= LIMITS.max_operations


def goes_by_arrays(system: AbstractSystem, state: Double[Array, "..."]) -> bool:
    """Return whether the system's series are of whole arrays; such a motion can be resumed bit for bit."""
    return facts_of(system).series_of_arrays or _operations(system, state) > LIMITS.max_operations


def _operations(system: AbstractSystem, state: Double[Array, "..."]) -> int:
    return count_operations(system, as_rows(system, state)[0])


def find_obstacle(
    system: AbstractSystem, state: Double[Array, "..."], times: tuple[float, float], extended: bool = False
) -> NoSeries | None:
    """Return why motions between two times have no series, as far as their starts show it."""
    one = as_rows(system, state)[0]
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
    states, place = check_starts(system, state, times, memory)
    precision = choose_precision(tolerance, method.order, method.is_extended)
    with reporting(meter) as (report, _):
        whole = goes_by_arrays(system, states)
        runs, place = run_or_refuse(system, states, kept, times[-1], precision, longest, report, whole, place)
    return as_motion(system, np.shape(state)[: np.ndim(state) - system.state_axes], times, kept, runs, place)


def check_starts(
    system: AbstractSystem, state: Double[Array, "..."], times: Float64[np.ndarray, "time"],
    memory: Sequence[Array] | None = None,
) -> tuple[Double[Array, "copies ..."], Place | None]:
    """Return the starts of copies one below the other, and where the step began in which one motion is resumed.

    Raises:
        InvalidInput: for starts at an event, states of a size whose products are no numbers, or another's memory.
    """
    states, facts = as_rows(system, state), facts_of(system)  # which refuses jumps that are not finite
    if facts.has_events:
        check_events(system, times[0], state)
    check_sizes(states)
    return states, None if memory is None else _find_place(memory, states, times[0])


def as_motion(
    system: AbstractSystem, batch: tuple[int, ...], times: Float64[np.ndarray, "time"],
    kept: Float64[np.ndarray, "kept"], runs: Runs, place: Place | None,
) -> AdaptiveMotion:
    """Return runs with samples at the kept ones of the times as a motion of a batch."""
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


def _by_arrays_or_tape(
    system: AbstractSystem, states: Array, times: np.ndarray, precision: Precision, longest: float,
    check: Callable[[float], None], by_arrays: bool, place: Place | None, late: Float64[np.ndarray, "copies"] | None,
    companions: Companions | None,
) -> tuple[Runs, Place | None]:
    """Return runs by series of whole arrays where these pay and exist, otherwise by series of single numbers."""
    if by_arrays:
        try:
            return runs_of_arrays(system, states, times, precision, longest, check, place)
        except Untraceable:
            if place is not None:
                raise
    return run_copies(system, states, times, precision, longest, check, late=late, companions=companions), None


def _find_place(memory: Sequence[Array], states: Double[Array, "copies ..."], first: float) -> Place:
    """Return where the last step of an earlier motion began; ``memory`` has the time from there to its end."""
    shapes = [np.shape(x) for x in memory]
    if shapes != [(), np.shape(states[0]), ()] or len(states) > 1:
        raise InvalidInput(
            f"`memory` must be that of an earlier run by Taylor from one state: a time, a state {np.shape(states[0])} "
            f"and a unit of time; got shapes {shapes}. Leave it out to begin afresh."
        )
    return Place(first - float(memory[0]), np.asarray(memory[1], states.dtype), float(memory[2]))


class reporting:
    """Give what shows the completed share of a run by a meter, if there is one, and what only lets Ctrl-C act."""

    def __init__(self, meter: Any) -> None:
        self._meter, self._interrupts = meter, keep_interrupts()

    def __enter__(self) -> tuple[Callable[[float], None], Callable[[], None]]:
        self._check = self._interrupts.__enter__()
        self._shown = None if self._meter is None else self._meter.init()
        return self._report, self._check

    def __exit__(self, kind: Any, *error: object) -> None:
        self._interrupts.__exit__()
        if self._meter is not None and kind is None:
            self._meter.close(self._shown)

    def _report(self, share: float) -> None:
        self._check()
        if self._meter is not None:
            self._shown = self._meter.step(self._shown, jnp.asarray(share))


def run_or_refuse(
    system: AbstractSystem, states: Array, times: np.ndarray, last: float, precision: Precision, longest: float,
    report: Callable[[float], None], by_arrays: bool, place: Place | None = None,
    late: Float64[np.ndarray, "copies"] | None = None, companions: Companions | None = None,
) -> tuple[Runs, Place | None]:
    """Return runs up to a last time, which need not be a sample, and where to resume; or say why there are none."""
    whole = times if times[-1] == last else np.append(times, last)
    try:
        runs, place = _by_arrays_or_tape(system, states, whole, precision, longest, report, by_arrays, place, late,
                                         companions)
    except Untraceable as error:
        raise _refuse(system, error, precision.extended) from None
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
