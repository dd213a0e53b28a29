"""From a body to the constants of its motion: invariants, rates, and the arguments of the theta functions.

A, B, C, P, Q and S are those of ``reduction``; pairs are double-double. The arguments come by descending Landen
transformation from tangents and hyperbolic sines that are ratios of the invariants, so neither elliptic integrals nor
logarithms enter the full form.
"""

from __future__ import annotations

import math

from polhode.exact._formulas import by_theta, nome_per_parameter
from polhode.exact._kernel_arithmetic import (
    Pair,
    add,
    choice,
    constant,
    divide,
    multiply,
    multiply_float,
    root,
    scale,
    sine_cosine,
    square_root,
    subtract,
    two_product,
    two_square,
    two_sum,
    where,
    whole,
)
from polhode.exact.free_body._formulas import Ten
from polhode.special._doubledouble import INVERSE_TWO_PI, PI

Three = tuple[float, float, float]


def invariants(moments: Three, momentum: Three) -> tuple[Pair, Pair, Pair, Pair, Pair, Pair]:
    """Return A, B, C, P, Q and |L|² before the mirror, each a sum of terms of one sign."""
    i1, i2, i3 = moments
    x, y, z = momentum
    a = multiply_float(two_sum(i2, -i1), i3)
    b = multiply_float(two_sum(i3, -i2), i1)
    c = multiply_float(two_sum(i3, -i1), i2)
    s1, s2, s3 = two_square(x), two_square(y), two_square(z)
    p, q = add(multiply(c, s1), multiply(b, s2)), add(multiply(a, s2), multiply(c, s3))
    return a, b, c, p, q, add(add(s1, s2), s3)


def difference(a: Pair, b: Pair, x: float, z: float) -> tuple[Pair, float]:
    """Return S = A L1² − B L3² in double-double, and the size of its first term."""
    first = multiply(a, two_square(x))
    return subtract(first, multiply(b, two_square(z))), first[0]


# ---------------------------------------------------------------------- rates


def starts_of_mean(a: Pair, b: Pair, c: Pair, q: Pair, gg: Pair, root_s: Pair) -> tuple[Pair, Pair, Pair]:
    """Return √(BQ), √(−CS) and p² from which the third-kind sum starts, of which the choice keeps it quadratic."""
    third = b[0] >= a[0]
    start = multiply(choice(third, q, b), c)
    return root(multiply(b, q)), multiply(root(c), root_s), choice(third, start, multiply(start, gg))


def precession_rate(
    long_axis: bool, third: bool, moments: Three, lead: Pair, total: Pair, gg: Pair, g: Pair, mean: Pair
) -> Pair:
    """Return ω_p times V, of the third-kind sum and what it is multiplied by, A or P."""
    i1, i2, i3 = moments
    # a1 V = I2 I3 and a3 V = I1 I2, and with the mirror −I1 I2 and −I2 I3
    outer = two_product(where(long_axis, -1.0, 1.0) * where(long_axis == third, i1, i3), i2)
    correction = multiply(lead, total)
    share = choice(third, scale(correction, -0.5), scale(divide(correction, gg), 0.5))
    rate = multiply(g, add(outer, share))
    return choice(third, rate, add(rate, mean))


def phase_rates(full: bool, precession: Pair, mean: Pair, v: Pair, rate_scale: float) -> tuple[Pair, Pair]:
    """Return the rates of ``Motion.first`` and ``Motion.second`` [turns per time]."""
    # rates times V become turns: over 2πV
    inverse = scale(divide(constant(INVERSE_TWO_PI, rate_scale), v), rate_scale)
    half = scale(multiply(precession, inverse), 0.5)
    turn = scale(multiply(mean, inverse), 2.0)
    quarter = scale(turn, 0.25)
    return choice(full, subtract(half, quarter), half), choice(full, add(half, quarter), turn)


# ---------------------------------------------------------------------- arguments and series


def _landen_step(
    x: float, y: float, dn: float, factor: float, sinh: float, cosine: float, dc: float
) -> tuple[float, float, float, float, float, float]:
    """Return x, y, dn, factor, sinh and dc after a step."""
    # descending Landen (DLMF §22.7(i)), κ = (1 − k′)/(1 + k′): (1 − dn)/(1 + dn) = κ sn² of the next step, whose
    # dn² = 1 − κ² sn², and tan am = (1 + κ) tan am/dn of the next step
    kappa = (x - y) / (x + y)
    grown = 1.0 + kappa
    next_dn = square_root(1.0 - kappa * (1.0 - dn) / (1.0 + dn))
    sinh = 2.0 * sinh / (grown * (cosine + dc))
    next_dc = square_root(1.0 + kappa * (dc - cosine) / (dc + cosine))
    return 0.5 * (x + y), square_root(x * y), next_dn, factor * (next_dn / grown), sinh, next_dc


