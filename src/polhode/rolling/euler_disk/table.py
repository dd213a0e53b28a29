"""The table [system] of a rolling disk."""

from __future__ import annotations

from typing import ClassVar

from pydantic import Field

from polhode.bodies._pivot import STANDARD_GRAVITY
from polhode.rolling.euler_disk.laws import LawTable
from polhode.spec.fields import Acceleration, Angle, Length, Mass, PositiveMoment, Rate, Thickness, Tilt, Velocity
from polhode.spec.models import SystemTable


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
    needs: ClassVar[tuple[str, ...]] = ()
    mass: Mass = Field(description='give it like "30 g"')
    radius: Length = Field(description='give it like "38 mm"')
    thickness: Thickness = 0.0
    axial_moment: PositiveMoment | None = None
    diametral_moment: PositiveMoment | None = None
    gravity: Acceleration = STANDARD_GRAVITY
    tilt: Tilt = Field(description='give it like "10 deg"')
    heading: Angle = 0.0
    precession: Rate | None = None
    spin: Rate | None = None
    tilt_rate: Rate | None = None
    center_velocity: Velocity | None = None
    # each law is compiled, and hundreds took minutes
    dissipation: list[LawTable] = Field(default_factory=list, max_length=20)
