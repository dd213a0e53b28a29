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
from polhode.exact.lagrange_top.kernel_store import (
    ALPHA,
    BETA,
    C_PLUS,
    GAP,
    HALF_ROOT,
    I1,
    I3,
    L3,
    MEAN,
    NUTATION,
    RATE,
    S1,
    S2,
    SIGN_A,
    SIGN_B,
    SUM,
    T1,
    T2,
    Z_MINUS,
    Z_PLUS,
    A,
    B,
    C,
    G,
)  # fmt: skip
from polhode.special.doubledouble import INVERSE_TWO_PI

TAU_HIGH, TAU_LOW = INVERSE_TWO_PI
ONE = (1.0, 0.0)


@inlined
def _first_alpha(w: Any, i: int) -> bool:
    return w[Z_PLUS + i] <= 2.0 * w[A + i]


@inlined
def _first_beta(w: Any, i: int) -> bool:
    return multiply(pair(w, G + i), pair(w, S2 + i))[0] <= w[Z_MINUS + i]


@called
def _begin_alpha(w: Any, count: int, s: Any) -> None:
    for i in range(count):
        a, t1 = pair(w, A + i), pair(w, T1 + i)
        root_a = root(a)
        other = divide(multiply(a, pair(w, T2 + i)), t1)
        start_mean(s, i, root_a, root(pair(w, B + i)), choice(_first_alpha(w, i), pair(w, Z_PLUS + i), other))
        put(w, HALF_ROOT + i, scale(root_a, 0.5))


@called
def _begin_beta(w: Any, count: int, s: Any) -> None:
    """The mean is the same; where c = 0 the sum's factor vanishes, and p² must only not be zero."""
    for i in range(count):
        a, b, first = pair(w, A + i), pair(w, B + i), _first_beta(w, i)
        other = divide(multiply(pair(w, S1 + i), b), pair(w, S2 + i))
        start = choice(first, choice(w[C + i] == 0.0, a, pair(w, Z_MINUS + i)), other)
        start_mean(s, i, scale(pair(w, HALF_ROOT + i), 2.0), root(b), start)


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
        nutation, g, d = scale(pair(w, MEAN + i), 0.5), pair(w, G + i), pair(w, GAP + i)
        sign = 1.0 if w[C_PLUS + i] >= 0.0 else -1.0
        c, t1, t2 = scale(pair(w, C_PLUS + i), sign), pair(w, T1 + i), pair(w, T2 + i)
        rate = _drift(g, c, pair(w, Z_PLUS + i), t1, t2, d, nutation, pair(w, SUM + i), _first_alpha(w, i))
        w[SIGN_A + i] = sign
        put(w, NUTATION + i, nutation)
        put(w, ALPHA + i, scale(rate, sign))


@called
def _beta(w: Any, count: int) -> None:
    for i in range(count):
        nutation, g, d, first = pair(w, NUTATION + i), pair(w, G + i), pair(w, GAP + i), _first_beta(w, i)
        sign = 1.0 if w[C + i] >= 0.0 else -1.0
        c, s1, s2 = scale(pair(w, C + i), sign), pair(w, S1 + i), pair(w, S2 + i)
        rate = _drift(g, c, pair(w, Z_MINUS + i), s2, s1, d, nutation, pair(w, SUM + i), first)
        w[SIGN_B + i] = sign
        put(w, BETA + i, scale(rate, -sign if first else sign))


@called
def _put_rates(w: Any, count: int, m: Any) -> None:
    """Put the rates of the phases of α and β [turns per time] into rows 1 to 6 of the motion."""
    n = BLOCK
    for i in range(count):
        moment = (w[I1 + i], 0.0)
        spin = multiply_float(two_sum(w[I1 + i], -w[I3 + i]), 0.5 * w[L3 + i])
        spin = divide(spin, (w[I3 + i], 0.0))
        inverse = scale(divide((TAU_HIGH, TAU_LOW), moment), w[RATE + i])
        alpha = multiply(add(pair(w, ALPHA + i), spin), inverse)
        beta = multiply(subtract(pair(w, BETA + i), spin), inverse)
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
    third_kind(w, MEAN, SUM, count, steps, who)
    _alpha(w, count)
    _begin_beta(w, count, steps)
    third_kind(w, MEAN, SUM, count, steps, who)
    _beta(w, count)
    _put_rates(w, count, m)
