"""The attitude quaternion of a free body as a quotient of theta functions.

Two complex theta functions A and B of the polhode angle make, up to their norm, the quaternion of the frame whose
third row is the angular momentum (Jacobi 1849; Klein & Sommerfeld, *Theorie des Kreisels*). Both are short series in
the smaller of the two nomes: the full form (m ≤ ½) is trigonometric in the polhode angle, the complementary form
(m > ½) exponential. The rest is a constant 4×4 matrix.
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
    floor,
    larger,
    phase,
    record,
    sine_cosine,
    square_root,
    where,
    whole,
)

COLUMNS, SUMMED, SUMS = 50, 25, 4  # numbers of a motion, how many of these its sums take, and of sums
FIRST, START, SERIES, NOME, Y_TURNS, TO_ATTITUDE, TO_MOMENTUM = (k * BLOCK for k in (1, 7, 9, 19, 22, 25, 41))
"""Rows of numbers of a ``Motion`` in a store."""
Spinor = tuple[Number, Number, Number, Number]  # Re A, Im A, Re B, Im B
Five = tuple[Number, Number, Number, Number, Number]
Ten = tuple[Number, Number, Number, Number, Number, Number, Number, Number, Number, Number]
Matrix3 = tuple[Number, Number, Number, Number, Number, Number, Number, Number, Number]  # by rows
Matrix4 = tuple[
    Number, Number, Number, Number, Number, Number, Number, Number,
    Number, Number, Number, Number, Number, Number, Number, Number,
]  # fmt: skip
State = tuple[float, float, float, float, float, float, float]


class Motion(NamedTuple):
    """All that evaluation needs of a body: numbers, or arrays with one for each of many."""

    full: Number  # whether it takes the full form
    first: Rate  # full: rate of the phase of A; complementary: half the precession rate [turns per time]
    second: Rate  # full: rate of the phase of B; complementary: rate of u/2K
    start: Pair  # full: (z0/4π, 0); complementary: u0/2K, double-double
    series: Ten  # full: five coefficients of A and of B; complementary: cos and sin of (2n+1)(y/2 − π/4)
    nome: Five  # complementary: √q1, πK/K' in halves, y/2π, 0 on the separatrix
    parity: Number  # complementary: half turns of u at the start
    to_attitude: Matrix4  # by rows: quaternion = matrix (4, 4) · spinor / norm
    to_momentum: Matrix3  # by rows: momentum = matrix (3, 3) · (n1, n2, n3)


def unflatten(m: Any) -> Motion:
    """Return the motion whose numbers stand in one tuple."""
    return Motion(m[0], m[1:4], m[4:7], m[7:9], m[9:19], m[19:24], m[24], m[25:41], m[41:50])


def motion_at(rows: Any, i: int) -> Motion:
    """Return the motion whose numbers are in rows."""
    return unflatten(record(rows, i, COLUMNS))


def sums_at(rows: Any, i: int) -> Spinor:
    """Return the spinor in rows."""
    return record(rows, i, SUMS)


def full_sums(m: Motion, time: Time) -> Spinor:
    """Sum A and B as polynomials in X = cos 2z and Y = sin 2z, where z is the difference of their phases."""
    start = m.start[0]
    a0, a1, a2, a3, a4, b0, b1, b2, b3, b4 = m.series
    fa, ra, _ = phase(m.first, time)
    fb, rb, _ = phase(m.second, time)
    ta, tb = fa + (ra - start), fb + (rb + start)
    sa, ca = sine_cosine(ta - whole(ta))
    sb, cb = sine_cosine(tb - whole(tb))
    cz, sz = ca * cb + sa * sb, sb * ca - cb * sa
    # cos 2z = 1 − 2 sin² z, sin 2z = 2 sin z cos z
    s2 = sz + sz
    X, Y = 1.0 - s2 * sz, s2 * cz
    pa, qa = a0 + X * (a1 + X * a2), Y * (a3 + X * a4)
    pb, qb = b0 + X * (b1 + X * b2), Y * (b3 + X * b4)
    return ca * pa - sa * qa, ca * qa + sa * pa, cb * pb - sb * qb, cb * qb + sb * pb


def complementary_phase(m: Motion, time: Time) -> tuple[float, float, float, float, float, float, float]:
    """Return turns, side, count of half turns, and exponent and factor of E and of R, which sums A and B."""
    _, upper, lower, y_turns, periodic = m.nome
    fraction, rest, _ = phase(m.first, time)
    u, u_rest, count = reduced_argument(m.second, m.start, periodic, time)
    count = m.parity + count
    count = count - 4.0 * whole(0.25 * count)
    turns = fraction - 0.25 * count
    turns = (turns - whole(turns)) + (rest - u * y_turns)
    side = where(u < 0.0, -1.0, 1.0)
    f, g = u * side, u_rest * side
    e, e_factor = exponent(f, g, upper, lower)
    distance = larger(0.5 - f, 0.0)
    r, r_factor = exponent(distance, ((0.5 - distance) - f) * periodic - g, upper, lower)
    return turns, side, count, e, e_factor, r, periodic * r_factor


def complementary_sums(m: Motion, turns: float, side: float, count: float, e0: float, R: float) -> Spinor:
    """Sum A and B in the growing powers of R = √q1/E and the decaying ones of E = e^−|x|, x = πu/2K'."""
    c0, c1, c2, c3, c4, s0, s1, s2, s3, s4 = m.series
    root = m.nome[0]
    s, c = sine_cosine(turns - whole(turns))
    q = root * root
    q2 = q * q
    g1 = root * R
    g2 = g1 * g1 * q
    g3 = g2 * g1 * q2
    g4 = g3 * g1 * q2 * q
    e1 = q * e0 * e0
    e2 = q2 * e1 * e0
    e3 = q2 * q * e2 * e0
    e4 = q2 * q2 * e3 * e0
    ar, ai = c4 * (g4 + e4), s4 * (g4 - e4)
    br, bi = -s4 * (g4 + e4), c4 * (g4 - e4)
    ar, ai = ar + c3 * (g3 + e3), ai + s3 * (g3 - e3)
    br, bi = br + s3 * (g3 + e3), bi - c3 * (g3 - e3)
    ar, ai = ar + c2 * (g2 + e2), ai + s2 * (g2 - e2)
    br, bi = br - s2 * (g2 + e2), bi + c2 * (g2 - e2)
    ar, ai = ar + c1 * (g1 + e1), ai + s1 * (g1 - e1)
    br, bi = br + s1 * (g1 + e1), bi - c1 * (g1 - e1)
    ar, ai = ar + c0 * (1.0 + e0), ai + s0 * (1.0 - e0)
    br, bi = br - s0 * (1.0 + e0), bi + c0 * (1.0 - e0)
    ai, bi = ai * side, bi * side
    odd = 1.0 - 2.0 * (count - 2.0 * floor(0.5 * count))
    return c * ar - s * ai, c * ai + s * ar, odd * (c * br - s * bi), odd * (c * bi + s * br)


