"""The table [system] of a conducting fluid on a sphere."""

from __future__ import annotations

from typing import Annotated, ClassVar, Literal

from pydantic import AfterValidator, Field, StrictInt

from polhode.fields.sphere.start import Degrees, Harmonic, RandomTable, WaveTable
from polhode.spec.fields import PositiveRate, Rate, not_zero
from polhode.spec.models import SystemTable


class RandomFieldTable(Degrees):
    """A random magnetic field."""

    field: PositiveRate = Field(
        description='give the root mean square of its Alfvén speed, in radii per second, like "0.3 rad/s"'
    )


class FieldWaveTable(Harmonic):
    """A wave of the field's potential; of order zero a field along circles of latitude."""

    field: Annotated[Rate, AfterValidator(not_zero)] = Field(
        description='give the root mean square of its Alfvén speed, in radii per second, like "0.3 rad/s"'
    )


class AlfvenWaveTable(Harmonic):
    """The exact wave of any height on a fluid that turns rigidly, in a field that a rigid turn would carry along."""

    vorticity: Annotated[Rate, AfterValidator(not_zero)] = Field(
        description='give the root mean square of the wave over the sphere, like "1 rad/s"'
    )
    turning: Rate = 0.0
    field: Annotated[Rate, AfterValidator(not_zero)] = Field(
        description='give the Alfvén speed at the equator, in radii per second, like "0.6 rad/s"'
    )
    branch: Literal["eastward", "westward"] = "eastward"


class MagneticFluidTable(SystemTable):
    """Resolution, sphere, and vorticity and field at the start, the sum of all that is given."""

    takes: ClassVar[tuple[str, ...]] = ("time",)
    needs: ClassVar[tuple[str, ...]] = ()
    resolution: Annotated[StrictInt, Field(ge=4, le=256)] = Field(
        description="give the size of the matrices, like 48, up to 256: harmonics of lower degree are resolved"
    )
    rotation: Rate = 0.0
    random: RandomTable | None = None
    waves: Annotated[list[WaveTable], Field(min_length=1)] | None = None
    random_field: RandomFieldTable | None = None
    field_waves: Annotated[list[FieldWaveTable], Field(min_length=1)] | None = None
    alfven_wave: AlfvenWaveTable | None = None
    start_from: str | None = None
