"""Finds all zeros of polynomials between two times."""

from __future__ import annotations

from typing import Any

import numpy as np

from polhode._base.compiled.copying import called
from polhode.types import Array

MAX_WAITING = 100  # of intervals that wait to be searched
ROUNDING = 1e-15  # of a polynomial's terms: where values are smaller, their signs say nothing


def find_reach(p: Array, order: Any, h: Any, reach: Any) -> Any:
    """Return how far a series may be followed, h at most; 0 where a coefficient is not finite.

    Its first terms give its size, as the function itself may be at a zero: their size in the step so far, not in h.
    """
    length = h
    for _ in range(6):  # each leaves at most an eighth of the powers of ten by which a step is too long
        size, power, longest = abs(p[0]), 1.0, length
        for k in range(1, 4):
            power *= longest
            # Jorba & Zou, §3.2, with the largest of the first four terms for the size
            size = max(size, abs(p[k]) * power)
        for k in range(order - 2, order + 1):
            if not abs(p[k]) < np.inf:
                return 0.0
            if abs(p[k]) > 0.0 and size > 0.0:
                length = min(length, reach * (size / abs(p[k])) ** (1.0 / k))
        if length == longest:
            break
    return length


def polynomial(p: Array, order: Any, x: Any) -> Any:
    value = p[order]
    for k in range(order - 1, -1, -1):
        value = value * x + p[k]
    return value


@called
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
        # Newton's step, and half of the bracket where that leaves it
        later = x - value / slope if slope != 0.0 else np.inf
        later = later if a <= later <= b else 0.5 * (a + b)
        if abs(later - x) <= 1e-16 * high or later == x:
            return later
        x = later
    return x


@called
def first_zero(p: Array, order: Any, low: Any, high: Any, falling: Any, work: Array, waiting: Array) -> Any:
    """Return the first sign change of a polynomial between low and high, a falling one if so wanted; NaN if none.

    Each part that is searched ends at twice the time where it begins, as the last time may be far beyond all changes.
    """
    left, right, was = low, low, polynomial(p, order, low)
    while right < high:
        # before this there is none: all terms together are less than the first
        nearest = high
        for k in range(1, order + 1):
            if abs(p[k]) > 0.0:
                # for x ≤ ½ (|p₀|/|p_k|)^(1/k) each |p_k| x^k ≤ 2^−k |p₀|, and their sum is less than |p₀|
                nearest = min(nearest, 0.5 * (abs(p[0]) / abs(p[k])) ** (1.0 / k))
        # and a first part that is not too short to advance
        right = min(2.0 * max(left, nearest, 1e-300 * high), high)
        zero = change_within(p, order, left, right, falling, was, work, waiting)
        if zero == zero:
            return zero
        left, later = right, polynomial(p, order, right)
        if changes_sign(was, later, falling):  # at the very end
            return right
        was = later if later != 0.0 else was
    return np.nan


@called
def change_within(
    p: Array, order: Any, low: Any, high: Any, falling: Any, was: Any, work: Array, waiting: Array
) -> Any:
    """Return the first sign change between low and high; NaN if none.

    An interval is left where the middle's value exceeds all that the others add up to, or where all values are
    rounding; it is searched where it is monotone, and halved otherwise, so that no change is missed. One that lies at
    the end of an interval, to the bit or within rounding of it, is in neither of the two that meet there: ``was``, a
    value of the sign before the interval, or zero at the start of a motion from a zero, decides it.
    """
    top, size, power = 1, abs(p[0]), 1.0
    for k in range(1, order + 1):
        power *= high
        size += abs(p[k]) * power
    waiting[0], waiting[1] = low, high
    while top > 0:
        top -= 1
        left, right = waiting[2 * top], waiting[2 * top + 1]
        centre, radius = 0.5 * (left + right), 0.5 * (right - left)
        for k in range(order + 1):  # Numba takes seconds to compile assignments of slices
            work[k] = p[k]
        # Taylor's shift to the centre by repeated synthetic division
        for i in range(order):
            for k in range(order - 1, i - 1, -1):
                work[k] += centre * work[k + 1]
        others, slopes = 0.0, 0.0
        for k in range(order, 0, -1):
            # |q(x) − q₀| ≤ Σ |q_k| r^k, and |q′(x) − q₁| ≤ Σ k |q_k| r^(k−1) over k > 1, within r of the centre
            others = others * radius + abs(work[k])
            if k > 1:
                slopes = slopes * radius + k * abs(work[k])
        others, slopes = others * radius, slopes * radius
        if abs(work[0]) > others:
            if changes_sign(was, work[0], falling):
                return left
            was = work[0]
            continue
        if not abs(work[0]) < np.inf:
            return np.nan
        if abs(work[1]) > slopes or radius <= 1e-15 * high or top + 2 > MAX_WAITING:
            before, after = polynomial(p, order, left), polynomial(p, order, right)
            if changes_sign(was, before, falling):
                return left
            was = before if before != 0.0 else was
            if changes_sign(was, after, falling):
                return zero_between(p, order, left, right)
            was = after if after != 0.0 else was
            continue
        if abs(work[0]) + others <= ROUNDING * size:  # as about a zero of order three, which would be halved for hours
            continue
        waiting[2 * top], waiting[2 * top + 1] = centre, right
        waiting[2 * top + 2], waiting[2 * top + 3] = left, centre
        top += 2
    return np.nan


@called
def changes_sign(before: Any, after: Any, falling: Any) -> Any:
    """Whether a value has come to zero or beyond it, from above or, unless it has to fall, from below."""
    return before > 0.0 >= after or (not falling and before < 0.0 <= after)