def state_of(m: Motion, spinor: Spinor) -> State:
    """Return attitude and momentum."""
    a0, a1, b0, b1 = spinor
    aa, bb = a0 * a0 + a1 * a1, b0 * b0 + b1 * b1
    x = 1.0 / (aa + bb)
    root = square_root(x)
    x2 = x + x
    # the direction of L of a spinor (A, B): 2 Re ĀB, 2 Im ĀB and |A|² − |B|², over |A|² + |B|²
    n0, n1, n2 = (a0 * b0 + a1 * b1) * x2, (a0 * b1 - a1 * b0) * x2, (aa - bb) * x
    a, b, c, d = a0 * root, a1 * root, b0 * root, b1 * root
    q = m.to_attitude
    p = m.to_momentum
    return (
        ((q[0] * a + q[1] * b) + q[2] * c) + q[3] * d, ((q[4] * a + q[5] * b) + q[6] * c) + q[7] * d,
        ((q[8] * a + q[9] * b) + q[10] * c) + q[11] * d, ((q[12] * a + q[13] * b) + q[14] * c) + q[15] * d,
        (p[0] * n0 + p[1] * n1) + p[2] * n2, (p[3] * n0 + p[4] * n1) + p[5] * n2, (p[6] * n0 + p[7] * n1) + p[8] * n2,
    )  # fmt: skip
