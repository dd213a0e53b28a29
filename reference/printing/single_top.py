"""Roots and integrals of a single top: formulas for printing, where arrays and kernels each have ways of their own.

The separate root is computed by Newton's method in double-double, in a variable in which it is large. Sources: Viète's
formula for its start; Carlson, Numer. Algorithms 10 (1995) 13, for the integrals.
"""

from __future__ import annotations

import math

from polhode.exact._kernel_arithmetic import (
    Pair,
    add,
    angle_of,
    choice,
    divide,
    iterate,
    larger,
    multiply,
    negation,
    root,
    root_or_zero,
    scale,
    smaller,
    square,
    square_root,
    subtract,
    where,
)
from polhode.exact.lagrange_top._formulas_rates import Frequencies
from polhode.exact.lagrange_top._formulas_roots import (
    ONE,
    ZERO,
    Cubic,
    Reduction,
    TurningPoints,
    cubics,
    turning_points_of,
)
from polhode.exact.lagrange_top._formulas_setup import Integrals

NEWTON_STEPS = 5  # from the root in single numbers; three do, two more where that was poor
DUPLICATIONS = 20  # nine halve the exponent of the smallest ratio, the others divide the spread by four
BEGIN, SLOPE, CURVE = 0.8660254, 0.1642, -0.0302  # of cos(⅓ acos x), 0 ≤ x ≤ 1, to 2e-4
Three = tuple[Pair, Pair, Pair]


def _largest_root(b: float, c: float, d: float) -> tuple[float, float]:
    """Return the largest root of x³ + bx² + cx + d, whose roots are real, if cos 3φ is not negative; and cos 3φ."""
    # Viète: x = 2r cos φ − b/3 with r = √(−P/3) and cos 3φ = −Q/2r³
    third = b / 3.0
    p, q = c - b * third, 2.0 * (third * third) * third - third * c + d
    r = square_root(larger(-p / 3.0, 0.0))
    cosine = where(r > 0.0, -0.5 * q / (r * r * r), 1.0)
    x = smaller(larger(cosine, 0.0), 1.0)
    # cos φ is a root of 4 y³ − 3 y = x
    y = BEGIN + x * (SLOPE + x * CURVE)
    y = (8.0 * y * y * y + x) / (12.0 * y * y - 3.0)
    y = (8.0 * y * y * y + x) / (12.0 * y * y - 3.0)
    return 2.0 * r * y - third, cosine


def _nearer(state: tuple[Pair, Cubic]) -> tuple[Pair, Cubic]:
    """Return a root after a step of Newton's."""
    x, cubic = state
    b, c, d = cubic
    value = add(multiply(add(multiply(add(x, b), x), c), x), d)
    slope = add(multiply(add(add(scale(x, 2.0), x), scale(b, 2.0)), x), c)
    change = divide(value, slope)
    is_finite = change[0] - change[0] == 0.0
    return choice(is_finite, subtract(x, change), x), cubic


def turning_points(top: Reduction) -> TurningPoints:
    """Return the turning points of a top."""
    weightless = negation(top.G[0] > 0.0)
    safe, p2, c2 = choice(weightless, ONE, top.G), square(top.p), square(top.c)
    f1, of_y, of_s = cubics(
        top.momentum[2], top.G, divide(ONE, safe), top.s0, top.t0, top.u0, top.w2, top.twist, p2, c2, top.D, top.F
    )
    y, cosine = _largest_root(of_y[0][0], of_y[1][0], of_y[2][0])
    s, _ = _largest_root(of_s[0][0], of_s[1][0], of_s[2][0])
    upper = (cosine >= 0.0) | weightless
    cubic = (
        choice(upper, of_y[0], of_s[0]), choice(upper, of_y[1], of_s[1]), choice(upper, of_y[2], of_s[2]),
    )  # fmt: skip
    lone, _ = iterate(NEWTON_STEPS, _nearer, ((where(upper, y, s), 0.0), cubic))
    return turning_points_of(upper, lone, top.G, safe, top.s0, top.t0, p2, c2, top.c_plus, top.F, f1)


