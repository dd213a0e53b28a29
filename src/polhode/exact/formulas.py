"""Formulas of both motions, each written once, over the words of ``kernel_arithmetic``.

Python runs them with single numbers. ``copies`` makes copies of them for Numba, in which basic words are its own, and
for arrays of NumPy or JAX. So they consist of arithmetic and words: what depends on a number is a ``where``.
"""

from __future__ import annotations

from polhode.exact.kernel_arithmetic import (
    Pair,
    Rate,
    add,
    fast_two_sum,
    halves,
    inlined,
    nearest,
    phase,
    square_root,
    two_sum,
)


@inlined
def exponent(x: float, rest: float, upper: float, lower: float) -> Pair:
    """Return the leading part of −(x + rest)(upper + lower), which is exact, and the factor for the rest."""
    high, low = halves(x)
    small = (high * lower + low * (upper + lower)) + rest * upper
    return -(high * upper), 1.0 - small * (1.0 - 0.5 * small)


@inlined
def reduced_argument(rate: Rate, start: Pair, periodic: float, high: float, low: float) -> tuple[float, float, float]:
    """Return an argument in half periods as a number within ±½ and its rest, and the half periods taken out.

    On the separatrix, where ``periodic`` is zero, it runs to infinity and none is taken out.
    """
    fraction, rest, turned = phase(rate, high, low)
    total, first_error = two_sum((1.0 - periodic) * turned, fraction)
    u, second_error = two_sum(total, start[0])
    u, u_rest = fast_two_sum(u, rest + (start[1] + (first_error + second_error)))
    more = periodic * nearest(u)
    return u - more, u_rest, periodic * turned + more


@inlined
def nome_per_parameter(parameter: float, k: float) -> float:
    """Return ``elliptic.nome_per_parameter``."""
    more = 1.0 + square_root(k)
    ratio = 0.5 / ((1.0 + k) * more * more)
    e = ratio * parameter
    e4 = (e * e) * (e * e)
    return ratio * (1.0 + e4 * (2.0 + e4 * (15.0 + e4 * (150.0 + e4 * 1707.0))))


@inlined
def by_theta(period: Pair, nome: float) -> Pair:
    """Return a period over θ3², of which 1/θ3² is 1 less a small correction."""
    q4 = (nome * nome) * (nome * nome)
    e = 2.0 * (nome + q4 + q4 * q4 * nome)
    return add(period, (-period[0] * (e * (2.0 + e) / ((1.0 + e) * (1.0 + e))), 0.0))
