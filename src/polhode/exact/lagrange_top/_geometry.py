"""The numbers that describe a Lagrange top's motion: turning points, period, precession, spin and regime."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

from polhode._base.arrays import compiled, namespace
from polhode.exact.lagrange_top._formulas_rates import Frequencies
from polhode.exact.lagrange_top._formulas_roots import Reduction, TurningPoints
from polhode.exact.lagrange_top._reduction import reduce_top
from polhode.exact.lagrange_top._roots import FORMULAS, turning_points
from polhode.special import _doubledouble as dd
from polhode.special._doubledouble import DoubleDouble
from polhode.types import Array, Float64, Integer

REGIMES = (
    "rest", "sleeping", "hanging", "steady", "free", "planar", "undulating", "cusp", "loop", "separatrix",
)  # fmt: skip
REST, SLEEPING, HANGING, STEADY, FREE, PLANAR, UNDULATING, CUSP, LOOP, SEPARATRIX = range(10)


Number = Float64[Array, "*batch"]
Code = Integer[Array, "*batch"]


class Characteristics(NamedTuple):
    """Numbers of the motion, one per top; inf or NaN where there is none."""

    regime: Code  # code, index into REGIMES
    lowest: Number  # of cos θ
    highest: Number
    period: Number
    precession_per_period: Number
    spin_per_period: Number
    precession_rate: Number
    spin_rate: Number


def characteristics(
    moments: Float64[Array, "*batch 3"],
    mgl: Float64[Array, "*batch 1"],
    momentum: Float64[Array, "*batch 3"],
    attitude: Float64[Array, "*batch 4"],
) -> Characteristics:
    """Return the characteristics of tops with arrays (…, 3), (…, 1), (…, 3) and (…, 4) of one batch shape."""
    top = compiled(reduce_top, moments)(moments, mgl, momentum, attitude)
    points = compiled(turning_points, moments)(top)
    return characteristics_of(top, points, compiled(FORMULAS.frequencies, moments)(top, points))


def characteristics_of(top: Reduction, points: TurningPoints, rates: Frequencies) -> Characteristics:
    """Return the characteristics of tops that have been reduced."""
    return compiled(_characteristics, top.reversed)(top, points, rates)


def _characteristics(top: Reduction, points: TurningPoints, rates: Frequencies) -> Characteristics:
    xp = namespace(top.reversed)
    zero = xp.zeros_like(top.moments[0])
    permanent, separatrix = rates.permanent, rates.separatrix
    lower, upper = _cosine(xp, points.s1, points.t1), _cosine(xp, points.s2, points.t2)
    lower, upper = (xp.where(permanent, top.u0[0], v) for v in (lower, upper))
    pi = tuple(c + zero for c in dd.PI)
    half_turn = dd.from_float(rates.sign_alpha)
    # α = cos(θ/2) e^{i(φ + ψ)/2}, β = sin(θ/2) e^{i(φ − ψ)/2} up to a constant phase: φ = arg α + arg β,
    # ψ = arg α − arg β. In a period, π/ϖ by τ, each argument gains its linear part, and half a turn by its thetas
    turn_alpha = dd.add(dd.divide(rates.alpha, rates.nutation), half_turn)
    turn_beta = dd.add(dd.divide(rates.beta, rates.nutation), dd.from_float(rates.sign_beta))
    spin = dd.divide(rates.spin, rates.nutation)
    precession = dd.multiply(pi, dd.add(turn_alpha, turn_beta))[0]
    own_turn = dd.multiply(pi, dd.add(dd.subtract(turn_alpha, turn_beta), spin))[0]
    period = dd.divide(dd.multiply_float(pi, top.moments[0]), dd.scale(rates.nutation, top.rate_scale))[0]
    sense = xp.where(top.reversed, -1.0, 1.0)
    none = xp.where(separatrix, math.inf, xp.where(permanent, math.nan, 0.0))
    undefined = xp.where(separatrix | permanent, math.nan, 0.0)
    rate = lambda turn: turn / period + undefined  # noqa: E731
    return Characteristics(
        _regime(top, points, rates), xp.where(top.reversed, -upper, lower), xp.where(top.reversed, -lower, upper),
        xp.where(none == 0.0, period, none), precession + undefined, sense * own_turn + undefined, rate(precession),
        sense * rate(own_turn),
    )


def _cosine(xp: Any, s: DoubleDouble, t: DoubleDouble) -> Array:
    """Return u from the smaller of 1 − u and 1 + u."""
    one = dd.one_like(s[0])
    return xp.where(s[0] < t[0], dd.subtract(one, s)[0], dd.subtract(t, one)[0])


def _regime(top: Reduction, points: TurningPoints, rates: Frequencies) -> Array:
    """Signs of polynomials in the given floats decide; only the steady top needs the computed gap u2 − u1.

    The azimuth is at rest where p_φ = a u; there |w|² = lean/a, which is positive inside the nutation's range.
    """
    xp = namespace(top.reversed)
    a, c, c_plus, lean = top.momentum[2], top.c[0], top.c_plus[0], top.lean[0]
    along = xp.where(a < 0, -lean, lean)
    within = (c * a < 0) & (c_plus * a > 0)  # the place p_φ/a is a tilt: −1 < p_φ/a < 1
    code = xp.where(within & (along > 0), LOOP, UNDULATING)
    code = xp.where(within & (along == 0), CUSP, code)
    code = xp.where((a == 0) & (c == 0), PLANAR, code)
    code = xp.where(rates.steady, STEADY, code)
    code = xp.where(rates.separatrix, SEPARATRIX, code)
    code = xp.where(rates.permanent, xp.where(top.s0[0] == 0, SLEEPING, HANGING), code)
    code = xp.where(top.G[0] == 0, FREE, code)
    return xp.where((a == 0) & rates.permanent, REST, code)
