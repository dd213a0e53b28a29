"""Mounts inside a rigid body: rotors, a slug of fuel, and losses without moving parts of their own."""

from __future__ import annotations

import abc
from collections.abc import Callable

import jax.numpy as jnp
import numpy as np

from polhode.arrays import known_numbers_only, refuse_single_precision
from polhode.errors import InvalidInput, shown
from polhode.motion._layout import StatePart
from polhode.systems.attachments import (
    AbstractAttachment,
    Attitude,
    Own,
    Time,
    Velocity,
    checked_jumps,
)
from polhode.systems.free_rigid_body import checked_vector
from polhode.systems.kepler_orbit import checked_number
from polhode.types import Array, ArrayLike, Float64, Real

Batch = Float64[Array, "*batch"]
Motor = Callable[[Batch, Float64[Array, "*batch 4"], Float64[Array, "*batch 3"], Batch], Batch]


class AbstractMounted(AbstractAttachment):
    """What is inside a body and has momentum and energy of its own: a mount, or a part that moves its mass."""

    @property
    def inertia(self) -> Float64[Array, "3 3"] | None:
        """(3, 3) inertia that turns by its own state instead of with the carrier [kg m²]; None if none does."""
        return None

    @property
    def conserves_energy(self) -> bool:
        """Whether its power is always zero."""
        return True

    @property
    def momentum_scale(self) -> Float64[Array, ""]:
        """The momentum [kg m²/s] that it gives a body from rest, roughly; zero if none."""
        return jnp.zeros(())

    def momentum(self, own: Float64[Array, "*batch {self.state_size}"]) -> Float64[Array, "*batch 3"]:
        """Return p (…, 3), its own angular momentum [kg m²/s, body axes]; zero by default."""
        return jnp.zeros((*own.shape[:-1], 3))

    def energy(self, own: Float64[Array, "*batch {self.state_size}"]) -> Float64[Array, "*batch"]:
        """Return its own energy (…) [J]."""
        return jnp.zeros(own.shape[:-1])


class AbstractMount(AbstractMounted):
    """A part that turns inside a body without moving its mass, as a rotor does.

    A mount brings its own angular momentum p. The whole body's is L = K Ω + Σ p, where K is the inertia of the body
    with all mounts locked, less what each mount turns by itself, its ``inertia``. The mount's reaction on the carrier
    is in that sum: L changes by outer torques alone, so that what a rotor gains the carrier loses. The energy is
    ½ Ω·KΩ + Σ ``energy``, and changes inside by the sum of ``power``.

    A new mount gives ``momentum`` and, where it has a state of its own, ``state_parts``, ``state_rate``, ``start``,
    ``inertia``, ``energy`` and ``power``. Where energy and power disagree, the drift of the energy says so. What moves
    its mass is an ``AbstractMovingPart``.
    """

    @abc.abstractmethod
    def momentum(self, own: Float64[Array, "*batch {self.state_size}"]) -> Float64[Array, "*batch 3"]:
        """Return p (…, 3) [kg m²/s, body axes]."""

    def state_rate(
        self, t: Time, attitude: Attitude, angular_velocity: Velocity, own: Own
    ) -> Float64[Array, "*batch {self.state_size}"]:
        """Return how fast its own state changes, (…, n); not at all by default."""
        return jnp.zeros_like(own)

    def power(self, t: Time, attitude: Attitude, angular_velocity: Velocity, own: Own) -> Float64[Array, "*batch"]:
        """Return the power (…) [W] of the forces between mount and carrier; negative where energy is lost."""
        return jnp.zeros(angular_velocity.shape[:-1])

    def drift(
        self, momentum: Float64[Array, "*#batch 3"], angular_velocity: Float64[Array, "*#batch 3"]
    ) -> Float64[Array, "*batch 3"]:
        """Return how much faster than Ω the body turns, (…, 3) [rad/s, body axes].

        Zero but for losses that have no state of their own: they act on L and the attitude as a turn more.
        """
        return jnp.zeros_like(angular_velocity)

    def start(
        self, rate: Real[ArrayLike, "..."], angular_velocity: Float64[Array, "*batch 3"]
    ) -> Float64[Array, "... {self.state_size}"]:
        """Return its own state (…, n) where it turns at a rate relative to the body.

        Args:
            rate: (…) about its axis, or (…, 3) along the body's axes [rad/s]; zero is at rest in the body.
            angular_velocity: Ω (…, 3) [rad/s, body axes].
        """
        return jnp.zeros((*angular_velocity.shape[:-1], self.state_size))


