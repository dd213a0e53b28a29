"""Where in a log the device lies still, so that its gyro shows its bias alone."""

from __future__ import annotations

from itertools import pairwise
from typing import NamedTuple

import numpy as np
from scipy.ndimage import maximum_filter1d, minimum_filter1d, uniform_filter1d

from polhode._base.arrays import known_numbers_only
from polhode.measuring.throws.gyro_log import GyroLog
from polhode.types import Array, Bool, Float64


class RestThresholds(NamedTuple):
    """Numbers that decide where a device is at rest.

    Attributes:
        min_duration: s, of a rest.
        mean_duration: s; means over it have little noise and still show the tremor of a hand.
        max_wander: rad/s, of such means within a rest; hands shake by several times as much.
        max_bias: rad/s, its length, that a single rest shows; a body that rotates slowly may show more.
        max_bias_per_axis: rad/s, with further evidence; cheap gyros are sold with 20 deg/s on each axis.
        min_handling: rad/s, by which the rates leave the bias between two rests when a hand moves the device.
        max_bias_change: rad/s, within a log as the gyro warms up.
        min_gravity, max_gravity: m/s², measured by accelerometers that are a few percent off.
        max_tilt: m/s², change of the acceleration within a rest: a rotation of 0.1 rad/s.
    """

    min_duration: float = 0.3
    mean_duration: float = 0.1
    max_wander: float = 0.015
    max_bias: float = 0.35
    max_bias_per_axis: float = 0.6
    min_handling: float = 1.0
    max_bias_change: float = 0.03
    min_gravity: float = 8.8
    max_gravity: float = 10.8
    max_tilt: float = 0.3


LIMITS = RestThresholds()


@known_numbers_only
def rest_stretches(log: GyroLog) -> list[tuple[float, float]]:
    """Return the start and end [s] of the stretches in which the device lies still, in the order of time.

    The device is still where means of the rates over a tenth of a second differ by no more than noise explains, and are
    near zero and near those of the longest stretch; an accelerometer must measure a constant weight too. The mean of
    the rates within is the gyro's bias. Neither a hand nor a flying body is so still. A body may rotate slowly and
    steadily, though: a bias above 0.35 rad/s needs the accelerometer, or two rests with equal rates before and after a
    motion.

    Args:
        log: from ``clean_log``.

    Example:
        >>> import numpy as np
        >>> from polhode.measuring import clean_log
        >>> t = np.arange(0, 3, 0.01)
        >>> rates = np.where(t > 1, 9 * np.cos(5 * t), 0.002)[:, None] * [0.0, 1.0, 1.0]
        >>> [(start, end)] = rest_stretches(clean_log(t, rates))
        >>> bool(start == 0.0 and 0.85 < end < 1.0)
        True
    """
    t, rates = log.times, log.rates
    means, size = _means(t, rates)
    wander = LIMITS.max_wander + 0.5 * _step_between_values(rates)
    still = _steady(means, size, wander) & _without_gaps(t, size)
    felt, clock = log.acceleration, log.acceleration_times
    weighed = felt is not None
    if felt is not None and clock is not None:
        still &= _weight_is_constant(clock, felt, t)
    stretches = _alike(_stretches(still & (np.linalg.norm(means, axis=1) < LIMITS.max_bias), t), t, rates)
    if not stretches:
        slow = (np.abs(means) < LIMITS.max_bias_per_axis).all(axis=1)
        stretches = _alike(_stretches(still & slow, t), t, rates)
        stretches = stretches if weighed or _is_handled_between(stretches, rates) else []
    return [(float(t[i]), float(t[j])) for i, j in stretches]


def _alike(stretches: list[tuple[int, int]], t: Array, rates: Array) -> list[tuple[int, int]]:
    """Return the stretches whose mean is near that of the longest."""
    if not stretches:
        return []
    means = [rates[i : j + 1].mean(axis=0) for i, j in stretches]
    bias = means[int(np.argmax([t[j] - t[i] for i, j in stretches]))]
    apart = [np.linalg.norm(mean - bias) for mean in means]
    return [each for each, change in zip(stretches, apart, strict=True) if change < LIMITS.max_bias_change]


def _is_handled_between(stretches: list[tuple[int, int]], rates: Array) -> bool:
    """Whether the device was moved between two of the stretches, which have equal rates."""
    if len(stretches) < 2:
        return False
    bias = rates[stretches[0][0] : stretches[0][1] + 1].mean(axis=0)
    gaps = [rates[one[1] : two[0]] for one, two in pairwise(stretches)]
    return any(len(gap) > 0 and np.linalg.norm(gap - bias, axis=1).max() > LIMITS.min_handling for gap in gaps)


def _means(t: Array, values: Array) -> tuple[Array, int]:
    """Return running means, and the number of samples of the shortest rest."""
    step = float(np.median(np.diff(t)))
    return (uniform_filter1d(values, max(1, round(LIMITS.mean_duration / step)), axis=0, mode="nearest"),
            max(2, round(LIMITS.min_duration / step)))  # fmt: skip


def _step_between_values(rates: Array) -> float:
    """Return the usual step between the values of a rounding gyro [rad/s]; zero where it hardly rounds."""
    values = np.unique(np.round(rates[:20_000], 9))  # the beginning of a long log suffices
    return float(np.median(np.diff(values))) if len(values) > 1 else 0.0


def _steady(means: Array, size: int, wander: float) -> Bool[Array, "n"]:
    """Return which samples belong to a stretch of so many in which no component wanders."""
    span = maximum_filter1d(means, size, axis=0) - minimum_filter1d(means, size, axis=0)
    whole = np.asarray((span < wander).all(axis=1))
    whole[: size // 2] = whole[len(whole) - (size - 1) // 2 :] = False  # stretches that reach beyond the log
    return maximum_filter1d(whole, size, origin=-1 if size % 2 == 0 else 0)


def _without_gaps(t: Float64[Array, "n"], size: int) -> Bool[Array, "n"]:
    """Return the samples with neighbours within the duration of the shortest rest."""
    steps = np.diff(t, prepend=t[0], append=t[-1])
    return (steps[:-1] < LIMITS.min_duration) & (steps[1:] < LIMITS.min_duration)


def _weight_is_constant(clock: Array, felt: Array, t: Array) -> Bool[Array, "n"]:
    if len(clock) < 2:
        return np.zeros(len(t), dtype=bool)
    means, size = _means(clock, felt)
    weight = np.linalg.norm(means, axis=1)
    calm = _steady(means, size, LIMITS.max_tilt) & (weight > LIMITS.min_gravity) & (weight < LIMITS.max_gravity)
    return np.interp(t, clock, calm.astype(float), 0.0, 0.0) > 0.5


def _stretches(still: Bool[Array, "n"], t: Float64[Array, "n"]) -> list[tuple[int, int]]:
    """Return the first and last sample of each long enough run, without the ends that running means blur."""
    edges = np.flatnonzero(np.diff(np.concatenate([[False], still, [False]]).astype(np.int8)))
    blur = LIMITS.mean_duration / 2
    stretches = []
    for first, behind in zip(edges[::2].tolist(), edges[1::2].tolist(), strict=True):
        start = first if first == 0 else int(np.searchsorted(t, t[first] + blur))
        last = behind - 1 if behind == len(t) else int(np.searchsorted(t, t[behind - 1] - blur, "right")) - 1
        if last > start and t[last] - t[start] >= LIMITS.min_duration - LIMITS.mean_duration:
            stretches.append((start, last))
    return stretches
