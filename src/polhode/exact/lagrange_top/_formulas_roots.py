"""The turning points of a top: the roots u1 ≤ u2 ≤ 1 ≤ u3 of u̇² = (α − βu)(1 − u²) − (b − au)².

One of the roots is well separated from the other two. It is computed by Newton's method in double-double, in a variable
in which it is large; the others follow from sums and products of roots without cancellation, whatever coincides.
Sources: Whittaker, *Analytical Dynamics*, §71–73, for the cubic; Viète for the start.
"""

from __future__ import annotations

from typing import NamedTuple

from polhode.exact._kernel_arithmetic import (
    Number,
    Pair,
    Truth,
    add,
    binary_exponent,
    choice,
    constant,
    divide,
    iterate_until,
    larger,
    multiply,
    multiply_float,
    negation,
    root_or_zero,
    scale,
    smaller,
    square,
    square_root,
    subtract,
    times_power,
    two_square,
    where,
)
from polhode.exact.lagrange_top._formulas_reduction import ONE, ZERO, Reduction, Three

SQUARABLE = -400.0  # binary exponent down to which a square has all its digits
BEGIN, SLOPE, CURVE = 0.8660254, 0.1642, -0.0302  # of cos(⅓ acos x), 0 ≤ x ≤ 1, to 2e-4
AT_ONCE, MOST = 2, 5  # steps of Newton's, of all and of any: two do, three more where the start was poor
CONVERGED = 2.0**-60  # of the last change over the root: what is left is smaller by a float64's precision
Cubic = tuple[Pair, Pair, Pair]
Root = tuple[Pair, Number, Cubic]  # with the last change, and of which cubic


class TurningPoints(NamedTuple):
    """Distances between the roots, the poles u = ±1 and the start u0, each as a number of its own."""

    from_lower: Pair  # u0 − u1
    from_upper: Pair  # u2 − u0
    d: Pair  # u2 − u1
    s1: Pair  # 1 − u1
    s2: Pair  # 1 − u2
    t1: Pair  # 1 + u1
    t2: Pair  # 1 + u2
    A: Pair  # G (u3 − u1)
    B: Pair  # G (u3 − u2)
    Y: Pair  # G (u3 − u0)
    Z_minus: Pair  # G (u3 − 1)
    Z_plus: Pair  # G (u3 + 1)


class Apart(NamedTuple):
    """The cubic whose largest root stands apart from the others."""

    upper: Truth  # whether it is that of Y, and the root u3, or that of s, and the root u1
    cubic: Cubic
    start: Number  # near the root
    f1: Pair


# ---------------------------------------------------------------------- the separate root


def cubics(
    axial: float, g: Pair, inverse: Pair, s0: Pair, t0: Pair, u0: Pair, w2: Pair, twist: Pair, p2: Pair, c2: Pair,
    d: Pair, f: Pair,
) -> tuple[Pair, Cubic, Cubic]:
    """Return f1, and the cubics x³ + bx² + cx + d of Y = G (u3 − u0) and of s = 1 − u1; ``inverse`` is 1/G."""
    # with v = u − u0 and the |w|² of the start, u̇² = (1 − u²)(|w|² − G v) − (b − a u)² = p² + f1 v + f2 v² + G v³,
    # and with s = 1 − u it is −(G s³ − D s² − 2F s + c²)
    f1 = subtract(scale(multiply_float(twist, axial), 2.0), multiply(g, multiply(s0, t0)))
    f1 = subtract(f1, scale(multiply(u0, w2), 2.0))
    f2 = subtract(subtract(scale(multiply(g, u0), 2.0), w2), two_square(axial))
    d, f = multiply(d, inverse), multiply(f, inverse)
    return f1, (f2, multiply(g, f1), multiply(square(g), p2)), ((-d[0], -d[1]), scale(f, -2.0), multiply(c2, inverse))


def _by_angle(cubic: Cubic) -> Three:
    """Return b/3, r and cos 3φ of a cubic with real roots, of which 2r cos φ − b/3 is the largest."""
    # x = 2r cos φ − b/3 with r = √(−P/3) and cos 3φ = −Q/2r³
    b, c, d = cubic[0][0], cubic[1][0], cubic[2][0]
    third = b / 3.0
    p, q = c - b * third, 2.0 * (third * third) * third - third * c + d
    r = square_root(larger(-p / 3.0, 0.0 * p))
    return third, r, where(r > 0.0, -0.5 * q / where(r > 0.0, r * r * r, 1.0), 1.0)


def apart(top: Reduction) -> Apart:
    """Return the cubic whose largest root stands apart."""
    weightless, one = negation(top.G[0] > 0.0), constant(ONE, top.G[0])
    f1, of_y, of_s = cubics(
        top.momentum[2], top.G, divide(one, choice(weightless, one, top.G)), top.s0, top.t0, top.u0, top.w2, top.twist,
        square(top.p), square(top.c), top.D, top.F,
    )  # fmt: skip
    third, r, cosine = _by_angle(of_y)
    other_third, other_r, other = _by_angle(of_s)
    upper = (cosine >= 0.0) | weightless
    x = where(upper, cosine, other)
    x = smaller(larger(x, 0.0 * x), 1.0 + 0.0 * x)
    # cos φ is a root of 4 y³ − 3 y = x
    y = BEGIN + x * (SLOPE + x * CURVE)
    y = (8.0 * y * y * y + x) / (12.0 * y * y - 3.0)
    y = (8.0 * y * y * y + x) / (12.0 * y * y - 3.0)
    cubic = choice(upper, of_y[0], of_s[0]), choice(upper, of_y[1], of_s[1]), choice(upper, of_y[2], of_s[2])
    return Apart(upper, cubic, 2.0 * where(upper, r, other_r) * y - where(upper, third, other_third), f1)


