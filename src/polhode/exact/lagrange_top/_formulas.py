"""The Cayley–Klein parameters of a Lagrange top as quotients of theta functions.

α ∝ θ1(z − iy_a)/θ4(z) and β ∝ θ2(z − iy_b)/θ4(z), each with a phase linear in time (Klein & Sommerfeld, *Theorie des
Kreisels*, ch. VI). The full form (m ≤ ½) is trigonometric in z, the complementary form (m > ½) exponential. As
|α|² + |β|² = 1 the common denominator is not needed, and w = 2(ᾱβ̇ − βᾱ̇) needs no derivative of it.
"""

from __future__ import annotations

from typing import Any, NamedTuple

from polhode.exact._formulas import exponent, reduced_argument
from polhode.exact._kernel_arithmetic import (
    BLOCK,
    Number,
    Pair,
    Rate,
    Time,
    choice,
    floor,
    larger,
    phase,
    record,
    sine_cosine,
    square_root,
    where,
    whole,
)

COLUMNS, SUMMED, SUMS = 45, 37, 10  # numbers of a motion, how many of these its sums take, and of sums
FIRST, THIRD, START, A_SUM, B_SUM, CONSTANT, NOME, SIGNS, RATES, PHASES, AXIAL, REVERSED = (
    k * BLOCK for k in (1, 7, 10, 12, 20, 28, 29, 35, 37, 39, 43, 44)
)
"""Rows of numbers of a ``Motion`` in a store."""
Four = tuple[float, float, float, float]
Six = tuple[Number, Number, Number, Number, Number, Number]
State = tuple[float, float, float, float, float, float, float]
Sums = tuple[float, float, float, float, float, float, float, float, float, float]
"""A, B and their derivatives by z or x', real and imaginary parts, and the phases that these leave, in turns."""


class Motion(NamedTuple):
    """All that evaluation needs of a top: numbers, or arrays with one for each of many.

    Each series has four terms: q^16 is below 1e-21.
    """

    full: Number  # whether it takes the full form
    first: Rate  # of the phase of α [turns per time]
    second: Rate  # of the phase of β
    third: Rate  # full: of z/2π; complementary: of x/2K
    start: Pair  # the same at the epoch, double-double
    a_sum: Four  # full: sums of the terms e^{±ikz} in A; complementary: their factors of sin ky, k = 1, 3, 5, 7
    a_gap: Four  # full: differences; complementary: factors of cos ky
    b_sum: Four  # full: as of A; complementary: factors of cos ky, k = 2, 4, 6, 8
    b_gap: Four  # full: as of A; complementary: factors of sin ky
    constant: Number  # complementary: the constant term of B
    nome: Six  # complementary: q, πK/K' in halves, y_a/π, y_b/π, whether periodic
    signs: Pair  # of c' and c
    rates: Pair  # of w: twice dz/dt or dx'/dt, twice the sum of the linear rates [momentum]
    phases: Four  # cos, sin of the constant phases of α and β
    axial: Number  # L3
    reversed: Number  # −1 where the axis was turned round


def unflatten(m: Any) -> Motion:
    """Return the motion whose numbers stand in one tuple."""
    return Motion(
        m[0], m[1:4], m[4:7], m[7:10], m[10:12], m[12:16], m[16:20], m[20:24], m[24:28], m[28], m[29:35], m[35:37],
        m[37:39], m[39:43], m[43], m[44],
    )


def motion_at(rows: Any, i: int) -> Motion:
    """Return the motion whose numbers stand in rows."""
    return unflatten(record(rows, i, COLUMNS))


def sums_at(rows: Any, i: int) -> Sums:
    """Return the sums that stand in rows."""
    return record(rows, i, SUMS)


def _dot(x: Four, y: Four) -> float:
    """Sum the products, smallest first."""
    (a, b, c, d), (e, f, g, h) = x, y
    return ((d * h + c * g) + b * f) + a * e


def _odd(x: Four, y: Four) -> float:
    """Sum the products times 1, 3, 5 and 7, which a derivative brings."""
    (a, b, c, d), (e, f, g, h) = x, y
    return ((d * (7.0 * h) + c * (5.0 * g)) + b * (3.0 * f)) + a * e


def _even(x: Four, y: Four) -> float:
    """Sum the products times 2, 4, 6 and 8."""
    (a, b, c, d), (e, f, g, h) = x, y
    return ((d * (8.0 * h) + c * (6.0 * g)) + b * (4.0 * f)) + a * (2.0 * e)


def _turns(rate: Rate, time: Time) -> float:
    fraction, rest, _ = phase(rate, time)
    return fraction + rest


def full_sums(m: Motion, time: Time) -> Sums:
    """Sum A, B and their derivatives by z."""
    sa, sb = m.signs
    fraction, rest, _ = phase(m.third, time)
    z = fraction + (rest + m.start[0])
    s1, c1 = sine_cosine(z - whole(z))
    c, s = 1.0 - 2.0 * s1 * s1, 2.0 * s1 * c1
    c3, s3 = c1 * c - s1 * s, s1 * c + c1 * s
    c5, s5 = c3 * c - s3 * s, s3 * c + c3 * s
    c7, s7 = c5 * c - s5 * s, s5 * c + c5 * s
    cosines, sines = (c1, c3, c5, c7), (s1, s3, s5, s7)
    return (
        _dot(m.a_sum, sines), -sa * _dot(m.a_gap, cosines), _dot(m.b_sum, cosines), sb * _dot(m.b_gap, sines),
        _odd(m.a_sum, cosines), sa * _odd(m.a_gap, sines), -_odd(m.b_sum, sines), sb * _odd(m.b_gap, cosines),
        _turns(m.first, time), _turns(m.second, time),
    )  # fmt: skip


