"""Control moment gyroscopes: a rotor in a gimbal, which turns the rotor's momentum in the body."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any, ClassVar, NamedTuple

import equinox as eqx
import jax.numpy as jnp
import numpy as np

from polhode._base import check
from polhode._base.arrays import known_numbers_only
from polhode.errors import InvalidInput, shown
from polhode.motion._layout import StatePart
from polhode.spacecraft.systems.attachments import Argument, Attitude, Own, Time, Velocity, checked_jumps
from polhode.spacecraft.systems.hinged_part import rotate_about, turn_tensor
from polhode.spacecraft.systems.moving_parts import AbstractMovingPart, Coordinates
from polhode.spacecraft.systems.wheels import HeldWheel, Wheel
from polhode.systems._checks import checked_direction, checked_number
from polhode.types import Array, ArrayLike, Float64, Real, Self

Batch = Float64[Array, "*batch"]
Drive = Callable[[Batch, Float64[Array, "*batch 4"], Float64[Array, "*batch 3"], Batch, Batch], Batch]


class GyroscopeLimits(NamedTuple):
    """Which axes are refused."""

    max_cosine: float = 1e-9  # between axes that are given as perpendicular


LIMITS = GyroscopeLimits()


class ControlMomentGyroscope(AbstractMovingPart):
    """A rotor in a single gimbal: it turns by γ about an axis g of the body, and the rotor's axis s(γ) with it.

    Its state is γ, the canonical momentum π of γ, and for a ``Wheel`` its whole axial momentum h = J (σ + s·Ω). With A
    the inertia of gimbal and rotor but for J s sᵀ, and ω = Ω + γ̇ g, it adds ½ ω·Aω + h²/2J to the energy and Aω + h s
    to the momentum. The rotor's reaction h Ω·(g × s) on the gimbal is in π̇, and that of a turning gimbal on the body,
    γ̇ h g × s, in L: both come from the one Lagrangian. Its centre lies on g, so that no mass moves.

    The gimbal is driven by a torque, or follows a rate γ̇ = r through a servo of the bandwidth b, whose motor gives
    I_g b (r − γ̇). A rate is never exact, as a motor's torque is finite; the lag is 1/b. Singular configurations of
    several gyroscopes are for the steering law to avoid.

    Args:
        gimbal_axis: g (3,) along the body's axes, normalised here.
        rotor: a ``Wheel``, free, driven or with friction, or a ``HeldWheel``, with its axis s at γ = 0.
        moments: (3,) of gimbal and rotor together about s, g × s and g [kg m²], positive.
        gimbal_torque: of the motor on the gimbal [N m]: a number, or a function (t, attitude, angular_velocity, angle,
            rate), batched and written with ``jax.numpy``; None for no motor.
        gimbal_rate: r [rad/s] instead: a number, or such a function.
        bandwidth: b of the servo [1/s], positive; given with ``gimbal_rate``.
        friction: c of the gimbal [N m s], not negative.
        jumps: (J,) times [s] at which the drive jumps; those of the rotor's motor are added.

    Raises:
        InvalidInput: for axes that are not perpendicular, a rotor with more than the whole's moment, both a torque and
            a rate, a rate without bandwidth, or values out of range.

    Source: Schaub & Junkins, *Analytical Mechanics of Space Systems* (2018), §4.6; Hughes, *Spacecraft Attitude
    Dynamics* (1986), §3.4.
    """

    name: ClassVar[str] = "control-moment-gyroscope"
    arguments: ClassVar[dict[str, Argument]] = {
        "gimbal_axis": Argument("", (3,)),
        "spin_axis": Argument("", (3,)),
        "rotor_moment": Argument("kg*m^2"),
        "rotor_rate": Argument("rad/s"),
        "moments": Argument("kg*m^2", (3,)),
        "rotor": Argument("text", choices=("held", "free")),
        "gimbal_torque": Argument("N*m"),
        "gimbal_rate": Argument("rad/s"),
        "bandwidth": Argument("1/s"),
        "friction": Argument("N*m*s"),
    }
    start_arguments: ClassVar[dict[str, Argument]] = {"angle": Argument("rad"), "angle_rate": Argument("rad/s")}
    carries_spin: ClassVar[bool] = True
    moves_mass: ClassVar[bool] = False
    gimbal_axis: Float64[Array, "3"]
    rotor: Wheel | HeldWheel
    moments: Float64[Array, "3"]
    drive: Float64[Array, ""] | Drive | None
    bandwidth: Float64[Array, ""] | None
    friction: Float64[Array, ""]
    jump_times: Float64[Array, "jumps"]
    mass: Float64[Array, ""]
    is_lossless: bool = eqx.field(static=True)

    @known_numbers_only
    def __init__(
        self, gimbal_axis: Real[ArrayLike, "3"], rotor: Wheel | HeldWheel, moments: Real[ArrayLike, "3"],
        gimbal_torque: float | Drive | None = None, gimbal_rate: float | Drive | None = None,
        bandwidth: float | None = None, friction: float = 0.0, jumps: Real[ArrayLike, "jumps"] = (),
    ) -> None:
        check.instance("rotor", rotor, (Wheel, HeldWheel), "a polhode.spacecraft.Wheel or HeldWheel")
        self.gimbal_axis, self.rotor = checked_direction("gimbal_axis", gimbal_axis), rotor
        if abs(float(np.dot(self.gimbal_axis, rotor.axis))) > LIMITS.max_cosine:
            raise InvalidInput(f"`gimbal_axis` must be perpendicular to the rotor's axis; got {shown(gimbal_axis)}.")
        self.moments = jnp.stack(_checked_moments(moments))
        if isinstance(rotor, Wheel) and not float(self.moments[0]) > float(rotor.moment):
            raise InvalidInput(
                f"`moments` must be those of gimbal and rotor together, the first of them above the rotor's "
                f"{float(rotor.moment):g} kg m²; got {shown(moments)}."
            )
        if gimbal_torque is not None and gimbal_rate is not None:
            raise InvalidInput("give `gimbal_torque` or `gimbal_rate`, not both.")
        if (gimbal_rate is None) != (bandwidth is None):
            raise InvalidInput("`gimbal_rate` and `bandwidth` go together: a servo follows the rate. Give both.")
        name, drive = ("gimbal_torque", gimbal_torque) if gimbal_rate is None else ("gimbal_rate", gimbal_rate)
        self.drive = drive if drive is None or callable(drive) else checked_number(name, drive)
        self.bandwidth = None if bandwidth is None else checked_number("bandwidth", bandwidth, 0.0, unit="1/s")
        self.friction = checked_number("friction", friction, least=0.0, unit="N m s")
        self.jump_times, self.mass = checked_jumps(jumps), jnp.zeros(())
        self.is_lossless = drive is None and not float(self.friction) and rotor.conserves_energy

    @property
    def moment(self) -> Float64[Array, ""]:
        """About the gimbal's axis [kg m²]."""
        return self.moments[2]

    @property
    def tensor_at_rest(self) -> Float64[Array, "3 3"]:
        """Of gimbal and rotor at γ = 0, without the moment of a free rotor about its axis [kg m²]."""
        spun, third = self.rotor.axis, jnp.cross(self.gimbal_axis, self.rotor.axis)
        about_spin = self.moments[0] - (self.rotor.moment if isinstance(self.rotor, Wheel) else 0.0)
        pairs = ((about_spin, spun), (self.moments[1], third), (self.moments[2], self.gimbal_axis))
        first, second, last = (moment * axis[:, None] * axis for moment, axis in pairs)
        return first + second + last

    @classmethod
    def from_table(
        cls, gimbal_axis: Real[ArrayLike, "3"], spin_axis: Real[ArrayLike, "3"], rotor_moment: float, rotor_rate: float,
        moments: Real[ArrayLike, "3"], rotor: str = "held", gimbal_torque: float | None = None,
        gimbal_rate: float | None = None, bandwidth: float | None = None, friction: float = 0.0,
    ) -> Self:
        """Return the gyroscope of a spec, whose rotor is held at a rate, or free and has it at the start."""
        spun = Wheel(spin_axis, rotor_moment) if rotor == "free" else HeldWheel(spin_axis, rotor_moment, rotor_rate)
        return cls(gimbal_axis, spun, moments, gimbal_torque, gimbal_rate, bandwidth, friction)

    def start_of(self, values: Mapping[str, Any]) -> tuple[Any, Any]:
        rates = [values.get("angle_rate") or 0.0, values["rotor_rate"]]
        return rates[: self.rate_count], values.get("angle")

    @property
    def jumps(self) -> Float64[Array, "jumps"]:
        return jnp.concatenate([self.jump_times, jnp.ravel(self.rotor.jumps)])

    @property
    def coordinates(self) -> tuple[StatePart, ...]:
        return (StatePart("gimbal_angle", 1, "rad", "angle of a gimbal"),)

    @property
    def further_parts(self) -> tuple[StatePart, ...]:
        return self.rotor.state_parts

    @property
    def rate_count(self) -> int:
        """Two where the rotor turns freely, γ̇ and σ; else γ̇ alone."""
        return 1 + len(self.rotor.state_parts)

    @property
    def needs_attitude(self) -> bool:
        return callable(self.drive) or self.rotor.needs_attitude

    @property
    def names_all_jumps(self) -> bool:
        return not callable(self.drive) and self.rotor.names_all_jumps

    @property
    def conserves_energy(self) -> bool:
        return self.is_lossless

    @property
    def momentum_scale(self) -> Float64[Array, ""]:
        held = self.rotor
        return jnp.abs(held.moment * held.rate) if isinstance(held, HeldWheel) else held.momentum_scale

    @property
    def limited(self) -> bool:
        return self.rotor.limited

    def without_limits(self) -> Self:
        return eqx.tree_at(lambda gyroscope: gyroscope.rotor, self, self.rotor.without_limits())

    def load(
        self, t: Time, attitude: Attitude, angular_velocity: Velocity, own: Own, stored: Velocity
    ) -> Float64[Array, "*batch"]:
        return self._turned_rotor(own).load(t, attitude, angular_velocity, own[..., 2:], stored)

    def spin_axis(self, q: Coordinates) -> Float64[Array, "*batch 3"]:
        """Return s(γ) (…, 3)."""
        return rotate_about(self.gimbal_axis, q, self.rotor.axis)

    def position(self, q: Coordinates) -> Float64[Array, "*batch 3"]:
        return jnp.zeros((*q.shape[:-1], 3))

    def tensor(self, q: Coordinates) -> Float64[Array, "*batch 3 3"]:
        return turn_tensor(self.gimbal_axis, q, self.tensor_at_rest)

    def turning_axes(self, q: Coordinates) -> list[Float64[Array, "*batch 3"]]:
        return [jnp.broadcast_to(self.gimbal_axis, (*q.shape[:-1], 3))]

    def spin_inertia(self, q: Coordinates) -> Float64[Array, "*batch 3 3"] | None:
        if isinstance(self.rotor, HeldWheel):
            return None
        axis = self.spin_axis(q)
        return self.rotor.moment * axis[..., :, None] * axis[..., None, :]

    def momentum(self, own: Float64[Array, "*batch {self.state_size}"]) -> Float64[Array, "*batch 3"]:
        return self._turned_rotor(own).momentum(own[..., 2:])

    def energy(self, own: Float64[Array, "*batch {self.state_size}"]) -> Float64[Array, "*batch"]:
        return self.rotor.energy(own[..., 2:])

    def _turned_rotor(self, own: Array) -> Wheel | HeldWheel:
        return eqx.tree_at(lambda rotor: rotor.axis, self.rotor, self.spin_axis(own[..., :1]))

    def applied(
        self, t: Time, attitude: Attitude, angular_velocity: Velocity, own: Float64[Array, "*#batch {self.state_size}"],
        rate: Float64[Array, "*#batch {self.count}"],
    ) -> Float64[Array, "*batch {self.count}"]:
        drive, turning = self.drive, rate[..., 0]
        if callable(drive):
            assert attitude is not None, "a drive by a function needs the attitude"
            drive = drive(t, attitude, angular_velocity, own[..., 0], turning)
        torque = 0.0 if drive is None else drive
        if self.bandwidth is not None:
            torque = self.moment * self.bandwidth * (torque - turning)
        return (torque - self.friction * turning)[..., None]

    def further_rate(
        self, t: Time, attitude: Attitude, angular_velocity: Velocity, own: Float64[Array, "*#batch {self.state_size}"],
        rate: Float64[Array, "*#batch {self.count}"],
    ) -> Float64[Array, "*batch {self.further_count}"]:
        return self._turned_rotor(own).state_rate(t, attitude, angular_velocity, own[..., 2:])

    def further_power(
        self, t: Time, attitude: Attitude, angular_velocity: Velocity, own: Float64[Array, "*#batch {self.state_size}"],
        rate: Float64[Array, "*#batch {self.count}"],
    ) -> Float64[Array, "*batch"]:
        return self._turned_rotor(own).power(t, attitude, angular_velocity, own[..., 2:])

    def start_further(
        self, q: Float64[Array, "*#batch {self.count}"], rate: Float64[Array, "*#batch rates"],
        angular_velocity: Float64[Array, "*#batch 3"],
    ) -> Float64[Array, "*batch {self.further_count}"]:
        if isinstance(self.rotor, HeldWheel):
            return jnp.zeros((*q.shape[:-1], 0))
        rotated = eqx.tree_at(lambda rotor: rotor.axis, self.rotor, self.spin_axis(q))
        return rotated.start(rate[..., 1], angular_velocity)


def _checked_moments(moments: Real[ArrayLike, "3"]) -> list[Float64[Array, ""]]:
    remedy = "Give those about s, g × s and g."
    return [jnp.asarray(x) for x in check.array("moments", moments, (3,), "kg m²", above=0, remedy=remedy)]
