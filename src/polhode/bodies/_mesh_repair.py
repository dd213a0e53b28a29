"""Repair of meshes on request: mends that need no knowledge of the body, with a word on each change."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from polhode._base.extras import needing
from polhode.bodies._extruded import triangulate
from polhode.bodies._mesh_crossing import depths
from polhode.bodies._mesh_edges import find_edges, find_neighbours, find_pieces
from polhode.bodies._mesh_gate import as_mesh, find_parity, find_volume
from polhode.errors import InvalidInput
from polhode.types import ArrayLike, Float64, Integer, Real


class HoleLimits(NamedTuple):
    """Numbers that decide which holes of a mesh are closed."""

    max_width: float = 0.05  # of the mesh's extent: closed flat, such a hole changes the volume by less than 1e-4
    max_edges: int = 200  # of a small hole
    edges_of_one_triangle: int = 3  # a hole that one lost triangle leaves, of any size
    edges_of_two_triangles: int = 4  # a hole that two triangles side by side leave, of any size
    # of 30°: two lost triangles continue the plane of a neighbour; the lid of an open box does not
    min_flat_cosine: float = 0.87


LIMITS = HoleLimits()


class Repaired(NamedTuple):
    """A mesh after repair.

    Attributes:
        vertices: (n, 3) [m].
        faces: (m, 3) indices of corners.
        changes: a phrase for each change.
    """

    vertices: Float64[np.ndarray, "n 3"]
    faces: Integer[np.ndarray, "m 3"]
    changes: tuple[str, ...]


def repair_mesh(
    vertices: Real[ArrayLike, "n 3"], faces: Real[ArrayLike, "m 3"], holes: bool = False
) -> Repaired:
    """Return the mesh with its faces oriented consistently, bodies outward, cavities inward; the rest stays.

    Triangles with repeated corners are dropped, as are copies of others, and walls of two triangles back to back.

    Args:
        vertices: (n, 3) corners [m].
        faces: (m, 3) indices of corners.
        holes: whether small holes are closed: those no wider than a twentieth of the mesh, those of 3 edges, and those
            of 4 edges that continue a flat face.

    Raises:
        InvalidInput: if a piece of the surface has only one side.
    """
    vertices, given = as_mesh(vertices, faces)
    faces, changes = _drop_useless(given)
    faces = _orient_faces(faces)
    if holes:
        faces, closed = _close_holes(vertices, faces)
        changes += closed
    kept = faces.copy()
    edges = find_edges(faces)
    if len(faces) and not (edges.uses < 2).any() and not edges.balance.any():
        pieces = find_pieces(vertices, faces)
        for piece, depth in zip(pieces, depths(vertices[faces], pieces), strict=True):
            if (find_volume(vertices[faces[piece]]) < 0) == (depth % 2 == 0):
                faces[piece] = faces[piece][:, ::-1]
    if count := _count_reversed(given, faces if len(edges.uses) else kept):
        changes.append(f"turned {count} triangles round")
    return Repaired(vertices, faces, tuple(changes))


def _drop_useless(faces: np.ndarray) -> tuple[np.ndarray, list[str]]:
    """Drop triangles without area, all but one of equal triangles, and pairs of opposite orientation."""
    a, b, c = faces.T
    proper = (a != b) & (b != c) & (c != a)
    changes = [f"dropped {int((~proper).sum())} triangles with a repeated corner"] if not proper.all() else []
    faces = faces[proper]
    _, first, number = np.unique(np.sort(faces, axis=1), axis=0, return_index=True, return_inverse=True)
    number = number.reshape(-1)
    parity = find_parity(faces)
    net = np.rint(np.bincount(number, weights=parity)).astype(int)
    if len(first) == len(faces):
        return faces, changes
    even = np.bincount(number, minlength=len(first)) > 1
    kept = first[net != 0]
    wanted = np.sign(net[net != 0])
    left = faces[kept]
    left = np.where((parity[kept] == wanted)[:, None], left, left[:, ::-1])
    left = left[np.argsort(kept, kind="stable")]
    changes.append(f"dropped {len(faces) - len(left)} triangles that lay on others ({int(even.sum())} places)")
    return left, changes


def _orient_faces(faces: np.ndarray) -> np.ndarray:
    """Return the faces, in each piece oriented like the first one.

    Each face is in a graph twice, as it is and reversed; neighbours are joined in the ways that agree. A surface
    with two sides falls apart into two copies.
    """
    with needing("Repairs of meshes need", alone=True):
        from scipy.sparse import coo_array
        from scipy.sparse.csgraph import connected_components

    one, other, clash = find_neighbours(find_edges(faces))
    n = len(faces)
    rows = np.concatenate([one, one + n])
    columns = np.concatenate([other + n * clash, other + n * ~clash])
    graph = coo_array((np.ones(len(rows), dtype=bool), (rows, columns)), shape=(2 * n, 2 * n))
    _, labels = connected_components(graph, directed=False)
    if (labels[:n] == labels[n:]).any():
        raise InvalidInput(
            "the mesh has a surface with only one side, like a Klein bottle, which encloses nothing. Check the file."
        )
    # labels count up by first appearance, so the copy that holds a piece's first face as it is has the lower one
    turn = labels[:n] > labels[n:]
    return np.where(turn[:, None], faces[:, ::-1], faces)


def _close_holes(vertices: np.ndarray, faces: np.ndarray) -> tuple[np.ndarray, list[str]]:
    """Close small holes, each by triangles between the corners of its rim."""
    edges = find_edges(faces)
    open_ = edges.uses[edges.number] == 1
    rim = edges.ends[open_]
    if len(rim) == 0:
        return faces, []
    beside = {frozenset(ends): face for ends, face in zip(rim.tolist(), edges.face[open_], strict=True)}
    extent = float(np.ptp(vertices[faces], axis=(0, 1)).max())
    added, widest, longest, closed = [], 0.0, 0, 0
    for loop in _find_loops(rim):
        corners = vertices[loop]
        width = float(np.ptp(corners, axis=0).max())
        cap = np.asarray(loop)[_span(corners)]
        neighbours = [beside[frozenset(ends)] for ends in zip(loop, np.roll(loop, -1).tolist(), strict=True)]
        small = width <= LIMITS.max_width * extent and len(loop) <= LIMITS.max_edges
        was_flat = len(loop) == LIMITS.edges_of_two_triangles and _is_flat(vertices, cap, faces[neighbours])
        if not (small or len(loop) == LIMITS.edges_of_one_triangle or was_flat):
            continue
        added.append(cap)
        widest, longest, closed = max(widest, width), max(longest, len(loop)), closed + 1
    if not added:
        return faces, []
    holes, share = f"{closed} hole{'s' if closed > 1 else ''}", widest / extent
    return np.vstack([faces, *added]), [f"closed {holes} of up to {longest} edges and {share:.2g} of the mesh's size"]


def _is_flat(vertices: np.ndarray, cap: np.ndarray, neighbours: np.ndarray) -> bool:
    """Return whether each triangle of a cap lies in the plane of some neighbour, whatever its orientation."""
    a, b, c = np.moveaxis(vertices[np.concatenate([cap, neighbours])], 1, 0)
    normals = np.cross(b - a, c - a)
    normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), np.finfo(float).tiny)
    return bool((np.abs(normals[: len(cap)] @ normals[len(cap) :].T).max(axis=1) > LIMITS.min_flat_cosine).all())


def _find_loops(rim: np.ndarray) -> list[list[int]]:
    """Return simple closed paths of corners along open half-edges (k, 2), against their direction.

    Where several pass one corner, a path is cut off as soon as it comes back to a corner that it has been at.
    """
    following: dict[int, list[int]] = {}
    for start, end in rim.tolist():
        following.setdefault(end, []).append(start)
    loops = []
    while following:
        path = [next(iter(following))]
        place = {path[0]: 0}
        while path:
            ways = following.get(path[-1])
            if not ways:  # faces of inconsistent orientation leave paths without an end
                following.pop(path[-1], None)
                place.pop(path.pop())
                continue
            after = ways.pop()
            if not ways:
                del following[path[-1]]
            if after in place:
                loop = path[place[after] :]
                loops += [loop] if len(loop) > 2 else []
                for corner in loop[1:]:
                    del place[corner]
                path = path[: place[after] + 1]
                if path[-1] not in following and len(path) == 1:
                    break
            else:
                place[after] = len(path)
                path.append(after)
    return loops


def _span(corners: np.ndarray) -> np.ndarray:
    """Return triangles (n − 2, 3) between the corners of a loop, as it looks along its mean normal.

    Source: Newell's normal, the sum of cross products of neighbours; ears by Meisters.
    """
    middle = corners - corners.mean(axis=0)
    normal = np.cross(middle, np.roll(middle, -1, axis=0)).sum(axis=0)
    size = float(np.linalg.norm(normal))
    if size == 0.0:
        return np.array([[0, k, k + 1] for k in range(1, len(corners) - 1)])
    normal /= size
    across = np.cross(normal, np.eye(3)[np.abs(normal).argmin()])
    across /= np.linalg.norm(across)
    return np.asarray(triangulate(np.column_stack([middle @ across, middle @ np.cross(normal, across)])))


def _count_reversed(given: np.ndarray, faces: np.ndarray) -> int:
    """Return how many triangles of a mesh are in another one with the opposite orientation."""
    size = int(max(given.max(initial=0), faces.max(initial=0))) + 1

    def keys(triangles: np.ndarray) -> np.ndarray:
        ordered = np.sort(triangles, axis=1) @ np.array([size * size, size, 1])
        return 2 * ordered + (find_parity(triangles) > 0)

    return len(np.setdiff1d(np.intersect1d(keys(given) ^ 1, keys(faces)), keys(given)))
