"""The tables of a spec and their fields; rules between fields are in ``rules``."""

from __future__ import annotations

from typing import Annotated, ClassVar, Literal

from pydantic import BaseModel, ConfigDict, Field

from polhode.spec.export import ExportTable
from polhode.spec.fields import (
    Angle,
    Attitude,
    Density,
    Duration,
    Flag,
    Inertia,
    Length,
    Lengths,
    Mass,
    MeshUnit,
    Moments,
    Momentum,
    Position,
    Precession,
    Rate,
    Rates,
    RotationalConstants,
    Samples,
    Temperature,
    one_of,
)

SHAPE_KEYS: dict[str, tuple[str, ...]] = {
    "box": ("size",),
    "cylinder": ("radius", "height"),
    "ellipsoid": ("semi_axes",),
    "sphere": ("radius",),
    "cone": ("radius", "height"),
    "disk": ("radius",),
    "rod": ("length",),
    "torus": ("major_radius", "minor_radius"),
}
MAY_BE_HOLLOW = ("cylinder", "sphere", "disk")
Shape = Annotated[str, one_of(*SHAPE_KEYS)]
PartAxis = Annotated[Literal["x", "y", "z", "-x", "-y", "-z"], one_of("x", "y", "z", "-x", "-y", "-z")]
LOOK_SOURCES: dict[str, tuple[str, ...]] = {
    "book": ("parts",),
    "phone": ("parts",),
    "earth": ("moments",),
    "metal": ("mesh", "parts"),
    "gyroscope": ("parts",),
    "satellite": ("parts",),
    "rocket": ("parts",),
    "top": ("parts",),
}
ONE_PART = {"book": "box", "phone": "box", "rocket": "cylinder"}  # of that shape, which these looks paint
BodyLook = Annotated[str, one_of(*LOOK_SOURCES)]
Axis = Annotated[Literal[1, 2, 3, "x", "y", "z"], one_of(1, 2, 3, "x", "y", "z")]


class Strict(BaseModel):
    """A table of the spec: unknown keys are errors."""

    model_config = ConfigDict(extra="forbid")


class PartTable(Strict):
    """One homogeneous part; ``at`` is its centre of mass, ``axis`` where its own z axis points."""

    shape: Shape = Field(description='give it like "box"')
    mass: Mass = Field(description='give it like "30 g"')
    at: Position = (0.0, 0.0, 0.0)
    axis: PartAxis = "z"
    size: Lengths | None = None
    semi_axes: Lengths | None = None
    radius: Length | None = None
    inner_radius: Length | None = None
    height: Length | None = None
    length: Length | None = None
    major_radius: Length | None = None
    minor_radius: Length | None = None


class BodyTable(Strict):
    """Where the body comes from: exactly one of the keys that ``rules.SOURCES`` lists."""

    mesh: str | None = None
    mesh_unit: MeshUnit | None = None
    repair: Flag = False
    several: Flag = False
    density: Density | None = None
    mass: Mass | None = None
    moments: Moments | None = None
    inertia: Inertia | None = None
    rotational_constants: RotationalConstants | None = None
    allow_vibration: Flag = False
    parts: Annotated[list[PartTable], Field(min_length=1)] | None = None
    molecule: str | None = None
    urdf: str | None = None
    link: str | None = None
    look: BodyLook | None = None

    @property
    def is_molecule(self) -> bool:
        """Whether it is a molecule, given by atoms or by rotational constants."""
        return self.molecule is not None or self.rotational_constants is not None


class SpinTable(Strict):
    """How the body spins at the start: exactly one of angular_velocity, momentum, rate and temperature.

    Of a top it may be the rates of its Euler angles instead: spin, precession and nutation_rate.
    """

    angular_velocity: Rates | None = None
    momentum: Momentum | None = None
    frame: Annotated[Literal["given", "principal"], one_of("given", "principal")] = "given"
    rate: Rate | None = None
    about: Axis | None = None
    tilt: Angle = 0.0
    temperature: Temperature | None = None
    spin: Rate | None = None
    precession: Precession | None = None
    nutation_rate: Rate | None = None
    attitude: Attitude = (1.0, 0.0, 0.0, 0.0)

    @property
    def is_of_a_top(self) -> bool:
        """Whether it gives the rates of a top's Euler angles."""
        return any(rate is not None for rate in (self.spin, self.precession, self.nutation_rate))


class TimeTable(Strict):
    """The times of samples, from zero on."""

    until: Duration | None = None
    samples: Samples = 2000


class SystemTable(Strict):
    """Base of the table [system] of every kind.

    Attributes:
        takes: the other tables that go with it.
        needs: those of them that are required.
        leans: whether [spin] may give spin, precession and nutation_rate.
        beside: fields that a file gives as tables of their own at the top, not inside [system].
    """

    takes: ClassVar[tuple[str, ...]] = ("body", "spin", "time")
    needs: ClassVar[tuple[str, ...]] = ("body",)
    leans: ClassVar[bool] = False
    beside: ClassVar[tuple[str, ...]] = ()
    kind: str


class SpecFile(Strict):
    """The whole file."""

    name: str | None = None
    body: BodyTable | None = None
    spin: SpinTable | None = None
    time: TimeTable = TimeTable()
    export: ExportTable = ExportTable()
