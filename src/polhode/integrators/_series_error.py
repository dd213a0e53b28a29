"""The error of motions by Taylor series, from further runs, and steps by which it is within a tolerance.

A first further run begins a rounding away, and has other roundings throughout. Where steps are far longer than
roundings need, it is of higher order, with shorter steps, and shows their truncation; otherwise it may be of lower
order. A coarse run, which costs next to nothing, shows how small errors grow. Where they do not, the distance of the
first run is the error. Where they do, as beside a saddle or over a long time, one run may be near the motion by chance,
and the error is the largest distance of three that are more exact: from the start, and from two that are a rounding
away. Even all three may be near it by chance: of 3,000 starts beside saddles one had an error of seven times the
estimate.

Copies are moved and compared in parts of a batch, so that no more samples are in memory than the part's.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from functools import partial
from typing import Any, NamedTuple

import numpy as np

from polhode.errors import NotConverged
from polhode.integrators._adaptive import AdaptiveMotion
from polhode.integrators._difference import EPS, LARGE, difference, starts_a_rounding_away
from polhode.integrators._series import (
    NoSeries,
    Taylor,
    as_motion,
    check_starts,
    goes_by_arrays,
    reporting,
    run_or_refuse,
)
from polhode.motion._outcome import Status
from polhode.systems.base import AbstractSystem
from polhode.taylor.array_series import Place
from polhode.taylor.runs import Precision, Runs, choose_precision, finest_tolerance, join_runs
from polhode.types import Array, Bool, Double, Float64, Integer


class ErrorLimits(NamedTuple):
    """Numbers that choose the further runs, and make an estimate of their distances from the motion."""

    min_compared_times: int = 64  # of long motions beside saddles: with 16 an error was 1,900 times what was said
    max_compared_times: int = 256  # of many samples: with 16 of 2,000, flips beside a saddle between them were not seen
    max_numbers_together: int = 1 << 20  # of samples, 8 MB, of copies that are moved and compared side by side
    min_copies_together: int = 1024  # of many samples: fewer would not keep the threads of many processors busy
    more_orders: int = 4  # of runs that show truncation
    reach_share: float = 0.8  # of theirs: beside saddles, where series end fast, more orders only make steps longer
    fewer_orders: int = 3  # of a run that shows roundings alone, if its truncation is below them: it costs less
    max_unseen_truncation: float = EPS / 8.0  # of such a step, relative to the state's size
    min_plain_truncation: float = 1e-9  # of a step: from here on it outweighs roundings, even where errors grow
    coarse_tolerance: float = 1e-3  # of the steps of the run that shows growth
    max_growth: float = 20.0  # of its error, over that tolerance, up to which small errors have not grown
    max_roundings: float = 128.0  # by which the first run is off, likewise
    rounding_factor: float = 4.0  # as three other runs show most of what roundings grow to, not all
    single_factor: float = 8.0  # of one other run: of 2,000 starts 1 in 100 was off by more than four distances
    truncation_factor: float = 2.0  # as one run shows most of it, and growth is common to both
    min_error_roundings: float = 4.0  # of the last step and of the sample itself
    max_rounds: int = 6  # of shorter steps, until a tolerance is met


LIMITS = ErrorLimits()


class _Asked(NamedTuple):
    """What is asked of all copies.

    Attributes:
        system, method: whose motions by which series.
        times: (T,) [s] of samples, enough for a comparison.
        saved: which of them are kept.
        compared: at which of them runs are compared.
        longest: step [s].
        by_arrays: whether series are of whole arrays.
    """

    system: AbstractSystem
    method: Taylor
    times: Float64[np.ndarray, "time"]
    saved: Integer[np.ndarray, "kept"]
    compared: Integer[np.ndarray, "compared"]
    longest: float
    by_arrays: bool


class _Found(NamedTuple):
    """Runs with the kept samples, their estimated errors (C,), and where the last step began of series of arrays."""

    runs: Runs
    errors: Float64[np.ndarray, "copies"]
    place: Place | None


def solve_with_error(
    system: AbstractSystem, method: Taylor, state: Double[Array, "..."], times: Float64[np.ndarray, "time"],
    meter: Any = None, step: float | None = None, tolerance: float | None = None, every: int = 1,
    memory: Sequence[Array] | None = None,
) -> tuple[AdaptiveMotion, Float64[Array, "*batch"] | None]:
    """Return the motion, and its estimated error unless every copy failed.

    Raises:
        InvalidInput, NotConverged: as ``solve_by_series``.
    """
    states, place = check_starts(system, state, times, memory)
    batch = np.shape(state)[: np.ndim(state) - system.state_axes]
    found = _run(_ask(system, method, states, times, step, every), states, tolerance, meter, place)
    motion = as_motion(system, batch, times, times[::every], found.runs, found.place)
    return motion, found.errors.reshape(batch) if np.any(motion.successful) else None


def series_to_tolerance(
    system: AbstractSystem, method: Taylor, state: Double[Array, "..."], times: Float64[np.ndarray, "time"],
    meter: Any, step: float | None, tolerance: float, every: int = 1,
) -> tuple[AdaptiveMotion, Float64[Array, "*batch"], float]:
    """Return a motion whose estimated error is within a tolerance, that error, and the least tolerance of a step.

    Only copies that miss the tolerance are moved again, each with a tolerance of its steps that follows from its own
    error, so that it moves as it would alone.

    Raises:
        NotConverged: if rounding alone makes more of it.
    """
    states, _ = check_starts(system, state, times)
    batch = np.shape(state)[: np.ndim(state) - system.state_axes]
    asked, least = _ask(system, method, states, times, step, every), finest_tolerance(method.is_extended)
    local, found = np.full(len(states), tolerance), _run(asked, states, tolerance, meter)
    for _ in range(1, LIMITS.max_rounds):
        missed = _missed(found, tolerance)
        if not missed.any() or np.any(local[missed] <= least):
            break
        local[missed] = np.maximum(local[missed] * _shares(found.errors[missed], tolerance), least)
        for value in np.unique(local[missed]):
            some = np.flatnonzero(missed & (local == value))
            try:
                part = _run(asked, states[some], float(value), meter)
            except NoSeries as error:
                raise _in_batch(error, some, len(states), None) from None
            for whole, own in zip((*found.runs[:-1], found.errors), (*part.runs[:-1], part.errors), strict=True):
                whole[some] = own
            found = found._replace(place=part.place)
    if (missed := _missed(found, tolerance)).any():
        raise NotConverged(
            f"`tolerance` {tolerance:g} could not be met: the estimated error is {found.errors[missed].max():.2g}, and "
            "shorter steps do not help, as it comes from rounding or chaos. Allow more, or shorten the time."
        )
    motion = as_motion(system, batch, times, times[::every], found.runs, found.place)
    return motion, found.errors.reshape(batch), float(local.min())


def _missed(found: _Found, tolerance: float) -> Bool[np.ndarray, "copies"]:
    return (found.errors > tolerance) & (found.runs.status != Status.NOT_CONVERGED)


def _shares(errors: Float64[np.ndarray, "copies"], tolerance: float) -> Float64[np.ndarray, "copies"]:
    """Return by which powers of ten steps must be more exact; powers, as copies with the same one move together."""
    return 10.0 ** (-1.0 - np.floor(np.log10(errors / tolerance)))


def _ask(
    system: AbstractSystem, method: Taylor, states: Double[Array, "copies ..."], times: Float64[np.ndarray, "time"],
    step: float | None, every: int,
) -> _Asked:
    """Return enough times for a comparison, which cost next to nothing, and no more samples to be compared."""
    kept, least = times[::every], LIMITS.min_compared_times
    whole = kept if kept[-1] == times[-1] else np.append(kept, times[-1])
    parts = max(1, math.ceil(least / (len(whole) - 1)))
    fine = np.append(np.linspace(whole[:-1], whole[1:], parts, endpoint=False, axis=1), whole[-1])
    last = len(fine) - 1
    compared = np.append(np.arange(0, last, max(1, math.ceil(last / LIMITS.max_compared_times))), last)
    longest = math.inf if step is None else float(step)
    by_arrays = goes_by_arrays(system, states)
    return _Asked(system, method, fine, parts * np.arange(len(kept)), compared, longest, by_arrays)


def _run(
    asked: _Asked, states: Double[Array, "copies ..."], tolerance: float | None, meter: Any, place: Place | None = None
) -> _Found:
    """Return motions with their errors."""
    precision = choose_precision(tolerance, asked.method.order, asked.method.is_extended)
    count, parts, refused = _together(asked, states), [], None
    with reporting(meter) as (report, check):
        for first in range(0, len(states), count):
            some = slice(first, min(first + count, len(states)))
            own = partial(_share, report, some, len(states))
            try:
                parts.append(_run_part(asked, states[some], precision, own, lambda share: check(), place))
            except NoSeries as error:
                refused = _in_batch(error, np.arange(len(states))[some], len(states), refused)
                if refused.copies is None:
                    raise
    if refused is not None:
        raise refused
    runs, errors = join_runs([part.runs for part in parts]), np.concatenate([part.errors for part in parts])
    return _Found(runs, errors, parts[-1].place)


def _share(report: Callable[[float], None], some: slice, copies: int, done: float) -> None:
    """Report the share of all copies that is done by the share of some."""
    report((some.start + (some.stop - some.start) * done) / copies)


def _in_batch(error: NoSeries, some: Integer[np.ndarray, "some"], copies: int, before: NoSeries | None) -> NoSeries:
    """Return a refusal of some copies as one of a batch, with those that were refused before."""
    first = error if before is None else before
    if error.copies is not None:
        lost = np.zeros(copies, bool) if before is None or before.copies is None else before.copies
        lost[some] = error.copies
        first.copies = lost
    return first


def _together(asked: _Asked, states: Double[Array, "copies ..."]) -> int:
    """Return how many copies are moved and compared side by side."""
    if asked.by_arrays:
        return 1  # as they are moved one after the other
    numbers = len(asked.times) * states[0].size
    return max(LIMITS.min_copies_together, LIMITS.max_numbers_together // numbers)


def _run_part(
    asked: _Asked, states: Double[Array, "copies ..."], precision: Precision, report: Callable[[float], None],
    check: Callable[[float], None], place: Place | None,
) -> _Found:
    last = asked.times[-1]
    runs, place = run_or_refuse(asked.system, states, asked.times, last, precision, asked.longest, report,
                                asked.by_arrays, place)
    errors = np.full(len(states), np.inf)
    if np.any(runs.status != Status.NOT_CONVERGED):
        compared = runs._replace(states=runs.states[:, asked.compared])
        errors = _Comparison(asked, states, compared, check).estimate(precision)
    # copies, as views would keep all samples in memory
    kept = runs._replace(states=runs.states[:, asked.saved], received=runs.received[:, asked.saved])
    return _Found(kept, errors, place)


class _Comparison(NamedTuple):
    """Motions of some copies, at the compared times, and their starts."""

    asked: _Asked
    starts: Double[Array, "copies ..."]
    runs: Runs
    check: Callable[[float], None]

    def estimate(self, precision: Precision) -> Float64[np.ndarray, "copies"]:
        """Return the estimated errors of runs with a precision."""
        everyone, finer = np.arange(len(self.starts)), make_finer(precision)
        if precision.extended:  # whose roundings are not those of doubles
            return _as_error(self.off(everyone, self.starts, finer), LIMITS.rounding_factor)
        one, two = starts_a_rounding_away(self.asked.system, self.starts)
        first = finer if self.asked.by_arrays else choose_first(precision)  # as JAX compiles each order of arrays
        gaps, factors = self.off(everyone, one, first, 1.0), np.full(len(everyone), LIMITS.single_factor)
        if truncation(precision) >= LIMITS.min_plain_truncation:
            return _as_error(gaps, LIMITS.truncation_factor)
        grown = gaps > LIMITS.max_roundings * EPS
        if truncation(precision) > LIMITS.max_roundings * EPS:  # which outweighs roundings that have not grown
            grown, factors = np.zeros_like(grown), np.full(len(everyone), LIMITS.truncation_factor)
        which = np.flatnonzero(self.add_grown(grown))
        if which.size:
            factors[which] = LIMITS.rounding_factor
            more = [gaps[which]] if first == finer else [self.off(which, one, finer, 1.0)]
            more += [self.off(which, self.starts, finer), self.off(which, two, finer, -1.0)]
            gaps[which] = np.max(more, axis=0)
        return _as_error(gaps, factors)

    def add_grown(self, grown: Bool[np.ndarray, "copies"]) -> Bool[np.ndarray, "copies"]:
        """Return which copies are known to make much of small errors, or do so in a coarse run."""
        coarse = choose_precision(LIMITS.coarse_tolerance)
        while not (grown.all() or self.asked.by_arrays):
            rest = np.flatnonzero(~grown)
            try:
                gap = self.off(rest, self.starts, coarse)
            except NoSeries as error:  # as a coarse run comes to other places
                grown = grown | (True if error.copies is None else error.copies)
                continue
            grown[rest] = gap > LIMITS.max_growth * LIMITS.coarse_tolerance
            return grown
        return np.ones_like(grown)

    def off(
        self, some: Integer[np.ndarray, "some"], starts: Double[Array, "copies ..."], precision: Precision,
        late: float = 0.0,
    ) -> Float64[np.ndarray, "some"]:
        """Return how far runs from starts are from the motions of some copies.

        Args:
            some: copies.
            starts: of all.
            precision: of the runs.
            late: roundings of the time by which they pass borders and jumps too late.
        """
        asked, each = self.asked, np.full(len(some), late) if late else None
        times = asked.times[asked.compared]
        whole = len(some) == len(starts)  # no need to copy
        try:
            again, _ = run_or_refuse(asked.system, starts if whole else starts[some], times, times[-1], precision,
                                     asked.longest, self.check, asked.by_arrays, late=each)
        except NoSeries as error:
            raise _in_batch(error, some, len(starts), None) from None
        return _apart(asked.system, times, self.runs if whole else self.runs.part(some), again)


def truncation(precision: Precision) -> float:
    """Return the error of a step by the end of its series, relative to the state's size."""
    return precision.reach**precision.order


