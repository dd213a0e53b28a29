"""The table [system] of a body that loses energy."""

from __future__ import annotations

from typing import ClassVar

from polhode.spec.fields import (
    Duration,
    Eccentricity,
    LinearDragCoefficient,
    PositivePlain,
    Power,
    QuadraticDragCoefficient,
)
from polhode.spec.models import SystemTable


class DampedBodyTable(SystemTable):
    """A body that loses energy, inside or by drag.

    Attributes:
        damping: α |L| of the double bracket; one of the next two may give α instead.
        damping_time: time in which the final approach to the major axis falls to 1/e [s].
        loss_rate: mean power lost on the polhode of the start [W].
    """

    cones: ClassVar[bool] = True
    damping: PositivePlain | None = None
    damping_time: Duration | None = None
    loss_rate: Power | None = None
    linear_drag: LinearDragCoefficient | None = None
    quadratic_drag: QuadraticDragCoefficient | None = None
    orbital_period: Duration | None = None
    eccentricity: Eccentricity | None = None

    @property
    def inside(self) -> bool:
        """Whether the losses are inside the body."""
        return self.damping is not None or self.damping_time is not None or self.loss_rate is not None
