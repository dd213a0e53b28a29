"""The tables of a spec and their fields; rules between fields are in ``rules``."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from typing import Annotated, Any, ClassVar, Literal

from pydantic import BaseModel, BeforeValidator, ConfigDict, Field, PrivateAttr, create_model, model_validator

from polhode.spec.body_files import body_file_keys, reserve_keys
from polhode.spec.export import ExportTable
from polhode.spec.fields import (
    Angle,
    Attitude,
    Density,
    Digits,
    Duration,
    Flag,
    Inertia,
    Joints,
    Length,
    Lengths,
    Mass,
    MeshUnit,
    Moments,
    Momentum,
    Outline,
    Position,
    Precession,
    Radius,
    Rate,
    Rates,
    RotationalConstants,
    Samples,
    Sides,
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
    "capsule": ("radius", "length"),
    "prism": ("height",),
    "point": (),
}
MAY_HAVE: dict[str, tuple[str, ...]] = {
    "cylinder": ("inner_radius", "shell", "thickness", "open_ends"),
    "sphere": ("inner_radius", "shell", "thickness"),
    "disk": ("inner_radius",),
    "box": ("shell", "thickness"),
    "prism": ("sides", "radius", "outline"),
}
"""Optional keys of a shape."""
WITHOUT_VOLUME = ("disk", "rod", "point")
PART_SOURCES = ("shape", "mesh", "spec", "inertia")
Shape = Annotated[str, one_of(*SHAPE_KEYS)]
PartAxis = Annotated[Literal["x", "y", "z", "-x", "-y", "-z"], one_of("x", "y", "z", "-x", "-y", "-z")]
LOOK_SOURCES: dict[str, tuple[str, ...]] = {
    "book": ("part",),
    "phone": ("part",),
    "earth": ("moments",),
    "metal": ("mesh", "part"),
    "gyroscope": ("part",),
    "satellite": ("part",),
    "rocket": ("part",),
    "top": ("part",),
}
ONE_PART = {"book": "box", "phone": "box", "rocket": "cylinder"}  # of that shape, which these looks paint
BodyLook = Annotated[str, one_of(*LOOK_SOURCES)]
Axis = Annotated[Literal[1, 2, 3, "x", "y", "z"], one_of(1, 2, 3, "x", "y", "z")]


class Strict(BaseModel):
    """A table of the spec: unknown keys are errors."""

    model_config = ConfigDict(extra="forbid")


class PartTable(Strict):
    """One part of a body: exactly one of the keys ``PART_SOURCES``, in its place.

    ``at`` is the place of its own origin: the centre of mass of a shape, the origin of a file or of an outline.
    ``attitude`` or ``axis`` turn its own axes.
    """

    name: str | None = None
    shape: Shape | None = None
    mesh: str | None = None
    mesh_unit: MeshUnit | None = None
    repair: Flag = False
    several: Flag = False
    spec: str | None = None
    inertia: Inertia | None = None
    about: Position | None = None
    center_of_mass: Position | None = None
    rounding: Digits | None = None
    mass: Mass | None = None
    density: Density | None = None
    cut: Flag = False
    at: Position = (0.0, 0.0, 0.0)
    axis: PartAxis = "z"
    attitude: Attitude | None = None
    size: Lengths | None = None
    semi_axes: Lengths | None = None
    radius: Radius | None = None
    inner_radius: Length | None = None
    height: Length | None = None
    length: Length | None = None
    major_radius: Length | None = None
    minor_radius: Length | None = None
    sides: Sides | None = None
    outline: Outline | None = None
    shell: Flag = False
    thickness: Length | None = None
    open_ends: Flag = False

    @property
    def is_shell(self) -> bool:
        """Whether its material lies in a wall along its surface."""
        return self.shell or self.thickness is not None


def _as_list(value: object) -> object:
    if isinstance(value, dict):
        raise ValueError("must be a list of tables: begin each part with [[body.part]], in double brackets")
    return value


class BodyTable(Strict):
    """Where the body comes from: exactly one of the keys that ``rules.body_sources`` lists.

    Besides the fields there is a key for each format of files that hold a body; ``file`` has such a key and its file.
    """

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
    center_of_mass: Position | None = None
    about: Position | None = None
    rounding: Digits | None = None
    part: Annotated[list[PartTable], Field(min_length=1), BeforeValidator(_as_list)] | None = None
    molecule: str | None = None
    link: str | None = None
    joints: Joints | None = None
    look: BodyLook | None = None
    _file: tuple[str, str] | None = PrivateAttr(None)

    @model_validator(mode="wrap")
    @classmethod
    def _take_file(cls, value: Any, handler: Callable[[Any], BodyTable]) -> BodyTable:
        keys = body_file_keys()
        if cls is not BodyTable or not isinstance(value, dict) or not set(keys) & value.keys():
            return handler(value)
        checked = _with_keys(keys).model_validate(value)  # so that a mistake in a file's name has its place too
        fields = {name: getattr(checked, name) for name in BodyTable.model_fields}
        table = BodyTable.model_construct(checked.model_fields_set & fields.keys(), **fields)
        named = ((key, getattr(checked, key)) for key in keys)
        table._file = next(((key, name) for key, name in named if name is not None), None)
        return table

    @property
    def file(self) -> tuple[str, str] | None:
        """The key of the format of a file that holds the body, and the file; None where it comes from elsewhere."""
        return self._file

    @property
    def is_molecule(self) -> bool:
        """Whether it is a molecule, given by atoms or by rotational constants."""
        return self.molecule is not None or self.rotational_constants is not None


reserve_keys(BodyTable.model_fields)


@cache
def _with_keys(keys: tuple[str, ...]) -> type[BodyTable]:
    files: dict[str, Any] = {key: (str | None, None) for key in keys}
    return create_model("BodyTable", __base__=BodyTable, **files)


def known_keys(model: type[BaseModel]) -> list[str]:
    """Return the keys of a table."""
    keys = list(model.model_fields)
    if model is BodyTable:
        keys[keys.index("link") : keys.index("link")] = body_file_keys()
    return keys


class SpinTable(Strict):
    """How the body spins at the start: exactly one of angular_velocity, momentum, rate and temperature.

    Of a top it may be the rates of its Euler angles instead: spin, precession and nutation_rate; of a free symmetric
    body two of spin, precession and nutation, the angle between its axis and the momentum.
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
    nutation: Angle | None = None
    attitude: Attitude = (1.0, 0.0, 0.0, 0.0)

    @property
    def is_of_a_top(self) -> bool:
        """Whether it gives the rates of a top's Euler angles."""
        return any(rate is not None for rate in (self.spin, self.precession, self.nutation_rate))

    @property
    def is_of_a_cone(self) -> bool:
        """Whether it gives the steady coning of a free symmetric body, where the system takes that."""
        return self.is_of_a_top or self.nutation is not None


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
        cones: whether [spin] may give two of spin, precession and nutation, as of a free symmetric body.
        beside: fields that a file gives as tables of their own at the top, not inside [system].
    """

    takes: ClassVar[tuple[str, ...]] = ("body", "spin", "time")
    needs: ClassVar[tuple[str, ...]] = ("body",)
    leans: ClassVar[bool] = False
    cones: ClassVar[bool] = False
    beside: ClassVar[tuple[str, ...]] = ()
    kind: str


class SpecFile(Strict):
    """The whole file."""

    name: str | None = None
    body: BodyTable | None = None
    spin: SpinTable | None = None
    time: TimeTable = TimeTable()
    export: ExportTable = ExportTable()
