"""Derived quantities of a motion over time: rates, pointing error, wheels, torques and power."""

from __future__ import annotations

from dataclasses import replace
from typing import Any, NamedTuple

import jax
import jax.numpy as jnp
import numpy as np

from polhode import rotation
from polhode._base.arrays import compiled_for_few_calls
from polhode.motion._layout import Quantity
from polhode.motion._trajectory import Trajectory
from polhode.spacecraft.systems.control_laws import AbstractLawActuator
from polhode.spacecraft.systems.rigid_body import RigidBody
from polhode.spacecraft.systems.wheels import HeldWheel
from polhode.systems.kepler_orbit import KeplerOrbit
from polhode.types import Array, Float64

OBSERVED = {
    "wheel_rate": ("rates", Quantity("rad s-1", "rate of each wheel against the body")),
    "wheel_torque": ("motors", Quantity("N m", "torque of the motor of each wheel")),
    "torque_size": ("torques", Quantity("N m", "size of each torque about the centre of mass")),
    "pointing_error": ("pointing", Quantity("rad", "angle from the target")),
    "from_nadir": ("from_nadir", Quantity("rad", "angle of the given axes from those that look down")),
}
"""What a trajectory of a report has of a history: name in files → (attribute, what it is)."""


class History(NamedTuple):
    """Numbers at the samples of a motion, or of each of a batch, whose axis comes first.

    Attributes:
        velocity: Ω (T, 3) [rad/s, given axes].
        momentum: L (T, 3) of all [kg m²/s, given axes].
        stored: L − IΩ (T, 3) inside [kg m²/s, given axes].
        pointing: angle from the target (T,) [rad]; None without one.
        slew: angle of the body from the target (T,), from 0 to 2π [rad], counted on past half a turn; None
            without one.
        from_nadir: angle of the body's axes from those that look down (T,) [rad]; None without an orbit.
        rates: of the wheels against the body (T, wheels) [rad/s].
        motors: their torques (T, wheels) [N m], friction left out.
        torques: size of each torque from outside (T, torques) [N m], about the centre of mass.
        load: demand on actuators over their limits, at these samples or closer ones.
    """

    velocity: Float64[Array, "*batch time 3"]
    momentum: Float64[Array, "*batch time 3"]
    stored: Float64[Array, "*batch time 3"]
    pointing: Float64[Array, "*batch time"] | None
    slew: Float64[Array, "*batch time"] | None
    from_nadir: Float64[Array, "*batch time"] | None
    rates: Float64[Array, "*batch time wheels"]
    motors: Float64[Array, "*batch time wheels"]
    torques: Float64[Array, "*batch time torques"]
    load: Float64[Array, "*batch samples"]

    def thin(self, parts: int) -> History:
        """Return every ``parts``-th sample; ``load`` stays whole, as it counts between the samples too."""
        kept = {name: value for name, value in self._asdict().items() if value is not None}
        batch = (slice(None),) * (self.load.ndim - 1)
        return self._replace(**{name: value[(*batch, slice(None, None, parts))]
                                for name, value in kept.items() if name != "load"})  # fmt: skip

    def add_observed(self, trajectory: Trajectory) -> Trajectory:
        """Return the trajectory with this history's quantities as ``observed``, which files hold."""
        values = {name: getattr(self, where) for name, (where, _) in OBSERVED.items()}
        kept = {name: x for name, x in values.items() if x is not None and 0 not in np.shape(x)}
        quantities = {name: OBSERVED[name][1] for name in kept}
        return replace(trajectory, observed=kept, quantities=trajectory.quantities | quantities)

    @property
    def power(self) -> Float64[Array, "*batch time"]:
        """(…, T) mechanical power of all motors, none of it given back: Σ |u σ| [W]."""
        return np.sum(np.abs(self.rates * self.motors), axis=-1)


def follow(
    system: RigidBody, orbit: KeplerOrbit | None, times: Float64[Array, "time"], states: Float64[Array, "*batch time n"]
) -> History:
    """Return the history of a motion, or of those of a batch along one axis, of its samples."""
    values = (_follow if np.ndim(states) == 2 else _follow_many)(system, orbit, jnp.asarray(times), jnp.asarray(states))
    arrays: dict[str, Any] = {name: None if value is None else np.asarray(value) for name, value in values.items()}
    return History(**arrays)


@compiled_for_few_calls
def _follow_many(system: RigidBody, orbit: KeplerOrbit | None, times: Array, states: Array) -> dict[str, Any]:
    return jax.vmap(lambda one: _compute_history(system, orbit, times, one))(states)


@compiled_for_few_calls
def _follow(system: RigidBody, orbit: KeplerOrbit | None, times: Array, states: Array) -> dict[str, Any]:
    return _compute_history(system, orbit, times, states)


def _compute_history(system: RigidBody, orbit: KeplerOrbit | None, times: Array, states: Array) -> dict[str, Any]:
    # vectors along the principal axes are rotated here, with `structure`, once for all
    body = system.as_given(states)
    assert body.attitude is not None or not system.needs_attitude
    velocity = system.velocity(states)
    parts = (*system.mounts, *system.torques)
    law = next((part.law for part in parts if isinstance(part, AbstractLawActuator)), None)
    target = None if law is None else law.target(times)
    from_target = lambda aim: None if aim is None else rotation.angle_between(aim, body.attitude)  # noqa: E731
    pointing, nadir = from_target(target), from_target(None if orbit is None else orbit.frame(times))
    owned = list(zip(system.mounts, body.mounts, strict=True))
    rates = [mount.rotor_rates(velocity, own) for mount, own in owned]
    is_held = any(isinstance(mount, HeldWheel) for mount in system.mounts)  # else the acceleration is not needed
    acceleration = _acceleration(system, times, states) if is_held else jnp.zeros_like(velocity)
    motors = [
        mount.holding_torque(acceleration)[..., None] if isinstance(mount, HeldWheel)
        else mount.motor_torques(times, body.attitude, velocity, own) for mount, own in owned
    ]
    empty = jnp.zeros((*times.shape, 0))
    each = [jnp.linalg.norm(x, axis=-1)[..., None] for x in system.torques_apart(times, states)]
    return {
        "velocity": velocity, "momentum": body.momentum, "stored": system.stored(states), "pointing": pointing,
        "slew": None if target is None or body.attitude is None else _count_on(target, body.attitude),
        "from_nadir": nadir, "rates": jnp.concatenate([empty, *rates], axis=-1),
        "motors": jnp.concatenate([empty, *motors], axis=-1), "torques": jnp.concatenate([empty, *each], axis=-1),
        "load": system.load(times, states),
    }  # fmt: skip


def _count_on(target: Array, attitude: Array) -> Array:
    """Return the angle from a target, from 0 to 2π, of quaternions that go on without jumps of their signs."""
    same = jnp.sum(target * attitude, axis=-1)
    return 2.0 * jnp.arccos(jnp.clip(jnp.where(same[0] < 0.0, -same, same), -1.0, 1.0))


def _acceleration(system: RigidBody, times: Array, states: Array) -> Array:
    """Return Ω̇ (T, 3) [rad/s², given axes]."""
    change = jax.vmap(system.vector_field)(times, states)
    return jax.jvp(system.velocity, (states,), (change,))[1]
