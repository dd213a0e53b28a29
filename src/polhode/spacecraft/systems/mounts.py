"""Mounts inside a rigid body: their base classes, a slug of fuel, and losses without moving parts of their own."""

from __future__ import annotations

import abc
from collections.abc import Mapping
from typing import Any, ClassVar

import jax.numpy as jnp

from polhode._base.arrays import known_numbers_only
from polhode.motion._layout import StatePart
from polhode.spacecraft.systems.attachments import AbstractAttachment, Argument, Attitude, Own, Time, Velocity
from polhode.systems._checks import checked_number
from polhode.types import Array, ArrayLike, Float64, Real


class AbstractMounted(AbstractAttachment):
    """A part inside a body with momentum and energy of its own: a mount, or a part that moves its mass."""

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

    def start_of(self, values: Mapping[str, Any]) -> tuple[Any, Any]:
        """Return rates and coordinates as ``pack`` takes them, from the table of a spec, in SI; None for rest."""
        return None, None

    def rotor_rates(
        self, angular_velocity: Float64[Array, "*#batch 3"], own: Float64[Array, "*#batch {self.state_size}"]
    ) -> Float64[Array, "*batch rotors"]:
        """Return the rates of its rotors against the body (…, rotors) [rad/s]; no rotors by default."""
        return jnp.zeros((*jnp.broadcast_shapes(angular_velocity.shape[:-1], own.shape[:-1]), 0))

    def motor_torques(
        self, t: Time, attitude: Attitude, angular_velocity: Velocity, own: Own
    ) -> Float64[Array, "*batch rotors"]:
        """Return the torque of each motor on its rotor (…, rotors) [N m], within its limits and without friction."""
        return jnp.zeros_like(self.rotor_rates(angular_velocity, own))


class AbstractMount(AbstractMounted):
    """A part that turns inside a body without moving its mass, as a rotor does.

    A mount brings its own angular momentum p. The whole body's is L = K Ω + Σ p, where K is the inertia of the body
    with all mounts locked, less the ``inertia`` that each mount turns by itself. The mount's reaction on the carrier is
    in that sum: L changes by outer torques alone, so that the carrier loses the momentum that a rotor gains. The energy
    is ½ Ω·KΩ + Σ ``energy``, and changes inside by the sum of ``power``.

    A new mount gives ``momentum`` and, where it has a state of its own, ``state_parts``, ``state_rate``, ``start``,
    ``inertia``, ``energy`` and ``power``. Where energy and power disagree, the drift of the energy says so. A part that
    moves its mass is an ``AbstractMovingPart``.
    """

    @abc.abstractmethod
    def momentum(self, own: Float64[Array, "*batch {self.state_size}"]) -> Float64[Array, "*batch 3"]:
        """Return p (…, 3) [kg m²/s, body axes]."""

    def state_rate(
        self, t: Time, attitude: Attitude, angular_velocity: Velocity, own: Own
    ) -> Float64[Array, "*batch {self.state_size}"]:
        """Return the rate of its own state (…, n); zero by default."""
        return jnp.zeros_like(own)

    def power(self, t: Time, attitude: Attitude, angular_velocity: Velocity, own: Own) -> Float64[Array, "*batch"]:
        """Return the power (…) [W] of the forces between mount and carrier; negative where energy is lost."""
        return jnp.zeros(angular_velocity.shape[:-1])

    def drift(
        self, momentum: Float64[Array, "*#batch 3"], angular_velocity: Float64[Array, "*#batch 3"]
    ) -> Float64[Array, "*batch 3"]:
        """Return the angular velocity of the body beyond Ω (…, 3) [rad/s, body axes].

        Zero but for losses that have no state of their own: they act on L and the attitude as an additional turn.
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

    name: ClassVar[str] = "slug"
    arguments: ClassVar[dict[str, Argument]] = {
        "moment": Argument("kg*m^2"),
        "damping": Argument("N*m*s"),
    }
    start_arguments: ClassVar[dict[str, Argument]] = {"angular_velocity": Argument("rad/s", (3,))}

    moment: Float64[Array, ""]
    damping: Float64[Array, ""]

    @known_numbers_only
    def __init__(self, moment: float, damping: float) -> None:
        self.moment = checked_number("moment", moment, 0.0, unit="kg m²")
        self.damping = checked_number("damping", damping, least=0.0, unit="N m s")

    @property
    def state_parts(self) -> tuple[StatePart, ...]:
        return (StatePart("slug_momentum", 3, "kg m2 s-1", "whole angular momentum of the slug", "given"),)

    @property
    def inertia(self) -> Float64[Array, "3 3"]:
        return self.moment * jnp.eye(3)

    @property
    def names_all_jumps(self) -> bool:
        return True

    @property
    def conserves_energy(self) -> bool:
        return False

    def momentum(self, own: Float64[Array, "*batch {self.state_size}"]) -> Float64[Array, "*batch 3"]:
        return own

    def energy(self, own: Float64[Array, "*batch {self.state_size}"]) -> Float64[Array, "*batch"]:
        return 0.5 * jnp.sum(own**2, axis=-1) / self.moment

    def state_rate(
        self, t: Time, attitude: Attitude, angular_velocity: Velocity, own: Own
    ) -> Float64[Array, "*batch {self.state_size}"]:
        # ds/dt = c (Ω − ω) in space, in axes that turn with Ω: s × Ω more
        dragged = self.damping * (angular_velocity - own / self.moment)
        return jnp.cross(own, angular_velocity) + dragged

    def power(self, t: Time, attitude: Attitude, angular_velocity: Velocity, own: Own) -> Float64[Array, "*batch"]:
        # the couple c (Ω − ω) works on the ball by ·ω, on the body by −·Ω
        return -self.damping * jnp.sum((angular_velocity - own / self.moment) ** 2, axis=-1)

    def start(
        self, rate: Real[ArrayLike, "..."], angular_velocity: Float64[Array, "*batch 3"]
    ) -> Float64[Array, "... {self.state_size}"]:
        return self.moment * (rate + angular_velocity)

    def start_of(self, values: Mapping[str, Any]) -> tuple[Any, Any]:
        return values.get("angular_velocity"), None


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

    name: ClassVar[str] = "energy-sink"
    arguments: ClassVar[dict[str, Argument]] = {
        "rate": Argument("s/(kg*m^2)"),
    }

    rate: Float64[Array, ""]

    @known_numbers_only
    def __init__(self, rate: float) -> None:
        self.rate = checked_number("rate", rate, least=0.0, unit="s/(kg m²)")

    @property
    def names_all_jumps(self) -> bool:
        return True

    @property
    def conserves_energy(self) -> bool:
        return False

    def momentum(self, own: Float64[Array, "*batch {self.state_size}"]) -> Float64[Array, "*batch 3"]:
        return jnp.zeros((*own.shape[:-1], 3))

    def drift(
        self, momentum: Float64[Array, "*#batch 3"], angular_velocity: Float64[Array, "*#batch 3"]
    ) -> Float64[Array, "*batch 3"]:
        return self.rate * jnp.cross(momentum, angular_velocity)
