"""Whether triangles pass through each other, and which closed surfaces lie inside which."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from polhode.errors import InvalidInput
from polhode.types import Float64, Integer


class CrossingLimits(NamedTuple):
    """Numbers that decide whether faces of a mesh cross and whether a piece lies inside another."""

    # of the mesh's extent: contact, and what single-precision files make of it, is not a crossing
    contact_depth: float = 1e-6
    winding_rounding: float = 1e-13  # of the extent, squared: rounding of products of two coordinates
    near_triangle: float = 1e-9  # of the extent: points closer to a triangle are checked by solid angles
    max_faces_tested: int = 64  # of one piece, for whether they lie inside another


LIMITS = CrossingLimits()


def find_crossing_faces(
    vertices: Float64[np.ndarray, "n 3"], faces: Integer[np.ndarray, "m 3"]
) -> tuple[int, int] | None:
    """Return two faces of which an edge of the first pierces the second, None if there are none.

    The edge must end clearly on both sides and pass clearly through the inside, so that surfaces may touch.
    """
    used = vertices[faces]
    clear = LIMITS.contact_depth * np.ptp(used, axis=(0, 1)).max()
    ends = np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]])
    first = np.flatnonzero(ends[:, 0] < ends[:, 1])  # each edge of a closed surface once
    ends = ends[first]
    points = vertices[ends]
    edge_boxes = np.stack([points.min(axis=1), points.max(axis=1)], axis=1)
    face_boxes = np.stack([used.min(axis=1), used.max(axis=1)], axis=1)
    for edge, face in _find_overlaps(edge_boxes, face_boxes):
        apart = ~(ends[edge][:, :, None] == faces[face][:, None, :]).any(axis=(1, 2))
        edge, face = edge[apart], face[apart]
        hit = _pierces(points[edge], used[face], clear)
        if hit.any():
            k = int(np.flatnonzero(hit)[0])
            return int(first[edge[k]] % len(faces)), int(face[k])
    return None


def _find_overlaps(one: np.ndarray, other: np.ndarray) -> Iterator[tuple[np.ndarray, np.ndarray]]:
    """Yield index pairs of boxes (n, 2, 3) that overlap, some at a time, by halving both sets in space."""
    leaf = 150_000  # pairs of boxes compared at once; smaller sets cost calls, larger ones needless comparisons
    stack = [(np.arange(len(one)), np.arange(len(other)))]
    while stack:
        i, j = stack.pop()
        low = np.maximum(one[i, 0].min(axis=0), other[j, 0].min(axis=0))
        high = np.minimum(one[i, 1].max(axis=0), other[j, 1].max(axis=0))
        i = i[((one[i, 0] <= high) & (one[i, 1] >= low)).all(axis=1)]
        j = j[((other[j, 0] <= high) & (other[j, 1] >= low)).all(axis=1)]
        if len(i) == 0 or len(j) == 0:
            continue
        if len(i) * len(j) <= leaf:
            (a, b), (c, d) = np.moveaxis(one[i], 0, -1), np.moveaxis(other[j], 0, -1)
            near = np.ones((len(i), len(j)), dtype=bool)
            for axis in range(3):
                near &= (a[axis][:, None] <= d[axis]) & (c[axis] <= b[axis][:, None])
            k, m = np.nonzero(near)
            yield i[k], j[m]
            continue
        middles = one[i].mean(axis=1) if len(i) > len(j) else other[j].mean(axis=1)
        axis = int(np.argmax(np.ptp(middles, axis=0)))
        order = np.argsort(middles[:, axis], kind="stable")
        for half in np.array_split(order, 2):
            stack.append((i[half], j) if len(i) > len(j) else (i, j[half]))


def _pierces(segments: np.ndarray, triangles: np.ndarray, clear: float) -> np.ndarray:
    """Whether each segment (k, 2, 3) passes through its triangle (k, 3, 3), clear of its ends and of the borders."""
    a, b, c = np.moveaxis(triangles, 1, 0)
    p, q = np.moveaxis(segments, 1, 0)
    normal = np.cross(b - a, c - a)
    area = np.linalg.norm(normal, axis=1)
    ok = area > 0
    normal = normal / np.where(ok, area, 1.0)[:, None]
    before, after = np.einsum("ki,ki->k", normal, p - a), np.einsum("ki,ki->k", normal, q - a)
    ok &= (before * after < 0) & (np.minimum(np.abs(before), np.abs(after)) > clear)
    # the place on the edge where the distance from the plane is zero, inside if it is left of all three sides
    t = before / np.where(ok, before - after, 1.0)
    x = p + t[:, None] * (q - p)
    for start, end in ((a, b), (b, c), (c, a)):
        side = np.cross(end - start, x - start)
        length = np.linalg.norm(end - start, axis=1)
        ok &= np.einsum("ki,ki->k", side, normal) > clear * length
    return ok


def depths(corners: Float64[np.ndarray, "m 3 3"], pieces: list[np.ndarray]) -> Integer[np.ndarray, "pieces"]:
    """Return in how many other pieces each one lies (p,), for closed pieces of triangles (m, 3, 3) that do not cross.

    Raises:
        InvalidInput: if a piece lies partly inside another one, or in the very same place.
    """
    result = np.zeros(len(pieces), dtype=int)
    low = np.array([corners[piece].min(axis=(0, 1)) for piece in pieces])
    high = np.array([corners[piece].max(axis=(0, 1)) for piece in pieces])
    clear = LIMITS.contact_depth * (high.max(axis=0) - low.min(axis=0)).max()
    projections: dict[int, _Projected] = {}
    for i, piece in enumerate(pieces):
        # only what reaches into another's box can lie inside it or share volume with it
        near = ((low < high[i] - clear) & (high > low[i] + clear)).all(axis=1)
        for j in np.flatnonzero(near):
            if i != j:
                if int(j) not in projections:
                    projections[int(j)] = _Projected.of(corners[pieces[j]])
                result[i] += _lies_inside(corners[piece], projections[int(j)], clear)
    return result


def find_miscounted_face(corners: Float64[np.ndarray, "m 3 3"], pieces: list[np.ndarray]) -> int | None:
    """Return a face with a winding number other than 0 and 1 on one side, from samples of each piece; None without one.

    Around a point of the body the whole surface winds once, around others not at all.
    """
    places = [np.unique(np.linspace(0, len(piece) - 1, LIMITS.max_faces_tested // 4).astype(int)) for piece in pieces]
    chosen = np.concatenate([piece[place] for piece, place in zip(pieces, places, strict=True)])
    a, b, c = np.moveaxis(corners[chosen], 1, 0)
    normal = np.cross(b - a, c - a)
    area = np.linalg.norm(normal, axis=1, keepdims=True)
    size = np.ptp(corners, axis=(0, 1)).max()
    clear = 10.0 * LIMITS.contact_depth * size
    # corners as far from every side as this; on smaller faces the shift leaves the neighbourhood of the face
    wide = area[:, 0] > clear * size
    shift = clear * normal / np.where(area > 0.0, area, 1.0)
    middles, projection = corners[chosen].mean(axis=1), _Projected.of(corners)
    for side in (shift, -shift):
        wound = _winding_number((middles + side)[wide], projection)
        if (wrong := np.flatnonzero((wound != 0.0) & (wound != 1.0))).size:
            return int(chosen[wide][wrong[0]])
    return None


def _lies_inside(piece: np.ndarray, other: _Projected, clear: float) -> bool:
    """Whether a closed piece lies inside another one, tested at some faces, just above and just below each.

    Faces that lie in the other surface differ in that, and decide nothing.
    """
    middles = piece.mean(axis=1)
    chosen = np.linspace(0, len(piece) - 1, min(LIMITS.max_faces_tested, len(piece))).astype(int)
    chosen = np.unique(np.concatenate([chosen, middles.argmin(axis=0), middles.argmax(axis=0)]))
    a, b, c = np.moveaxis(piece[chosen], 1, 0)
    normal = np.cross(b - a, c - a)
    area = np.linalg.norm(normal, axis=1, keepdims=True)
    shift = 0.5 * clear * normal / np.where(area > 0, area, 1.0)
    above = _winding_number(middles[chosen] + shift, other)
    below = _winding_number(middles[chosen] - shift, other)
    same = above == below
    inside = above[same] != 0
    if inside.size == 0:
        raise InvalidInput("the mesh overlaps itself: two of its pieces lie in the same place. Drop one of them.")
    if inside.any() != inside.all():
        raise InvalidInput(
            "the mesh overlaps itself: one of its pieces lies partly inside another one, so that volume would count "
            "twice. Unite the parts first."
        )
    return bool(inside[0])


def _winding_number(points: np.ndarray, triangles: _Projected) -> np.ndarray:
    """Return how often closed triangles wind around points (k, 3).

    A ray in an odd direction is counted through the triangles, outward ways less inward ones; a point whose ray passes
    close to an edge, or that is close to a triangle, is tested by solid angles, which take a hundred times as long.
    """
    at = (points - triangles.origin) @ _ODD_AXES / triangles.size
    low, high = triangles.low, triangles.high
    ray, face = np.nonzero(
        (low[0] <= at[:, :1]) & (at[:, :1] <= high[0]) & (low[1] <= at[:, 1:2]) & (at[:, 1:2] <= high[1])
    )
    corners = triangles.projected[face] - at[ray][:, None, :]
    (a, b, c), up = np.moveaxis(corners[:, :, :2], 1, 0), corners[:, :, 2]
    turns = np.stack([p[:, 0] * q[:, 1] - p[:, 1] * q[:, 0] for p, q in ((b, c), (c, a), (a, b))], axis=1)
    within = (turns > -LIMITS.winding_rounding).all(axis=1) | (turns < LIMITS.winding_rounding).all(axis=1)
    ray, turns, up = ray[within], turns[within], up[within]
    # each side's turn is twice the area opposite to the third corner: its weight where the ray meets the triangle
    whole = turns.sum(axis=1)
    height = np.einsum("kn,kn->k", turns, up) / np.where(whole == 0.0, 1.0, whole)
    unsure = (np.abs(turns) <= LIMITS.winding_rounding).any(axis=1) | (np.abs(height) <= LIMITS.near_triangle)
    ways = np.where(height > 0.0, np.sign(turns[:, 0]), 0.0)
    result = np.rint(np.bincount(ray, weights=ways, minlength=len(points)))
    for k in np.unique(ray[unsure]):
        result[k] = _solid_angle(points[k], triangles.corners)
    return result


class _Projected(NamedTuple):
    """Triangles (m, 3, 3) projected along the ray, and the boxes around their projections."""

    corners: np.ndarray
    origin: np.ndarray
    size: float
    projected: np.ndarray
    low: np.ndarray
    high: np.ndarray

    @classmethod
    def of(cls, triangles: np.ndarray) -> _Projected:
        origin = triangles.reshape(-1, 3).mean(axis=0)
        size = float(np.abs(triangles - origin).max()) or 1.0
        projected = (triangles - origin) @ _ODD_AXES / size
        flat = projected[:, :, :2]
        return cls(triangles, origin, size, projected, flat.min(axis=1).T.copy(), flat.max(axis=1).T.copy())


def _solid_angle(point: np.ndarray, triangles: np.ndarray) -> float:
    """Return how often closed triangles (m, 3, 3) wind around a point (3,), by the sum of their solid angles.

    Source: van Oosterom & Strackee, IEEE Trans. Biomed. Eng. 30 (1983) 125, eq. 8.
    """
    a, b, c = np.moveaxis(triangles - point, 1, 0)
    la, lb, lc = (np.linalg.norm(x, axis=1) for x in (a, b, c))
    volume = np.einsum("ni,ni->n", a, np.cross(b, c))
    ab, bc, ca = (np.einsum("ni,ni->n", x, y) for x, y in ((a, b), (b, c), (c, a)))
    return float(np.rint(np.arctan2(volume, la * lb * lc + ab * lc + bc * la + ca * lb).sum() / (2.0 * np.pi)))


def _odd_axes() -> np.ndarray:
    """Return a rotation (3, 3) by columns along no axis, face or diagonal of usual drawings."""
    axes, _ = np.linalg.qr(np.array([[1.0, 0.3194, 0.1237], [0.2713, -1.0, 0.4561], [0.4129, 0.1873, 1.0]]))
    axes[:, 2] *= np.sign(np.linalg.det(axes))
    return axes


_ODD_AXES = _odd_axes()
