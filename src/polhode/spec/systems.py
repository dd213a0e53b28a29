"""The table [system] of a spec, one model for each kind."""

from __future__ import annotations

from typing import Annotated, ClassVar, Literal

from polhode.spec.fields import Acceleration, Angle, Duration, Position, one_of
from polhode.spec.models import Strict

STANDARD_GRAVITY = 9.80665  # m/s²
Order = Annotated[Literal[2, 4, 6], one_of(2, 4, 6)]


class SystemTable(Strict):
    """What every kind has.

    Attributes:
        takes: the other tables that go with it.
    """

    takes: ClassVar[tuple[str, ...]] = ("body", "spin", "time")
    kind: str


class HeavyTopTable(SystemTable):
    """A body that turns about a fixed point under its weight, any shape."""

    pivot: Position
    gravity: Acceleration = STANDARD_GRAVITY
    lean: Angle | None = None
    step: Duration | None = None
    order: Order = 4


class LagrangeTopTable(SystemTable):
    """A symmetric body that turns about a point of its axis under its weight, exactly."""

    pivot: Position
    gravity: Acceleration = STANDARD_GRAVITY
    lean: Angle | None = None


SYSTEMS: dict[str, type[SystemTable]] = {
    "heavy-top": HeavyTopTable,
    "lagrange-top": LagrangeTopTable,
}
