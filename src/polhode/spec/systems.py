"""The table [system] of a spec, one model for each kind."""

from __future__ import annotations

from typing import Annotated, ClassVar, Literal

from pydantic import Field

from polhode.spec.dissipation import LawTable
from polhode.spec.fields import (
    Acceleration,
    Angle,
    Asphericity,
    Direction,
    Duration,
    Eccentricity,
    GravitationalParameter,
    Lean,
    Length,
    LinearDragCoefficient,
    Mass,
    Orbits,
    Position,
    PositiveMoment,
    PositivePlain,
    QuadraticDragCoefficient,
    Rate,
    SpinRatio,
    Thickness,
    Tilt,
    Torque,
    Velocity,
    one_of,
)
from polhode.spec.models import Strict

STANDARD_GRAVITY = 9.80665  # m/s²
Order = Annotated[Literal[2, 4, 6, 8], one_of(2, 4, 6, 8)]


class SystemTable(Strict):
    """What every kind has.

    Attributes:
        takes: the other tables that go with it.
    """

    takes: ClassVar[tuple[str, ...]] = ("body", "spin", "time")
    kind: str


class HeavyTopTable(SystemTable):
    """A body that turns about a fixed point under its weight, any shape."""

    pivot: Position
    gravity: Acceleration = STANDARD_GRAVITY
    lean: Lean | None = None
    step: Duration | None = None
    order: Order = 8


class LagrangeTopTable(SystemTable):
    """A symmetric body that turns about a point of its axis under its weight, exactly."""

    pivot: Position
    gravity: Acceleration = STANDARD_GRAVITY
    lean: Lean | None = None


class GyrostatTable(SystemTable):
    """A body with a rotor inside; the body's inertia includes the rotor's.

    Attributes:
        rotor_axis: in the given axes, of any length.
        rotor_rate: relative to the body.
        rotor_drive: free beside a motor torque and constant-rate otherwise, where it is left out.
    """

    rotor_axis: Direction
    rotor_moment: PositiveMoment
    rotor_rate: Rate
    rotor_drive: Annotated[Literal["constant-rate", "free"], one_of("constant-rate", "free")] | None = None
    motor_torque: Torque | None = None
    step: Duration | None = None


class DampedBodyTable(SystemTable):
    """A body that loses energy, inside or by drag.

    Attributes:
        damping: α |L| of the double bracket.
    """

    damping: PositivePlain | None = None
    linear_drag: LinearDragCoefficient | None = None
    quadratic_drag: QuadraticDragCoefficient | None = None
    orbital_period: Duration | None = None
    eccentricity: Eccentricity | None = None


class SpinOrbitTable(SystemTable):
    """A moon or planet that turns upright on an eccentric orbit; its shape from [body] or by ``asphericity``."""

    takes: ClassVar[tuple[str, ...]] = ("body", "time")
    eccentricity: Eccentricity
    orbital_period: Duration | None = None
    semi_major_axis: Length | None = None
    gravitational_parameter: GravitationalParameter | None = None
    asphericity: Asphericity | None = None
    angle: Angle = 0.0
    spin_ratio: SpinRatio = 1.0
    section_orbits: Orbits = 300


class EulerDiskTable(SystemTable):
    """A disk that rolls on a plane; it starts in steady motion unless ``tilt_rate`` is given.

    Attributes:
        tilt: between face and plane.
        heading: of the horizontal diameter.
        precession: of the contact; by default that at which the centre is at rest.
        spin: about the axis; follows from precession.
        center_velocity: along space axes; checked against rolling.
    """

    takes: ClassVar[tuple[str, ...]] = ("time",)
    mass: Mass
    radius: Length
    thickness: Thickness = 0.0
    axial_moment: PositiveMoment | None = None
    diametral_moment: PositiveMoment | None = None
    gravity: Acceleration = STANDARD_GRAVITY
    tilt: Tilt
    heading: Angle = 0.0
    precession: Rate | None = None
    spin: Rate | None = None
    tilt_rate: Rate | None = None
    center_velocity: Velocity | None = None
    dissipation: list[LawTable] = Field(default_factory=list)


SYSTEMS: dict[str, type[SystemTable]] = {
    "heavy-top": HeavyTopTable,
    "lagrange-top": LagrangeTopTable,
    "gyrostat": GyrostatTable,
    "damped-body": DampedBodyTable,
    "spin-orbit": SpinOrbitTable,
    "euler-disk": EulerDiskTable,
}
