"""Checks of meshes: a bad one would silently give wrong moments, so each fault is an error of its own.

What passes is a closed surface, each edge used once in each direction, that winds once around every point of the body
and not at all around any other: pieces neither cross nor contain each other, but for cavities.
"""

from __future__ import annotations

import numpy as np

from polhode.bodies._mesh_crossing import depths, find_crossing_faces
from polhode.errors import InvalidInput
from polhode.types import ArrayLike, Float64, Integer, Real

FINEST = 1e-30  # m; fifth powers of coordinates must neither overflow nor underflow
NO_VOLUME = 1e-12  # of the tetrahedra's own size: a flat surface leaves rounding, a foil of 1e-9 of its width far more
ASKED = "repair = true in a spec, repair=True in Python"


def check_mesh(
    vertices: Real[ArrayLike, "n 3"], faces: Real[ArrayLike, "m 3"], several: bool = False, repaired: bool = False
) -> tuple[Float64[np.ndarray, "n 3"], Integer[np.ndarray, "m 3"]]:
    """Return the mesh as arrays if it bounds a body.

    Args:
        vertices: (n, 3) corners [m].
        faces: (m, 3) indices of corners.
        several: whether disjoint bodies are accepted.
        repaired: whether it is what repair left, so that no message advises to ask for that.

    Raises:
        InvalidInput: naming the fault and what helps.
    """
    vertices, faces = as_mesh(vertices, faces)
    _check_edges(faces, repaired)
    pieces = find_pieces(faces)
    corners = vertices[faces]
    volumes = np.array([_volume(corners[piece]) for piece in pieces])
    if not volumes.all():
        raise InvalidInput("the mesh encloses no volume; a flat surface is not a body. Check the file and its scale.")
    if volumes.sum() < 0:
        raise InvalidInput(
            f"the mesh is inverted: its faces are turned inward and its volume is {volumes.sum():.6g} m³. "
            f"Turn the faces outward{_or_repair(repaired)}."
        )
    _check_crossings(vertices, faces, pieces)
    if len(pieces) > 1:
        _check_nesting(volumes, depths(corners, pieces), several, repaired)
    return vertices, faces


def repair_mesh(
    vertices: Real[ArrayLike, "n 3"], faces: Real[ArrayLike, "m 3"]
) -> tuple[Float64[np.ndarray, "n 3"], Integer[np.ndarray, "kept 3"]]:
    """Return the mesh with its faces turned alike, bodies outward, cavities inward; what cannot be turned stays.

    Triangles with repeated corners are dropped.

    Raises:
        InvalidInput: if a piece of the surface has only one side.
    """
    vertices, faces = as_mesh(vertices, faces)
    a, b, c = faces.T
    faces = faces[(a != b) & (b != c) & (c != a)]
    edges, face, forward, uses = _edges(faces)
    if len(faces) == 0 or (uses < 2).any():
        return vertices, faces  # the gate will say that it is open
    faces = _orient_faces(faces, *_neighbours(edges, face, forward, uses))
    if (uses > 2).any():
        return vertices, faces
    pieces = find_pieces(faces)
    for piece, depth in zip(pieces, depths(vertices[faces], pieces), strict=True):
        if (_volume(vertices[faces[piece]]) < 0) == (depth % 2 == 0):
            faces[piece] = faces[piece][:, ::-1]
    return vertices, faces


def as_mesh(
    vertices: Real[ArrayLike, "n 3"], faces: Real[ArrayLike, "m 3"], least: int = 4
) -> tuple[Float64[np.ndarray, "n 3"], Integer[np.ndarray, "m 3"]]:
    """Return copies as float64 and int64 arrays of the right shapes, finite and in range."""
    if np.iscomplexobj(vertices):
        raise InvalidInput("`vertices` must be real; got complex numbers.")
    try:
        vertices, faces = np.array(vertices, dtype=float), np.array(faces)
    except (TypeError, ValueError) as error:
        raise InvalidInput(f"a mesh needs vertices (n, 3) of numbers and faces (m, 3); got {error}.") from None
    if vertices.ndim != 2 or vertices.shape[1:] != (3,) or faces.ndim != 2 or faces.shape[1:] != (3,):
        raise InvalidInput(
            f"a mesh needs vertices (n, 3) and faces (m, 3), triangles only; got {vertices.shape} and {faces.shape}."
        )
    if len(faces) < least:
        raise InvalidInput(f"the mesh is open: a closed surface has at least 4 triangles; got {len(faces)}.")
    if not np.issubdtype(faces.dtype, np.integer):
        raise InvalidInput(f"`faces` must be integer indices; got {faces.dtype}.")
    if faces.min() < 0 or faces.max() >= len(vertices):
        span = f"{faces.min()} to {faces.max()}"
        raise InvalidInput(f"`faces` must index the {len(vertices)} vertices from 0; got {span}.")
    if not np.isfinite(vertices).all():
        raise InvalidInput("`vertices` must be finite; got NaN or an infinity. Check the file.")
    if not FINEST < np.abs(vertices).max() < 1.0 / FINEST:
        size = np.abs(vertices).max()
        raise InvalidInput(f"`vertices` must lie within 1e±30 m; the largest coordinate is {size:.3g}. Check the unit.")
    return vertices, faces.astype(np.int64)


def triple_products(corners: Float64[np.ndarray, "m 3 3"]) -> Float64[np.ndarray, "m"]:
    """Return a · (b − a) × (c − a) (m,) of triangles (m, 3, 3), six times the tetrahedra's volumes."""
    a, b, c = np.moveaxis(corners, 1, 0)
    return np.einsum("mi,mi->m", a, np.cross(b - a, c - a))


