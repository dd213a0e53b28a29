"""Torques on a body, in its axes."""

from __future__ import annotations

import abc
from collections.abc import Callable
from typing import Any

import equinox as eqx
import jax.numpy as jnp
import numpy as np

from polhode import rotation
from polhode.arrays import known_numbers_only, refuse_single_precision
from polhode.bodies.body import Body
from polhode.errors import InvalidInput, shown
from polhode.motion._layout import StatePart
from polhode.motion.frame import BodyFrame
from polhode.systems._symmetric import times
from polhode.systems.attachments import (
    AbstractAttachment,
    Attitude,
    Own,
    Time,
    Velocity,
    checked_attachments,
    checked_jumps,
)
from polhode.systems.free_rigid_body import checked_moments
from polhode.systems.kepler_orbit import KeplerOrbit, checked_number
from polhode.types import Array, ArrayLike, Float64, Real

SAME = 1e-12  # relative, of an inertia that was turned to other axes and back
NEEDED = "a torque is given the attitude and the state that it says it needs"

Command = Callable[
    [Float64[Array, "*batch"], Float64[Array, "*batch 4"], Float64[Array, "*batch 3"]], Float64[Array, "*batch 3"]
]


class AbstractTorque(AbstractAttachment):
    """An external torque on a body; it may have a state of its own, as an actuator has.

    Its power τ·Ω enters the balance of the energy.
    """

    def state_rate(
        self, t: Time, attitude: Attitude, angular_velocity: Velocity, actuator: Own
    ) -> Float64[Array, "*batch {self.state_size}"]:  # fmt: skip
        """Return how fast its own state changes, (…, n); not at all by default."""
        return jnp.zeros_like(actuator)

    @property
    def rate(self) -> Float64[Array, ""]:
        """The angular velocity [rad/s] that it causes from rest; zero if it causes none."""
        return jnp.zeros(())

    def force(
        self, t: Time, attitude: Attitude, angular_velocity: Velocity, actuator: Own | None = None
    ) -> Float64[Array, "*batch 3"] | None:  # fmt: skip
        """Return the resultant force on the body (…, 3) [N, body axes]; None for a couple."""
        return None

    @abc.abstractmethod
    def torque(
        self, t: Time, attitude: Attitude, angular_velocity: Velocity, actuator: Own | None = None
    ) -> Float64[Array, "*batch 3"]:  # fmt: skip
        """Return τ (…, 3) about the origin of the body's axes [N m, body axes].

        For a body from moments that origin is its centre of mass, for one ``from_body`` that of the given axes. A
        couple is the same about any point; what has a resultant ``force`` is referred to the centre of mass by the
        body.

        Args:
            t: one time (), or one for each state (…) [s]; with vectors write ``t[..., None]``.
            attitude: (…, 4) unit quaternions wxyz, body → space; None where the state carries none.
            angular_velocity: Ω (…, 3) [rad/s, body axes].
            actuator: (…, n) its own state; of no components for a torque without one, which may be called without it.
        """


class LinearDrag(AbstractTorque):
    """τ = −c Ω, the drag of a slow flow.

    Args:
        coefficient: c [N m s], one for all axes or one for each (3,), not negative.
    """

    coefficient: Float64[Array, "*components"]

    @known_numbers_only
    def __init__(self, coefficient: Real[ArrayLike, "*components"]) -> None:
        refuse_single_precision(coefficient=coefficient)
        values = np.asarray(coefficient, dtype=float)
        if values.shape not in ((), (3,)) or not (np.isfinite(values).all() and (values >= 0).all()):
            raise InvalidInput(
                f"`coefficient` of linear drag must be one or three finite numbers, not negative [N m s]; "
                f"got {shown(values.tolist())}. Drag takes energy: give its size without a sign."
            )
        self.coefficient = jnp.asarray(values)

    def torque(
        self, t: Time, attitude: Attitude, angular_velocity: Velocity, actuator: Own | None = None
    ) -> Float64[Array, "*batch 3"]:  # fmt: skip
        return -self.coefficient * angular_velocity


