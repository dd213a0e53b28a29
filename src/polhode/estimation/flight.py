"""Where in a log a body flies freely: by its accelerometer, or by what keeps the angular momentum."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.ndimage import binary_closing, binary_opening, uniform_filter1d

from polhode.arrays import known_numbers_only
from polhode.errors import InvalidInput, shown
from polhode.estimation.gyro_log import GyroLog
from polhode.estimation.linear_start import OFF_DIAGONAL, ROOT, momentum_map, turned_by
from polhode.types import Array

SHORTEST = 0.25  # s
SPAN = 0.3  # s, over which a stretch is judged
LEVER_ARM = 0.05  # m, how far from the centre of mass an accelerometer is expected to sit
FELT = 3.0  # m/s², what a free accelerometer may feel beyond its own turning; one that is held feels 9.8
UNEVEN = 0.03  # change of angular momentum relative to its size, within SPAN
TORQUE = 1.0  # 1/s, of the angular momentum; hands give several, drag and a gyro's bias some tenths
TURN = 2.0  # rad, of which a span holds at least so much
MOST_SPANS = 40
SLOWEST = 1.0  # rad/s: slower turning says nothing of inertia


@dataclass(frozen=True)
class Window:
    """A stretch of a log.

    Attributes:
        start: [s].
        end: [s], included.
        reason: how it was found.
        score: of the accelerometer, rms of what it feels beyond its turning [m/s²]; of the gyro, change of angular
            momentum relative to its size; the smaller, the better; 0 where the window was given.
    """

    start: float
    end: float
    reason: str = "given"
    score: float = 0.0


@known_numbers_only
def free_flights(log: GyroLog) -> list[Window]:
    """Return the stretches of free flight, in the order of time; none where there are none.

    In flight an accelerometer at place r feels ω × (ω × r) + ω̇ × r alone. The lever arm r is fitted, within what a
    hand-held device has, over the spans of a few tenths of a second, and gravity's absence is what is looked for. A log
    without accelerometer gives the longest stretch over which some inertia J keeps R J ω, R from the gyro itself.

    Args:
        log: from ``clean_log``.

    Example:
        >>> import numpy as np
        >>> from polhode.estimation import clean_log
        >>> t = np.arange(0, 2, 0.01)
        >>> felt = np.where(abs(t - 1) < 0.4, 0.0, 9.8)[:, None] * [0.0, 0.0, 1.0]
        >>> [found] = free_flights(clean_log(t, np.ones((200, 3)), t, felt))
        >>> bool(abs(found.start - 0.6) < 0.03 and abs(found.end - 1.4) < 0.03)
        True
    """
    if log.acceleration is None or log.acceleration_times is None:
        return _longest_stretch(log)
    t, felt = log.acceleration_times, log.acceleration
    size = _samples_of(t, SPAN)
    if len(t) < size:
        return []
    rates, turning = _rates_at(log, t)
    eye = np.eye(3)
    lever = np.stack([np.cross(rates, np.cross(rates, e)) + np.cross(turning, e) for e in eye], axis=-1)
    inside = (t >= log.times[0]) & (t <= log.times[-1])
    sums = lambda x: uniform_filter1d(x, size, axis=0, mode="nearest")  # noqa: E731
    normal = sums(np.matmul(np.swapaxes(lever, 1, 2), lever)) + 1e-3 / LEVER_ARM**2 * eye
    right = sums(np.einsum("nij,ni->nj", lever, felt))
    place = np.linalg.solve(normal, right[..., None])[..., 0]
    left = sums((felt * felt).sum(axis=1)) - (place * right).sum(axis=1)
    calm = inside & (left < FELT**2) & (np.linalg.norm(place, axis=1) < 4 * LEVER_ARM)
    if not calm.any():
        return []
    # one place serves the whole log: that which explains a calm span best, of those whose turning tells enough of it
    known = np.linalg.det(normal)
    telling = calm & (known >= 0.1 * known[calm].max())
    beyond = np.linalg.norm(felt - lever @ place[np.argmin(np.where(telling, left, np.inf))], axis=1)
    free = binary_closing((beyond < FELT) & inside, np.ones(3))
    free = binary_opening(free, np.ones(max(3, _samples_of(t, SHORTEST) - 1)))
    return [
        Window(float(t[i]), float(t[j]), "the accelerometer feels no weight", float(np.sqrt(np.mean(beyond[i:j] ** 2))))
        for i, j in _runs(free)
        if t[j] - t[i] >= SHORTEST
    ]


def check_windows(windows: list[Window], log: GyroLog) -> None:
    """Raise InvalidInput unless every window has a beginning before its end, and samples."""
    for window in windows:
        inside = int(((log.times >= window.start) & (log.times <= window.end)).sum())
        if not window.start < window.end or inside < 8:
            raise InvalidInput(
                f"a window must start before its end and hold at least 8 samples of the log, which goes from "
                f"{log.times[0]:g} s to {log.times[-1]:g} s; got {shown((window.start, window.end))} with {inside}."
            )


def _samples_of(t: Array, span: float) -> int:
    return max(3, round(span / float(np.median(np.diff(t))))) if len(t) > 1 else 3


def _rates_at(log: GyroLog, t: Array) -> tuple[Array, Array]:
    """Return the gyro's rates and their slopes at the accelerometer's times."""
    slopes = np.gradient(log.rates, log.times, axis=0)
    both = np.concatenate([log.rates, slopes], axis=1)
    at = np.stack([np.interp(t, log.times, column) for column in both.T], axis=1)
    return at[:, :3], at[:, 3:]


def _longest_stretch(log: GyroLog) -> list[Window]:
    """Return the longest stretch over which one inertia, that of some span within it, keeps R J ω."""
    t, speeds = log.times, np.linalg.norm(log.rates, axis=1)
    fast = max(float(np.quantile(speeds, 0.9)), SLOWEST)
    size = min(_samples_of(t, max(SPAN, TURN / fast)), max(6, len(t) // 2))
    maps = momentum_map(turned_by(t, log.rates), log.rates)
    inertias, change = _kept_by_spans(maps, size)
    slow = uniform_filter1d(speeds, size)[size // 2 :][: len(change)] < SLOWEST
    change = np.where(slow | ~_possible(inertias), np.inf, change)
    hops = max(2, _samples_of(t, 0.07))
    found: list[tuple[float, int, int]] = []
    # the hand can keep a momentum for a moment too, by an inertia of no use elsewhere: several spans are asked
    for part in np.array_split(np.arange(len(change)), max(1, min(MOST_SPANS, len(change) // size))):
        best = part[np.argmin(change[part])]
        if change[best] > UNEVEN:
            continue
        along = maps @ inertias[best]
        torque = np.linalg.norm(along[hops:] - along[:-hops], axis=1) / (t[hops:] - t[:-hops])
        momentum = np.maximum(np.linalg.norm(along, axis=1), 1e-12)
        quiet = torque / np.minimum(momentum[hops:], momentum[:-hops]) < TORQUE
        good = np.zeros(len(t), dtype=bool)
        for i in np.flatnonzero(binary_opening(quiet, np.ones(hops + 1))):
            good[i : i + hops + 1] = True
        good &= uniform_filter1d(speeds, hops) > SLOWEST
        found += [(float(t[j] - t[i]), i, j) for i, j in _runs(good) if t[j] - t[i] >= SHORTEST]
    if not found:
        return []
    _, i, j = max(found)
    inside = change[i : max(j - size + 1, i + 1)]
    score = float(np.median(inside[np.isfinite(inside)])) if np.isfinite(inside).any() else UNEVEN
    return [Window(float(t[i]), float(t[j]), "the longest stretch that keeps an angular momentum", score)]


def _kept_by_spans(maps: Array, size: int) -> tuple[Array, Array]:
    """Return the inertia (6,) that each span of samples keeps best, and the momentum's change relative to its size."""
    total = np.zeros((len(maps) + 1, 3, 6))
    squares = np.zeros((len(maps) + 1, 6, 6))
    total[1:] = np.cumsum(maps, axis=0)
    squares[1:] = np.cumsum(np.matmul(np.swapaxes(maps, 1, 2), maps), axis=0)
    mean = (total[size:] - total[:-size]) / size
    spread = (squares[size:] - squares[:-size]) / size - np.matmul(np.swapaxes(mean, 1, 2), mean)
    values, vectors = np.linalg.eigh(spread)
    inertias = vectors[:, :, 0]
    momentum = np.linalg.norm(mean @ inertias[..., None], axis=(1, 2))
    return inertias, np.sqrt(np.maximum(values[:, 0], 0.0)) / np.maximum(momentum, 1e-12)


def _possible(inertias: Array) -> Array:
    """Return which inertias some body nearly has, as far as a biased gyro tells."""
    J = np.zeros((len(inertias), 3, 3))
    J[:, [0, 1, 2], [0, 1, 2]] = inertias[:, :3]
    for k, (i, j) in enumerate(OFF_DIAGONAL, start=3):
        J[:, i, j] = J[:, j, i] = inertias[:, k] / ROOT
    moments = np.linalg.eigvalsh(J * np.sign(np.trace(J, axis1=1, axis2=2))[:, None, None])
    return (moments[:, 0] > 0.03 * moments[:, 2]) & (moments[:, 0] + moments[:, 1] > 0.8 * moments[:, 2])


def _runs(flags: Array) -> list[tuple[int, int]]:
    """Return the first and last index of each run of true flags."""
    edges = np.flatnonzero(np.diff(np.concatenate([[False], flags, [False]]).astype(int)))
    return [(int(a), int(b) - 1) for a, b in zip(edges[::2], edges[1::2], strict=True)]
