"""The turning points of a Lagrange top: the roots u1 ≤ u2 ≤ 1 ≤ u3 of u̇² = (α − βu)(1 − u²) − (b − au)².

One root stands apart from the other two. It is found by Newton's method in double-double, in a variable in which it is
large; the others follow from sums and products of roots without cancellation, whatever coincides. Source: Whittaker,
*Analytical Dynamics*, §71–73, for the cubic.
"""

from __future__ import annotations

from typing import Any, NamedTuple

from polhode.arrays import iterate, namespace
from polhode.exact.lagrange_top.reduction import Reduction
from polhode.special import doubledouble as dd
from polhode.special.doubledouble import DoubleDouble
from polhode.types import Array

SQUARABLE = -400  # binary exponent down to which a square has all its digits
NEWTON_STEPS = 5  # from the float64 root; three do, two more where float64 was poor


class TurningPoints(NamedTuple):
    """Distances between the roots, the poles u = ±1 and the start u0, each as a number of its own."""

    from_lower: DoubleDouble  # u0 − u1
    from_upper: DoubleDouble  # u2 − u0
    d: DoubleDouble  # u2 − u1
    s1: DoubleDouble  # 1 − u1
    s2: DoubleDouble  # 1 − u2
    t1: DoubleDouble  # 1 + u1
    t2: DoubleDouble  # 1 + u2
    A: DoubleDouble  # G (u3 − u1)
    B: DoubleDouble  # G (u3 − u2)
    Y: DoubleDouble  # G (u3 − u0)
    Z_minus: DoubleDouble  # G (u3 − 1)
    Z_plus: DoubleDouble  # G (u3 + 1)


def turning_points(top: Reduction) -> TurningPoints:
    """Return the turning points of reduced tops."""
    xp = namespace(top.reversed)
    G = top.G
    weightless = ~(G[0] > 0)
    safe = dd.where(weightless, dd.one_like(G[0]), G)
    p2, c2 = dd.square(top.p), dd.square(top.c)
    a = dd.from_float(top.momentum[2])
    f1 = dd.subtract(dd.scale(dd.multiply(a, top.twist), 2.0), dd.multiply(G, dd.multiply(top.s0, top.t0)))
    f1 = dd.subtract(f1, dd.scale(dd.multiply(top.u0, top.w2), 2.0))
    f2 = dd.subtract(dd.subtract(dd.scale(dd.multiply(G, top.u0), 2.0), top.w2), dd.square(a))
    of_Y = (f2, dd.multiply(G, f1), dd.multiply(dd.square(G), p2))
    of_s = (
        dd.negate(dd.divide(top.D, safe)), dd.scale(dd.divide(top.F, safe), -2.0), dd.divide(c2, safe),
    )  # fmt: skip
    Y, cosine = _largest_root(xp, *(v[0] for v in of_Y))
    s, _ = _largest_root(xp, *(v[0] for v in of_s))
    upper = (cosine >= 0) | weightless
    cubic = tuple(dd.where(upper, x, y) for x, y in zip(of_Y, of_s, strict=True))
    root = _polished(xp, xp.where(upper, Y, s), cubic)
    above = _upper_root_apart(top, p2, c2, f1, root)
    below = _lower_root_apart(top, p2, c2, safe, root)
    found = [dd.where(upper, x, y) for x, y in zip(above, below, strict=True)]
    from_lower, from_upper, d, s1, s2, A, B, Y, Z_minus = found
    t2 = dd.add(top.t0, from_upper)
    Z_plus = dd.add(Y, dd.multiply(G, top.t0))
    t1 = _quotient(dd.square(top.c_plus), dd.multiply(t2, Z_plus))
    return TurningPoints(from_lower, from_upper, d, s1, s2, t1, t2, A, B, Y, Z_minus, Z_plus)


def _largest_root(xp: Any, b: Array, c: Array, d: Array) -> tuple[Array, Array]:
    """Return the largest root of x³ + bx² + cx + d, whose roots are real, and cos 3φ of Viète's formula."""
    P, Q = c - b * b / 3.0, 2.0 * b**3 / 27.0 - b * c / 3.0 + d
    r = xp.sqrt(xp.maximum(-P / 3.0, 0.0 * P))
    positive = r > 0
    cosine = xp.where(positive, -0.5 * Q / xp.where(positive, r, 1.0) ** 3, 1.0)
    cosine = xp.minimum(xp.maximum(cosine, -1.0 + 0.0 * r), 1.0 + 0.0 * r)
    return 2.0 * r * xp.cos(xp.acos(cosine) / 3.0) - b / 3.0, cosine


