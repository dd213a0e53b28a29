"""The table [system] of a body that loses energy."""

from __future__ import annotations

from polhode.spec.fields import Duration, Eccentricity, LinearDragCoefficient, PositivePlain, QuadraticDragCoefficient
from polhode.spec.models import SystemTable


class DampedBodyTable(SystemTable):
    """A body that loses energy, inside or by drag.

    Attributes:
        damping: α |L| of the double bracket.
    """

    damping: PositivePlain | None = None
    linear_drag: LinearDragCoefficient | None = None
    quadratic_drag: QuadraticDragCoefficient | None = None
    orbital_period: Duration | None = None
    eccentricity: Eccentricity | None = None
