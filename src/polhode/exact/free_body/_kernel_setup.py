"""The set-up of many bodies, from moments to the columns of ``formulas.Motion``, compiled by Numba.

The steps of ``formulas_setup`` in blocks of bodies and in loops that LLVM turns into vector instructions. Bodies are
sorted on the way: those that take the full form first, then those that take the complementary one.
"""

from __future__ import annotations

import math
from typing import Any

from polhode._base.compiled.copying import called, entry
from polhode.exact._formulas import nome_per_parameter
from polhode.exact._kernel_agm import STEPS
from polhode.exact._kernel_arithmetic import (
    BLOCK,
    divide,
    fast_two_sum,
    halves,
    pair,
    places,
    put,
    put_record,
    room,
    scale,
    square_root,
)
from polhode.exact._kernel_loops import SUMS, WORK, sums_of_many
from polhode.exact.free_body import _kernel_store as at
from polhode.exact.free_body._formulas import COLUMNS, NOME, SERIES, START, TO_ATTITUDE, TO_MOMENTUM, Y_TURNS, sums_at
from polhode.exact.free_body._formulas_setup import (
    complementary_amplitudes,
    full_arguments,
    half_period,
    harmonics,
    landen,
)
from polhode.exact.free_body._kernel_rates import rates
from polhode.exact.free_body._kernel_reduction import begin
from polhode.exact.free_body._kernel_store import ROWS

WORTH = 2_000  # bodies for which a thread is worth its start


@called
def _full_arguments(w: Any, full: int, m: Any) -> None:
    """Put start and series of the full form into the motion."""
    for i in range(full):
        A0, B0, C0, P0, Q0 = w[at.A + i], w[at.B + i], w[at.C + i], w[at.P + i], w[at.Q + i]
        momentum = w[at.X1 + i], w[at.L2 + i], w[at.X3 + i]
        w[at.UP + i], w[at.ACROSS + i], series = full_arguments(
            A0, B0, C0, Q0, (A0 * P0, C0 * w[at.S + i]), square_root(P0), momentum
        )
        put_record(m, SERIES + i, series)
        put_record(m, START + BLOCK + i, (0.0,))
        put_record(m, NOME + i, (0.0, 0.0, 0.0, 0.0, 0.0, 0.0))
    for i in range(full):
        m[START + i] = math.atan2(w[at.UP + i], w[at.ACROSS + i]) * (0.25 / math.pi)


@called
def _complementary_arguments(w: Any, count: int, m: Any) -> None:
    """Put start, harmonics and nome of the complementary form into the motion."""
    for i in range(count):
        B0, C0, P0, Q0 = w[at.B + i], w[at.C + i], w[at.P + i], w[at.Q + i]
        total = B0 * Q0
        k, parameter = square_root(w[at.A + i] * P0 / total), C0 * w[at.S + i] / total
        m[NOME + i] = parameter * nome_per_parameter(parameter, k)
        momentum = w[at.X1 + i], w[at.L2 + i], w[at.X3 + i]
        dn, along, cosine, dc = complementary_amplitudes(B0, C0, P0, Q0, w[at.G + i], momentum)
        factor, w[at.UP + i] = landen(k, dn, along, cosine, dc)
        w[at.ACROSS + i] = square_root(Q0 / P0) * factor
    for i in range(count):
        x = math.asinh(w[at.UP + i])
        m[START + i], m[START + BLOCK + i] = x, math.sinh(x)
        m[Y_TURNS + i] = math.atan(w[at.ACROSS + i])
    for i in range(count):
        sinh, y, q = w[at.UP + i], m[Y_TURNS + i], m[NOME + i]
        x, back = pair(m, START + i)
        side = -1.0 if (w[at.L2 + i] < 0.0) != (w[at.X1 + i] < 0.0) else 1.0
        x = scale(fast_two_sum(x, (sinh - back) / square_root(1.0 + back * back)), side)
        period = half_period(pair(w, at.FAST + i), pair(w, at.MEAN + i), q)
        put(m, START + i, divide(x, period))
        put_record(m, SERIES + i, harmonics(y))
        upper, lower = halves(period[0])
        parity = 1.0 if w[at.X1 + i] < 0.0 else 0.0
        put_record(m, NOME + i, (square_root(q), upper, lower + period[1], y * (0.5 / math.pi), 1.0, parity))


