"""From a body to the constants of its motion: the arguments of the theta functions, and the matrices.

The arguments come by descending Landen transformation from tangents and hyperbolic sines that are ratios of the
invariants, so neither elliptic integrals nor logarithms enter the full form. Source: DLMF §22.7.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from polhode.exact._formulas import by_theta, nome_per_parameter
from polhode.exact._kernel_arithmetic import (
    Number,
    Pair,
    Rate,
    Truth,
    add,
    angle_of,
    arctangent,
    area_of_sine,
    choice,
    choose,
    constant,
    divide,
    exponential,
    fast_two_sum,
    halves,
    hyperbolic_sine,
    larger,
    logarithm,
    multiply,
    negation,
    root_or_zero,
    scale,
    sine_cosine,
    smaller,
    square,
    square_root,
    where,
    whole,
)
from polhode.exact.free_body._formulas import (
    Five,
    Matrix3,
    Matrix4,
    Motion,
    Spinor,
    Ten,
    complementary_phase,
    complementary_sums,
    full_sums,
)
from polhode.exact.free_body._formulas_rates import Frequencies, phase_rates
from polhode.exact.free_body._formulas_reduction import Reduction, Three
from polhode.special._doubledouble import INVERSE_TWO_PI, PI

HUGE_INVERSE, HUGE_SCALE = 2.0**-400, 2.0**-200  # a sine above the inverse of the first is scaled by the second
LOG_OF_SCALE = (138.62943611198907, -3.3555121496085278e-15)  # 200 ln 2
NINE_ZEROS = (0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
SIXTEEN_ZEROS = (*NINE_ZEROS, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
Four = tuple[Number, Number, Number, Number]
Matrix = tuple[tuple[Number, Number, Number], tuple[Number, Number, Number], tuple[Number, Number, Number]]


class Arguments(NamedTuple):
    """What a form takes at the epoch."""

    start: Pair
    series: Ten
    nome: Five
    parity: Number


class FullAmplitude(NamedTuple):
    """What the full form's start is the angle of, and its coefficients."""

    rise: Number
    run: Number
    series: Ten


class Amplitude(NamedTuple):
    """What the complementary form's start is made from."""

    nome: Number
    tangent: Number  # of y, the circular amplitude
    sinh: Number  # of x, the hyperbolic one, times HUGE_SCALE if it is huge
    huge: Truth


class Angles(NamedTuple):
    """The amplitudes, and the hyperbolic sine of x as it is rounded."""

    x: Number
    sinh: Number
    y: Number


class Given(NamedTuple):
    """A body as given, with its reduction and frequencies."""

    moments: Three
    momentum: Three
    attitude: Four
    body: Reduction
    rates: Frequencies


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


def full_amplitude(body: Reduction) -> FullAmplitude:
    """Return what the start of the full form, m ≤ ½, is the angle of, and the coefficients of A and B."""
    a, b, c, q = body.A[0], body.B[0], body.C[0], body.Q[0]
    x, y, z = body.canonical
    total = b * q
    parameter, complement = a * body.P[0] / total, -c * body.S[0] / total
    per_parameter = nome_per_parameter(parameter, square_root(complement))
    nome = per_parameter * parameter
    # √(P/Q) sinh, as the hyperbolic sine itself overflows near a stable axis
    small = body.root_P / square_root(q)
    of_b, of_c = square_root(b), square_root(c)
    factor, scaled = landen(square_root(complement), z * square_root(c / q), of_b, of_b, of_c)
    grown = scaled + square_root(small * small + scaled * scaled)
    g = small / grown
    r = (a / b) * per_parameter * grown * grown
    g2, q2, r2 = g * g, nome * nome, r * r
    q3, q4 = q2 * nome, q2 * q2
    q8, gg = q4 * q4, g2 * g2
    up, down, up2, down2 = -nome * g2, -q2 * r, q4 * q2 * gg, q8 * r2
    up3, up4, down4 = -q3 * g2, q8 * q2 * gg, q4 * r2
    return FullAmplitude(of_b * y * factor, of_c * x, (
        1.0 - (up2 + down2), up + down, 2.0 * (up2 + down2), up - down, 2.0 * (up2 - down2), g * (1.0 - (up4 + down4)),
        g * (up3 - r), 2.0 * g * (up4 + down4), g * (up3 + r), 2.0 * g * (up4 - down4),
    ))  # fmt: skip


def full_start(rise: float, run: float) -> float:
    """Return z0/4π."""
    return angle_of(rise, run) * (0.25 / math.pi)


def full_arguments(start: float, series: Ten) -> Arguments:
    """Return what the full form takes."""
    return Arguments((start, 0.0), series, (0.0, 0.0, 0.0, 0.0, 0.0), 0.0)


def _full_arguments(given: Given) -> Arguments:
    at = full_amplitude(given.body)
    return full_arguments(full_start(at.rise, at.run), at.series)


