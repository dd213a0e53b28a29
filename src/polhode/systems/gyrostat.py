"""Gyrostats: a body with a rotor inside."""

from __future__ import annotations

from collections.abc import Sequence
from typing import ClassVar

import equinox as eqx
import jax.numpy as jnp
import numpy as np

from polhode import rotation
from polhode._base.arrays import compiled_for_few_calls, is_traced, known_numbers_only, require_doubles
from polhode.algebra.base import AbstractLieAlgebra
from polhode.algebra.so3 import SO3
from polhode.errors import InvalidInput, shown
from polhode.motion._inputs import refuse_not_finite
from polhode.motion._layout import (
    ATTITUDE,
    ENERGY,
    MOMENTUM,
    MOMENTUM_SPACE,
    MOMENTUM_SQUARED,
    Quantity,
    StateLayout,
    StatePart,
)
from polhode.systems._checks import (
    as_finite_state,
    check_unit_attitude,
    checked_direction,
    checked_number,
    checked_vector,
)
from polhode.systems._symmetric import solve_symmetric
from polhode.systems.base import (
    AbstractLiePoissonSystem,
    AbstractSystem,
    Balance,
    Flow,
    Vectors,
)
from polhode.systems.free_rigid_body import axis_flow, checked_moments
from polhode.types import Array, ArrayLike, Float64, Real

States = Float64[Array, "*batch 8"]
LAYOUT = StateLayout((
    ATTITUDE, MOMENTUM, StatePart("rotor_momentum", 1, "kg m2 s-1", "whole momentum of the rotor along its axis"),
))  # fmt: skip


class Gyrostat(AbstractLiePoissonSystem):
    """Π̇ = Π × Ω, Ω = I⁻¹(Π − h) on so(3)*, with the rotor's momentum h fixed in the body; H = ½ (Π − h)·I⁻¹(Π − h).

    Π is the whole angular momentum. Two kinds of rotor obey it. One is driven at a constant rate against the body: h is
    its momentum relative to the body, I the moments of both together. The other turns freely, or its motor only
    makes up for friction: h is its whole axial momentum, which then stays, and I the moments less the rotor's axial
    one along its axis. Energy is that of the carrier, which is kept in either case. State Π (…, 3), or with the
    attitude (…, 7). Flows: rotation about each axis.

    Args:
        moments: (3,) principal moments I [kg m²], positive.
        rotor: (3,) h [kg m²/s, principal axes].
        rotor_moment: J of the rotor about its axis [kg m²]; the motion does not depend on it, only ``rotor_rate`` does.
        free: whether the rotor turns freely, so that h is its whole momentum.

    Raises:
        InvalidInput: for moments that are not positive, or a rotor that is not three finite numbers.

    Source: Zhukovskii 1885; Volterra, Acta Math. 22 (1899) 201; Hughes, *Spacecraft Attitude Dynamics*, §3.4.
    """

    kind: ClassVar[str] = "gyrostat"
    title: ClassVar[str] = "Gyrostat"
    algebra: AbstractLieAlgebra
    moments: Float64[Array, "3"]
    rotor: Float64[Array, "3"]
    rotor_moment: float | None = eqx.field(static=True)
    free: bool = eqx.field(static=True)

    @known_numbers_only
    def __init__(
        self, moments: Real[ArrayLike, "3"], rotor: Real[ArrayLike, "3"], rotor_moment: float | None = None,
        free: bool = False,
    ) -> None:
        self.algebra, self.moments, self.rotor = SO3(), checked_moments(moments), checked_vector("rotor", rotor)
        if rotor_moment is not None:
            rotor_moment = float(checked_number("rotor_moment", rotor_moment, above=0.0, unit="kg m²"))
        self.rotor_moment, self.free = rotor_moment, free

    def energy(self, point: Float64[Array, "*batch 3"]) -> Float64[Array, "*batch"]:
        return 0.5 * jnp.sum((point - self.rotor) ** 2 / self.moments, axis=-1)

    def velocity(self, point: Float64[Array, "*batch 3"]) -> Float64[Array, "*batch 3"]:
        # dH = I⁻¹(Π − h), which is Ω: the momentum h is not carried by the body
        return (point - self.rotor) / self.moments

    def rotor_rate(self, velocity: Float64[Array, "*batch 3"]) -> Float64[Array, "*batch"]:
        """Return how fast the rotor turns relative to the body (…) [rad/s], about h, while the body turns by Ω.

        Args:
            velocity: (…, 3) Ω [rad/s, principal axes].

        Raises:
            InvalidInput: without the rotor's moment.
        """
        if self.rotor_moment is None:
            raise InvalidInput("`rotor_moment` of the gyrostat must be given to find how fast its rotor turns.")
        return _rotor_rate(self.rotor, self.rotor_moment, self.free, velocity)

    @property
    def flows(self) -> dict[str, Flow]:
        return {f"rotation about axis {k + 1}": axis_flow(self.moments, k, 1, self.rotor[k]) for k in range(3)}


