"""Lets the page continue the motion of a body that loses energy; its pictures are those of any body."""

from __future__ import annotations

from typing import Any

from polhode.kinds.panel import KindPanel
from polhode.motion._trajectory import Trajectory
from polhode.systems.double_bracket import DoubleBracket
from polhode.viewer.models import find_start


class DampedBodyPanel(KindPanel):
    """What a page needs to simulate a body with losses; its pictures are those of any body."""

    def model(self, trajectory: Trajectory) -> dict[str, Any] | None:
        """Return the body, its losses inside and its start; None under torques, and without attitudes."""
        system, start = trajectory.source, find_start(trajectory)
        if start is None or not isinstance(system, DoubleBracket):
            return None
        return {"solver": "DampedBody", "rate": float(system.rate), **start}


PANEL = DampedBodyPanel()
