"""The kernel of one copy: coefficients, steps, samples, events, and the way back onto what is conserved.

It runs any program, so that it is compiled once for an installation. Eight products are computed at a time, one in each
lane of a vector. Without Numba the same lines run as Python, a thousand times slower, which is enough for short runs.

Source: Jorba & Zou, Exp. Math. 14 (2005) 99, §3.2, for the length of a step.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from polhode.exact.kernel_arithmetic import compiled
from polhode.taylor.program import (
    ARGUMENT,
    CODE,
    CONSTANT,
    FACTOR,
    FIRST,
    INDEX,
    LEFT,
    NUMBER,
    OPERATIONS,
    OUT,
    PRODUCTS,
    RIGHT,
    SIZE,
    SLOTS,
    START,
)
from polhode.taylor.vectors import gather, load, store
from polhode.types import Array, Float64

inner = compiled(fastmath={"contract", "nsz"}, nogil=True)
inlined = compiled(fastmath={"contract", "nsz"}, nogil=True, forceinline=True)

RUNNING, DONE, STOPPED, FULL, FAILED = 0, 1, 2, 3, 4
FLOOR = 1e-3  # of the scale: a motion that dies away is computed to this part of its first size
SHORTEST = 4e-16  # of the present time: shorter steps do not advance
INDEPENDENT = 0.01  # of a squared gradient, that must be left beside the other gradients
FARTHEST = 1e-3  # of the scale: a run that is off by more is not to be mended
CLOSE = 1e-14  # of a step: an event as near to its beginning as that was found at the end of the step before
UNITS = 300  # of time that are tried
FAR = 256.0  # units: a longer step may be of coefficients that vanished
DEPTH = 100  # of intervals that wait to be searched


@inlined
def combination(whole: Array, number: Array, z: Array, base: Any, row: Any) -> Any:
    start, index, factor = whole[START] + row, whole[INDEX], whole[FACTOR]
    value = 0.0
    for q in range(whole[start], whole[start + 1]):
        value += number[factor + q] * z[base + whole[index + q]]
    return value


@inner
def _function(operation: Any, z: Array, base: Any, width: Any, k: Any, out: Any, x: Any, exponent: Any) -> None:
    """Set the k-th coefficient of a function of node x; see ``program``."""
    u, y, total = out, base + x, 0.0
    if operation == 2:
        if k == 0:
            z[base + out] = z[x] ** exponent
            return
        for j in range(k):
            total += (exponent * (k - j) - j) * (z[u] * z[y])
            u, y = u + width, y - width
        z[base + out] = total / (k * z[x])
    elif operation == 3:
        if k == 0:
            z[base + out] = np.exp(z[x])
            return
        for j in range(k):
            total += (k - j) * (z[u] * z[y])
            u, y = u + width, y - width
        z[base + out] = total / k
    elif operation == 4:
        if k == 0:
            z[base + out] = np.log(z[x])
            return
        for j in range(1, k):
            u, y = u + width, y - width
            total += j * (z[u] * z[y])
        z[base + out] = (z[base + x] - total / k) / z[x]
    else:
        if k == 0:
            z[base + out] = np.sin(z[x])
            z[base + out + 1] = np.cos(z[x])
            return
        sine, cosine = 0.0, 0.0
        for j in range(k):
            weight = (k - j) * z[y]
            sine += weight * z[u + 1]
            cosine -= weight * z[u]
            u, y = u + width, y - width
        z[base + out] = sine / k
        z[base + out + 1] = cosine / k


@inlined
def nodes(whole: Array, number: Array, z: Array, a: Array, b: Array, k: Any) -> None:
    """Set the k-th coefficients of all nodes from those of the state; a and b keep the factors of products."""
    width, products = whole[SLOTS], whole[PRODUCTS]
    codes, outs, arguments, numbers = whole[CODE], whole[OUT], whole[ARGUMENT], whole[NUMBER]
    lefts, rights = whole[LEFT], whole[RIGHT]
    base = k * width
    for q in range(whole[OPERATIONS]):
        operation, out = whole[codes + q], base + whole[outs + q]
        if operation == 1:
            m = whole[arguments + q]
            row = k * products + m
            left, right = gather(z, whole, lefts + m, base), gather(z, whole, rights + m, base)
            store(a, row, left)
            store(b, row, right)
            if k == 0:
                store(z, out, left * right)
                continue
            # the newest from registers, the older from memory; two sums
            one, two = left * load(b, m), load(a, m) * right
            x, y = m + products, row - products
            for _ in range(1, k - 1, 2):
                one = one + load(a, x) * load(b, y)
                two = two + load(a, x + products) * load(b, y - products)
                x += 2 * products
                y -= 2 * products
            if k % 2 == 0:
                one = one + load(a, x) * load(b, y)
            store(z, out, one + two)
        elif operation == 0:
            value = combination(whole, number, z, base, whole[arguments + q])
            z[out] = value + number[numbers + q] if k == 0 else value
        else:
            _function(operation, z, base, width, k, whole[outs + q], whole[arguments + q], number[numbers + q])


@inner
def coefficients(whole: Array, number: Array, z: Array, a: Array, b: Array, order: Any, unit: Any) -> None:
    """Set the coefficients of the state up to an order, of powers of the time over a unit that is a power of two."""
    width, first, constant = whole[SLOTS], whole[FIRST], whole[CONSTANT]
    for k in range(order):
        nodes(whole, number, z, a, b, k)
        base = k * width
        for i in range(whole[SIZE]):
            value = combination(whole, number, z, base, first + i)
            if k == 0:
                value += number[constant + i]
            # divided: multiplied by the reciprocal, errors of all steps would have one sign
            z[base + width + i] = value * unit / (k + 1)


@inner
def step_length(whole: Array, z: Array, scale: Array, order: Any, reach: Any) -> Any:
    """Return the length of a step by the last three coefficients; infinite where all are zero, NaN where none is."""
    width = whole[SLOTS]
    size, best = FLOOR, np.inf
    for i in range(whole[SIZE]):
        size = max(size, abs(z[i]) / scale[i])
    for k in range(order - 2, order + 1):
        largest = 0.0
        for i in range(whole[SIZE]):
            part = abs(z[k * width + i]) / scale[i]
            if not part <= 1e250:
                return np.nan
            largest = max(largest, part)
        if largest > 0.0:
            best = min(best, (size / largest) ** (1.0 / k))
    return best * reach


@inner
def power_of_two(x: Any) -> Any:
    """Return the power of two at or below a positive number."""
    return math.ldexp(1.0, math.frexp(x)[1] - 1)


@inner
def fitted_series(
    whole: Array, number: Array, z: Array, a: Array, b: Array, scale: Array, order: Any, reach: Any, unit: Any,
    left: Any,
) -> Any:  # fmt: skip
    """Set the coefficients by a unit of time that fits them, and return it and the length of the step in it.

    The search begins with a unit such as the last step's length, and goes up to the time that is left.
    """
    length = np.nan
    for _ in range(UNITS):
        coefficients(whole, number, z, a, b, order, unit)
        length = step_length(whole, z, scale, order, reach)
        if not length >= 0.0:
            if unit < 1e-280:
                break
            unit *= 2.0**-8  # they overflow
        elif length > FAR and unit < left:  # the last ones may have vanished
            unit = min(unit * 2.0**16, power_of_two(left) * 2.0)
        else:
            break
    return unit, length


@inner
def evaluate(whole: Array, z: Array, order: Any, h: Any, out: Array) -> None:
    """Set out to the state after h units of time."""
    width = whole[SLOTS]
    for i in range(whole[SIZE]):
        value = z[order * width + i]
        for k in range(order - 1, -1, -1):
            value = value * h + z[k * width + i]
        out[i] = value


@inner
def polynomial(p: Array, order: Any, x: Any) -> Any:
    value = p[order]
    for k in range(order - 1, -1, -1):
        value = value * x + p[k]
    return value


@inner
def zero_between(p: Array, order: Any, low: Any, high: Any) -> Any:
    """Return the zero of a polynomial that changes its sign once between low and high, by Newton within brackets."""
    sign = polynomial(p, order, low) < 0.0
    a, b, x = low, high, 0.5 * (low + high)
    for _ in range(200):
        value, slope = p[order], 0.0
        for k in range(order - 1, -1, -1):
            slope = slope * x + value
            value = value * x + p[k]
        if (value < 0.0) == sign:
            a = x
        else:
            b = x
        later = x - value / slope if slope != 0.0 else np.inf
        later = later if a <= later <= b else 0.5 * (a + b)
        if abs(later - x) <= 1e-16 * high or later == x:
            return later
        x = later
    return x


@inner
def first_zero(p: Array, order: Any, low: Any, high: Any, falling: Any, work: Array, waiting: Array) -> Any:
    """Return the first sign change of a polynomial between low and high, a falling one if so wanted; NaN if none.

    An interval is left where the middle's value exceeds all that the others add up to, searched where it is monotone,
    and halved otherwise, so that no change is missed.
    """
    top = 1
    waiting[0], waiting[1] = low, high
    while top > 0:
        top -= 1
        left, right = waiting[2 * top], waiting[2 * top + 1]
        centre, radius = 0.5 * (left + right), 0.5 * (right - left)
        for k in range(order + 1):  # Numba takes seconds to compile assignments of slices
            work[k] = p[k]
        for i in range(order):
            for k in range(order - 1, i - 1, -1):
                work[k] += centre * work[k + 1]
        others, slopes, power = 0.0, 0.0, radius
        for k in range(1, order + 1):
            others += abs(work[k]) * power
            if k > 1:
                slopes += k * abs(work[k]) * power / radius
            power *= radius
        if abs(work[0]) > others:
            continue
        if abs(work[1]) > slopes or radius <= 1e-15 * high or top + 2 > DEPTH:
            before, after = polynomial(p, order, left), polynomial(p, order, right)
            if before > 0.0 >= after or (not falling and before < 0.0 <= after):
                return zero_between(p, order, left, right)
            continue
        waiting[2 * top], waiting[2 * top + 1] = centre, right
        waiting[2 * top + 2], waiting[2 * top + 3] = left, centre
        top += 2
    return np.nan


@inner
def back_onto(
    whole: Array, number: Array, y: Array, wanted: Array, scale: Array, z: Array, a: Array, b: Array, rows: Array
) -> None:
    """Move a state by one Newton step onto what is conserved: the outputs are the values, then their gradients.

    Gradients that nearly depend on those before them are left out, as at an equilibrium, where nothing is to be gained.
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
            rows[kept, i] = slope * scale[i]
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
            y[i] += rows[e, n] * rows[e, i] * scale[i]


