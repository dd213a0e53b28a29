"""How a body that loses energy settles: the angle to its major axis, and how long that takes."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from polhode._base.arrays import known_numbers_only
from polhode.analysis.energy_casimir import Stability
from polhode.errors import InvalidInput, shown
from polhode.types import Array, ArrayLike, Float64, Real


class AxisLimits(NamedTuple):
    """What decides whether a start is on an axis."""

    on_axis: float = 1e-9  # rad from it


LIMITS = AxisLimits()


@known_numbers_only
def angle_to_major_axis(
    momentum: Real[ArrayLike, "*times 3"], moments: Real[ArrayLike, "3"]
) -> Float64[Array, "*times"]:
    """Return the angle from L to the nearest line of largest moment [rad], 0 to π/2.

    Args:
        momentum: (…, 3) [kg m²/s, principal axes].
        moments: (3,) principal moments [kg m²]; if two or three are the largest, each of their axes is a major one.
    """
    L, I = np.asarray(momentum, dtype=float), np.asarray(moments, dtype=float)  # noqa: E741
    major = I == I.max()
    return np.asarray(np.arctan2(np.linalg.norm(L[..., ~major], axis=-1), np.linalg.norm(L[..., major], axis=-1)))


@known_numbers_only
def angle_to_axis(momentum: Real[ArrayLike, "3"], axis: int) -> float:
    """Return the angle between L and a principal axis 0, 1 or 2, either end [rad]."""
    L = np.asarray(momentum, dtype=float)
    return math.atan2(float(np.linalg.norm(np.delete(L, axis))), abs(float(L[axis])))


def time_constant(stability: Stability) -> float | None:
    """Return the time [s] in which neighbours of an equilibrium leave or return by a factor of e; None if never."""
    return 1.0 / abs(stability.rate) if stability.rate else None


@known_numbers_only
def drag_time_constant(moment: float, spin: float, linear: float = 0.0, quadratic: float = 0.0) -> float:
    """Return I/(c + k|Ω|) [s], in which drag −(c + k|Ω|) Ω, as strong as at the start, reduces a spin to 1/e.

    Args:
        moment: about the axis [kg m²].
        spin: |Ω| [rad/s].
        linear: c [N m s].
        quadratic: k [N m s²].

    Raises:
        InvalidInput: where nothing brakes.
    """
    brake = linear + quadratic * abs(spin)
    if not 0.0 < brake < math.inf:
        raise InvalidInput(f"drag must brake; got {shown(linear)} N m s and {shown(quadratic)} N m s².")
    return moment / brake


@known_numbers_only
def settling_time(axes: Sequence[Stability], momentum: Real[ArrayLike, "3"], moments: Real[ArrayLike, "3"]) -> float:
    """Return the time [s] by which a body that loses energy inside has settled about its major axis.

    Twelve time constants of the approach (twelve turns at the rate of the start if there is no approach), plus the time
    in which a start near an unstable axis leaves it.

    Args:
        axes: verdicts on the principal axes in the order of ascending moments, as of ``damped_axis_stability``.
        momentum: (3,) at the start [kg m²/s, principal axes], not zero.
        moments: (3,) principal moments [kg m²], ascending.
    """
    settled = 12.0  # time constants, which leave 6e-6 of an angle
    L, I = np.asarray(momentum, dtype=float), np.asarray(moments, dtype=float)  # noqa: E741
    wanted = settled * (time_constant(axes[2]) or 2.0 * math.pi / float(np.linalg.norm(L / I)))
    for k in (0, 1):
        off = angle_to_axis(L, k)
        if axes[k].verdict == "unstable" and LIMITS.on_axis < off < 1.0:
            wanted += math.log(1.0 / off) / axes[k].rate
    return wanted
