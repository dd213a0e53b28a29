"""The error of motions by Taylor series, and steps by which it is within a tolerance.

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
from polhode.integrators._series import (
    NoSeries,
    Taylor,
    as_motion,
    check_starts,
    goes_by_arrays,
    reporting,
    run_or_refuse,
)
from polhode.integrators._series_comparison import LIMITS as COMPARING
from polhode.integrators._series_comparison import Asked, Comparison, in_batch, run_with_companions
from polhode.motion._outcome import Status
from polhode.systems.base import AbstractSystem
from polhode.taylor.array_series import Place
from polhode.taylor.expressions import Untraceable
from polhode.taylor.runs import Precision, Runs, choose_precision, finest_tolerance, join_runs, takes_companions
from polhode.types import Array, Bool, Double, Float64


class PartLimits(NamedTuple):
    """Sizes of parts of a batch, and how often copies are moved again."""

    max_numbers_together: int = 1 << 20  # of samples, 8 MB, of copies that are moved and compared side by side
    min_copies_together: int = 1024  # of many samples: fewer would not keep the threads of many processors busy
    max_rounds: int = 6  # of shorter steps, until a tolerance is met


LIMITS = PartLimits()


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
                raise in_batch(error, some, len(states), None) from None
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
) -> Asked:
    """Return enough times for a comparison, which cost next to nothing, and no more samples to be compared."""
    kept, least = times[::every], COMPARING.min_compared_times
    longest, by_arrays = math.inf if step is None else float(step), goes_by_arrays(system, states)
    whole = kept if kept[-1] == times[-1] else np.append(kept, times[-1])
    beside = not by_arrays and _takes_companions(system, states, whole, method)
    parts = 1 if beside else max(1, math.ceil(least / (len(whole) - 1)))
    fine = np.append(np.linspace(whole[:-1], whole[1:], parts, endpoint=False, axis=1), whole[-1])
    last = len(fine) - 1
    compared = np.append(np.arange(0, last, max(1, math.ceil(last / COMPARING.max_compared_times))), last)
    return Asked(system, method, fine, parts * np.arange(len(kept)), compared, longest, by_arrays, beside)


def _takes_companions(
    system: AbstractSystem, states: Double[Array, "copies ..."], times: Float64[np.ndarray, "time"], method: Taylor
) -> bool:
    try:
        return takes_companions(system, states, times, choose_precision(None, method.order, method.is_extended))
    except Untraceable:  # which the run says in words
        return False


def _run(
    asked: Asked, states: Double[Array, "copies ..."], tolerance: float | None, meter: Any, place: Place | None = None
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
                refused = in_batch(error, np.arange(len(states))[some], len(states), refused)
                if refused.copies is None:
                    raise
    if refused is not None:
        raise refused
    runs, errors = join_runs([part.runs for part in parts]), np.concatenate([part.errors for part in parts])
    return _Found(runs, errors, parts[-1].place)


def _share(report: Callable[[float], None], some: slice, copies: int, done: float) -> None:
    """Report the share of all copies that is done by the share of some."""
    report((some.start + (some.stop - some.start) * done) / copies)


def _together(asked: Asked, states: Double[Array, "copies ..."]) -> int:
    """Return how many copies are moved and compared side by side."""
    if asked.by_arrays:
        return 1  # as they are moved one after the other
    numbers = len(asked.times) * states[0].size
    return max(LIMITS.min_copies_together, LIMITS.max_numbers_together // numbers)


def _run_part(
    asked: Asked, states: Double[Array, "copies ..."], precision: Precision, report: Callable[[float], None],
    check: Callable[[float], None], place: Place | None,
) -> _Found:
    if asked.beside:
        runs, errors = run_with_companions(asked, states, precision, report, check)
        return _Found(_keep_saved(asked, runs), errors, None)
    last = asked.times[-1]
    runs, place = run_or_refuse(asked.system, states, asked.times, last, precision, asked.longest, report,
                                asked.by_arrays, place)
    errors = np.full(len(states), np.inf)
    if np.any(runs.status != Status.NOT_CONVERGED):
        compared = runs._replace(states=runs.states[:, asked.compared])
        errors = Comparison(asked, states, compared, check).estimate(precision)
    return _Found(_keep_saved(asked, runs), errors, place)


def _keep_saved(asked: Asked, runs: Runs) -> Runs:
    """Return runs with the samples that are kept; copies, as views would keep all of them in memory."""
    if len(asked.saved) == len(asked.times):
        return runs
    return runs._replace(states=runs.states[:, asked.saved], received=runs.received[:, asked.saved])


