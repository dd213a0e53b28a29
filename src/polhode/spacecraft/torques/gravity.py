"""The torque of gravity's gradient on a body in its orbit."""

from __future__ import annotations

from typing import ClassVar, NamedTuple

import equinox as eqx
import jax.numpy as jnp
import numpy as np

from polhode._base import check
from polhode._base.arrays import known_numbers_only
from polhode.bodies.body import Body
from polhode.errors import InvalidInput
from polhode.motion.frame import BodyFrame
from polhode.spacecraft.systems.attachments import Attitude, Own, Time, Velocity
from polhode.spacecraft.torques.base import NEEDED, AbstractEnvironmentTorque, in_body
from polhode.systems._symmetric import times
from polhode.systems.free_rigid_body import checked_moments
from polhode.systems.kepler_orbit import KeplerOrbit
from polhode.types import Array, ArrayLike, Float64, Real


class InertiaLimits(NamedTuple):
    """Which moments of a gravity gradient are refused."""

    relative_inertia: float = 1e-12  # difference that turning an inertia to other axes and back leaves


LIMITS = InertiaLimits()


class GravityGradient(AbstractEnvironmentTorque):
    """τ = 3 (GM/R³) R̂ × I R̂, with R̂ the direction of the attracting centre in body axes and GM/R³ = n² (a/r)³.

    The first term in the body's size over R. The orbit is not moved by it.

    Args:
        orbit: of the body's centre of mass about the attracting centre.
        moments: (3,) principal moments of the body [kg m²], or its inertia (3, 3) along the axes in which it is given;
            left out, it takes those of the body that it is put on.

    Source: Hughes, *Spacecraft Attitude Dynamics* (1986), ch. 8.
    """

    name: ClassVar[str] = "gravity-gradient"

    orbit: KeplerOrbit
    moments: Float64[Array, "3"] | Float64[Array, "3 3"] | None
    circular: bool = eqx.field(static=True)

    @known_numbers_only
    def __init__(
        self, orbit: KeplerOrbit, moments: Real[ArrayLike, "3"] | Real[ArrayLike, "3 3"] | None = None
    ) -> None:
        check.instance("orbit", orbit, KeplerOrbit, "a polhode.systems.KeplerOrbit")
        self.orbit = orbit
        if moments is None or np.shape(moments) != (3, 3):
            self.moments = None if moments is None else checked_moments(moments)
        else:
            inertia = Body.from_inertia(moments).inertia
            diagonal = np.diagonal(inertia)
            self.moments = jnp.asarray(diagonal if np.array_equal(np.diag(diagonal), inertia) else inertia)
        self.circular = float(orbit.eccentricity) == 0.0

    def bound(self, frame: BodyFrame) -> GravityGradient:
        principal = np.array_equal(frame.axes, np.eye(3))
        own = np.asarray(frame.moments if principal else frame.inertia)
        if self.moments is None:
            return GravityGradient(self.orbit, own)
        given = np.asarray(self.moments)
        as_matrix = [np.diag(x) if x.ndim == 1 else x for x in (given, own)]
        if not np.abs(as_matrix[0] - as_matrix[1]).max() <= LIMITS.relative_inertia * np.abs(own).max():
            raise InvalidInput(
                f"`torques` has the gravity gradient on the moments {given.tolist()}, but the body's are "
                f"{own.tolist()} kg m² along its axes. Give both the same, or leave them out here."
            )
        return self

    @property
    def rate(self) -> Float64[Array, ""]:
        return self.orbit.mean_motion

    def torque(
        self, t: Time, attitude: Attitude, angular_velocity: Velocity, actuator: Own | None = None
    ) -> Float64[Array, "*batch 3"]:
        assert attitude is not None, NEEDED
        # GM/R³ = n² (a/r)³ with n² a³ = GM; the force on dm at r is expanded to first order in r/R, dF = GM/R³ (3
        # (r·R̂) R̂ − r) dm, and ∫ r × dF = 3 GM/R³ R̂ × I R̂
        strength, centre = self.pull(t, attitude)
        return 3.0 * strength[..., None] * jnp.cross(centre, times(self._inertia, centre))

    def pull(
        self, t: Time, attitude: Float64[Array, "*#batch 4"]
    ) -> tuple[Float64[Array, "*#batch"], Float64[Array, "*batch 3"]]:
        """Return GM/R³ (…) [1/s²] and the line to the attracting centre (…, 3) [body axes], of either sign."""
        strength = self.orbit.mean_motion**2 / self.orbit.distance_ratio(t) ** 3
        return strength, in_body(attitude, self.orbit.direction(t))

    @property
    def _inertia(self) -> Array:
        if self.moments is None:
            raise InvalidInput("the gravity gradient has no moments yet; give `moments`, or put it on a body.")
        return self.moments

    def relative_velocity(
        self, attitude: Float64[Array, "*#batch 4"], angular_velocity: Float64[Array, "*#batch 3"]
    ) -> Float64[Array, "*batch 3"]:
        """Return the angular velocity (…, 3) against the frame that turns with mean motion [rad/s, body axes]."""
        return angular_velocity - self.orbit.mean_motion * in_body(attitude, self.orbit.normal)
