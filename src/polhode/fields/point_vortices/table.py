"""The table [system] of point vortices."""

from __future__ import annotations

from typing import Annotated, ClassVar, NamedTuple

from pydantic import Field

from polhode.spec.fields import Angle, Circulation, Coordinate, Latitude, Length
from polhode.spec.models import SystemTable


class VorticesTableLimits(NamedTuple):
    """What the table accepts.

    Attributes:
        max_vortices: a step goes over all pairs.
    """

    max_vortices: int = 2000


LIMITS = VorticesTableLimits()
Place = tuple[Coordinate, Coordinate]
LatitudeAndLongitude = tuple[Latitude, Angle]


class VorticesTable(SystemTable):
    """Circulations and places: in a plane ``positions`` or ``ring_radius``, on a sphere the others."""

    takes: ClassVar[tuple[str, ...]] = ("time",)
    needs: ClassVar[tuple[str, ...]] = ()
    strengths: Annotated[list[Circulation], Field(min_length=2, max_length=LIMITS.max_vortices)] = Field(
        description='give circulations like ["1 m^2/s", "1 m^2/s"]'
    )
    positions: list[Place] | None = None
    ring_radius: Length | None = None
    coordinates: list[LatitudeAndLongitude] | None = None
    ring_latitude: Latitude | None = None
    sphere_radius: Length | None = None
