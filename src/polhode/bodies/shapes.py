"""Homogeneous bodies by exact formulas, each centred on its centre of mass with its axis of symmetry along z.

Source: any table of moments of inertia, e.g. Goldstein, *Classical Mechanics*, ch. 5; each is checked against
quadrature in the tests.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from polhode.bodies.body import Body
from polhode.errors import InvalidInput

Array = Any


def _positive(**named: Any) -> list[Any]:
    values = []
    for name, value in named.items():
        try:
            array = np.array(value, dtype=float)
        except (TypeError, ValueError):
            raise InvalidInput(f"`{name}` must be a number; got {value!r}.") from None
        if not (np.isfinite(array).all() and (array > 0).all()):
            raise InvalidInput(f"`{name}` must be positive and finite; got {value!r}. Check sign and units.")
        values.append(array if array.ndim else float(array))
    return values


def _triple(name: str, value: Any) -> Array:
    (array,) = _positive(**{name: value})
    if np.shape(array) != (3,):
        raise InvalidInput(f"`{name}` must be three lengths; got {value!r}.")
    return array


def _shape(mass: float, squares: Any) -> Body:
    """Return the body with ∫ x² dm/M, ∫ y² dm/M, ∫ z² dm/M."""
    x, y, z = squares
    return Body(mass, (0.0, 0.0, 0.0), np.diag([mass * (y + z), mass * (x + z), mass * (x + y)]))


def box(mass: float, size: Array) -> Body:
    """Return a rectangular block with edges ``size`` (3,) [m] along x, y, z."""
    (mass,) = _positive(mass=mass)
    return _shape(mass, _triple("size", size) ** 2 / 12.0)


def cylinder(mass: float, radius: float, height: float, inner_radius: float = 0.0) -> Body:
    """Return a solid cylinder about z, or a tube if ``inner_radius`` is given [m]."""
    mass, radius, height = _positive(mass=mass, radius=radius, height=height)
    inner = _inner_radius(inner_radius, radius)
    across = (radius**2 + inner**2) / 4.0
    return _shape(mass, (across, across, height**2 / 12.0))


def ellipsoid(mass: float, semi_axes: Array) -> Body:
    """Return a solid ellipsoid with semi-axes (3,) [m] along x, y, z."""
    (mass,) = _positive(mass=mass)
    return _shape(mass, _triple("semi_axes", semi_axes) ** 2 / 5.0)


def sphere(mass: float, radius: float, inner_radius: float = 0.0) -> Body:
    """Return a solid ball, or a thick shell if ``inner_radius`` is given [m]."""
    mass, radius = _positive(mass=mass, radius=radius)
    ratio = _inner_radius(inner_radius, radius) / radius
    # (1 − r⁵)/(1 − r³) without the common factor 1 − r, which cancels for thin shells
    share = (1 + ratio + ratio**2 + ratio**3 + ratio**4) / (1 + ratio + ratio**2)
    return _shape(mass, (radius**2 * share / 5.0,) * 3)


def cone(mass: float, radius: float, height: float) -> Body:
    """Return a solid circular cone about z, apex up; its centre of mass lies height/4 above the base."""
    mass, radius, height = _positive(mass=mass, radius=radius, height=height)
    return _shape(mass, (0.15 * radius**2, 0.15 * radius**2, 0.0375 * height**2))


def disk(mass: float, radius: float, inner_radius: float = 0.0) -> Body:
    """Return a flat disk of no thickness about z, or an annulus if ``inner_radius`` is given [m]."""
    mass, radius = _positive(mass=mass, radius=radius)
    across = (radius**2 + _inner_radius(inner_radius, radius) ** 2) / 4.0
    return _shape(mass, (across, across, 0.0))


def rod(mass: float, length: float) -> Body:
    """Return a thin rod along z; its moment about z is zero, so it spins freely only as part of a body."""
    mass, length = _positive(mass=mass, length=length)
    return _shape(mass, (0.0, 0.0, length**2 / 12.0))


def torus(mass: float, major_radius: float, minor_radius: float) -> Body:
    """Return a solid ring torus about z: a tube of ``minor_radius`` around a circle of ``major_radius`` [m]."""
    mass, major, minor = _positive(mass=mass, major_radius=major_radius, minor_radius=minor_radius)
    if minor > major:
        raise InvalidInput(f"`minor_radius` must not exceed `major_radius`; got {minor:g} m and {major:g} m.")
    across = major**2 / 2.0 + 3.0 * minor**2 / 8.0
    return _shape(mass, (across, across, minor**2 / 4.0))


def _inner_radius(inner: float, outer: float) -> float:
    if not 0.0 <= inner < outer:
        raise InvalidInput(f"`inner_radius` must lie between 0 and the radius {outer:g} m; got {inner!r}.")
    return float(inner)
