"""Torques on a body, in its axes."""

from __future__ import annotations

import abc
from typing import Any

import equinox as eqx
import jax.numpy as jnp
import numpy as np

from polhode import rotation
from polhode.arrays import known_numbers_only, refuse_single_precision
from polhode.errors import InvalidInput, shown
from polhode.systems.free_rigid_body import checked_moments
from polhode.systems.kepler_orbit import KeplerOrbit, checked_number

Array = Any


class AbstractTorque(eqx.Module):
    """What acts on a body."""

    @property
    def needs_attitude(self) -> bool:
        """Whether the torque depends on how the body is turned."""
        return False

    @property
    def rate(self) -> Array:
        """The angular velocity [rad/s] of the motion that it causes from rest; zero if it causes none."""
        return jnp.zeros(())

    @abc.abstractmethod
    def torque(self, t: Array, attitude: Array | None, angular_velocity: Array) -> Array:
        """Return τ (…, 3) [N m, body axes].

        Args:
            t: one time (), or one for each state (…) [s]; beside vectors write ``t[..., None]``.
            attitude: (…, 4) unit quaternions wxyz, body → space; None where the state carries none.
            angular_velocity: Ω (…, 3) [rad/s, body axes].
        """


class LinearDrag(AbstractTorque):
    """τ = −c Ω, the drag of a slow flow.

    Args:
        coefficient: c [N m s], one for all axes or one for each (3,), not negative.
    """

    coefficient: Array

    @known_numbers_only
    def __init__(self, coefficient: Array) -> None:
        refuse_single_precision(coefficient=coefficient)
        values = np.asarray(coefficient, dtype=float)
        if values.shape not in ((), (3,)) or not (np.isfinite(values).all() and (values >= 0).all()):
            raise InvalidInput(
                f"`coefficient` of linear drag must be one or three finite numbers, not negative [N m s]; "
                f"got {shown(values.tolist())}. Drag takes energy: give its size without a sign."
            )
        self.coefficient = jnp.asarray(values)

    def torque(self, t: Array, attitude: Array | None, angular_velocity: Array) -> Array:
        return -self.coefficient * angular_velocity


class QuadraticDrag(AbstractTorque):
    """τ = −k |Ω| Ω, the drag of a fast flow.

    Args:
        coefficient: k [N m s²], not negative.
    """

    coefficient: Array

    @known_numbers_only
    def __init__(self, coefficient: float) -> None:
        self.coefficient = checked_number("coefficient", coefficient, least=0.0, unit="N m s²")

    def torque(self, t: Array, attitude: Array | None, angular_velocity: Array) -> Array:
        return -self.coefficient * jnp.linalg.norm(angular_velocity, axis=-1, keepdims=True) * angular_velocity


class GravityGradient(AbstractTorque):
    """τ = 3 (GM/R³) R̂ × I R̂, with R̂ the direction of the attracting centre in body axes and GM/R³ = n² (a/r)³.

    The first term in the body's size over R. The orbit is not moved by it.

    Args:
        orbit: of the body's centre of mass about the attracting centre.
        moments: (3,) principal moments of the body [kg m²].

    Source: Hughes, *Spacecraft Attitude Dynamics* (1986), ch. 8.
    """

    orbit: KeplerOrbit
    moments: Array
    circular: bool = eqx.field(static=True)

    @known_numbers_only
    def __init__(self, orbit: KeplerOrbit, moments: Array) -> None:
        if not isinstance(orbit, KeplerOrbit):
            raise InvalidInput(f"`orbit` must be a polhode.systems.KeplerOrbit; got {shown(orbit)}.")
        self.orbit, self.moments = orbit, checked_moments(moments)
        self.circular = float(orbit.eccentricity) == 0.0

    @property
    def needs_attitude(self) -> bool:
        return True

    @property
    def rate(self) -> Array:
        return self.orbit.mean_motion

    def torque(self, t: Array, attitude: Array | None, angular_velocity: Array) -> Array:
        strength = (self.orbit.mean_motion**2 / self.orbit.distance_ratio(t) ** 3)[..., None]
        centre = _in_body(attitude, self.orbit.direction(t))  # its sign cancels
        return 3.0 * strength * jnp.cross(centre, self.moments * centre)

    def relative_velocity(self, attitude: Array, angular_velocity: Array) -> Array:
        """Return the angular velocity (…, 3) against the frame that turns with mean motion [rad/s, body axes]."""
        return angular_velocity - self.orbit.mean_motion * _in_body(attitude, jnp.array([0.0, 0.0, 1.0]))

    def jacobi_integral(self, t: Array, attitude: Array, angular_velocity: Array) -> Array:
        """Return ½ w·Iw + (3/2) n² R̂·IR̂ − ½ n² ẑ·Iẑ (…) [J], which a circular orbit conserves.

        It is H − n π_z of the inertial motion; w is the velocity relative to the orbit's frame and ẑ its normal.

        Source: Hughes, *Spacecraft Attitude Dynamics*, ch. 9.
        """
        n = self.orbit.mean_motion
        relative = self.relative_velocity(attitude, angular_velocity)
        centre = _in_body(attitude, self.orbit.direction(t))
        normal = _in_body(attitude, jnp.array([0.0, 0.0, 1.0]))
        squares = relative**2 + n**2 * (3.0 * centre**2 - normal**2)
        return 0.5 * jnp.sum(self.moments * squares, axis=-1)


def _in_body(attitude: Array, direction: Array) -> Array:
    return rotation.rotate(rotation.conjugate(attitude), direction)
