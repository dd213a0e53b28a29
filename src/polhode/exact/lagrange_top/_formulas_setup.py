"""From a top's frequencies and the places of its poles to the constants of its motion: theta series and phases."""

from __future__ import annotations

import math
from typing import NamedTuple

from polhode.exact._formulas import nome_per_parameter
from polhode.exact._kernel_arithmetic import (
    Number,
    Pair,
    Rate,
    Truth,
    add,
    choice,
    choose,
    divide,
    exponential,
    halves,
    negation,
    root,
    scale,
    sine_cosine,
    square_root,
    times_power,
    where,
    whole,
)
from polhode.exact.lagrange_top._formulas import (
    Four,
    Motion,
    Sums,
    complementary_phase,
    complementary_sums,
    full_sums,
)
from polhode.exact.lagrange_top._formulas_integrals import Integrals
from polhode.exact.lagrange_top._formulas_rates import Frequencies, climb, half_periods, periods, phase_rates
from polhode.exact.lagrange_top._formulas_reduction import ONE, ZERO, Reduction, Three, is_upright, leaves
from polhode.exact.lagrange_top._formulas_roots import TurningPoints

NO_TERMS = (0.0, 0.0, 0.0, 0.0)
Six = tuple[Number, Number, Number, Number, Number, Number]
Series = tuple[Four, Four, Four, Four, Number]


class Arguments(NamedTuple):
    """The modulus and the places of start and poles in the lattice."""

    full: Truth
    q: Number  # nome of the smaller parameter
    theta3: Number
    y_alpha: Number  # imaginary distance of the poles, times π/2K (full) or π/2K'
    y_beta: Number
    w_alpha: Number  # full: the like of K' − v
    w_beta: Number
    x0: Pair


class Given(NamedTuple):
    """A reduced top with all that its motion is made from."""

    top: Reduction
    points: TurningPoints
    rates: Frequencies
    at: Arguments
    axial: Number  # L3 as given


class Timing(NamedTuple):
    """What of a ``Motion`` depends on rates and places."""

    rates: tuple[Rate, Rate, Rate, Pair]  # its first to start
    places: tuple[Six, Pair, Pair]  # its nome to rates
    linear: Pair  # derivatives by τ of the phases of α and β that evaluation adds to A and B, spin aside
    turn: Number  # dz/dτ or dx'/dτ


def is_full(top: Reduction, points: TurningPoints) -> bool:
    """Return whether the motion takes the full form, m ≤ ½, if it nutates."""
    # m = (A − B)/A = G (u2 − u1)/A and 1 − m = B/A
    return top.G[0] * points.d[0] <= points.B[0]


def arguments(top: Reduction, points: TurningPoints, rates: Frequencies, integrals: Integrals) -> Arguments:
    """Return modulus and places, of the integrals."""
    m, m1 = top.G[0] * points.d[0] / points.A[0], where(rates.separatrix, 0.0, points.B[0] / points.A[0])
    full = rates.permanent | (is_full(top, points) & negation(rates.separatrix))
    small = where(rates.permanent, 0.0, where(full, m, m1))
    q = small * nome_per_parameter(small, square_root(1.0 - small))
    q4 = (q * q) * (q * q)
    theta3 = 1.0 + 2.0 * (q + q4 + q4 * q4 * q)
    by = 1.0 / (theta3 * theta3)  # π/2K of the smaller quarter period (DLMF 22.2.2)
    x0 = scale(add(integrals.x0, climb(top)), where(top.p[0] >= 0.0, 1.0, -1.0))
    return Arguments(
        full, q, theta3, integrals.v_alpha * by, integrals.v_beta * by, integrals.w_alpha * by, integrals.w_beta * by,
        x0,
    )  # fmt: skip


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


def _sizes(top: Reduction, t: Pair, s: Pair) -> Pair:
    """Return √(t/2) and √(s/2) at the given size of the displacement, where that stays as small."""
    down, upright = times_power(1.0, -where(leaves(top), 0.0, top.lift)), is_upright(top)
    root_t, root_s = square_root(0.5 * t[0]), square_root(0.5 * s[0])
    return root_t * where(upright, 1.0, down), root_s * where(upright, down, 1.0)


def tails(at: Arguments) -> Four:
    """Return q e^{2y}, accurate where y is far out, and e^{−2y}, of α and of β."""
    return (
        exponential(-2.0 * at.w_alpha), exponential(-2.0 * at.y_alpha), exponential(-2.0 * at.w_beta),
        exponential(-2.0 * at.y_beta),
    )


def full_series(top: Reduction, points: TurningPoints, at: Arguments, tail: Four) -> Series:
    """Return sums and differences of the coefficients of e^{±ikz}, k = 1, 3, 5, 7, in A and in B."""
    root_t, root_s = _sizes(top, points.t2, points.s1)
    of_alpha, of_beta = full_sizes(root_t, root_s, at.q, at.theta3)
    some = at.q > 0.0
    a_sum, a_gap = full_terms(of_alpha, tail[1], at.q, where(some, tail[0], 0.0), -1.0)
    b_sum, b_gap = full_terms(of_beta, tail[3], at.q, where(some, tail[2], 0.0), 1.0)
    return a_sum, a_gap, b_sum, b_gap, 0.0


def _full(given: Given) -> Series:
    return full_series(given.top, given.points, given.at, tails(given.at))


