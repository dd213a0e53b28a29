"""The table [system] of a spherical pendulum."""

from __future__ import annotations

from typing import ClassVar

from pydantic import Field

from polhode.kinds import STANDARD_GRAVITY, Acceleration, Lean, Length, Rate, SystemTable


class PendulumTable(SystemTable):
    """The rod, and how it starts: leaning towards x from hanging down, turning about the vertical."""

    takes: ClassVar[tuple[str, ...]] = ("time",)
    needs: ClassVar[tuple[str, ...]] = ()
    length: Length = Field(description='give it like "1 m"')
    gravity: Acceleration = STANDARD_GRAVITY
    lean: Lean = 0.0
    rate: Rate = 0.0
