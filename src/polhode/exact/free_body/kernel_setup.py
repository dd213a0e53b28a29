"""The set-up of many bodies, from moments to the columns of ``spinor.Motion``, compiled by Numba.

The same steps as ``reduction``, ``frequencies`` and ``preparation``, in blocks of bodies and in loops that LLVM turns
into vector instructions. Bodies are sorted on the way: those that take the full form first, then those that take the
complementary one.
"""

from __future__ import annotations

import math
from typing import Any

from polhode.exact.free_body.formulas import COLUMNS, sums_at
from polhode.exact.free_body.kernel_rates import rates
from polhode.exact.free_body.kernel_reduction import (
    ACROSS,
    E0,
    E1,
    E2,
    E3,
    FAST,
    FAST_,
    FIRST,
    HALF,
    L2,
    LONG,
    MEAN,
    MEAN_,
    PARITY,
    ROWS,
    SECOND,
    SIZE,
    THIRD,
    UP,
    X1,
    X3,
    A,
    B,
    C,
    G,
    P,
    Q,
    S,
    begin,
)  # fmt: skip
from polhode.exact.kernel_agm import STEPS
from polhode.exact.kernel_arithmetic import (
    BLOCK,
    Pair,
    add,
    called,
    divide,
    entry,
    fast_two_sum,
    halves,
    inlined,
    multiply,
    places,
    room,
    scale,
    sine_cosine,
    square_root,
    whole,
)
from polhode.exact.kernel_loops import SUMS, WORK, sums_of_many
from polhode.special.doubledouble import PI

WORTH = 2_000  # bodies for which a thread is worth its start
PI_HIGH, PI_LOW = PI


@inlined
def _landen_step(
    x: float, y: float, dn: float, factor: float, sinh: float, cosine: float, dc: float
) -> tuple[float, float, float, float, float, float]:
    """Return x, y, dn, factor, sinh and dc after a step of ``preparation._landen``."""
    kappa = (x - y) / (x + y)
    grown = 1.0 + kappa
    next_dn = square_root(1.0 - kappa * (1.0 - dn) / (1.0 + dn))
    sinh = 2.0 * sinh / (grown * (cosine + dc))
    next_dc = square_root(1.0 + kappa * (dc - cosine) / (dc + cosine))
    return 0.5 * (x + y), square_root(x * y), next_dn, factor * (next_dn / grown), sinh, next_dc


@inlined
def _landen(k: float, dn: float, sinh: float, cosine: float, dc: float) -> Pair:
    x, y, dn, factor, sinh, dc = _landen_step(1.0, k, dn, 1.0, sinh, cosine, dc)
    x, y, dn, factor, sinh, dc = _landen_step(x, y, dn, factor, sinh, 1.0, dc)
    x, y, dn, factor, sinh, dc = _landen_step(x, y, dn, factor, sinh, 1.0, dc)
    x, y, dn, factor, sinh, dc = _landen_step(x, y, dn, factor, sinh, 1.0, dc)
    x, y, dn, factor, sinh, dc = _landen_step(x, y, dn, factor, sinh, 1.0, dc)
    return factor, sinh


@inlined
def _nome_per_parameter(parameter: float, k: float) -> float:
    """Return ``elliptic.nome_per_parameter``."""
    more = 1.0 + square_root(k)
    ratio = 0.5 / ((1.0 + k) * more * more)
    e = ratio * parameter
    e4 = (e * e) * (e * e)
    return ratio * (1.0 + e4 * (2.0 + e4 * (15.0 + e4 * (150.0 + e4 * 1707.0))))


