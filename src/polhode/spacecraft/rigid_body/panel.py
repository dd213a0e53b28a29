"""The plots of a rigid body with mounts and torques on a page; its pictures are those of any body."""

from __future__ import annotations

from typing import Any

import numpy as np

from polhode.kinds.panel import KindPanel
from polhode.motion._trajectory import Trajectory
from polhode.spacecraft.rigid_body.history import follow
from polhode.types import Array
from polhode.viewer.encoding import pack
from polhode.viewer.samples import Samples


class RigidBodyPanel(KindPanel):
    """The plots of a rigid body with mounts and torques."""

    def plots(self, trajectory: Trajectory, samples: Samples) -> dict[str, Any]:
        """Return Ω, the pointing error, and the rates of the wheels over time."""
        orbit = next((x.orbit for x in trajectory.source.torques if getattr(x, "orbit", None) is not None), None)
        history = follow(trajectory.source, orbit, samples.times, samples.states)
        plots = [{"title": "angular velocity, given axes", "unit": "rad/s",
                  "series": [_series(name, history.velocity[:, k]) for k, name in enumerate("xyz")]}]  # fmt: skip
        if history.pointing is not None:
            error = np.degrees(history.pointing)
            plots.append({"title": "pointing error", "unit": "°", "series": [_series("error", error)]})
        if history.rates.shape[1]:
            series = [_series(f"{k + 1}", rates) for k, rates in enumerate(history.rates.T)]
            plots.append({"title": "rates of the wheels", "unit": "rad/s", "series": series})
        return {"plots": plots}


def _series(name: str, values: Array) -> dict[str, Any]:
    return {"name": name, "values": pack(values, "f4")}


PANEL = RigidBodyPanel()