def _standing(given: Given) -> Series:
    """Return the series of a permanent top, which has one of α, β, or at rest both, as it started."""
    # A = |α| sin z and B = i |β| sin z at z = π/2
    root_t, root_s = _sizes(given.top, given.top.t0, given.top.s0)
    return (root_t, 0.0, 0.0, 0.0), NO_TERMS, NO_TERMS, (root_s, 0.0, 0.0, 0.0), 0.0


def _of_full_form(given: Given) -> Series:
    return choose(given.rates.permanent, _standing, _full, given)


def complementary(top: Reduction, points: TurningPoints, at: Arguments) -> Series:
    """Return the series of the complementary form."""
    root_t, root_s = _sizes(top, points.t2, points.s1)
    return complementary_series(root_t, root_s, at.q, at.theta3, at.y_alpha, at.y_beta)


def _of_complementary_form(given: Given) -> Series:
    return complementary(given.top, given.points, given.at)


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


def phases_of(top: Reduction, timing: Timing, sums: Sums) -> Four:
    """Return the constant phases, of the sums at the epoch."""
    ar, ai, br, bi, dar, dai, dbr, dbi, turns_a, turns_b = sums
    up, upright = times_power(1.0, top.lift), is_upright(top)
    a, b = where(upright, 1.0, up), where(upright, up, 1.0)
    x, y, z = top.momentum
    size = (x * x + y * y) + (z * z + top.G[0])
    lifted = ar * a, ai * a, br * b, bi * b, dar * a, dai * a, dbr * b, dbi * b, turns_a, turns_b
    return constant_phases(
        top.quaternion, top.size, top.momentum, where(size > 0.0, size, 1.0), lifted, timing.linear, timing.turn
    )


# ---------------------------------------------------------------------- the whole


def _in_halves(rate: Pair) -> Rate:
    high, low = halves(rate[0])
    return high, low, rate[1]


def timing_of(top: Reduction, rates: Frequencies, at: Arguments) -> Timing:
    """Return what of the motion depends on rates and places."""
    i1, _ = top.moments
    permanent, separatrix, full = rates.permanent, rates.separatrix, at.full
    alpha, beta = phase_rates(top, rates)
    half = half_periods(rates.nutation, i1, top.rate_scale)
    saddle = divide(scale(rates.half_root, top.rate_scale), (i1, 0.0))
    third = choice(permanent, ZERO, choice(full, scale(half, 0.5), choice(separatrix, saddle, half)))
    quarter, period = periods(rates.half_root, rates.nutation, at.q)
    fraction = scale(divide(at.x0, quarter), 0.5)
    start = choice(full, scale(fraction, 0.5), choice(separatrix, at.x0, fraction))
    start, period = choice(permanent, (0.25, 0.0), start), choice(separatrix, ONE, period)
    upper, lower = halves(period[0])
    ya, yb = where(full | separatrix, 0.0, at.y_alpha), where(full | separatrix, 0.0, at.y_beta)
    carried, sa, sb = rates.nutation[0] * (2.0 / math.pi), rates.sign_alpha, rates.sign_beta
    turn = where(full, rates.nutation[0], rates.half_root[0] / (at.theta3 * at.theta3))
    linear_a, linear_b, turn = (
        where(permanent, 0.0, rates.alpha[0] + sa * ya * carried),
        where(permanent, 0.0, rates.beta[0] + sb * yb * carried), where(permanent, 0.0, turn),
    )  # fmt: skip
    size = top.momentum_scale
    return Timing(
        (_in_halves(alpha), _in_halves(beta), _in_halves(third), start),
        (
            (at.q, upper, lower + period[1], ya / math.pi, yb / math.pi, where(separatrix, 0.0, 1.0)),
            (where(permanent, 1.0, sa), where(permanent, 1.0, sb)),
            (2.0 * turn * size, 2.0 * (linear_a + linear_b) * size),
        ),
        (linear_a, linear_b), turn,
    )  # fmt: skip


def _motion(given: Given, timing: Timing, series: Series, phases: Four) -> Motion:
    first, second, third, start = timing.rates
    nome, signs, rates = timing.places
    a_sum, a_gap, b_sum, b_gap, constant = series
    return Motion(
        where(given.at.full, 1.0, 0.0), first, second, third, start, a_sum, a_gap, b_sum, b_gap, constant, nome, signs,
        rates, phases, given.axial, where(given.top.reversed, -1.0, 1.0),
    )


def motion_without_phases(given: Given) -> tuple[Motion, Timing]:
    """Return the motion of a top whose constant phases are none."""
    timing = timing_of(given.top, given.rates, given.at)
    series = choose(given.at.full, _of_full_form, _of_complementary_form, given)
    return _motion(given, timing, series, (1.0, 0.0, 1.0, 0.0)), timing


def _full_start(m: Motion) -> Sums:
    zero = 0.0 * m.start[0]
    return full_sums(m, (zero, zero, zero))


def _complementary_start(m: Motion) -> Sums:
    zero = 0.0 * m.start[0]
    a, b, c, e, factor, other, other_factor = complementary_phase(m, (zero, zero, zero))
    return complementary_sums(m, a, b, c, exponential(e) * factor, exponential(other) * other_factor)


def motion_with_phases(given: Given, motion: Motion, timing: Timing) -> Motion:
    """Return the motion, which begins at the given attitude."""
    sums = choose(given.at.full, _full_start, _complementary_start, motion)
    series = motion.a_sum, motion.a_gap, motion.b_sum, motion.b_gap, motion.constant
    return _motion(given, timing, series, phases_of(given.top, timing, sums))


def motion_of(given: Given) -> Motion:
    """Return the constants of motion of a top."""
    motion, timing = motion_without_phases(given)
    return motion_with_phases(given, motion, timing)
