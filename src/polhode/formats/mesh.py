"""Triangle meshes from files: STL and OBJ directly, other formats by trimesh, with repairs on request."""

from __future__ import annotations

import io
import logging
import warnings
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from polhode._base import check
from polhode._base.extras import needing
from polhode.bodies._mesh import mass_properties
from polhode.bodies.body import Body
from polhode.errors import FormatError, InvalidInput, shown
from polhode.formats.mesh_archives import MODULES, check_archive, names_its_unit
from polhode.formats.opening import MB, read_file
from polhode.formats.paths import as_path
from polhode.types import Array, Float64, Integer

LARGEST_FILE = 256 * MB  # five million triangles of a binary STL
ENDINGS = ("stl", "obj", "ply", "off", "glb", "gltf", "3mf", "dae")


class MeshLimits(NamedTuple):
    """Numbers that decide whether a mesh is refused and its corners are joined."""

    max_extent: float = 1e30  # m; moments of inertia are its fifth power, and doubles end at 1e308
    # of a corner within ``corner_distance`` on average; more would be all pairs of a heap of corners
    max_neighbours: int = 50
    # of the mesh's extent, within which corners are one: single precision and printed digits leave as much
    corner_distance: float = 1e-6


LIMITS = MeshLimits()


class LoadedMesh(NamedTuple):
    """A mesh from a file.

    Attributes:
        vertices: (n, 3) [m].
        faces: (m, 3) indices of corners.
        notes: what repair changed, in sentences; empty where it was not asked for or changed nothing.
    """

    vertices: Float64[Array, "n 3"]
    faces: Integer[Array, "m 3"]
    notes: tuple[str, ...] = ()


def read_mesh(
    path: str | Path, unit: float | None = None, repair: bool = False
) -> tuple[Float64[Array, "n 3"], Integer[Array, "m 3"]]:
    """Return vertices (n, 3) [m] and faces (m, 3) of a mesh file (STL, OBJ, PLY, OFF, GLB, glTF in one file, 3MF, DAE).

    Corners that coincide exactly are merged, as STL files repeat them for every triangle.

    Args:
        path: the file.
        unit: length of the file's unit [m]; it may be left out for 3MF and DAE files, which name theirs.
        repair: merge corners closer than 1e-6 of the extent, drop degenerate and repeated triangles, fill
            small holes, and turn faces outward, or inward on cavities. Only on request, as it guesses.

    Raises:
        InvalidInput: if the file is missing or the unit is not positive.
        FormatError: if it cannot be read as a mesh.
    """
    read = load_mesh(path, unit, repair)
    return read.vertices, read.faces


def load_mesh(path: str | Path, unit: float | None = None, repair: bool = False) -> LoadedMesh:
    """Return a mesh as ``read_mesh`` does, with notes on what repair changed."""
    path = as_path("path", path)
    if unit is None and not names_its_unit(path):
        raise InvalidInput(f"{path}: `unit` is missing, a length in metres like 1e-3; of mesh files only 3MF and DAE "
                           "name theirs.")
    if unit is not None:
        unit = check.number("unit", unit, "m", above=0, remedy="Millimetres are 1e-3.")
    vertices, faces, unit = _load(path, read_file(path, "mesh", LARGEST_FILE), unit)
    if len(faces) == 0:
        raise FormatError(f"{path}: holds no triangles; it may be cut short. Export it again, as a surface mesh.")
    if not np.isfinite(vertices).all():
        raise FormatError(f"{path}: a corner is NaN or infinite. Export it again.")
    if faces.shape[1:] != (3,) or faces.min() < 0 or faces.max() >= len(vertices):
        raise FormatError(f"{path}: a face has a corner that is not there, of {len(vertices)}. Export it again.")
    if (extent := float(np.abs(vertices).max())) > LIMITS.max_extent / unit:
        raise FormatError(f"{path}: a corner is {extent:.3g} of its units away, and no body is that large. Check the "
                          "file and its unit.")
    vertices, faces = _merge(vertices, faces.astype(np.int64))
    if not repair:
        return LoadedMesh(vertices * unit, faces)
    from polhode.bodies._mesh_repair import repair_mesh

    try:
        near, index = _merge_nearby(vertices, faces)
        merged = len(vertices) - len(near)
        vertices, faces, changes = repair_mesh(near, index, holes=True)
    except InvalidInput as error:
        raise InvalidInput(f"{path}: {error}") from None
    if len(faces) == 0:
        raise FormatError(f"{path}: holds no triangle with an area; it may be cut short. Export it again.")
    return LoadedMesh(vertices * unit, faces, _say(changes, merged))


