"""What a spec may say: pydantic models that turn quantities to SI and collect every mistake in one pass."""

from __future__ import annotations

from typing import Annotated, Any, Literal

from pydantic import BaseModel, BeforeValidator, ConfigDict, Field, model_validator

from polhode.spec.units import parse_quantity


def _reader(unit: str, positive: bool = False) -> BeforeValidator:
    def read(value: Any) -> float:
        number = parse_quantity(value, unit)
        if positive and not number > 0:
            raise ValueError(f"must be positive; got {value!r}")
        return number

    return BeforeValidator(read)


Mass = Annotated[float, _reader("kg", positive=True)]
Density = Annotated[float, _reader("kg/m^3", positive=True)]
Length = Annotated[float, _reader("m", positive=True)]
Position = Annotated[float, _reader("m")]
Moment = Annotated[float, _reader("kg*m^2")]
Momentum = Annotated[float, _reader("kg*m^2/s")]
Rate = Annotated[float, _reader("rad/s")]
Angle = Annotated[float, _reader("rad")]
Time = Annotated[float, _reader("s")]
Row = tuple[Moment, Moment, Moment]


def _mesh_unit(value: Any) -> float:
    if not isinstance(value, str):
        raise ValueError(f'must be a unit of length in quotes, like "mm"; got {value!r}')
    text = value if any(c.isdigit() for c in value) else f"1 {value}"
    number = parse_quantity(text, "m")
    if not number > 0:
        raise ValueError(f"must be a positive length; got {value!r}")
    return number


class Strict(BaseModel):
    """A table of the spec: unknown keys are errors."""

    model_config = ConfigDict(extra="forbid")


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


class PartTable(Strict):
    """One homogeneous part; ``at`` is its centre of mass, ``axis`` where its own z axis points."""

    shape: Literal["box", "cylinder", "ellipsoid", "sphere", "cone", "disk", "rod", "torus"]
    mass: Mass
    at: tuple[Position, Position, Position] = (0.0, 0.0, 0.0)
    axis: Literal["x", "y", "z"] = "z"
    size: tuple[Length, Length, Length] | None = None
    semi_axes: tuple[Length, Length, Length] | None = None
    radius: Length | None = None
    inner_radius: Length | None = None
    height: Length | None = None
    length: Length | None = None
    major_radius: Length | None = None
    minor_radius: Length | None = None

    @model_validator(mode="after")
    def _right_measures(self) -> PartTable:
        needed = SHAPE_KEYS[self.shape]
        allowed = {*needed, *(("inner_radius",) if self.shape in MAY_BE_HOLLOW else ())}
        measures = {k for keys in SHAPE_KEYS.values() for k in keys} | {"inner_radius"}
        given = {name for name in measures if getattr(self, name) is not None}
        if missing := [name for name in needed if name not in given]:
            raise ValueError(f"a {self.shape} needs {' and '.join(missing)}")
        if extra := sorted(given - allowed):
            raise ValueError(f"a {self.shape} has no {' or '.join(extra)}; it takes {', '.join(needed)}")
        return self


class BodyTable(Strict):
    """Where the body comes from: exactly one of mesh, moments, inertia, parts and molecule."""

    mesh: str | None = None
    mesh_unit: Annotated[float, BeforeValidator(_mesh_unit)] | None = None
    repair: bool = False
    several: bool = False
    density: Density | None = None
    mass: Mass | None = None
    moments: tuple[Moment, Moment, Moment] | None = None
    inertia: tuple[Row, Row, Row] | None = None
    parts: Annotated[list[PartTable], Field(min_length=1)] | None = None
    molecule: str | None = None

    @model_validator(mode="after")
    def _one_source(self) -> BodyTable:
        sources = [k for k in ("mesh", "moments", "inertia", "parts", "molecule") if getattr(self, k) is not None]
        if len(sources) != 1:
            got = " and ".join(sources) or "none"
            raise ValueError(f"needs exactly one of mesh, moments, inertia, parts and molecule; got {got}")
        if self.mesh is not None:
            if self.mesh_unit is None:
                raise ValueError('needs mesh_unit, like "mm": mesh files carry no units')
            if (self.mass is None) == (self.density is None):
                raise ValueError("needs exactly one of mass and density beside a mesh")
            return self
        only_mesh = {"mesh_unit": self.mesh_unit, "density": self.density, "repair": self.repair or None,
                     "several": self.several or None}  # fmt: skip
        if extra := [name for name, value in only_mesh.items() if value is not None]:
            raise ValueError(f"{' and '.join(extra)} goes with a mesh, not with {sources[0]}")
        if self.mass is not None and sources[0] in ("parts", "molecule"):
            raise ValueError(f"mass follows from the {sources[0]}; leave it out")
        return self


class SpinTable(Strict):
    """How the body spins at the start: exactly one of angular_velocity, momentum and rate."""

    angular_velocity: tuple[Rate, Rate, Rate] | None = None
    momentum: tuple[Momentum, Momentum, Momentum] | None = None
    frame: Literal["given", "principal"] = "given"
    rate: Rate | None = None
    about: Literal[1, 2, 3, "x", "y", "z"] | None = None
    tilt: Angle = 0.0
    attitude: tuple[float, float, float, float] = (1.0, 0.0, 0.0, 0.0)

    @model_validator(mode="after")
    def _one_way(self) -> SpinTable:
        ways = [k for k in ("angular_velocity", "momentum", "rate") if getattr(self, k) is not None]
        if len(ways) != 1:
            got = " and ".join(ways) or "none"
            raise ValueError(f"needs exactly one of angular_velocity, momentum and rate; got {got}")
        if ways[0] == "rate":
            if self.about is None:
                raise ValueError('rate needs about = 1, 2 or 3 (principal axis) or "x", "y", "z" (given axis)')
            if "frame" in self.model_fields_set:
                raise ValueError("frame goes with components; about already says which axis")
            if self.rate == 0.0 and "tilt" in self.model_fields_set:
                raise ValueError("a spin of zero has no direction to tilt; give a rate, or leave tilt out")
        elif self.about is not None or "tilt" in self.model_fields_set:
            raise ValueError(f"about and tilt go with rate, not with {ways[0]}")
        return self


class TimeTable(Strict):
    """When to sample, from zero on."""

    until: Time | None = None
    samples: Annotated[int, Field(ge=2, le=10_000_000)] = 2000

    @model_validator(mode="after")
    def _forward(self) -> TimeTable:
        if self.until is not None and not self.until > 0:
            raise ValueError(f"until must be positive; got {self.until:g} s")
        return self


class SpecFile(Strict):
    """The whole file."""

    name: str | None = None
    body: BodyTable
    spin: SpinTable | None = None
    time: TimeTable = TimeTable()
