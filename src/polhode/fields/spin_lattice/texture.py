"""Topology of spins in a plane."""

from __future__ import annotations

import numpy as np

from polhode._base.arrays import known_numbers_only
from polhode.errors import InvalidInput
from polhode.types import ArrayLike, Float64, Real


@known_numbers_only
def skyrmion_number(
    spins: Real[ArrayLike, "*batch m n 3"], periodic: bool = True
) -> Float64[np.ndarray, "*batch"]:
    """Return how often spins (…, M, N, 3) of a plane cover the sphere, by triangles' signed solid angles over 4π.

    Each plaquette is cut along its diagonal. On a periodic plane it is a whole number to rounding, unless a triangle
    is a great circle's. Positive where the map to the sphere keeps orientation: (M, N) axes to outward normals.

    Args:
        spins: of any length but zero.
        periodic: whether the plane closes; open planes give any number.

    Raises:
        InvalidInput: for other shapes, spins that are zero or not finite.

    Source: Berg & Lüscher, Nucl. Phys. B 190 (1981) 412.

    >>> float(skyrmion_number(np.tile([0.0, 0.0, 1.0], (4, 4, 1))))
    0.0
    """
    spins = np.asarray(spins, float)
    if spins.ndim < 3 or spins.shape[-1] != 3:
        raise InvalidInput(f"`spins` must have shape (…, M, N, 3); got {spins.shape}.")
    size = np.linalg.norm(spins, axis=-1, keepdims=True)
    if not (np.isfinite(size).all() and (size > 0).all()):
        raise InvalidInput("`spins` must be finite and not zero.")
    m = spins / size
    right, up = np.roll(m, -1, axis=-3), np.roll(m, -1, axis=-2)
    across = np.roll(right, -1, axis=-2)
    angles = _solid_angle(m, right, across) + _solid_angle(m, across, up)
    if not periodic:
        angles = angles[..., :-1, :-1]
    return np.asarray(angles.sum(axis=(-2, -1)) / (4.0 * np.pi))


def _solid_angle(a: np.ndarray, b: np.ndarray, c: np.ndarray) -> np.ndarray:
    """Return signed solid angles of triangles of unit vectors. Source: Van Oosterom & Strackee, 1983."""
    volume = np.sum(a * np.cross(b, c), axis=-1)
    return 2.0 * np.arctan2(volume, 1.0 + np.sum(a * b + b * c + c * a, axis=-1))
