"""Wheels in a rigid body: free, driven, with friction and limits, or held at a rate."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import equinox as eqx
import jax.numpy as jnp

from polhode._base.arrays import known_numbers_only
from polhode.motion._layout import StatePart
from polhode.spacecraft.systems.attachments import Attitude, Own, Time, Velocity, checked_jumps
from polhode.spacecraft.systems.mounts import AbstractMount
from polhode.systems._checks import checked_direction, checked_number
from polhode.types import Array, ArrayLike, Float64, Real, Self

Batch = Float64[Array, "*batch"]
Motor = Callable[[Batch, Float64[Array, "*batch 4"], Float64[Array, "*batch 3"], Batch], Batch]


class WheelLimits(NamedTuple):
    """Where a motor fades."""

    fading: float = 0.01  # of the largest rate, within which its torque falls to zero


LIMITS = WheelLimits()


class Wheel(AbstractMount):
    """A rotor on an axis a fixed in the body, which turns freely, against friction, or by a motor.

    Its state is its whole axial momentum h = J (σ + a·Ω), with σ its rate relative to the body: ḣ = u − f and p = h a,
    with the friction f = c σ + f₀ tanh(σ/σ₀). Its energy is h²/2J, and the power between rotor and body (u − f) σ.

    Limits are met without a jump: the motor's torque is cut off at ``max_torque``, and a torque that would speed the
    wheel up further fades to nothing over the last hundredth below ``max_rate``, as a motor's does near its no-load
    speed. Rates of change have corners there, at which steps end.

    Args:
        axis: (3,) a along the body's axes, normalised here.
        moment: J about its axis [kg m²], positive.
        motor: u, the torque of the motor on the rotor [N m]: a number, or a function (t, attitude, angular_velocity,
            rate) of the time (…) [s], the attitude (…, 4), Ω (…, 3) and σ (…), batched and written with ``jax.numpy``;
            None for no motor. A function needs states that have the attitude.
        friction: c of the bearing [N m s], not negative.
        coulomb_friction: f₀ [N m], not negative.
        sliding_rate: σ₀ [rad/s], positive, below which dry friction falls to zero smoothly.
        max_torque: the largest torque of the motor [N m], positive; None for no limit.
        max_rate: the largest |σ| to which the motor drives [rad/s], positive; None for no limit.
        jumps: (J,) times [s] at which the motor's torque jumps; see ``AbstractSystem.jumps``.

    Raises:
        InvalidInput: for an axis without direction, a moment that is not positive, a friction that is negative, or a
            limit that is not positive.

    Source: Hughes, *Spacecraft Attitude Dynamics* (1986), §3.4; of dry friction Andersson, Söderberg & Björklund,
    Tribol. Int. 40 (2007) 580.

    >>> wheel, velocity = Wheel((0.0, 0.0, 2.0), moment=0.5, motor=0.25, friction=0.125), jnp.array([0.0, 0.0, 1.0])
    >>> own = wheel.start(rate=5.0, angular_velocity=velocity)
    >>> own.tolist(), wheel.state_rate(0.0, None, velocity, own).tolist()
    ([3.0], [-0.375])
    """

    axis: Float64[Array, "3"]
    moment: Float64[Array, ""]
    motor: Float64[Array, ""] | Motor | None
    friction: Float64[Array, ""] | None
    coulomb_friction: Float64[Array, ""] | None
    sliding_rate: Float64[Array, ""]
    max_torque: Float64[Array, ""] | None
    max_rate: Float64[Array, ""] | None
    jump_times: Float64[Array, "jumps"]

    @known_numbers_only
    def __init__(
        self, axis: Real[ArrayLike, "3"], moment: float, motor: float | Motor | None = None, friction: float = 0.0,
        jumps: Real[ArrayLike, "jumps"] = (), coulomb_friction: float = 0.0, sliding_rate: float = 1.0,
        max_torque: float | None = None, max_rate: float | None = None,
    ) -> None:
        self.axis, self.moment = checked_direction("axis", axis), checked_number("moment", moment, 0.0, unit="kg m²")
        self.motor = motor if motor is None or callable(motor) else checked_number("motor", motor, unit="N m")
        number = checked_number("friction", friction, least=0.0, unit="N m s")
        self.friction = number if float(number) else None
        dry = checked_number("coulomb_friction", coulomb_friction, least=0.0, unit="N m")
        self.coulomb_friction = dry if float(dry) else None
        self.sliding_rate = checked_number("sliding_rate", sliding_rate, 0.0, unit="rad/s")
        self.max_torque = None if max_torque is None else checked_number("max_torque", max_torque, 0.0, unit="N m")
        self.max_rate = None if max_rate is None else checked_number("max_rate", max_rate, 0.0, unit="rad/s")
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
        return self.motor is None and self.friction is None and self.coulomb_friction is None

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

    def _asked(self, t: Time, attitude: Attitude, angular_velocity: Velocity, rate: Array) -> Array:
        motor = self.motor
        if callable(motor):
            assert attitude is not None, "a motor by a function needs the attitude"
            motor = motor(t, attitude, angular_velocity, rate)
        return jnp.broadcast_to(0.0 if motor is None else motor, rate.shape)

    def axial_torque(
        self, t: Time, attitude: Attitude, angular_velocity: Velocity, own: Own
    ) -> Float64[Array, "*batch"]:
        """Return ḣ (…) [N m], the torque of motor and friction on the rotor."""
        rate = self.rate(angular_velocity, own)
        torque = self.motor_torques(t, attitude, angular_velocity, own)[..., 0]
        if self.friction is not None:
            torque = torque - self.friction * rate
        if self.coulomb_friction is not None:
            torque = torque - self.coulomb_friction * jnp.tanh(rate / self.sliding_rate)
        return torque

    def rotor_rates(
        self, angular_velocity: Float64[Array, "*#batch 3"], own: Float64[Array, "*#batch 1"]
    ) -> Float64[Array, "*batch 1"]:
        return self.rate(angular_velocity, own)[..., None]

    def motor_torques(
        self, t: Time, attitude: Attitude, angular_velocity: Velocity, own: Own
    ) -> Float64[Array, "*batch 1"]:
        rate = self.rate(angular_velocity, own)
        return self._limited(self._asked(t, attitude, angular_velocity, rate), rate)[..., None]

    @property
    def limited(self) -> bool:
        return self.max_torque is not None or self.max_rate is not None

    def without_limits(self) -> Self:
        limits = lambda wheel: (wheel.max_torque, wheel.max_rate)  # noqa: E731
        return eqx.tree_at(limits, self, (None, None), is_leaf=lambda x: x is None)

    def load(
        self, t: Time, attitude: Attitude, angular_velocity: Velocity, own: Own, stored: Velocity
    ) -> Float64[Array, "*batch"]:
        rate = self.rate(angular_velocity, own)
        largest = jnp.zeros(rate.shape)
        if self.max_torque is not None:
            largest = jnp.abs(self._asked(t, attitude, angular_velocity, rate)) / self.max_torque
        if self.max_rate is not None:
            largest = jnp.maximum(largest, jnp.abs(rate) / ((1.0 - LIMITS.fading) * self.max_rate))
        return largest

    def _limited(self, torque: Array, rate: Array) -> Array:
        """Return the delivered torque (…) [N m] for a commanded one, after limits and friction."""
        if self.max_torque is not None:
            torque = jnp.clip(torque, -self.max_torque, self.max_torque)
        if self.max_rate is None:
            return torque
        up = jnp.clip((self.max_rate - rate) / (LIMITS.fading * self.max_rate), 0.0, 1.0)
        down = jnp.clip((self.max_rate + rate) / (LIMITS.fading * self.max_rate), 0.0, 1.0)
        return jnp.maximum(torque, 0.0) * up + jnp.minimum(torque, 0.0) * down

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

    def rotor_rates(
        self, angular_velocity: Float64[Array, "*#batch 3"], own: Float64[Array, "*#batch {self.state_size}"]
    ) -> Float64[Array, "*batch 1"]:
        shape = jnp.broadcast_shapes(angular_velocity.shape[:-1], own.shape[:-1])
        return jnp.broadcast_to(self.rate, (*shape, 1))

    def holding_torque(self, acceleration: Float64[Array, "*batch 3"]) -> Float64[Array, "*batch"]:
        """Return the torque of the motor on the rotor (…) [N m], J a·Ω̇, at accelerations Ω̇ (…, 3) of the body."""
        return self.moment * (acceleration @ self.axis)
