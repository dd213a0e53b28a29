"""A rotor inside a body: the axes along which the two move, their moments, and their start."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from polhode import rotation
from polhode._base.arrays import known_numbers_only
from polhode.bodies._inertia import principal_axes
from polhode.bodies.body import Body
from polhode.errors import InvalidInput, shown
from polhode.systems.gyrostat import Gyrostat
from polhode.types import Array, ArrayLike, ArrayOrFloat, Float64, Real


class RotorInBody(NamedTuple):
    """A body with its rotor, at the start of a motion, or of many from different spins.

    Attributes:
        moments: (3,) of the motion: rotor locked, or of a free rotor less its axial moment [kg m²].
        axes: (3, 3) their axes by columns in the given ones; the vectors below are along them.
        along: (3,) unit vector of the rotor's axis.
        momentum: (…) of the rotor along its axis, relative to the body or, of a free one, whole [kg m²/s].
        velocity: (…, 3) Ω [rad/s].
        total: (…, 3) L of body and rotor [kg m²/s].
        attitude: (…, 4) unit quaternion, these axes → space.
        rotor_moment: J of the rotor about its axis [kg m²].
        free: whether no torque about its axis acts on it.
    """

    moments: Float64[Array, "3"]
    axes: Float64[Array, "3 3"]
    along: Float64[Array, "3"]
    momentum: Float64[ArrayOrFloat, "*start"]
    velocity: Float64[Array, "*start 3"]
    total: Float64[Array, "*start 3"]
    attitude: Float64[Array, "*turn 4"]
    rotor_moment: float
    free: bool

    @property
    def rotor(self) -> Float64[Array, "3"]:
        """The rotor's momentum h [kg m²/s], as of ``Gyrostat``."""
        return self.momentum * self.along

    @property
    def gyrostat(self) -> Gyrostat:
        """The system for a free rotor, or one held at its rate."""
        return Gyrostat(self.moments, self.rotor, self.rotor_moment, self.free)

    @property
    def usual_rate(self) -> float:
        """How fast body or momentum turn at least [rad/s]; zero where neither does."""
        length = float(np.linalg.norm(self.total))
        return max(float(np.linalg.norm(self.velocity)), length / float(np.max(self.moments)))


@known_numbers_only
def rotor_in_body(
    body: Body,
    rotor_axis: Real[ArrayLike, "3"],
    rotor_moment: float,
    rotor_rate: float,
    angular_velocity: Real[ArrayLike, "*start 3"],
    attitude: Real[ArrayLike, "*turn 4"] = (1.0, 0.0, 0.0, 0.0),
    *,
    free: bool = False,
) -> RotorInBody:
    """Return a body with a rotor in it, along the principal axes of its motion.

    Args:
        body: whose inertia includes the rotor's.
        rotor_axis: (3,) of any length [given axes].
        rotor_moment: about that axis [kg m²].
        rotor_rate: relative to the body [rad/s].
        angular_velocity: (…, 3) Ω of the body [rad/s, given axes].
        attitude: (…, 4) unit quaternion wxyz, given axes → space.
        free: whether the rotor turns freely, or by a motor of given torque, and not at a constant rate; its axial
            moment does not move with the body then.

    Raises:
        InvalidInput: for a rotor whose inertia, at least that of a thin disk, leaves none that a carrier could have.

    >>> import polhode as ph
    >>> assembly = rotor_in_body(ph.Body.from_moments((2.0, 3.0, 4.0)), (0, 0, 1), 0.5, 10.0, (0, 0, 1.0), free=True)
    >>> assembly.moments.tolist(), assembly.momentum, assembly.total.tolist()
    ([2.0, 3.0, 3.5], 5.5, [0.0, 0.0, 9.0])

    Source: Hughes, *Spacecraft Attitude Dynamics*, §3.4.
    """
    axis = find_direction(rotor_axis)
    if why := rotor_misfit(body, axis, rotor_moment):
        raise InvalidInput(f"`rotor_moment` {why}")
    moments, axes = body.principal_moments, body.principal_axes
    if free:
        # L = (I − J aaᵀ) Ω + h a with h = J (σ + a·Ω): what the axial moment carries is in h (Hughes §3.4)
        moments, axes = principal_axes(body.inertia - rotor_moment * np.outer(axis, axis))
    along = clean_direction(axes.T @ axis)
    velocity = (np.asarray(angular_velocity, dtype=float)[..., None, :] @ axes)[..., 0, :]  # alike of one and of many
    body_attitude = rotation.multiply(np.asarray(attitude, dtype=float), rotation.from_matrix(axes))
    momentum = rotor_moment * (rotor_rate + (np.vecdot(velocity, along) if free else np.zeros(velocity.shape[:-1])))
    total = moments * velocity + momentum[..., None] * along
    return RotorInBody(moments, axes, along, momentum if momentum.ndim else float(momentum), velocity, total,
                       body_attitude, float(rotor_moment), free)


@known_numbers_only
def find_direction(vector: Real[ArrayLike, "3"]) -> Float64[Array, "3"]:
    """Return the direction of a vector (3,) of any length.

    Raises:
        InvalidInput: for a vector without direction.
    """
    array = np.asarray(vector, dtype=float)
    largest = np.abs(array).max() if array.shape == (3,) else np.nan
    if not 0.0 < largest < np.inf:
        raise InvalidInput(f"an axis must be three finite numbers, not all zero; got {shown(vector)}.")
    array = array / largest  # so that squares neither vanish nor overflow
    return array / np.linalg.norm(array)


def rotor_misfit(body: Body, rotor_axis: Real[ArrayLike, "3"], rotor_moment: float) -> str | None:
    """Return why a body cannot have a rotor in it, as a sentence about its moment; None where it can.

    Its inertia, at least that of a thin disk, must leave some that a carrier could have.

    Args:
        body: whose inertia includes the rotor's.
        rotor_axis: (3,) of any length [given axes].
        rotor_moment: about that axis [kg m²].
    """
    axis = find_direction(rotor_axis)
    # a disk has J about its axis and J/2 across it, ½J (1 + aaᵀ); a body of axial moment J with less across would have
    # I1 + I2 < I3
    inertia = body.inertia - 0.5 * rotor_moment * (np.eye(3) + np.outer(axis, axis))
    try:
        fits = bool(Body(None, (0.0, 0.0, 0.0), inertia, body.effective).principal_moments[0] > 0)
    except InvalidInput:
        fits = False
    if fits and axis @ body.inertia @ axis > rotor_moment:
        return None
    left = ", ".join(f"{x:.6g}" for x in principal_axes(inertia)[0])
    return (
        f"must be that of a part of the body; got {rotor_moment:.6g} kg m², without which the body would be left with "
        f"moments of at most ({left}) kg m². No body has these; check rotor_moment and rotor_axis, and that the body "
        "has the rotor in it."
    )


def clean_direction(direction: Float64[Array, "3"]) -> Float64[Array, "3"]:
    """Return a unit vector with components at the size of rounding set to zero."""
    rounding = 1e-14  # of the frame, in components of a unit vector
    return np.where(np.abs(direction) < rounding, 0.0, direction)
