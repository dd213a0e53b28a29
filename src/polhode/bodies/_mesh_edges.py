"""Edges of triangle meshes, and which faces belong together across them.

Two faces on an edge are neighbours. On an edge with more of them, bodies touch, or a body touches itself: sorted by
angle about the edge, faces open and close sectors of material like brackets, and each pair of brackets belongs
together. Faces connected by such pairs form a closed surface, since each pair uses its edge once in each direction.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from polhode._base.extras import needing
from polhode.types import Bool, Float64, Integer


class EdgeLimits(NamedTuple):
    """A number that decides whether faces at an edge are coplanar."""

    max_angle: float = 1e-5  # rad: coplanar faces in single precision, triangulated in different ways


LIMITS = EdgeLimits()


class Edges(NamedTuple):
    """The edges of a mesh, by its half-edges (h,) of faces (m, 3).

    Attributes:
        number: (h,) of its edge.
        face: (h,) that it belongs to.
        forward: (h,) whether it runs from the smaller to the larger index of a corner.
        uses: (edges,) how many half-edges each one has.
        balance: (edges,) of these forward less those backward.
        ends: (h, 2) corners, in the order of the face.
    """

    number: Integer[np.ndarray, "h"]
    face: Integer[np.ndarray, "h"]
    forward: Bool[np.ndarray, "h"]
    uses: Integer[np.ndarray, "edges"]
    balance: Integer[np.ndarray, "edges"]
    ends: Integer[np.ndarray, "h 2"]


def find_edges(faces: Integer[np.ndarray, "m 3"]) -> Edges:
    """Return the edges of a mesh."""
    ends = np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]])
    size = int(faces.max(initial=0)) + 1
    _, number, uses = np.unique(ends.min(axis=1) * size + ends.max(axis=1), return_inverse=True, return_counts=True)
    forward = ends[:, 0] < ends[:, 1]
    balance = np.rint(np.bincount(number, weights=np.where(forward, 1.0, -1.0), minlength=len(uses))).astype(int)
    return Edges(number, np.tile(np.arange(len(faces)), 3), forward, uses, balance, ends)


def find_neighbours(edges: Edges) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return pairs of faces that share an edge with no third, and whether both run along it in one direction."""
    order = np.argsort(edges.number, kind="stable")
    order = order[edges.uses[edges.number[order]] == 2]
    one, other = order[::2], order[1::2]
    return edges.face[one], edges.face[other], edges.forward[one] == edges.forward[other]


def find_pieces(
    vertices: Float64[np.ndarray, "n 3"], faces: Integer[np.ndarray, "m 3"]
) -> list[Integer[np.ndarray, "_"]]:
    """Return the indices of the faces of each closed piece of surface; every edge is used evenly both ways."""
    with needing("Bodies of meshes need", alone=True):
        from scipy.sparse import coo_array
        from scipy.sparse.csgraph import connected_components

    edges = find_edges(faces)
    one, other, _ = find_neighbours(edges)
    pairs = [(one, other)]
    if (edges.uses > 2).any():
        pairs.append(_pair_on_shared_edges(vertices, faces, edges))
    one, other = (np.concatenate(column) for column in zip(*pairs, strict=True))
    graph = coo_array((np.ones(len(one), dtype=bool), (one, other)), shape=(len(faces),) * 2)
    count, labels = connected_components(graph, directed=False)
    order = np.argsort(labels, kind="stable")
    return np.split(order, np.cumsum(np.bincount(labels, minlength=count))[:-1])


def _pair_on_shared_edges(vertices: np.ndarray, faces: np.ndarray, edges: Edges) -> tuple[np.ndarray, np.ndarray]:
    """Return pairs of faces that bound one sector of material at an edge of more than two faces."""
    half = np.flatnonzero(edges.uses[edges.number] > 2)
    half = half[np.argsort(edges.number[half], kind="stable")]
    number, face, opens = edges.number[half], edges.face[half], ~edges.forward[half]
    angle = _angles(vertices, faces, edges, half)
    one: list[int] = []
    other: list[int] = []
    for group in np.split(np.arange(len(half)), np.flatnonzero(np.diff(number)) + 1):
        for start, end in _match_brackets(angle[group], opens[group]):
            one.append(int(face[group[start]]))
            other.append(int(face[group[end]]))
    return np.array(one, dtype=int), np.array(other, dtype=int)


def _angles(vertices: np.ndarray, faces: np.ndarray, edges: Edges, half: np.ndarray) -> np.ndarray:
    """Return the angle (k,) of each half-edge's face about its edge, which points to the larger index.

    The outside of a face that runs forward is on the side of larger angles: it closes a sector of material.
    """
    low, high = np.sort(edges.ends[half], axis=1).T
    third = faces[edges.face[half]].sum(axis=1) - low - high
    along = vertices[high] - vertices[low]
    size = np.linalg.norm(along, axis=1, keepdims=True)
    along = along / np.where(size > 0.0, size, 1.0)
    least = np.eye(3)[np.abs(along).argmin(axis=1)]
    across = np.cross(along, least)
    across /= np.linalg.norm(across, axis=1, keepdims=True)
    up = np.cross(along, across)
    out = vertices[third] - vertices[low]
    return np.arctan2(np.einsum("ki,ki->k", up, out), np.einsum("ki,ki->k", across, out))


def _match_brackets(angle: np.ndarray, opens: np.ndarray) -> list[tuple[int, int]]:
    """Return pairs of an opening and a closing face; at equal angles sectors end before others begin."""
    order = np.argsort(angle, kind="stable")
    beyond = np.diff(angle[order], prepend=angle[order[0]]) > LIMITS.max_angle
    level = np.cumsum(beyond)
    if level[-1] and angle[order[0]] + 2.0 * np.pi - angle[order[-1]] <= LIMITS.max_angle:
        level[level == level[-1]] = 0  # the turn begins in the middle of a direction
    order = order[np.lexsort((opens[order], level))]
    depth = np.cumsum(np.where(opens[order], 1, -1))
    order = np.roll(order, -(int(depth.argmin()) + 1))  # from where least material is open
    waiting: list[int] = []
    pairs = []
    for k in order:
        if opens[k]:
            waiting.append(int(k))
        elif waiting:
            pairs.append((waiting.pop(), int(k)))
    return pairs
