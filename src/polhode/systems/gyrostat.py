"""Gyrostats: a body with a rotor inside."""

from __future__ import annotations

from typing import Any, ClassVar

import jax.numpy as jnp
import numpy as np

from polhode import rotation
from polhode.algebra.base import AbstractLieAlgebra
from polhode.algebra.so3 import SO3
from polhode.arrays import known_numbers_only, refuse_single_precision
from polhode.errors import InvalidInput, shown
from polhode.motion.layout import ATTITUDE, MOMENTUM, StateLayout, StatePart
from polhode.systems.base import (
    AbstractLiePoissonSystem,
    AbstractSystem,
    Balance,
    Flow,
    Vectors,
    as_finite_state,
    check_unit_attitude,
)
from polhode.systems.free_rigid_body import axis_flow, checked_moments

Array = Any
DRIVEN = StateLayout((
    ATTITUDE, MOMENTUM, StatePart("rotor_momentum", 1, "kg m2 s-1", "whole momentum of the rotor along its axis"),
))  # fmt: skip


class Gyrostat(AbstractLiePoissonSystem):
    """Π̇ = Π × Ω, Ω = I⁻¹(Π − h) on so(3)*, with the rotor's momentum h fixed in the body; H = ½ (Π − h)·I⁻¹(Π − h).

    Π is the whole angular momentum. Two rotors are meant. One driven at a constant rate relative to the body: h is its
    momentum relative to the body, I the moments of body and rotor together. One that turns freely, or whose motor only
    makes up for friction: h is its whole axial momentum, which then stays, and I the moments less the rotor's axial
    one along its axis. Energy is that of the carrier, which is kept in either case. State Π (…, 3), or with the
    attitude (…, 7). Flows: rotation about each axis.

    Args:
        moments: (3,) principal moments I [kg m²], positive.
        rotor: (3,) h [kg m²/s, principal axes].

    Raises:
        InvalidInput: for moments that are not positive, or a rotor that is not three finite numbers.

    Source: Zhukovskii 1885; Volterra, Acta Math. 22 (1899) 201; Hughes, *Spacecraft Attitude Dynamics*, §3.4.
    """

    title: ClassVar[str] = "Gyrostat"
    algebra: AbstractLieAlgebra
    moments: Array
    rotor: Array

    @known_numbers_only
    def __init__(self, moments: Array, rotor: Array) -> None:
        self.algebra, self.moments, self.rotor = SO3(), checked_moments(moments), _vector("rotor", rotor)

    def energy(self, point: Array) -> Array:
        return 0.5 * jnp.sum((point - self.rotor) ** 2 / self.moments, axis=-1)

    def velocity(self, point: Array) -> Array:
        return (point - self.rotor) / self.moments

    @property
    def flows(self) -> dict[str, Flow]:
        return {f"rotation about axis {k + 1}": axis_flow(self.moments, k, self.rotor[k]) for k in range(3)}