class Wheel(AbstractMount):
    """A rotor on an axis a fixed in the body, which turns freely, against friction, or by a motor.

    Its state is its whole axial momentum h = J (σ + a·Ω), with σ its rate relative to the body: ḣ = u − c σ, p = h a.
    Its energy is h²/2J, and the power between rotor and body (u − c σ) σ.

    Args:
        axis: (3,) a along the body's axes, normalised here.
        moment: J about its axis [kg m²], positive.
        motor: u, the torque of the motor on the rotor [N m]: a number, or a function (t, attitude, angular_velocity,
            rate) of the time (…) [s], the attitude (…, 4), Ω (…, 3) and σ (…), batched and written with ``jax.numpy``;
            None for no motor. A function needs states that have the attitude.
        friction: c of the bearing [N m s], not negative.
        jumps: (J,) times [s] at which the motor's torque jumps; see ``AbstractSystem.jumps``.

    Raises:
        InvalidInput: for an axis without direction, a moment that is not positive, a friction that is negative.

    Source: Hughes, *Spacecraft Attitude Dynamics* (1986), §3.4.

    >>> wheel, velocity = Wheel((0.0, 0.0, 2.0), moment=0.5, motor=0.25, friction=0.125), jnp.array([0.0, 0.0, 1.0])
    >>> own = wheel.start(rate=5.0, angular_velocity=velocity)
    >>> own.tolist(), wheel.state_rate(0.0, None, velocity, own).tolist()
    ([3.0], [-0.375])
    """

    axis: Float64[Array, "3"]
    moment: Float64[Array, ""]
    motor: Float64[Array, ""] | Motor | None
    friction: Float64[Array, ""] | None
    jump_times: Float64[Array, "jumps"]

    @known_numbers_only
    def __init__(
        self, axis: Real[ArrayLike, "3"], moment: float, motor: float | Motor | None = None, friction: float = 0.0,
        jumps: Real[ArrayLike, "jumps"] = (),
    ) -> None:  # fmt: skip
        self.axis, self.moment = checked_direction("axis", axis), checked_number("moment", moment, 0.0, unit="kg m²")
        self.motor = motor if motor is None or callable(motor) else checked_number("motor", motor, unit="N m")
        number = checked_number("friction", friction, least=0.0, unit="N m s")
        self.friction = number if float(number) else None
        self.jump_times = checked_jumps(jumps)

    @property
    def jumps(self) -> Float64[Array, "jumps"]:
        return self.jump_times

    @property
    def state_parts(self) -> tuple[StatePart, ...]:
        return (StatePart("rotor_momentum", 1, "kg m2 s-1", "whole momentum of the rotor along its axis"),)

    @property
    def needs_attitude(self) -> bool:
        return callable(self.motor)

    @property
    def inertia(self) -> Float64[Array, "3 3"]:
        return self.moment * jnp.outer(self.axis, jnp.asarray(self.axis))

    @property
    def names_all_jumps(self) -> bool:
        return not callable(self.motor)

    @property
    def conserves_energy(self) -> bool:
        return self.motor is None and self.friction is None

    @property
    def momentum_scale(self) -> Float64[Array, ""]:
        """The momentum that a constant motor gives the rotor in one turn."""
        if self.motor is None or callable(self.motor):
            return jnp.zeros(())
        return jnp.sqrt(jnp.abs(self.motor) * self.moment)

    def momentum(self, own: Float64[Array, "*batch {self.state_size}"]) -> Float64[Array, "*batch 3"]:
        return own * self.axis

    def energy(self, own: Float64[Array, "*batch {self.state_size}"]) -> Float64[Array, "*batch"]:
        return 0.5 * self.part(own, "rotor_momentum") ** 2 / self.moment

    def rate(
        self, angular_velocity: Float64[Array, "*#batch 3"], own: Float64[Array, "*#batch 1"]
    ) -> Float64[Array, "*batch"]:
        """Return σ (…) relative to the body [rad/s]."""
        return self.part(own, "rotor_momentum") / self.moment - jnp.sum(angular_velocity * self.axis, axis=-1)

    def axial_torque(
        self, t: Time, attitude: Attitude, angular_velocity: Velocity, own: Own
    ) -> Float64[Array, "*batch"]:
        """Return ḣ (…) [N m], the torque of motor and friction on the rotor."""
        rate, motor = self.rate(angular_velocity, own), self.motor
        if callable(motor):
            assert attitude is not None, "a motor by a function needs the attitude"
            motor = motor(t, attitude, angular_velocity, rate)
        torque = jnp.broadcast_to(0.0 if motor is None else motor, rate.shape)
        return torque if self.friction is None else torque - self.friction * rate

    def state_rate(
        self, t: Time, attitude: Attitude, angular_velocity: Velocity, own: Own
    ) -> Float64[Array, "*batch {self.state_size}"]:
        return self.axial_torque(t, attitude, angular_velocity, own)[..., None]

    def power(self, t: Time, attitude: Attitude, angular_velocity: Velocity, own: Own) -> Float64[Array, "*batch"]:
        # the torque works by ḣ ω on the rotor, at ω = σ + a·Ω in space, and by −ḣ a·Ω on the carrier
        return self.axial_torque(t, attitude, angular_velocity, own) * self.rate(angular_velocity, own)

    def start(
        self, rate: Real[ArrayLike, "..."], angular_velocity: Float64[Array, "*batch 3"]
    ) -> Float64[Array, "... {self.state_size}"]:
        return (self.moment * (rate + jnp.sum(angular_velocity * self.axis, axis=-1)))[..., None]


