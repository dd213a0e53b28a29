"""The two frequencies of a free body, by one arithmetic–geometric mean with its third-kind sum.

The polhode angle π u/2K turns at agm(√(BQ), √(−CS)); the frame about the angular momentum turns at the mean
precession rate ω_p = 2E/G + λ[Z(α|m1) + πα/(2KK')]. Both come from arithmetic and square roots alone, so they run in
double-double and their phases stay exact for any time. Source: Carlson, SIAM J. Math. Anal. 8 (1977) 231 for the
third-kind AGM; the choice of starting value keeps its convergence quadratic in every regime.
"""

from __future__ import annotations

from typing import NamedTuple

from polhode._base.arrays import namespace
from polhode.exact._agm import third_kind_agm
from polhode.exact.free_body._reduction import FORMULAS, Reduction
from polhode.special import _doubledouble as dd
from polhode.special._doubledouble import DoubleDouble
from polhode.types import Array, Bool

Flag = Bool[Array, "*batch"]


class Frequencies(NamedTuple):
    """Rates times V in canonical scaled units, and the regime of the body."""

    modulus_rate: DoubleDouble  # λ = √(BQ): u = u0 + λ t
    mean: DoubleDouble  # agm(√(BQ), √(−CS)) = π λ / 2K; meaningless on the separatrix
    precession: DoubleDouble  # ω_p
    G: DoubleDouble  # |L|
    constant: Flag  # permanent rotation, sphere or rest: L stays
    separatrix: Flag


def canonical_frequencies(body: Reduction) -> Frequencies:
    """Return the frequencies of reduced bodies."""
    xp = namespace(body.long_axis)
    A, B, C, P, Q, G2 = body.A, body.B, body.C, body.P, body.Q, body.G2
    l1, _, l3 = body.canonical
    modulus_rate, *rest = FORMULAS.starts_of_mean(A, B, C, Q, G2, body.root_S)
    constant = ~(modulus_rate[0] > 0) | ~(body.root_P > 0) | ((l1 == 0) & (l3 == 0))
    separatrix = ~((C[0] > 0) & (body.root_S[0] > 0)) & ~constant
    one = dd.from_float(xp.ones_like(l1))
    mean, total = third_kind_agm(*(dd.where(constant | separatrix, one, x) for x in (modulus_rate, *rest)))
    G, third = dd.sqrt(G2), B[0] >= A[0]
    lead = dd.where(third, A, P)
    precession = FORMULAS.precession_rate(body.long_axis, third, body.moments, lead, total, G2, G, mean)
    I1, _, I3 = body.moments
    # on the separatrix the frame ends up turning at |L|/I2, here times V = I1 I2 I3
    saddle = dd.multiply(G, dd.two_product(xp.where(body.long_axis, -1.0, 1.0) * I1, I3))
    return Frequencies(modulus_rate, mean, dd.where(separatrix, saddle, precession), G, constant, separatrix)
