"""The table [system] of a heavy top."""

from __future__ import annotations

from typing import Annotated, ClassVar, Literal

from pydantic import Field

from polhode.bodies._pivot import STANDARD_GRAVITY
from polhode.spec.fields import Acceleration, Duration, Lean, Position, one_of
from polhode.spec.models import SystemTable

Order = Annotated[Literal[2, 4, 6, 8], one_of(2, 4, 6, 8)]


class HeavyTopTable(SystemTable):
    """A body that turns about a fixed point under its weight, any shape."""

    leans: ClassVar[bool] = True
    pivot: Position = Field(description='give the fixed point like ["0 mm", "0 mm", "-35 mm"], in the given axes')
    gravity: Acceleration = STANDARD_GRAVITY
    lean: Lean | None = None
    step: Duration | None = None
    order: Order | None = None