def find_pieces(faces: Integer[np.ndarray, "m 3"]) -> list[Integer[np.ndarray, "_"]]:
    """Return the indices of the faces of each piece of surface that hangs together by edges."""
    from scipy.sparse import coo_array
    from scipy.sparse.csgraph import connected_components

    one, other, _ = _neighbours(*_edges(faces))
    graph = coo_array((np.ones(len(one), dtype=bool), (one, other)), shape=(len(faces),) * 2)
    count, labels = connected_components(graph, directed=False)
    order = np.argsort(labels, kind="stable")
    return np.split(order, np.cumsum(np.bincount(labels, minlength=count))[:-1])


def _edges(faces: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Return of each half-edge the number of its edge, its face, whether it runs forward; of each edge its uses."""
    ends = np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]])
    size = int(faces.max(initial=0)) + 1
    _, edges, uses = np.unique(ends.min(axis=1) * size + ends.max(axis=1), return_inverse=True, return_counts=True)
    return edges, np.tile(np.arange(len(faces)), 3), ends[:, 0] < ends[:, 1], uses


def _neighbours(
    edges: np.ndarray, face: np.ndarray, forward: np.ndarray, uses: np.ndarray
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return pairs of faces that share an edge with no third, and whether both run along it the same way."""
    order = np.argsort(edges, kind="stable")
    order = order[uses[edges[order]] == 2]
    one, other = order[::2], order[1::2]
    return face[one], face[other], forward[one] == forward[other]


def _orient_faces(faces: np.ndarray, one: np.ndarray, other: np.ndarray, clash: np.ndarray) -> np.ndarray:
    """Return the faces, in each piece turned like the first one.

    Each face stands twice in a graph, as it is and turned; neighbours are joined in the ways that agree. A surface
    with two sides falls apart into two copies.
    """
    from scipy.sparse import coo_array
    from scipy.sparse.csgraph import connected_components

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


def _volume(corners: np.ndarray) -> float:
    """Return the signed volume [m³] inside triangles (m, 3, 3), zero where it is not above rounding."""
    corners = corners - 0.5 * (corners.min(axis=(0, 1)) + corners.max(axis=(0, 1)))
    a, b, c = np.moveaxis(corners, 1, 0)
    sizes = np.linalg.norm(a, axis=1) * np.linalg.norm(np.cross(b - a, c - a), axis=1)
    volume = triple_products(corners).sum() / 6.0
    return float(volume) if abs(volume) > NO_VOLUME * sizes.sum() else 0.0


def _or_repair(repaired: bool) -> str:
    """Return the remedy "repair", if repair has not been tried yet."""
    return "" if repaired else f", or ask for repair ({ASKED})"


def _check_edges(faces: np.ndarray, repaired: bool) -> None:
    """Require that every edge is used once in each direction."""
    if (faces == np.roll(faces, 1, axis=1)).any():
        raise InvalidInput(f"the mesh has a triangle with a repeated corner. Ask for repair to drop it ({ASKED}).")
    edges, _, forward, uses = _edges(faces)
    balance = np.bincount(edges, weights=np.where(forward, 1.0, -1.0))
    if open_edges := int((uses == 1).sum()):
        raise InvalidInput(
            f"the mesh is open: {open_edges} edges border only one triangle, so it encloses nothing. "
            f"{'Repair fills small holes only; close' if repaired else 'Close'} the surface, or merge duplicate corners"
            f"{'' if repaired else f', or read the file with repair: {ASKED}'}."
        )
    if shared_edges := int((uses > 2).sum()):
        raise InvalidInput(
            f"the mesh is not a surface: {shared_edges} edges border more than two triangles. "
            "Drop duplicate triangles, or separate the bodies that touch there."
        )
    if clashing := int((balance != 0).sum()):
        raise InvalidInput(
            f"the mesh is wound inconsistently: {clashing} edges are not used once in each direction. "
            f"Turn the faces alike{_or_repair(repaired)}."
        )


def _check_crossings(vertices: np.ndarray, faces: np.ndarray, pieces: list[np.ndarray]) -> None:
    pair = find_crossing_faces(vertices, faces)
    if pair is None:
        return
    labels = np.empty(len(faces), dtype=int)
    for k, piece in enumerate(pieces):
        labels[piece] = k
    where = ", ".join(f"{x:.4g}" for x in vertices[faces[pair[0]]].mean(axis=0))
    if labels[pair[0]] == labels[pair[1]]:
        what = "its surface passes through itself"
    else:
        what = f"two of its {len(pieces)} pieces pass through each other"
    raise InvalidInput(
        f"the mesh overlaps itself: {what}, near ({where}) m, so that volume would count twice. Unite the parts first."
    )


def _check_nesting(volumes: np.ndarray, depth: np.ndarray, several: bool, repaired: bool) -> None:
    """Allow cavities inside a body, and several bodies if wanted."""
    if (twice := (volumes > 0) & (depth % 2 == 1)).any():
        raise InvalidInput(
            f"the mesh overlaps itself: {int(twice.sum())} of its {len(volumes)} pieces lie inside another one "
            f"and are turned outward, so that volume would count twice. Turn cavities inward{_or_repair(repaired)}."
        )
    if (inward := (volumes < 0) & (depth % 2 == 0)).any():
        raise InvalidInput(
            f"the mesh is inverted in part: {int(inward.sum())} of its {len(volumes)} pieces are turned inward, but "
            f"lie in no body. Turn them outward{_or_repair(repaired)}."
        )
    bodies = int((volumes > 0).sum())
    if bodies > 1 and not several:
        raise InvalidInput(
            f"the mesh holds {bodies} separate bodies, which need not move as one. "
            "Give them apart, or say that they are rigidly joined: several = true in a spec, several=True in Python."
        )
