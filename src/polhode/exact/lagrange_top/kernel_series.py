"""From frequencies and poles of a block of tops to the columns of ``series.Motion``, compiled by Numba.

The steps of ``preparation._motion``.
"""

from __future__ import annotations

import math
from typing import Any

from polhode.exact.kernel_arithmetic import (
    BLOCK,
    add,
    called,
    divide,
    exponential,
    halves,
    inlined,
    multiply,
    multiply_float,
    pair,
    root,
    scale,
    sine_cosine,
    square_root,
    whole,
)
from polhode.exact.kernel_loops import SUMS
from polhode.exact.lagrange_top import kernel_store as at
from polhode.exact.lagrange_top.formulas import sums_at
from polhode.special.doubledouble import PI

PI_HIGH, PI_LOW = PI
Four = tuple[float, float, float, float]


@inlined
def _nome(parameter: float) -> float:
    """Return ``elliptic.nome``."""
    k = square_root(1.0 - parameter)
    more = 1.0 + square_root(k)
    ratio = 0.5 / ((1.0 + k) * more * more)
    e = ratio * parameter
    e4 = (e * e) * (e * e)
    return parameter * (ratio * (1.0 + e4 * (2.0 + e4 * (15.0 + e4 * (150.0 + e4 * 1707.0)))))


@called
def _poles(w: Any, count: int) -> None:
    """Put the nome of the smaller parameter, and the places of the poles in units of its half period."""
    for i in range(count):
        small = min(w[at.G + i] * w[at.GAP + i], w[at.B + i]) / w[at.A + i]
        q = _nome(small)
        q4 = (q * q) * (q * q)
        theta3 = 1.0 + 2.0 * (q + q4 + q4 * q4 * q)
        by = 1.0 / (theta3 * theta3)
        w[at.NOME + i], w[at.THETA3 + i] = q, theta3
        w[at.Y_ALPHA + i], w[at.Y_BETA + i] = w[at.V_ALPHA + i] * by, w[at.V_BETA + i] * by
        w[at.W_ALPHA + i], w[at.W_BETA + i] = w[at.W_ALPHA + i] * by, w[at.W_BETA + i] * by


@inlined
def _put_sums(m: Any, k: int, size: float, h: float, q: float, r: float, alternating: float) -> None:
    """Put sums and differences of one series of ``preparation._full_series`` into rows k to k + 7."""
    n = BLOCK
    w1, w2, w3 = q * r, q * q * r, q * q * q * r
    w2, w3 = w2 * w2, w3 * w3 * w3
    h3 = h * h * h
    h5, h7 = h3 * h * h, h3 * h3 * h
    size = size / (((w3 * (1.0 + h7) + w2 * (1.0 + h5)) + w1 * (1.0 + h3)) + (1.0 + h))
    w1, w2, w3 = alternating * size * w1, size * w2, alternating * size * w3
    m[k], m[k + n], m[k + 2 * n], m[k + 3 * n] = size * (1.0 + h), w1 * (1.0 + h3), w2 * (1.0 + h5), w3 * (1.0 + h7)
    k += 4 * n
    m[k], m[k + n], m[k + 2 * n], m[k + 3 * n] = size * (1.0 - h), w1 * (1.0 - h3), w2 * (1.0 - h5), w3 * (1.0 - h7)


@called
def _full_series(w: Any, full: int, m: Any) -> None:
    """Put the series of ``preparation._full_series`` into rows 12 to 28."""
    n = BLOCK
    for i in range(full):
        w[at.R_ALPHA + i] = exponential(-2.0 * w[at.W_ALPHA + i])
        w[at.R_BETA + i] = exponential(-2.0 * w[at.W_BETA + i])
        w[at.V_ALPHA + i] = exponential(-2.0 * w[at.Y_ALPHA + i])
        w[at.V_BETA + i] = exponential(-2.0 * w[at.Y_BETA + i])
    for i in range(full):
        q, theta3 = w[at.NOME + i], w[at.THETA3 + i]
        q4 = (q * q) * (q * q)
        theta4 = 1.0 - 2.0 * (q - q4 + q4 * q4 * q)
        of_alpha = square_root(0.5 * w[at.T2 + i]) * theta3
        of_beta = square_root(0.5 * w[at.S1 + i]) * theta4
        _put_sums(m, 12 * n + i, of_alpha, w[at.V_ALPHA + i], q, w[at.R_ALPHA + i], -1.0)
        _put_sums(m, 20 * n + i, of_beta, w[at.V_BETA + i], q, w[at.R_BETA + i], 1.0)
        m[28 * n + i] = 0.0