def landen(k: float, dn: float, sinh_times_cosine: float, cosine: float, dc: float) -> Pair:
    """Follow a circular and a hyperbolic amplitude down five Landen steps from the complementary modulus k.

    Returns the factor of the tangent of the circular amplitude and the hyperbolic sine of the other; its first step
    takes sinh · c, c and dc · c so that none of them needs a quotient that may be 0/0.
    """
    x, y, dn, factor, sinh, dc = _landen_step(1.0, k, dn, 1.0, sinh_times_cosine, cosine, dc)
    x, y, dn, factor, sinh, dc = _landen_step(x, y, dn, factor, sinh, 1.0, dc)
    x, y, dn, factor, sinh, dc = _landen_step(x, y, dn, factor, sinh, 1.0, dc)
    x, y, dn, factor, sinh, dc = _landen_step(x, y, dn, factor, sinh, 1.0, dc)
    x, y, dn, factor, sinh, dc = _landen_step(x, y, dn, factor, sinh, 1.0, dc)
    return factor, sinh


def full_arguments(
    a: float, b: float, c: float, q: float, ratios: Pair, root_p: float, momentum: Three
) -> tuple[float, float, Ten]:
    """Return what the start is the angle of, (rise, run), and the coefficients of A and B.

    Args:
        a, b, c, q: A, B, C and Q.
        ratios: m and m1, each times BQ.
        root_p: √P.
        momentum: canonical.
    """
    x, y, z = momentum
    total = b * q
    parameter = ratios[0] / total
    per_parameter = nome_per_parameter(parameter, square_root(ratios[1] / total))
    nome = per_parameter * parameter
    # √(P/Q) sinh, as the hyperbolic sine itself overflows near a stable axis
    small = root_p / square_root(q)
    of_b, of_c = square_root(b), square_root(c)
    factor, scaled = landen(square_root(ratios[1] / total), z * square_root(c / q), of_b, of_b, of_c)
    grown = scaled + square_root(small * small + scaled * scaled)
    g = small / grown
    r = (a / b) * per_parameter * grown * grown
    g2, q2, r2 = g * g, nome * nome, r * r
    q3, q4 = q2 * nome, q2 * q2
    q8, gg = q4 * q4, g2 * g2
    up, down, up2, down2 = -nome * g2, -q2 * r, q4 * q2 * gg, q8 * r2
    up3, up4, down4 = -q3 * g2, q8 * q2 * gg, q4 * r2
    return of_b * y * factor, of_c * x, (
        1.0 - (up2 + down2), up + down, 2.0 * (up2 + down2), up - down, 2.0 * (up2 - down2), g * (1.0 - (up4 + down4)),
        g * (up3 - r), 2.0 * g * (up4 + down4), g * (up3 + r), 2.0 * g * (up4 - down4),
    )  # fmt: skip


def complementary_amplitudes(
    b: float, c: float, p: float, q: float, g: float, momentum: Three
) -> tuple[float, float, float, float]:
    """Return what ``landen`` takes beside k: dn, sinh · c, c and dc · c."""
    x, y, z = momentum
    of_c = square_root(c)
    return square_root(p / b) / g, abs(square_root(b) * y), of_c * abs(x), of_c * z * square_root(p / q)


def half_period(fast: Pair, mean: Pair, nome: float) -> Pair:
    """Return πK/K' = 2K/θ3², of √(BQ) and the mean."""
    return by_theta(divide(multiply(fast, constant(PI, nome)), mean), nome)


def harmonics(y: float) -> Ten:
    """Return cos and sin of (2n+1)(y/2 − π/4), n from 0 to 4, for 0 ≤ y ≤ π/2."""
    angle = (0.5 * y - 0.25 * math.pi) * (0.5 / math.pi)
    s0, c0 = sine_cosine(angle)
    s1, c1 = sine_cosine(3.0 * angle)
    s2, c2 = sine_cosine(5.0 * angle - whole(5.0 * angle))
    s3, c3 = sine_cosine(7.0 * angle - whole(7.0 * angle))
    s4, c4 = sine_cosine(9.0 * angle - whole(9.0 * angle))
    return c0, c1, c2, c3, c4, s0, s1, s2, s3, s4
