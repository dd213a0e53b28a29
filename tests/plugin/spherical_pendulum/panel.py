"""The picture of a spherical pendulum on a page."""

from __future__ import annotations

import numpy as np

from polhode.kinds import KindPanel, Panel, Samples, Surface, pack
from polhode.motion import Trajectory


class PendulumPanel(KindPanel):
    """The picture of a spherical pendulum."""

    def panels(self, trajectory: Trajectory, samples: Samples, surface: Surface | None) -> list[Panel]:
        """Return the rod, the mass and its path, in lengths of the rod."""
        place = np.asarray(samples.states)[:, :3] / float(trajectory.source.length)
        return [{"type": "pendulum", "place": pack(place)}]


PANEL = PendulumPanel()
