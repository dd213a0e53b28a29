"""Reaction wheels under a control law, with the torque shared out among them, and limits."""

from __future__ import annotations

from typing import Any, NamedTuple

import equinox as eqx
import jax.numpy as jnp
import numpy as np

from polhode._base.arrays import known_numbers_only
from polhode.errors import InvalidInput
from polhode.motion._layout import StatePart
from polhode.spacecraft.systems.attachments import Attitude, Own, Time, Velocity
from polhode.spacecraft.systems.control_laws import AbstractControlLaw, AbstractLawActuator, checked_law
from polhode.spacecraft.systems.mounts import AbstractMount
from polhode.spacecraft.torques.base import AbstractTorque
from polhode.systems._checks import checked_directions, checked_numbers
from polhode.types import Array, ArrayLike, Float64, Real, Self


class ControlledWheelLimits(NamedTuple):
    """Where motors fade, and which directions wheels reach."""

    taper: float = 0.02  # of the largest rate: the part below it over which a motor's torque falls to zero
    min_singular_value: float = 1e-9  # of the largest, above which wheels give a torque along a direction


LIMITS = ControlledWheelLimits()


class ControlledWheels(AbstractLawActuator, AbstractMount):
    """Wheels whose motors together give the body the torque that a law commands.

    The body is to have τ, so the motors have to give the rotors −τ: u = −A⁺ τ with the wheels' axes as columns of A and
    A⁺ its pseudo-inverse, which takes the least sum of squares. One wheel, or two, turn the body about their own axes
    alone, as on a satellite with a bias of momentum: a command across them is not delivered. Each motor gives at
    most ``max_torque``. Towards higher rates its torque falls to zero over the last fiftieth below ``max_rate``, which
    no motor exceeds; the body, as it turns under a rotor whose motor gives nothing, may carry σ = h/J − a·Ω past it.

    The state is the whole axial momentum h (wheels,) of each, as of a ``Wheel``, and then that of the law.

    Args:
        axes: (wheels, 3) [body axes], normalised here.
        moments: J of each about its axis [kg m²], one for all or (wheels,), positive.
        law: of control.
        max_torque: of each motor [N m], one for all or (wheels,); None for no limit.
        max_rate: of each rotor against the body [rad/s], likewise; it needs ``max_torque``.
        friction: c of each bearing [N m s], likewise, not negative.

    Raises:
        InvalidInput: for wheels that do not fit each other.

    Source: Markley & Crassidis (2014), §7.3.4; Hughes, *Spacecraft Attitude Dynamics* (1986), §3.4.
    """

    axes: Float64[Array, "wheels 3"]
    moments: Float64[Array, "wheels"]
    law: AbstractControlLaw
    max_torque: Float64[Array, "*wheels"] | None
    max_rate: Float64[Array, "*wheels"] | None
    friction: Float64[Array, "wheels"]
    shares: Float64[Array, "wheels 3"]

    @known_numbers_only
    def __init__(
        self, axes: Real[ArrayLike, "wheels 3"], moments: Real[ArrayLike, "*wheels"], law: Any,
        max_torque: Real[ArrayLike, "*wheels"] | None = None, max_rate: Real[ArrayLike, "*wheels"] | None = None,
        friction: Real[ArrayLike, "*wheels"] = 0.0,
    ) -> None:
        self.axes, self.law = checked_directions("axes", axes), checked_law(law)
        count = len(self.axes)
        self.moments = jnp.broadcast_to(checked_numbers("moments", moments, count, 0.0, unit="kg m²"), count)
        limits = {"max_torque": (max_torque, "N m"), "max_rate": (max_rate, "rad/s")}
        self.max_torque, self.max_rate = (
            None if limit is None else checked_numbers(name, limit, count, above=0.0, unit=unit)
            for name, (limit, unit) in limits.items()
        )
        if max_rate is not None and max_torque is None:
            raise InvalidInput("`max_rate` needs `max_torque`, the torque that falls to zero towards it.")
        resistance = checked_numbers("friction", friction, count, least=0.0, unit="N m s")
        self.friction = jnp.broadcast_to(resistance, count)
        matrix = np.asarray(self.axes)
        # A⁺, with the axes as columns of A
        self.shares = jnp.asarray(np.linalg.pinv(matrix, rcond=LIMITS.min_singular_value))

    @property
    def state_parts(self) -> tuple[StatePart, ...]:
        wheels = StatePart("wheel_momentum", len(self.axes), "kg m2 s-1", "whole momentum of each wheel along its axis")
        return (wheels, *self.law.state_parts)

    @property
    def inertia(self) -> Float64[Array, "3 3"]:
        return (self.axes * self.moments[:, None]).T @ self.axes

    @property
    def conserves_energy(self) -> bool:
        return False

    def _momenta(self, own: Array) -> Array:
        return own[..., : len(self.axes)]

    def momentum(self, own: Float64[Array, "*batch {self.state_size}"]) -> Float64[Array, "*batch 3"]:
        return self._momenta(own) @ self.axes

    def energy(self, own: Float64[Array, "*batch {self.state_size}"]) -> Float64[Array, "*batch"]:
        return 0.5 * jnp.sum(self._momenta(own) ** 2 / self.moments, axis=-1)

    def rotor_rates(
        self, angular_velocity: Float64[Array, "*#batch 3"], own: Float64[Array, "*#batch {self.state_size}"]
    ) -> Float64[Array, "*batch wheels"]:
        return self._momenta(own) / self.moments - angular_velocity @ self.axes.T

    def commanded(
        self, t: Time, attitude: Attitude, angular_velocity: Velocity, own: Own
    ) -> Float64[Array, "*batch wheels"]:
        """Return the commanded torque of each motor (…, wheels) [N m], without limits."""
        wanted = self.law.wanted(t, attitude, angular_velocity, own[..., len(self.axes) :])
        return -wanted @ self.shares

    @property
    def reached(self) -> Float64[Array, "3 3"]:
        return self.shares @ self.axes

    def motor_torques(
        self, t: Time, attitude: Attitude, angular_velocity: Velocity, own: Own
    ) -> Float64[Array, "*batch wheels"]:
        asked = self.commanded(t, attitude, angular_velocity, own)
        if self.max_torque is None:
            return asked
        least, most = -self.max_torque, self.max_torque
        if self.max_rate is not None:
            room = self.rotor_rates(angular_velocity, own) / self.max_rate
            most = most * jnp.clip((1.0 - room) / LIMITS.taper, 0.0, 1.0)
            least = least * jnp.clip((1.0 + room) / LIMITS.taper, 0.0, 1.0)
        return jnp.clip(asked, least, most)

    def state_rate(
        self, t: Time, attitude: Attitude, angular_velocity: Velocity, own: Own
    ) -> Float64[Array, "*batch {self.state_size}"]:
        turning = self._on_rotors(t, attitude, angular_velocity, own)
        law = self.law.state_rate(t, attitude, angular_velocity, own[..., len(self.axes) :])
        return jnp.concatenate([turning, law], axis=-1)

    def _on_rotors(self, t: Time, attitude: Attitude, angular_velocity: Velocity, own: Own) -> Array:
        dragged = self.friction * self.rotor_rates(angular_velocity, own)
        return self.motor_torques(t, attitude, angular_velocity, own) - dragged

    def power(self, t: Time, attitude: Attitude, angular_velocity: Velocity, own: Own) -> Float64[Array, "*batch"]:
        # each torque works by ω = σ + a·Ω on its rotor and by −a·Ω on the body
        torques = self._on_rotors(t, attitude, angular_velocity, own)
        return jnp.sum(torques * self.rotor_rates(angular_velocity, own), axis=-1)

    def start(
        self, rate: Real[ArrayLike, "..."], angular_velocity: Float64[Array, "*batch 3"]
    ) -> Float64[Array, "... {self.state_size}"]:
        momenta = self.moments * (rate + angular_velocity @ self.axes.T)
        law = jnp.zeros((*momenta.shape[:-1], self.law.state_size))
        return jnp.concatenate([momenta, law], axis=-1)

    @property
    def limited(self) -> bool:
        return self.max_torque is not None

    def load(
        self, t: Time, attitude: Attitude, angular_velocity: Velocity, own: Own, stored: Velocity
    ) -> Float64[Array, "*batch"]:
        if self.max_torque is None:
            return jnp.zeros(angular_velocity.shape[:-1])
        asked = jnp.abs(self.commanded(t, attitude, angular_velocity, own)) / self.max_torque
        if self.max_rate is not None:
            fast = jnp.abs(self.rotor_rates(angular_velocity, own)) / ((1.0 - LIMITS.taper) * self.max_rate)
            asked = jnp.maximum(asked, fast)
        return jnp.max(asked, axis=-1)

    def without_limits(self) -> Self:
        limits = lambda wheels: (wheels.max_torque, wheels.max_rate)  # noqa: E731
        return eqx.tree_at(limits, self, (None, None), is_leaf=lambda x: x is None)