@called
def _full_arguments(w: Any, full: int, m: Any) -> None:
    """Put start and series of ``preparation._full_arguments`` into the motion."""
    n = BLOCK
    for i in range(full):
        A0, B0, C0, P0, Q0 = w[A + i], w[B + i], w[C + i], w[P + i], w[Q + i]
        total = B0 * Q0
        k, parameter = square_root(C0 * w[S + i] / total), A0 * P0 / total
        per_parameter = _nome_per_parameter(parameter, k)
        q = per_parameter * parameter
        small = square_root(P0) / square_root(Q0)
        of_b, of_c = square_root(B0), square_root(C0)
        factor, scaled = _landen(k, w[X3 + i] * square_root(C0 / Q0), of_b, of_b, of_c)
        w[UP + i], w[ACROSS + i] = of_b * w[L2 + i] * factor, of_c * w[X1 + i]
        grown = scaled + square_root(small * small + scaled * scaled)
        g = small / grown
        r = (A0 / B0) * per_parameter * grown * grown
        g2, q2, r2 = g * g, q * q, r * r
        q3, q4 = q2 * q, q2 * q2
        q8, gg = q4 * q4, g2 * g2
        up, down, up2, down2 = -q * g2, -q2 * r, q4 * q2 * gg, q8 * r2
        m[9 * n + i], m[10 * n + i], m[11 * n + i] = 1.0 - (up2 + down2), up + down, 2.0 * (up2 + down2)
        m[12 * n + i], m[13 * n + i] = up - down, 2.0 * (up2 - down2)
        up, up2, down2 = -q3 * g2, q8 * q2 * gg, q4 * r2
        m[14 * n + i], m[15 * n + i], m[16 * n + i] = g * (1.0 - (up2 + down2)), g * (up - r), 2.0 * g * (up2 + down2)
        m[17 * n + i], m[18 * n + i] = g * (up + r), 2.0 * g * (up2 - down2)
        m[8 * n + i] = m[19 * n + i] = m[20 * n + i] = m[21 * n + i] = 0.0
        m[22 * n + i] = m[23 * n + i] = m[24 * n + i] = 0.0
    for i in range(full):
        m[7 * n + i] = math.atan2(w[UP + i], w[ACROSS + i]) * (0.25 / math.pi)


@called
def _complementary_arguments(w: Any, count: int, m: Any) -> None:
    """Put start, harmonics and nome of ``preparation._complementary_arguments`` into the motion."""
    n = BLOCK
    for i in range(count):
        B0, C0, P0, Q0 = w[B + i], w[C + i], w[P + i], w[Q + i]
        total = B0 * Q0
        k, parameter = square_root(w[A + i] * P0 / total), C0 * w[S + i] / total
        m[19 * n + i] = parameter * _nome_per_parameter(parameter, k)
        of_c = square_root(C0)
        cosine, dc = of_c * abs(w[X1 + i]), of_c * w[X3 + i] * square_root(P0 / Q0)
        factor, sinh = _landen(k, square_root(P0 / B0) / w[G + i], abs(square_root(B0) * w[L2 + i]), cosine, dc)
        w[UP + i], w[ACROSS + i] = sinh, square_root(Q0 / P0) * factor
    for i in range(count):
        x = math.asinh(w[UP + i])
        m[7 * n + i], m[8 * n + i] = x, math.sinh(x)
        m[22 * n + i] = math.atan(w[ACROSS + i])
    for i in range(count):
        sinh, x, back, y, q = w[UP + i], m[7 * n + i], m[8 * n + i], m[22 * n + i], m[19 * n + i]
        side = -1.0 if (w[L2 + i] < 0.0) != (w[X1 + i] < 0.0) else 1.0
        x = scale(fast_two_sum(x, (sinh - back) / square_root(1.0 + back * back)), side)
        period = divide(multiply((w[FAST + i], w[FAST_ + i]), (PI_HIGH, PI_LOW)), (w[MEAN + i], w[MEAN_ + i]))
        q4 = (q * q) * (q * q)
        e = 2.0 * (q + q4 + q4 * q4 * q)
        period = add(period, (-period[0] * (e * (2.0 + e) / ((1.0 + e) * (1.0 + e))), 0.0))
        m[7 * n + i], m[8 * n + i] = divide(x, period)
        upper, lower = halves(period[0])
        m[19 * n + i], m[20 * n + i], m[21 * n + i] = square_root(q), upper, lower + period[1]
        angle = (0.5 * y - 0.25 * math.pi) * (0.5 / math.pi)
        m[14 * n + i], m[9 * n + i] = sine_cosine(angle)
        m[15 * n + i], m[10 * n + i] = sine_cosine(3.0 * angle)
        m[16 * n + i], m[11 * n + i] = sine_cosine(5.0 * angle - whole(5.0 * angle))
        m[17 * n + i], m[12 * n + i] = sine_cosine(7.0 * angle - whole(7.0 * angle))
        m[18 * n + i], m[13 * n + i] = sine_cosine(9.0 * angle - whole(9.0 * angle))
        m[22 * n + i], m[23 * n + i], m[24 * n + i] = y * (0.5 / math.pi), 1.0, 1.0 if w[X1 + i] < 0.0 else 0.0


