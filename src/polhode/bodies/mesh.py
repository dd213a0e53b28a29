"""Homogeneous bodies bounded by triangle meshes, which first pass the gate."""

from __future__ import annotations

import numpy as np

from polhode.arrays import known_numbers_only
from polhode.bodies.body import Body
from polhode.bodies.mesh_gate import check_mesh, repair_mesh, triple_products
from polhode.errors import InvalidInput, shown
from polhode.types import Array, ArrayLike, Float64, Real


@known_numbers_only
def from_mesh(
    vertices: Real[ArrayLike, "n 3"],
    faces: Real[ArrayLike, "m 3"],
    mass: float | None = None,
    density: float | None = None,
    several: bool = False,
    repair: bool = False,
) -> Body:
    """Return the homogeneous body inside a closed triangle mesh: J = ρ ∫ (|r|² 1 − r rᵀ) dV about the centroid.

    Args:
        vertices: (n, 3) corners [m].
        faces: (m, 3) indices of corners, counterclockwise seen from outside. A closed surface turned inward and lying
            inside another one is a cavity.
        mass: [kg]; this or ``density``.
        density: [kg/m³].
        several: accept disjoint bodies, touching or not, as one rigid body.
        repair: turn the faces right first, bodies outward and surfaces inside them inward as cavities, and drop
            triangles with repeated corners. Only on request, as it guesses. Holes stay holes; to fill them, read the
            mesh from a file with repair.

    Raises:
        InvalidInput: if the mesh is open, wound inconsistently, inverted, overlapping, or of several bodies; if not
            exactly one of mass and density is given, positive.

    >>> corners = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]
    >>> from_mesh(corners, [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]], density=6.0).mass
    1.0

    Source: Tonon, J. Math. Stat. 1 (2004) 8 (signed tetrahedra); Mirtich, J. Graphics Tools 1 (1996) 31.
    """
    if (mass is None) == (density is None):
        raise InvalidInput("give exactly one of `mass` [kg] and `density` [kg/m³]; a mesh alone has neither.")
    for name, value in (("mass", mass), ("density", density)):
        if value is not None and not (np.ndim(value) == 0 and np.isfinite(value) and value > 0):
            raise InvalidInput(
                f"`{name}` must be one positive finite number; got {shown(value)}. "
                "Check sign and units."
            )
    if repair:
        vertices, faces = repair_mesh(vertices, faces)
    vertices, faces = check_mesh(vertices, faces, several, repaired=repair)
    volume, center, second = volume_moments(vertices[faces])
    whole = float(mass if mass is not None else density * volume)  # type: ignore[operator]
    xx, yy, zz = np.diag(second)
    # sums of squares, not trace minus entry, which would cancel for needles
    inertia = np.diag([yy + zz, zz + xx, xx + yy]) - (second - np.diag([xx, yy, zz]))
    return Body(whole, center, whole / volume * inertia)


def volume_moments(corners: Float64[Array, "m 3 3"]) -> tuple[float, Float64[Array, "3"], Float64[Array, "3 3"]]:
    """Return volume [m³], centroid (3,) [m] and ∫ r rᵀ dV about the centroid (3, 3) [m⁵] inside triangles (m, 3, 3).

    Tetrahedra are taken from the middle of the mesh, then from the centroid, so that a mesh far from the origin loses
    no digits.
    """
    origin = 0.5 * (corners.min(axis=(0, 1)) + corners.max(axis=(0, 1)))
    corners = corners - origin
    products = triple_products(corners)
    center = (products[:, None] * corners.sum(axis=1)).sum(axis=0) / (4.0 * products.sum())
    corners = corners - center
    products = triple_products(corners)
    sums = corners.sum(axis=1)
    squares = np.einsum("nki,nkj->nij", corners, corners) + np.einsum("ni,nj->nij", sums, sums)
    second = (products[:, None, None] * squares).sum(axis=0) / 120.0
    return float(products.sum() / 6.0), center + origin, second
