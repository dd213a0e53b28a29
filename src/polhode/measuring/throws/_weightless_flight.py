"""Free flights by the accelerometer, which then measures only its rotation about the centre of mass."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from polhode.measuring.throws.gyro_log import GyroLog
from polhode.types import Array, Float64


class WeightlessThresholds(NamedTuple):
    """Numbers that decide where an accelerometer is weightless.

    Attributes:
        span: s, over which a stretch is judged.
        max_lever_arm: m, of an accelerometer from the centre of mass of a hand-held device.
        max_acceleration: m/s², of a free accelerometer beyond its own rotation; one at rest measures 9.8.
        min_hand_acceleration: m/s²; at the ends of a stretch a hand causes more.
        max_acceleration_ratio: to the median of the stretch; more at its ends is a hand's.
        max_spike: s; longer disturbances end a stretch.
        min_information: of the largest determinant; spans with less determine the lever arm badly.
    """

    span: float = 0.3
    max_lever_arm: float = 0.35
    max_acceleration: float = 3.0
    min_hand_acceleration: float = 1.0
    max_acceleration_ratio: float = 4.0
    max_spike: float = 0.02
    min_information: float = 0.1


LIMITS = WeightlessThresholds()


class Weightless(NamedTuple):
    """First and last sample of a stretch, and the acceleration not due to rotation, root mean square [m/s²]."""

    first: int
    last: int
    felt: float


def weightless_stretches(log: GyroLog, shortest: float) -> list[Weightless]:
    """Return the stretches without weight, in the order of time.

    A free accelerometer at place r measures ω × (ω × r) + ω̇ × r. One r is fitted to the whole log, no longer than in
    a hand-held device.

    Args:
        log: with accelerations.
        shortest: of a stretch [s].
    """
    t, felt = log.acceleration_times, log.acceleration
    assert t is not None and felt is not None
    step = float(np.median(np.diff(t))) if len(t) > 1 else LIMITS.span
    size = max(3, round(LIMITS.span / step))
    place = _place(log, t, felt, size) if len(t) >= size else None
    if place is None:
        return []
    beyond = np.concatenate([np.linalg.norm(felt[part] - lever @ place, axis=1)
                             for part, lever in _levers(log, t, 0)])
    inside = (t >= log.times[0]) & (t <= log.times[-1])
    stretches = []
    for first, last in _runs((beyond < LIMITS.max_acceleration) & inside, max(2, round(LIMITS.max_spike / step))):
        usual = float(np.median(beyond[first : last + 1]))
        limit = max(LIMITS.min_hand_acceleration, LIMITS.max_acceleration_ratio * usual)
        calm = np.flatnonzero(beyond[first : last + 1] < limit)
        first, last = first + int(calm[0]), first + int(calm[-1])
        if t[last] - t[first] >= shortest:
            rms = float(np.sqrt(np.mean(beyond[first : last + 1] ** 2)))
            stretches.append(Weightless(first, last, rms))
    return stretches


def _levers(log: GyroLog, t: Array, overlap: int) -> Iterator[tuple[slice, Array]]:
    """Yield parts of the log, and the maps (n, 3, 3) from a place to the acceleration there by rotation."""
    batch = 50_000  # samples whose maps are in memory together
    for begin in range(0, max(len(t) - overlap, 1), batch):
        part = slice(begin, min(begin + batch + overlap, len(t)))
        rates, turning = _rates_at(log, t[part])
        yield part, np.stack(
            [np.cross(rates, np.cross(rates, e)) + np.cross(turning, e) for e in np.eye(3)], axis=-1
        )


def _place(log: GyroLog, t: Array, felt: Array, size: int) -> Float64[Array, "3"] | None:
    """Return the place of the accelerometer that explains a calm span best; None where no span is calm."""
    stride, typical_arm = max(1, size // 8), 0.05  # m
    candidates: list[Array] = []
    for part, lever in _levers(log, t, size):
        n = part.stop - part.start
        if n < size:
            continue
        begins = np.arange(0, n - size + 1, stride)
        inside = (t[part][begins] >= log.times[0]) & (t[part][begins + size - 1] <= log.times[-1])
        mean = lambda x, begins=begins: _means(x, begins, size)  # noqa: E731
        # least squares of f = L r; a small penalty bounds r where rotation does not determine it
        normal = mean(np.matmul(np.swapaxes(lever, 1, 2), lever)) + 1e-3 / typical_arm**2 * np.eye(3)
        right = mean(np.einsum("nij,ni->nj", lever, felt[part]))
        place = np.linalg.solve(normal, right[..., None])[..., 0]
        # at the minimum, where N r = b, the mean of |f − L r|² and the penalty together are ⟨f²⟩ − r·b
        left = mean((felt[part] ** 2).sum(axis=1)) - (place * right).sum(axis=1)
        calm = inside & (left < LIMITS.max_acceleration**2) & (np.linalg.norm(place, axis=1) < LIMITS.max_lever_arm)
        candidates.append(np.column_stack([np.linalg.det(normal), left, place])[calm])
    spans = np.concatenate(candidates) if candidates else np.empty((0, 5))
    if not len(spans):
        return None
    informative = spans[spans[:, 0] >= LIMITS.min_information * spans[:, 0].max()]
    return informative[np.argmin(informative[:, 1]), 2:]


def _means(x: Array, begins: Array, size: int) -> Array:
    total = np.zeros((len(x) + 1, *x.shape[1:]))
    np.cumsum(x, axis=0, out=total[1:])
    return (total[begins + size] - total[begins]) / size


def _rates_at(log: GyroLog, t: Array) -> tuple[Array, Array]:
    """Return the gyro's rates and their slopes at the accelerometer's times."""
    low, high = np.searchsorted(log.times, [t[0], t[-1]])
    near = slice(max(int(low) - 2, 0), min(int(high) + 3, len(log.times)))
    if near.stop - near.start < 2:
        near = slice(max(near.stop - 2, 0), max(near.stop, 2))
    times, rates = log.times[near], log.rates[near]
    both = np.concatenate([rates, np.gradient(rates, times, axis=0)], axis=1)
    at = np.stack([np.interp(t, times, column) for column in both.T], axis=1)
    return at[:, :3], at[:, 3:]


def _runs(flags: Array, gap: int) -> list[tuple[int, int]]:
    """Return the first and last index of each run of true flags, over gaps of so many false ones."""
    edges = np.flatnonzero(np.diff(np.concatenate([[False], flags, [False]]).astype(np.int8)))
    runs: list[tuple[int, int]] = []
    for first, behind in zip(edges[::2].tolist(), edges[1::2].tolist(), strict=True):
        if runs and first - runs[-1][1] - 1 <= gap:
            runs[-1] = (runs[-1][0], behind - 1)
        else:
            runs.append((first, behind - 1))
    return runs
