"""Mass properties of homogeneous bodies that are bounded by triangle meshes."""

from __future__ import annotations

import numpy as np

from polhode.bodies._inertia import MassProperties
from polhode.bodies._mesh_gate import check_mesh, repair_mesh, triple_products
from polhode.errors import InvalidInput, shown
from polhode.types import Array, ArrayLike, Float64, Real


def mass_properties(
    vertices: Real[ArrayLike, "n 3"], faces: Real[ArrayLike, "m 3"], *, mass: float | None, density: float | None,
    several: bool = False, repair: bool = False,
) -> MassProperties:  # fmt: skip
    """Return mass, centre and inertia of what a mesh encloses: ``Body.from_mesh`` documents the arguments."""
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
    return MassProperties(whole, center, whole / volume * inertia)


def volume_moments(corners: Float64[np.ndarray, "m 3 3"]) -> tuple[float, Float64[Array, "3"], Float64[Array, "3 3"]]:
    """Return volume [m³], centroid (3,) [m] and ∫ r rᵀ dV about the centroid (3, 3) [m⁵] inside triangles (m, 3, 3).

    Tetrahedra are taken from the middle of the mesh, then from the centroid, so that a mesh far from the origin loses
    no digits.
    """
    origin = 0.5 * (corners.min(axis=(0, 1)) + corners.max(axis=(0, 1)))
    corners = corners - origin
    products = triple_products(corners)
    # a tetrahedron from the origin has volume det/6 and its centroid at (a + b + c)/4
    center = (products[:, None] * corners.sum(axis=1)).sum(axis=0) / (4.0 * products.sum())
    corners = corners - center
    products = triple_products(corners)
    sums = corners.sum(axis=1)
    # ∫ r rᵀ dV of a tetrahedron from the origin = det/120 (a aᵀ + b bᵀ + c cᵀ + s sᵀ), s = a + b + c
    squares = np.einsum("nki,nkj->nij", corners, corners) + np.einsum("ni,nj->nij", sums, sums)
    second = (products[:, None, None] * squares).sum(axis=0) / 120.0
    return float(products.sum() / 6.0), center + origin, second
