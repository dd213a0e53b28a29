"""The steps of ``frequencies`` for a block of bodies, compiled by Numba."""

from __future__ import annotations

from typing import Any

from polhode.exact.free_body.kernel_reduction import (
    A_,
    B_,
    C_,
    FAST,
    FAST_,
    G_,
    GG,
    GG_,
    HALF,
    I1,
    I2,
    I3,
    L1,
    L3,
    LEAD,
    LEAD_,
    LONG,
    MEAN,
    MEAN_,
    P_,
    Q_,
    RATE,
    S_,
    SUM,
    SUM_,
    V_,
    X1,
    X3,
    A,
    B,
    C,
    G,
    P,
    Q,
    S,
    V,
)  # fmt: skip
from polhode.exact.kernel_agm import start_mean, third_kind
from polhode.exact.kernel_arithmetic import (
    BLOCK,
    add,
    called,
    choice,
    divide,
    halves,
    multiply,
    multiply_float,
    root,
    scale,
    subtract,
    two_product,
)
from polhode.special.doubledouble import INVERSE_TWO_PI

TAU_HIGH, TAU_LOW = INVERSE_TWO_PI


@called
def _begin(w: Any, count: int, s: Any) -> None:
    """Mirror, turn, and begin the arithmetic–geometric mean, ``frequencies.canonical_frequencies``."""
    for i in range(count):
        S0 = w[S + i]
        long_axis = S0 > 0.0
        sign = -1.0 if long_axis else 1.0
        a, b, c = (w[A + i], w[A_ + i]), (w[B + i], w[B_ + i]), (w[C + i], w[C_ + i])
        p, q, gg = (w[P + i], w[P_ + i]), (w[Q + i], w[Q_ + i]), (w[GG + i], w[GG_ + i])
        a, b = choice(long_axis, b, a), choice(long_axis, a, b)
        p, q = choice(long_axis, q, p), choice(long_axis, p, q)
        x1, x3 = w[L1 + i], w[L3 + i]
        x1, x3 = (x3 if long_axis else x1), (x1 if long_axis else x3)
        half_turn = -1.0 if x3 < 0.0 else 1.0
        fast = root(multiply(b, q))
        third = b[0] >= a[0]
        start = multiply(choice(third, q, b), c)
        g = multiply(root(c), root((-sign * S0, -sign * w[S_ + i])))
        start_mean(s, i, fast, g, choice(third, start, multiply(start, gg)))
        w[A + i], w[B + i], w[P + i], w[Q + i], w[S + i] = a[0], b[0], p[0], q[0], abs(S0)
        w[LEAD + i], w[LEAD_ + i] = choice(third, a, p)
        w[X1 + i], w[X3 + i], w[LONG + i], w[HALF + i] = x1 * half_turn, x3 * half_turn, sign, half_turn
        w[G + i], w[G_ + i] = root(gg)
        w[FAST + i], w[FAST_ + i] = fast
        w[V + i], w[V_ + i] = multiply_float(two_product(w[I1 + i], w[I2 + i]), w[I3 + i])


@called
def _put_rates(w: Any, full: int, count: int, m: Any) -> None:
    """Put the two rates [turns per time] into rows 1 to 6 of the motion."""
    for i in range(count):
        long_axis, third = w[LONG + i] < 0.0, w[B + i] >= w[A + i]
        mean, V0 = (w[MEAN + i], w[MEAN_ + i]), (w[V + i], w[V_ + i])
        outer = two_product(w[LONG + i] * (w[I1 + i] if long_axis == third else w[I3 + i]), w[I2 + i])
        correction = multiply((w[LEAD + i], w[LEAD_ + i]), (w[SUM + i], w[SUM_ + i]))
        other = scale(divide(correction, (w[GG + i], w[GG_ + i])), 0.5)
        share = choice(third, scale(correction, -0.5), other)
        precession = multiply((w[G + i], w[G_ + i]), add(outer, share))
        precession = choice(third, precession, add(precession, mean))
        inverse = scale(divide((TAU_HIGH, TAU_LOW), V0), w[RATE + i])
        half = scale(multiply(precession, inverse), 0.5)
        turn = scale(multiply(mean, inverse), 2.0)
        quarter = scale(turn, 0.25)
        first, second = choice(i < full, subtract(half, quarter), half), choice(i < full, add(half, quarter), turn)
        m[BLOCK + i], m[2 * BLOCK + i] = halves(first[0])
        m[4 * BLOCK + i], m[5 * BLOCK + i] = halves(second[0])
        m[3 * BLOCK + i], m[6 * BLOCK + i] = first[1], second[1]


@called
def rates(w: Any, full: int, count: int, steps: Any, who: Any, m: Any) -> None:
    """Mirror the bodies, and put their rates into the motion.

    Args:
        w: store of bodies.
        full: how many take the full form; they come first.
        count: of all bodies.
        steps, who: room for the mean.
        m: columns of the motion in rows of BLOCK.
    """
    _begin(w, count, steps)
    third_kind(w, MEAN, SUM, count, steps, who)
    _put_rates(w, full, count, m)