@compiled_for_few_calls
def _rotor_rate(rotor: Array, rotor_moment: float, free: bool, velocity: Array) -> Array:
    # h = Jσ of a driven rotor, h = J (σ + Ω·a) of a free one, solved for σ
    size = jnp.sqrt(jnp.sum(rotor**2))
    along = velocity @ (rotor / jnp.where(size > 0.0, size, 1.0))
    return size / rotor_moment - (along if free else 0.0 * along)


class TorquedGyrostat(AbstractSystem):
    """A gyrostat whose motor turns the rotor with a constant torque u: Π̇ = Π × Ω, ḣ = u, Ω = I⁻¹(Π − h a).

    h is the rotor's whole momentum along its axis a, I the moments less the rotor's axial one along a: the spin-up and
    dual-spin turn of spacecraft. Without torque it is ``Gyrostat``; several rotors, and other motors, take a
    ``RigidBody``, whose moments are those with the rotors locked. The energy ½ (Π − ha)·I⁻¹(Π − ha) + h²/2J receives
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

    kind: ClassVar[str] = "gyrostat"
    title: ClassVar[str] = "Gyrostat with a driven rotor"
    moments: Float64[Array, "3"]
    axis: Float64[Array, "3"]
    rotor_moment: Float64[Array, ""]
    torque: Float64[Array, ""]

    @known_numbers_only
    def __init__(
        self, moments: Real[ArrayLike, "3"], axis: Real[ArrayLike, "3"], rotor_moment: float, torque: float
    ) -> None:
        self.rotor_moment = checked_number("rotor_moment", rotor_moment, above=0.0, unit="kg m²")
        self.torque = checked_number("torque", torque, unit="N m")
        self.moments, self.axis = checked_moments(moments), checked_direction("axis", axis)

    def vector_field(self, t: Real[ArrayLike, "..."], state: States) -> States:
        attitude, momentum, rotor = self._parts(state)
        velocity = self._velocity(momentum, rotor)
        return jnp.concatenate([
            rotation.quaternion_rate(attitude, velocity), jnp.cross(momentum, velocity),
            jnp.broadcast_to(self.torque, rotor.shape),
        ], axis=-1)

    def velocity(self, state: States) -> Float64[Array, "*batch 3"]:
        """Return Ω (…, 3) [rad/s, principal axes]."""
        _, momentum, rotor = self._parts(state)
        return self._velocity(momentum, rotor)

    def _velocity(self, momentum: Array, rotor: Array) -> Array:
        return (momentum - rotor * self.axis) / self.moments

    def _parts(self, state: Float64[Array, "*batch n"]) -> tuple[Array, Array, Array]:
        """Return attitude (…, 4), Π (…, 3) and h (…, 1).

        Raises:
            InvalidInput: for a wrong last axis.
        """
        require_doubles(state=state)
        if jnp.shape(state)[-1:] != (8,):
            raise InvalidInput(
                f"`state` of TorquedGyrostat must have shape (…, 8) with the attitude in front; got "
                f"{jnp.shape(state)}. Make it by `pack(attitude, angular_velocity)`."
            )
        return state[..., :4], state[..., 4:7], state[..., 7:]

    # ------------------------------------------------------------------ what is kept, and what is balanced

    def energy(self, state: States) -> Float64[Array, "*batch"]:
        """Return ½ (Π − ha)·Ω + h²/2J (…) [J]."""
        _, momentum, rotor = self._parts(state)
        carried = momentum - rotor * self.axis
        own = 0.5 * rotor[..., 0] ** 2 / self.rotor_moment
        return 0.5 * jnp.sum(carried * (carried / self.moments), axis=-1) + own

    def power(self, t: Real[ArrayLike, "..."], state: States) -> Float64[Array, "*batch"]:
        """Return the power of the motor (…) [W]."""
        _, momentum, rotor = self._parts(state)
        along = jnp.sum(self._velocity(momentum, rotor) * self.axis, axis=-1)
        return self.torque * (rotor[..., 0] / self.rotor_moment - along)

    def invariants(self, state: States) -> dict[str, Float64[Array, "..."]]:
        """Return |Π|² and the momentum in space, which nothing inside changes."""
        attitude, momentum, _ = self._parts(state)
        return {"|L|²": jnp.sum(momentum**2, axis=-1), "momentum_space": rotation.rotate(attitude, momentum)}

    def balances(self, t: Real[ArrayLike, "..."], state: States) -> dict[str, Balance]:
        return {"energy": Balance(self.energy(state), self.power(t, state))}

    @property
    def quantities(self) -> dict[str, Quantity]:
        return {"energy": ENERGY, "|L|²": MOMENTUM_SQUARED, "momentum_space": MOMENTUM_SPACE}

    @property
    def names_all_jumps(self) -> bool:
        return True

    def vectors(self, state: States) -> Vectors:
        attitude, momentum, rotor = self._parts(state)
        return Vectors(attitude, momentum, self._velocity(momentum, rotor))

    # ------------------------------------------------------------------ packed states

    def layout(self, state: States) -> StateLayout:
        return LAYOUT

    def scales(self, state: States) -> Float64[Array, "8"]:
        """Return one for the attitude, and for momenta their size, or that which the motor gives in a turn."""
        _, momentum, rotor = self._parts(state)
        largest = jnp.maximum(jnp.max(jnp.abs(momentum), initial=0.0), jnp.max(jnp.abs(rotor), initial=0.0))
        largest = jnp.maximum(largest, jnp.sqrt(jnp.abs(self.torque) * self.rotor_moment))
        scale = jnp.where(largest > 0, largest, jnp.max(self.moments))
        return jnp.concatenate([jnp.ones(4), jnp.full(4, scale)])

    @known_numbers_only
    def check_state(self, state: Real[ArrayLike, "*shape"]) -> Float64[Array, "*shape"]:
        """Return states as an array.

        Raises:
            InvalidInput: for wrong shapes, values that are not finite, an attitude that is not a unit quaternion.
        """
        state = as_finite_state(state, float)
        self._parts(np.asarray(state))
        return check_unit_attitude(state)

    def pack(
        self, attitude: Real[ArrayLike, "*#batch 4"] | None = None,
        angular_velocity: Real[ArrayLike, "*#batch 3"] | None = None,
        momentum: Real[ArrayLike, "*#batch 3"] | None = None,
        rates: Sequence[Real[ArrayLike, "..."] | None] | None = None,
    ) -> Float64[Array, "... 8"]:
        """Return packed states (…, 8), as ``RigidBody.pack`` does.

        Args:
            attitude: (…, 4) unit quaternion wxyz, principal axes → space; the identity if left out.
            angular_velocity: Ω (…, 3) of the body [rad/s]; this, ``momentum``, or neither for rest.
            momentum: Π (…, 3) of the body with its rotor [kg m²/s].
            rates: one entry, (…) of the rotor relative to the body [rad/s]; left out, it rests in the body.

        Raises:
            InvalidInput: if both velocity and momentum are given, for NaN, or more than one rate.
        """
        if angular_velocity is not None and momentum is not None:
            raise InvalidInput("give `angular_velocity` or `momentum`, not both.")
        require_doubles(attitude=attitude, angular_velocity=angular_velocity, momentum=momentum)
        if rates is not None and (not isinstance(rates, Sequence | np.ndarray) or len(rates) != 1):
            raise InvalidInput(f"`rates` must be a list with one entry, for the rotor; got {shown(rates)}.")
        rate = 0.0 if rates is None or rates[0] is None else rates[0]
        require_doubles(**{"rates[0]": rate})
        given = {"attitude": attitude, "angular_velocity": angular_velocity, "momentum": momentum, "rates[0]": rate}
        refuse_not_finite(**{name: jnp.asarray(x, dtype=float) for name, x in given.items() if x is not None})
        quaternion = jnp.asarray((1.0, 0.0, 0.0, 0.0) if attitude is None else attitude, dtype=float)
        if attitude is not None:
            quaternion = rotation.normalize(quaternion if is_traced(quaternion) else np.asarray(quaternion))
        velocity = np.zeros(3) if angular_velocity is None else jnp.asarray(angular_velocity, dtype=float)
        whole = None if momentum is None else jnp.asarray(momentum, dtype=float)
        return _pack(self, quaternion, velocity, whole, jnp.asarray(rate, dtype=float))


@compiled_for_few_calls
def _pack(body: TorquedGyrostat, attitude: Array, velocity: Array, momentum: Array | None, rate: Array) -> Array:
    """Return packed states of what ``pack`` has checked; of Ω only where the momentum is None."""

    def start(velocity: Array) -> tuple[Array, Array]:
        own = body.rotor_moment * (rate + jnp.sum(velocity * body.axis, axis=-1))[..., None]
        return body.moments * velocity + own * body.axis, own

    if momentum is not None:
        # Π = (I + J aaᵀ) Ω + what turns against the body
        still = start(jnp.zeros(3))[0]
        units = [start(unit)[0] - still for unit in jnp.eye(3)]
        rows, right = [[unit[..., i] for unit in units] for i in range(3)], momentum - still
        velocity = jnp.stack(solve_symmetric(rows, [right[..., i] for i in range(3)]), axis=-1)
    parts = [attitude, *start(velocity)]
    shape = np.broadcast_shapes(*(part.shape[:-1] for part in parts))
    return jnp.concatenate([jnp.broadcast_to(part, (*shape, part.shape[-1])) for part in parts], axis=-1)
