"""Rigid parts on a sprung hinge in a body, such as solar panels, and pendulums in a plane."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any, ClassVar

import equinox as eqx
import jax.numpy as jnp

from polhode._base.arrays import known_numbers_only
from polhode.bodies.body import Body
from polhode.errors import InvalidInput
from polhode.motion._layout import StatePart
from polhode.spacecraft.systems.attachments import Argument, Attitude, Time, Velocity, checked_jumps
from polhode.spacecraft.systems.moving_parts import AbstractMovingPart, Coordinates
from polhode.systems._checks import checked_direction, checked_number, checked_vector
from polhode.types import Array, ArrayLike, Float64, Real

Batch = Float64[Array, "*batch"]
HingeMotor = Callable[[Batch, Float64[Array, "*batch 4"], Float64[Array, "*batch 3"], Batch, Batch], Batch]


class HingedPart(AbstractMovingPart):
    """A rigid part on a hinge with a spring: a solar panel, an antenna, or, without inertia, a pendulum in a plane.

    It turns by θ about an axis a through the hinge, and on it act −k θ − c θ̇ and a motor.

    Args:
        hinge: (3,) a point of its axis [m, body axes].
        axis: (3,) a, normalised here.
        center: (3,) its centre of mass at rest [m, body axes].
        mass: m [kg], positive.
        inertia: (3, 3) about its centre of mass at rest [kg m², body axes]; None for a point.
        stiffness: k [N m/rad], not negative.
        damping: c [N m s], not negative.
        motor: the torque of a motor on it [N m]: a number, or a function (t, attitude, angular_velocity, angle, rate),
            batched and written with ``jax.numpy``; None for no motor. A function needs states that have the attitude.
        jumps: (J,) times [s] at which the motor's torque jumps.

    Raises:
        InvalidInput: for values out of range, an inertia of no body, a body without mass.

    Source: Allard, Schaub & Piggott, "General Hinged Rigid-Body Dynamics Approximating First-Order Spacecraft Solar
    Panel Flexing", J. Spacecr. Rockets 55 (2018) 1291.
    """

    name: ClassVar[str] = "hinged-part"
    arguments: ClassVar[dict[str, Argument]] = {
        "hinge": Argument("m", (3,)),
        "axis": Argument("", (3,)),
        "center": Argument("m", (3,)),
        "mass": Argument("kg"),
        "inertia": Argument("kg*m^2", (3, 3)),
        "stiffness": Argument("N*m/rad"),
        "damping": Argument("N*m*s"),
        "motor": Argument("N*m"),
    }
    start_arguments: ClassVar[dict[str, Argument]] = {"angle": Argument("rad"), "rate": Argument("rad/s")}

    hinge: Float64[Array, "3"]
    axis: Float64[Array, "3"]
    arm: Float64[Array, "3"]
    mass: Float64[Array, ""]
    inertia_at_rest: Float64[Array, "3 3"] | None
    stiffness: Float64[Array, ""]
    damping: Float64[Array, ""]
    motor: Float64[Array, ""] | HingeMotor | None
    jump_times: Float64[Array, "jumps"]
    is_lossless: bool = eqx.field(static=True)

    @known_numbers_only
    def __init__(
        self, hinge: Real[ArrayLike, "3"], axis: Real[ArrayLike, "3"], center: Real[ArrayLike, "3"], mass: float,
        inertia: Real[ArrayLike, "3 3"] | None = None, stiffness: float = 0.0, damping: float = 0.0,
        motor: float | HingeMotor | None = None, jumps: Real[ArrayLike, "jumps"] = (),
    ) -> None:
        self.hinge, self.axis = checked_vector("hinge", hinge), checked_direction("axis", axis)
        self.arm = checked_vector("center", center) - self.hinge
        self.mass = checked_number("mass", mass, 0.0, unit="kg")
        self.inertia_at_rest = None if inertia is None else jnp.asarray(Body.from_inertia(inertia).inertia)
        self.stiffness = checked_number("stiffness", stiffness, least=0.0, unit="N m/rad")
        self.damping = checked_number("damping", damping, least=0.0, unit="N m s")
        self.motor = motor if motor is None or callable(motor) else checked_number("motor", motor, unit="N m")
        self.jump_times = checked_jumps(jumps)
        self.is_lossless = self.motor is None and not float(self.damping)
        across = self.arm - self.axis * jnp.dot(self.axis, self.arm)
        own = 0.0 if self.inertia_at_rest is None else float(self.axis @ self.inertia_at_rest @ self.axis)
        if not float(self.mass * jnp.sum(across**2)) + own > 0.0:
            raise InvalidInput("`center` must lie off the hinge's axis, or `inertia` be more than a point's; "
                               "got a part that turns on its axis without inertia.")

    def start_of(self, values: Mapping[str, Any]) -> tuple[Any, Any]:
        return values.get("rate"), values.get("angle")

    @property
    def jumps(self) -> Float64[Array, "jumps"]:
        return self.jump_times

    @property
    def coordinates(self) -> tuple[StatePart, ...]:
        return (StatePart("hinge_angle", 1, "rad", "angle of a hinge"),)

    @property
    def needs_attitude(self) -> bool:
        return callable(self.motor)

    @property
    def names_all_jumps(self) -> bool:
        return not callable(self.motor)

    @property
    def conserves_energy(self) -> bool:
        return self.is_lossless

    def position(self, q: Coordinates) -> Float64[Array, "*batch 3"]:
        return self.hinge + rotate_about(self.axis, q, self.arm)

    def tensor(self, q: Coordinates) -> Float64[Array, "*batch 3 3"] | None:
        return None if self.inertia_at_rest is None else turn_tensor(self.axis, q, self.inertia_at_rest)

    def turning_axes(self, q: Coordinates) -> list[Float64[Array, "*batch 3"]] | None:
        return None if self.inertia_at_rest is None else [jnp.broadcast_to(self.axis, (*q.shape[:-1], 3))]

    def potential(self, q: Coordinates) -> Float64[Array, "*batch"]:
        return 0.5 * self.stiffness * q[..., 0] ** 2

    def applied(
        self, t: Time, attitude: Attitude, angular_velocity: Velocity, own: Float64[Array, "*#batch {self.state_size}"],
        rate: Float64[Array, "*#batch {self.count}"],
    ) -> Float64[Array, "*batch {self.count}"]:
        motor = 0.0 if self.motor is None else self.motor
        if callable(motor):
            assert attitude is not None, "a motor by a function needs the attitude"
            motor = motor(t, attitude, angular_velocity, own[..., 0], rate[..., 0])
        return (motor - self.damping * rate[..., 0])[..., None]


def rotate_about(
    axis: Float64[Array, "3"], angle: Float64[Array, "*batch 1"], vector: Float64[Array, "3"]
) -> Float64[Array, "*batch 3"]:
    """Return a vector rotated about an axis by an angle (…, 1), by Rodrigues' formula."""
    along = axis * jnp.dot(axis, vector)
    return along + jnp.cos(angle) * (vector - along) + jnp.sin(angle) * jnp.cross(axis, vector)


def turn_tensor(
    axis: Float64[Array, "3"], angle: Float64[Array, "*batch 1"], tensor: Float64[Array, "3 3"]
) -> Float64[Array, "*batch 3 3"]:
    """Return R I Rᵀ of the turn about an axis by an angle (…, 1)."""
    x, y, z = axis
    hat = jnp.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    outer = jnp.outer(axis, jnp.asarray(axis))
    sine, cosine = jnp.sin(angle)[..., None], jnp.cos(angle)[..., None]
    turn = outer + cosine * (jnp.eye(3) - outer) + sine * hat
    return turn @ tensor @ jnp.swapaxes(turn, -1, -2)
