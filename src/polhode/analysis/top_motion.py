"""A top's motion: direction of its axis, period of a swing, and steady precession."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from polhode import rotation
from polhode._base import check
from polhode._base.arrays import known_numbers_only
from polhode.exact.lagrange_top.steady_precession import SteadyPrecession, steady_precession
from polhode.systems.heavy_top import LIMITS as HEAVY_TOP_LIMITS
from polhode.systems.heavy_top import HeavyTop
from polhode.types import Array, ArrayLike, Float64, Real

if TYPE_CHECKING:
    from polhode.exact.lagrange_top import LagrangeMotion

NUTATING = ("undulating", "cusp", "loop")


class TopMotionLimits(NamedTuple):
    """What decides that a tilt is constant."""

    constant_tilt: float = 1e-12  # rad between the limits of a tilt, but for rounding of the input


LIMITS = TopMotionLimits()


@known_numbers_only
def axis_in_space(top: HeavyTop, attitude: Real[ArrayLike, "*times 4"]) -> Float64[Array, "*times 3"]:
    """Return the unit vector from the fixed point to the centre of mass, space axes.

    Args:
        top: with its axis along the principal axes.
        attitude: (…, 4) unit quaternions wxyz, principal axes → space.
    """
    return rotation.rotate(np.asarray(attitude, dtype=float), np.asarray(top.axis))


@known_numbers_only
def axis_tilt(top: HeavyTop, attitude: Real[ArrayLike, "*times 4"]) -> Float64[Array, "*times"]:
    """Return the angle of the axis from the upward vertical [rad], 0 to π; attitude (…, 4) as of ``axis_in_space``."""
    return np.asarray(np.arccos(np.clip(axis_in_space(top, attitude)[..., 2], -1.0, 1.0)))


@known_numbers_only
def axial_spin(top: HeavyTop, momentum: Real[ArrayLike, "3"]) -> float:
    """Return Ω·χ [rad/s] where the line to the centre of mass is a principal axis; zero elsewhere.

    Args:
        top: any.
        momentum: (3,) about the fixed point [kg m²/s, principal axes].
    """
    axis, L = np.asarray(top.axis), _vector(momentum)
    k = int(np.argmax(np.abs(axis)))
    along = np.linalg.norm(np.delete(axis, k)) <= HEAVY_TOP_LIMITS.axis_sine
    return float(L[k] * axis[k] / top.moments[k]) if along else 0.0


@known_numbers_only
def top_period(top: HeavyTop, momentum: Real[ArrayLike, "3"]) -> float | None:
    """Return the longest period that a small swing about hanging can have [s]: 2π √(I/mgl), I the largest moment.

    Without weight it is that of a turn, 2π/|Ω|; None for a body that nothing moves.

    Args:
        top: any.
        momentum: (3,) about the fixed point [kg m²/s, principal axes].
    """
    moments = np.asarray(top.moments)
    if float(top.mgl) != 0.0:
        return 2.0 * math.pi * math.sqrt(float(np.max(moments)) / abs(float(top.mgl)))
    turn = float(np.linalg.norm(_vector(momentum) / moments))
    return 2.0 * math.pi / turn if turn else None


@known_numbers_only
def is_steady_precession(motion: LagrangeMotion) -> bool:
    """Whether one top precesses steadily: at constant tilt, to rounding of the input."""
    low, high = motion.nutation_limits
    if motion.regime not in NUTATING or low is None or high is None:
        return motion.regime == "steady"
    return math.acos(low) - math.acos(high) < LIMITS.constant_tilt


@known_numbers_only
def steady_precession_of(motion: LagrangeMotion) -> SteadyPrecession | None:
    """Return the rates at which one top would precess steadily at the tilt and spin that it has at its epoch.

    None if the axis is vertical, or if the top spins too slowly for steady precession; see ``steady_precession``.

    >>> from polhode import LagrangeMotion
    >>> top = LagrangeMotion((1.0, 1.0, 0.5), mgl=1.0, momentum=(0.0, 0.0, 2.5), attitude=(3**0.5 / 2, 0.5, 0.0, 0.0))
    >>> round(steady_precession_of(top).slow, 12)
    0.438447187191
    """
    motion = motion.along("principal")
    moments = tuple(float(x) for x in motion.moments)
    height = rotation.rotate(motion.state(motion.epoch)[0], np.array([0.0, 0.0, 1.0]))[2]
    tilt = math.acos(max(-1.0, min(1.0, float(height))))
    if not 0.0 < tilt < math.pi:
        return None
    spin = float(motion.momentum_at_epoch[2]) / moments[2]
    return steady_precession((moments[0], moments[1], moments[2]), float(motion.mgl), tilt, spin)


def _vector(momentum: Array) -> Array:
    return check.array("momentum", momentum, (3,), "kg m²/s, principal axes")
