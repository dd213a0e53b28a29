"""The table [system] of an ideal fluid on a sphere."""

from __future__ import annotations

from typing import Annotated, ClassVar

from pydantic import Field, StrictInt

from polhode.fields.sphere.start import RandomTable, VortexTable, WaveTable
from polhode.spec.fields import Length, Rate
from polhode.spec.models import SystemTable


class FluidTable(SystemTable):
    """Resolution, sphere, and the vorticity at the start, the sum of all that is given."""

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
