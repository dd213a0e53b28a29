"""Notes on parts that overlap: cuts that stick out, and material that is counted twice.

Masses and moments are sums over the parts, which ignore overlaps. Points in a part, by the winding number of its
surface, show how much of it lies in another.

Source: van Oosterom & Strackee, "The solid angle of a plane triangle", IEEE Trans. Biomed. Eng. 30 (1983) 125.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from itertools import combinations
from pathlib import Path
from typing import NamedTuple

import numpy as np

from polhode.bodies.surface import Surface
from polhode.spec.assembly import NO_DENSITY, name_of
from polhode.spec.models import PartTable
from polhode.spec.surfaces import surface_of_part
from polhode.types import Array, Bool, Float64


class OverlapLimits(NamedTuple):
    """Numbers that decide whether an overlap of parts is reported, and the number of points that decide."""

    min_share: float = 0.05  # of a part: a larger overlap is real, given flat facets and few points
    max_work: int = 4_000_000  # points times triangles; fewer points are taken where they would exceed it


LIMITS = OverlapLimits()


def notes_on_places(parts: Sequence[PartTable], density: float | None, folder: Path) -> tuple[str, ...]:
    """Return a sentence for each pair of parts placed so that their sum is probably not the intended body.

    Args:
        parts: of a body.
        density: of parts that give neither mass nor density [kg/m³], or None.
        folder: from which paths of meshes count.
    """
    return (*_notes_on_twins(parts), *_notes_on_solids(parts, density, folder))


def _notes_on_twins(parts: Sequence[PartTable]) -> Iterator[str]:
    plain = [part.model_dump(exclude={"name"}) for part in parts]
    for k, j in combinations(range(len(parts)), 2):
        if plain[k] == plain[j]:
            both = "both are taken away" if parts[k].cut else "the masses of both count"
            yield f"{_names(parts, k, j)} are the same thing in the same place; {both}."


def _notes_on_solids(parts: Sequence[PartTable], density: float | None, folder: Path) -> Iterator[str]:
    solid = {k: surface_of_part(part, folder) for k, part in enumerate(parts) if _is_solid(part)}
    drawn = {k: surface for k, surface in solid.items() if surface is not None}
    whole = all(part.cut or k in drawn or part.shape in NO_DENSITY for k, part in enumerate(parts))
    cuts, kept = [k for k in drawn if parts[k].cut], [k for k in drawn if not parts[k].cut]
    for k in cuts if whole and kept else []:
        outside = 1.0 - _share_inside(drawn[k], [drawn[j] for j in kept])
        if outside > LIMITS.min_share:
            yield (
                f"{name_of(parts[k], k)}, a cut, sticks out: about {100.0 * outside:.0f} % of it lies in no part, and "
                "mass is taken away there as well. Check its place and size."
            )
    of_material = [k for k in kept if parts[k].mass is None and (parts[k].density or density)]
    for group, what in ((cuts, "is taken away twice"), (of_material, "counts twice")):
        for k, j in combinations(group, 2):
            if parts[k].model_dump(exclude={"name"}) == parts[j].model_dump(exclude={"name"}):
                continue  # reported as twins
            small, large = sorted((k, j), key=lambda n: _box_volume(drawn[n]))
            shared = _share_inside(drawn[small], [drawn[large]])
            if shared > LIMITS.min_share:
                yield (
                    f"{_names(parts, k, j)} overlap: about {100.0 * shared:.0f} % of {name_of(parts[small], small)} "
                    f"lies in {name_of(parts[large], large)}, and what is there {what}."
                )


def _is_solid(part: PartTable) -> bool:
    known = part.mesh is not None or (part.shape is not None and part.shape not in NO_DENSITY)
    return known and not part.is_shell


def _names(parts: Sequence[PartTable], k: int, j: int) -> str:
    return f"{name_of(parts[k], k)} and {name_of(parts[j], j)}"


def _box_volume(surface: Surface) -> float:
    return float(np.prod(np.ptp(surface.vertices, axis=0)))


def _share_inside(one: Surface, others: Sequence[Surface]) -> float:
    """Return which share of the volume inside a surface lies inside any of others."""
    most_points = 600  # in the box about a part, of which those in the part count
    fewest_points = 100
    low, high = one.vertices.min(axis=0), one.vertices.max(axis=0)
    near = [other for other in others if _boxes_meet(low, high, other)]
    if not near:
        return 0.0
    most = max(len(surface.faces) for surface in (one, *near))
    points = low + (high - low) * _spread_points(max(fewest_points, min(most_points, LIMITS.max_work // most)))
    points = points[_is_inside(points, one)]
    if not len(points):
        return 0.0
    covered = np.zeros(len(points), dtype=bool)
    for other in near:
        covered[~covered] = _is_inside(points[~covered], other)
    return float(covered.mean())


def _boxes_meet(low: Float64[Array, "3"], high: Float64[Array, "3"], other: Surface) -> bool:
    return bool((other.vertices.min(axis=0) < high).all() and (other.vertices.max(axis=0) > low).all())


def _spread_points(count: int) -> Float64[Array, "n 3"]:
    """Return Halton's points in the unit cube, which are not random."""
    bases = (2, 3, 5)
    return np.array([[_radical_inverse(k, base) for base in bases] for k in range(1, count + 1)])


def _radical_inverse(number: int, base: int) -> float:
    value, scale = 0.0, 1.0 / base
    while number:
        number, digit = divmod(number, base)
        value, scale = value + digit * scale, scale / base
    return value


def _is_inside(points: Float64[Array, "n 3"], surface: Surface) -> Bool[Array, "n"]:
    """Return of which points the winding number is nearer to ±1 than to 0."""
    corners, inside = surface.vertices[surface.faces], np.zeros(len(points), dtype=bool)
    step = max(1, LIMITS.max_work // (10 * len(corners)))
    for begin in range(0, len(points), step):
        relative = corners[None] - points[begin : begin + step, None, None]
        a, b, c = (relative[:, :, k] for k in range(3))
        sizes = [np.linalg.norm(x, axis=-1) for x in (a, b, c)]
        volume = np.sum(a * np.cross(b, c), axis=-1)
        flat = sizes[0] * sizes[1] * sizes[2] + np.sum(a * b, axis=-1) * sizes[2]
        flat = flat + np.sum(b * c, axis=-1) * sizes[0] + np.sum(c * a, axis=-1) * sizes[1]
        angle = 2.0 * np.sum(np.arctan2(volume, flat), axis=-1)
        inside[begin : begin + step] = np.abs(angle) > 2.0 * math.pi
    return inside
