"""The places of a top's poles and of its start, by Carlson's R_F(x, y, 1) = ½ ∫₀^∞ dt / √((t+x)(t+y)(t+1)).

The places of the poles enter amplitudes alone, so float64 does; the start enters phases, and the logarithm that it is
near the saddle wants some more digits. Source: Carlson, Numer. Algorithms 10 (1995) 13, duplication.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from polhode.exact._kernel_arithmetic import (
    Number,
    Pair,
    add,
    angle_of,
    choice,
    constant,
    divide,
    iterate_until,
    larger,
    multiply,
    root,
    root_or_zero,
    scale,
    square_root,
    where,
)
from polhode.exact.lagrange_top._formulas_rates import Frequencies
from polhode.exact.lagrange_top._formulas_reduction import ONE, ZERO, Reduction, Three
from polhode.exact.lagrange_top._formulas_roots import TurningPoints

MOST_STEPS = 40
CLOSE, CLOSER = 1e-2, 2e-3  # of the spread, whose eighth power is what the closing formula leaves
Pairs = tuple[Pair, Pair, Pair]


class Integrals(NamedTuple):
    """Elliptic integrals of the first kind."""

    v_alpha: Number  # distances of α's and β's poles from the real axis; infinite where the tilt stays
    v_beta: Number
    w_alpha: Number  # K' − v, of the full form
    w_beta: Number
    x0: Pair  # distance of the start from the lowest place


# ---------------------------------------------------------------------- R_F(x, y, 1)


def _series(x: float, y: float) -> float:
    """Return what R_F is more than one over the root of the mean, of relative distances from it (DLMF 19.36.1)."""
    z = -x - y
    second, third = x * y - z * z, x * y * z
    higher = second * second * (1.0 / 24.0 - second * (5.0 / 208.0)) - second * third * (3.0 / 44.0)
    higher = higher + third * (3.0 / 104.0 * third + 0.0625 * second * second)
    return (higher + third * (1.0 / 14.0)) - 0.1 * second


def widest(x: float, y: float, z: float) -> float:
    """Return the largest distance from the mean over it."""
    mean = ((x + y) + z) / 3.0
    return larger(larger(abs(mean - x), abs(mean - y)), abs(mean - z)) / mean


def duplicated(now: Three) -> Three:
    """Return numbers of equal R_F, nearer to each other (DLMF §19.26(iii))."""
    x, y, z = now
    a, b, c = square_root(x), square_root(y), square_root(z)
    more = (a * b + b * c) + c * a
    return 0.25 * (x + more), 0.25 * (y + more), 0.25 * (z + more)


def is_close(now: Three) -> bool:
    """Return whether the closing formula has all digits of a float."""
    return widest(now[0], now[1], now[2]) <= CLOSE


def closed(now: Three) -> float:
    """Return R_F of numbers next to each other, NaN of others."""
    x, y, z = now
    mean = ((x + y) + z) / 3.0
    return where(is_close(now), (1.0 + _series(1.0 - x / mean, 1.0 - y / mean)) / square_root(mean), math.nan)


def duplicated_sharply(now: Pairs) -> Pairs:
    """Return ``duplicated`` in double-double."""
    x, y, z = now
    a, b, c = root_or_zero(x), root_or_zero(y), root(z)
    more = add(multiply(a, add(b, c)), multiply(b, c))
    return scale(add(x, more), 0.25), scale(add(y, more), 0.25), scale(add(z, more), 0.25)


def is_closer(now: Pairs) -> bool:
    """Return whether the closing formula has the digits that a phase wants."""
    return widest(now[0][0], now[1][0], now[2][0]) <= CLOSER


def closed_sharply(now: Pairs) -> Pair:
    """Return ``closed`` in double-double."""
    x, y, z = now
    one = constant(ONE, x[0])
    mean = divide(add(add(x, y), z), constant((3.0, 0.0), x[0]))
    apart = _series(1.0 - divide(x, mean)[0], 1.0 - divide(y, mean)[0])
    return choice(is_closer(now), divide(add(one, (apart, 0.0 * apart)), root(mean)), (math.nan, math.nan))


# ---------------------------------------------------------------------- what is integrated


def pole_of_alpha(top: Reduction, points: TurningPoints) -> Three:
    """Return x, y and c of an integral √c R_F(x, y, 1), v of α."""
    d, t2 = points.d[0], points.t2[0]
    return d / t2, d * points.Z_plus[0] / (points.A[0] * t2), points.t1[0] / t2


def pole_of_beta(top: Reduction, points: TurningPoints) -> Three:
    """Return the like of v of β."""
    d, s1, b = points.d[0], points.s1[0], points.B[0]
    return d * points.Z_minus[0] / (s1 * b), d / s1, points.s2[0] * points.A[0] / (s1 * b)


def rest_of_alpha(top: Reduction, points: TurningPoints) -> Three:
    """Return the like of K' − v of α."""
    g, z = top.G[0], points.Z_plus[0]
    return g * points.t1[0] / z, g * points.t2[0] / z, points.A[0] / z


def rest_of_beta(top: Reduction, points: TurningPoints) -> Three:
    """Return the like of K' − v of β."""
    g, b = top.G[0], points.B[0]
    return g * points.s2[0] / b, g * points.s1[0] / points.A[0], points.Z_minus[0] / b


def place_of_start(points: TurningPoints) -> Pairs:
    """Return the like of the start's distance from the lowest place, in double-double."""
    return divide(points.from_upper, points.d), divide(points.Y, points.A), divide(points.from_lower, points.d)


def _integral(idle: bool, terms: Three) -> float:
    """Return √c R_F(x, y, 1), or some number where there is none."""
    x, y, c = terms
    total = x + y
    good = where(idle, 0.0, total) > 0.0
    good = good & (total < math.inf)
    start = where(good, x, 1.0), where(good, y, 1.0), 1.0 + 0.0 * x
    return square_root(c) * closed(iterate_until(duplicated, is_close, start, 0, MOST_STEPS))


def _sharp_integral(idle: bool, terms: Pairs) -> Pair:
    x, y, c = terms
    total, one = x[0] + y[0], constant(ONE, x[0])
    good = where(idle, 0.0, total) > 0.0
    good = good & (total < math.inf)
    start = choice(good, x, one), choice(good, y, one), one
    return multiply(root_or_zero(c), closed_sharply(iterate_until(duplicated_sharply, is_closer, start, 0, MOST_STEPS)))


def integrals_of(top: Reduction, points: TurningPoints, rates: Frequencies) -> Integrals:
    """Return the integrals of a top."""
    idle, separatrix, d = rates.permanent | rates.steady, rates.separatrix, points.d[0]
    v_alpha, v_beta = _integral(idle, pole_of_alpha(top, points)), _integral(idle, pole_of_beta(top, points))
    v_alpha = where(separatrix, angle_of(square_root(points.t1[0]), square_root(d)), v_alpha)
    v_beta = where(separatrix | (points.s2[0] == 0.0), 0.0, v_beta)
    # where the tilt stays the pole is infinitely far: only e^−y = 0 enters
    still = where(rates.steady, math.inf, 0.0)
    x0 = _sharp_integral(idle, place_of_start(points))
    return Integrals(
        where(idle, still, v_alpha), where(idle, still, v_beta), _integral(idle, rest_of_alpha(top, points)),
        _integral(idle, rest_of_beta(top, points)), choice(idle & (d <= 0.0), ZERO, x0),
    )  # fmt: skip
