"""A rigid body under torques: drag, gravity gradient, or the user's own."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any, ClassVar

import jax.numpy as jnp
import numpy as np

from polhode import rotation
from polhode.arrays import known_numbers_only
from polhode.errors import InvalidInput, shown
from polhode.motion.layout import ATTITUDE, MOMENTUM, MOMENTUM_SQUARED, Quantity, StateLayout
from polhode.systems.base import AbstractSystem, Balance, Parts, Vectors, as_finite_state, check_unit_attitude, joined
from polhode.systems.free_rigid_body import checked_moments
from polhode.systems.torques import AbstractTorque, GravityGradient

Array = Any


class TorquedBody(AbstractSystem):
    """L̇ = L × Ω + Σ τ(t, attitude, Ω) along principal axes, dR/dt = R hat(Ω).

    State L (…, 3) where no torque asks for the attitude, or attitude and L (…, 7). Nothing is conserved in general; the
    kinetic energy changes by the torques' power τ·Ω, |L|² by 2 τ·L, and on a circular orbit the Jacobi integral by the
    power of all torques but gravity's in the orbit's frame. ``simulate`` reports how well the motion obeys.

    Args:
        moments: (3,) principal moments [kg m²], positive.
        torques: what acts on it, any number.

    Raises:
        InvalidInput: for moments that are not positive, what is not a torque, or a gravity gradient on other moments.

    >>> from polhode.systems.torques import LinearDrag
    >>> body = TorquedBody((1.0, 2.0, 3.0), [LinearDrag(0.5)])
    >>> body.vector_field(0.0, jnp.array([0.0, 0.0, 3.0])).tolist()
    [0.0, 0.0, -0.5]
    """

    title: ClassVar[str] = "Body under torques"
    moments: Array
    torques: tuple[AbstractTorque, ...]

    @known_numbers_only
    def __init__(self, moments: Array, torques: Sequence[AbstractTorque]) -> None:
        if not isinstance(torques, Iterable):
            raise InvalidInput(f"`torques` must be a list; got {shown(torques)}. Put it in brackets.")
        self.moments, self.torques = checked_moments(moments), tuple(torques)
        for torque in self.torques:
            if not isinstance(torque, AbstractTorque):
                raise InvalidInput(
                    f"`torques` must be a list of polhode.systems.torques; got {shown(torque)}. "
                    "Derive your own from AbstractTorque."
                )
            if isinstance(torque, GravityGradient) and not np.array_equal(torque.moments, self.moments):
                raise InvalidInput(
                    f"`torques` has the gravity gradient on the moments {np.asarray(torque.moments).tolist()}, "
                    f"but the body's are {np.asarray(self.moments).tolist()} kg m². Give both the same."
                )

    @property
    def needs_attitude(self) -> bool:
        """Whether a torque depends on how the body is turned."""
        return any(torque.needs_attitude for torque in self.torques)

    def vector_field(self, t: Array, state: Array) -> Array:
        attitude, momentum = self.parts(state)
        velocity = momentum / self.moments
        change = jnp.cross(momentum, velocity) + self.torque(t, attitude, velocity)
        if attitude is None:
            return change
        pure = jnp.concatenate([jnp.zeros_like(velocity[..., :1]), 0.5 * velocity], axis=-1)
        return joined(rotation.multiply(attitude, pure), change)

    def torque(self, t: Array, attitude: Array | None, angular_velocity: Array) -> Array:
        """Return the sum of all torques (…, 3) [N m, body axes]."""
        t, still = jnp.asarray(t), jnp.zeros_like(angular_velocity)
        return sum((torque.torque(t, attitude, angular_velocity) for torque in self.torques), still)

    def invariants(self, state: Array) -> dict[str, Array]:
        """Return none: what a circular orbit conserves depends on time too, and stands among the balances."""
        return {}

    def balances(self, t: Array, state: Array) -> dict[str, Balance]:
        """Return kinetic energy and |L|² with the torques' shares, and on a circular orbit the Jacobi integral."""
        attitude, momentum = self.parts(state)
        velocity = momentum / self.moments
        torque = self.torque(t, attitude, velocity)
        energy = 0.5 * jnp.sum(momentum * velocity, axis=-1)
        balances = {
            "kinetic_energy": Balance(energy, jnp.sum(torque * velocity, axis=-1)),
            "|L|²": Balance(jnp.sum(momentum**2, axis=-1), 2.0 * jnp.sum(torque * momentum, axis=-1)),
        }
        gravity = [torque for torque in self.torques if isinstance(torque, GravityGradient)]
        if attitude is not None and len(gravity) == 1 and gravity[0].circular:
            others = torque - gravity[0].torque(t, attitude, velocity)
            power = jnp.sum(others * gravity[0].relative_velocity(attitude, velocity), axis=-1)
            balances["jacobi_integral"] = Balance(gravity[0].jacobi_integral(t, attitude, velocity), power)
        return balances

    @known_numbers_only
    def check_state(self, state: Array) -> Array:
        """Return states as an array.

        Raises:
            InvalidInput: for wrong shapes, values that are not finite, an attitude that is not a unit quaternion.
        """
        state = as_finite_state(state, float)
        return state if self.parts(state).attitude is None else check_unit_attitude(state)

    def scales(self, state: Array) -> Array:
        """Return one for the attitude, and for the momentum its size, or that which the torques give it from rest."""
        attitude, momentum = self.parts(state)
        largest = jnp.max(jnp.abs(momentum), initial=0.0)
        for torque in self.torques:
            largest = jnp.maximum(largest, jnp.max(self.moments) * torque.rate)
        scale = jnp.broadcast_to(jnp.where(largest > 0, largest, jnp.max(self.moments)), (3,))
        return scale if attitude is None else jnp.concatenate([jnp.ones(4), scale])

    def layout(self, state: Array) -> StateLayout:
        return StateLayout((MOMENTUM,) if self.parts(state).attitude is None else (ATTITUDE, MOMENTUM))

    @property
    def quantities(self) -> dict[str, Quantity]:
        return {
            "kinetic_energy": Quantity("J", "kinetic energy"),
            "|L|²": MOMENTUM_SQUARED,
            "jacobi_integral": Quantity("J", "Jacobi integral in the orbit's frame"),
        }

    def vectors(self, state: Array) -> Vectors:
        attitude, momentum = self.parts(state)
        return Vectors(attitude, momentum, momentum / self.moments)

    def parts(self, state: Array) -> Parts:
        """Take a packed state apart.

        Raises:
            InvalidInput: for a wrong last axis.
        """
        size = jnp.shape(state)[-1:]
        if size == (7,):
            return Parts(state[..., :4], state[..., 4:])
        if size == (3,) and not self.needs_attitude:
            return Parts(None, state)
        shorter = "" if self.needs_attitude else "(…, 3), or "
        raise InvalidInput(
            f"`state` of TorquedBody must have shape {shorter}(…, 7) with the attitude in front; "
            f"got {jnp.shape(state)}."
        )
