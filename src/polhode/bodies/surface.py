"""What a body looks like: triangles to draw, not to integrate."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from polhode.bodies.frame import BodyFrame

Array = Any
_CORNERS = np.array([[x, y, z] for x in (-0.5, 0.5) for y in (-0.5, 0.5) for z in (-0.5, 0.5)])
_FACES = np.array([[0, 1, 3], [0, 3, 2], [4, 6, 7], [4, 7, 5], [0, 4, 5], [0, 5, 1],
                   [2, 3, 7], [2, 7, 6], [0, 2, 6], [0, 6, 4], [1, 5, 7], [1, 7, 3]])  # fmt: skip


class Surface(NamedTuple):
    """A triangle mesh to draw; it need not be closed.

    Attributes:
        vertices: (n, 3) [m].
        faces: (m, 3) indices of corners, counterclockwise seen from outside.
    """

    vertices: Array
    faces: Array

    def along(self, frame: BodyFrame) -> Surface:
        """Return a surface in given axes as it stands along a trajectory's axes, about the point it turns about."""
        return Surface((np.asarray(self.vertices) - frame.origin) @ np.asarray(frame.axes), self.faces)


def box_of_same_inertia(moments: Array, mass: float | None = None) -> Surface | None:
    """Return the solid box with these moments about its centre: edge_i² = 6 (I_j + I_k − I_i)/m.

    Args:
        moments: (3,) principal moments [kg m²], along the box's edges.
        mass: [kg]; None for a box whose longest edge is 1 m, as moments alone have no size.

    Returns:
        The box along the principal axes, flat where a moment is the sum of the others; None for moments that no body
        has.
    """
    I = np.asarray(moments, dtype=float)  # noqa: E741
    squares = I.sum() - 2.0 * I
    if not (squares >= -4.0 * np.finfo(float).eps * I.sum()).all() or not squares.max() > 0:
        return None
    edges = np.sqrt(np.maximum(squares, 0.0))
    scale = 1.0 / edges.max() if mass is None else np.sqrt(6.0 / mass)
    return Surface(_CORNERS * (edges * scale), _FACES)
