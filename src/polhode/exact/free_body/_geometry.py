"""The numbers that describe a free body's motion, such as periods, precession and action, from its two frequencies."""

from __future__ import annotations

import math
from typing import NamedTuple

from polhode._base.arrays import namespace
from polhode.exact.free_body._formulas_rates import Frequencies
from polhode.exact.free_body._formulas_reduction import Reduction
from polhode.exact.free_body._preparation import FORMULAS, canonical_reduction
from polhode.special import _doubledouble as dd
from polhode.special._doubledouble import DoubleDouble
from polhode.types import Array, Float64, Integer

REGIMES = ("rest", "spherical", "permanent", "symmetric", "short-axis", "long-axis", "separatrix")
REST, SPHERICAL, PERMANENT, SYMMETRIC, SHORT_AXIS, LONG_AXIS, SEPARATRIX = range(7)

Number = Float64[Array, "*batch"]
Code = Integer[Array, "*batch"]


class Characteristics(NamedTuple):
    """Numbers of the motion, one per body; inf or NaN where there is none."""

    regime: Code  # code, index into REGIMES
    encircled_axis: Code  # index of the given principal axis that the polhode encircles; −1 where none
    modulus: Number
    period: Number
    precession_rate: Number
    precession_per_period: Number
    solid_angle: Number


def characteristics(moments: Float64[Array, "*batch 3"], momentum: Float64[Array, "*batch 3"]) -> Characteristics:
    """Return the characteristics of bodies with moments and momentum (…, 3) along the principal axes.

    With ω_p the canonical precession rate, T the period and 2E the canonical energy, the solid angle of the cap that
    the polhode cuts off about its axis is Ω = 2π − (ω_p − 2E/|L|) T; all in double-double, as small caps cancel.
    """
    xp = namespace(moments, momentum)
    body = canonical_reduction(moments, momentum)
    rates = FORMULAS.frequencies(body)
    none = rates.constant | rates.separatrix
    regime = _regime(moments, momentum, body, rates)
    undefined = xp.where(rates.separatrix, math.inf, math.nan)

    two_pi = tuple(2.0 * c + 0.0 * body.G2[0] for c in dd.PI)
    scaled_period = dd.divide(two_pi, rates.mean)  # T/V
    per_period = dd.multiply(rates.precession, scaled_period)  # ω_p T
    solid_angle = _solid_angle(body, rates, per_period, scaled_period, two_pi)
    rate = dd.scale(dd.divide(rates.precession, body.V), body.rate_scale)
    sense = xp.where(body.long_axis, -1.0, 1.0)
    has_rate = ~rates.constant
    period = dd.divide(dd.multiply(scaled_period, body.V), (body.rate_scale, 0.0 * body.rate_scale))
    # k² = AP/(BQ)
    modulus = xp.sqrt(body.A[0] / body.B[0]) * (body.root_P / xp.sqrt(body.Q[0]))
    return Characteristics(
        regime=regime,
        encircled_axis=xp.where(none, -1, xp.asarray(body.order[2], dtype=int)),
        modulus=xp.where(none, xp.where(rates.separatrix, 1.0, math.nan), modulus),
        period=xp.where(none, undefined, period[0]),
        precession_rate=xp.where(has_rate, sense * rate[0], math.nan),
        precession_per_period=xp.where(none, undefined, sense * per_period[0]),
        solid_angle=xp.where(none, math.nan, solid_angle),
    )


def _solid_angle(
    body: Reduction, rates: Frequencies, per_period: DoubleDouble, scaled_period: DoubleDouble, two_pi: DoubleDouble
) -> Array:
    xp = namespace(body.long_axis)
    I1, I2, I3 = body.moments
    a3V = dd.two_product(xp.where(body.long_axis, -I3, I1), I2)
    twice_energy = dd.add(body.P, dd.multiply(a3V, body.G2))
    dynamic = dd.multiply(dd.divide(twice_energy, rates.G), scaled_period)
    angle = dd.subtract(two_pi, dd.subtract(per_period, dynamic))
    small = body.P[0] / (body.B[0] * body.G2[0])
    # a small cap is the ellipse C L1² + B L2² = P, of area πP/√(BC), over |L|²
    cap = math.pi * body.P[0] / (xp.sqrt(body.B[0] * body.C[0]) * body.G2[0])
    # a symmetric body's period has no bound near its equator, and the difference no digit left
    sine2, cosine2 = body.P[0] / (body.C[0] * body.G2[0]), body.Q[0] / (body.C[0] * body.G2[0])
    round_cap = 2.0 * math.pi * sine2 / (1.0 + xp.sqrt(cosine2))
    smallest = 1e-14  # below it the leading term of the cap's area is as exact as the difference it replaces
    return xp.where(body.A[0] == 0, round_cap, xp.where(small < smallest, cap, angle[0]))


def _regime(moments: Array, momentum: Array, body: Reduction, rates: Frequencies) -> Array:
    xp = namespace(moments, momentum)
    I1, I2, I3 = body.moments
    code = xp.where(body.long_axis, LONG_AXIS, SHORT_AXIS)
    code = xp.where((I1 == I2) | (I2 == I3), SYMMETRIC, code)
    code = xp.where(rates.separatrix, SEPARATRIX, code)
    code = xp.where(rates.constant, PERMANENT, code)
    code = xp.where(I1 == I3, SPHERICAL, code)
    return xp.where(xp.all(momentum == 0, axis=-1), REST, code)
