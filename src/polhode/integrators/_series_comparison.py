"""Further runs beside motions by Taylor series, and what their distances from these say of the error.

A first further run begins a rounding away, and has other roundings throughout. Where truncation would show, it is of
higher order; otherwise it may be of lower order. A coarse run, which costs little, shows how small errors grow. Where
they do not, the distance of the first run is the error. Where they do, as beside a saddle or over a long time, one run
may be near the motion by chance, and the error is the largest distance of three that are more exact: from the start,
and from two that are a rounding away. Even all three may be near it by chance: of 15,000 starts beside saddles one had
an error of 14 times the estimate.

These runs are companions, which take the motion's own steps (``taylor.kernel_companions``). Series with twice as many
digits or of whole arrays, and motions past borders, which a companion passes at another time, have runs by steps of
their own, compared at common times.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import NamedTuple

import numpy as np

from polhode.integrators._difference import EPS, LARGE, difference, relative_size, starts_a_rounding_away
from polhode.integrators._series import NoSeries, Taylor, run_or_refuse
from polhode.motion._outcome import Status
from polhode.systems.base import AbstractSystem
from polhode.taylor.runs import Companions, Precision, Runs, choose_precision
from polhode.types import Array, Bool, Double, Float64, Integer


class ErrorLimits(NamedTuple):
    """Numbers that choose the further runs, and make an estimate of their distances from the motion."""

    min_compared_times: int = 64  # of long motions beside saddles: with 16 an error was 1,900 times what was said
    max_compared_times: int = 256  # of many samples: with 16 of 2,000, flips beside a saddle between them were not seen
    more_orders: int = 4  # of runs that show truncation
    reach_share: float = 0.8  # of theirs: beside saddles, where series end fast, more orders only make steps longer
    fewer_orders: int = 3  # of a run that shows roundings alone, if its truncation is below them: it costs less
    max_unseen_truncation: float = EPS / 8.0  # of such a step, relative to the state's size
    min_plain_truncation: float = 1e-9  # of a step: from here on it outweighs roundings, even where errors grow
    min_pure_truncation: float = 2e-13  # of a step: from here on one companion shows what is left of it; below,
    # of 1,500 motions past a hill one was off by 106 times the estimate
    coarse_tolerance: float = 1e-3  # of the steps of the run that shows growth
    max_growth: float = 20.0  # of its error, over that tolerance, up to which small errors have not grown
    coarse_truncation: float = 1e-4  # of a step of the companion that shows growth
    max_coarse_gap: float = 0.02  # of its, likewise
    max_roundings: float = 128.0  # by which the first run is off, likewise
    rounding_factor: float = 4.0  # as three other runs show most of what roundings grow to, not all
    single_factor: float = 8.0  # of one other run: of 2,000 starts 1 in 100 was off by more than four distances
    truncation_factor: float = 2.0  # as one run shows most of it, and growth is common to both
    min_error_roundings: float = 4.0  # of the last step and of the sample itself


LIMITS = ErrorLimits()


class Asked(NamedTuple):
    """What is asked of all copies.

    Attributes:
        system, method: whose motions by which series.
        times: (T,) [s] of samples, enough for a comparison.
        saved: which of them are kept.
        compared: at which of them runs are compared.
        longest: step [s].
        by_arrays: whether series are of whole arrays.
        beside: whether further runs go beside the motion, as its companions.
    """

    system: AbstractSystem
    method: Taylor
    times: Float64[np.ndarray, "time"]
    saved: Integer[np.ndarray, "kept"]
    compared: Integer[np.ndarray, "compared"]
    longest: float
    by_arrays: bool
    beside: bool


def run_with_companions(
    asked: Asked, states: Double[Array, "copies ..."], precision: Precision, report: Callable[[float], None],
    check: Callable[[float], None],
) -> tuple[Runs, Float64[np.ndarray, "copies"]]:
    """Return motions, and their errors by companions."""
    one, two = starts_a_rounding_away(asked.system, states)
    finer = precision.order + LIMITS.more_orders
    by_truncation, first = truncation(precision), choose_first(precision).order
    if by_truncation >= LIMITS.min_plain_truncation:
        runs, gaps = _run_beside(asked, states, asked.times, precision, [one], (finer,), report)
        return runs, _as_error(gaps[0], LIMITS.truncation_factor)
    orders = first, choose_coarse(precision)
    runs, (gaps, coarse) = _run_beside(asked, states, asked.times, precision, [one, states], orders, report)
    outweighs = by_truncation > LIMITS.max_roundings * EPS  # roundings that have not grown
    grown = ~(coarse <= LIMITS.max_coarse_gap) | (not outweighs and gaps > LIMITS.max_roundings * EPS)
    grown &= runs.status != Status.NOT_CONVERGED
    factors = np.where(grown, LIMITS.rounding_factor, LIMITS.truncation_factor if outweighs else LIMITS.single_factor)
    if by_truncation < LIMITS.min_pure_truncation and (which := np.flatnonzero(grown)).size:
        some = [x[which] for x in (states, one, two)]
        _, more = _run_beside(asked, some[0], asked.times[[0, -1]], precision, some, (finer,) * 3, check)
        gaps[which] = np.max([*more, *([gaps[which]] if first == finer else [])], axis=0)
    return runs, _as_error(gaps, factors)


def _run_beside(
    asked: Asked, states: Double[Array, "copies ..."], times: Float64[np.ndarray, "time"], precision: Precision,
    starts: Sequence[Array], orders: tuple[int, ...], report: Callable[[float], None],
) -> tuple[Runs, list[Float64[np.ndarray, "copies"]]]:
    """Return motions, and how far each of their companions is off; infinite where one of them failed."""
    companions = Companions(np.stack(starts), orders)
    runs, _ = run_or_refuse(asked.system, states, times, times[-1], precision, asked.longest, report, False,
                            companions=companions)
    gaps = []
    for j in range(len(orders)):
        with np.errstate(invalid="ignore"):
            gap = relative_size(asked.system, runs.gaps[:, j], runs.sizes, states)
        gaps.append(np.where((runs.status == Status.NOT_CONVERGED) | np.isnan(gap), np.inf, gap))
    return runs._replace(gaps=runs.gaps[:, :0]), gaps


def in_batch(error: NoSeries, some: Integer[np.ndarray, "some"], copies: int, before: NoSeries | None) -> NoSeries:
    """Return a refusal of some copies as one of a batch, with those that were refused before."""
    first = error if before is None else before
    if error.copies is not None:
        lost = np.zeros(copies, bool) if before is None or before.copies is None else before.copies
        lost[some] = error.copies
        first.copies = lost
    return first


class Comparison(NamedTuple):
    """Motions of some copies, at the compared times, and their starts."""

    asked: Asked
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
            raise in_batch(error, some, len(starts), None) from None
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


def choose_coarse(precision: Precision) -> int:
    """Return the order of a companion that shows growth by a truncation of its own."""
    return max(2, math.ceil(math.log(LIMITS.coarse_truncation) / math.log(precision.reach)) - 1)


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
