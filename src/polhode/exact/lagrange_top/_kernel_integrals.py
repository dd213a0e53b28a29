"""The integrals of the first kind of ``preparation`` for a block of tops, compiled by Numba.

The places of the poles enter amplitudes alone, so float64 does; the start enters phases, and the logarithm that it is
near the saddle wants some more digits.
"""

from __future__ import annotations

import math
from typing import Any

from polhode._base.compiled.copying import called
from polhode.exact._kernel_arithmetic import (
    BLOCK,
    add,
    choice,
    divide,
    multiply,
    pair,
    put,
    root,
    root_or_zero,
    scale,
    square_root,
)
from polhode.exact.lagrange_top import _kernel_store as at

MOST_STEPS = 40
CLOSE, CLOSER = 1e-2, 2e-3  # of the spread, whose eighth power is what the closing formula leaves
# rows of the duplication, those of the sharp one in pairs
X, Y_, Z = 0, 2 * BLOCK, 4 * BLOCK
STEPS = 6
ONE = (1.0, 0.0)
NONE = math.nan


def _series(x: float, y: float) -> float:
    """Return what Carlson's R_F is more than one over the root of the mean, of relative distances from it."""
    z = -x - y
    second, third = x * y - z * z, x * y * z
    higher = second * second * (1.0 / 24.0 - second * (5.0 / 208.0)) - second * third * (3.0 / 44.0)
    higher += third * (3.0 / 104.0 * third + 0.0625 * second * second)
    return (higher + third * (1.0 / 14.0)) - 0.1 * second


def _widest(x: float, y: float, z: float) -> float:
    """Return the largest distance from the mean over it."""
    mean = ((x + y) + z) / 3.0
    return max(max(abs(mean - x), abs(mean - y)), abs(mean - z)) / mean


@called
def _far(s: Any, count: int, close: float) -> int:
    """Return how many need a step of the duplication."""
    far = 0
    for i in range(count):
        far += 1 if _widest(s[X + i], s[Y_ + i], s[Z + i]) > close else 0
    return far


@called
def _duplicate(s: Any, count: int) -> None:
    """Take a step of the duplication with those that need it, so that none depends on its neighbours."""
    for i in range(count):
        x, y, z = s[X + i], s[Y_ + i], s[Z + i]
        near = _widest(x, y, z) <= CLOSE
        a, b, c = square_root(x), square_root(y), square_root(z)
        more = (a * b + b * c) + c * a
        s[X + i] = x if near else 0.25 * (x + more)
        s[Y_ + i] = y if near else 0.25 * (y + more)
        s[Z + i] = z if near else 0.25 * (z + more)


@called
def _first_kind(s: Any, count: int) -> None:
    """Put R_F(x, y, 1) of two rows into the first; NaN where it has not converged."""
    for i in range(count):
        s[Z + i] = 1.0
    left = MOST_STEPS
    while left > 0 and _far(s, count, CLOSE) > 0:
        _duplicate(s, count)
        left -= 1
    for i in range(count):
        far = _widest(s[X + i], s[Y_ + i], s[Z + i]) > CLOSE
        mean = ((s[X + i] + s[Y_ + i]) + s[Z + i]) / 3.0
        value = (1.0 + _series(1.0 - s[X + i] / mean, 1.0 - s[Y_ + i] / mean)) / square_root(mean)
        s[X + i] = NONE if far else value


@called
def _duplicate_sharply(s: Any, count: int) -> None:
    """Take a step of the duplication in double-double with those that need it."""
    for i in range(count):
        x, y, z = pair(s, X + i), pair(s, Y_ + i), pair(s, Z + i)
        near = _widest(x[0], y[0], z[0]) <= CLOSER
        a, b, c = root_or_zero(x), root_or_zero(y), root(z)
        more = add(multiply(a, add(b, c)), multiply(b, c))
        put(s, X + i, choice(near, x, scale(add(x, more), 0.25)))
        put(s, Y_ + i, choice(near, y, scale(add(y, more), 0.25)))
        put(s, Z + i, choice(near, z, scale(add(z, more), 0.25)))


