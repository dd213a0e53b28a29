"""Steady precession of a Lagrange top, and the spin at which it sleeps."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from polhode._base.arrays import known_numbers_only
from polhode.errors import InvalidInput, shown
from polhode.types import ArrayOrFloat, Float64


class LevelLimits(NamedTuple):
    """When an axis counts as level."""

    max_cosine: float = 3.6e-15  # of its tilt, 16 roundings: π/2 is no double, and attitudes round it further


LIMITS = LevelLimits()


class SteadyPrecession(NamedTuple):
    """Rates of steady precession [rad/s] at one tilt and spin; ``fast`` is None for a level axis, to rounding."""

    slow: float
    fast: float | None


@known_numbers_only
def steady_precession(
    moments: tuple[float, float, float],
    mgl: float,
    tilt: float,
    spin: float | None = None,
    *,
    spin_rate: float | None = None,
) -> SteadyPrecession | None:
    """Return the rates at which the axis precesses at constant tilt, None where the spin is too slow for any.

    The roots of I1 cos θ φ̇² − I3 ω3 φ̇ + mgl = 0; with ω3 = ψ̇ + φ̇ cos θ those of (I1 − I3) cos θ φ̇² − I3 ψ̇ φ̇ + mgl = 0.
    The smaller one is mgl over the rest, so that nothing cancels.

    Args:
        moments: (I1, I1, I3) about the pivot [kg m²].
        mgl: weight times the distance from the pivot to the centre of mass, along the axis [N m].
        tilt: θ of the axis from the upward vertical, strictly between 0 and π [rad].
        spin: ω3, the component of the angular velocity along the axis [rad/s]; this or ``spin_rate``.
        spin_rate: ψ̇, the rate of the body about its axis against the line of nodes [rad/s].

    Raises:
        InvalidInput: for unequal I1, I2, a tilt outside (0, π), values that are not finite, or both spins or none.

    Source: Klein & Sommerfeld, *Theorie des Kreisels*, ch. IV; Whittaker, *Analytical Dynamics*, §72.

    >>> rates = steady_precession((1.0, 1.0, 0.5), 1.0, math.pi / 3, 5.0)
    >>> round(rates.slow, 12), round(rates.fast, 12)
    (0.438447187191, 4.561552812809)
    >>> again = steady_precession((1.0, 1.0, 0.5), 1.0, math.pi / 3, spin_rate=5.0 - 0.5 * rates.slow)
    >>> round(again.slow, 12)
    0.438447187191
    """
    if (spin is None) == (spin_rate is None):
        raise InvalidInput("give either `spin`, the component along the axis, or `spin_rate`, that against the line of "
                           "nodes.")
    I1, I3 = _checked(moments, mgl)
    rate = spin if spin_rate is None else spin_rate
    assert rate is not None
    if not (0.0 < tilt < math.pi and math.isfinite(rate)):
        raise InvalidInput(
            "`tilt` must lie between 0 and π, and `spin` be finite; "
            f"got {shown(tilt)} rad, {shown(rate)} rad/s."
        )
    moment = I1 if spin_rate is None else I1 - I3
    return precession_roots(moment, I3, mgl, tilt, rate)


def precession_roots(moment: float, I3: float, mgl: float, tilt: float, rate: float) -> SteadyPrecession | None:
    """Return the roots φ̇ [rad/s] of moment · cos θ φ̇² − I3 rate φ̇ + mgl = 0, None where none is real; no checks."""
    quadratic, momentum = moment * math.cos(tilt), I3 * rate
    if moment == 0.0 or abs(math.cos(tilt)) <= LIMITS.max_cosine:
        return SteadyPrecession(mgl / momentum, None) if momentum else None
    square = momentum * momentum - 4.0 * quadratic * mgl
    if square < 0.0:
        return None
    # the root without cancellation; the other is mgl over it, as their product is mgl/quadratic
    larger = 0.5 * (momentum + math.copysign(math.sqrt(square), momentum))
    if larger == 0.0:
        return SteadyPrecession(0.0, 0.0)
    return SteadyPrecession(mgl / larger, larger / quadratic)


@known_numbers_only
def least_spin_rate(moments: tuple[float, float, float], mgl: float, tilt: float) -> float:
    """Return the |ψ̇| [rad/s] from which a top can precess steadily at a tilt, 2 √((I1 − I3) cos θ mgl)/I3, or zero.

    It is zero where the top precesses steadily at any spin; a level axis needs a spin other than zero.

    Args:
        moments: (I1, I1, I3) about the pivot [kg m²].
        mgl: weight times the distance from the pivot to the centre of mass, along the axis [N m].
        tilt: θ of the axis from the upward vertical [rad].

    Raises:
        InvalidInput: for unequal I1, I2, or values that are not finite.

    >>> round(least_spin_rate((1.0, 1.0, 0.5), 1.0, math.pi / 3), 12)
    2.0
    """
    I1, I3 = _checked(moments, mgl)
    if not math.isfinite(tilt):
        raise InvalidInput(f"`tilt` must be finite; got {shown(tilt)} rad.")
    height = math.cos(tilt)
    return 0.0 if abs(height) <= LIMITS.max_cosine else 2.0 * math.sqrt(max(0.0, (I1 - I3) * height * mgl)) / I3


@known_numbers_only
def sleeping_threshold(moments: tuple[float, float, float], mgl: float) -> float:
    """Return the spin |ω3| [rad/s] from which the upright top is stable, 2 √(I1 mgl)/I3; zero for a hanging one.

    At the threshold itself the quadratic terms of the potential vanish, and the quartic ones keep the top stable.

    >>> round(sleeping_threshold((1.0, 1.0, 0.5), 1.0), 12)
    4.0
    """
    I1, I3 = _checked(moments, mgl)
    return float(sleeping_thresholds(I1, I3, mgl))


def sleeping_thresholds(
    I1: Float64[ArrayOrFloat, "*batch"], I3: Float64[ArrayOrFloat, "*batch"], mgl: Float64[ArrayOrFloat, "*batch"]
) -> Float64[np.ndarray, "*batch"]:
    """Return the spins (…) as ``sleeping_threshold`` does, of many tops; no checks."""
    return np.asarray(2.0 * np.sqrt(I1) * np.sqrt(np.maximum(mgl, 0.0)) / I3)


def _checked(moments: tuple[float, float, float], mgl: float) -> tuple[float, float]:
    I1, I2, I3 = (float(v) for v in moments)
    if not (I1 == I2 and I1 > 0.0 and I3 > 0.0 and math.isfinite(I1) and math.isfinite(I3)):
        raise InvalidInput(
            f"`moments` must be (I1, I1, I3), positive, the first two equal; got {(I1, I2, I3)} kg m². "
            "Put the axis of symmetry third and check units."
        )
    if not math.isfinite(mgl):
        raise InvalidInput(f"`mgl` must be finite; got {shown(mgl)} N m.")
    return I1, I3