@inlined
def _multiples(y: float) -> tuple[Four, Four]:
    """Return cos ky and sin ky for k = 1 to 4 of 0 ≤ y ≤ π/2."""
    turns = y * (0.5 / math.pi)
    s1, c1 = sine_cosine(turns)
    s2, c2 = 2.0 * s1 * c1, 1.0 - 2.0 * s1 * s1
    return (c1, c2, c2 * c1 - s2 * s1, 1.0 - 2.0 * s2 * s2), (s1, s2, s2 * c1 + c2 * s1, 2.0 * s2 * c2)


@called
def _complementary_series(w: Any, count: int, m: Any) -> None:
    """Put the series of ``preparation._complementary_series`` into rows 12 to 28."""
    n = BLOCK
    for i in range(count):
        q, theta3 = w[at.NOME + i], w[at.THETA3 + i]
        q2 = q * q
        q4, q6 = q2 * q2, q2 * q2 * q2
        q9 = q6 * q2 * q
        c, s = _multiples(w[at.Y_ALPHA + i])
        theta4 = 1.0 - 2.0 * ((q * c[1] - q4 * c[3]) + q9 * (2.0 * c[2] * c[2] - 1.0))
        size = square_root(0.5 * w[at.T2 + i]) * theta3 / theta4
        c5, s5 = c[3] * c[0] - s[3] * s[0], s[3] * c[0] + c[3] * s[0]
        c7, s7 = c[3] * c[2] - s[3] * s[2], s[3] * c[2] + c[3] * s[2]
        m[12 * n + i], m[13 * n + i] = size * s[0], -size * s[2]
        m[14 * n + i], m[15 * n + i] = size * s5, -size * s7
        m[16 * n + i], m[17 * n + i] = size * c[0], -size * c[2]
        m[18 * n + i], m[19 * n + i] = size * c5, -size * c7
        c, s = _multiples(2.0 * w[at.Y_BETA + i])
        theta4 = 1.0 - 2.0 * ((q * c[0] - q4 * c[1]) + q9 * c[2])
        size = square_root(0.5 * w[at.S1 + i]) * (1.0 + q2 + q6 + q6 * q6) / theta4
        m[20 * n + i], m[21 * n + i] = -size * c[0], size * c[1]
        m[22 * n + i], m[23 * n + i] = -size * c[2], size * c[3]
        m[24 * n + i], m[25 * n + i] = -size * s[0], size * s[1]
        m[26 * n + i], m[27 * n + i] = -size * s[2], size * s[3]
        m[28 * n + i] = size


@called
def _put_motion(w: Any, count: int, m: Any, complementary: float) -> None:
    """Put the rest of ``preparation._motion`` into the motion, apart from the constant phases."""
    n = BLOCK
    for i in range(count):
        pi, nutation, half_root = (PI_HIGH, PI_LOW), pair(w, at.NUTATION + i), pair(w, at.HALF_ROOT + i)
        q, theta3, sa, sb = w[at.NOME + i], w[at.THETA3 + i], w[at.SIGN_A + i], w[at.SIGN_B + i]
        third = divide(scale(nutation, w[at.RATE + i]), multiply_float(pi, w[at.I1 + i]))
        third = scale(third, 0.5 + 0.5 * complementary)
        K = divide(scale(multiply(half_root, pi), 0.5), nutation)
        start = scale(divide(pair(w, at.X0 + i), K), 0.25 + 0.25 * complementary)
        period = scale(K, 2.0)
        q4 = (q * q) * (q * q)
        shrink = 2.0 * (q + q4 + q4 * q4 * q)
        period = add(period, (-period[0] * (shrink * (2.0 + shrink) / (theta3 * theta3)), 0.0))
        m[7 * n + i], m[8 * n + i] = halves(third[0])
        m[9 * n + i], m[10 * n + i], m[11 * n + i] = third[1], start[0], start[1]
        upper, lower = halves(period[0])
        m[29 * n + i], m[30 * n + i], m[31 * n + i] = q, upper, lower + period[1]
        ya, yb = complementary * w[at.Y_ALPHA + i], complementary * w[at.Y_BETA + i]
        m[32 * n + i], m[33 * n + i], m[34 * n + i] = ya / math.pi, yb / math.pi, 1.0
        m[35 * n + i], m[36 * n + i] = sa, sb
        carried = nutation[0] * (2.0 / math.pi)
        linear_a, linear_b = w[at.ALPHA + i] + sa * ya * carried, w[at.BETA + i] + sb * yb * carried
        turn = complementary * (half_root[0] / (theta3 * theta3)) + (1.0 - complementary) * nutation[0]
        w[at.LINEAR_A + i], w[at.LINEAR_B + i], w[at.TURN + i] = linear_a, linear_b, turn
        m[37 * n + i] = 2.0 * turn * w[at.SIZE + i]
        m[38 * n + i] = 2.0 * (linear_a + linear_b) * w[at.SIZE + i]
        m[39 * n + i] = m[41 * n + i] = 1.0
        m[40 * n + i] = m[42 * n + i] = 0.0
        m[44 * n + i] = w[at.SIDE + i]


