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
from polhode.types import Array, ArrayLike, Float64, Real

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
    axis, back = axis_in_space(top, q), rotation.conjugate(q)
    in_space = precession_rate * UP
    if nutation_rate:
        sine = math.hypot(axis[0], axis[1])
        if sine <= LIMITS.min_tilt:
            raise InvalidInput(
                "`nutation_rate` needs an axis that leans: a vertical one has no line of nodes to turn about. Let it "
                "lean, or give the angular velocity."
            )
        in_space = in_space + nutation_rate * np.array([-axis[1], axis[0], 0.0]) / sine
    return rotation.rotate(back, in_space) + spin_rate * np.asarray(top.axis)


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
