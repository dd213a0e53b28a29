"""Free flights in the log of a gyro alone: where one inertia J keeps R J ω constant."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from scipy.ndimage import binary_closing

from polhode.measuring.throws._linear_start import OFF_DIAGONAL, ROOT, integrate_rates, momentum_map
from polhode.types import Array, Bool, Float64, Integer

SPANS = (0.3, 0.6, 1.2, 2.4)  # s, over which stretches are judged; the slower the turning, the longer
TURN = 2.0  # rad, of which a span holds at least so much
SLOWEST = 1.0  # rad/s: slower turning says nothing of inertia
UNEVEN = 0.03  # change of angular momentum relative to its size, within a span
TORQUE = (0.3, 1.0)  # 1/s, of the angular momentum: drag and a gyro's bias give some tenths, hands several
OWN_TORQUE = 3.0  # times the usual one within the span: more is another motion
HOP = 0.07  # s, over which a noisy gyro's torque is judged at most
MOST_ROUNDS = 4
PLANE = 12  # inertias that are asked in a plane of them
STRIDES = 6  # spans begin so often within the length of one
MOST_AT_ONCE = 20_000  # samples
BROKEN = 0.1  # s: longer steps between samples end a stretch


@dataclass(frozen=True, eq=False)
class Stretch:
    """A stretch with constant angular momentum.

    Attributes:
        first: its first sample.
        last: its last sample.
        inertia: (6,) for which it is constant, as ``linear_start.momentum_map`` has it.
        change: of the angular momentum, relative to its size.
        turn: how far the body turned [rad].
    """

    first: int
    last: int
    inertia: Float64[Array, "6"]
    change: float
    turn: float


def momentum_stretches(t: Float64[Array, "n"], rates: Float64[Array, "n 3"], shortest: float) -> list[Stretch]:
    """Return the stretches with constant angular momentum, in the order of time.

    Args:
        t: [s], increasing.
        rates: [rad/s, device frame], without the gyro's bias as far as it is known.
        shortest: of a stretch [s].
    """
    stretches: list[Stretch] = []
    speeds = np.linalg.norm(rates, axis=1)
    for first, last in _find_turning_parts(t, speeds):
        for begin in range(first, last + 1, MOST_AT_ONCE // 2):
            end = min(begin + MOST_AT_ONCE, last + 1)
            if t[end - 1] - t[begin] >= shortest:
                stretches += _within(t[begin:end], rates[begin:end], shortest, begin)
            if end > last:
                break
    return _apart(stretches)


def within(t: Float64[Array, "n"], rates: Float64[Array, "n 3"]) -> Stretch | None:
    """Return the stretch without torque that holds the middle half of some samples; None where there is none."""
    maps = momentum_map(integrate_rates(t, rates), rates)
    begin, end = len(t) // 4, len(t) - len(t) // 4
    grown = _grow_stretch(t, maps, begin, end, fit_inertia(maps[begin:end])[0])
    if grown is None or grown[0] > begin or grown[1] < end - 1:
        return None
    first, last, inertia = grown
    turn = float(np.sum(_speed(rates[first:last]) * np.diff(t[first : last + 1])))
    return Stretch(first, last, inertia, measure_change(maps[first : last + 1], inertia), turn)


def of_one_body(
    t: Float64[Array, "n"], rates: Float64[Array, "n 3"], stretches: list[Stretch]
) -> tuple[list[Stretch], list[Stretch]]:
    """Return the stretches that one inertia explains together, which turn furthest, and the others.

    Handling may keep some momentum constant for a moment, with an inertia that fits nowhere else.
    """
    spreads = [_Spread.of(t, rates, one) for one in stretches]
    order = sorted(range(len(stretches)), key=lambda k: -stretches[k].turn)
    groups: list[list[int]] = []
    for k in order:
        home = next((group for group in groups if _agree([spreads[j] for j in (*group, k)])), None)
        if home is None:
            groups.append([k])
        else:
            home.append(k)
    best = max(groups, key=lambda group: sum(stretches[k].turn for k in group), default=[])
    return [one for k, one in enumerate(stretches) if k in best], [
        one for k, one in enumerate(stretches) if k not in best
    ]


@dataclass(frozen=True, eq=False)
class _Spread:
    """Mean (3, 6) of the momentum maps of a stretch, their spread (6, 6) about it, and the change that its own best
    inertia leaves.
    """

    mean: Array
    spread: Array
    change: float

    @classmethod
    def of(cls, t: Array, rates: Array, one: Stretch) -> _Spread:
        part = slice(one.first, one.last + 1)
        maps = momentum_map(integrate_rates(t[part], rates[part]), rates[part])
        mean = maps.mean(axis=0)
        spread = np.tensordot(maps, maps, axes=((0, 1), (0, 1))) / len(maps) - mean.T @ mean
        return cls(mean, spread, one.change)

    def change_by(self, inertia: Array) -> float:
        momentum = float(np.linalg.norm(self.mean @ inertia))
        return float(np.sqrt(max(float(inertia @ self.spread @ inertia), 0.0)) / max(momentum, 1e-12))


def _agree(spreads: list[_Spread]) -> bool:
    """Whether with one inertia the momentum of every stretch is constant within the tolerance."""
    sizes = [max(float(np.trace(one.spread)), 1e-300) for one in spreads]
    inertia = np.linalg.eigh(sum(one.spread / size for one, size in zip(spreads, sizes, strict=True)))[1][:, 0]
    return all(one.change_by(inertia) < max(UNEVEN, 3 * one.change) for one in spreads)


def fit_inertia(maps: Float64[Array, "n 3 6"]) -> tuple[Float64[Array, "6"], float]:
    """Return the inertia with the most constant momentum, and the momentum's relative change.

    A physical inertia is preferred where it does well too; the change is infinite if there is none.
    """
    mean = maps.mean(axis=0)
    spread = np.tensordot(maps, maps, axes=((0, 1), (0, 1))) / len(maps) - mean.T @ mean
    inertias, change = _fit_inertias(mean[None], spread[None])
    return inertias[0], float(change[0])


def _fit_inertias(mean: Float64[Array, "m 3 6"], spread: Float64[Array, "m 6 6"]) -> tuple[Array, Array]:
    values, vectors = np.linalg.eigh(spread)
    # a short or steady turn leaves a plane of inertias: those in it are asked, the best of all first
    angles = np.concatenate([[0.0], np.pi / PLANE * np.arange(1, PLANE)])
    tried = (np.cos(angles)[:, None] * vectors[:, None, :, 0] + np.sin(angles)[:, None] * vectors[:, None, :, 1])
    squares = np.cos(angles) ** 2 * values[:, :1] + np.sin(angles) ** 2 * values[:, 1:2]
    momentum = np.linalg.norm(np.einsum("mij,mkj->mki", mean, tried), axis=2)
    change = np.sqrt(np.maximum(squares, 0.0)) / np.maximum(momentum, 1e-12)
    change = np.where(_possible(tried.reshape(-1, 6)).reshape(change.shape), change, np.inf)
    best = np.where(np.isfinite(change[:, 0]), 0, np.argmin(change, axis=1))
    rows = np.arange(len(tried))
    return tried[rows, best], change[rows, best]


def measure_change(maps: Float64[Array, "n 3 6"], inertia: Float64[Array, "6"]) -> float:
    """Return how much an inertia's momentum changes, root mean square, relative to its size."""
    momentum = maps @ inertia
    mean = momentum.mean(axis=0)
    spread = np.sqrt(np.mean(np.sum((momentum - mean) ** 2, axis=1)))
    return float(spread / max(float(np.linalg.norm(mean)), 1e-12))