class QuadraticDrag(AbstractTorque):
    """τ = −k |Ω| Ω, the drag of a fast flow.

    Args:
        coefficient: k [N m s²], not negative.
    """

    coefficient: Float64[Array, ""]

    @known_numbers_only
    def __init__(self, coefficient: float) -> None:
        self.coefficient = checked_number("coefficient", coefficient, least=0.0, unit="N m s²")

    def torque(
        self, t: Time, attitude: Attitude, angular_velocity: Velocity, actuator: Own | None = None
    ) -> Float64[Array, "*batch 3"]:  # fmt: skip
        return -self.coefficient * jnp.linalg.norm(angular_velocity, axis=-1, keepdims=True) * angular_velocity


class LaggedTorque(AbstractTorque):
    """A torque that follows a command with a lag of first order: τ̇ = (u − τ)/T, as of a thruster or a magnetorquer.

    Its state is τ itself (…, 3).

    Args:
        command: u (…, 3) [N m, body axes], a function (t, attitude, angular_velocity) of the time (…) [s], the attitude
            (…, 4) and Ω (…, 3), batched and written with ``jax.numpy``. It asks for states with the attitude.
        time_constant: T [s], positive.
        jumps: (J,) times [s] at which the command jumps; see ``AbstractSystem.jumps``.

    Raises:
        InvalidInput: for a command that is not a function, a time constant that is not positive, or jumps that are not
            times.
    """

    command: Command
    time_constant: Float64[Array, ""]
    jump_times: Float64[Array, "jumps"]

    @known_numbers_only
    def __init__(
        self, command: Command, time_constant: float, jumps: Real[ArrayLike, "jumps"] = ()
    ) -> None:
        if not callable(command):
            raise InvalidInput(
                f"`command` must be a function (t, attitude, angular_velocity) that gives a torque (…, 3) [N m]; "
                f"got {shown(command)}. For a constant one write `lambda t, attitude, velocity: 0 * velocity + torque`."
            )
        self.command, self.time_constant = command, checked_number("time_constant", time_constant, 0.0, unit="s")
        self.jump_times = checked_jumps(jumps)

    @property
    def jumps(self) -> Float64[Array, "jumps"]:
        return self.jump_times

    @property
    def state_parts(self) -> tuple[StatePart, ...]:
        return (StatePart("actuator_torque", 3, "N m", "torque of the actuator", "body"),)

    @property
    def needs_attitude(self) -> bool:
        return True

    def state_rate(
        self, t: Time, attitude: Attitude, angular_velocity: Velocity, actuator: Own
    ) -> Float64[Array, "*batch {self.state_size}"]:  # fmt: skip
        assert attitude is not None, NEEDED
        return (self.command(t, attitude, angular_velocity) - actuator) / self.time_constant

    def torque(
        self, t: Time, attitude: Attitude, angular_velocity: Velocity, actuator: Own | None = None
    ) -> Float64[Array, "*batch 3"]:  # fmt: skip
        assert actuator is not None, NEEDED
        return actuator


