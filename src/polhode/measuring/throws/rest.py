"""Where in a log the device lies still, so that its gyro shows its bias alone."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
from scipy.ndimage import maximum_filter1d, minimum_filter1d, uniform_filter1d

from polhode._base.arrays import known_numbers_only
from polhode.measuring.throws.gyro_log import GyroLog
from polhode.types import Array, Bool, Float64

SHORTEST = 0.3  # s
MEAN_OVER = 0.1  # s: means over it keep the noise small and show a hand's tremor
WANDER = 0.015  # rad/s, by which means over MEAN_OVER may differ within a stretch; hands shake by several times as much
LARGEST_BIAS = 0.35  # rad/s, its length: what one stretch may show alone
LARGEST_OF_AN_AXIS = 0.6  # rad/s: cheap gyros are sold with 20 deg/s on each axis; so slow may a body turn too
HANDLED = 1.0  # rad/s, by which the rates leave the bias between two rests
BIASES_APART = 0.03  # rad/s: the bias of one log warms up by less
GRAVITY = (8.8, 10.8)  # m/s², as accelerometers that are a few percent off feel it
TILT = 0.3  # m/s², by which what is felt may change within SHORTEST: a turn of 0.1 rad/s


@known_numbers_only
def rest_stretches(log: GyroLog) -> list[tuple[float, float]]:
    """Return the start and end [s] of the stretches in which the device lies still, in the order of time.

    The device is still where means of the rates over a tenth of a second differ by no more than noise explains, and are
    near zero and near those of the longest stretch; an accelerometer must feel a constant weight too. The mean of the
    rates within is the gyro's bias. Neither a hand nor a flight is so still. A body may turn slowly and steadily,
    though: a bias above 0.35 rad/s needs the accelerometer, or two rests that show the same before and after a motion.

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
    wander = WANDER + 0.5 * _step_between_values(rates)
    still = _steady(means, size, wander) & _without_gaps(t, size)
    felt, clock = log.acceleration, log.acceleration_times
    weighed = felt is not None
    if felt is not None and clock is not None:
        still &= _weight_is_constant(clock, felt, t)
    stretches = _alike(_stretches(still & (np.linalg.norm(means, axis=1) < LARGEST_BIAS), t), t, rates)
    if not stretches:
        stretches = _alike(_stretches(still & (np.abs(means) < LARGEST_OF_AN_AXIS).all(axis=1), t), t, rates)
        stretches = stretches if weighed or _is_handled_between(stretches, rates) else []
    return [(float(t[i]), float(t[j])) for i, j in stretches]


def _alike(stretches: list[tuple[int, int]], t: Array, rates: Array) -> list[tuple[int, int]]:
    """Return the stretches whose mean is near that of the longest."""
    if not stretches:
        return []
    means = [rates[i : j + 1].mean(axis=0) for i, j in stretches]
    bias = means[int(np.argmax([t[j] - t[i] for i, j in stretches]))]
    return [each for each, mean in zip(stretches, means, strict=True) if np.linalg.norm(mean - bias) < BIASES_APART]


def _is_handled_between(stretches: list[tuple[int, int]], rates: Array) -> bool:
    """Whether the device was moved between two of the stretches, and shows the same rates before and after."""
    if len(stretches) < 2:
        return False
    bias = rates[stretches[0][0] : stretches[0][1] + 1].mean(axis=0)
    gaps = [rates[one[1] : two[0]] for one, two in pairwise(stretches)]
    return any(len(gap) > 0 and np.linalg.norm(gap - bias, axis=1).max() > HANDLED for gap in gaps)


def _means(t: Array, values: Array) -> tuple[Array, int]:
    """Return means over MEAN_OVER, and over how many samples SHORTEST is."""
    step = float(np.median(np.diff(t)))
    return (uniform_filter1d(values, max(1, round(MEAN_OVER / step)), axis=0, mode="nearest"),
            max(2, round(SHORTEST / step)))  # fmt: skip


def _step_between_values(rates: Array) -> float:
    """Return the usual step between the values that a gyro rounds to [rad/s]; zero where it hardly rounds."""
    values = np.unique(np.round(rates[:20_000], 9))  # of a long log its beginning says it
    return float(np.median(np.diff(values))) if len(values) > 1 else 0.0


def _steady(means: Array, size: int, wander: float) -> Bool[Array, "n"]:
    """Return which samples belong to a stretch of so many in which no component wanders."""
    span = maximum_filter1d(means, size, axis=0) - minimum_filter1d(means, size, axis=0)
    whole = np.asarray((span < wander).all(axis=1))
    whole[: size // 2] = whole[len(whole) - (size - 1) // 2 :] = False  # stretches that reach beyond the log
    return maximum_filter1d(whole, size, origin=-1 if size % 2 == 0 else 0)


def _without_gaps(t: Float64[Array, "n"], size: int) -> Bool[Array, "n"]:
    """Return which samples have neighbours within SHORTEST."""
    steps = np.diff(t, prepend=t[0], append=t[-1])
    return (steps[:-1] < SHORTEST) & (steps[1:] < SHORTEST)


def _weight_is_constant(clock: Array, felt: Array, t: Array) -> Bool[Array, "n"]:
    if len(clock) < 2:
        return np.zeros(len(t), dtype=bool)
    means, size = _means(clock, felt)
    weight = np.linalg.norm(means, axis=1)
    calm = _steady(means, size, TILT) & (weight > GRAVITY[0]) & (weight < GRAVITY[1])
    return np.interp(t, clock, calm.astype(float), 0.0, 0.0) > 0.5


def _stretches(still: Bool[Array, "n"], t: Float64[Array, "n"]) -> list[tuple[int, int]]:
    """Return the first and last sample of each long enough run, whose ends a mean has spread over are cut off."""
    edges = np.flatnonzero(np.diff(np.concatenate([[False], still, [False]]).astype(np.int8)))
    stretches = []
    for first, behind in zip(edges[::2].tolist(), edges[1::2].tolist(), strict=True):
        start = first if first == 0 else int(np.searchsorted(t, t[first] + MEAN_OVER / 2))
        last = behind - 1 if behind == len(t) else int(np.searchsorted(t, t[behind - 1] - MEAN_OVER / 2, "right")) - 1
        if last > start and t[last] - t[start] >= SHORTEST - MEAN_OVER:
            stretches.append((start, last))
    return stretches