class HeldWheel(AbstractMount):
    """A rotor that its motor keeps at a constant rate σ relative to the body: p = J σ a, fixed in the body.

    It has no state of its own. Energy is counted without the motor's work, as in ``Gyrostat``, which is a body with
    held rotors alone.

    Args:
        axis: (3,) a along the body's axes, normalised here.
        moment: J about its axis [kg m²], positive.
        rate: σ [rad/s].

    Raises:
        InvalidInput: for an axis without direction, a moment that is not positive, a rate that is not finite.
    """

    axis: Float64[Array, "3"]
    moment: Float64[Array, ""]
    rate: Float64[Array, ""]

    @known_numbers_only
    def __init__(self, axis: Real[ArrayLike, "3"], moment: float, rate: float) -> None:
        self.axis, self.moment = checked_direction("axis", axis), checked_number("moment", moment, 0.0, unit="kg m²")
        self.rate = checked_number("rate", rate, unit="rad/s")

    @property
    def names_all_jumps(self) -> bool:
        return True

    def momentum(self, own: Float64[Array, "*batch {self.state_size}"]) -> Float64[Array, "*batch 3"]:
        return jnp.broadcast_to(self.moment * self.rate * self.axis, (*own.shape[:-1], 3))


class SphericalSlug(AbstractMount):
    """A ball in a viscous film inside the body, as of fuel: a damper that reaches its own speed and then rests.

    Its state is its whole momentum s = J ω along the body's axes: ṡ = s × Ω + c (Ω − ω). Power: −c |Ω − ω|².

    Args:
        moment: J of the ball about its centre [kg m²], positive.
        damping: c of the film [N m s], not negative.

    Raises:
        InvalidInput: for values out of range.

    Source: Rahn & Barba, J. Guid. Control Dyn. 14 (1991) 724.
    """

    moment: Float64[Array, ""]
    damping: Float64[Array, ""]

    @known_numbers_only
    def __init__(self, moment: float, damping: float) -> None:
        self.moment = checked_number("moment", moment, 0.0, unit="kg m²")
        self.damping = checked_number("damping", damping, least=0.0, unit="N m s")

    @property
    def state_parts(self) -> tuple[StatePart, ...]:
        return (StatePart("slug_momentum", 3, "kg m2 s-1", "whole angular momentum of the slug", "body"),)

    @property
    def inertia(self) -> Float64[Array, "3 3"]:
        return self.moment * jnp.eye(3)

    @property
    def conserves_energy(self) -> bool:
        return False

    @property
    def names_all_jumps(self) -> bool:
        return True

    def momentum(self, own: Float64[Array, "*batch {self.state_size}"]) -> Float64[Array, "*batch 3"]:
        return own

    def energy(self, own: Float64[Array, "*batch {self.state_size}"]) -> Float64[Array, "*batch"]:
        return 0.5 * jnp.sum(own**2, axis=-1) / self.moment

    def state_rate(
        self, t: Time, attitude: Attitude, angular_velocity: Velocity, own: Own
    ) -> Float64[Array, "*batch {self.state_size}"]:
        # ds/dt = c (Ω − ω) in space, seen from axes that turn with Ω: s × Ω more
        dragged = self.damping * (angular_velocity - own / self.moment)
        return jnp.cross(own, angular_velocity) + dragged

    def power(self, t: Time, attitude: Attitude, angular_velocity: Velocity, own: Own) -> Float64[Array, "*batch"]:
        # the couple c (Ω − ω) works on the ball by ·ω, on the body by −·Ω
        return -self.damping * jnp.sum((angular_velocity - own / self.moment) ** 2, axis=-1)

    def start(
        self, rate: Real[ArrayLike, "..."], angular_velocity: Float64[Array, "*batch 3"]
    ) -> Float64[Array, "... {self.state_size}"]:
        return self.moment * (rate + angular_velocity)