def _find_turning_parts(t: Float64[Array, "n"], speeds: Float64[np.ndarray, "n"]) -> list[tuple[int, int]]:
    """Return the first and last sample of the parts of a log in which the device turns at all."""
    fast = np.logical_or(binary_closing(speeds > SLOWEST, np.ones(5)), speeds > SLOWEST)
    whole = np.diff(t) < max(BROKEN, 5 * float(np.median(np.diff(t))))
    starts = fast & ~np.concatenate([[False], fast[:-1] & whole])
    ends = fast & ~np.concatenate([fast[1:] & whole, [False]])
    return list(zip(np.flatnonzero(starts).tolist(), np.flatnonzero(ends).tolist(), strict=True))


def _within(t: Array, rates: Array, shortest: float, offset: int) -> list[Stretch]:
    maps = momentum_map(integrate_rates(t, rates), rates)
    angle = np.concatenate([[0.0], np.cumsum(0.5 * (_speed(rates[1:]) + _speed(rates[:-1])) * np.diff(t))])
    taken = np.zeros(len(t), dtype=bool)
    stretches = []
    for begin, end, inertia in _seeds(t, maps, angle):
        if taken[begin:end].mean() > 0.5:
            continue
        grown = _grow_stretch(t, maps, begin, end, inertia)
        if grown is None:
            continue
        first, last, inertia = grown
        if t[last] - t[first] >= shortest:
            taken[first : last + 1] = True
            change = measure_change(maps[first : last + 1], inertia)
            stretches.append(Stretch(first + offset, last + offset, inertia, change, float(angle[last] - angle[first])))
    return stretches


