"""The two frequencies of a free body, by one arithmetic–geometric mean with its third-kind sum.

The polhode angle π u/2K turns at agm(√(BQ), √(−CS)); the frame about the angular momentum turns at the mean
precession rate ω_p = 2E/G + λ[Z(α|m1) + πα/(2KK')]. Both come from arithmetic and square roots alone, so they run in
double-double and their phases stay exact for any time. Source: Carlson, SIAM J. Math. Anal. 8 (1977) 231 for the
third-kind AGM; the choice of starting value keeps its convergence quadratic in every regime.
"""

from __future__ import annotations

from typing import Any, NamedTuple

from polhode.arrays import iterate_until, namespace
from polhode.exact.reduction import Reduction
from polhode.special import doubledouble as dd
from polhode.special.doubledouble import DoubleDouble

Array = Any
CONVERGED = 2e-8  # the closing formulas leave an error of the fourth power
MOST_STEPS = 20


class Frequencies(NamedTuple):
    """Rates times V in canonical scaled units, and the regime of the body."""

    modulus_rate: DoubleDouble  # λ = √(BQ): u = u0 + λ t
    mean: DoubleDouble  # agm(√(BQ), √(−CS)) = π λ / 2K; meaningless on the separatrix
    precession: DoubleDouble  # ω_p
    G: DoubleDouble  # |L|
    constant: Array  # permanent rotation, sphere or rest: L stays
    separatrix: Array


def canonical_frequencies(body: Reduction) -> Frequencies:
    """Return the frequencies of reduced bodies."""
    xp = namespace(body.long_axis)
    A, B, C, P, Q, G2 = body.A, body.B, body.C, body.P, body.Q, body.G2
    BQ = dd.multiply(B, Q)
    l1, _, l3 = body.canonical
    constant = ~(BQ[0] > 0) | ~(P[0] > 0) | ((l1 == 0) & (l3 == 0))
    separatrix = ~((C[0] > 0) & (body.root_S[0] > 0)) & ~constant
    G = dd.sqrt(G2)
    modulus_rate = dd.sqrt(BQ)
    third_axis = B[0] >= A[0]
    start = dd.multiply(dd.where(third_axis, Q, B), C)
    start = dd.where(third_axis, start, dd.multiply(start, G2))
    one = dd.from_float(xp.ones_like(l1))
    tame = constant | separatrix
    mean, total = _third_kind_agm(
        *(dd.where(tame, one, x) for x in (modulus_rate, dd.multiply(dd.sqrt(C), body.root_S), start))
    )
    # a1 V = I2 I3 and a3 V = I1 I2, and with the mirror −I1 I2 and −I2 I3
    I1, I2, I3 = body.moments
    sign = xp.where(body.long_axis, -1.0, 1.0)
    outer = dd.two_product(sign * xp.where(body.long_axis == third_axis, I1, I3), I2)
    correction = dd.multiply(dd.where(third_axis, A, P), total)
    share = dd.where(third_axis, dd.scale(correction, -0.5), dd.scale(dd.divide(correction, G2), 0.5))
    precession = dd.multiply(G, dd.add(outer, share))
    precession = dd.where(third_axis, precession, dd.add(precession, mean))
    saddle = dd.multiply(G, dd.two_product(sign * I1, I3))
    return Frequencies(modulus_rate, mean, dd.where(separatrix, saddle, precession), G, constant, separatrix)


def _third_kind_agm(a: DoubleDouble, g: DoubleDouble, pp: DoubleDouble) -> tuple[DoubleDouble, DoubleDouble]:
    """Return agm(a, g) and Σ Q_n, with Q_0 = 1, ε = (p²−ag)/(p²+ag), Q_{n+1} = Q_n ε/2 and p ← (p²+ag)/2p."""
    xp = namespace(a[0])
    q = dd.from_float(xp.ones_like(a[0]))
    _, exponent = xp.frexp(a[0])  # rates down to 1e-150, whose fourth powers would underflow
    up, down = xp.ldexp(xp.ones_like(a[0]), exponent), xp.ldexp(xp.ones_like(a[0]), -exponent)
    a, g, pp = dd.scale(a, down), dd.scale(g, down), dd.scale(dd.scale(pp, down), down)
    state = iterate_until(_agm_step, _agm_finished, (*a, *g, *pp, *q, *q), at_once=3, most=MOST_STEPS)
    a, pp, q, total = state[0:2], state[4:6], state[6:8], state[8:10]
    x, e, middle = _agm_closing(*state)
    last = 0.5 * q[0] * e
    total = dd.add(total, (last + last * (0.25 * (e * e - 0.5 * x * x)), xp.zeros_like(x)))
    return dd.scale(dd.add(middle, (-0.25 * middle[0] * x * x, xp.zeros_like(x))), up), total


def _agm_step(*state: Array) -> tuple[Array, ...]:
    a, g, pp, q, total = (state[k : k + 2] for k in range(0, 10, 2))
    ag = dd.multiply(a, g)
    s = dd.add(pp, ag)
    e = dd.divide(dd.subtract(pp, ag), s)
    q = dd.scale(dd.multiply(q, e), 0.5)
    pp = dd.scale(dd.divide(dd.square(s), pp), 0.25)
    return (*dd.scale(dd.add(a, g), 0.5), *dd.sqrt(ag), *pp, *q, *dd.add(total, q))


def _agm_closing(*state: Array) -> tuple[Array, Array, DoubleDouble]:
    """Return x = (a−g)/(a+g), ε and (a+g)/2; ag is taken as ((a+g)/2)² − ((a−g)/2)², which does not cancel in ε."""
    a, g, pp = state[0:2], state[2:4], state[4:6]
    middle = dd.scale(dd.add(a, g), 0.5)
    half = 0.5 * ((a[0] - g[0]) + (a[1] - g[1]))
    d = dd.subtract(pp, dd.square(middle))
    e = d[0] + d[1] + half * half
    return half / middle[0], e / (2.0 * middle[0] * middle[0] + e), middle


def _agm_finished(*state: Array) -> Array:
    xp = namespace(state[0])
    x, e, _ = _agm_closing(*state)
    return (xp.abs(x) < CONVERGED) & (xp.abs(e) < CONVERGED)
