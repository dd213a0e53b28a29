"""Finds samples at a gyro's limit: a plateau at the end of its range, which rates reach without slowing."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np

from polhode.measuring.throws.gyro_log import GyroLog
from polhode.types import Array, Float64

FEWEST = 3  # samples of a plateau
KNOWN = np.radians([125.0, 245.0, 250.0, 500.0, 1000.0, 2000.0, 4000.0,
                    143.4, 286.7, 573.4, 1146.9, 2293.8, 4587.5])  # fmt: skip
"""Ranges that gyros are sold with [rad/s]; those below are 32768 counts of 4.375, 8.75, 17.5, 35, 70 and 140 mdeg/s."""
OFF_RANGE = 0.0012  # of a known range, by which rounding and scale may move it
BEYOND = 0.03  # of the largest rate: a limit is that of all axes, up to their gains
PEAKED = 1.5  # samples down to 4 steps below the top, over those at the top; a smooth peak has 2.2 or more
SLOWED = 3.0  # samples down to 16 steps over those down to 4, without the top: 4 for a ramp, 2.5 for a smooth peak,
# 1.6 for a rate that creeps to its end as a turn about the middle axis does
SLOW_EDGE = 3  # samples down to 16 steps at each edge; of fewer it cannot be told whether the rate slowed
SPREAD = 6.0  # standard deviations of noise that a noisy plateau is wide
FINEST = 1e-6  # of the largest rate, to which limits come back alike
FAR_FROM_ZERO, FAR_BELOW = 20, 32  # steps: of the top from zero, and of the lowest from the top
MOST = 0.8  # of the samples may be at the limit; what never leaves a value is a steady spin


class _Plateau(NamedTuple):
    """The lower edge and the middle of a plateau [rad/s], its axis and side, and in how many runs it comes."""

    edge: float
    level: float
    axis: int
    side: int
    runs: int


def saturation(logs: Sequence[GyroLog]) -> float | None:
    """Return the size of rates [rad/s] from which samples are at the gyro's limit; None where no limit shows.

    Rounded rates stay at the top of a smooth peak too, and the higher the clock's rate the longer. A limit is told from
    that by how few samples lie just below it, by no axis going beyond, and by coming on both sides of zero, on two
    axes, again and again, or at a range that gyros are sold with.

    Args:
        logs: from ``clean_log``, of one gyro.
    """
    limits = [edge for log in logs if (edge := _limit(log.rates)) is not None]
    return min(limits, default=None)


def _limit(rates: Float64[Array, "n 3"]) -> float | None:
    shown = rates[np.concatenate([[True], (np.diff(rates, axis=0) != 0.0).any(axis=1)])]  # not what a clock repeats
    if len(shown) < 2 * FEWEST:
        return None
    largest = float(np.partition(np.abs(shown), -FEWEST, axis=0)[-FEWEST].max())  # a spike or two may be higher
    plateaus = [each for each in _plateaus(shown) if each.level > (1 - BEYOND) * largest]
    edges = [one.edge for one in plateaus if _is_known(one.level) or one.runs > 1 or _has_twin(one, plateaus)]
    return min(edges, default=None)


def _is_known(level: float) -> bool:
    return bool((np.abs(level / KNOWN - 1) < OFF_RANGE).any())


def _has_twin(one: _Plateau, others: list[_Plateau]) -> bool:
    return any((other.axis, other.side) != (one.axis, one.side) for other in others)


def _plateaus(rates: Float64[Array, "n 3"]) -> Iterator[_Plateau]:
    steps, noises = np.transpose([_step_and_noise(column) for column in rates.T])
    for axis, noise in enumerate(noises.tolist()):
        step = max(float(min(steps[steps > 0], default=0.0)), FINEST * float(np.abs(rates[:, axis]).max()))
        for side in (1, -1):
            values = side * rates[:, axis]
            top = float(np.partition(values, -FEWEST)[-FEWEST])  # a spike or two may be higher
            for level, unit in ((top, step), (top - 0.5 * SPREAD * noise, SPREAD * noise)):
                if unit > 0 and level > FAR_FROM_ZERO * unit and (runs := _flat_runs(values, level, unit)):
                    yield _Plateau(top if unit == step else level - unit / 2, level, axis, side, runs)
                    break


def _step_and_noise(values: Float64[Array, "n"]) -> tuple[float, float]:
    """Return the step to which values are rounded, or how near the nearest come, and their noise."""
    apart = np.diff(np.unique(np.asarray(values, dtype=np.float64)))
    third = np.abs(np.diff(values, n=3))
    return (float(np.quantile(apart, 0.05)) if len(apart) else 0.0), float(np.median(third) / (0.6745 * np.sqrt(20.0)))


def _flat_runs(values: Float64[Array, "n"], top: float, unit: float) -> int:
    """Return how often values stay within half a unit of the top, 0 unless they reach it without slowing down."""
    depth = (top - values) / unit
    at_top = np.abs(depth) < 0.5 + 1e-6
    count = int(at_top.sum())
    near, far = (int(((depth < steps) & ~at_top & (depth > 0)).sum()) for steps in (4.5, 16.5))
    if count < FEWEST or near > (PEAKED - 1.0) * count:
        return 0
    edges = np.diff(np.concatenate([[False], depth < 16.5, [False]]).astype(np.int8))
    totals = np.concatenate([[0], np.cumsum(at_top)])
    visits = int((totals[np.flatnonzero(edges == -1)] - totals[np.flatnonzero(edges == 1)] >= FEWEST).sum())
    if _is_known(top) and np.ptp(values[at_top]) <= FINEST * top:
        return max(visits, 1)  # a throw may be at the limit from its beginning to its end
    slowed = far < SLOWED * near and far > SLOW_EDGE * 2 * max(visits, 1)
    return 0 if depth.max() < FAR_BELOW or count > MOST * len(values) or slowed else visits
