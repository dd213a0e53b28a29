"""The table [system] of an ideal fluid on a sphere."""

from __future__ import annotations

from typing import Annotated, ClassVar

from pydantic import AfterValidator, Field, StrictInt

from polhode.spec.fields import Angle, Circulation, Latitude, Length, PositiveRate, Rate, not_zero
from polhode.spec.models import Strict, SystemTable

Degree = Annotated[StrictInt, Field(ge=1, le=511)]


class RandomTable(Strict):
    """Random phases, with the same energy in each of the degrees from the first to the last."""

    degrees: tuple[Degree, Degree] = Field(description="give the first and the last degree, like [4, 8]")
    vorticity: PositiveRate = Field(description='give the root mean square over the sphere, like "1 rad/s"')
    seed: Annotated[StrictInt, Field(ge=0, le=2**63)] = 1


class VortexTable(Strict):
    """The smallest vortex that the resolution has room for."""

    strength: Circulation = Field(description='give the circulation, like "1 m^2/s"')
    latitude: Latitude = Field(description='give it like "45 deg"')
    longitude: Angle = 0.0


class WaveTable(Strict):
    """One spherical harmonic; of order zero a zonal flow."""

    degree: Degree = Field(description="give it like 4")
    order: Annotated[StrictInt, Field(ge=0, le=511)] = Field(description="give it like 3; zero is a zonal flow")
    vorticity: Annotated[Rate, AfterValidator(not_zero)] = Field(
        description='give the root mean square over the sphere, like "1 rad/s"'
    )
    longitude: Angle = 0.0


class FluidTable(SystemTable):
    """How finely, on which sphere, and the vorticity at the start: the sum of what is given."""

    takes: ClassVar[tuple[str, ...]] = ("time",)
    needs: ClassVar[tuple[str, ...]] = ()
    resolution: Annotated[StrictInt, Field(ge=4, le=512)] = Field(
        description="give the size of the matrices, like 64, up to 512: harmonics of lower degree are resolved"
    )
    radius: Length = 1.0
    rotation: Rate = 0.0
    random: RandomTable | None = None
    vortices: Annotated[list[VortexTable], Field(min_length=1)] | None = None
    waves: Annotated[list[WaveTable], Field(min_length=1)] | None = None
    start_from: str | None = None
