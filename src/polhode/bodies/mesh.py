"""Homogeneous bodies bounded by triangle meshes, behind a gate: a bad mesh gives wrong moments without a sound."""

from __future__ import annotations

from itertools import combinations
from typing import Any

import numpy as np

from polhode.bodies.body import Body
from polhode.errors import InvalidInput

Array = Any
CROSSINGS_AT_ONCE = 1_000_000  # edge–triangle pairs tested together, about 100 MB


def from_mesh(
    vertices: Array, faces: Array, mass: float | None = None, density: float | None = None, several: bool = False
) -> Body:
    """Return the homogeneous body inside a closed triangle mesh.

    Args:
        vertices: (n, 3) corners [m].
        faces: (m, 3) indices of corners, counterclockwise seen from outside. A closed surface turned inward and lying
            inside another one is a cavity.
        mass: [kg]; this or ``density``.
        density: [kg/m³].
        several: accept disjoint pieces as one rigid body.

    Raises:
        InvalidInput: if the mesh is open, wound inconsistently, inverted, overlapping, or of several pieces; if not
            exactly one of mass and density is given, positive.

    Source: Mirtich, J. Graphics Tools 1 (1996) 31; as signed tetrahedra, Tonon, J. Math. Stat. 1 (2004) 8.
    """
    if (mass is None) == (density is None):
        raise InvalidInput("give exactly one of `mass` [kg] and `density` [kg/m³]; a mesh alone has neither.")
    for name, value in (("mass", mass), ("density", density)):
        if value is not None and not (np.isfinite(value) and value > 0):
            raise InvalidInput(f"`{name}` must be positive and finite; got {value!r}. Check sign and units.")
    vertices, faces = checked_mesh(vertices, faces, several)
    volume, center, covariance = volume_moments(vertices, faces)
    whole = float(mass if mass is not None else density * volume)  # type: ignore[operator]
    per_mass = covariance / volume
    return Body(whole, center, whole * (np.trace(per_mass) * np.eye(3) - per_mass))


def volume_moments(vertices: Array, faces: Array) -> tuple[float, Array, Array]:
    """Return volume [m³], centroid (3,) [m] and ∫ r rᵀ dV about the centroid (3, 3) [m⁵].

    Tetrahedra are taken from the middle of the mesh, then from the centroid, so that a mesh far from the origin loses
    no digits.
    """
    origin = 0.5 * (vertices.min(axis=0) + vertices.max(axis=0))
    corners = (vertices - origin)[faces]
    determinants = np.linalg.det(corners)
    volume = determinants.sum() / 6.0
    if volume == 0.0:
        return 0.0, origin, np.zeros((3, 3))
    center = (determinants[:, None] * corners.sum(axis=1)).sum(axis=0) / (24.0 * volume)
    corners = corners - center
    determinants = np.linalg.det(corners)
    sums = corners.sum(axis=1)
    squares = np.einsum("nki,nkj->nij", corners, corners) + np.einsum("ni,nj->nij", sums, sums)
    return float(volume), center + origin, np.einsum("n,nij->ij", determinants, squares) / 120.0


def checked_mesh(vertices: Array, faces: Array, several: bool = False) -> tuple[Array, Array]:
    """Return the mesh as arrays if it bounds a body; refuse it otherwise."""
    vertices, faces = _as_mesh(vertices, faces)
    _check_edges(faces)
    pieces = _pieces(faces)
    volumes = [volume_moments(vertices, faces[piece])[0] for piece in pieces]
    total = sum(volumes)
    if not abs(total) > 1e-12 * np.ptp(vertices, axis=0).max() ** 3:
        raise InvalidInput("the mesh encloses no volume; a flat surface is no body. Check the file and its scale.")
    if total < 0:
        raise InvalidInput(
            f"the mesh is inverted: its faces are turned inward and its volume is {total:g} m³. "
            "Turn the faces outward, or read the file with repair."
        )
    if len(pieces) > 1:
        _check_pieces(vertices, faces, pieces, volumes, several)
    return vertices, faces


def _as_mesh(vertices: Array, faces: Array) -> tuple[Array, Array]:
    vertices, faces = np.array(vertices, dtype=float), np.array(faces)
    if vertices.ndim != 2 or vertices.shape[1:] != (3,) or faces.ndim != 2 or faces.shape[1:] != (3,):
        raise InvalidInput(f"a mesh needs vertices (n, 3) and faces (m, 3); got {vertices.shape} and {faces.shape}.")
    if len(faces) < 4:
        raise InvalidInput(f"the mesh is open: a closed surface has at least 4 triangles; got {len(faces)}.")
    if not np.issubdtype(faces.dtype, np.integer):
        raise InvalidInput(f"`faces` must be integer indices; got {faces.dtype}.")
    if faces.min() < 0 or faces.max() >= len(vertices):
        found = f"{faces.min()} to {faces.max()}"
        raise InvalidInput(f"`faces` must index the {len(vertices)} vertices from 0; got {found}.")
    if not np.isfinite(vertices).all():
        raise InvalidInput("`vertices` must be finite; got NaN or an infinity. Check the file.")
    return vertices, faces.astype(np.int64)