@called
def series(w: Any, full: int, count: int, m: Any) -> None:
    """Put the columns of ``preparation._motion`` into the motion, apart from the constant phases.

    Args:
        w: store of tops, those of the full form first.
        full: how many these are.
        count: of all tops.
        m: columns of the motion in rows of BLOCK.
    """
    _poles(w, count)
    _full_series(w, full, m)
    _complementary_series(w[full:], count - full, m[full:])
    _put_motion(w, full, m, 0.0)
    _put_motion(w[full:], count - full, m[full:], 1.0)


@inlined
def _constant_phase(
    r: float, i: float, dr: float, di: float, turns: float, rate: float, given: tuple[float, float],
    slope: tuple[float, float], norm: float, drop: float, turn: float, size: float,
) -> tuple[float, float]:  # fmt: skip
    """Return cos and sin of the phase that turns A or B at the epoch into the given α or β."""
    r, i = r / norm, i / norm
    sr = turn * (dr / norm - r * drop) - rate * i
    si = turn * (di / norm - i * drop) + rate * r
    (gr, gi), (er, ei) = given, slope
    real = (r * gr + i * gi) + (sr * er + si * ei) / size
    imaginary = (r * gi - i * gr) + (sr * ei - si * er) / size
    s, c = sine_cosine(turns - whole(turns))
    real, imaginary = real * c + imaginary * s, imaginary * c - real * s
    length = square_root(real * real + imaginary * imaginary)
    some = length > 0.0
    return (real / length if some else 1.0), (imaginary / length if some else 0.0)


@called
def phases(w: Any, count: int, m: Any, work: Any) -> None:
    """Put the constant phases of ``preparation._constant_phases`` into the motion, of the numerators at the epoch."""
    n = BLOCK
    for i in range(count):
        x, y, z = w[at.L1 + i], w[at.L2 + i], w[at.L3 + i]
        length = root(pair(w, at.NORM + i))
        q0, q1 = divide((w[at.E0 + i], 0.0), length)[0], divide((w[at.E1 + i], 0.0), length)[0]
        q2, q3 = divide((w[at.E2 + i], 0.0), length)[0], divide((w[at.E3 + i], 0.0), length)[0]
        a = 0.5 * (-z * q3 - (x * q1 + y * q2)), 0.5 * (z * q0 - (x * q2 - y * q1))
        b = 0.5 * (x * q0 - y * q3 + z * q2), 0.5 * (x * q3 + y * q0 - z * q1)
        ar, ai, br, bi, dar, dai, dbr, dbi, turns_a, turns_b = sums_at(work, SUMS + i)
        square = (ar * ar + ai * ai) + (br * br + bi * bi)
        norm = square_root(square)
        drop = ((ar * dar + ai * dai) + (br * dbr + bi * dbi)) / square
        size, turn = (x * x + y * y) + (z * z + w[at.G + i]), w[at.TURN + i]
        m[39 * n + i], m[40 * n + i] = _constant_phase(
            ar, ai, dar, dai, turns_a, w[at.LINEAR_A + i], (q0, q3), a, norm, drop, turn, size)
        m[41 * n + i], m[42 * n + i] = _constant_phase(
            br, bi, dbr, dbi, turns_b, w[at.LINEAR_B + i], (q1, q2), b, norm, drop, turn, size)  # fmt: skip
