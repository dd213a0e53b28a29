"""How fast a top precesses and nutates: from its motion, by linearisation, and by the formulas for fast gyroscopes.

The last two take a body that is not quite symmetric about the line from the fixed point to the centre of mass as
symmetric, with the mean of its moments across that line.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from polhode._base.arrays import known_numbers_only
from polhode.exact.lagrange_top.steady_precession import steady_precession
from polhode.systems.heavy_top import HeavyTop
from polhode.types import ArrayLike, Float64, Real


class TopRateLimits(NamedTuple):
    """Numbers that decide whether samples allow mean rates of a top."""

    max_asymmetry: float = 0.1  # of the moments across the axis, relative, up to which their mean is of use
    min_highest_points: int = 3  # of the axis, between which a mean is taken
    max_turn: float = 2.5  # rad between samples; a larger change of azimuth may have gone the other way round
    min_samples: int = 8  # a nutation
    min_nodding: float = 1e-9  # of the height of the unit axis; less is rounding


LIMITS = TopRateLimits()


class TopRates(NamedTuple):
    """Rates [rad/s] of a top, None where there is none.

    Attributes:
        precession: at which the axis goes round the vertical, positive as the right hand turns about the upward one.
        nutation: at which the axis nods.
    """

    precession: float | None
    nutation: float | None


@known_numbers_only
def mean_top_rates(times: Real[ArrayLike, "time"], axis: Real[ArrayLike, "time 3"]) -> TopRates:
    """Return mean rates from samples of an axis in space, over whole nutations where there are any.

    Rates are None where samples lie too far apart to follow the axis, or where it does not nod.

    Args:
        times: (T,) [s].
        axis: (T, 3) unit vectors, the vertical third.
    """
    t, n = np.asarray(times, dtype=float), np.asarray(axis, dtype=float)
    azimuth = np.unwrap(np.arctan2(n[:, 1], n[:, 0]))
    followed = len(t) > 1 and bool(np.abs(np.diff(azimuth)).max() < LIMITS.max_turn)
    tops = _highest(t, n[:, 2])
    if tops is None:
        return TopRates(float((azimuth[-1] - azimuth[0]) / (t[-1] - t[0])) if followed else None, None)
    first, last = tops[0], tops[-1]
    angle = np.diff(np.interp([first, last], t, azimuth))[0]
    precession = float(angle / (last - first)) if followed else None
    return TopRates(precession, 2.0 * math.pi * (len(tops) - 1) / float(last - first))


@known_numbers_only
def steady_top_rates(top: HeavyTop, axial_momentum: float, tilt: float) -> TopRates | None:
    """Return the slow steady precession at a tilt, and the rate of small nutation about it; None where there is none.

    With p = I3 ω3 the nutation is √((p − 2 I1 φ̇ cos θ)² + (I1 φ̇ sin θ)²)/I1, the second derivative of the effective
    potential.

    Args:
        top: symmetric about its axis, or nearly.
        axial_momentum: p, along the axis [kg m²/s].
        tilt: θ from the upward vertical [rad].

    Source: Klein & Sommerfeld, *Theorie des Kreisels*, ch. IV; Goldstein, *Classical Mechanics*, §5.7.

    >>> rates = steady_top_rates(HeavyTop((1.0, 1.0, 0.5), 1.0), 2.5, math.pi / 3)
    >>> round(rates.precession, 12), round(rates.nutation, 6)
    (0.438447187191, 2.096229)
    """
    moments = _symmetric(top)
    if moments is None or not 0.0 < tilt < math.pi:
        return None
    across, along = moments
    precession = steady_precession((across, across, along), float(top.mgl), tilt, axial_momentum / along)
    if precession is None:
        return None
    # V″ at the steady tilt over I1: (p/I1 − 2φ̇ cos θ)² + φ̇² sin² θ
    rest = axial_momentum / across - 2.0 * precession.slow * math.cos(tilt)
    return TopRates(precession.slow, math.hypot(rest, precession.slow * math.sin(tilt)))


@known_numbers_only
def gyroscopic_rates(top: HeavyTop, axial_momentum: float) -> TopRates | None:
    """Return the rates mgl/p and p/I1 of a top that spins fast, p = I3 ω3; None for one without spin.

    >>> gyroscopic_rates(HeavyTop((1.0, 1.0, 0.5), 1.0), 10.0)
    TopRates(precession=0.1, nutation=10.0)
    """
    moments = _symmetric(top)
    if moments is None or not axial_momentum:
        return None
    return TopRates(float(top.mgl) / axial_momentum, abs(axial_momentum) / moments[0])


def _symmetric(top: HeavyTop) -> tuple[float, float] | None:
    """Return the mean moment across the axis and that along it; None of a body that is too far from symmetric."""
    axis, moments = np.asarray(top.axis), np.asarray(top.moments)
    across = np.linalg.svd(axis[None])[2][1:]
    both = np.linalg.eigvalsh(across @ np.diag(moments) @ across.T)
    if both[1] - both[0] > LIMITS.max_asymmetry * both[1]:
        return None
    return float(both.mean()), float(axis @ (moments * axis))


def _highest(t: np.ndarray, height: np.ndarray) -> Float64[np.ndarray, "tops"] | None:
    """Return the times at which the axis is highest, by parabolas through three samples; None where it does not nod."""
    if np.ptp(height) < LIMITS.min_nodding:
        return None
    inner = np.flatnonzero((height[1:-1] > height[:-2]) & (height[1:-1] >= height[2:])) + 1
    if len(inner) < LIMITS.min_highest_points or np.diff(inner).min() < LIMITS.min_samples:
        return None
    before, here, after = height[inner - 1], height[inner], height[inner + 1]
    left, right = t[inner] - t[inner - 1], t[inner + 1] - t[inner]
    rise, fall = (here - before) / left, (after - here) / right
    # the parabola has the slope (rise · right + fall · left)/(left + right) at the middle sample and the second
    # derivative 2(fall − rise)/(left + right)
    return t[inner] + 0.5 * (rise * right + fall * left) / (rise - fall)
