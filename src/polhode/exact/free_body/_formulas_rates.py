"""The two frequencies of a free body, by one arithmetic–geometric mean with its third-kind sum.

The polhode angle π u/2K turns at agm(√(BQ), √(−CS)); the frame about the angular momentum turns at the mean
precession rate ω_p = 2E/G + λ[Z(α|m1) + πα/(2KK')]. Both come from arithmetic and square roots alone, so they run in
double-double and their phases stay exact for any time. Source: Carlson, SIAM J. Math. Anal. 8 (1977) 231 for the
third-kind AGM; the choice of starting value keeps its convergence quadratic in every regime.
"""

from __future__ import annotations

from typing import NamedTuple

from polhode.exact._formulas import third_kind_mean
from polhode.exact._kernel_arithmetic import (
    Pair,
    Rate,
    Truth,
    add,
    choice,
    constant,
    divide,
    halves,
    multiply,
    negation,
    root_or_zero,
    scale,
    subtract,
    two_product,
    where,
)
from polhode.exact.free_body._formulas_reduction import Reduction
from polhode.special._doubledouble import INVERSE_TWO_PI


class Frequencies(NamedTuple):
    """Rates times V in canonical scaled units, and the regime of the body."""

    modulus_rate: Pair  # λ = √(BQ): u = u0 + λ t
    mean: Pair  # agm(√(BQ), √(−CS)) = π λ / 2K; meaningless on the separatrix
    precession: Pair  # ω_p
    G: Pair  # |L|
    constant: Truth  # permanent rotation, sphere or rest: L stays
    separatrix: Truth


class Start(NamedTuple):
    """What of the frequencies is there before the mean."""

    modulus_rate: Pair
    constant: Truth
    separatrix: Truth


def start_of(body: Reduction) -> tuple[Start, Pair, Pair, Pair]:
    """Return the start and √(BQ), √(−CS) and p² for the mean, or ones where there is no period.

    p² is so chosen that the third-kind sum stays quadratic.
    """
    rate = root_or_zero(multiply(body.B, body.Q))
    slow = multiply(root_or_zero(body.C), body.root_S)
    third = body.B[0] >= body.A[0]
    pp = multiply(choice(third, body.Q, body.B), body.C)
    pp = choice(third, pp, multiply(pp, body.G2))
    x, _, z = body.canonical
    is_constant = negation(rate[0] > 0.0) | negation(body.root_P > 0.0) | ((x == 0.0) & (z == 0.0))
    separatrix = negation((body.C[0] > 0.0) & (body.root_S[0] > 0.0)) & negation(is_constant)
    idle, one = is_constant | separatrix, constant((1.0, 0.0), x)
    start = Start(rate, is_constant, separatrix)
    return start, choice(idle, one, rate), choice(idle, one, slow), choice(idle, one, pp)


def frequencies_of(body: Reduction, start: Start, mean: Pair, total: Pair) -> Frequencies:
    """Return the frequencies, of mean and third-kind sum."""
    g, third = root_or_zero(body.G2), body.B[0] >= body.A[0]
    i1, i2, i3 = body.moments
    # a1 V = I2 I3 and a3 V = I1 I2, and with the mirror −I1 I2 and −I2 I3
    side = where(body.long_axis, -1.0, 1.0)
    outer = two_product(side * where(body.long_axis == third, i1, i3), i2)
    correction = multiply(choice(third, body.A, body.P), total)
    share = choice(third, scale(correction, -0.5), scale(divide(correction, body.G2), 0.5))
    rate = multiply(g, add(outer, share))
    precession = choice(third, rate, add(rate, mean))
    # on the separatrix the frame ends up turning at |L|/I2, here times V = I1 I2 I3
    saddle = multiply(g, two_product(side * i1, i3))
    precession = choice(start.separatrix, saddle, precession)
    return Frequencies(start.modulus_rate, mean, precession, g, start.constant, start.separatrix)


def frequencies(body: Reduction) -> Frequencies:
    """Return the frequencies of a reduced body."""
    start, fast, slow, pp = start_of(body)
    mean, total = third_kind_mean(fast, slow, pp)
    return frequencies_of(body, start, mean, total)


def phase_rates(full: bool, body: Reduction, rates: Frequencies) -> tuple[Rate, Rate]:
    """Return ``Motion.first`` and ``Motion.second`` [turns per time], in halves, of a body with two frequencies."""
    # rates times V become turns: over 2πV
    inverse = scale(divide(constant(INVERSE_TWO_PI, body.rate_scale), body.V), body.rate_scale)
    half = scale(multiply(rates.precession, inverse), 0.5)
    turn = scale(multiply(rates.mean, inverse), 2.0)
    quarter = scale(turn, 0.25)
    saddle = scale(divide(rates.modulus_rate, body.V), body.rate_scale)
    first = choice(full, subtract(half, quarter), half)
    second = choice(rates.separatrix, saddle, choice(full, add(half, quarter), turn))
    first_high, first_low = halves(first[0])
    second_high, second_low = halves(second[0])
    return (first_high, first_low, first[1]), (second_high, second_low, second[1])