@called
def _first_kind_sharply(s: Any, count: int) -> None:
    """Put R_F(x, y, 1) of two pairs of rows into the first; NaN where it has not converged."""
    for i in range(count):
        put(s, Z + i, ONE)
    left = MOST_STEPS
    while left > 0 and _far(s, count, CLOSER) > 0:
        _duplicate_sharply(s, count)
        left -= 1
    for i in range(count):
        x, y, z = pair(s, X + i), pair(s, Y_ + i), pair(s, Z + i)
        mean = divide(add(add(x, y), z), (3.0, 0.0))
        apart = _series(1.0 - divide(x, mean)[0], 1.0 - divide(y, mean)[0])
        far = _widest(x[0], y[0], z[0]) > CLOSER
        put(s, X + i, choice(far, (NONE, NONE), divide(add(ONE, (apart, 0.0)), root(mean))))


# ---------------------------------------------------------------------- poles and start


@called
def _pole_of_alpha(w: Any, count: int, s: Any) -> None:
    for i in range(count):
        d, t2 = w[at.GAP + i], w[at.T2 + i]
        s[X + i], s[Y_ + i] = d / t2, d * w[at.Z_PLUS + i] / (w[at.A + i] * t2)
    _first_kind(s, count)
    for i in range(count):
        w[at.V_ALPHA + i] = square_root(w[at.T1 + i] / w[at.T2 + i]) * s[X + i]


@called
def _pole_of_beta(w: Any, count: int, s: Any) -> None:
    for i in range(count):
        d, s1 = w[at.GAP + i], w[at.S1 + i]
        s[X + i], s[Y_ + i] = d * w[at.Z_MINUS + i] / (s1 * w[at.B + i]), d / s1
    _first_kind(s, count)
    for i in range(count):
        w[at.V_BETA + i] = square_root(w[at.S2 + i] * w[at.A + i] / (w[at.S1 + i] * w[at.B + i])) * s[X + i]


@called
def _rest_of_alpha(w: Any, count: int, s: Any) -> None:
    for i in range(count):
        g, z = w[at.G + i], w[at.Z_PLUS + i]
        s[X + i], s[Y_ + i] = g * w[at.T1 + i] / z, g * w[at.T2 + i] / z
    _first_kind(s, count)
    for i in range(count):
        w[at.W_ALPHA + i] = square_root(w[at.A + i] / w[at.Z_PLUS + i]) * s[X + i]
        w[at.V_ALPHA + i] = w[at.V_ALPHA + i] if w[at.W_ALPHA + i] == w[at.W_ALPHA + i] else NONE


@called
def _rest_of_beta(w: Any, count: int, s: Any) -> None:
    for i in range(count):
        g, a, b = w[at.G + i], w[at.A + i], w[at.B + i]
        s[X + i], s[Y_ + i] = g * w[at.S2 + i] / b, g * w[at.S1 + i] / a
    _first_kind(s, count)
    for i in range(count):
        w[at.W_BETA + i] = square_root(w[at.Z_MINUS + i] / w[at.B + i]) * s[X + i]
        w[at.V_BETA + i] = w[at.V_BETA + i] if w[at.W_BETA + i] == w[at.W_BETA + i] else NONE


@called
def _start(w: Any, count: int, s: Any) -> None:
    for i in range(count):
        d = pair(w, at.GAP + i)
        put(s, X + i, divide(pair(w, at.UPPER + i), d))
        put(s, Y_ + i, divide(pair(w, at.Y + i), pair(w, at.A + i)))
    _first_kind_sharply(s, count)
    for i in range(count):
        put(w, at.X0 + i, multiply(root_or_zero(divide(pair(w, at.LOWER + i), pair(w, at.GAP + i))), pair(s, X + i)))


@called
def integrals(w: Any, full: int, count: int, s: Any) -> None:
    """Put the places of the poles, and the start, into the store; NaN into the first of a top where one fails.

    Args:
        w: store of tops, those of the full form first; they alone need the distances of the poles from K'.
        full: how many these are.
        count: of all tops.
        s: STEPS rows.
    """
    _pole_of_alpha(w, count, s)
    _pole_of_beta(w, count, s)
    _rest_of_alpha(w, full, s)
    _rest_of_beta(w, full, s)
    _start(w, count, s)