# ---------------------------------------------------------------------- integrals of the first kind


def _duplicated(state: Three) -> Three:
    # R_F(a, b, c) = R_F((a+λ)/4, (b+λ)/4, (c+λ)/4), λ = √a√b + √b√c + √c√a (DLMF §19.26(iii))
    a, b, c = state
    u, v, w = root_or_zero(a), root_or_zero(b), root_or_zero(c)
    more = add(add(multiply(u, v), multiply(v, w)), multiply(w, u))
    return scale(add(a, more), 0.25), scale(add(b, more), 0.25), scale(add(c, more), 0.25)


def first_kind(x: Pair, y: Pair) -> Pair:
    """Return R_F(x, y, 1) for x, y ≥ 0, not both zero."""
    a, b, c = iterate(DUPLICATIONS, _duplicated, (x, y, ONE))
    # DLMF 19.36.1 in X = 1 − a/mean, …, with X + Y + Z = 0. After the steps |X| < 1e-7 even where x = 0 and y = 1e-300,
    # so that order 5 is enough, and the correction, below 1e-15, needs no second number
    mean = divide(add(add(a, b), c), (3.0, 0.0))
    X, Y = subtract(ONE, divide(a, mean))[0], subtract(ONE, divide(b, mean))[0]
    Z = -X - Y
    E2, E3 = X * Y - Z * Z, X * Y * Z
    closing = -E2 / 10.0 + E3 / 14.0 + E2 * E2 / 24.0 - 3.0 * E2 * E3 / 44.0
    return divide(add(ONE, (closing, 0.0)), root(mean))


def _integral(idle: bool, factor: Pair, x: Pair, y: Pair) -> Pair:
    """Return √factor R_F(x, y, 1), and √factor where the integral is not used."""
    total = x[0] + y[0]
    bad = idle | negation(total > 0.0) | negation(total - total == 0.0)
    return multiply(root_or_zero(factor), first_kind(choice(bad, ONE, x), choice(bad, ONE, y)))


def integrals(top: Reduction, points: TurningPoints, rates: Frequencies) -> Integrals:
    """Return the distances of α's and β's poles from the real axis, what they leave of K', and that of the start."""
    g, d, a, b, z_plus, z_minus = top.G, points.d, points.A, points.B, points.Z_plus, points.Z_minus
    s1, s2, t1, t2 = points.s1, points.s2, points.t1, points.t2
    idle = rates.permanent | rates.steady
    v_alpha = _integral(idle, divide(t1, t2), divide(d, t2), divide(multiply(d, z_plus), multiply(a, t2)))[0]
    s1b = multiply(s1, b)
    v_beta = _integral(idle, divide(multiply(s2, a), s1b), divide(multiply(d, z_minus), s1b), divide(d, s1))[0]
    w_alpha = _integral(idle, divide(a, z_plus), divide(multiply(g, t1), z_plus), divide(multiply(g, t2), z_plus))
    w_beta = _integral(idle, divide(z_minus, b), divide(multiply(g, s2), b), divide(multiply(g, s1), a))
    x0 = _integral(idle, divide(points.from_lower, d), divide(points.from_upper, d), divide(points.Y, a))
    v_alpha = where(rates.separatrix, angle_of(square_root(t1[0]), square_root(d[0])), v_alpha)
    v_beta = where(rates.separatrix | (s2[0] == 0.0), 0.0, v_beta)
    # where the tilt stays the pole is infinitely far
    v_alpha = where(rates.steady, math.inf, where(rates.permanent, 0.0, v_alpha))
    v_beta = where(rates.steady, math.inf, where(rates.permanent, 0.0, v_beta))
    return Integrals(v_alpha, v_beta, w_alpha[0], w_beta[0], choice(idle & negation(d[0] > 0.0), ZERO, x0))