def _polished(xp: Any, start: Array, cubic: tuple[DoubleDouble, ...]) -> DoubleDouble:
    b, c, d = cubic

    def step(x: DoubleDouble) -> DoubleDouble:
        value = dd.add(dd.multiply(dd.add(dd.multiply(dd.add(x, b), x), c), x), d)
        three = dd.scale(x, 2.0)
        slope = dd.add(dd.multiply(dd.add(dd.add(three, x), dd.scale(b, 2.0)), x), c)
        change = dd.divide(value, slope)
        return dd.where(xp.isfinite(change[0]), dd.subtract(x, change), x)

    return iterate(NEWTON_STEPS, step, dd.from_float(start), like=start)


def _quotient(x: DoubleDouble, y: DoubleDouble) -> DoubleDouble:
    """Return x / y, and zero for x = 0 whatever y."""
    zero = x[0] == 0
    return dd.where(zero, x, dd.divide(x, dd.where(zero, dd.one_like(x[0]), y)))


def _difference(sum_: DoubleDouble, product: DoubleDouble) -> DoubleDouble:
    """Return x + y = √((x − y)² + 4 x y), also where the square underflows."""
    xp = namespace(sum_[0])
    _, exponent = xp.frexp(sum_[0])
    _, of_product = xp.frexp(product[0])
    alone = (product[0] == 0) | (of_product < 2 * exponent)
    small = -xp.where((sum_[0] != 0) & (exponent < SQUARABLE) & alone, exponent, 0)
    up = xp.ldexp(xp.ones_like(sum_[0]), small)
    scaled, raised = dd.scale(sum_, up), dd.scale(dd.scale(product, up), up)
    return dd.scale(dd.sqrt(dd.add(dd.square(scaled), dd.scale(raised, 4.0))), xp.ldexp(xp.ones_like(up), -small))


def _larger_and_smaller(
    sum_: DoubleDouble, difference: DoubleDouble, product: DoubleDouble
) -> tuple[DoubleDouble, DoubleDouble]:
    """Return x ≥ 0 and y ≥ 0 from x − y, x + y and x y."""
    xp = namespace(sum_[0])
    positive = sum_[0] >= 0
    larger = dd.scale(dd.add(difference, dd.where(positive, sum_, dd.negate(sum_))), 0.5)
    smaller = dd.where(larger[0] > 0, _quotient(product, larger), dd.from_float(xp.zeros_like(larger[0])))
    return dd.where(positive, larger, smaller), dd.where(positive, smaller, larger)


def _upper_root_apart(
    top: Reduction, p2: DoubleDouble, c2: DoubleDouble, f1: DoubleDouble, Y: DoubleDouble
) -> tuple[DoubleDouble, ...]:
    """From Y = G (u3 − u0): with v = u − u0, v1 + v2 = (f1 + G p²/Y)/Y and v1 v2 = −p²/Y."""
    G = top.G
    product = _quotient(p2, Y)
    sum_ = _quotient(dd.add(f1, dd.multiply(G, product)), Y)
    d = _difference(sum_, product)
    from_upper, from_lower = _larger_and_smaller(sum_, d, product)
    s1 = dd.add(top.s0, from_lower)
    s2, Z = dd.subtract(top.s0, from_upper), dd.subtract(Y, dd.multiply(G, top.s0))
    Gs2 = dd.multiply(G, s2)
    take_Z = Z[0] >= Gs2[0]
    # s1 s2 Z = c²; of s2 and Z only the larger is an accurate difference
    s2, Z = (
        dd.where(take_Z, _quotient(c2, dd.multiply(s1, Z)), s2),
        dd.where(take_Z, Z, _quotient(c2, dd.multiply(s1, s2))),
    )
    A = dd.add(Y, dd.multiply(G, from_lower))
    B = dd.subtract(Y, dd.multiply(G, from_upper))
    return from_lower, from_upper, d, s1, s2, A, B, Y, Z


def _lower_root_apart(
    top: Reduction, p2: DoubleDouble, c2: DoubleDouble, G: DoubleDouble, s1: DoubleDouble
) -> tuple[DoubleDouble, ...]:
    """From s1 = 1 − u1: s2 + s3 = (c²/s1 − 2F)/(G s1) and s2 s3 = −c²/(G s1)."""
    G_s1 = dd.multiply(G, s1)
    product = _quotient(c2, G_s1)
    sum_ = dd.divide(dd.add(dd.scale(top.F, -2.0), _quotient(c2, s1)), G_s1)
    gap = _difference(sum_, product)
    s2, minus_s3 = _larger_and_smaller(sum_, gap, product)
    Z = dd.multiply(G, minus_s3)
    Y = dd.add(dd.multiply(G, top.s0), Z)
    upper, lower = dd.subtract(top.s0, s2), dd.subtract(s1, top.s0)
    other = _quotient(p2, Y)
    take_upper = upper[0] >= lower[0]
    from_upper = dd.where(take_upper, upper, _quotient(other, lower))
    from_lower = dd.where(take_upper, _quotient(other, upper), lower)
    A, B = dd.multiply(G, dd.add(s1, minus_s3)), dd.multiply(G, gap)
    return from_lower, from_upper, dd.subtract(s1, s2), s1, s2, A, B, Y, Z
