"""Checks of meshes: a bad one would silently give wrong moments, so each fault is an error of its own.

A mesh that passes is a closed surface, each edge used as often in one direction as in the other, that winds once around
every point of the body and not at all around any other: pieces neither cross nor contain each other, but for cavities.
They may touch by a face, an edge or a corner.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from polhode.bodies._mesh_crossing import depths, find_crossing_faces, find_miscounted_face
from polhode.bodies._mesh_edges import find_edges, find_pieces
from polhode.errors import InvalidInput
from polhode.types import ArrayLike, Float64, Integer, Real

ASKED = "repair = true in a spec, repair=True in Python"


class MeshLimits(NamedTuple):
    """Numbers that decide whether a mesh is refused."""

    min_extent: float = 1e-30  # m, and its reciprocal; fifth powers of coordinates must neither overflow nor underflow
    # of the tetrahedra's own size: a flat surface leaves rounding, a foil of 1e-9 of its width far more
    min_relative_volume: float = 1e-12


LIMITS = MeshLimits()


def check_mesh(
    vertices: Real[ArrayLike, "n 3"], faces: Real[ArrayLike, "m 3"], several: bool = False, repaired: bool = False
) -> tuple[Float64[np.ndarray, "n 3"], Integer[np.ndarray, "m 3"]]:
    """Return the mesh as arrays if it bounds a body.

    Args:
        vertices: (n, 3) corners [m].
        faces: (m, 3) indices of corners.
        several: whether disjoint bodies are accepted.
        repaired: whether it was repaired already, so that no message advises repair.

    Raises:
        InvalidInput: naming the fault and the remedy.
    """
    vertices, faces = as_mesh(vertices, faces)
    _check_edges(faces, repaired)
    pieces = find_pieces(vertices, faces)
    corners = vertices[faces]
    volumes = np.array([find_volume(corners[piece]) for piece in pieces])
    if not volumes.any():
        raise InvalidInput("the mesh encloses no volume; a flat surface is not a body. Check the file and its scale.")
    if volumes.sum() < 0:
        raise InvalidInput(
            f"the mesh is inverted: its faces are turned inward and its volume is {volumes.sum():.6g} m³. "
            f"Turn the faces outward{_or_repair(repaired)}."
        )
    _check_crossings(vertices, faces, pieces)
    # a piece that encloses nothing, such as a flap of two faces back to back, does not change the volume
    thick = [piece for piece, volume in zip(pieces, volumes, strict=True) if volume]
    if len(thick) > 1:
        _check_nesting(volumes[volumes != 0.0], depths(corners, thick), several, repaired)
    if (find_edges(faces).uses > 2).any() and (face := find_miscounted_face(corners, thick)) is not None:
        raise InvalidInput(
            f"the mesh overlaps itself near ({_near(corners[face])}) m, where some of its volume would count twice, or "
            "as outside. Unite the parts first."
        )
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
    if not LIMITS.min_extent < np.abs(vertices).max() < 1.0 / LIMITS.min_extent:
        size = np.abs(vertices).max()
        raise InvalidInput(f"`vertices` must lie within 1e±30 m; the largest coordinate is {size:.3g}. Check the unit.")
    return vertices, faces.astype(np.int64)


def triple_products(corners: Float64[np.ndarray, "m 3 3"]) -> Float64[np.ndarray, "m"]:
    """Return a · (b − a) × (c − a) (m,) of triangles (m, 3, 3), six times the tetrahedra's volumes."""
    a, b, c = np.moveaxis(corners, 1, 0)
    return np.einsum("mi,mi->m", a, np.cross(b - a, c - a))


def find_volume(corners: np.ndarray) -> float:
    """Return the signed volume [m³] inside triangles (m, 3, 3), zero where it is not above rounding."""
    corners = corners - 0.5 * (corners.min(axis=(0, 1)) + corners.max(axis=(0, 1)))
    a, b, c = np.moveaxis(corners, 1, 0)
    sizes = np.linalg.norm(a, axis=1) * np.linalg.norm(np.cross(b - a, c - a), axis=1)
    volume = triple_products(corners).sum() / 6.0
    return float(volume) if abs(volume) > LIMITS.min_relative_volume * sizes.sum() else 0.0


def _or_repair(repaired: bool) -> str:
    """Return the remedy "repair", if repair has not been tried yet."""
    return "" if repaired else f", or ask for repair ({ASKED})"


def _check_edges(faces: np.ndarray, repaired: bool) -> None:
    """Require that every edge is used as often in one direction as in the other, and no triangle twice."""
    if (faces == np.roll(faces, 1, axis=1)).any():
        raise InvalidInput(f"the mesh has a triangle with a repeated corner. Ask for repair to drop it ({ASKED}).")
    _, twice = np.unique(np.sort(faces, axis=1) * find_parity(faces)[:, None], axis=0, return_counts=True)
    if doubled := int((twice > 1).sum()):
        raise InvalidInput(
            f"the mesh is not a surface: {doubled} of its triangles are there more than once, turned the same "
            "way, so that "
            f"volume would count twice. Drop the copies{_or_repair(repaired)}."
        )
    edges = find_edges(faces)
    if open_edges := int((edges.uses == 1).sum()):
        raise InvalidInput(
            f"the mesh is open: {open_edges} edges border only one triangle, so it encloses nothing. "
            + ("Repair closes holes up to a twentieth of the mesh wide, and those of one or two lost triangles. Close "
               "the surface; a sheet is a part with shell = true."
               if repaired else
               f"Close the surface, or merge duplicate corners, or read the file with repair: {ASKED}.")
        )
    if shared := int(((edges.uses > 2) & (edges.balance != 0)).sum()):
        raise InvalidInput(
            f"the mesh is not a surface: {shared} edges border more than two triangles, and not as many one way round "
            "as the other. Drop duplicate triangles and walls inside the body."
        )
    if clashing := int((edges.balance != 0).sum()):
        raise InvalidInput(
            f"the mesh is wound inconsistently: {clashing} edges are not used once in each direction. "
            f"Turn the faces alike{_or_repair(repaired)}."
        )


def find_parity(faces: np.ndarray) -> np.ndarray:
    """Return 1 or −1 (m,): whether the corners of each triangle are an even or an odd permutation of ascending ones."""
    a, b, c = faces.T
    return np.where((a < b) ^ (b < c) ^ (c < a), -1, 1)


def _near(corners: np.ndarray) -> str:
    return ", ".join(f"{x:.4g}" for x in corners.mean(axis=0))


def _check_crossings(vertices: np.ndarray, faces: np.ndarray, pieces: list[np.ndarray]) -> None:
    pair = find_crossing_faces(vertices, faces)
    if pair is None:
        return
    labels = np.empty(len(faces), dtype=int)
    for k, piece in enumerate(pieces):
        labels[piece] = k
    where = _near(vertices[faces[pair[0]]])
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
