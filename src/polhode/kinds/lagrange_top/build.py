"""From a symmetric top along any axes to one whose third axis points to its centre of mass."""

from __future__ import annotations

import numpy as np

from polhode import rotation
from polhode.errors import InvalidInput
from polhode.reports.wording import distinct, vector
from polhode.systems.heavy_top import HeavyTop
from polhode.systems.top_integrals import EQUAL


def axis_third(top: HeavyTop) -> HeavyTop:
    """Return a symmetric top along axes whose third points to the centre of mass, moments of the others equal."""
    moments, axes = np.asarray(top.moments), np.asarray(top.axes)
    case, k = top.case or ("none", 0)
    axis = np.asarray(top.axis)
    if case == "Euler":  # any axis of symmetry will do
        pairs = [k for k in range(3) if abs(moments[(k + 1) % 3] - moments[(k + 2) % 3]) <= EQUAL * moments.max()]
        case, k = ("Lagrange", pairs[0]) if pairs else ("none", 0)
        axis = np.eye(3)[k]
    if case != "Lagrange":
        raise InvalidInput(
            f"the body is not symmetric about the line from pivot to centre of mass; its moments there are "
            f"{distinct(moments)} kg m², the line {vector(axis)} along their axes. Ask for kind = \"heavy-top\"."
        )
    if k < 0:
        first = rotation.perpendicular(axis)
        turned = np.stack([first, np.cross(axis, first), axis], axis=-1)
        return HeavyTop((moments[1],) * 3, float(top.mgl), (0.0, 0.0, 1.0), axes @ turned)  # equal but for rounding
    i, j = (k + 1) % 3, (k + 2) % 3
    side = -1.0 if axis[k] < 0 else 1.0
    turned = np.stack([np.eye(3)[i], side * np.eye(3)[j], side * np.eye(3)[k]], axis=-1)
    return HeavyTop((moments[i], moments[i], moments[k]), float(top.mgl), (0.0, 0.0, 1.0), axes @ turned)
