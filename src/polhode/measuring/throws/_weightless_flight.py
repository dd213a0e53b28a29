"""Free flights by the accelerometer, which then feels only its rotation about the centre of mass."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from polhode.measuring.throws.gyro_log import GyroLog
from polhode.types import Array, Float64

SPAN = 0.3  # s, over which a stretch is judged
LEVER_ARM = 0.05  # m, how far from the centre of mass an accelerometer is expected to sit
LONGEST_ARM = 0.35  # m
FELT = 3.0  # m/s², what a free accelerometer may feel beyond its own turning; one that is held feels 9.8
LEAST_FELT, OWN_FELT = 1.0, 4.0  # m/s², and times what is usual in the stretch: more at its ends is a hand
GAP = 0.02  # s, of a spike
AT_ONCE = 50_000  # samples


class Weightless(NamedTuple):
    """First and last sample of the accelerometer, and what it feels beyond its turning, root mean square [m/s²]."""

    first: int
    last: int
    felt: float


def weightless_stretches(log: GyroLog, shortest: float) -> list[Weightless]:
    """Return the stretches without weight, in the order of time.

    In flight an accelerometer at place r feels ω × (ω × r) + ω̇ × r. One r is fitted for the whole log, within what a
    hand-held device has.

    Args:
        log: with accelerations.
        shortest: of a stretch [s].
    """
    t, felt = log.acceleration_times, log.acceleration
    assert t is not None and felt is not None
    step = float(np.median(np.diff(t))) if len(t) > 1 else SPAN
    size = max(3, round(SPAN / step))
    place = _place(log, t, felt, size) if len(t) >= size else None
    if place is None:
        return []
    beyond = np.concatenate([np.linalg.norm(felt[part] - lever @ place, axis=1)
                             for part, lever in _levers(log, t, 0)])  # fmt: skip
    inside = (t >= log.times[0]) & (t <= log.times[-1])
    stretches = []
    for first, last in _runs((beyond < FELT) & inside, max(2, round(GAP / step))):
        limit = max(LEAST_FELT, OWN_FELT * float(np.median(beyond[first : last + 1])))
        calm = np.flatnonzero(beyond[first : last + 1] < limit)
        first, last = first + int(calm[0]), first + int(calm[-1])
        if t[last] - t[first] >= shortest:
            rms = float(np.sqrt(np.mean(beyond[first : last + 1] ** 2)))
            stretches.append(Weightless(first, last, rms))
    return stretches


def _levers(log: GyroLog, t: Array, overlap: int) -> Iterator[tuple[slice, Array]]:
    """Yield parts of the log, and the maps (n, 3, 3) from a place to what an accelerometer there feels of turning."""
    for begin in range(0, max(len(t) - overlap, 1), AT_ONCE):
        part = slice(begin, min(begin + AT_ONCE + overlap, len(t)))
        rates, turning = _rates_at(log, t[part])
        yield part, np.stack(
            [np.cross(rates, np.cross(rates, e)) + np.cross(turning, e) for e in np.eye(3)], axis=-1
        )


def _place(log: GyroLog, t: Array, felt: Array, size: int) -> Float64[Array, "3"] | None:
    """Return the place of the accelerometer that explains a calm span best; None where no span is calm."""
    stride = max(1, size // 8)
    candidates: list[Array] = []
    for part, lever in _levers(log, t, size):
        n = part.stop - part.start
        if n < size:
            continue
        begins = np.arange(0, n - size + 1, stride)
        inside = (t[part][begins] >= log.times[0]) & (t[part][begins + size - 1] <= log.times[-1])
        mean = lambda x, begins=begins: _means(x, begins, size)  # noqa: E731
        # least squares of f = L r; a small penalty on r holds it where the turning does not tell it
        normal = mean(np.matmul(np.swapaxes(lever, 1, 2), lever)) + 1e-3 / LEVER_ARM**2 * np.eye(3)
        right = mean(np.einsum("nij,ni->nj", lever, felt[part]))
        place = np.linalg.solve(normal, right[..., None])[..., 0]
        # at the minimum, where N r = b, the mean of |f − L r|² and the penalty together are ⟨f²⟩ − r·b
        left = mean((felt[part] ** 2).sum(axis=1)) - (place * right).sum(axis=1)
        calm = inside & (left < FELT**2) & (np.linalg.norm(place, axis=1) < LONGEST_ARM)
        candidates.append(np.column_stack([np.linalg.det(normal), left, place])[calm])
    spans = np.concatenate(candidates) if candidates else np.empty((0, 5))
    if not len(spans):
        return None
    telling = spans[spans[:, 0] >= 0.1 * spans[:, 0].max()]  # of those whose turning tells enough of it
    return telling[np.argmin(telling[:, 1]), 2:]


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