def complementary_phase(m: Motion, time: Time) -> State:
    """Return side, both phases in turns, and exponent and factor of E and of R, which sum A and B."""
    _, upper, lower, ya_turns, yb_turns, periodic = m.nome
    sa, sb = m.signs
    u, u_rest, count = reduced_argument(m.third, m.start, periodic, time)
    side = where(u < 0.0, -1.0, 1.0)
    f, g = u * side, u_rest * side
    e, e_factor = exponent(f, g, upper, lower)
    distance = larger(0.5 - f, 0.0)
    r, r_factor = exponent(distance, ((0.5 - distance) - f) * periodic - g, upper, lower)
    half = 0.5 * (count - 2.0 * floor(0.5 * count))
    within = u + u_rest
    turns_a = _turns(m.first, time) + sa * within * ya_turns
    turns_b = _turns(m.second, time) + sb * within * yb_turns
    turns_a, turns_b = (turns_a - whole(turns_a)) + half, (turns_b - whole(turns_b)) + half
    return side, turns_a, turns_b, e, e_factor, r, periodic * r_factor


def complementary_sums(m: Motion, side: float, turns_a: float, turns_b: float, e0: float, R: float) -> Sums:
    """Sum A, B and their derivatives by x' in the decaying powers of E = e^−|x'| and the growing ones of R = √q/E."""
    q = m.nome[0]
    sa, sb = m.signs
    h, r = e0 * e0, R * R
    h2 = h * h
    h3 = h * h2
    h5 = h3 * h2
    h7 = h5 * h2
    q2 = q * q
    q3 = q2 * q
    w1, w2, w3 = q * r, q2 * r, q3 * r
    p1, p2, p3, p4 = q * h, q2 * h, q3 * h, q2 * q2 * h
    v2, v3 = w2 * w2, w3 * w3
    u1, u2, u3 = w1 * w1, v2 * w2, v3 * v3
    d2, d3, d4 = p2 * p2, p3 * p3 * p3, (p4 * p4) * (p4 * p4)
    v3 = v3 * w3
    sums = 1.0 + h, w1 * (1.0 + h3), v2 * (1.0 + h5), v3 * (1.0 + h7)
    gaps = 1.0 - h, w1 * (1.0 - h3), v2 * (1.0 - h5), v3 * (1.0 - h7)
    up, down = (r + p1, u1 + d2, u2 + d3, u3 + d4), (r - p1, u1 - d2, u2 - d3, u3 - d4)
    e = 2.0 * e0
    return (
        _dot(m.a_sum, sums), sa * side * _dot(m.a_gap, gaps), e * (m.constant + _dot(m.b_sum, up)),
        -sb * side * e * _dot(m.b_gap, down), side * _odd(m.a_sum, gaps), sa * _odd(m.a_gap, sums),
        side * e * _even(m.b_sum, down), -sb * e * _even(m.b_gap, up), turns_a, turns_b,
    )  # fmt: skip


def state_of(m: Motion, sums: Sums) -> State:
    """Return attitude and momentum: α = A e^{iφ_a}, β = B e^{iφ_b} over their norm, and w."""
    ar, ai, br, bi, dar, dai, dbr, dbi, turns_a, turns_b = sums
    by_argument, by_phase = m.rates
    c0, s0, c1, s1 = m.phases
    x = 1.0 / ((ar * ar + ai * ai) + (br * br + bi * bi))
    root = square_root(x)
    s, c = sine_cosine(turns_a - whole(turns_a))
    ca, sa = c * c0 - s * s0, s * c0 + c * s0
    s, c = sine_cosine(turns_b - whole(turns_b))
    cb, sb = c * c1 - s * s1, s * c1 + c * s1
    ar_t, ai_t = (ar * ca - ai * sa) * root, (ar * sa + ai * ca) * root
    br_t, bi_t = (br * cb - bi * sb) * root, (br * sb + bi * cb) * root
    # ĀB' − BĀ' and i ĀB
    gain_r = (ar * dbr + ai * dbi) - (br * dar + bi * dai)
    gain_i = (ar * dbi - ai * dbr) - (bi * dar - br * dai)
    turn_r, turn_i = ai * br - ar * bi, ar * br + ai * bi
    wr = (by_argument * gain_r + by_phase * turn_r) * x
    wi = (by_argument * gain_i + by_phase * turn_i) * x
    cw, sw = cb * ca + sb * sa, sb * ca - cb * sa
    side = m.reversed
    turned = side < 0.0
    w, z = choice(turned, (br_t, bi_t), (ar_t, ai_t))
    x, y = choice(turned, (ar_t, ai_t), (br_t, bi_t))
    return w, side * x, side * y, z, wr * cw - wi * sw, side * (wr * sw + wi * cw), m.axial
