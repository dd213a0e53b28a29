"""From a body about a fixed point to moments (I1, I1, I3) and axes whose third points to the centre of mass."""

from __future__ import annotations

import numpy as np

from polhode import rotation
from polhode.bodies._pivot import EQUAL, PivotedBody, axis_of_symmetry
from polhode.errors import InvalidInput
from polhode.types import Array, Float64


def third_axis_to_centre(body: PivotedBody) -> tuple[Float64[Array, "3"], Float64[Array, "3 3"]]:
    """Return moments (I1, I1, I3) and right-handed axes (3, 3) by columns whose third points to the centre of mass.

    Of a body whose centre of mass is its fixed point the third is an axis of symmetry.

    Raises:
        InvalidInput: for a body that is not symmetric about the line from its fixed point to its centre of mass.
    """
    moments, axes = body.moments, body.axes
    free = not body.arm.any()
    axis = np.zeros(3) if free else body.arm / np.linalg.norm(body.arm)
    k = _any_symmetry(moments) if free else axis_of_symmetry(moments, axis)
    if k is None:
        line = "" if free else f", the line ({', '.join(f'{x:.6g}' for x in axis)}) along their axes"
        raise InvalidInput(
            "`body` must be a Lagrange top, but is not symmetric about the line from pivot to centre of mass; its "
            f"moments at the pivot are ({', '.join(map(str, moments.tolist()))}) kg m²{line}. Check `pivot`; other "
            "heavy tops have no closed form: use HeavyTop.from_body with simulate."
        )
    if k < 0:
        first = rotation.perpendicular(axis)
        rotated = np.stack([first, np.cross(axis, first), axis], axis=-1)
        return np.full(3, moments[1]), axes @ rotated  # equal but for rounding
    i, j = (k + 1) % 3, (k + 2) % 3
    side = -1.0 if axis[k] < 0 else 1.0
    rotated = np.stack([np.eye(3)[i], side * np.eye(3)[j], side * np.eye(3)[k]], axis=-1)
    return moments[[i, i, k]], axes @ rotated


def _any_symmetry(moments: Array) -> int | None:
    """Return the index of an axis of symmetry, None where there is none."""
    pairs = (k for k in range(3) if abs(moments[(k + 1) % 3] - moments[(k + 2) % 3]) <= EQUAL * moments.max())
    return next(pairs, None)