def begun(lone: Apart) -> Root:
    """Return the root before the first step."""
    return (lone.start, 0.0 * lone.start), lone.start, lone.cubic


def nearer(root: Root) -> Root:
    """Return a root after a step of Newton's, whose slope need not be sharp."""
    x, _, cubic = root
    b, c, d = cubic
    value = add(multiply(add(multiply(add(x, b), x), c), x), d)
    change = -value[0] / ((3.0 * x[0] + 2.0 * b[0]) * x[0] + c[0])
    change = where(change - change == 0.0, change, 0.0)
    return add(x, (change, 0.0 * change)), change, cubic


def is_found(root: Root) -> bool:
    """Return whether the last change leaves nothing to be changed."""
    x, change, _ = root
    return (x[0] > 0.0) & (abs(change) <= CONVERGED * x[0])


# ---------------------------------------------------------------------- turning points


def quotient(x: Pair, y: Pair) -> Pair:
    """Return x / y, and zero for x = 0 whatever y."""
    zero = x[0] == 0.0
    return choice(zero, x, divide(x, choice(zero, ONE, y)))


def difference(total: Pair, product: Pair) -> Pair:
    """Return x + y = √((x − y)² + 4 x y), also where the square underflows."""
    exponent = binary_exponent(total[0])
    alone = (product[0] == 0.0) | (binary_exponent(product[0]) < 2.0 * exponent)
    power = where((total[0] != 0.0) & (exponent < SQUARABLE) & alone, -exponent, 0.0)
    up = times_power(1.0, power)
    raised = scale(scale(product, up), up)
    return scale(root_or_zero(add(square(scale(total, up)), scale(raised, 4.0))), times_power(1.0, -power))


def _larger_and_smaller(total: Pair, sum_: Pair, product: Pair) -> tuple[Pair, Pair]:
    """Return x ≥ 0 and y ≥ 0 from x − y, x + y and x y."""
    positive = total[0] >= 0.0
    most = scale(add(sum_, choice(positive, total, (-total[0], -total[1]))), 0.5)
    least = choice(most[0] > 0.0, quotient(product, most), ZERO)
    return choice(positive, most, least), choice(positive, least, most)


def _upper_root_apart(g: Pair, s0: Pair, p2: Pair, c2: Pair, f1: Pair, y: Pair) -> tuple[Pair, ...]:
    """From Y = G (u3 − u0): with v = u − u0, v1 + v2 = (f1 + G p²/Y)/Y and v1 v2 = −p²/Y."""
    product = quotient(p2, y)
    total = quotient(add(f1, multiply(g, product)), y)
    gap = difference(total, product)
    upper, lower = _larger_and_smaller(total, gap, product)
    s1, s2, z = add(s0, lower), subtract(s0, upper), subtract(y, multiply(g, s0))
    # s1 s2 Z = c²; of s2 and Z only the larger is an accurate difference
    take = z[0] >= multiply(g, s2)[0]
    other = quotient(c2, multiply(s1, choice(take, z, s2)))
    s2, z = choice(take, other, s2), choice(take, z, other)
    return lower, upper, gap, s1, s2, add(y, multiply(g, lower)), subtract(y, multiply(g, upper)), y, z


def _lower_root_apart(g: Pair, s0: Pair, p2: Pair, c2: Pair, f: Pair, s1: Pair) -> tuple[Pair, ...]:
    """From s1 = 1 − u1: s2 + s3 = (c²/s1 − 2F)/(G s1) and s2 s3 = −c²/(G s1)."""
    gs = multiply(g, s1)
    product = quotient(c2, gs)
    total = divide(add(scale(f, -2.0), quotient(c2, s1)), gs)
    between = difference(total, product)
    s2, minus_s3 = _larger_and_smaller(total, between, product)
    z = multiply(g, minus_s3)
    y = add(multiply(g, s0), z)
    upper, lower = subtract(s0, s2), subtract(s1, s0)
    take = upper[0] >= lower[0]
    other = quotient(quotient(p2, y), choice(take, upper, lower))
    upper, lower = choice(take, upper, other), choice(take, other, lower)
    return lower, upper, subtract(s1, s2), s1, s2, multiply(g, add(s1, minus_s3)), multiply(g, between), y, z


def turning_points_of(top: Reduction, is_upper: bool, lone: Pair, f1: Pair) -> TurningPoints:
    """Return the turning points from the separate root, Y or else s1."""
    g, s0, t0, p2, c2 = top.G, top.s0, top.t0, square(top.p), square(top.c)
    x = _upper_root_apart(g, s0, p2, c2, f1, lone)
    y = _lower_root_apart(choice(g[0] > 0.0, g, constant(ONE, g[0])), s0, p2, c2, top.F, lone)
    upper, above = choice(is_upper, x[1], y[1]), choice(is_upper, x[7], y[7])
    t2, z = add(t0, upper), add(above, multiply(g, t0))
    return TurningPoints(
        choice(is_upper, x[0], y[0]), upper, choice(is_upper, x[2], y[2]), choice(is_upper, x[3], y[3]),
        choice(is_upper, x[4], y[4]), quotient(square(top.c_plus), multiply(t2, z)), t2, choice(is_upper, x[5], y[5]),
        choice(is_upper, x[6], y[6]), above, choice(is_upper, x[8], y[8]), z,
    )


def turning_points(top: Reduction) -> TurningPoints:
    """Return the turning points of a top."""
    lone = apart(top)
    root, _, _ = iterate_until(nearer, is_found, begun(lone), AT_ONCE, MOST)
    return turning_points_of(top, lone.upper, root, lone.f1)