def _put_column(
    w: Any, i: int, m: Any, k: int, scalar: float, x: float, y: float, z: float, first: float, second: float
) -> None:
    """Store one column of the matrix from spinor to attitude: the given attitude times a quaternion."""
    x, y, z = (
        x if first == 0.0 else y if second == 0.0 else z,
        x if first == 1.0 else y if second == 1.0 else z,
        x if first == 2.0 else y if second == 2.0 else z,
    )
    a, b, c, d = w[at.E0 + i], w[at.E1 + i], w[at.E2 + i], w[at.E3 + i]
    m[TO_ATTITUDE + k * BLOCK + i] = ((a * scalar - b * x) - c * y) - d * z
    m[TO_ATTITUDE + (4 + k) * BLOCK + i] = ((a * x + b * scalar) + c * z) - d * y
    m[TO_ATTITUDE + (8 + k) * BLOCK + i] = ((a * y - b * z) + c * scalar) + d * x
    m[TO_ATTITUDE + (12 + k) * BLOCK + i] = ((a * z + b * y) - c * x) + d * scalar


@called
def _matrices(w: Any, count: int, m: Any, spinor: Any) -> None:
    """Put the matrices of ``preparation._matrices`` into the motion."""
    for i in range(count):
        a0, a1, b0, b1 = sums_at(spinor, SUMS + i)
        norm = square_root((a0 * a0 + a1 * a1) + (b0 * b0 + b1 * b1))
        a0, a1, b0, b1 = a0 / norm, a1 / norm, b0 / norm, b1 / norm
        long_axis = w[at.LONG + i] < 0.0
        first, second = (w[at.THIRD + i] if long_axis else w[at.FIRST + i]), w[at.SECOND + i]
        third = w[at.FIRST + i] if long_axis else w[at.THIRD + i]
        middle, outer = w[at.PARITY + i], w[at.PARITY + i] * w[at.HALF + i]
        f, g = w[at.LONG + i] * outer, w[at.LONG + i] * middle
        _put_column(w, i, m, 0, a0, -f * b1, g * b0, -f * a1, first, second)
        _put_column(w, i, m, 1, a1, f * b0, g * b1, f * a0, first, second)
        _put_column(w, i, m, 2, b0, -f * a1, -g * a0, f * b1, first, second)
        _put_column(w, i, m, 3, b1, f * a0, -g * a1, -f * b0, first, second)
        size = w[at.G + i] * w[at.SIZE + i]
        outer, middle = size * outer, size * middle
        put_record(m, TO_MOMENTUM + i, (
            outer if first == 0.0 else 0.0, middle if second == 0.0 else 0.0, outer if third == 0.0 else 0.0,
            outer if first == 1.0 else 0.0, middle if second == 1.0 else 0.0, outer if third == 1.0 else 0.0,
            outer if first == 2.0 else 0.0, middle if second == 2.0 else 0.0, outer if third == 2.0 else 0.0,
        ))


@entry
def set_up(moments: Any, momentum: Any, attitude: Any, columns: Any, left: Any, first: int) -> None:
    begun, w, m = room(ROWS * BLOCK), room(ROWS * BLOCK), room(COLUMNS * BLOCK)
    steps, work, zeros, terms = room(STEPS * BLOCK), room(WORK * BLOCK), room(BLOCK), room(32)
    place, who = places(BLOCK), places(BLOCK)
    for low in range(0, len(moments), BLOCK):
        part = slice(low, low + BLOCK)
        full, count = begin(moments[part], momentum[part], begun, w, place, terms)
        for i in range(count):
            start = attitude[low + place[i]]
            put_record(w, at.E0 + i, (start[0], start[1], start[2], start[3]))
        rates(w, full, count, steps, who, m)
        _full_arguments(w, full, m)
        _complementary_arguments(w[full:], count - full, m[full:])
        sums_of_many(m, full, count, zeros, zeros, zeros, work)
        _matrices(w, count, m, work)
        for i in range(count):
            columns[0][first + low + place[i]] = 1.0 if i < full else 0.0
            left[low + place[i]] = False
        for k in range(1, COLUMNS):
            column = columns[k]
            for i in range(count):
                column[first + low + place[i]] = m[k * BLOCK + i]
