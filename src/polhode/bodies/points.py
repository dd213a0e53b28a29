"""Bodies made of point masses."""

from __future__ import annotations

from typing import Any

import numpy as np

from polhode.bodies.body import Body, point_inertia
from polhode.errors import InvalidInput

Array = Any


def from_points(masses: Array, positions: Array) -> Body:
    """Return point masses as one rigid body: J = Σ m (|r|² 1 − r rᵀ), r from the centre of mass.

    Args:
        masses: (n,) [kg], positive.
        positions: (n, 3) [m].

    Raises:
        InvalidInput: for shapes that do not match, masses that are not positive, or points all in one place.

    >>> from_points([1.0, 1.0], [[-1, 0, 0], [1, 0, 0]]).principal_moments
    array([0., 2., 2.])
    """
    if np.iscomplexobj(masses) or np.iscomplexobj(positions):
        raise InvalidInput("`masses` and `positions` must be real; got complex numbers.")
    try:
        m, r = np.array(masses, dtype=float), np.array(positions, dtype=float)
    except (TypeError, ValueError):
        raise InvalidInput("`masses` and `positions` must be numbers.") from None
    if m.ndim != 1 or r.shape != (len(m), 3) or len(m) == 0:
        raise InvalidInput(f"`masses` (n,) and `positions` (n, 3) must match; got {m.shape} and {r.shape}.")
    if not (np.isfinite(m).all() and np.isfinite(r).all()):
        raise InvalidInput("`masses` and `positions` must be finite; got NaN or an infinity.")
    if not (m > 0).all():
        raise InvalidInput(f"`masses` must be positive; got {m[~(m > 0)][0]:g} kg. Check sign and units.")
    if (r == r[0]).all():
        raise InvalidInput(f"`positions` must not all coincide; got {len(r)} at one place. A point has no attitude.")
    offsets = r - r[0]
    center = m @ offsets / m.sum()
    return Body(float(m.sum()), center + r[0], np.einsum("n,nij->ij", m, point_inertia(offsets - center)))
