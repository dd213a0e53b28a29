"""From frequencies and poles of a block of tops to the columns of ``formulas.Motion``, compiled by Numba.

The steps of ``preparation._motion``.
"""

from __future__ import annotations

import math
from typing import Any

from polhode._base.compiled.copying import called
from polhode.exact._formulas import nome_per_parameter
from polhode.exact._kernel_arithmetic import (
    divide,
    exponential,
    halves,
    pair,
    put_record,
    scale,
    square_root,
)
from polhode.exact._kernel_loops import SUMS
from polhode.exact.lagrange_top import _kernel_store as at
from polhode.exact.lagrange_top._formulas import A_SUM, NOME, PHASES, RATES, REVERSED, THIRD, sums_at
from polhode.exact.lagrange_top._formulas_setup import (
    complementary_series,
    constant_phases,
    full_sizes,
    full_terms,
    half_periods,
    periods,
)


@called
def _poles(w: Any, count: int) -> None:
    """Put the nome of the smaller parameter, and the places of the poles in units of its half period."""
    for i in range(count):
        # m = (A − B)/A = G (u2 − u1)/A and 1 − m = B/A; θ3 = 1 + 2(q + q⁴ + q⁹ + …), whose square is 2K/π (DLMF 22.2.2)
        small = min(w[at.G + i] * w[at.GAP + i], w[at.B + i]) / w[at.A + i]
        q = small * nome_per_parameter(small, square_root(1.0 - small))
        q4 = (q * q) * (q * q)
        theta3 = 1.0 + 2.0 * (q + q4 + q4 * q4 * q)
        by = 1.0 / (theta3 * theta3)
        w[at.NOME + i], w[at.THETA3 + i] = q, theta3
        w[at.Y_ALPHA + i], w[at.Y_BETA + i] = w[at.V_ALPHA + i] * by, w[at.V_BETA + i] * by
        w[at.W_ALPHA + i], w[at.W_BETA + i] = w[at.W_ALPHA + i] * by, w[at.W_BETA + i] * by


@called
def _full_series(w: Any, full: int, m: Any) -> None:
    """Put the series of the full form into the motion."""
    for i in range(full):
        w[at.R_ALPHA + i] = exponential(-2.0 * w[at.W_ALPHA + i])
        w[at.R_BETA + i] = exponential(-2.0 * w[at.W_BETA + i])
        w[at.V_ALPHA + i] = exponential(-2.0 * w[at.Y_ALPHA + i])
        w[at.V_BETA + i] = exponential(-2.0 * w[at.Y_BETA + i])
    for i in range(full):
        q, theta3 = w[at.NOME + i], w[at.THETA3 + i]
        of_alpha, of_beta = full_sizes(square_root(0.5 * w[at.T2 + i]), square_root(0.5 * w[at.S1 + i]), q, theta3)
        a_sum, a_gap = full_terms(of_alpha, w[at.V_ALPHA + i], q, w[at.R_ALPHA + i], -1.0)
        b_sum, b_gap = full_terms(of_beta, w[at.V_BETA + i], q, w[at.R_BETA + i], 1.0)
        put_record(m, A_SUM + i, (*a_sum, *a_gap, *b_sum, *b_gap, 0.0))


@called
def _complementary_series(w: Any, count: int, m: Any) -> None:
    """Put the series of the complementary form into the motion."""
    for i in range(count):
        root_t, root_s = square_root(0.5 * w[at.T2 + i]), square_root(0.5 * w[at.S1 + i])
        a_sine, a_cosine, b_cosine, b_sine, last = complementary_series(
            root_t, root_s, w[at.NOME + i], w[at.THETA3 + i], w[at.Y_ALPHA + i], w[at.Y_BETA + i]
        )
        put_record(m, A_SUM + i, (*a_sine, *a_cosine, *b_cosine, *b_sine, last))


@called
def _put_motion(w: Any, count: int, m: Any, complementary: float) -> None:
    """Put the rest of ``preparation._motion`` into the motion, apart from the constant phases."""
    for i in range(count):
        nutation, half_root = pair(w, at.NUTATION + i), pair(w, at.HALF_ROOT + i)
        q, theta3, sa, sb = w[at.NOME + i], w[at.THETA3 + i], w[at.SIGN_A + i], w[at.SIGN_B + i]
        third = scale(half_periods(nutation, w[at.I1 + i], w[at.RATE + i]), 0.5 + 0.5 * complementary)
        K, period = periods(half_root, nutation, q)
        start = scale(divide(pair(w, at.X0 + i), K), 0.25 + 0.25 * complementary)
        upper, lower = halves(period[0])
        put_record(m, THIRD + i, (*halves(third[0]), third[1], *start))
        ya, yb = complementary * w[at.Y_ALPHA + i], complementary * w[at.Y_BETA + i]
        put_record(m, NOME + i, (q, upper, lower + period[1], ya / math.pi, yb / math.pi, 1.0, sa, sb))
        carried = nutation[0] * (2.0 / math.pi)
        linear_a, linear_b = w[at.ALPHA + i] + sa * ya * carried, w[at.BETA + i] + sb * yb * carried
        turn = complementary * (half_root[0] / (theta3 * theta3)) + (1.0 - complementary) * nutation[0]
        w[at.LINEAR_A + i], w[at.LINEAR_B + i], w[at.TURN + i] = linear_a, linear_b, turn
        put_record(m, RATES + i, (
            2.0 * turn * w[at.SIZE + i], 2.0 * (linear_a + linear_b) * w[at.SIZE + i], 1.0, 0.0, 1.0, 0.0
        ))
        m[REVERSED + i] = w[at.SIDE + i]


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


@called
def phases(w: Any, count: int, m: Any, work: Any) -> None:
    """Put the constant phases into the motion, of the sums at the epoch."""
    for i in range(count):
        x, y, z = w[at.L1 + i], w[at.L2 + i], w[at.L3 + i]
        put_record(m, PHASES + i, constant_phases(
            (w[at.E0 + i], w[at.E1 + i], w[at.E2 + i], w[at.E3 + i]), pair(w, at.NORM + i), (x, y, z),
            (x * x + y * y) + (z * z + w[at.G + i]), sums_at(work, SUMS + i),
            (w[at.LINEAR_A + i], w[at.LINEAR_B + i]), w[at.TURN + i],
        ))
