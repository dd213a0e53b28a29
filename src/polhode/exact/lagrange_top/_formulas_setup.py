"""From a top's invariants to the constants of its motion: turning points, rates, theta series and phases.

The invariants are those of ``reduction``; pairs are double-double. The turning points are the roots u1 ≤ u2 ≤ 1 ≤ u3 of
u̇² = (α − βu)(1 − u²) − (b − au)². One of them is well separated from the other two, which follow from sums and products
of roots without cancellation, whatever coincides. Source: Whittaker, *Analytical Dynamics*, §71–73, for the cubic.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from polhode.exact._formulas import by_theta
from polhode.exact._kernel_arithmetic import (
    Pair,
    add,
    choice,
    constant,
    divide,
    multiply,
    multiply_float,
    root,
    root_or_zero,
    scale,
    sine_cosine,
    square,
    square_root,
    subtract,
    two_square,
    two_sum,
    where,
    whole,
)
from polhode.exact.lagrange_top._formulas import Four, Sums
from polhode.special._doubledouble import INVERSE_TWO_PI, PI

ONE, ZERO = (1.0, 0.0), (0.0, 0.0)
Three = tuple[float, float, float]
Cubic = tuple[Pair, Pair, Pair]


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
    """Return x + y = √((x − y)² + 4 x y)."""
    return root_or_zero(add(square(total), scale(product, 4.0)))


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


# ---------------------------------------------------------------------- rates


def start_of_alpha(first: bool, a: Pair, z_plus: Pair, t1: Pair, t2: Pair) -> Pair:
    """Return p² at the start of the sum of α; ``first`` says that it takes the form that starts from Z."""
    return choice(first, z_plus, divide(multiply(a, t2), choice(first, constant(ONE, t1[0]), t1)))


def start_of_beta(first: bool, c: Pair, a: Pair, b: Pair, z_minus: Pair, s1: Pair, s2: Pair) -> Pair:
    """Return p² of the sum of β. Where c = 0 the factor of the sum vanishes, and p² must only not be zero."""
    other = divide(multiply(s1, b), choice(first, constant(ONE, s2[0]), s2))
    return choice(first, choice(c[0] == 0.0, a, z_minus), other)


def drift(first: bool, c: Pair, g: Pair, z: Pair, near: Pair, far: Pair, d: Pair, nutation: Pair, total: Pair) -> Pair:
    """Return cG/(4Z) Σ in the first form, |c|/(2 near) [1 − d/(2 far) Σ] − ϖ in the second."""
    idle = c[0] == 0.0
    ratio = divide(choice(first, multiply(c, g), c), choice(idle, ONE, choice(first, z, near)))
    share = subtract(constant(ONE, c[0]), scale(multiply(divide(d, far), total), 0.5))
    return choice(
        first, scale(multiply(ratio, total), 0.25), subtract(multiply(scale(ratio, 0.5), share), nutation)
    )


def spin(i1: float, i3: float, axial: float) -> Pair:
    """Return ν I1, the spin that I3 ≠ I1 adds, by τ."""
    return divide(multiply_float(two_sum(i1, -i3), axial), (i3, 0.0))


def turns_per_time(rate: Pair, i1: float, rate_scale: float) -> Pair:
    """Return a rate by τ as turns per time."""
    inverse = divide(constant(INVERSE_TWO_PI, i1), (i1, 0.0))
    return multiply(rate, scale(inverse, rate_scale))


def half_periods(nutation: Pair, i1: float, rate_scale: float) -> Pair:
    """Return the rate of x/2K [half periods per time]."""
    return divide(scale(nutation, rate_scale), multiply_float(constant(PI, i1), i1))


def periods(half_root: Pair, nutation: Pair, nome: float) -> tuple[Pair, Pair]:
    """Return K and πK/K', of the nome of the smaller parameter."""
    quarter = divide(scale(multiply(half_root, constant(PI, nome)), 0.5), nutation)
    return quarter, by_theta(scale(quarter, 2.0), nome)


# ---------------------------------------------------------------------- series


def full_terms(size: float, h: float, q: float, r: float, alternating: float) -> tuple[Four, Four]:
    """Return sums and differences of the coefficients of e^{±ikz}, k = 1, 3, 5, 7."""
    w1, w2, w3 = q * r, q * q * r, q * q * q * r
    w2, w3 = w2 * w2, w3 * w3 * w3
    h3 = h * h * h
    h5, h7 = h3 * h * h, h3 * h3 * h
    size = size / (((w3 * (1.0 + h7) + w2 * (1.0 + h5)) + w1 * (1.0 + h3)) + (1.0 + h))
    w1, w2, w3 = alternating * size * w1, size * w2, alternating * size * w3
    return (
        (size * (1.0 + h), w1 * (1.0 + h3), w2 * (1.0 + h5), w3 * (1.0 + h7)),
        (size * (1.0 - h), w1 * (1.0 - h3), w2 * (1.0 - h5), w3 * (1.0 - h7)),
    )


def full_sizes(root_t: float, root_s: float, q: float, theta3: float) -> Pair:
    """Return √t θ3 and √s θ4."""
    q4 = (q * q) * (q * q)
    return root_t * theta3, root_s * (1.0 - 2.0 * (q - q4 + q4 * q4 * q))


