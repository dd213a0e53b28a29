"""Lyapunov exponents of any motion: the mean rates at which small differences grow."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from polhode._base import check
from polhode._base.arrays import known_numbers_only
from polhode._base.long_work import long_work
from polhode.analysis._printing import print_answer, write_numbers, write_span
from polhode.analysis._tangent_flow import TangentFlow, check_start
from polhode.errors import NotConverged
from polhode.systems.base import AbstractSystem
from polhode.types import ArrayLike, Double, Float64, Real


class LyapunovLimits(NamedTuple):
    """Numbers that decide what growth is resolved, and how often changes are made orthogonal."""

    min_intervals: int = 256  # between which changes are made orthogonal again
    # e-folds in a finite time that regular motion may also show, growing by a power of the time
    unresolved_growth: float = 3.0
    max_separation: float = 12.0  # e-folds by which changes may part in an interval: more, and it is halved
    min_separation: float = 3.0  # e-folds: less, and the interval is doubled


LIMITS = LyapunovLimits()


class LyapunovExponents(NamedTuple):
    """The mean rates at which small differences of a motion grow.

    Attributes:
        exponents: (k,) [1/s], from the largest on.
        errors: (k,) [1/s] half-widths of 95 % intervals, by the scatter of parts of the time and by its length; an
            exponent that is less than its error may be zero.
        times: (N,) [s] ends of the intervals that count.
        growth: (N, k) what each exponent is by the growth up to then [1/s].
        last: the system's state at the end.
    """

    exponents: Float64[np.ndarray, "k"]
    errors: Float64[np.ndarray, "k"]
    times: Float64[np.ndarray, "n"]
    growth: Float64[np.ndarray, "n k"]
    last: Double[np.ndarray, "..."]

    @property
    def is_chaotic(self) -> bool:
        """Whether the largest is positive beyond its error: chaos, unless the motion rests or is periodic itself."""
        return bool(self.exponents[0] > self.errors[0])

    def __str__(self) -> str:
        largest = write_numbers(self.exponents[:1], "1/s", self.errors)
        comparison = "above its error: chaos" if self.is_chaotic else "not above its error: no chaos is seen"
        return print_answer(
            f"the largest exponent, {largest}, is {comparison}",
            exponents=write_numbers(self.exponents, "1/s", self.errors), times=write_span(self.times, "s"),
        )


@known_numbers_only
@long_work("averaging the growth of small changes")
def lyapunov(
    system: AbstractSystem, state: Real[ArrayLike, "..."], times: Real[ArrayLike, "2"], count: int | None = None
) -> LyapunovExponents:
    """Return the Lyapunov exponents of a motion, with errors.

    Small changes move with the linearised flow and are made orthogonal again before they become parallel; their growth
    in nine tenths of the time gives the rates. All of them belong to the state as it is packed: each Casimir, the
    energy and the direction of the motion add a zero, a body's attitude four. Of a Hamiltonian system they come in
    pairs ±λ.

    Args:
        system: what moves.
        state: one, packed as ``simulate`` takes it.
        times: first and last [s]. Errors of a chaotic motion go down as the root of the time, those of a regular one
            as one over it.
        count: how many of the largest exponents; by default all.

    Raises:
        InvalidInput: for a batch of states, an invalid count, invalid times, or a motion that ends earlier.
        NotConverged: if the motion or its changes leave the finite numbers.

    >>> import polhode as ph
    >>> body = ph.systems.FreeRigidBody((1.0, 2.0, 3.0))
    >>> bool(ph.analysis.lyapunov(body, [0.3, 1.9, 0.1], (0.0, 300.0)).is_chaotic)
    False

    Source: Benettin, Galgani, Giorgilli & Strelcyn, Meccanica 15 (1980) 9 and 21; Shimada & Nagashima, Prog. Theor.
    Phys. 61 (1979) 1605.
    """
    start, first, last = check_start(system, state, times)
    flow = TangentFlow(system, start, (first, last))
    count = flow.size if count is None else check.whole("count", count, 1, flow.size)
    span, now, base = last - first, first, start
    changes = np.linalg.qr(np.random.default_rng(1).normal(size=(flow.size, count)))[0]
    step = span / LIMITS.min_intervals
    ends, rates = [], []
    while abs(now - first) < abs(span):
        end = last if abs(last - now) <= 1.5 * abs(step) else now + step
        base_after, changes_after = flow(now, end, base, changes)
        # changes = Q R: the diagonal of R is by what volumes grew, one direction more at a time, and Q spans the same
        # (Benettin et al. 1980)
        directions, triangle = np.linalg.qr(changes_after)
        with np.errstate(divide="ignore"):
            grown = np.log(np.abs(np.diag(triangle)))
        apart = float(np.ptp(grown)) if np.isfinite(grown).all() else math.inf
        if apart > LIMITS.max_separation and abs(step) > 1e-9 * abs(span):
            step *= 0.5
            continue
        if not (np.isfinite(grown).all() and np.isfinite(base_after).all()):
            raise NotConverged(
                f"the changes of {type(system).__name__} leave the finite numbers at {now:g} s. Give an earlier last "
                "time, or fewer exponents by `count`."
            )
        ends.append(end)
        rates.append(grown)
        now, base, changes = end, base_after, directions
        if apart < LIMITS.min_separation and abs(step) < abs(span) / LIMITS.min_intervals:
            step *= 2.0
    return _average_growth(first, np.array(ends), np.array(rates), base)


def _average_growth(
    first: float, ends: Float64[np.ndarray, "all"], grown: Float64[np.ndarray, "all k"], last: Double[np.ndarray, "..."]
) -> LyapunovExponents:
    transient = 0.1  # share of the time in which changes turn into the directions that grow most
    block_counts = 8, 16, 32  # of the time, whose rates scatter
    factors = 2.4, 2.1, 2.0  # standard errors of as many blocks that hold 95 %, by Student's distribution
    begin = first + transient * (ends[-1] - first)
    known = int(np.searchsorted(np.abs(ends - first), abs(begin - first)))
    start = ends[known]
    times = ends[known + 1 :]
    total = np.cumsum(grown[known + 1 :], axis=0)
    elapsed = np.abs(times - start)
    growth = total / elapsed[:, None]
    exponents, errors = growth[-1], LIMITS.unresolved_growth / elapsed[-1]
    scatter = np.zeros_like(exponents)
    for blocks, factor in zip(block_counts, factors, strict=True):
        borders = np.searchsorted(elapsed, np.linspace(0.0, elapsed[-1], blocks + 1)[1:-1])
        sums = np.diff(np.concatenate([np.zeros_like(total[:1]), total[borders], total[-1:]]), axis=0)
        spans = np.diff(np.concatenate([[0.0], elapsed[borders], elapsed[-1:]]))
        # blocks are as long as one another but for an interval
        rates = sums / spans[:, None]
        scatter = np.maximum(scatter, factor * rates.std(axis=0, ddof=1) / math.sqrt(blocks))
    order = np.argsort(-exponents)
    return LyapunovExponents(exponents[order], (scatter + errors)[order], times, growth[:, order], last)