def _speed(rates: Array) -> Array:
    return np.linalg.norm(rates, axis=1)


def _seeds(t: Array, maps: Array, angle: Array) -> list[tuple[int, int, Array]]:
    """Return spans with constant momentum for some physical inertia, and that inertia; the best come first."""
    seeds: list[tuple[float, int, int, Array]] = []
    step = float(np.median(np.diff(t)))
    for size in dict.fromkeys(max(6, round(span / step)) for span in SPANS):
        if size > len(t):
            size = len(t) if not seeds and len(t) >= 6 else size
        begins = np.arange(0, len(t) - size + 1, max(1, size // STRIDES))
        begins = begins[angle[begins + size - 1] - angle[begins] >= TURN] if len(begins) else begins
        if not len(begins):
            continue
        inertias, change = _fit_inertia_by_spans(maps, begins, size)
        # the best of each neighbourhood; one inertia of a hand's may be of no use a little further
        for part in np.array_split(np.arange(len(begins)), max(1, len(begins) // STRIDES)):
            best = part[np.argmin(change[part])]
            if change[best] < UNEVEN:
                seeds.append((float(change[best]), int(begins[best]), int(begins[best]) + size, inertias[best]))
    return [(begin, end, inertia) for _, begin, end, inertia in sorted(seeds, key=lambda seed: seed[0])]


def _fit_inertia_by_spans(maps: Array, begins: Integer[Array, "m"], size: int) -> tuple[Array, Array]:
    """Return for each span the inertia (6,) with the most constant momentum, and the momentum's relative change."""
    total, squares = np.zeros((len(maps) + 1, 3, 6)), np.zeros((len(maps) + 1, 6, 6))
    np.cumsum(maps, axis=0, out=total[1:])
    np.cumsum(np.matmul(np.swapaxes(maps, 1, 2), maps), axis=0, out=squares[1:])
    mean = (total[begins + size] - total[begins]) / size
    spread = (squares[begins + size] - squares[begins]) / size - np.matmul(np.swapaxes(mean, 1, 2), mean)
    return _fit_inertias(mean, spread)


def _grow_stretch(t: Array, maps: Array, begin: int, end: int, inertia: Array) -> tuple[int, int, Array] | None:
    """Return first and last sample of the stretch around a span in which no torque acts, and the inertia it keeps."""
    first, last = begin, end - 1
    for _ in range(MOST_ROUNDS):
        quiet = _quiet(t, maps @ inertia, first, last)
        middle = _longest(quiet[first : last + 1])
        if middle is None:
            return None
        low, high = first + middle[0], first + middle[1]
        while low > 0 and quiet[low - 1]:
            low -= 1
        while high < len(t) - 1 and quiet[high + 1]:
            high += 1
        if high - low < 6:
            return None
        inertia, change = fit_inertia(maps[low : high + 1])
        if not np.isfinite(change):
            return None
        if (low, high) == (first, last):
            break
        first, last = low, high
    return first, last, inertia


def _quiet(t: Array, momentum: Array, first: int, last: int) -> Bool[Array, "n"]:
    """Return at which samples no torque acts beyond what the noise and the usual torque of a stretch explain."""
    size = np.maximum(np.linalg.norm(momentum, axis=1), 1e-12)
    steps = np.linalg.norm(np.diff(momentum[first : last + 1], axis=0), axis=1) / size[first:last]
    noise = float(np.median(steps))  # of the momentum's step from sample to sample
    step = float(np.median(np.diff(t)))
    hop = min(max(1, round(HOP / step)), max(1, int(np.ceil(4 * noise / (TORQUE[0] * step)))))
    torque = np.linalg.norm(momentum[hop:] - momentum[:-hop], axis=1) / (t[hop:] - t[:-hop])
    torque = torque / np.minimum(size[hop:], size[:-hop])
    usual = float(np.median(torque[first : max(last - hop + 1, first + 1)]))
    calm = torque < min(max(TORQUE[0], OWN_TORQUE * usual), TORQUE[1])
    for begin, behind in _runs(~calm):  # a spike spoils the hops that touch it, and the momentum is the same behind it
        after = min(behind + hop - 1, len(t) - 1)
        moved = np.linalg.norm(momentum[after] - momentum[begin]) / size[begin]
        if after - begin <= 2 * hop + 2 and moved < TORQUE[0] * (t[after] - t[begin]) + 2 * noise:
            calm[begin:behind] = True
    quiet = np.zeros(len(t), dtype=bool)
    for shift in range(hop + 1):
        quiet[np.flatnonzero(calm) + shift] = True
    return quiet


def _longest(flags: Bool[Array, "n"]) -> tuple[int, int] | None:
    return max(((begin, behind - 1) for begin, behind in _runs(flags)), key=lambda run: run[1] - run[0], default=None)


def _runs(flags: Bool[Array, "n"]) -> list[tuple[int, int]]:
    """Return where each run of true flags begins, and what is behind it."""
    edges = np.flatnonzero(np.diff(np.concatenate([[False], flags, [False]]).astype(np.int8)))
    return list(zip(edges[::2].tolist(), edges[1::2].tolist(), strict=True))


def _possible(inertias: Float64[Array, "n 6"]) -> Bool[Array, "n"]:
    """Return which inertias are physical, within the tolerance for a biased gyro."""
    J = np.zeros((len(inertias), 3, 3))
    J[:, [0, 1, 2], [0, 1, 2]] = inertias[:, :3]
    for k, (i, j) in enumerate(OFF_DIAGONAL, start=3):
        J[:, i, j] = J[:, j, i] = inertias[:, k] / ROOT
    moments = np.linalg.eigvalsh(J * np.sign(np.trace(J, axis1=1, axis2=2))[:, None, None])
    return (moments[:, 0] > 0.03 * moments[:, 2]) & (moments[:, 0] + moments[:, 1] > 0.8 * moments[:, 2])


def _apart(stretches: list[Stretch]) -> list[Stretch]:
    """Return stretches that do not overlap, the longest of those that do."""
    kept: list[Stretch] = []
    for one in sorted(stretches, key=lambda each: each.first - each.last):
        if all(one.last < other.first or one.first > other.last for other in kept):
            kept.append(one)
    kept.sort(key=lambda each: each.first)
    assert all(a.last < b.first for a, b in pairwise(kept))
    return kept