def amplitude(body: Reduction, rates: Frequencies) -> Amplitude:
    """Return what the start of the complementary form, m > ½, is made from."""
    b, c, p, q = body.B[0], body.C[0], body.P[0], body.Q[0]
    x, y, z = body.canonical
    total = b * q
    k = where(rates.separatrix, 1.0, square_root(body.A[0] * p / total))
    parameter = where(rates.separatrix, 0.0, -c * body.S[0] / total)
    of_c = square_root(c)
    # dn, and sinh, cosine and dc of which all but the last are times one number: none needs a quotient that may be 0/0
    dn, along = square_root(p / b) / rates.G[0], abs(square_root(b) * y)
    cosine, dc = of_c * abs(x), of_c * z * square_root(p / q)
    # close to the unstable axis the hyperbolic sine and its square leave the range of numbers
    huge = cosine + dc < HUGE_INVERSE * along
    factor, sinh = landen(k, dn, where(huge, HUGE_SCALE * along, along), cosine, dc)
    return Amplitude(parameter * nome_per_parameter(parameter, k), square_root(q / p) * factor, sinh, huge)


def _of_huge(sinh: float) -> Pair:
    x = logarithm(2.0 * sinh)
    return x, 0.5 * exponential(x)


def _of_ordinary(sinh: float) -> Pair:
    x = area_of_sine(sinh)
    return x, hyperbolic_sine(x)


def angles(at: Amplitude) -> Angles:
    """Return the amplitudes by elementary functions."""
    x, sinh = choose(at.huge, _of_huge, _of_ordinary, at.sinh)
    return Angles(x, sinh, arctangent(at.tangent))


def complementary_arguments(body: Reduction, rates: Frequencies, at: Amplitude, angle: Angles) -> Arguments:
    """Return start, harmonics, nome and parity of the complementary form, separatrix included."""
    l1, l2, _ = body.canonical
    slope = where(at.huge, angle.sinh, square_root(1.0 + angle.sinh * angle.sinh))
    x = fast_two_sum(angle.x, (at.sinh - angle.sinh) / slope)
    x = choice(at.huge, add(x, constant(LOG_OF_SCALE, at.nome)), x)
    x = scale(x, where((l2 < 0.0) == (l1 < 0.0), 1.0, -1.0))
    period = half_period(rates.modulus_rate, rates.mean, at.nome)
    period = choice(rates.separatrix, constant((1.0, 0.0), at.nome), period)
    upper, lower = halves(period[0])
    periodic = where(rates.separatrix, 0.0, 1.0)
    return Arguments(
        divide(x, period), harmonics(angle.y),
        (square_root(at.nome), upper, lower + period[1], periodic * angle.y * (0.5 / math.pi), periodic),
        where(l1 < 0.0, 1.0, 0.0),
    )  # fmt: skip


def _complementary_arguments(given: Given) -> Arguments:
    at = amplitude(given.body, given.rates)
    return complementary_arguments(given.body, given.rates, at, angles(at))


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


# ---------------------------------------------------------------------- matrices


def _turned(given: Four, scalar: float, x: float, y: float, z: float) -> Four:
    """Return the product of quaternions."""
    a, b, c, d = given
    return (
        ((a * scalar - b * x) - c * y) - d * z, ((a * x + b * scalar) + c * z) - d * y,
        ((a * y - b * z) + c * scalar) + d * x, ((a * z + b * y) - c * x) + d * scalar,
    )  # fmt: skip


def _on_axis(k: float, order: Three, x: float, y: float, z: float) -> float:
    """Return the component along a given axis of a vector along axes of this order."""
    return where(order[0] == k, x, where(order[1] == k, y, z))


def _column(given: Four, order: Three, scalar: float, x: float, y: float, z: float) -> Four:
    return _turned(
        given, scalar, _on_axis(0.0, order, x, y, z), _on_axis(1.0, order, x, y, z), _on_axis(2.0, order, x, y, z)
    )


def axes_of(body: Reduction) -> Matrix:
    """Return the signed permutation whose rows take canonical components to those along the given axes."""
    i, j, k = body.order
    middle, outer = body.parity, body.parity * body.half_turn
    return (
        (where(i == 0.0, outer, 0.0), where(j == 0.0, middle, 0.0), where(k == 0.0, outer, 0.0)),
        (where(i == 1.0, outer, 0.0), where(j == 1.0, middle, 0.0), where(k == 1.0, outer, 0.0)),
        (where(i == 2.0, outer, 0.0), where(j == 2.0, middle, 0.0), where(k == 2.0, outer, 0.0)),
    )


