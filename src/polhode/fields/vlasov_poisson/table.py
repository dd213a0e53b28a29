"""The table [system] of a plasma."""

from __future__ import annotations

from typing import Annotated, ClassVar

from pydantic import AfterValidator, Field, StrictInt

from polhode.spec.fields import Plain, PositivePlain, not_zero, within
from polhode.spec.models import Strict, SystemTable

Disturbance = Annotated[Plain, AfterValidator(within(-0.99, 0.99, "a share of the density")),
                        AfterValidator(not_zero)]
Wavenumber = Annotated[Plain, AfterValidator(within(1e-3, 10.0, "in inverse Debye lengths"))]
Step = Annotated[Plain, AfterValidator(within(1e-6, 1.0, "a fraction of a plasma oscillation"))]


class BeamTable(Strict):
    """A Maxwellian share of the electrons, in thermal speeds."""

    share: PositivePlain = 1.0
    drift: Plain = 0.0
    spread: PositivePlain = 1.0


class PlasmaTable(SystemTable):
    """Electrons before a background at rest, in Debye lengths, thermal speeds and inverse plasma frequencies."""

    takes: ClassVar[tuple[str, ...]] = ("time",)
    needs: ClassVar[tuple[str, ...]] = ()
    wavenumber: Wavenumber = Field(
        description="give that of the box's longest wave, in inverse Debye lengths, like 0.5"
    )
    amplitude: Disturbance = Field(description="give the density's share that is moved, like 0.01")
    beams: Annotated[list[BeamTable], Field(min_length=1)] | None = None
    modes: Annotated[StrictInt, Field(ge=1, le=256)] = 4
    velocities: Annotated[StrictInt, Field(ge=8, le=4096)] = 256
    particles_per_velocity: Annotated[StrictInt, Field(ge=2, le=4096)] = 32
    fastest: PositivePlain | None = None
    step: Step = 0.1
