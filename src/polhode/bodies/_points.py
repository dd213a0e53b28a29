"""Mass properties of point masses."""

from __future__ import annotations

import math

import numpy as np

from polhode.bodies._inertia import LIMITS, MassProperties, point_inertia
from polhode.errors import InvalidInput
from polhode.types import ArrayLike, Real


def mass_properties(masses: Real[ArrayLike, "n"], positions: Real[ArrayLike, "n 3"]) -> MassProperties:
    """Return mass, centre and inertia of point masses; see ``Body.from_points``, which documents the arguments."""
    try:
        real = not (np.iscomplexobj(masses) or np.iscomplexobj(positions))
        m, r = (np.array(x, dtype=float) for x in (masses, positions)) if real else (None, None)
    except (TypeError, ValueError, OverflowError) as error:
        raise InvalidInput(f"`masses` (n,) and `positions` (n, 3) must be numbers ({error}).") from None
    if m is None or r is None:
        raise InvalidInput("`masses` and `positions` must be real; got complex numbers.")
    if m.ndim != 1 or r.shape != (len(m), 3) or len(m) == 0:
        raise InvalidInput(f"`masses` (n,) and `positions` (n, 3) must match; got {m.shape} and {r.shape}.")
    if not (np.isfinite(m).all() and np.isfinite(r).all()):
        raise InvalidInput("`masses` and `positions` must be finite; got NaN or an infinity.")
    if np.abs(r).max() > math.sqrt(LIMITS.largest):
        raise InvalidInput(f"`positions` must lie within 1e75 m; got {np.abs(r).max():.3g} m. Check the unit.")
    if not (m > 0).all():
        raise InvalidInput(f"`masses` must be positive; got {m[~(m > 0)][0]:g} kg. Check sign and units.")
    if (r == r[0]).all():
        raise InvalidInput(f"`positions` must not all coincide; got {len(r)} at one place. A point has no attitude.")
    offsets = r - r[0]
    center = m @ offsets / m.sum()
    return MassProperties(float(m.sum()), center + r[0], np.einsum("n,nij->ij", m, point_inertia(offsets - center)))
