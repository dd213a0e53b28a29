"""The axes along which a motion is given, and how they lie in the body."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from polhode.types import Array, Float64


class BodyFrame(NamedTuple):
    """The body axes of a trajectory, and the mass properties along them.

    Attributes:
        moments: (3,) principal moments [kg m²], about the centre of mass or a fixed point.
        axes: (3, 3) principal axes by columns in the given ones.
        center_of_mass: (3,) [m, given axes].
        mass: [kg] or None.
        pivot: (3,) fixed point [m, given axes]; None for a body that turns about its centre of mass.
    """

    moments: Float64[Array, "3"]
    axes: Float64[Array, "3 3"]
    center_of_mass: Float64[Array, "3"]
    mass: float | None
    pivot: Float64[Array, "3"] | None = None

    @property
    def inertia(self) -> Float64[Array, "3 3"]:
        """(3, 3) about the point that the body turns about [kg m², given axes]."""
        axes = np.asarray(self.axes)
        return axes @ np.diag(np.asarray(self.moments)) @ axes.T

    @property
    def origin(self) -> Float64[Array, "3"]:
        """(3,) the point that the body turns about [m, given axes]."""
        return np.asarray(self.center_of_mass if self.pivot is None else self.pivot)
