"""The steady coning of a free symmetric body, and of a gyroscope in its frame: rates, momenta and torques."""

from __future__ import annotations

import math

import numpy as np

from polhode._base.arrays import known_numbers_only
from polhode.bodies._pivot import axis_of_symmetry
from polhode.errors import InvalidInput, shown
from polhode.exact.lagrange_top.steady_precession import SteadyPrecession, steady_precession
from polhode.special._circular import cosine_and_sine
from polhode.types import Array, ArrayLike, Float64, Real


@known_numbers_only
def coning_momentum(
    moments: Real[ArrayLike, "3"], nutation: float | None = None, spin: float | None = None,
    precession: float | None = None,
) -> Float64[np.ndarray, "3"]:
    """Return the momentum (3,) of a free symmetric body that cones, by two of three numbers [kg m²/s, principal axes].

    Its axis keeps the angle θ to L and goes round it at φ̇ = |L|/A, while the body turns about the axis at ψ̇ against
    the plane of both: ψ̇ = (A − C)/C φ̇ cos θ. The component of Ω along the axis is ψ̇ + φ̇ cos θ = A/C φ̇ cos θ.

    Args:
        moments: (3,) principal moments [kg m²], of which two are equal, A; C is the third.
        nutation: θ [rad], from 0 to π.
        spin: ψ̇ [rad/s].
        precession: φ̇ [rad/s]; a negative one gives the opposite L.

    Raises:
        InvalidInput: for a body that is not symmetric, or a sphere, for not exactly two numbers, and for rates that no
            motion of this body has.

    Source: Goldstein, *Classical Mechanics*, §5.6; Marsden & Ratiu, *Introduction to Mechanics and Symmetry*, §15.

    >>> coning_momentum((300.0, 300.0, 500.0), nutation=math.pi / 3, precession=2.0).round(9).tolist()
    [519.615242271, 0.0, 300.0]
    """
    I = np.asarray(moments, dtype=float)  # noqa: E741
    k = _axis_of_symmetry(I)
    if (nutation is None) + (spin is None) + (precession is None) != 1:
        raise InvalidInput("coning needs two of nutation, spin and precession, from which the third follows.")
    A, C = float(I[(k + 1) % 3]), float(I[k])
    if nutation is not None and not 0.0 <= nutation <= math.pi:
        raise InvalidInput(f"the nutation must be an angle from 0 to 180 deg; got {math.degrees(nutation):.6g} deg.")
    if nutation is None:
        assert spin is not None and precession is not None
        cosine = C * spin / ((A - C) * precession) if precession else math.inf
        if not abs(cosine) <= 1.0:
            most = abs(A - C) / C * abs(precession)
            raise InvalidInput(
                f"no free motion of this body has a spin of {spin:.6g} rad/s against its plane with L at a precession "
                f"of {precession:.6g} rad/s: the spin is (A − C)/C φ̇ cos θ = {(A - C) / C:.6g} φ̇ cos θ, at most "
                f"{most:.6g} rad/s. Give nutation, the angle, in place of one; the rate about the axis against the "
                "stars is another number, A/C φ̇ cos θ."
            )
        nutation = math.acos(cosine)
    elif precession is None:
        assert spin is not None
        across = (A - C) * float(cosine_and_sine(nutation)[0])
        if across == 0.0:
            raise InvalidInput("a body that cones at a right angle has no spin; give its precession.")
        precession = C * spin / across
    L = np.zeros(3)
    along, aside = map(float, cosine_and_sine(nutation))
    L[k], L[(k + 1) % 3] = A * precession * along, A * precession * aside
    return L


@known_numbers_only
def precession_with_fixed_frame(
    transverse: float, rotor: float, frame: float, mgl: float, tilt: float, spin_rate: float
) -> SteadyPrecession | None:
    """Return the rates at which a gyroscope precesses steadily while its frame does not turn about the axis.

    The frame goes round with the line of nodes, so that its axial moment counts with φ̇ cos θ alone: the roots of
    (A − C_r − C_f) cos θ φ̇² − C_r ψ̇ φ̇ + mgl = 0, those of a top with the moments A − C_f and C_r.

    Args:
        transverse: A of rotor and frame together across the axis, about the pivot [kg m²].
        rotor, frame: their moments C_r and C_f about the axis [kg m²]; a frame of zero is a top.
        mgl: weight of both times the distance of their centre of mass from the pivot [N m].
        tilt: θ of the axis from the upward vertical [rad], strictly between 0 and π.
        spin_rate: ψ̇ of the rotor against its frame [rad/s].

    Raises:
        InvalidInput: for moments that no such bodies have, and as ``steady_precession`` does.

    >>> toy = precession_with_fixed_frame(2.0028e-3, 2.57125e-4, 0.0, 0.1750487, math.pi / 2, 90.0 * math.pi)
    >>> print(toy is not None and round(2.0 * math.pi / toy.slow, 4))
    2.6095
    """
    if not (0.0 < rotor < math.inf and 0.0 <= frame < transverse < math.inf):
        raise InvalidInput(
            "the rotor's moment must be positive, and the frame's axial one from zero to below the transverse one of "
            f"both; got {shown((transverse, rotor, frame))} kg m²."
        )
    across = transverse - frame
    return steady_precession((across, across, rotor), mgl, tilt, spin_rate=spin_rate)


@known_numbers_only
def holding_torque(
    transverse: float, rotor: float, frame: float, mgl: float, tilt: float, spin_rate: float, precession: float
) -> float:
    """Return the torque [N m] about the line of nodes that holds a gyroscope in a given steady precession.

    Positive lowers the axis, as weight does: sin θ (φ̇ (C_r ψ̇ + (C_r + C_f − A) φ̇ cos θ) − mgl). Zero at the rates of
    ``precession_with_fixed_frame``.

    Args:
        transverse, rotor, frame, mgl, tilt, spin_rate: as ``precession_with_fixed_frame`` has them; mgl may be zero.
        precession: φ̇ about the upward vertical [rad/s].

    Raises:
        InvalidInput: for values that are not finite.

    >>> round(holding_torque(0.03, 0.01, 0.0, 0.0, math.pi / 2, 100.0, 2.0), 12)
    2.0
    """
    values = (transverse, rotor, frame, mgl, tilt, spin_rate, precession)
    if not all(math.isfinite(value) for value in values):
        raise InvalidInput(f"moments, weight, tilt and rates must be finite numbers; got {shown(values)}.")
    axial = rotor * spin_rate + (rotor + frame - transverse) * precession * math.cos(tilt)
    return math.sin(tilt) * (precession * axial - mgl)


def _axis_of_symmetry(moments: Array) -> int:
    good = moments.shape == (3,) and np.isfinite(moments).all() and (moments > 0.0).all()
    axes = [k for k in range(3) if good and axis_of_symmetry(moments, np.eye(3)[k]) == k]
    if len(axes) != 1:
        raise InvalidInput(
            "coning at a constant angle is of a body with two equal principal moments and a third one; got "
            f"{shown(moments.tolist())} kg m². Give the angular velocity or the momentum instead."
        )
    return axes[0]
