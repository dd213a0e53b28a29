"""The table [system] of a Lagrange top."""

from __future__ import annotations

from typing import ClassVar

from pydantic import Field

from polhode.bodies._pivot import STANDARD_GRAVITY
from polhode.spec.fields import Acceleration, Lean, Position
from polhode.spec.models import SystemTable


class LagrangeTopTable(SystemTable):
    """A symmetric body that turns about a point of its axis under its weight, exactly."""

    leans: ClassVar[bool] = True
    pivot: Position = Field(description='give the fixed point like ["0 mm", "0 mm", "-35 mm"], in the given axes')
    gravity: Acceleration = STANDARD_GRAVITY
    lean: Lean | None = None
