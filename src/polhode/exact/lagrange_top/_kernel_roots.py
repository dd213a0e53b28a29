"""The steps of ``roots`` for a block of tops, compiled by Numba."""

from __future__ import annotations

from typing import Any

from polhode._base.compiled.copying import called
from polhode.exact._kernel_arithmetic import (
    Pair,
    add,
    choice,
    divide,
    multiply,
    pair,
    put,
    put_record,
    square,
    square_root,
)
from polhode.exact.lagrange_top import _kernel_store as at
from polhode.exact.lagrange_top._formulas_roots import cubics, turning_points_of

CONVERGED = 2.0**-60  # of the last change over the root: what is left is smaller by a float64's precision
ONE = (1.0, 0.0)
BEGIN, SLOPE, CURVE = 0.8660254, 0.1642, -0.0302  # of cos(⅓ acos x), 0 ≤ x ≤ 1, to 2e-4


def _sharp_root(b: float, c: float, d: float) -> tuple[float, float, float]:
    """Return b/3, r and cos 3φ of Viète's formula for x³ + bx² + cx + d, ``roots._largest_root``."""
    third = b / 3.0
    P, Q = c - b * third, 2.0 * (third * third) * third - third * c + d
    r = square_root(max(-P / 3.0, 0.0))
    cosine = -0.5 * Q / (r * r * r) if r > 0.0 else 1.0
    return third, r, min(max(cosine, -1.0), 1.0)


def _polished(x: Pair, b: Pair, c: Pair, d: Pair) -> tuple[Pair, float]:
    """Return the root after a step of Newton's, whose slope need not be sharp, and the change."""
    value = add(multiply(add(multiply(add(x, b), x), c), x), d)
    slope = (3.0 * x[0] + 2.0 * b[0]) * x[0] + c[0]
    change = -value[0] / slope
    return add(x, (change, 0.0)), change


@called
def _apart(w: Any, count: int) -> None:
    """Put the root that stands apart into Y; UP says whether it is the upper one, or that it has not been found."""
    for i in range(count):
        g, c2, p2 = pair(w, at.G + i), square(pair(w, at.C + i)), square(pair(w, at.P + i))
        f1, of_y, of_s = cubics(
            w[at.L3 + i], g, divide(ONE, g), pair(w, at.S0 + i), pair(w, at.T0 + i), pair(w, at.U0 + i),
            pair(w, at.W2 + i), pair(w, at.TWIST + i), p2, c2, pair(w, at.D + i), pair(w, at.F + i),
        )
        third, r, cosine = _sharp_root(of_y[0][0], of_y[1][0], of_y[2][0])
        other_third, other_r, other = _sharp_root(of_s[0][0], of_s[1][0], of_s[2][0])
        upper = cosine >= 0.0
        x = cosine if upper else max(other, 0.0)
        y = BEGIN + x * (SLOPE + x * CURVE)
        y = (8.0 * y * y * y + x) / (12.0 * y * y - 3.0)
        y = (8.0 * y * y * y + x) / (12.0 * y * y - 3.0)
        start = 2.0 * (r if upper else other_r) * y - (third if upper else other_third)
        b, c, d = choice(upper, of_y[0], of_s[0]), choice(upper, of_y[1], of_s[1]), choice(upper, of_y[2], of_s[2])
        root, _ = _polished((start, 0.0), b, c, d)
        root, change = _polished(root, b, c, d)
        good = (root[0] > 0.0) & (abs(change) <= CONVERGED * root[0])
        w[at.UP + i] = (1.0 if upper else 0.0) if (w[at.UP + i] == 0.0) & good else -1.0
        put(w, at.Y + i, root)
        put(w, at.A + i, f1)


@called
def _points(w: Any, count: int) -> None:
    """Put the turning points into the store."""
    for i in range(count):
        g = pair(w, at.G + i)
        p = turning_points_of(
            w[at.UP + i] > 0.0, pair(w, at.Y + i), g, g, pair(w, at.S0 + i), pair(w, at.T0 + i),
            square(pair(w, at.P + i)), square(pair(w, at.C + i)), pair(w, at.C_PLUS + i), pair(w, at.F + i),
            pair(w, at.A + i),
        )
        put_record(w, at.POINTS + i, p)


@called
def turning_points(w: Any, count: int) -> None:
    """Put ``roots.turning_points`` into the store; where UP is below zero they are left to NumPy."""
    _apart(w, count)
    _points(w, count)