class TorquedGyrostat(AbstractSystem):
    """A gyrostat whose motor turns the rotor with a constant torque u: Π̇ = Π × Ω, ḣ = u, Ω = I⁻¹(Π − h a).

    h is the rotor's whole momentum along its axis a, I the moments less the rotor's axial one along a: the spin-up and
    dual-spin turn of spacecraft. Without torque it is ``Gyrostat``. The energy ½ (Π − ha)·I⁻¹(Π − ha) + h²/2J receives
    the motor's power u (h/J − Ω·a). State (attitude, Π, h) (…, 8).

    Args:
        moments: (3,) I [kg m²].
        axis: (3,) a along the principal axes, normalised here.
        rotor_moment: J of the rotor about its axis [kg m²], positive.
        torque: u of the motor on the rotor [N m].

    Raises:
        InvalidInput: for values that are not positive, or not finite.

    Source: Hughes, *Spacecraft Attitude Dynamics*, §3.4 and ch. 6; Hall & Rand, J. Guid. Control Dyn. 17 (1994) 30.
    """

    title: ClassVar[str] = "Gyrostat with a driven rotor"
    moments: Array
    axis: Array
    rotor_moment: Array
    torque: Array

    @known_numbers_only
    def __init__(self, moments: Array, axis: Array, rotor_moment: float, torque: float) -> None:
        direction = np.asarray(_vector("axis", axis))
        if not (largest := np.abs(direction).max()) > 0:
            raise InvalidInput("`axis` must be a direction (3,); got (0, 0, 0).")
        refuse_single_precision(rotor_moment=rotor_moment, torque=torque)
        if not (np.ndim(rotor_moment) == 0 and np.isfinite(rotor_moment) and rotor_moment > 0):
            raise InvalidInput(f"`rotor_moment` must be positive and finite [kg m²]; got {shown(rotor_moment)}.")
        if not (np.ndim(torque) == 0 and np.isfinite(torque)):
            raise InvalidInput(f"`torque` must be one finite number [N m]; got {shown(torque)}.")
        direction = np.ldexp(direction, -np.frexp(largest)[1])  # squares of extreme lengths overflow
        self.moments, self.axis = checked_moments(moments), jnp.asarray(direction / np.linalg.norm(direction))
        self.rotor_moment, self.torque = jnp.asarray(float(rotor_moment)), jnp.asarray(float(torque))

    @known_numbers_only
    def check_state(self, state: Array) -> Array:
        return check_unit_attitude(as_finite_state(state, float, length=8))

    def scales(self, state: Array) -> Array:
        """Return one for the attitude, and for momenta their size, or what a turn under the motor gives the rotor."""
        largest = jnp.maximum(jnp.max(jnp.abs(state[..., 4:]), initial=0.0),
                              jnp.sqrt(jnp.abs(self.torque) * self.rotor_moment))  # fmt: skip
        return jnp.concatenate([jnp.ones(4), jnp.full(4, jnp.where(largest > 0, largest, 1.0))])

    def layout(self, state: Array) -> StateLayout:
        return DRIVEN

    def vectors(self, state: Array) -> Vectors:
        return Vectors(state[..., :4], state[..., 4:7], self._velocity(state))

    def _velocity(self, state: Array) -> Array:
        return (state[..., 4:7] - state[..., 7:] * self.axis) / self.moments

    def vector_field(self, t: Array, state: Array) -> Array:
        attitude, momentum, velocity = state[..., :4], state[..., 4:7], self._velocity(state)
        pure = jnp.concatenate([jnp.zeros_like(state[..., :1]), 0.5 * velocity], axis=-1)
        spin_up = jnp.broadcast_to(self.torque, state[..., 7:].shape)
        return jnp.concatenate([rotation.multiply(attitude, pure), jnp.cross(momentum, velocity), spin_up], axis=-1)

    def invariants(self, state: Array) -> dict[str, Array]:
        attitude, momentum = state[..., :4], state[..., 4:7]
        return {"|L|²": jnp.sum(momentum**2, axis=-1), "momentum_space": rotation.rotate(attitude, momentum)}

    def balances(self, t: Array, state: Array) -> dict[str, Balance]:
        velocity, rotor = self._velocity(state), state[..., 7]
        energy = 0.5 * jnp.sum(self.moments * velocity**2, axis=-1) + 0.5 * rotor**2 / self.rotor_moment
        slip = rotor / self.rotor_moment - jnp.sum(velocity * self.axis, axis=-1)
        return {"energy": Balance(energy, self.torque * slip)}


def _vector(name: str, value: Array) -> Array:
    refuse_single_precision(**{name: value})
    try:
        vector = np.asarray(value, dtype=float)
    except (TypeError, ValueError):
        vector = np.full(1, np.nan)
    if vector.shape != (3,) or not np.isfinite(vector).all():
        raise InvalidInput(f"`{name}` must be three finite numbers along the principal axes; got {shown(value)}.")
    return jnp.asarray(vector)
