"""The surface of a spec's body, as triangles along its given axes, for drawing only."""

from __future__ import annotations

import functools
from collections.abc import Sequence
from dataclasses import replace
from importlib.resources import files
from pathlib import Path
from typing import NamedTuple

import numpy as np

from polhode.bodies._extruded import extrude, regular_outline
from polhode.bodies._turned import SECTIONS, ball, bar, capsule, cone, torus, tube
from polhode.bodies.atoms import ANGSTROM
from polhode.bodies.surface import Surface, box_in_place, cuboid, join_surfaces
from polhode.errors import InvalidInput
from polhode.formats.mesh_checks import LIMITS as SCENE_LIMITS
from polhode.spec.assembly import turn_of
from polhode.spec.building import build_body, read_body_table
from polhode.spec.models import BodyTable, PartTable
from polhode.types import Array, Float64

THIN = 0.02  # of the radius or length: thickness given to a body without one, to be visible
BAR = 0.12 * ANGSTROM  # radius of a bond


class DrawingLimits(NamedTuple):
    """A number beyond which a body is not drawn."""

    max_pieces: int = 10_000


LIMITS = DrawingLimits()


def surface_of_body(table: BodyTable, folder: Path) -> Surface | None:
    """Return the surface of a body; paths count from the folder. None where only moments are known.

    A mesh is as in its file, parts are in their places, a molecule is balls and bars. What is cut is not shown.

    Raises:
        InvalidInput: if a file that the body came from is gone.
    """
    if table.mesh is not None:
        from polhode.formats.mesh import read_mesh

        return Surface(*read_mesh(folder / table.mesh, table.mesh_unit, table.repair))
    if table.part is not None:
        if (count := _count_pieces(table, folder, {})) > LIMITS.max_pieces:
            raise InvalidInput(f"its parts have {count} pieces with those of other specs, more than "
                               f"{LIMITS.max_pieces}, which "
                               "no page can draw. The report needs no picture.")
        return surface_of_parts(table.part, folder)
    if table.molecule is not None:
        from polhode.formats.molecule import read_molecule

        symbols, positions, _ = read_molecule(folder / table.molecule)
        return surface_of_atoms(symbols, positions)
    return None


def _count_pieces(table: BodyTable, folder: Path, known: dict[Path, int]) -> int:
    """Return the number of pieces drawn of a body, with those of the specs in it, each of which is read once."""
    count = 0
    for part in table.part or [None]:
        if part is None or part.spec is None:
            count += 1
            continue
        path = (folder / part.spec).resolve()
        if path not in known:
            known[path] = _count_pieces(read_body_table(path), path.parent, known)
        count += known[path]
    return count


def surface_of_disk(radius: float, thickness: float, sections: int = SECTIONS) -> Surface:
    """Return a disk, its axis along z; one without thickness is given some, to be visible."""
    return tube(radius, thickness or THIN * radius, sections=sections)


def surface_of_parts(parts: Sequence[PartTable], folder: Path) -> Surface | None:
    """Return the parts that are not cut, points as small balls; None where nothing is known but points in one place.

    Raises:
        InvalidInput: for more triangles than a page can draw.
    """
    pieces, points = [], []
    for part in parts:
        if part.cut:
            continue
        if part.shape == "point":
            points.append(part.at)
        elif (piece := surface_of_part(part, folder)) is not None:
            pieces.append(piece)
    if sum(len(piece.faces) for piece in pieces) > SCENE_LIMITS.max_triangles:
        raise InvalidInput(f"the parts have more than {SCENE_LIMITS.max_triangles} triangles together, which no page "
                           "can draw.")
    corners = np.vstack([*(piece.vertices for piece in pieces), *np.reshape(points, (-1, 1, 3))])
    size = float(np.ptp(corners, axis=0).max())
    if size > 0.0:
        vertices, faces = ball(12)
        pieces += [Surface(vertices * THIN * size + np.asarray(at), faces) for at in points]
    return join_surfaces(pieces) if pieces else None


