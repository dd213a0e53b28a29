"""The base class of torques on a body."""

from __future__ import annotations

import abc
from typing import Any

import jax.numpy as jnp

from polhode import rotation
from polhode.motion.frame import BodyFrame
from polhode.spacecraft.systems.attachments import (
    AbstractAttachment,
    Attitude,
    Own,
    Time,
    Velocity,
    checked_attachments,
)
from polhode.types import Array, Float64

NEEDED = "a torque is given the attitude and the state that it says it needs"


class AbstractTorque(AbstractAttachment):
    """An external torque on a body; it may have a state of its own, as an actuator has.

    Its power τ·Ω enters the balance of the energy.

    A spec names it by the ``type`` of a ``[[torque]]``; that of another package registers its class in the entry-point
    group ``polhode.torques``.
    """

    def state_rate(
        self, t: Time, attitude: Attitude, angular_velocity: Velocity, actuator: Own
    ) -> Float64[Array, "*batch {self.state_size}"]:
        """Return the rate of its own state (…, n); zero by default."""
        return jnp.zeros_like(actuator)

    @property
    def rate(self) -> Float64[Array, ""]:
        """The angular velocity [rad/s] that it causes from rest; zero if it causes none."""
        return jnp.zeros(())

    @property
    def needs_stored(self) -> bool:
        """Whether it depends on the momentum stored inside, and ``torque`` takes it as ``stored``."""
        return False

    def remark(self, times: Float64[Array, "time"]) -> str:
        """Return a report's remark on it at times [s], as the predicate of a sentence; None by default."""
        return ""

    def force(
        self, t: Time, attitude: Attitude, angular_velocity: Velocity, actuator: Own | None = None
    ) -> Float64[Array, "*batch 3"] | None:
        """Return the resultant force on the body (…, 3) [N, body axes]; None for a couple."""
        return None

    @abc.abstractmethod
    def torque(
        self, t: Time, attitude: Attitude, angular_velocity: Velocity, actuator: Own | None = None
    ) -> Float64[Array, "*batch 3"]:
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


class AbstractEnvironmentTorque(AbstractTorque):
    """A torque by what surrounds the body: it depends on the attitude, and never jumps."""

    @property
    def names_all_jumps(self) -> bool:
        return True

    @property
    def needs_attitude(self) -> bool:
        return True


def torque_of(
    torque: AbstractTorque, t: Time, attitude: Attitude, angular_velocity: Velocity, own: Float64[Array, "*batch n"],
    stored: Velocity,
) -> Float64[Array, "*batch 3"]:
    """Return τ (…, 3) of a torque, with the momentum ``stored`` inside, L − IΩ (…, 3), where it asks for that."""
    if not torque.needs_stored:
        return torque.torque(t, attitude, angular_velocity, own)
    asks_more: Any = torque
    return asks_more.torque(t, attitude, angular_velocity, own, stored=stored)


def _try_torque(torque: AbstractTorque, t: Array, attitude: Array, velocity: Array, own: Array) -> dict[str, Any]:
    results = {
        "torque": (torque_of(torque, t, attitude, velocity, own, velocity), (3,)),
        "state_rate": (torque.state_rate(t, attitude, velocity, own), (torque.state_size,)),
    }
    force = torque.force(t, attitude, velocity, own)
    return results if force is None else results | {"force": (force, (3,))}


def checked_torques(torques: Any, frame: BodyFrame) -> tuple[AbstractTorque, ...]:
    """Return a list of torques on a body.

    Raises:
        InvalidInput: for anything else, one whose methods fail, and a gravity gradient on other moments.
    """
    return checked_attachments("torques", torques, (AbstractTorque,), frame, _try_torque)


def in_body(
    attitude: Float64[Array, "*#batch 4"], direction: Float64[Array, "*#batch 3"]
) -> Float64[Array, "*batch 3"]:
    """Return vectors (…, 3) of space along the body's axes."""
    return rotation.rotate(rotation.conjugate(attitude), direction)
