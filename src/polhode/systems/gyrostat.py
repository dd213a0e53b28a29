"""Gyrostats: a body with a rotor inside."""

from __future__ import annotations

from typing import ClassVar

import equinox as eqx
import jax.numpy as jnp

from polhode.algebra.base import AbstractLieAlgebra
from polhode.algebra.so3 import SO3
from polhode.arrays import compiled_for_few_calls, known_numbers_only
from polhode.errors import InvalidInput
from polhode.systems._checks import checked_number, checked_vector
from polhode.systems.base import AbstractLiePoissonSystem, Flow
from polhode.systems.free_rigid_body import axis_flow, checked_moments
from polhode.systems.mounts import AbstractMounted
from polhode.systems.rigid_body import AbstractRigidBody
from polhode.systems.torques import AbstractTorque
from polhode.systems.wheels import Wheel
from polhode.types import Array, ArrayLike, Float64, Real


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
    ) -> None:  # fmt: skip
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


class TorquedGyrostat(AbstractRigidBody):
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
    mounts: tuple[AbstractMounted, ...]
    torques: tuple[AbstractTorque, ...]
    structure: None

    @known_numbers_only
    def __init__(
        self, moments: Real[ArrayLike, "3"], axis: Real[ArrayLike, "3"], rotor_moment: float, torque: float
    ) -> None:
        moment = float(checked_number("rotor_moment", rotor_moment, above=0.0, unit="kg m²"))
        motor = float(checked_number("torque", torque, unit="N m"))
        self.moments, self.structure = checked_moments(moments), None
        self.mounts, self.torques = (Wheel(axis, moment, motor),), ()

    @property
    def carrier(self) -> Float64[Array, "3"]:
        """The moments, which are given without the rotor's axial one."""
        return self.moments

    @property
    def needs_attitude(self) -> bool:
        """Its states always carry the attitude."""
        return True

    @property
    def axis(self) -> Float64[Array, "3"]:
        """(3,) of the rotor."""
        return self._rotor.axis

    @property
    def rotor_moment(self) -> Float64[Array, ""]:
        """J of the rotor about its axis [kg m²]."""
        return self._rotor.moment

    @property
    def _rotor(self) -> Wheel:
        (rotor,) = self.mounts
        assert isinstance(rotor, Wheel)
        return rotor
