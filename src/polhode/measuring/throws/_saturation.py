"""Finds the limit of a gyro: a plateau at the end of its range, which rates reach without slowing down."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np

from polhode.measuring.throws.gyro_log import GyroLog
from polhode.types import Array, Float64

KNOWN = np.radians([125.0, 245.0, 250.0, 500.0, 1000.0, 2000.0, 4000.0,
                    143.4, 286.7, 573.4, 1146.9, 2293.8, 4587.5])  # fmt: skip
"""Ranges that gyros are sold with [rad/s]; those below are 32768 counts of 4.375, 8.75, 17.5, 35, 70 and 140 mdeg/s."""


class SaturationThresholds(NamedTuple):
    """Numbers that decide whether a plateau is the limit of a gyro.

    Attributes:
        min_plateau: samples of a plateau.
        range_tolerance: of a known range, by which rounding and scale may move it.
        axis_tolerance: of the largest rate; all axes share a limit, up to their gains.
        max_peak_ratio: of samples down to 4 steps below the top and those at the top; smooth peaks have 2.2 or more.
        min_ramp_ratio: of samples down to 16 steps and those down to 4, without the top: 4 for a ramp, 2.5 for a smooth
            peak, 1.6 for a rate that creeps to its end, as in a turn about the middle axis.
        min_edge: samples down to 16 steps at each edge; fewer do not show whether the rate slows down.
        noise_width: standard deviations of noise, the width of a noisy plateau.
        relative_rounding: of the largest rate, within which equal limits return.
        min_steps_above_zero: of the top.
        min_depth: steps between the lowest rate and the top.
        near_steps, far_steps: depths below the top at which samples are counted, between two steps.
        max_share: of the samples at the limit; a rate that never leaves a value is that of a steady spin.
    """

    min_plateau: int = 3
    range_tolerance: float = 0.0012
    axis_tolerance: float = 0.03
    max_peak_ratio: float = 1.5
    min_ramp_ratio: float = 3.0
    min_edge: int = 3
    noise_width: float = 6.0
    relative_rounding: float = 1e-6
    min_steps_above_zero: int = 20
    min_depth: int = 32
    near_steps: float = 4.5
    far_steps: float = 16.5
    max_share: float = 0.8


LIMITS = SaturationThresholds()


class _Plateau(NamedTuple):
    """The lower edge and the middle of a plateau [rad/s], its axis and sign, and its number of visits."""

    edge: float
    level: float
    axis: int
    side: int
    visits: int


def saturation(logs: Sequence[GyroLog]) -> float | None:
    """Return the size of rates [rad/s] from which samples are at the gyro's limit; None where no limit shows.

    Rounded rates stay at the top of a smooth peak too, the longer the higher the clock's rate. A limit differs in that
    few samples lie just below it and no axis exceeds it, and in that it returns: on both sides of zero, on two axes,
    again and again, or at a range that gyros are sold with.

    Args:
        logs: from ``clean_log``, of one gyro.
    """
    limits = [edge for log in logs if (edge := _limit(log.rates)) is not None]
    return min(limits, default=None)


def _limit(rates: Float64[Array, "n 3"]) -> float | None:
    # a fast clock repeats samples
    shown = rates[np.concatenate([[True], (np.diff(rates, axis=0) != 0.0).any(axis=1)])]
    if len(shown) < 2 * LIMITS.min_plateau:
        return None
    kth = -LIMITS.min_plateau  # a spike or two may be higher
    largest = float(np.partition(np.abs(shown), kth, axis=0)[kth].max())
    plateaus = [each for each in _plateaus(shown) if each.level > (1 - LIMITS.axis_tolerance) * largest]
    edges = [one.edge for one in plateaus if _is_known(one.level) or one.visits > 1 or _has_twin(one, plateaus)]
    return min(edges, default=None)


def _is_known(level: float) -> bool:
    return bool((np.abs(level / KNOWN - 1) < LIMITS.range_tolerance).any())


def _has_twin(one: _Plateau, others: list[_Plateau]) -> bool:
    return any((other.axis, other.side) != (one.axis, one.side) for other in others)


def _plateaus(rates: Float64[Array, "n 3"]) -> Iterator[_Plateau]:
    steps, noises = np.transpose([_step_and_noise(column) for column in rates.T])
    for axis, noise in enumerate(noises.tolist()):
        finest = LIMITS.relative_rounding * float(np.abs(rates[:, axis]).max())
        step, width = max(float(min(steps[steps > 0], default=0.0)), finest), LIMITS.noise_width * noise
        for side in (1, -1):
            values = side * rates[:, axis]
            top = float(np.partition(values, -LIMITS.min_plateau)[-LIMITS.min_plateau])  # a spike or two may be higher
            for level, unit in ((top, step), (top - 0.5 * LIMITS.noise_width * noise, width)):
                lowest = LIMITS.min_steps_above_zero * unit
                if unit > 0 and level > lowest and (visits := _count_visits(values, level, unit)):
                    yield _Plateau(top if unit == step else level - unit / 2, level, axis, side, visits)
                    break


def _step_and_noise(values: Float64[Array, "n"]) -> tuple[float, float]:
    """Return the step to which values are rounded, else the least distance between them, and their noise."""
    apart = np.diff(np.unique(np.asarray(values, dtype=np.float64)))
    third = np.abs(np.diff(values, n=3))
    return (float(np.quantile(apart, 0.05)) if len(apart) else 0.0), float(np.median(third) / (0.6745 * np.sqrt(20.0)))


def _count_visits(values: Float64[Array, "n"], top: float, unit: float) -> int:
    """Return how often values stay within half a unit of the top, 0 unless they reach it without slowing down."""
    depth = (top - values) / unit
    at_top = np.abs(depth) < 0.5 + 1e-6
    count = int(at_top.sum())
    depths = (LIMITS.near_steps, LIMITS.far_steps)
    near, far = (int(((depth < steps) & ~at_top & (depth > 0)).sum()) for steps in depths)
    if count < LIMITS.min_plateau or near > (LIMITS.max_peak_ratio - 1.0) * count:
        return 0
    edges = np.diff(np.concatenate([[False], depth < LIMITS.far_steps, [False]]).astype(np.int8))
    totals = np.concatenate([[0], np.cumsum(at_top)])
    samples = totals[np.flatnonzero(edges == -1)] - totals[np.flatnonzero(edges == 1)]
    visits = int((samples >= LIMITS.min_plateau).sum())
    if _is_known(top) and np.ptp(values[at_top]) <= LIMITS.relative_rounding * top:
        return max(visits, 1)  # a throw may be at the limit from its beginning to its end
    slowed = far < LIMITS.min_ramp_ratio * near and far > LIMITS.min_edge * 2 * max(visits, 1)
    steady = depth.max() < LIMITS.min_depth or count > LIMITS.max_share * len(values)
    return 0 if steady or slowed else visits
