"""Mass properties of homogeneous bodies that are bounded by triangle meshes."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from polhode._base import check
from polhode.bodies._inertia import MassProperties, inertia_of_second
from polhode.bodies._mesh_gate import as_mesh, check_mesh, triple_products
from polhode.errors import InvalidInput
from polhode.types import Array, ArrayLike, Float64, Real


class SheetLimits(NamedTuple):
    """A number beyond which a sheet is refused."""

    max_thickness: float = 0.25  # of a mesh's size: the moments of a sheet are off by the square of that


LIMITS = SheetLimits()


def mass_properties(
    vertices: Real[ArrayLike, "n 3"], faces: Real[ArrayLike, "m 3"], *, mass: float | None, density: float | None,
    several: bool = False, repair: bool = False, repaired: bool = False,
) -> MassProperties:
    """Return mass, centre and inertia of the body inside a mesh: ``Body.from_mesh`` documents the arguments.

    A mesh that was ``repaired`` when it was read needs no second repair, and no message advises to ask for it.
    """
    if (mass is None) == (density is None):
        raise InvalidInput("give exactly one of `mass` [kg] and `density` [kg/m³]; a mesh alone has neither.")
    for name, value in (("mass", mass), ("density", density)):
        if value is not None:
            check.number(name, value, above=0, remedy="Check sign and units.")
    if repair:
        from polhode.bodies._mesh_repair import repair_mesh

        vertices, faces, _ = repair_mesh(vertices, faces)
    vertices, faces = check_mesh(vertices, faces, several, repair or repaired)
    volume, center, second = volume_moments(vertices[faces])
    whole = float(mass if mass is not None else density * volume)  # type: ignore[operator]
    with np.errstate(all="ignore"):  # a mass that is too large is refused by what takes it
        inertia = whole / volume * inertia_of_second(second)
    return MassProperties(whole, center, inertia)


def sheet_properties(
    vertices: Real[ArrayLike, "n 3"], faces: Real[ArrayLike, "m 3"], *, mass: float | None, density: float | None,
    thickness: float | None,
) -> MassProperties:
    """Return mass, centre and inertia of a thin sheet: ``Body.from_sheet`` documents the arguments."""
    if (mass is None) == (density is None) or (density is None) != (thickness is None):
        raise InvalidInput("give either `mass` [kg], or `density` [kg/m³] with `thickness` [m]; a sheet has no other.")
    for name, value in (("mass", mass), ("density", density), ("thickness", thickness)):
        if value is not None:
            check.number(name, value, above=0, remedy="Check sign and units.")
    vertices, faces = as_mesh(vertices, faces, least=1)
    area, center, second = area_moments(vertices[faces])
    widest = float(np.ptp(vertices[faces], axis=(0, 1)).max())
    if thickness is not None and thickness > LIMITS.max_thickness * widest:
        raise InvalidInput(
            f"`thickness` of a sheet must be at most {LIMITS.max_thickness:g} of the mesh's size, {widest:.4g} m; got "
            f"{thickness:g} m. Check its unit, or give the solid."
        )
    whole = float(mass if mass is not None else density * thickness * area)  # type: ignore[operator]
    return MassProperties(whole, center, whole / area * inertia_of_second(second))


def area_moments(corners: Float64[np.ndarray, "m 3 3"]) -> tuple[float, Float64[Array, "3"], Float64[Array, "3 3"]]:
    """Return area [m²], centroid (3,) [m] and ∫ r rᵀ dA about the centroid (3, 3) [m⁴] of triangles (m, 3, 3).

    Over a triangle of area A with corners a, b, c and s = a + b + c, ∫ r rᵀ dA = A/12 (a aᵀ + b bᵀ + c cᵀ + s sᵀ).
    """
    origin = 0.5 * (corners.min(axis=(0, 1)) + corners.max(axis=(0, 1)))
    corners = corners - origin
    a, b, c = np.moveaxis(corners, 1, 0)
    areas = 0.5 * np.linalg.norm(np.cross(b - a, c - a), axis=1)
    area = float(areas.sum())
    if not area > 0.0:
        raise InvalidInput("the mesh has no area: all of its triangles are lines or points. Check the file.")
    center = areas @ corners.sum(axis=1) / (3.0 * area)
    corners = corners - center
    sums = corners.sum(axis=1)
    squares = np.einsum("nki,nkj->nij", corners, corners) + np.einsum("ni,nj->nij", sums, sums)
    return area, center + origin, (areas[:, None, None] * squares).sum(axis=0) / 12.0


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