def body_of_mesh(
    read: LoadedMesh, mass: float | None, density: float | None, *, several: bool, repaired: bool
) -> Body:
    """Return the body that a mesh from a file bounds, which was repaired there if that was asked for."""
    return Body(*mass_properties(
        read.vertices, read.faces, mass=mass, density=density, several=several, repaired=repaired
    ))


def _say(changes: tuple[str, ...], merged: int) -> tuple[str, ...]:
    """Return a sentence on the changes by repair."""
    if merged:
        changes = (f"made {merged} corners one with others less than 1e-6 of the mesh's size away", *changes)
    if not changes:
        return ("repair had nothing to mend.",)
    return (f"repair {' and '.join(filter(None, (', '.join(changes[:-1]), changes[-1])))}.",)


def _load(path: Path, content: bytes, unit: float | None) -> tuple[Array, Array, float]:
    """Return corners, faces, and the unit that they are in [m]."""
    ending = path.suffix.lower().lstrip(".")
    if ending not in ENDINGS:
        known = ", ".join(ENDINGS)
        why = f"a mesh file must end in one of {known}; got {shown(path.suffix)}"
        raise FormatError(f"{path}: {why}. Convert it to STL.")
    if ending == "obj":
        from polhode.formats.mesh_checks import as_text
        from polhode.formats.obj_mesh import read_obj

        return *read_obj(path, as_text(path, content)), unit or 1.0
    if ending == "stl":
        from polhode.formats.stl_mesh import read_stl

        return *read_stl(path, content), unit or 1.0
    if ending in MODULES:
        unit = check_archive(path, ending, content, unit)
    else:
        from polhode.formats.mesh_checks import check_content

        content = check_content(path, ending, content)
    with needing(f"{ending.upper()} files need", "Or convert it to STL."):
        trimesh = _trimesh()
    try:
        with warnings.catch_warnings(), np.errstate(all="ignore"):
            warnings.simplefilter("ignore")
            # older NumPy warns where it stops at a word that is not a number
            warnings.filterwarnings("error", message="string or file could not be read")
            mesh: Any = trimesh.load(io.BytesIO(content), file_type=ending, force="mesh", process=False,
                                     skip_materials=True)
        return np.array(mesh.vertices, dtype=float), np.array(getattr(mesh, "faces", ())), unit or 1.0
    except Exception:  # trimesh raises whatever its many readers raise
        why = "it is broken, cut short, or not what its ending says. Export it again."
        raise FormatError(f"{path}: cannot be read as a mesh: {why}") from None


def _trimesh() -> Any:
    """Return trimesh, with a handler on its log, as it prints tracebacks otherwise."""
    import trimesh

    logger = logging.getLogger("trimesh")
    if not logger.handlers:
        logger.addHandler(logging.NullHandler())
    return trimesh


def _merge(vertices: Array, faces: Array) -> tuple[Array, Array]:
    unique, index = np.unique(vertices + 0.0, axis=0, return_inverse=True)  # + 0.0 makes −0.0 equal to 0.0
    return unique, index.reshape(-1)[faces]


def _merge_nearby(vertices: Array, faces: Array) -> tuple[Array, Array]:
    """Merge corners in chains of near neighbours; rounding to a grid instead would split some of them."""
    with needing("Repairs of meshes need", alone=True):
        from scipy.sparse import coo_array
        from scipy.sparse.csgraph import connected_components
        from scipy.spatial import KDTree

    tree, distance = KDTree(vertices), LIMITS.corner_distance * np.ptp(vertices, axis=0).max()
    if tree.count_neighbors(tree, distance) > LIMITS.max_neighbours * len(vertices):
        raise InvalidInput("most of its corners lie within 1e-6 of its extent of each other, where repair would merge "
                           "them. Take away what lies far from the body.")
    near = tree.query_pairs(distance, output_type="ndarray")
    graph = coo_array((np.ones(len(near), dtype=bool), (near[:, 0], near[:, 1])), shape=(len(vertices),) * 2)
    count, labels = connected_components(graph, directed=False)
    kept = np.empty(count, dtype=int)
    kept[labels[::-1]] = np.arange(len(vertices))[::-1]
    return vertices[kept], labels[faces]
