"""Lets the page continue the motion of a heavy top; its pictures are those of any top."""

from __future__ import annotations

from typing import Any

import numpy as np

from polhode.kinds.panel import KindPanel
from polhode.motion._trajectory import Trajectory
from polhode.viewer.models import find_start


class HeavyTopPanel(KindPanel):
    """What a page needs to simulate a heavy top; its pictures are those of any top."""

    def model(self, trajectory: Trajectory) -> dict[str, Any] | None:
        """Return the top and its start; None without attitudes."""
        top, start = trajectory.source, find_start(trajectory)
        if start is None:
            return None
        return {"solver": "HeavyTop", "mgl": float(top.mgl), "axis": np.asarray(top.axis).tolist(), **start}


PANEL = HeavyTopPanel()