def _check_edges(faces: Array) -> None:
    """Require that every edge is used once in each direction."""
    edges = np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]])
    if (edges[:, 0] == edges[:, 1]).any():
        raise InvalidInput("the mesh has a triangle with a repeated corner. Read the file with repair to drop it.")
    low, high = edges.min(axis=1), edges.max(axis=1)
    unique, index = np.unique(np.column_stack([low, high]), axis=0, return_inverse=True)
    index = index.reshape(-1)
    uses = np.bincount(index, minlength=len(unique))
    balance = np.bincount(index, weights=np.where(edges[:, 0] == low, 1.0, -1.0), minlength=len(unique))
    if (uses == 1).any():
        raise InvalidInput(
            f"the mesh is open: {int((uses == 1).sum())} edges border only one triangle, so it encloses nothing. "
            "Close the surface, merge duplicate corners, or read the file with repair."
        )
    if (balance != 0).any():
        raise InvalidInput(
            f"the mesh is wound inconsistently: {int((balance != 0).sum())} edges are not used once in each direction. "
            "Read the file with repair to turn the faces alike."
        )
    if (uses > 2).any():
        raise InvalidInput(
            f"the mesh is not a surface: {int((uses > 2).sum())} edges border more than two triangles. "
            "Split the bodies that touch there."
        )


def _pieces(faces: Array) -> list[Array]:
    """Return the indices of the faces of each connected piece."""
    from scipy.sparse import coo_array
    from scipy.sparse.csgraph import connected_components

    n = int(faces.max()) + 1
    rows = np.concatenate([faces[:, 0], faces[:, 1]])
    columns = np.concatenate([faces[:, 1], faces[:, 2]])
    _, labels = connected_components(coo_array((np.ones(len(rows)), (rows, columns)), shape=(n, n)), directed=False)
    of_face = labels[faces[:, 0]]
    return [np.flatnonzero(of_face == label) for label in np.unique(of_face)]


def _check_pieces(vertices: Array, faces: Array, pieces: list[Array], volumes: list[float], several: bool) -> None:
    """Allow cavities inside a body, disjoint bodies if wanted, and nothing that overlaps."""
    depth = np.zeros(len(pieces), dtype=int)
    boxes = [(vertices[faces[p]].min(axis=(0, 1)), vertices[faces[p]].max(axis=(0, 1))) for p in pieces]
    for i, j in combinations(range(len(pieces)), 2):
        if (boxes[i][0] > boxes[j][1]).any() or (boxes[j][0] > boxes[i][1]).any():
            continue
        if _cross(vertices, faces[pieces[i]], faces[pieces[j]]) or _cross(vertices, faces[pieces[j]], faces[pieces[i]]):
            raise InvalidInput(
                f"the mesh overlaps itself: two of its {len(pieces)} pieces pass through each other, "
                "so their common volume would count twice. Unite them first."
            )
        depth[i] += _inside(vertices[faces[pieces[i][0], 0]], vertices[faces[pieces[j]]])
        depth[j] += _inside(vertices[faces[pieces[j][0], 0]], vertices[faces[pieces[i]]])
    for k, volume in enumerate(volumes):
        if (volume > 0) != (depth[k] % 2 == 0):
            what = "lies inside another one and is turned outward" if volume > 0 else "is turned inward"
            raise InvalidInput(
                f"the mesh overlaps itself or is inverted in part: one of its {len(pieces)} pieces {what}. "
                "A cavity must be turned inward, a body outward."
            )
    bodies = int((depth % 2 == 0).sum())
    if bodies > 1 and not several:
        raise InvalidInput(
            f"the mesh holds {bodies} separate bodies, which need not move as one. "
            "Give them apart, or say that they are rigidly joined (several)."
        )


def _cross(vertices: Array, edges_of: Array, faces: Array) -> bool:
    """Whether an edge of the first faces meets one of the second ones (Möller–Trumbore, borders included)."""
    edges = np.unique(np.sort(np.concatenate([edges_of[:, [0, 1]], edges_of[:, [1, 2]], edges_of[:, [2, 0]]])), axis=0)
    a, b, c = (vertices[faces[:, k]] for k in range(3))
    for start in range(0, len(edges), max(1, CROSSINGS_AT_ONCE // len(faces))):
        part = edges[start : start + max(1, CROSSINGS_AT_ONCE // len(faces))]
        origin, way = vertices[part[:, 0]][:, None], (vertices[part[:, 1]] - vertices[part[:, 0]])[:, None]
        normal = np.cross(way, (c - a)[None])
        det = np.einsum("mk,nmk->nm", b - a, normal)
        with np.errstate(divide="ignore", invalid="ignore"):
            u = np.einsum("nmk,nmk->nm", origin - a, normal) / det
            other = np.cross(origin - a, (b - a)[None])
            v = np.einsum("nmk,nmk->nm", np.broadcast_to(way, other.shape), other) / det
            t = np.einsum("mk,nmk->nm", c - a, other) / det
            hit = (u >= 0) & (v >= 0) & (u + v <= 1) & (t >= 0) & (t <= 1)
        if hit.any():
            return True
    return False


def _inside(point: Array, triangles: Array) -> bool:
    """Whether the winding number of the triangles about the point is not zero (van Oosterom & Strackee 1983)."""
    a, b, c = np.moveaxis(triangles - point, 1, 0)
    na, nb, nc = (np.linalg.norm(x, axis=1) for x in (a, b, c))
    numerator = np.einsum("ni,ni->n", a, np.cross(b, c))
    ab, bc, ca = (np.einsum("ni,ni->n", x, y) for x, y in ((a, b), (b, c), (c, a)))
    angle = 2.0 * np.arctan2(numerator, na * nb * nc + ab * nc + bc * na + ca * nb).sum()
    return abs(angle) > 2.0 * np.pi
