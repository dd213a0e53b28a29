"""Free flights in the log of a gyro alone: where one inertia J keeps R J ω constant."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise
from typing import NamedTuple

import numpy as np
from scipy.ndimage import binary_closing

from polhode.measuring.throws._linear_start import OFF_DIAGONAL, ROOT, integrate_rates, momentum_map
from polhode.types import Array, Bool, Float64, Integer


class MomentumThresholds(NamedTuple):
    """Numbers that decide where a body keeps its angular momentum.

    Attributes:
        min_turn: rad, through which the body rotates in a span; less leaves too many inertias.
        min_rate: rad/s; slower rotation determines no inertia.
        max_change: of the angular momentum relative to its size, root mean square within a span.
        max_torque: 1/s, over the angular momentum; drag and a gyro's bias cause some tenths.
        max_noisy_torque: 1/s, likewise, where the usual torque of a span is large; hands cause several.
        max_torque_ratio: to the usual torque within the span; more is another motion.
        max_hop: s, over which a noisy gyro's torque is averaged.
        max_gap: s; longer steps between samples end a stretch.
        min_moment_ratio: of least and largest moment; a biased gyro may halve that of the thinnest bodies.
        min_triangle_ratio: of I1 + I2 and I3, 1 for a plate and somewhat less by a gyro's bias.
    """

    min_turn: float = 2.0
    min_rate: float = 1.0
    max_change: float = 0.03
    max_torque: float = 0.3
    max_noisy_torque: float = 1.0
    max_torque_ratio: float = 3.0
    max_hop: float = 0.07
    max_gap: float = 0.1
    min_moment_ratio: float = 0.03
    min_triangle_ratio: float = 0.8


LIMITS = MomentumThresholds()


@dataclass(frozen=True, eq=False)
class Stretch:
    """Part of a log with constant angular momentum.

    Attributes:
        first: its first sample.
        last: its last sample.
        inertia: (6,) for which it is constant, in the order of ``linear_start.momentum_map``.
        change: of the angular momentum, relative to its size.
        turn: angle through which the body rotates [rad].
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
    batch = 20_000  # samples whose maps are in memory together
    for first, last in _find_turning_parts(t, speeds):
        for begin in range(first, last + 1, batch // 2):
            end = min(begin + batch, last + 1)
            if t[end - 1] - t[begin] >= shortest:
                stretches += _within(t[begin:end], rates[begin:end], shortest, begin)
            if end > last:
                break
    return _apart(stretches)


def within(t: Float64[Array, "n"], rates: Float64[Array, "n 3"]) -> Stretch | None:
    """Return the stretch without torque that contains the middle half of the samples; None where there is none."""
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
    """Return the stretches that one inertia explains together, with the largest total turn, and the others.

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
    return all(one.change_by(inertia) < max(LIMITS.max_change, 3 * one.change) for one in spreads)


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
    # a short or steady turn leaves a plane of inertias: a few of it are tried, the best of all first
    in_plane = 12
    angles = np.concatenate([[0.0], np.pi / in_plane * np.arange(1, in_plane)])
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
    fast = np.logical_or(binary_closing(speeds > LIMITS.min_rate, np.ones(5)), speeds > LIMITS.min_rate)
    whole = np.diff(t) < max(LIMITS.max_gap, 5 * float(np.median(np.diff(t))))
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
    spans = (0.3, 0.6, 1.2, 2.4)  # s; the slower the rotation, the longer
    strides = 6  # starts of spans within the length of one
    for size in dict.fromkeys(max(6, round(span / step)) for span in spans):
        if size > len(t):
            size = len(t) if not seeds and len(t) >= 6 else size
        begins = np.arange(0, len(t) - size + 1, max(1, size // strides))
        begins = begins[angle[begins + size - 1] - angle[begins] >= LIMITS.min_turn] if len(begins) else begins
        if not len(begins):
            continue
        inertias, change = _fit_inertia_by_spans(maps, begins, size)
        # the best of each neighbourhood: an inertia that fits while a hand holds the body may not fit a little later
        for part in np.array_split(np.arange(len(begins)), max(1, len(begins) // strides)):
            best = part[np.argmin(change[part])]
            if change[best] < LIMITS.max_change:
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
    max_rounds = 4  # in which stretch and inertia settle, or never
    for _ in range(max_rounds):
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
    """Return the samples at which no torque acts beyond the noise and the usual torque of a stretch."""
    size = np.maximum(np.linalg.norm(momentum, axis=1), 1e-12)
    steps = np.linalg.norm(np.diff(momentum[first : last + 1], axis=0), axis=1) / size[first:last]
    noise = float(np.median(steps))  # of the momentum's step from sample to sample
    step = float(np.median(np.diff(t)))
    hop = min(max(1, round(LIMITS.max_hop / step)), max(1, int(np.ceil(4 * noise / (LIMITS.max_torque * step)))))
    torque = np.linalg.norm(momentum[hop:] - momentum[:-hop], axis=1) / (t[hop:] - t[:-hop])
    torque = torque / np.minimum(size[hop:], size[:-hop])
    usual = float(np.median(torque[first : max(last - hop + 1, first + 1)]))
    calm = torque < min(max(LIMITS.max_torque, LIMITS.max_torque_ratio * usual), LIMITS.max_noisy_torque)
    for begin, behind in _runs(~calm):  # a spike spoils the hops that touch it, and leaves the momentum as before
        after = min(behind + hop - 1, len(t) - 1)
        moved = np.linalg.norm(momentum[after] - momentum[begin]) / size[begin]
        if after - begin <= 2 * hop + 2 and moved < LIMITS.max_torque * (t[after] - t[begin]) + 2 * noise:
            calm[begin:behind] = True
    quiet = np.zeros(len(t), dtype=bool)
    for shift in range(hop + 1):
        quiet[np.flatnonzero(calm) + shift] = True
    return quiet


def _longest(flags: Bool[Array, "n"]) -> tuple[int, int] | None:
    return max(((begin, behind - 1) for begin, behind in _runs(flags)), key=lambda run: run[1] - run[0], default=None)


def _runs(flags: Bool[Array, "n"]) -> list[tuple[int, int]]:
    """Return the first index of each run of true flags, and the index behind it."""
    edges = np.flatnonzero(np.diff(np.concatenate([[False], flags, [False]]).astype(np.int8)))
    return list(zip(edges[::2].tolist(), edges[1::2].tolist(), strict=True))


def _possible(inertias: Float64[Array, "n 6"]) -> Bool[Array, "n"]:
    """Return which inertias are physical, within the tolerance for a biased gyro."""
    J = np.zeros((len(inertias), 3, 3))
    J[:, [0, 1, 2], [0, 1, 2]] = inertias[:, :3]
    for k, (i, j) in enumerate(OFF_DIAGONAL, start=3):
        J[:, i, j] = J[:, j, i] = inertias[:, k] / ROOT
    moments = np.linalg.eigvalsh(J * np.sign(np.trace(J, axis1=1, axis2=2))[:, None, None])
    thick = moments[:, 0] > LIMITS.min_moment_ratio * moments[:, 2]
    return thick & (moments[:, 0] + moments[:, 1] > LIMITS.min_triangle_ratio * moments[:, 2])


def _apart(stretches: list[Stretch]) -> list[Stretch]:
    """Return stretches without overlap; of overlapping ones the longest is kept."""
    kept: list[Stretch] = []
    for one in sorted(stretches, key=lambda each: each.first - each.last):
        if all(one.last < other.first or one.first > other.last for other in kept):
            kept.append(one)
    kept.sort(key=lambda each: each.first)
    assert all(a.last < b.first for a, b in pairwise(kept))
    return kept
