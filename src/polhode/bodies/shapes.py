"""Homogeneous bodies by exact formulas, each centred on its centre of mass with its axis of symmetry along z.

Formulas give the mean squares ⟨x²⟩, ⟨y²⟩, ⟨z²⟩ over the mass M; the inertia is Ixx = M (⟨y²⟩ + ⟨z²⟩) and cyclically.
Masses in kg, lengths in m; all raise ``InvalidInput`` for what is not positive and finite, naming it.

Source: Beer & Johnston, *Vector Mechanics for Engineers: Dynamics*, appendix B; hollow ones by subtraction.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from polhode.arrays import as_float64, known_numbers_only
from polhode.bodies.body import Body
from polhode.errors import InvalidInput, shown
from polhode.types import Array, ArrayLike, Float64, Real

__all__ = ["box", "cone", "cylinder", "disk", "ellipsoid", "rod", "sphere", "torus"]

SMALLEST, LARGEST = 1e-60, 1e60  # m or kg; no body is near


@known_numbers_only
def box(mass: float, size: Real[ArrayLike, "3"]) -> Body:
    """Return a rectangular block with edges ``size`` (3,) [m] along x, y, z: ⟨x²⟩ = size_x²/12.

    >>> box(12.0, (1.0, 2.0, 3.0)).principal_moments
    array([ 5., 10., 13.])
    """
    (mass,) = _positive(mass=mass)
    return _shape(mass, _lengths("size", size) ** 2 / 12.0)


@known_numbers_only
def cylinder(mass: float, radius: float, height: float, inner_radius: float = 0.0) -> Body:
    """Return a solid cylinder about z, or a tube if ``inner_radius`` is given: ⟨x²⟩ = (R² + r²)/4, ⟨z²⟩ = h²/12."""
    mass, radius, height = _positive(mass=mass, radius=radius, height=height)
    inner = _inner_radius(inner_radius, radius)
    across = (radius**2 + inner**2) / 4.0
    return _shape(mass, (across, across, height**2 / 12.0))


@known_numbers_only
def ellipsoid(mass: float, semi_axes: Real[ArrayLike, "3"]) -> Body:
    """Return a solid ellipsoid with semi-axes (3,) [m] along x, y, z: ⟨x²⟩ = a²/5."""
    (mass,) = _positive(mass=mass)
    return _shape(mass, _lengths("semi_axes", semi_axes) ** 2 / 5.0)


@known_numbers_only
def sphere(mass: float, radius: float, inner_radius: float = 0.0) -> Body:
    """Return a solid ball, or a shell if ``inner_radius`` is given: ⟨x²⟩ = (R⁵ − r⁵)/(R³ − r³)/5."""
    mass, radius = _positive(mass=mass, radius=radius)
    ratio = _inner_radius(inner_radius, radius) / radius
    # (1 − r⁵)/(1 − r³) without the common factor 1 − r, which cancels for thin shells
    share = (1 + ratio + ratio**2 + ratio**3 + ratio**4) / (1 + ratio + ratio**2)
    return _shape(mass, (radius**2 * share / 5.0,) * 3)


@known_numbers_only
def cone(mass: float, radius: float, height: float) -> Body:
    """Return a solid circular cone about z, apex up, its base h/4 below the origin: ⟨x²⟩ = 3R²/20, ⟨z²⟩ = 3h²/80."""
    mass, radius, height = _positive(mass=mass, radius=radius, height=height)
    return _shape(mass, (0.15 * radius**2, 0.15 * radius**2, 0.0375 * height**2))


@known_numbers_only
def disk(mass: float, radius: float, inner_radius: float = 0.0) -> Body:
    """Return a flat disk of no thickness about z, or a ring if ``inner_radius`` is given: ⟨x²⟩ = (R² + r²)/4."""
    mass, radius = _positive(mass=mass, radius=radius)
    across = (radius**2 + _inner_radius(inner_radius, radius) ** 2) / 4.0
    return _shape(mass, (across, across, 0.0))


@known_numbers_only
def rod(mass: float, length: float) -> Body:
    """Return a thin rod along z: ⟨z²⟩ = length²/12.

    Its moment about z is zero: it is good as a part, but has no free motion of its own.
    """
    mass, length = _positive(mass=mass, length=length)
    return _shape(mass, (0.0, 0.0, length**2 / 12.0))


@known_numbers_only
def torus(mass: float, major_radius: float, minor_radius: float) -> Body:
    """Return a solid ring torus about z: a tube of ``minor_radius`` b around a circle of ``major_radius`` a.

    ⟨x²⟩ = a²/2 + 3b²/8, ⟨z²⟩ = b²/4.
    """
    mass, major, minor = _positive(mass=mass, major_radius=major_radius, minor_radius=minor_radius)
    if minor > major:
        raise InvalidInput(f"`minor_radius` must not exceed `major_radius`; got {minor:g} m and {major:g} m.")
    # ⟨ρ²⟩ = a² + 3b²/4 about the axis, over a tube whose volume element grows as ρ; half of it across
    across = major**2 / 2.0 + 3.0 * minor**2 / 8.0
    return _shape(mass, (across, across, minor**2 / 4.0))


def _shape(mass: float, squares: Any) -> Body:
    """Return the body with ∫ x² dm/M, ∫ y² dm/M, ∫ z² dm/M."""
    x, y, z = squares
    return Body(mass, (0.0, 0.0, 0.0), np.diag([mass * (y + z), mass * (x + z), mass * (x + y)]))


def _positive(**named: Any) -> list[float]:
    """Return single numbers, each positive and finite."""
    values = []
    for name, value in named.items():
        array = _numbers(name, value)
        if array.shape != ():
            raise InvalidInput(f"`{name}` must be one number; got {shown(value)}.")
        if not SMALLEST < array < LARGEST:
            raise InvalidInput(
                f"`{name}` must be positive and finite, within 1e±60; got {shown(value)}. "
                "Check its unit."
            )
        values.append(float(array))
    return values


def _lengths(name: str, value: Any) -> Float64[Array, "3"]:
    array = _numbers(name, value)
    if array.shape != (3,):
        raise InvalidInput(f"`{name}` must be three lengths; got {shown(value)}.")
    if not ((array > SMALLEST) & (array < LARGEST)).all():
        raise InvalidInput(f"`{name}` must be positive and finite, within 1e±60 m; got {shown(value)}. Check its unit.")
    return array


def _inner_radius(inner: Any, outer: float) -> float:
    number = _numbers("inner_radius", inner)
    if number.shape != () or not 0.0 <= number <= outer:
        raise InvalidInput(f"`inner_radius` must lie between 0 and the radius {outer:g} m; got {shown(inner)}.")
    return float(number)


def _numbers(name: str, value: Any) -> Array:
    if value is None:
        raise InvalidInput(f"`{name}` must be given as a number; got None.")
    return np.asarray(as_float64(np, value, name))


def __dir__() -> list[str]:
    return __all__