class GravityGradient(AbstractTorque):
    """τ = 3 (GM/R³) R̂ × I R̂, with R̂ the direction of the attracting centre in body axes and GM/R³ = n² (a/r)³.

    The first term in the body's size over R. The orbit is not moved by it.

    Args:
        orbit: of the body's centre of mass about the attracting centre.
        moments: (3,) principal moments of the body [kg m²], or its inertia (3, 3) along the axes in which it is given;
            left out, it takes those of the body that it is put on.

    Source: Hughes, *Spacecraft Attitude Dynamics* (1986), ch. 8.
    """

    orbit: KeplerOrbit
    moments: Float64[Array, "3"] | Float64[Array, "3 3"] | None
    circular: bool = eqx.field(static=True)

    @known_numbers_only
    def __init__(
        self, orbit: KeplerOrbit, moments: Real[ArrayLike, "3"] | Real[ArrayLike, "3 3"] | None = None
    ) -> None:
        if not isinstance(orbit, KeplerOrbit):
            raise InvalidInput(f"`orbit` must be a polhode.systems.KeplerOrbit; got {shown(orbit)}.")
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
        if not np.abs(as_matrix[0] - as_matrix[1]).max() <= SAME * np.abs(own).max():
            raise InvalidInput(
                f"`torques` has the gravity gradient on the moments {given.tolist()}, but the body's are "
                f"{own.tolist()} kg m² along its axes. Give both the same, or leave them out here."
            )
        return self

    @property
    def needs_attitude(self) -> bool:
        return True

    @property
    def rate(self) -> Float64[Array, ""]:
        return self.orbit.mean_motion

    def torque(
        self, t: Time, attitude: Attitude, angular_velocity: Velocity, actuator: Own | None = None
    ) -> Float64[Array, "*batch 3"]:  # fmt: skip
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
        return strength, _in_body(attitude, self.orbit.direction(t))

    @property
    def _inertia(self) -> Array:
        if self.moments is None:
            raise InvalidInput("the gravity gradient has no moments yet; give `moments`, or put it on a body.")
        return self.moments

    def relative_velocity(
        self, attitude: Float64[Array, "*#batch 4"], angular_velocity: Float64[Array, "*#batch 3"]
    ) -> Float64[Array, "*batch 3"]:
        """Return the angular velocity (…, 3) against the frame that turns with mean motion [rad/s, body axes]."""
        return angular_velocity - self.orbit.mean_motion * _in_body(attitude, jnp.array([0.0, 0.0, 1.0]))

    def jacobi_integral(
        self, t: Real[ArrayLike, "*#batch"], attitude: Float64[Array, "*#batch 4"],
        angular_velocity: Float64[Array, "*#batch 3"],
    ) -> Float64[Array, "*batch"]:  # fmt: skip
        """Return ½ w·Iw + (3/2) n² R̂·IR̂ − ½ n² ẑ·Iẑ (…) [J], which a circular orbit conserves.

        It is H − n π_z of the inertial motion; w is the velocity relative to the orbit's frame and ẑ its normal.

        Source: Hughes, *Spacecraft Attitude Dynamics*, ch. 9.
        """
        n = self.orbit.mean_motion
        relative = self.relative_velocity(attitude, angular_velocity)
        centre = _in_body(attitude, self.orbit.direction(t))
        normal = _in_body(attitude, jnp.array([0.0, 0.0, 1.0]))
        # H = ½ Ω·IΩ + V with V = (3/2) n² R̂·IR̂ but for a constant; less n ẑ·IΩ, with Ω = w + nẑ
        if (inertia := self._inertia).ndim == 1:
            squares = relative**2 + n**2 * (3.0 * centre**2 - normal**2)
            return 0.5 * jnp.sum(inertia * squares, axis=-1)
        turning, pull, about = (jnp.sum(x * times(inertia, x), axis=-1) for x in (relative, centre, normal))
        return 0.5 * (turning + n**2 * (3.0 * pull - about))


def checked_torques(torques: Any, frame: BodyFrame) -> tuple[AbstractTorque, ...]:
    """Return a list of torques on a body.

    Raises:
        InvalidInput: for anything else, one whose methods fail, and a gravity gradient on other moments.
    """

    def trial(torque: AbstractTorque, t: Array, attitude: Array, velocity: Array, own: Array) -> dict[str, Any]:
        results = {
            "torque": (torque.torque(t, attitude, velocity, own), (3,)),
            "state_rate": (torque.state_rate(t, attitude, velocity, own), (torque.state_size,)),
        }
        force = torque.force(t, attitude, velocity, own)
        return results if force is None else results | {"force": (force, (3,))}

    return checked_attachments("torques", torques, (AbstractTorque,), frame, trial)


def _in_body(attitude: Array, direction: Array) -> Array:
    return rotation.rotate(rotation.conjugate(attitude), direction)
