"""From a TOML file to a body, its spin and the times asked for."""

from __future__ import annotations

import difflib
import math
import tomllib
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from pydantic import BaseModel, ValidationError

from polhode import rotation
from polhode.bodies import shapes
from polhode.bodies.atoms import from_atoms
from polhode.bodies.body import Body, combine
from polhode.bodies.mesh import from_mesh
from polhode.errors import FormatError, InvalidInput
from polhode.formats.mesh import read_mesh
from polhode.formats.molecule import read_molecule
from polhode.spec.models import SHAPE_KEYS, BodyTable, PartTable, SpecFile, SpinTable

Array = Any


@dataclass(frozen=True)
class Spec:
    """A spec in SI units.

    Attributes:
        name: what to call the body.
        body: its mass properties.
        momentum: (3,) at time zero [kg m²/s, principal axes]; zero where the file has no spin.
        attitude: (4,) wxyz, principal axes → space, at time zero.
        until: end of the samples [s], None for the report's own choice.
        samples: how many.
    """

    name: str
    body: Body
    momentum: Array
    attitude: Array
    until: float | None
    samples: int


def read_spec(path: str | Path) -> Spec:
    """Read a spec; every mistake in it is reported at once.

    Raises:
        InvalidInput: naming the file and, for each mistake, the key, the rule and what came.
        FormatError: if the file is not TOML.
    """
    path = Path(path)
    try:
        with path.open("rb") as file:
            table = tomllib.load(file)
    except OSError as error:
        raise InvalidInput(f"{path}: cannot be read ({error.strerror}). Check the path.") from None
    except (tomllib.TOMLDecodeError, UnicodeDecodeError) as error:
        raise FormatError(f"{path}: is not TOML ({error}). Values with units stand in quotes.") from None
    try:
        model = SpecFile.model_validate(table)
    except ValidationError as error:
        raise InvalidInput(_all_mistakes(path, error)) from None
    try:
        body = _body(model.body, path.parent)
        momentum, attitude = _spin(model.spin, body)
    except InvalidInput as error:
        raise type(error)(f"{path}: {error}") from None
    return Spec(model.name or path.stem, body, momentum, attitude, model.time.until, model.time.samples)


def _all_mistakes(path: Path, error: ValidationError) -> str:
    lines = [f"  {_key(mistake['loc'])}: {_said(mistake)}" for mistake in error.errors()]
    lines = list(dict.fromkeys(lines))
    count = "1 mistake" if len(lines) == 1 else f"{len(lines)} mistakes"
    return "\n".join([f"{path} has {count}:", *lines])


def _key(location: tuple[int | str, ...]) -> str:
    text = ""
    for part in location:
        text += f"[{part}]" if isinstance(part, int) else (f".{part}" if text else str(part))
    return text or "the file"


def _said(mistake: Any) -> str:
    if mistake["type"] == "extra_forbidden":
        known = _keys_at(mistake["loc"][:-1])
        near = difflib.get_close_matches(str(mistake["loc"][-1]), known, n=1)
        return "unknown key; " + (f"did you mean {near[0]}?" if near else f"known here are {', '.join(known)}")
    if mistake["type"] == "missing":
        return "is missing"
    message = mistake["msg"].removeprefix("Value error, ")
    if mistake["type"] in ("value_error", "assertion_error"):
        return message
    return f"{message[0].lower()}{message[1:]}; got {mistake['input']!r}"


def _keys_at(location: tuple[int | str, ...]) -> list[str]:
    model: type[BaseModel] = SpecFile
    tables: dict[str, type[BaseModel]] = {"body": BodyTable, "spin": SpinTable, "parts": PartTable}
    for part in location:
        if isinstance(part, str):
            model = tables.get(part) or type(SpecFile.model_fields[part].default)
    return list(model.model_fields)


def _body(table: BodyTable, folder: Path) -> Body:
    if table.mesh is not None:
        vertices, faces = read_mesh(folder / table.mesh, table.mesh_unit or 1.0, table.repair)
        try:
            return from_mesh(vertices, faces, mass=table.mass, density=table.density, several=table.several)
        except InvalidInput as error:
            raise InvalidInput(f"body.mesh {table.mesh}: {error}") from None
    if table.moments is not None:
        return Body.from_moments(*table.moments, mass=table.mass)
    if table.inertia is not None:
        return Body(table.mass, (0.0, 0.0, 0.0), table.inertia)
    if table.molecule is not None:
        return from_atoms(*read_molecule(folder / table.molecule))
    return combine([_part(part) for part in table.parts or []])


_TURNS = {"z": np.eye(3), "x": np.eye(3)[[2, 0, 1]], "y": np.eye(3)[[1, 2, 0]]}


def _part(table: PartTable) -> Body:
    measures = {name: getattr(table, name) for name in SHAPE_KEYS[table.shape]}
    if table.inner_radius is not None:
        measures["inner_radius"] = table.inner_radius
    return getattr(shapes, table.shape)(table.mass, **measures).placed(_TURNS[table.axis], table.at)


def _spin(table: SpinTable | None, body: Body) -> tuple[Array, Array]:
    """Return momentum along and attitude of the principal axes."""
    axes, moments = body.principal_axes, body.principal_moments
    given = (1.0, 0.0, 0.0, 0.0) if table is None else table.attitude
    if not (all(map(math.isfinite, given)) and any(given)):
        raise InvalidInput(f"spin.attitude must be a quaternion (w, x, y, z) that is not zero; got {list(given)}.")
    attitude = rotation.multiply(rotation.normalize(given), rotation.from_matrix(axes))
    if table is None:
        return np.zeros(3), attitude
    if table.momentum is not None or table.angular_velocity is not None:
        vector = np.array(table.momentum if table.momentum is not None else table.angular_velocity)
        vector = vector if table.frame == "principal" else vector @ axes
        return vector if table.momentum is not None else moments * vector, attitude
    direction = np.zeros(3)
    about = table.about
    index = about - 1 if isinstance(about, int) else "xyz".index(str(about))
    direction[index], direction[(index + 1) % 3] = math.cos(table.tilt), math.sin(table.tilt)
    velocity = (table.rate or 0.0) * (direction if isinstance(about, int) else direction @ axes)
    return moments * velocity, attitude