def make_finer(precision: Precision) -> Precision:
    """Return the precision of runs that show the truncation of those with another."""
    return precision._replace(order=precision.order + LIMITS.more_orders, reach=LIMITS.reach_share * precision.reach)


def choose_first(precision: Precision) -> Precision:
    """Return the precision of a run that shows roundings: of fewer orders, unless its truncation would show."""
    fewer = precision._replace(order=precision.order - LIMITS.fewer_orders)
    return fewer if truncation(fewer) <= LIMITS.max_unseen_truncation else make_finer(precision)


def _as_error(
    gaps: Float64[np.ndarray, "copies"], factor: Float64[np.ndarray, "copies"] | float
) -> Float64[np.ndarray, "copies"]:
    return np.where(gaps > LARGE, gaps, np.maximum(factor * gaps, LIMITS.min_error_roundings * EPS))


def _apart(
    system: AbstractSystem, times: Float64[np.ndarray, "time"], one: Runs, other: Runs
) -> Float64[np.ndarray, "copies"]:
    """Return how far runs are apart until either ends; infinite where one of them failed."""
    distances, whole = np.zeros(len(one.states)), np.full(len(one.states), abs(times[-1] - times[0]))
    last = np.nanmin([np.abs(one.end - times[0]), np.abs(other.end - times[0]), whole], axis=0)
    counts = np.maximum(np.sum(np.abs(times - times[0]) <= last[:, None] * (1.0 - 1e-9), axis=1), 1)
    counts[(one.event == -1) & (other.event == -1)] = len(times)
    for count in np.unique(counts):
        some = slice(None) if np.all(counts == count) else counts == count  # no need to copy
        with np.errstate(invalid="ignore"):
            distances[some] = difference(system, one.states[some, :count], other.states[some, :count])
    failed = (one.status == Status.NOT_CONVERGED) | (other.status == Status.NOT_CONVERGED)
    return np.where(failed | np.isnan(distances), np.inf, distances)