@inlined
def _put_column(
    w: Any, i: int, m: Any, k: int, scalar: float, x: float, y: float, z: float, first: float, second: float
) -> None:
    """Store one column of the matrix from spinor to attitude: the given attitude times a quaternion."""
    x, y, z = (
        x if first == 0.0 else y if second == 0.0 else z,
        x if first == 1.0 else y if second == 1.0 else z,
        x if first == 2.0 else y if second == 2.0 else z,
    )
    a, b, c, d = w[E0 + i], w[E1 + i], w[E2 + i], w[E3 + i]
    m[(25 + k) * BLOCK + i] = ((a * scalar - b * x) - c * y) - d * z
    m[(29 + k) * BLOCK + i] = ((a * x + b * scalar) + c * z) - d * y
    m[(33 + k) * BLOCK + i] = ((a * y - b * z) + c * scalar) + d * x
    m[(37 + k) * BLOCK + i] = ((a * z + b * y) - c * x) + d * scalar


@called
def _matrices(w: Any, count: int, m: Any, spinor: Any) -> None:
    """Put the matrices of ``preparation._matrices`` into the motion."""
    n = BLOCK
    for i in range(count):
        a0, a1, b0, b1 = sums_at(spinor, SUMS + i)
        norm = square_root((a0 * a0 + a1 * a1) + (b0 * b0 + b1 * b1))
        a0, a1, b0, b1 = a0 / norm, a1 / norm, b0 / norm, b1 / norm
        long_axis = w[LONG + i] < 0.0
        first, second = (w[THIRD + i] if long_axis else w[FIRST + i]), w[SECOND + i]
        third = w[FIRST + i] if long_axis else w[THIRD + i]
        middle, outer = w[PARITY + i], w[PARITY + i] * w[HALF + i]
        f, g = w[LONG + i] * outer, w[LONG + i] * middle
        _put_column(w, i, m, 0, a0, -f * b1, g * b0, -f * a1, first, second)
        _put_column(w, i, m, 1, a1, f * b0, g * b1, f * a0, first, second)
        _put_column(w, i, m, 2, b0, -f * a1, -g * a0, f * b1, first, second)
        _put_column(w, i, m, 3, b1, f * a0, -g * a1, -f * b0, first, second)
        size = w[G + i] * w[SIZE + i]
        outer, middle = size * outer, size * middle
        m[41 * n + i], m[44 * n + i] = (outer if first == 0.0 else 0.0), (outer if first == 1.0 else 0.0)
        m[47 * n + i], m[42 * n + i] = (outer if first == 2.0 else 0.0), (middle if second == 0.0 else 0.0)
        m[45 * n + i], m[48 * n + i] = (middle if second == 1.0 else 0.0), (middle if second == 2.0 else 0.0)
        m[43 * n + i], m[46 * n + i] = (outer if third == 0.0 else 0.0), (outer if third == 1.0 else 0.0)
        m[49 * n + i] = outer if third == 2.0 else 0.0


@entry
def set_up(moments: Any, momentum: Any, attitude: Any, columns: Any, left: Any) -> None:
    begun, w, m = room(ROWS * BLOCK), room(ROWS * BLOCK), room(COLUMNS * BLOCK)
    steps, work, zeros, terms = room(STEPS * BLOCK), room(WORK * BLOCK), room(BLOCK), room(32)
    place, who = places(BLOCK), places(BLOCK)
    for low in range(0, len(moments), BLOCK):
        part = slice(low, low + BLOCK)
        full, count = begin(moments[part], momentum[part], begun, w, place, terms)
        for i in range(count):
            start = attitude[low + place[i]]
            w[E0 + i], w[E1 + i], w[E2 + i], w[E3 + i] = start[0], start[1], start[2], start[3]
        rates(w, full, count, steps, who, m)
        _full_arguments(w, full, m)
        _complementary_arguments(w[full:], count - full, m[full:])
        sums_of_many(m, full, count, zeros, zeros, work)
        _matrices(w, count, m, work)
        for i in range(count):
            columns[0][low + place[i]] = 1.0 if i < full else 0.0
            left[low + place[i]] = False
        for k in range(1, COLUMNS):
            column = columns[k]
            for i in range(count):
                column[low + place[i]] = m[k * BLOCK + i]