def surface_of_part(part: PartTable, folder: Path = Path()) -> Surface | None:
    """Return one part in its place; where only its inertia is known, the box of that inertia."""
    if part.spec is not None:
        path = folder / part.spec
        table = read_body_table(path)
        local = surface_of_body(table, path.parent) or box_in_place(build_body(table, path.parent, path).body.frame)
    elif part.mesh is not None:
        from polhode.formats.mesh import read_mesh

        local = Surface(*read_mesh(folder / part.mesh, part.mesh_unit, part.repair))
    elif part.inertia is not None:
        from polhode.spec.known_inertia import build_known

        local = box_in_place(build_known(part).body.frame)
    else:
        local = _make_shape(part)
    if local is None:
        return None
    return Surface(local.vertices @ turn_of(part).T + np.asarray(part.at), local.faces)


def _make_shape(part: PartTable) -> Surface:
    """Return a shape about its centre of mass, its axis along z."""
    # each shape has its own measures by the rules; 0.0 replaces those of the others
    radius, height, length = part.radius or 0.0, part.height or 0.0, part.length or 0.0
    inner = min(part.inner_radius or 0.0, (1.0 - THIN) * radius)
    match part.shape:
        case "box":
            return cuboid(part.size)
        case "capsule":
            return capsule(radius, length)
        case "prism":
            outline = part.outline or regular_outline(part.sides or 3, radius)
            return extrude(np.asarray(outline, dtype=float), height)
        case "cylinder":
            if part.is_shell and part.open_ends:
                inner = max(radius - max(0.5 * (part.thickness or 0.0), 0.5 * THIN * radius), 0.0)
            return tube(radius, height, inner)
        case "disk":
            return tube(radius, THIN * radius, inner)
        case "rod":
            return tube(0.5 * THIN * length, length)
        case "cone":
            return cone(radius, height)
        case "torus":
            return torus(part.major_radius or 0.0, part.minor_radius or 0.0)
    vertices, faces = ball()
    if part.shape == "ellipsoid":
        return Surface(vertices * np.asarray(part.semi_axes), faces)
    cavity = [Surface(vertices * inner, faces[:, ::-1])] if inner else []
    return join_surfaces([Surface(vertices * radius, faces), *cavity])


def surface_of_atoms(symbols: Sequence[str], positions: Float64[Array, "n 3"]) -> Surface:
    """Return a molecule as balls in the usual colours, half as large as covalent radii, and bars between bonded ones.

    Args:
        symbols: (n,) chemical symbols.
        positions: (n, 3) [m].
    """
    ball_size = 0.5  # of the covalent radius: an atom
    unknown = 1.5, 0xFF1493  # Å and colour of an element that the table does not have
    bond_color = 0x9A9A9A
    many = 100  # from which on their balls are coarser
    bonded = 1.2  # of the sum of covalent radii: atoms no further apart are bonded
    from scipy.spatial import KDTree

    positions = np.asarray(positions, dtype=float)
    looks = [_looks().get(symbol, unknown) for symbol in symbols]
    radii = np.array([radius for radius, _ in looks]) * ANGSTROM
    vertices, faces = ball(24 if len(radii) <= many else 12)
    shown = [color_surface(Surface(vertices * (ball_size * radius * ANGSTROM) + at, faces), color)
             for (radius, color), at in zip(looks, positions, strict=True)]
    for i, j in KDTree(positions).query_pairs(2.0 * bonded * radii.max(), output_type="ndarray"):
        if 0.0 < np.linalg.norm(positions[i] - positions[j]) <= bonded * (radii[i] + radii[j]):
            shown.append(color_surface(bar(positions[i], positions[j], BAR), bond_color))
    return join_surfaces(shown)


@functools.cache
def _looks() -> dict[str, tuple[float, int]]:
    """Return covalent radius [Å] and colour by symbol."""
    lines = files("polhode.spec").joinpath("atom_looks.csv").read_text("ascii").splitlines()
    rows = (line.split(",") for line in lines if not line.startswith(("#", "symbol,")))
    return {symbol: (float(radius), int(color, 16)) for symbol, radius, color in rows}


def color_surface(surface: Surface, color: int) -> Surface:
    """Return a surface with all corners of one colour."""
    return replace(surface, colors=np.full(len(surface.vertices), color))
