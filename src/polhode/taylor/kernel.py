"""The kernel of one copy: steps, samples, events, and the way back onto what is conserved.

It runs any program, so that it is compiled once for an installation; ``kernels`` says by whom.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from polhode.taylor.kernel_series import combination, evaluate, fitted_series, nodes, power_of_two
from polhode.taylor.kernel_zeros import DEPTH, first_zero, reach_of
from polhode.taylor.program import CONSTANT, FIRST, PRODUCTS, SIZE, SLOTS
from polhode.types import Array, Float64

RUNNING, DONE, STOPPED, FULL, FAILED = 0, 1, 2, 3, 4
SHORTEST = 4e-16  # of the present time: shorter steps do not advance
INDEPENDENT = 0.01  # of a squared gradient, that must be left beside the other gradients
FARTHEST = 1e-3  # of the scale: a run that is off by more is not to be mended
CLOSE = 1e-14  # of a step: an event as near to its beginning as that was found at the end of the step before


def back_onto(
    whole: Array, number: Array, y: Array, wanted: Array, scale: Array, z: Array, a: Array, b: Array, rows: Array
) -> None:
    """Move a state by one Newton step onto what is conserved: the outputs are the values, then their gradients.

    Gradients that nearly depend on those before them are left out, as at an equilibrium, where nothing is to be gained.
    What has an infinite scale is left where it is.
    """
    n, count, kept = whole[SIZE], wanted.shape[0], 0
    for i in range(n):
        z[i] = y[i]
    nodes(whole, number, z, a, b, 0)
    for c in range(count):
        off = wanted[c] - combination(whole, number, z, 0, whole[FIRST] + c) - number[whole[CONSTANT] + c]
        square = 0.0
        for i in range(n):
            o = count + c * n + i
            slope = combination(whole, number, z, 0, whole[FIRST] + o) + number[whole[CONSTANT] + o]
            rows[kept, i] = slope * scale[i] if scale[i] < np.inf else 0.0
            square += rows[kept, i] * rows[kept, i]
        # what the earlier ones move is taken out, of gradient and of what is missing
        for e in range(kept):
            along = 0.0
            for i in range(n):
                along += rows[kept, i] * rows[e, i]
            for i in range(n):
                rows[kept, i] -= along * rows[e, i]
            off -= along * rows[e, n]
        left = 0.0
        for i in range(n):
            left += rows[kept, i] * rows[kept, i]
        length = np.sqrt(left)
        if not left > INDEPENDENT * square or not abs(off) < FARTHEST * length:
            continue
        for i in range(n):
            rows[kept, i] /= length
        rows[kept, n] = off / length
        kept += 1
    for e in range(kept):
        for i in range(n):
            if scale[i] < np.inf:
                y[i] += rows[e, n] * rows[e, i] * scale[i]


def advance(
    whole: Array, number: Array, whole_of: Array, number_of: Array, y: Array, scale: Array, wanted: Array, ends: Array,
    times: Array, out: Array, now: Array, counts: Array, hits: Array, order: Any, reach: Any, longest: Any, forth: Any,
    clock: Any, falling: Array, stops: Array, limit: Any,
) -> Any:  # fmt: skip
    """Go on with a run, for at most so many steps, and return how it stands.

    Args:
        whole, number: the program of the rates of change, and of what is watched.
        whole_of, number_of: that of what is conserved, and of its gradients.
        y: (n,) the state, which is changed.
        scale: (n,) sizes of its components.
        wanted: (C,) what is conserved, and kept.
        ends: (E,) times at which steps end, ascending in the direction of time, the last time last.
        times, out: (T,) samples likewise, and (T, n) where they are put.
        now: (3,) the present time, that of the last event, and a unit of time to begin with, such as a step's length.
        counts: (5,) steps so far, next of ``times``, next of ``ends``, hits so far, which event was last (−1).
        hits: (H, 2 + n) time, number and state of events.
        order, reach, longest: of the coefficients, of a step in radii of convergence, and step.
        forth: 1, or −1 of a run backwards in time.
        clock: component of the state that is the time, or −1.
        falling, stops: (W,) whether only changes from positive to negative are events, and which end the run.
        limit: of the steps.
    """
    n, width, watched = whole[SIZE], whole[SLOTS], falling.shape[0]
    z = np.zeros((order + 1) * width + 8)
    a = np.zeros((order + 1) * whole[PRODUCTS] + 8)
    b = np.zeros_like(a)
    other = np.zeros(whole_of[SLOTS] + 8), np.zeros(whole_of[PRODUCTS] + 8), np.zeros(whole_of[PRODUCTS] + 8)
    rows, p, work = np.zeros((wanted.shape[0] + 1, n + 1)), np.zeros((watched, order + 1)), np.zeros(order + 1)
    waiting, point = np.zeros(2 * DEPTH + 8), np.zeros(n)
    for _ in range(limit):
        t = now[0]
        end = ends[counts[2]]
        for i in range(n):
            z[i] = y[i]
        unit, length = fitted_series(whole, number, z, a, b, scale, order, reach, now[2], abs(end - t))
        h = min(length * unit, longest)
        if watched:
            nodes(whole, number, z, a, b, order)
        for w in range(watched):
            row, to_t = whole[FIRST] + n + w, 1.0
            for k in range(order + 1):
                p[w, k] = combination(whole, number, z, k * width, row) * to_t  # of the units of time that pass
                to_t *= forth
            p[w, 0] += number[whole[CONSTANT] + n + w]
            ahead = min(h, abs(end - t))
            reached = unit * reach_of(p[w], order, ahead / unit, reach)
            if reached < ahead:
                h = reached
        if not h > SHORTEST * abs(t) or not h > 0.0:
            return FAILED
        now[2] = power_of_two(min(h, abs(end - t)))
        last = h >= forth * (end - t) * (1.0 - 1e-12)
        later = end if last else t + forth * h
        h = later - t
        event, first = -1, h
        for w in range(watched):
            others, power = 0.0, abs(h) / unit
            for k in range(1, order + 1):
                others += abs(p[w, k]) * power
                power *= abs(h) / unit
            if abs(p[w, 0]) > others:
                continue
            low = 0.0
            if counts[4] == w and abs(now[1] - t) <= CLOSE * abs(h) + SHORTEST * abs(t):
                low = min(CLOSE * abs(h) + 4.0 * SHORTEST * abs(t), abs(h))
            found = forth * unit * first_zero(p[w], order, low / unit, abs(h) / unit, falling[w], work, waiting)
            if abs(found) <= abs(first):
                event, first = w, found
        if event >= 0:
            if counts[3] == hits.shape[0]:
                return FULL
            later, last = t + first, False
            h = first
        while counts[1] < times.shape[0] and forth * times[counts[1]] <= forth * later:
            if times[counts[1]] == later and event < 0:
                break  # samples at the end of a step have its state, put back onto what is conserved
            evaluate(whole, z, order, (times[counts[1]] - t) / unit, point)
            for i in range(n):
                out[counts[1], i] = point[i]
            if clock >= 0:
                out[counts[1], clock] = times[counts[1]]
            counts[1] += 1
        evaluate(whole, z, order, h / unit, y)
        if clock >= 0:
            y[clock] = later
        if wanted.shape[0]:
            back_onto(whole_of, number_of, y, wanted, scale, other[0], other[1], other[2], rows)
        now[0] = later
        counts[0] += 1
        while counts[1] < times.shape[0] and times[counts[1]] == later:
            for i in range(n):
                out[counts[1], i] = y[i]
            counts[1] += 1
        if event >= 0:
            hits[counts[3], 0], hits[counts[3], 1] = later, event
            for i in range(n):
                hits[counts[3], 2 + i] = y[i]
            counts[3] += 1
            counts[4], now[1] = event, later
            if stops[event]:
                return STOPPED
        if last:
            counts[2] += 1
            if counts[2] == ends.shape[0]:
                return DONE
    return RUNNING


def values_at(whole: Array, number: Array, z: Array, a: Array, b: Array, count: Any) -> Float64[Array, "outputs"]:
    """Return the first outputs of a program at a state, which z begins with."""
    nodes(whole, number, z, a, b, 0)
    found = np.zeros(count)
    for c in range(count):
        found[c] = combination(whole, number, z, 0, whole[FIRST] + c) + number[whole[CONSTANT] + c]
    return found
