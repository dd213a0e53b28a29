"""The numbers that describe a Lagrange top's motion, of its reduction, turning points and frequencies."""

from __future__ import annotations

import math
from typing import NamedTuple

from polhode.exact._kernel_arithmetic import (
    Number,
    Pair,
    add,
    constant,
    divide,
    multiply,
    multiply_float,
    scale,
    subtract,
    where,
)
from polhode.exact.lagrange_top._formulas_rates import Frequencies
from polhode.exact.lagrange_top._formulas_reduction import Reduction
from polhode.exact.lagrange_top._formulas_roots import TurningPoints
from polhode.special._doubledouble import PI


class Numbers(NamedTuple):
    """What a top's motion is like; what is infinite is inf, what is undefined NaN."""

    # 0 rest, 1 sleeping, 2 hanging, 3 steady, 4 free, 5 planar, 6 undulating, 7 cusp, 8 loop, 9 separatrix
    regime: Number
    lowest: Number  # of the cosine of the tilt from the upward vertical
    highest: Number
    period: Number  # of the nutation; of a steady top that of its smallest nutations
    precession_per_period: Number  # azimuth gained by the axis in a period, unreduced
    spin_per_period: Number  # the body's own turn in a period, unreduced


def _cosine(s: Pair, t: Pair) -> float:
    """Return u from the smaller of 1 − u and 1 + u."""
    one = constant((1.0, 0.0), s[0])
    return where(s[0] < t[0], subtract(one, s)[0], subtract(t, one)[0])


def _regime(top: Reduction, rates: Frequencies) -> float:
    """Signs of polynomials in the given floats decide; only the steady top needs the computed gap u2 − u1.

    The azimuth is at rest where p_φ = a u; there |w|² = lean/a, which is positive inside the nutation's range.
    """
    a, c, c_plus, lean = top.momentum[2], top.c[0], top.c_plus[0], top.lean[0]
    along = where(a < 0.0, -lean, lean)
    within = (c * a < 0.0) & (c_plus * a > 0.0)  # the place p_φ/a is a tilt: −1 < p_φ/a < 1
    code = where(within & (along > 0.0), 8.0, 6.0)
    code = where(within & (along == 0.0), 7.0, code)
    code = where((a == 0.0) & (c == 0.0), 5.0, code)
    code = where(rates.steady, 3.0, code)
    code = where(rates.separatrix, 9.0, code)
    code = where(rates.permanent, where(top.s0[0] == 0.0, 1.0, 2.0), code)
    code = where(top.G[0] == 0.0, 4.0, code)
    return where((a == 0.0) & rates.permanent, 0.0, code)


def _by_kind(rates: Frequencies, permanent: float, separatrix: float, periodic: float) -> float:
    return where(rates.permanent, permanent, where(rates.separatrix, separatrix, periodic))


def numbers(top: Reduction, points: TurningPoints, rates: Frequencies) -> Numbers:
    """Return the numbers of a top."""
    lower, upper = _cosine(points.s1, points.t1), _cosine(points.s2, points.t2)
    lower, upper = where(rates.permanent, top.u0[0], lower), where(rates.permanent, top.u0[0], upper)
    pi = constant(PI, top.u0[0])
    # α = cos(θ/2) e^{i(φ + ψ)/2}, β = sin(θ/2) e^{i(φ − ψ)/2} up to a constant phase: φ = arg α + arg β,
    # ψ = arg α − arg β. In a period, π/ϖ by τ, each argument gains its linear part, and half a turn by its thetas
    turn_alpha = add(divide(rates.alpha, rates.nutation), (rates.sign_alpha, 0.0 * rates.sign_alpha))
    turn_beta = add(divide(rates.beta, rates.nutation), (rates.sign_beta, 0.0 * rates.sign_beta))
    spin = divide(rates.spin, rates.nutation)
    precession = multiply(pi, add(turn_alpha, turn_beta))[0]
    own_turn = multiply(pi, add(subtract(turn_alpha, turn_beta), spin))[0]
    period = divide(multiply_float(pi, top.moments[0]), scale(rates.nutation, top.rate_scale))[0]
    own_turn = where(top.reversed, -1.0, 1.0) * own_turn + 0.0  # never −0
    return Numbers(
        _regime(top, rates), where(top.reversed, -upper, lower), where(top.reversed, -lower, upper),
        _by_kind(rates, math.nan, math.inf, period), _by_kind(rates, math.nan, math.nan, precession),
        _by_kind(rates, math.nan, math.nan, own_turn),
    )  # fmt: skip
