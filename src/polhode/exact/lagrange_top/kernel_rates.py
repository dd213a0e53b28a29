"""The steps of ``frequencies`` for a block of tops, compiled by Numba."""

from __future__ import annotations

from typing import Any

from polhode.exact.kernel_agm import start_mean, third_kind
from polhode.exact.kernel_arithmetic import (
    BLOCK,
    Pair,
    add,
    called,
    choice,
    divide,
    halves,
    inlined,
    multiply,
    multiply_float,
    pair,
    put,
    root,
    scale,
    subtract,
    two_sum,
)
from polhode.exact.lagrange_top import kernel_store as at
from polhode.special.doubledouble import INVERSE_TWO_PI

TAU_HIGH, TAU_LOW = INVERSE_TWO_PI
ONE = (1.0, 0.0)


@inlined
def _first_alpha(w: Any, i: int) -> bool:
    return w[at.Z_PLUS + i] <= 2.0 * w[at.A + i]


@inlined
def _first_beta(w: Any, i: int) -> bool:
    return multiply(pair(w, at.G + i), pair(w, at.S2 + i))[0] <= w[at.Z_MINUS + i]


@called
def _begin_alpha(w: Any, count: int, s: Any) -> None:
    for i in range(count):
        a, t1 = pair(w, at.A + i), pair(w, at.T1 + i)
        root_a = root(a)
        other = divide(multiply(a, pair(w, at.T2 + i)), t1)
        start_mean(s, i, root_a, root(pair(w, at.B + i)), choice(_first_alpha(w, i), pair(w, at.Z_PLUS + i), other))
        put(w, at.HALF_ROOT + i, scale(root_a, 0.5))


@called
def _begin_beta(w: Any, count: int, s: Any) -> None:
    """The mean is the same; where c = 0 the sum's factor vanishes, and p² must only not be zero."""
    for i in range(count):
        a, b, first = pair(w, at.A + i), pair(w, at.B + i), _first_beta(w, i)
        other = divide(multiply(pair(w, at.S1 + i), b), pair(w, at.S2 + i))
        start = choice(first, choice(w[at.C + i] == 0.0, a, pair(w, at.Z_MINUS + i)), other)
        start_mean(s, i, scale(pair(w, at.HALF_ROOT + i), 2.0), root(b), start)


@inlined
def _drift(g: Pair, c: Pair, z: Pair, near: Pair, far: Pair, d: Pair, nutation: Pair, total: Pair, first: bool) -> Pair:
    """Return ``frequencies._drift``."""
    idle = c[0] == 0.0
    divisor = choice(idle, ONE, choice(first, z, near))
    quotient = divide(choice(first, multiply(c, g), c), divisor)
    share = scale(multiply(divide(d, far), total), 0.5)
    inner = scale(multiply(quotient, total), 0.25)
    return choice(first, inner, subtract(multiply(scale(quotient, 0.5), subtract(ONE, share)), nutation))


@called
def _alpha(w: Any, count: int) -> None:
    for i in range(count):
        nutation, g, d = scale(pair(w, at.MEAN + i), 0.5), pair(w, at.G + i), pair(w, at.GAP + i)
        sign = 1.0 if w[at.C_PLUS + i] >= 0.0 else -1.0
        c, t1, t2 = scale(pair(w, at.C_PLUS + i), sign), pair(w, at.T1 + i), pair(w, at.T2 + i)
        rate = _drift(g, c, pair(w, at.Z_PLUS + i), t1, t2, d, nutation, pair(w, at.SUM + i), _first_alpha(w, i))
        w[at.SIGN_A + i] = sign
        put(w, at.NUTATION + i, nutation)
        put(w, at.ALPHA + i, scale(rate, sign))


@called
def _beta(w: Any, count: int) -> None:
    for i in range(count):
        nutation, g, d, first = pair(w, at.NUTATION + i), pair(w, at.G + i), pair(w, at.GAP + i), _first_beta(w, i)
        sign = 1.0 if w[at.C + i] >= 0.0 else -1.0
        c, s1, s2 = scale(pair(w, at.C + i), sign), pair(w, at.S1 + i), pair(w, at.S2 + i)
        rate = _drift(g, c, pair(w, at.Z_MINUS + i), s2, s1, d, nutation, pair(w, at.SUM + i), first)
        w[at.SIGN_B + i] = sign
        put(w, at.BETA + i, scale(rate, -sign if first else sign))


@called
def _put_rates(w: Any, count: int, m: Any) -> None:
    """Put the rates of the phases of α and β [turns per time] into rows 1 to 6 of the motion."""
    n = BLOCK
    for i in range(count):
        moment = (w[at.I1 + i], 0.0)
        spin = multiply_float(two_sum(w[at.I1 + i], -w[at.I3 + i]), 0.5 * w[at.L3 + i])
        spin = divide(spin, (w[at.I3 + i], 0.0))
        inverse = scale(divide((TAU_HIGH, TAU_LOW), moment), w[at.RATE + i])
        alpha = multiply(add(pair(w, at.ALPHA + i), spin), inverse)
        beta = multiply(subtract(pair(w, at.BETA + i), spin), inverse)
        m[n + i], m[2 * n + i] = halves(alpha[0])
        m[4 * n + i], m[5 * n + i] = halves(beta[0])
        m[3 * n + i], m[6 * n + i] = alpha[1], beta[1]


@called
def rates(w: Any, count: int, steps: Any, who: Any, m: Any) -> None:
    """Find the three frequencies, and put those of the phases into the motion.

    Args:
        w: store of tops.
        count: of them.
        steps, who: room for the mean.
        m: columns of the motion in rows of BLOCK.
    """
    _begin_alpha(w, count, steps)
    third_kind(w, at.MEAN, at.SUM, count, steps, who)
    _alpha(w, count)
    _begin_beta(w, count, steps)
    third_kind(w, at.MEAN, at.SUM, count, steps, who)
    _beta(w, count)
    _put_rates(w, count, m)
