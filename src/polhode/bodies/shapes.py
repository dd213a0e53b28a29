"""Homogeneous bodies by exact formulas, each centred on its centre of mass with its axis of symmetry along z.

Formulas give the mean squares ⟨x²⟩, ⟨y²⟩, ⟨z²⟩ over the mass M; the inertia is Ixx = M (⟨y²⟩ + ⟨z²⟩) and cyclically.
Masses in kg, lengths in m; all raise ``InvalidInput`` for values that are not positive and finite, naming them.

Shells have their material in a wall, and their measures are those of its middle: with a thickness the wall is exactly
as thick, without one the mass lies on the surface.

Source: Beer & Johnston, *Vector Mechanics for Engineers: Dynamics*, appendix B; hollow ones by subtraction.
"""

from __future__ import annotations

import numpy as np

from polhode._base.arrays import known_numbers_only
from polhode.bodies import _solids as solids
from polhode.bodies._inertia import MassProperties, finite_array, inertia_of_second
from polhode.bodies.body import Body
from polhode.types import ArrayLike, Real

__all__ = ["box", "box_shell", "capsule", "cone", "cylinder", "cylinder_shell", "disk", "ellipsoid", "point", "prism",
           "rod", "sphere", "sphere_shell", "torus"]  # fmt: skip


@known_numbers_only
def box(mass: float, size: Real[ArrayLike, "3"]) -> Body:
    """Return a rectangular block with edges ``size`` (3,) [m] along x, y, z: ⟨x²⟩ = size_x²/12.

    >>> box(12.0, (1.0, 2.0, 3.0)).principal_moments
    array([ 5., 10., 13.])
    """
    return _with_mass(mass, solids.box(size))


@known_numbers_only
def cylinder(mass: float, radius: float, height: float, inner_radius: float = 0.0) -> Body:
    """Return a solid cylinder about z, or a tube if ``inner_radius`` is given: ⟨x²⟩ = (R² + r²)/4, ⟨z²⟩ = h²/12."""
    return _with_mass(mass, solids.cylinder(radius, height, inner_radius))


@known_numbers_only
def ellipsoid(mass: float, semi_axes: Real[ArrayLike, "3"]) -> Body:
    """Return a solid ellipsoid with semi-axes (3,) [m] along x, y, z: ⟨x²⟩ = a²/5."""
    return _with_mass(mass, solids.ellipsoid(semi_axes))


@known_numbers_only
def sphere(mass: float, radius: float, inner_radius: float = 0.0) -> Body:
    """Return a solid ball, or a shell if ``inner_radius`` is given: ⟨x²⟩ = (R⁵ − r⁵)/(R³ − r³)/5."""
    return _with_mass(mass, solids.sphere(radius, inner_radius))


@known_numbers_only
def cone(mass: float, radius: float, height: float) -> Body:
    """Return a solid circular cone about z, apex up, its base h/4 below the origin: ⟨x²⟩ = 3R²/20, ⟨z²⟩ = 3h²/80."""
    return _with_mass(mass, solids.cone(radius, height))


@known_numbers_only
def disk(mass: float, radius: float, inner_radius: float = 0.0) -> Body:
    """Return a flat disk of no thickness about z, or a ring if ``inner_radius`` is given: ⟨x²⟩ = (R² + r²)/4."""
    return _with_mass(mass, solids.disk(radius, inner_radius))


@known_numbers_only
def rod(mass: float, length: float) -> Body:
    """Return a thin rod along z: ⟨z²⟩ = length²/12.

    Its moment about z is zero: it is good as a part, but has no free motion of its own.
    """
    return _with_mass(mass, solids.rod(length))


@known_numbers_only
def torus(mass: float, major_radius: float, minor_radius: float) -> Body:
    """Return a solid ring torus about z, a circle of radius b swept around at the distance a.

    ⟨x²⟩ = a²/2 + 3b²/8, ⟨z²⟩ = b²/4.
    """
    return _with_mass(mass, solids.torus(major_radius, minor_radius))


@known_numbers_only
def capsule(mass: float, radius: float, length: float) -> Body:
    """Return a solid cylinder about z of this length with half a ball on each end, length + 2 radius in all.

    >>> capsule(1.0, 1.0, 1e-9).principal_moments.round(6)
    array([0.4, 0.4, 0.4])
    """
    return _with_mass(mass, solids.capsule(radius, length))


@known_numbers_only
def prism(
    mass: float, height: float, sides: int | None = None, radius: float | None = None,
    outline: Real[ArrayLike, "n 2"] | None = None,
) -> Body:
    """Return a solid prism along z with its middle at z = 0, on a regular polygon or on any outline.

    Args:
        mass: [kg].
        height: [m].
        sides: of the regular polygon about the origin, one corner of which is on the x axis.
        radius: of the circle through its corners [m].
        outline: (n, 2) corners [m] in either order, in place of both; a simple polygon, whose centroid need not be at
            the origin.

    >>> prism(6.0, 1.0, outline=[(0, 0), (2, 0), (2, 1), (0, 1)]).center_of_mass
    array([1. , 0.5, 0. ])
    """
    return _with_mass(mass, solids.prism(height, sides, radius, outline))


@known_numbers_only
def box_shell(mass: float, size: Real[ArrayLike, "3"], thickness: float = 0.0) -> Body:
    """Return a hollow box with six walls; ``size`` (3,) and ``thickness`` in metres.

    >>> box_shell(12.0, (1.0, 1.0, 1.0)).principal_moments.round(12)  # 5/18 m a² of a cube
    array([3.33333333, 3.33333333, 3.33333333])
    """
    return _with_mass(mass, solids.box_shell(size, thickness))


@known_numbers_only
def cylinder_shell(
    mass: float, radius: float, height: float, thickness: float = 0.0, *, open_ends: bool = False
) -> Body:
    """Return a hollow cylinder about z, like a can, or like a pipe if its ends are open.

    >>> float(cylinder_shell(2.0, 1.0, 3.0, open_ends=True).inertia[2, 2])
    2.0
    """
    return _with_mass(mass, solids.cylinder_shell(radius, height, thickness, open_ends))


@known_numbers_only
def sphere_shell(mass: float, radius: float, thickness: float = 0.0) -> Body:
    """Return a hollow ball.

    >>> sphere_shell(1.5, 1.0).principal_moments  # 2/3 m R²
    array([1., 1., 1.])
    """
    return _with_mass(mass, solids.sphere_shell(radius, thickness))


@known_numbers_only
def point(mass: float, at: Real[ArrayLike, "3"] = (0.0, 0.0, 0.0)) -> MassProperties:
    """Return a point mass at a place (3,) [m], to combine with bodies; alone it has no attitude and is no ``Body``."""
    (mass,) = solids.positive(mass=mass)
    return MassProperties(mass, finite_array("at", at, (3,)), np.zeros((3, 3)))


def _with_mass(mass: float, solid: solids.Solid) -> Body:
    (mass,) = solids.positive(mass=mass)
    return Body(mass, solid.centroid, mass * inertia_of_second(solid.second))


def __dir__() -> list[str]:
    return __all__
