"""Turning points of a single top: formulas for printing, where arrays and kernels each have ways of their own.

The separate root is computed by Newton's method in double-double, in a variable in which it is large. Source: Viète's
formula for its start.
"""

from __future__ import annotations

from polhode.exact._kernel_arithmetic import (
    Pair,
    add,
    choice,
    divide,
    iterate,
    larger,
    multiply,
    negation,
    scale,
    smaller,
    square,
    square_root,
    subtract,
    where,
)
from polhode.exact.lagrange_top._formulas_roots import (
    ONE,
    Cubic,
    Reduction,
    TurningPoints,
    cubics,
    turning_points_of,
)

NEWTON_STEPS = 5  # from the root in single numbers; three do, two more where that was poor
BEGIN, SLOPE, CURVE = 0.8660254, 0.1642, -0.0302  # of cos(⅓ acos x), 0 ≤ x ≤ 1, to 2e-4


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