def _multiples(y: float) -> tuple[Four, Four]:
    """Return cos ky and sin ky for k = 1 to 4 of 0 ≤ y ≤ π."""
    s1, c1 = sine_cosine(y * (0.5 / math.pi))
    s2, c2 = 2.0 * s1 * c1, 1.0 - 2.0 * s1 * s1
    return (c1, c2, c2 * c1 - s2 * s1, 1.0 - 2.0 * s2 * s2), (s1, s2, s2 * c1 + c2 * s1, 2.0 * s2 * c2)


def complementary_series(
    root_t: float, root_s: float, q: float, theta3: float, y_alpha: float, y_beta: float
) -> tuple[Four, Four, Four, Four, float]:
    """Return A's factors of sin ky and cos ky, k = 1, 3, 5, 7, B's of cos and sin of 2, 4, 6, 8 y, and its constant."""
    q2 = q * q
    q4, q6 = q2 * q2, q2 * q2 * q2
    q9 = q6 * q2 * q
    c, s = _multiples(y_alpha)
    theta4 = 1.0 - 2.0 * ((q * c[1] - q4 * c[3]) + q9 * (2.0 * c[2] * c[2] - 1.0))
    size = root_t * theta3 / theta4
    c5, s5 = c[3] * c[0] - s[3] * s[0], s[3] * c[0] + c[3] * s[0]
    c7, s7 = c[3] * c[2] - s[3] * s[2], s[3] * c[2] + c[3] * s[2]
    a_sine, a_cosine = (size * s[0], -size * s[2], size * s5, -size * s7), (
        size * c[0], -size * c[2], size * c5, -size * c7)  # fmt: skip
    c, s = _multiples(2.0 * y_beta)
    theta4 = 1.0 - 2.0 * ((q * c[0] - q4 * c[1]) + q9 * c[2])
    size = root_s * (1.0 + q2 + q6 + q6 * q6) / theta4
    return (
        a_sine, a_cosine, (-size * c[0], size * c[1], -size * c[2], size * c[3]),
        (-size * s[0], size * s[1], -size * s[2], size * s[3]), size,
    )  # fmt: skip


# ---------------------------------------------------------------------- phases


def _constant_phase(
    r: float, i: float, dr: float, di: float, turns: float, rate: float, component: Pair, slope: Pair, norm: float,
    drop: float, turn: float, size: float,
) -> Pair:
    """Return cos and sin of the phase that turns A or B at the epoch into the given α or β.

    Where one of them vanishes its own phase says nothing; its derivative then does, so both are used.
    """
    r, i = r / norm, i / norm
    sr = turn * (dr / norm - r * drop) - rate * i
    si = turn * (di / norm - i * drop) + rate * r
    (gr, gi), (er, ei) = component, slope
    real = (r * gr + i * gi) + (sr * er + si * ei) / size
    imaginary = (r * gi - i * gr) + (sr * ei - si * er) / size
    s, c = sine_cosine(turns - whole(turns))
    real, imaginary = real * c + imaginary * s, imaginary * c - real * s
    length = square_root(real * real + imaginary * imaginary)
    some = length > 0.0
    safe = where(some, length, 1.0)
    return where(some, real / safe, 1.0), where(some, imaginary / safe, 0.0)


def constant_phases(
    quaternion: Four, norm2: Pair, momentum: Three, size: float, sums: Sums, linear: Pair, turn: float
) -> Four:
    """Return cos and sin of the phases that turn A and B at the epoch into the given α and β.

    Args:
        quaternion, norm2: at the epoch, and its |q|².
        momentum: at the epoch.
        size: |L|² + G, by which derivatives count.
        sums: at the epoch.
        linear: derivatives by τ of the phases that evaluation adds to A and B.
        turn: dz/dτ or dx'/dτ.
    """
    x, y, z = momentum
    length = root(norm2)
    q0, q1 = divide((quaternion[0], 0.0), length)[0], divide((quaternion[1], 0.0), length)[0]
    q2, q3 = divide((quaternion[2], 0.0), length)[0], divide((quaternion[3], 0.0), length)[0]
    # 2α' = i a α − w̄ β, 2β' = w α − i a β
    a = 0.5 * (-z * q3 - (x * q1 + y * q2)), 0.5 * (z * q0 - (x * q2 - y * q1))
    b = 0.5 * (x * q0 - y * q3 + z * q2), 0.5 * (x * q3 + y * q0 - z * q1)
    ar, ai, br, bi, dar, dai, dbr, dbi, turns_a, turns_b = sums
    length2 = (ar * ar + ai * ai) + (br * br + bi * bi)
    norm = square_root(length2)
    drop = ((ar * dar + ai * dai) + (br * dbr + bi * dbi)) / length2
    c0, s0 = _constant_phase(ar, ai, dar, dai, turns_a, linear[0], (q0, q3), a, norm, drop, turn, size)
    c1, s1 = _constant_phase(br, bi, dbr, dbi, turns_b, linear[1], (q1, q2), b, norm, drop, turn, size)
    return c0, s0, c1, s1