@compiled(fastmath={"contract", "nsz"}, nogil=True, cache=True)
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
    rows, p, work = np.zeros((wanted.shape[0] + 1, n + 1)), np.zeros(order + 1), np.zeros(order + 1)
    waiting, point = np.zeros(2 * DEPTH + 8), np.zeros(n)
    for _ in range(limit):
        t = now[0]
        end = ends[counts[2]]
        for i in range(n):
            z[i] = y[i]
        unit, length = fitted_series(whole, number, z, a, b, scale, order, reach, now[2], abs(end - t))
        h = min(length * unit, longest)
        if not h > SHORTEST * abs(t) or not h > 0.0:
            return FAILED
        now[2] = power_of_two(min(h, abs(end - t)))
        last = h >= forth * (end - t) * (1.0 - 1e-12)
        later = end if last else t + forth * h
        h = later - t
        event, first = -1, h
        if watched:
            nodes(whole, number, z, a, b, order)
        for w in range(watched):
            row = whole[FIRST] + n + w
            others, power = 0.0, abs(h) / unit
            for k in range(order + 1):
                p[k] = combination(whole, number, z, k * width, row) * forth**k  # of the units of time that pass
                if k == 0:
                    p[k] += number[whole[CONSTANT] + n + w]
                    continue
                others += abs(p[k]) * power
                power *= abs(h) / unit
            if abs(p[0]) > others:
                continue
            low = 0.0
            if counts[4] == w and abs(now[1] - t) <= CLOSE * abs(h) + SHORTEST * abs(t):
                low = min(CLOSE * abs(h) + 4.0 * SHORTEST * abs(t), abs(h))
            found = forth * unit * first_zero(p, order, low / unit, abs(h) / unit, falling[w], work, waiting)
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




@compiled(fastmath={"contract", "nsz"}, nogil=True, cache=True)
def values_at(whole: Array, number: Array, z: Array, a: Array, b: Array, count: Any) -> Float64[Array, "outputs"]:
    """Return the first outputs of a program at a state, which z begins with."""
    nodes(whole, number, z, a, b, 0)
    found = np.zeros(count)
    for c in range(count):
        found[c] = combination(whole, number, z, 0, whole[FIRST] + c) + number[whole[CONSTANT] + c]
    return found


@compiled(fastmath={"contract", "nsz"}, nogil=True, cache=True)
def coefficients_at(whole: Array, number: Array, state: Array, order: Any) -> Float64[Array, "numbers"]:
    """Return the coefficients of all nodes, order after order, of the motion through a state (n,)."""
    z = np.zeros((order + 1) * whole[SLOTS] + 8)
    a = np.zeros((order + 1) * whole[PRODUCTS] + 8)
    for i in range(whole[SIZE]):
        z[i] = state[i]
    coefficients(whole, number, z, a, np.zeros_like(a), order, 1.0)
    return z
