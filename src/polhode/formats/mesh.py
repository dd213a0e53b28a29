"""Triangle meshes from files, read and on request repaired by trimesh."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from polhode.errors import FormatError, InvalidInput

Array = Any


def read_mesh(path: str | Path, unit: float, repair: bool = False) -> tuple[Array, Array]:
    """Return vertices (n, 3) [m] and faces (m, 3) of a mesh file (STL, OBJ, PLY, OFF, GLB …).

    Args:
        path: the file.
        unit: length of the file's unit [m]; mesh files carry none.
        repair: merge corners, turn faces outward alike, and fill small holes. Only on request, as it guesses.

    Raises:
        InvalidInput: if the file is missing or the unit is not positive.
        FormatError: if it cannot be read as a mesh.
    """
    path = Path(path)
    if not (np.isfinite(unit) and unit > 0):
        raise InvalidInput(f"`unit` must be a positive length in metres; got {unit!r}.")
    if not path.is_file():
        raise InvalidInput(f"{path}: no such mesh file. Check the path; it counts from the spec's own folder.")
    import trimesh

    try:
        mesh: Any = trimesh.load(path, force="mesh", process=False)
        vertices, faces = np.asarray(mesh.vertices, dtype=float), np.asarray(mesh.faces)
    except Exception as error:  # trimesh raises whatever its many readers raise
        why = f"{path}: cannot be read as a mesh ({error}). Is the file whole and its ending right?"
        raise FormatError(why) from None
    if len(faces) == 0:
        raise FormatError(f"{path}: holds no triangles. Export it as a surface mesh.")
    mesh = trimesh.Trimesh(vertices, faces, process=False)
    mesh.merge_vertices(merge_tex=True, merge_norm=True)
    if repair:
        mesh.update_faces(mesh.nondegenerate_faces() & mesh.unique_faces())
        trimesh.repair.fill_holes(mesh)
        trimesh.repair.fix_normals(mesh, multibody=True)
    return np.asarray(mesh.vertices, dtype=float) * unit, np.asarray(mesh.faces, dtype=np.int64)