class EnergySink(AbstractMount):
    """Energy lost inside, with no moving part in the state: the body turns with Ω + α L × Ω.

    That is double-bracket dissipation, L̇ = L × Ω + α L × (L × Ω), which ``DoubleBracket`` has alone. The momentum stays
    in space, the energy falls by α |L × Ω|².

    Args:
        rate: α [s/(kg m²)], not negative.

    Raises:
        InvalidInput: for a rate that is negative or not finite.

    Source: Bloch, Krishnaprasad, Marsden & Ratiu, Commun. Math. Phys. 175 (1996) 1.
    """

    rate: Float64[Array, ""]

    @known_numbers_only
    def __init__(self, rate: float) -> None:
        refuse_single_precision(rate=rate)
        if not (np.ndim(rate) == 0 and np.isfinite(rate) and rate >= 0):
            raise InvalidInput(f"`rate` must be finite and not negative [s/(kg m²)]; got {shown(rate)}.")
        self.rate = jnp.asarray(float(rate))

    @property
    def conserves_energy(self) -> bool:
        return False

    @property
    def names_all_jumps(self) -> bool:
        return True

    def momentum(self, own: Float64[Array, "*batch {self.state_size}"]) -> Float64[Array, "*batch 3"]:
        return jnp.zeros((*own.shape[:-1], 3))

    def drift(
        self, momentum: Float64[Array, "*#batch 3"], angular_velocity: Float64[Array, "*#batch 3"]
    ) -> Float64[Array, "*batch 3"]:
        return self.rate * jnp.cross(momentum, angular_velocity)


def checked_direction(name: str, value: Real[ArrayLike, "3"]) -> Float64[Array, "3"]:
    """Return a unit vector along a direction of any length.

    Raises:
        InvalidInput: for what is not three finite numbers, or has no direction.
    """
    direction = np.asarray(checked_vector(name, value))
    if not (largest := np.abs(direction).max()) > 0:
        raise InvalidInput(f"`{name}` must be a direction (3,); got (0, 0, 0).")
    direction = np.ldexp(direction, -np.frexp(largest)[1])  # squares of extreme lengths overflow
    return jnp.asarray(direction / np.linalg.norm(direction))
