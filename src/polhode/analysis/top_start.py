"""The start of a top, given by its rates of spin, precession and nutation."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from polhode import rotation
from polhode._base import check
from polhode._base.arrays import known_numbers_only
from polhode.analysis.top_motion import axis_in_space
from polhode.bodies._pivot import axis_of_symmetry
from polhode.errors import InvalidInput
from polhode.exact.lagrange_top.steady_precession import SteadyPrecession, least_spin_rate, steady_precession
from polhode.systems.heavy_top import HeavyTop
from polhode.types import Array, ArrayLike, ArrayOrFloat, Float64, Real

UP = np.array([0.0, 0.0, 1.0])


class TopStartLimits(NamedTuple):
    """What decides that an axis leans."""

    min_tilt: float = 1e-12  # rad from a vertical: below it no line of nodes is sure


LIMITS = TopStartLimits()


@known_numbers_only
def top_velocity(
    top: HeavyTop,
    attitude: Real[ArrayLike, "4"],
    spin_rate: float = 0.0,
    precession_rate: float = 0.0,
    nutation_rate: float = 0.0,
) -> Float64[Array, "3"]:
    """Return the angular velocity (3,) of a top by its Euler rates: Ω = φ̇ e_z + θ̇ n + ψ̇ χ [rad/s, principal axes].

    χ is the direction from the fixed point to the centre of mass, whether or not it is a principal axis; e_z points up;
    n is the line of nodes, horizontal and across the axis, about which a positive turn lowers the axis. The component
    of Ω along the axis is ψ̇ + φ̇ cos θ.

    Args:
        top: any.
        attitude: (4,) unit quaternion wxyz, principal axes → space.
        spin_rate: ψ̇, of the body about its axis, against the line of nodes [rad/s].
        precession_rate: φ̇, of the axis about the upward vertical [rad/s].
        nutation_rate: θ̇, at which the axis leans over further [rad/s].

    Raises:
        InvalidInput: for rates that are not finite, or a nutation of an axis that is vertical and has no line of nodes.

    Source: Goldstein, *Classical Mechanics*, §4.9.

    >>> top = HeavyTop((1.0, 1.0, 0.5), 1.0)
    >>> top_velocity(top, top.leaning(math.pi / 3), spin_rate=5.0, precession_rate=2.0).round(12).tolist()
    [0.0, 1.732050807569, 6.0]
    """
    named = {"spin_rate": spin_rate, "precession_rate": precession_rate, "nutation_rate": nutation_rate}
    spin_rate, precession_rate, nutation_rate = (check.number(name, rate, "rad/s") for name, rate in named.items())
    q = rotation.normalize(np.asarray(attitude, dtype=float))
    if nutation_rate and float(lean_sine(axis_in_space(top, q))) <= LIMITS.min_tilt:
        raise InvalidInput(
            "`nutation_rate` needs an axis that leans: a vertical one has no line of nodes to turn about. Let it "
            "lean, or give the angular velocity."
        )
    return euler_velocity(np.asarray(top.axis), q, spin_rate, precession_rate, nutation_rate)


def euler_velocity(
    axis: Float64[Array, "3"], attitude: Float64[Array, "*#batch 4"],
    spin_rate: Float64[ArrayOrFloat, "*#batch"], precession_rate: Float64[ArrayOrFloat, "*#batch"],
    nutation_rate: Float64[ArrayOrFloat, "*#batch"],
) -> Float64[Array, "*batch 3"]:
    """Return angular velocities (…, 3) as ``top_velocity`` does, of one axis at many attitudes of unit length."""
    column = lambda rate: np.asarray(rate)[..., None]  # noqa: E731
    in_space = column(precession_rate) * UP
    if np.any(nutation_rate):
        leaning = rotation.rotate(attitude, axis)
        nodes = np.stack([-leaning[..., 1], leaning[..., 0], np.zeros(leaning.shape[:-1])], axis=-1)
        with np.errstate(all="ignore"):  # vertical axes are refused where they nutate
            nutating = in_space + column(nutation_rate) * nodes / column(lean_sine(leaning))
        in_space = np.where(column(nutation_rate) != 0.0, nutating, in_space)
    return rotation.rotate(rotation.conjugate(attitude), in_space) + column(spin_rate) * axis


def lean_sine(axis: Float64[Array, "*batch 3"]) -> Float64[np.ndarray, "*batch"]:
    """Return the sine (…) of the angle of unit vectors (…, 3) from the vertical."""
    # one by one, as NumPy's hypot may differ in its last digit
    return np.reshape([math.hypot(x, y) for x, y in np.asarray(axis)[..., :2].reshape(-1, 2).tolist()], axis.shape[:-1])


@known_numbers_only
def steady_precession_at(top: HeavyTop, tilt: float, spin_rate: float) -> SteadyPrecession:
    """Return the rates φ̇ at which a top that spins at ψ̇ precesses at constant tilt [rad/s]; see ``steady_precession``.

    Args:
        top: symmetric about the line from the fixed point to the centre of mass, which lie apart.
        tilt: of the axis from the upward vertical [rad], not vertical.
        spin_rate: ψ̇, of the body about its axis, against the line of nodes [rad/s].

    Raises:
        InvalidInput: for another top or tilt, or a spin that is too slow; then with the least spin.

    >>> rates = steady_precession_at(HeavyTop((1.0, 1.0, 0.5), 1.0), math.pi / 3, 3.0)
    >>> round(rates.slow, 12), round(rates.fast, 12)
    (0.7639320225, 5.2360679775)
    """
    moments, mgl = np.asarray(top.moments), float(top.mgl)
    k = axis_of_symmetry(moments, np.asarray(top.axis)) if mgl else None
    if k is None:
        raise InvalidInput(
            "steady precession needs a body symmetric about the line from its fixed point to its centre of mass, which "
            "lie apart; this one is not. Give the precession as a rate."
        )
    if not LIMITS.min_tilt < tilt < math.pi - LIMITS.min_tilt:
        raise InvalidInput(f"steady precession needs an axis that leans; got a tilt of {math.degrees(tilt):g}°.")
    across, along = float(moments[(k + 1) % 3]), float(moments[k])
    precession = steady_precession((across, across, along), mgl, tilt, spin_rate=float(spin_rate))
    if precession is None:
        least = least_spin_rate((across, across, along), mgl, tilt)
        why = f"least spin is {least:.6g} rad/s, either way round" if least else "body needs some spin for it"
        raise InvalidInput(
            f"there is no steady precession at a tilt of {math.degrees(tilt):g}° and a spin of {spin_rate:.6g} rad/s: "
            f"the {why}. Spin it faster, or give the precession as a rate."
        )
    return precession