class ControlTorque(AbstractLawActuator, AbstractTorque):
    """A couple from outside that a law commands, as thrusters give on the average, up to a limit about each axis.

    Args:
        law: of control.
        limit: largest torque about each of the body's axes [N m], one for all or (3,); None for no limit.

    Raises:
        InvalidInput: for anything but a law, or a limit that is not positive.
    """

    law: AbstractControlLaw
    limit: Float64[Array, "*axes"] | None

    @known_numbers_only
    def __init__(self, law: Any, limit: Real[ArrayLike, "*axes"] | None = None) -> None:
        self.law = checked_law(law)
        self.limit = None if limit is None else checked_numbers("limit", limit, 3, above=0.0, unit="N m")

    @property
    def state_parts(self) -> tuple[StatePart, ...]:
        return self.law.state_parts

    def state_rate(
        self, t: Time, attitude: Attitude, angular_velocity: Velocity, actuator: Own
    ) -> Float64[Array, "*batch {self.state_size}"]:
        return self.law.state_rate(t, attitude, angular_velocity, actuator)

    def torque(
        self, t: Time, attitude: Attitude, angular_velocity: Velocity, actuator: Own | None = None
    ) -> Float64[Array, "*batch 3"]:
        own = jnp.zeros((*angular_velocity.shape[:-1], 0)) if actuator is None else actuator
        wanted = self.law.wanted(t, attitude, angular_velocity, own)
        return wanted if self.limit is None else jnp.clip(wanted, -self.limit, self.limit)

    @property
    def limited(self) -> bool:
        return self.limit is not None

    def load(
        self, t: Time, attitude: Attitude, angular_velocity: Velocity, own: Own, stored: Velocity
    ) -> Float64[Array, "*batch"]:
        if self.limit is None:
            return jnp.zeros(angular_velocity.shape[:-1])
        return jnp.max(jnp.abs(self.law.wanted(t, attitude, angular_velocity, own)) / self.limit, axis=-1)

    def without_limits(self) -> Self:
        return eqx.tree_at(lambda torque: torque.limit, self, None, is_leaf=lambda x: x is None)
