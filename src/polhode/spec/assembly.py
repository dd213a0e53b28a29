"""From the parts of a spec to one body: each part's mass properties in its place, cuts taken away.

A part may be the body of another spec, whose parts may be so in turn; each file is read once, and a spec that would be
part of itself is refused.
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

import numpy as np

from polhode import rotation
from polhode.bodies import _solids as solids
from polhode.bodies._inertia import MassProperties, inertia_of_second
from polhode.bodies.body import Body, combine
from polhode.errors import InvalidInput
from polhode.spec.built import BuiltBody, BuiltPart, PartsRefused, ReadBody
from polhode.spec.models import MAY_HAVE, SHAPE_KEYS, PartTable
from polhode.types import Array, Float64

TURNS = {"z": np.eye(3), "x": np.eye(3)[[2, 0, 1]], "y": np.eye(3)[[1, 2, 0]]}
TURNS |= {f"-{axis}": turn * [1.0, -1.0, -1.0] for axis, turn in TURNS.items()}
NO_DENSITY = ("point", "disk", "rod")  # too thin to cut anything out of


class DensityLimits(NamedTuple):
    """A number that decides whether parts have one density."""

    relative_spread: float = 1e-9  # what volumes and masses in decimal digits leave


LIMITS = DensityLimits()


def turn_of(part: PartTable) -> Float64[Array, "3 3"]:
    """Return the rotation (3, 3) of a part's own axes into the body's."""
    if part.attitude is None:
        return TURNS[part.axis]
    return np.asarray(rotation.as_matrix(rotation.normalize(part.attitude)))


def name_of(part: PartTable, k: int) -> str:
    """Return the name of a part in reports: its own, or its number."""
    return f"part {k + 1}" if part.name is None else part.name


def build_assembly(
    parts: Sequence[PartTable], density: float | None, folder: Path, read_body: ReadBody
) -> BuiltBody:
    """Return the body that parts make together.

    Args:
        parts: their tables.
        density: of parts that give neither mass nor density [kg/m³], or None.
        folder: from which paths count.
        read_body: reads the body of another spec.

    Raises:
        PartsRefused: for parts that no body can have.
        InvalidInput: for cuts that leave no body.
    """
    built: dict[int, BuiltPart] = {}
    faults: list[tuple[int, InvalidInput]] = []
    for cutting in (False, True):
        if cutting and not faults:
            density = density or _common_density(parts, built)
        for k, part in enumerate(parts):
            if part.cut == cutting:
                try:
                    built[k] = build_part(part, density, folder, read_body)
                except InvalidInput as error:
                    faults.append((k, error))
    if faults:
        raise PartsRefused(sorted(faults, key=lambda fault: fault[0]))
    added = [built[k].properties for k, part in enumerate(parts) if not part.cut]
    taken = [built[k].properties for k, part in enumerate(parts) if part.cut]
    notes = [f"{name_of(part, k)}: {note}" for k, part in enumerate(parts) for note in built[k].notes]
    return BuiltBody(combine(added, taken), tuple(notes))


def _common_density(parts: Sequence[PartTable], built: dict[int, BuiltPart]) -> float | None:
    """Return the common density of all parts that cuts can be cut from, None where there is none.

    The shape of other specs and of known inertias is unknown, so that nothing is cut from them.
    """
    solid = [
        built[k].density
        for k, part in enumerate(parts)
        if not part.cut and part.shape not in NO_DENSITY and part.spec is None and part.inertia is None
    ]
    known = [one for one in solid if one is not None]
    if not known or len(known) < len(solid) or max(known) > (1.0 + LIMITS.relative_spread) * min(known):
        return None
    return known[0]


def build_part(part: PartTable, density: float | None, folder: Path, read_body: ReadBody) -> BuiltPart:
    """Return one part in its place; arguments as ``build_assembly`` has them.

    Raises:
        InvalidInput: for measures that do not fit each other.
        FormatError: for files of another format.
    """
    turn, place = turn_of(part), np.asarray(part.at)
    if part.spec is not None:
        made = read_body(folder / part.spec)
        if made.body.mass is None:
            raise InvalidInput(f"the body of {part.spec} has no mass, which a part needs; give it there")
        return BuiltPart(made.body.placed(turn, place), None, made.notes)
    if part.inertia is not None:
        from polhode.spec.known_inertia import build_known

        made = build_known(part)
        return BuiltPart(made.body.placed(turn, place), None, made.notes)
    if part.shape == "point":
        return BuiltPart(MassProperties(part.mass or 0.0, place, np.zeros((3, 3))), None)
    own = part.density or (None if part.mass else density)
    if part.mass is None and own is None:
        raise InvalidInput(
            "says neither mass nor density, and the shapes and meshes that it may be cut from have not one density in "
            "common. Give its density"
        )
    body, volume, notes = _mesh(part, own, folder) if part.mesh is not None else _shape(part, own)
    known = own or (body.mass / volume if volume and body.mass else None)
    return BuiltPart(body.placed(turn, place), None if part.is_shell else known, notes)


def _shape(part: PartTable, density: float | None) -> tuple[Body, float | None, tuple[str, ...]]:
    assert part.shape is not None, "checked by the rules"
    keys = [*SHAPE_KEYS[part.shape], *(key for key in MAY_HAVE.get(part.shape, ()) if key != "shell")]
    measures = {key: value for key in keys if (value := getattr(part, key)) not in (None, False)}
    solid = getattr(solids, f"{part.shape}_shell" if part.is_shell else part.shape)(**measures)
    if part.mass is None and solid.volume is None:
        raise InvalidInput("has no volume, so that no mass follows from density; give mass")
    mass = part.mass if part.mass is not None else (density or 0.0) * (solid.volume or 0.0)
    (mass,) = solids.positive(mass=mass)
    return Body(mass, solid.centroid, mass * inertia_of_second(solid.second)), solid.volume, ()


def _mesh(part: PartTable, density: float | None, folder: Path) -> tuple[Body, float | None, tuple[str, ...]]:
    from polhode.bodies._mesh import volume_moments
    from polhode.formats.mesh import body_of_mesh, load_mesh

    assert part.mesh is not None
    read = load_mesh(folder / part.mesh, part.mesh_unit, part.repair)
    amount = {"mass": part.mass, "density": None if part.mass is not None else density}
    try:
        if part.is_shell:
            of_wall = {} if part.mass is not None else {"thickness": part.thickness}
            return Body.from_sheet(read.vertices, read.faces, **amount, **of_wall), None, read.notes
        body = body_of_mesh(read, several=part.several, repaired=part.repair, **amount)
    except InvalidInput as error:
        raise InvalidInput(f"mesh {part.mesh}: {error}") from None
    volume = abs(volume_moments(np.asarray(read.vertices)[read.faces])[0])
    return body, volume, read.notes
