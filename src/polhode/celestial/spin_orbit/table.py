"""The table [system] of a moon or planet that turns on its orbit."""

from __future__ import annotations

from typing import ClassVar

from pydantic import Field

from polhode.spec.fields import (
    Angle,
    Asphericity,
    Duration,
    Eccentricity,
    GravitationalParameter,
    Length,
    Orbits,
    SpinRatio,
)
from polhode.spec.models import SystemTable


class SpinOrbitTable(SystemTable):
    """A moon or planet that turns upright on an eccentric orbit; its shape from [body] or by ``asphericity``."""

    takes: ClassVar[tuple[str, ...]] = ("body", "time")
    needs: ClassVar[tuple[str, ...]] = ()  # the asphericity takes the place of a body
    eccentricity: Eccentricity = Field(description="give it like 0.1, zero for a circle")
    orbital_period: Duration | None = None
    semi_major_axis: Length | None = None
    gravitational_parameter: GravitationalParameter | None = None
    asphericity: Asphericity | None = None
    angle: Angle = 0.0
    spin_ratio: SpinRatio = 1.0
    section_orbits: Orbits = 300
