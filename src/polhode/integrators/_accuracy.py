"""The error of a run by equal steps, from runs with other steps and from starts a rounding away.

A method of order p errs by E ∝ Σ Δt hᵖ. Two runs with steps h and h' differ by (R − 1) E with R = Σ Δt h'ᵖ / Σ Δt hᵖ,
which gives E: Richardson's extrapolation. Where the runs differ by much, the law does not hold and the difference is
the estimate, as for chaotic motion after its memory has gone. What it leaves out grows with the square of the
difference: a method of order 8 with five steps where the other has three was off by nine times what the law says,
though they differed by 0.0025 only. So the square is added, over the difference from which on no law holds.

Rounding does not follow that law: at order 8 the runs have it alike, and R − 1 = 255 would divide it away. Near a
saddle it grows to most of the error. What the motion makes of a rounding is seen in further runs, with the same steps,
from starts that are a rounding away. A single one may happen to lie along the motion, where nothing grows; two do so
once in ten thousand starts.
Source: Hairer, Nørsett & Wanner, *Solving Ordinary Differential Equations I*, II.4.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from polhode.errors import NotConverged
from polhode.integrators._difference import EPS, LARGE, LUCK, TWO_PLACES, difference, starts_a_rounding_away
from polhode.integrators._equal_steps import Run, run_by_equal_steps, run_through_windows, step_counts
from polhode.integrators._windows import inner_windows, split_into_windows
from polhode.integrators.base import AbstractOrbitSolver, Memory
from polhode.integrators.probing import depends_on_time, jumps_between
from polhode.systems.base import AbstractLiePoissonSystem
from polhode.types import Array, Double, Float64

DOUBTFUL = 1e-3  # distance of two runs at the samples, from which on they may be much farther apart in between
FEWEST = 4.0  # roundings of the last step and of the sample itself
SAFETY = 0.7  # of the tolerance, at which the next step size aims
SHORTEST = 1 / 32  # of a step, in one round
ROUNDS = 8
MAX_STEPS = 1e9  # of all copies together, in one round


class Measured(NamedTuple):
    """A run with its largest steps (batch…) [s] and its estimated error (batch…), None if not asked for."""

    run: Run
    sizes: Float64[Array, "*batch"]
    error: Float64[np.ndarray, "*batch"] | None


def run_with_error(
    solver: AbstractOrbitSolver, state: Double[Array, "..."], times: Float64[np.ndarray, "time"],
    sizes: Float64[Array, "*batch"], rates: Float64[Array, "*batch"], meter: Any, quiet: Any, every: int = 1,
    memory: Memory | None = None,
) -> Measured:
    """Return a run and its error, relative to the size of attitude, momentum and what else the state holds.

    The second run takes steps twice as long, at half the cost; or half as long, at twice the cost, where samples are a
    step apart and steps cannot be longer, or the longer ones failed. Those from other starts take the longer steps of
    the two, each at half the cost of the first or at the same.
    """
    run = run_by_equal_steps(solver, state, times, sizes, rates, meter, every, memory)
    ends = _ends(solver.system, times)
    counts = step_counts(ends, sizes)
    windows = 1 if every > 1 else inner_windows(len(times), int(step_counts(times, sizes).min()))

    def again(start: Any, at: Any) -> Run:
        if windows > 1:
            return run_through_windows(solver, start, times, at, rates, quiet, windows)
        return run_by_equal_steps(solver, start, times, at, rates, quiet, every)

    others = np.where(counts.min(axis=-1) > 1, 2.0, 0.5) * sizes
    second = again(state, others)
    failed = ~second.fine & run.fine & (others > sizes)
    if failed.any():
        others = np.where(failed, 0.5 * sizes, others)
        second = again(state, others)
    order = solver.order(None)
    finer = _ends(solver.system, np.append(np.ravel(split_into_windows(times, windows)[:, :-1]), times[-1]))
    power, other_power = (_power(at, n, order) for at, n in ((ends, counts), (finer, step_counts(finer, others))))
    gain = np.abs(other_power / power - 1.0)
    longer = others > sizes
    system, axes = solver.system, run.states.ndim - np.ndim(sizes)
    at_times = np.take(second.states, np.arange(0, second.states.shape[np.ndim(sizes)], windows), axis=np.ndim(sizes))
    base = second.states if windows > 1 else (
        np.where(longer.reshape(*longer.shape, *(1,) * axes), second.states, run.states))
    fine, grown = run.fine & second.fine, np.zeros(np.shape(sizes))
    with np.errstate(invalid="ignore"):
        off = difference(system, run.states, at_times)
        for kicked in starts_a_rounding_away(system, state, not solver.rounds_each_number, TWO_PLACES):
            third = again(kicked, others if windows > 1 else np.maximum(sizes, others))
            grown, fine = np.maximum(grown, difference(system, base, third.states)), fine & third.fine
        # they may be near to each other at the samples only
        if windows > 1 and (fine & ((grown > LUCK * off) | (off > DOUBTFUL))).any():
            off = np.maximum(off, difference(system, again(state, sizes).states, second.states))
    # what a rounding could make of the motion, it has not made where the two runs are much nearer to each other
    error = np.where(off > LARGE, off * np.maximum(1.0, 1.0 / gain),
                     np.maximum(off / gain + off * off / LARGE, np.minimum(LUCK * off, grown)))
    if depends_on_time(system, state):  # a pulse that no run met makes them alike, which proves nothing
        error = np.maximum(error, EPS * np.sqrt(counts.sum(axis=-1)))
    error = np.maximum(error, FEWEST * EPS)
    return Measured(run, sizes, np.where(fine, error, np.inf))


def _power(ends: Float64[np.ndarray, "ends"], counts: Array, order: int) -> Float64[Array, "*batch"]:
    """Return Σ Δt hᵖ of steps (batch…, T − 1) in each interval, over the whole time."""
    gaps = np.abs(np.diff(ends)) / np.ptp(ends)
    return np.sum(gaps * (gaps / counts) ** order, axis=-1)


def _ends(system: AbstractLiePoissonSystem, times: Float64[np.ndarray, "time"]) -> Float64[np.ndarray, "ends"]:
    """Return the times with the system's jumps between them, at all of which steps end."""
    jumps = jumps_between(times, np.asarray(system.jumps))
    return np.unique(np.concatenate([times, jumps]))[:: 1 if times[-1] > times[0] else -1] if len(jumps) else times


