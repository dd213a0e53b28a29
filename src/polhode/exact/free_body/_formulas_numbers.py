"""The numbers that describe a free body's motion, of its reduction and its two frequencies."""

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
    scale,
    square_root,
    subtract,
    two_product,
    where,
)
from polhode.exact.free_body._formulas_rates import Frequencies
from polhode.exact.free_body._formulas_reduction import Reduction
from polhode.special._doubledouble import PI

SMALL_CAP = 1e-14  # below it the leading term of the cap's area is as exact as the difference it replaces


class Numbers(NamedTuple):
    """What a free body's motion is like; what is infinite is inf, what is undefined NaN, and −1 of the axis."""

    regime: Number  # 0 rest, 1 spherical, 2 permanent, 3 symmetric, 4 short axis, 5 long axis, 6 separatrix
    encircled_axis: Number  # index of the given axis that the polhode goes round
    modulus: Number
    period: Number  # after which the momentum is back along the body's axes
    precession_rate: Number  # mean rate at which the encircled axis turns about the momentum
    precession_per_period: Number
    solid_angle: Number  # of the cap that the polhode cuts off about the encircled axis


def _regime(body: Reduction, rates: Frequencies) -> float:
    i1, i2, i3 = body.moments
    x, y, z = body.momentum
    code = where(body.long_axis, 5.0, 4.0)
    code = where((i1 == i2) | (i2 == i3), 3.0, code)
    code = where(rates.separatrix, 6.0, code)
    code = where(rates.constant, 2.0, code)
    code = where(i1 == i3, 1.0, code)
    return where((x == 0.0) & (y == 0.0) & (z == 0.0), 0.0, code)


def _solid_angle(body: Reduction, rates: Frequencies, per_period: Pair, scaled_period: Pair, two_pi: Pair) -> float:
    """Return Ω = 2π − (ω_p − 2E/|L|) T, in double-double, as small caps cancel."""
    i1, i2, i3 = body.moments
    b, c, p, q, g2 = body.B[0], body.C[0], body.P[0], body.Q[0], body.G2[0]
    twice_energy = add(body.P, multiply(two_product(where(body.long_axis, -i3, i1), i2), body.G2))
    dynamic = multiply(divide(twice_energy, rates.G), scaled_period)
    angle = subtract(two_pi, subtract(per_period, dynamic))
    # a small cap is the ellipse C L1² + B L2² = P, of area πP/√(BC), over |L|²
    cap = math.pi * p / (square_root(b * c) * g2)
    # a symmetric body's period has no bound near its equator, and the difference no digit left
    round_cap = 2.0 * math.pi * (p / (c * g2)) / (1.0 + square_root(q / (c * g2)))
    return where(body.A[0] == 0.0, round_cap, where(p / (b * g2) < SMALL_CAP, cap, angle[0]))


def _by_kind(rates: Frequencies, permanent: float, separatrix: float, periodic: float) -> float:
    return where(rates.constant, permanent, where(rates.separatrix, separatrix, periodic))


def numbers(body: Reduction, rates: Frequencies) -> Numbers:
    """Return the numbers of a body."""
    two_pi = scale(constant(PI, body.rate_scale), 2.0)
    scaled_period = divide(two_pi, rates.mean)  # T/V
    per_period = multiply(rates.precession, scaled_period)  # ω_p T
    period = divide(multiply(scaled_period, body.V), (body.rate_scale, 0.0 * body.rate_scale))
    rate = scale(divide(rates.precession, body.V), body.rate_scale)
    sense = where(body.long_axis, -1.0, 1.0)
    # k² = AP/(BQ)
    modulus = square_root(body.A[0] / body.B[0]) * (body.root_P / square_root(body.Q[0]))
    solid_angle = _solid_angle(body, rates, per_period, scaled_period, two_pi)
    return Numbers(
        _regime(body, rates), _by_kind(rates, -1.0, -1.0, body.order[2]), _by_kind(rates, math.nan, 1.0, modulus),
        _by_kind(rates, math.nan, math.inf, period[0]), where(rates.constant, math.nan, sense * rate[0]),
        _by_kind(rates, math.nan, math.inf, sense * per_period[0]), _by_kind(rates, math.nan, math.nan, solid_angle),
    )  # fmt: skip