def matrices(body: Reduction, g: float, attitude: Four, spinor: Spinor) -> tuple[Matrix4, Matrix3]:
    """Return by rows the matrices from spinor to attitude and from canonical direction to momentum.

    Args:
        body: the reduction.
        g: |L|.
        attitude: at the epoch.
        spinor: likewise.
    """
    a0, a1, b0, b1 = spinor
    norm = square_root((a0 * a0 + a1 * a1) + (b0 * b0 + b1 * b1))
    a0, a1, b0, b1 = a0 / norm, a1 / norm, b0 / norm, b1 / norm
    # (start frame)* (present frame) is linear in the spinor (Re A, Im A, Re B, Im B); the mirror reverses its vector
    h, order = where(body.long_axis, -body.parity, body.parity), body.order
    f = h * body.half_turn
    p = _column(attitude, order, a0, -f * b1, h * b0, -f * a1)
    q = _column(attitude, order, a1, f * b0, h * b1, f * a0)
    r = _column(attitude, order, b0, -f * a1, -h * a0, f * b1)
    s = _column(attitude, order, b1, f * a0, -h * a1, -f * b0)
    size = g * body.momentum_scale
    first, second, third = axes_of(body)
    return (
        p[0], q[0], r[0], s[0], p[1], q[1], r[1], s[1], p[2], q[2], r[2], s[2], p[3], q[3], r[3], s[3],
    ), (
        size * first[0], size * first[1], size * first[2], size * second[0], size * second[1], size * second[2],
        size * third[0], size * third[1], size * third[2],
    )  # fmt: skip


# ---------------------------------------------------------------------- the whole


def is_full(body: Reduction) -> bool:
    """Return whether the motion takes the full form, m ≤ ½, if it has a period."""
    return body.A[0] * body.P[0] <= -body.C[0] * body.S[0]


def _full_spinor(m: Motion) -> Spinor:
    zero = 0.0 * m.start[0]
    return full_sums(m, (zero, zero, zero))


def _complementary_spinor(m: Motion) -> Spinor:
    zero = 0.0 * m.start[0]
    a, b, c, e, factor, other, other_factor = complementary_phase(m, (zero, zero, zero))
    return complementary_sums(m, a, b, c, exponential(e) * factor, exponential(other) * other_factor)


def _moving(given: Given) -> Motion:
    """Return the motion of a body whose momentum moves."""
    body, rates = given.body, given.rates
    full = is_full(body) & negation(rates.separatrix)
    first, second = phase_rates(full, body, rates)
    at = choose(full, _full_arguments, _complementary_arguments, given)
    kind = where(full, 1.0, 0.0)
    m = Motion(kind, first, second, at.start, at.series, at.nome, at.parity, SIXTEEN_ZEROS, NINE_ZEROS)
    spinor = choose(full, _full_spinor, _complementary_spinor, m)
    to_attitude, to_momentum = matrices(body, rates.G[0], given.attitude, spinor)
    return Motion(kind, first, second, at.start, at.series, at.nome, at.parity, to_attitude, to_momentum)


def _permanent_rate(body: Reduction) -> Rate:
    """Return |Ω|/4π, the rate of half the angle of a permanent rotation, in turns."""
    (i1, i2, i3), (x, y, z), none = body.moments, body.momentum, 0.0 * body.root_P
    u, v, w = divide((x, none), (i1, none)), divide((y, none), (i2, none)), divide((z, none), (i3, none))
    size = root_or_zero(add(add(square(u), square(v)), square(w)))
    rate = scale(scale(multiply(size, constant(INVERSE_TWO_PI, none)), 0.5), body.rate_scale)
    high, low = halves(rate[0])
    return high, low, rate[1]


def _rotation_axis(moments: Three, momentum: Three) -> Three:
    """Return the direction of Ω along the given axes, zero at rest."""
    i1, i2, i3 = moments
    x, y, z = momentum
    largest = larger(larger(abs(x), abs(y)), abs(z))
    largest = where(largest > 0.0, largest, 1.0)
    least = smaller(smaller(i1, i2), i3)
    x, y, z = x / largest * (least / i1), y / largest * (least / i2), z / largest * (least / i3)
    size = square_root((x * x + y * y) + z * z)
    size = where(size > 0.0, size, 1.0)
    return x / size, y / size, z / size


def _permanent(given: Given) -> Motion:
    """Return the motion of a body at rest, of a sphere, or in permanent rotation: (A, B) turns, and L stays."""
    zero = 0.0 * given.body.root_P
    one = zero + 1.0
    x, y, z = _rotation_axis(given.moments, given.momentum)
    p, q = _turned(given.attitude, 1.0, zero, zero, zero), _turned(given.attitude, 0.0, x, y, z)
    l1, l2, l3 = given.momentum
    return Motion(
        one, _permanent_rate(given.body), (zero, zero, zero), (zero, zero),
        (one, zero, zero, zero, zero, zero, zero, zero, zero, zero), (zero, zero, zero, zero, zero), zero,
        (p[0], q[0], zero, zero, p[1], q[1], zero, zero, p[2], q[2], zero, zero, p[3], q[3], zero, zero),
        (zero, zero, l1, zero, zero, l2, zero, zero, l3),
    )  # fmt: skip


def motion_of(given: Given) -> Motion:
    """Return the constants of motion of a body."""
    return choose(given.rates.constant, _permanent, _moving, given)