def run_to_tolerance(
    solver: AbstractOrbitSolver, state: Double[Array, "..."], times: Float64[np.ndarray, "time"],
    sizes: Float64[Array, "*batch"], rates: Float64[Array, "*batch"], tolerance: float, meter: Any,
    quiet: Any, every: int = 1,
) -> Measured:
    """Return a run whose estimated error is within the tolerance, by shorter steps where it was not.

    Raises:
        NotConverged: if steps no longer help, or would be too many.
    """
    last = error = np.full(np.shape(rates), np.inf)
    stuck, wanted = np.zeros(np.shape(rates), bool), 0.0
    for _ in range(ROUNDS):
        run = run_with_error(solver, state, times, sizes, rates, meter, quiet, every)
        error = np.asarray(run.error)
        missed = error > tolerance
        if not missed.any():
            return run
        stuck = missed & np.isfinite(error) & (error > 0.9 * last)
        shorter = (SAFETY * tolerance / error) ** (1.0 / solver.order(None))
        sizes = np.where(missed, sizes * np.clip(shorter, SHORTEST, 0.8), sizes)
        wanted = float(step_counts(times, sizes).sum(axis=-1).max()) * sizes.size
        if stuck.any() or wanted > MAX_STEPS:
            break
        last = error
    why = "shorter steps no longer help, as rounding or chaos has the error" if stuck.any() else (
        f"it would take about {wanted:.1e} steps, or more than {ROUNDS} rounds of shorter ones")
    raise NotConverged(
        f"`tolerance` {tolerance:g} could not be met: the estimated error is {error.max():.2g}, and {why}. "
        "Allow more, shorten the time, or take a method of higher order."
    )
