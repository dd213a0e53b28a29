"""The invariants of a top, and its turning points: the roots u1 ≤ u2 ≤ 1 ≤ u3 of u̇² = (α − βu)(1 − u²) − (b − au)².

The invariants are those of ``reduction``; pairs are double-double. One of the roots is well separated from the other
two, which follow from sums and products of roots without cancellation, whatever coincides. Source: Whittaker,
*Analytical Dynamics*, §71–73, for the cubic.
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
    divide,
    multiply,
    multiply_float,
    root_or_zero,
    scale,
    square,
    subtract,
    times_power,
    two_square,
    where,
)
from polhode.exact.lagrange_top._formulas import Four

SQUARABLE = -400.0  # binary exponent down to which a square has all its digits
ONE, ZERO = (1.0, 0.0), (0.0, 0.0)
Three = tuple[Number, Number, Number]
Cubic = tuple[Pair, Pair, Pair]


class Reduction(NamedTuple):
    """A top with mgl ≥ 0, scaled by powers of two; pairs are double-double.

    u = cos θ, s = 1 − u, t = 1 + u, index 0 at the epoch; dots are derivatives by τ.
    """

    moments: tuple[Number, Number]  # I1, I3
    momentum: Three  # with the displacement scaled up by 2^lift
    quaternion: Four  # not normalised; likewise
    reversed: Truth  # whether the axis was reversed
    lift: Number  # binary exponent of the displacement's scale, 0 for most tops
    momentum_scale: Number  # powers of two taken out
    rate_scale: Number
    size: Pair  # |q|² as given
    G: Pair
    s0: Pair
    t0: Pair
    u0: Pair
    p: Pair  # u̇ at the epoch
    c: Pair  # p_φ − L3
    c_plus: Pair  # p_φ + L3
    twist: Pair  # p_φ − u L3 at the epoch
    F: Pair  # |w|² − G s − a c
    D: Pair  # 2G − a² − |w|² + G s
    w2: Pair  # |w|² at the epoch
    lean: Pair  # a (|w|² − G s) − G c: its sign against a's tells loops from waves


def is_upright(top: Reduction) -> bool:
    """Return whether the axis points up rather than down at the epoch."""
    return top.s0[0] < top.t0[0]


def leaves(top: Reduction) -> bool:
    """Return whether the displacement was scaled up and grows."""
    return (top.lift > 0.0) & is_upright(top) & (top.D[0] > 0.0)


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


# ---------------------------------------------------------------------- turning points


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
    larger = scale(add(sum_, choice(positive, total, (-total[0], -total[1]))), 0.5)
    smaller = choice(larger[0] > 0.0, quotient(product, larger), ZERO)
    return choice(positive, larger, smaller), choice(positive, smaller, larger)


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


def turning_points_of(
    is_upper: bool, lone_root: Pair, g: Pair, safe: Pair, s0: Pair, t0: Pair, p2: Pair, c2: Pair, c_plus: Pair, f: Pair,
    f1: Pair,
) -> TurningPoints:
    """Return the turning points from the separate root, Y or else s1; ``safe`` is G, where it is positive."""
    x = _upper_root_apart(g, s0, p2, c2, f1, lone_root)
    y = _lower_root_apart(safe, s0, p2, c2, f, lone_root)
    upper, apart = choice(is_upper, x[1], y[1]), choice(is_upper, x[7], y[7])
    t2, z = add(t0, upper), add(apart, multiply(g, t0))
    return TurningPoints(
        choice(is_upper, x[0], y[0]), upper, choice(is_upper, x[2], y[2]), choice(is_upper, x[3], y[3]),
        choice(is_upper, x[4], y[4]), quotient(square(c_plus), multiply(t2, z)), t2, choice(is_upper, x[5], y[5]),
        choice(is_upper, x[6], y[6]), apart, choice(is_upper, x[8], y[8]), z,
    )
