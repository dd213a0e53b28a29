"""Vectors of a body with mounts and torques along its given axes, and the limits of its actuators."""

from __future__ import annotations

import abc
from itertools import chain
from typing import Any

import equinox as eqx
import jax.numpy as jnp

from polhode.spacecraft.systems._moving_masses import momenta
from polhode.spacecraft.systems._packed_body import AbstractPackedBody, BodyState
from polhode.spacecraft.systems.attachments import Time
from polhode.systems._symmetric import times
from polhode.types import Array, Float64, Self

States = Float64[Array, "*#batch n"]


class AbstractObservedBody(AbstractPackedBody):
    """A body with its vectors along the given axes, whose actuators may have limits."""

    @abc.abstractmethod
    def _moment(self, body: BodyState) -> Any:
        """Return the velocities of a state along the given axes."""

    @abc.abstractmethod
    def _momentary_inertia(self, now: Any) -> Array:
        """Return the inertia (…, 3, 3), parts that turn by themselves included."""

    @abc.abstractmethod
    def _torques_apart(self, t: Array, now: Any) -> list[tuple[Array, list[Array]]]:
        """Return each torque about the centre of mass (…, 3), and the generalised force along the q of moving parts."""

    def as_given(self, state: States) -> BodyState:
        """Return a packed state taken apart, attitude and momentum along the given axes."""
        return self._as_given(self.parts(state))

    def velocity(self, state: States) -> Float64[Array, "*batch 3"]:
        """Return Ω (…, 3) [rad/s, given axes]."""
        return self._moment(self.as_given(state)).velocity

    def stored(self, state: States) -> Float64[Array, "*batch 3"]:
        """Return L − IΩ (…, 3), the momentum of parts that turn or move against the body [kg m²/s, given axes]."""
        return self._stored(self._moment(self.as_given(state)))

    def packed_as_given(
        self, attitude: Float64[Array, "*#batch 4"], velocity: Float64[Array, "*#batch 3"], state: States
    ) -> Float64[Array, "*batch n"]:
        """Return states with another attitude and Ω, along the given axes, whose mounts and torques are as they were.

        Moving parts keep q and π.
        """
        own = self.parts(state)
        arrangement = self._arranged(own.mounts)
        if arrangement is None:
            momentum = times(self.carrier, velocity)
        else:
            rates = self._moment(self._as_given(own)).rates
            momentum, _ = momenta(arrangement, velocity, rates)
        for mount, values in zip(self.mounts, own.mounts, strict=True):
            momentum = momentum + mount.momentum(values)
        if self.structure is not None:
            attitude = self.structure.turn.attitude(attitude)
        return jnp.concatenate([attitude, self._along_principal(momentum), *own.mounts, *own.torques], axis=-1)

    def torques_apart(self, t: Time, state: States) -> list[Float64[Array, "..."]]:
        """Return each torque about the centre of mass (…, 3) [N m, given axes], in the order of ``torques``."""
        return [torque for torque, _ in self._torques_apart(jnp.asarray(t), self._moment(self.as_given(state)))]

    def _stored(self, now: Any) -> Array:
        turning = jnp.sum(self._momentary_inertia(now) * now.velocity[..., None, :], axis=-1)
        return now.body.momentum - turning

    # ------------------------------------------------------------------ limits

    @property
    def limited(self) -> bool:
        """Whether a mount or a torque has limits."""
        return any(attachment.limited for attachment in chain(self.mounts, self.torques))

    def without_limits(self) -> Self:
        """Return this body with actuators without limits.

        Where ``load`` stays below one along its motion, that is the motion of the limited body too, and rates of change
        have no corners.
        """
        mounts = tuple(mount.without_limits() for mount in self.mounts)
        torques = tuple(torque.without_limits() for torque in self.torques)
        return eqx.tree_at(lambda body: (body.mounts, body.torques), self, (mounts, torques))

    def load(self, t: Time, state: States) -> Float64[Array, "*batch"]:
        """Return the largest demand on an actuator over its limit (…); above one a limit acts."""
        now, t = self._moment(self.as_given(state)), jnp.asarray(t)
        body, stored, largest = now.body, self._stored(now), jnp.zeros(now.velocity.shape[:-1])
        for attachment, own in zip((*self.mounts, *self.torques), (*body.mounts, *body.torques), strict=True):
            largest = jnp.maximum(largest, attachment.load(t, body.attitude, now.velocity, own, stored))
        return largest
