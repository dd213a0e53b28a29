"""Sines and cosines of angles counted in turns, and products of rates and times reduced to a fraction of a turn."""

from __future__ import annotations

import math

import numpy as np

from polhode._base.arrays import is_jax, namespace, nearest, split_halves
from polhode.special._doubledouble import two_sum
from polhode.types import Array, ArrayOrFloat, Float64

Operand = Float64[ArrayOrFloat, "*#shape"]
Result = Float64[ArrayOrFloat, "*shape"]
EPS = float(np.finfo(float).eps)
SplitRate = tuple[Float64[ArrayOrFloat, "..."], Float64[ArrayOrFloat, "..."], Float64[ArrayOrFloat, "..."]]

# Taylor coefficients of sin 2πx and cos 2πx in powers of x². At the end of an eighth of a turn, 2πx = π/4, the first
# terms left out are (π/4)^19/19! = 8e-20 and (π/4)^20/20! = 3e-21.
_SINE = [(-1) ** n * math.tau ** (2 * n + 1) / math.factorial(2 * n + 1) for n in range(9)]
_COSINE = [(-1) ** n * math.tau ** (2 * n) / math.factorial(2 * n) for n in range(10)]


def sine_cosine_turns(x: Operand) -> tuple[Result, Result]:
    """Return (sin 2πx, cos 2πx) for |x| ≤ ½, to about 3e-16.

    One tangent of the half angle serves both, which vector libraries make cheap. XLA has no vector sine or tangent on
    CPU, so JAX arrays take the Taylor polynomials on an eighth of a turn.
    """
    xp = namespace(x)
    if not is_jax(x):
        # with t = tan πx: sin 2πx = 2t/(1 + t²), cos 2πx = 2/(1 + t²) − 1
        t = xp.tan(x * math.pi)
        d = t * t
        d += 1.0
        d = 2.0 / d
        t *= d
        d -= 1.0
        return t, d
    quarter = xp.round(4.0 * x)
    r = x - 0.25 * quarter
    rr = r * r
    s, c = r * _horner(_SINE, rr), _horner(_COSINE, rr)
    # x = r + n/4: each quarter of a turn takes (sin, cos) to (cos, −sin)
    n = quarter - 4.0 * xp.floor(0.25 * quarter)
    odd = (n == 1.0) | (n == 3.0)
    s, c = xp.where(odd, c, s), xp.where(odd, s, c)
    return xp.where(n >= 2.0, -s, s), xp.where((n == 1.0) | (n == 2.0), -c, c)


def cosine_and_sine(angle: Float64[ArrayOrFloat, "*shape"]) -> tuple[Float64[np.ndarray, "*shape"], ...]:
    """Return both of angles [rad], exact for whole quarter turns, whose angle itself is not."""
    angle = np.asarray(angle, dtype=float)
    quarters = angle / (0.5 * math.pi)
    nearest_one = np.round(quarters)
    whole = (nearest_one != 0.0) & (np.abs(quarters - nearest_one) <= 4.0 * EPS * np.abs(quarters))
    k = (nearest_one % 4.0).astype(int)
    cosine, sine = np.array([1.0, 0.0, -1.0, 0.0])[k], np.array([0.0, 1.0, 0.0, -1.0])[k]
    return np.where(whole, cosine, np.cos(angle)), np.where(whole, sine, np.sin(angle))


def _horner(coefficients: list[float], x: Array) -> ArrayOrFloat:
    value = coefficients[-1]
    for a in coefficients[-2::-1]:
        value = a + x * value
    return value


def split_rate(high: Operand, low: Operand) -> tuple[Result, Result, Result]:
    """Return the double-double rate as two half-length floats and a remainder, for exact products with times."""
    upper, lower = split_halves(high)
    return upper, lower, low


def reduced_phase(
    rate: tuple[Operand, ...], time: tuple[Operand, ...]
) -> tuple[Result, Result, Result]:
    """Return (fraction, rest, turns): rate · time less whole turns, as fraction + rest.

    The time has two halves and, where it is no double, a rest below its last digit.
    The products of halves are exact, so each is reduced exactly and nothing depends on how a compiler contracts
    products and sums. Exact to about 3e-17 turns while |rate · time| < 2⁵⁰.
    """
    fraction, rest, (na, nb, nc, more) = _reduced(rate, time)
    return fraction, rest, na + (nb + nc) + more


def _reduced(rate: tuple[Array, ...], time: tuple[Array, ...]) -> tuple[Array, Array, tuple[Array, ...]]:
    upper, lower, least = rate
    high, low, *rest = time
    # (u + l + least)(h + low + rest): three exact products of halves; the others stay below half a turn and need no
    # reduction
    a, b, c = upper * high, upper * low, lower * high
    na, nb, nc = nearest(a), nearest(b), nearest(c)
    d = high + low
    d *= least
    d += lower * low
    for r in rest:
        d += (upper + lower) * r
    # each remainder may reach half a turn: a plain sum would cost 1e-16 turns, and near the saddle 1e-13 of x
    a -= na
    b -= nb
    c -= nc
    middle, middle_error = two_sum(b, c)
    fraction, error = two_sum(a, middle)
    more = nearest(fraction)
    fraction -= more
    middle_error += d
    error += middle_error
    return fraction, error, (na, nb, nc, more)
