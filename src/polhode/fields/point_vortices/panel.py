"""The picture of point vortices on a page."""

from __future__ import annotations

from typing import Any

import numpy as np

from polhode.bodies.surface import Surface
from polhode.fields.point_vortices.system import SphereVortices
from polhode.kinds.panel import KindPanel
from polhode.motion._trajectory import Trajectory
from polhode.viewer.encoding import pack
from polhode.viewer.panels import Panel
from polhode.viewer.samples import Samples


class PointVorticesPanel(KindPanel):
    """The picture of point vortices on a page."""

    def panels(self, trajectory: Trajectory, samples: Samples, surface: Surface | None) -> list[Panel]:
        """Return vortices with their tracks, on the globe or in the plane, which fits into a unit circle."""
        system = trajectory.source
        places = np.asarray(system.positions(samples.states))
        flat = not isinstance(system, SphereVortices)
        if flat:
            middle = 0.5 * (places.max(axis=(0, 1)) + places.min(axis=(0, 1)))
            places = (places - middle) / (float(np.linalg.norm(places - middle, axis=-1).max()) or 1.0)
            places = np.concatenate([places, np.zeros((*places.shape[:-1], 1))], axis=-1)
        strengths = np.asarray(system.strengths)
        return [{
            "type": "vortices", "flat": flat, "count": len(strengths), "place": pack(np.swapaxes(places, 0, 1), "f4"),
            "strength": pack(strengths / np.abs(strengths).max(), "f4"),
        }]  # fmt: skip

    def plots(self, trajectory: Trajectory, samples: Samples) -> dict[str, Any]:
        """Return the coordinates of the first vortices over time."""
        system = trajectory.source
        drawn = 6  # vortices whose coordinates are drawn over time
        places = np.asarray(system.positions(samples.states))[:, :drawn]
        if isinstance(system, SphereVortices):
            latitude = np.degrees(np.arcsin(np.clip(places[..., 2], -1.0, 1.0)))
            longitude = np.degrees(np.unwrap(np.arctan2(places[..., 1], places[..., 0]), axis=0))
            curves = {"latitude": (latitude, "°"), "longitude": (longitude, "°")}
        else:
            curves = {"x": (places[..., 0], "m"), "y": (places[..., 1], "m")}
        return {"plots": [
            {"title": title, "unit": unit,
             "series": [{"name": str(k + 1), "values": pack(values[:, k], "f4")} for k in range(values.shape[1])]}
            for title, (values, unit) in curves.items()
        ]}  # fmt: skip


PANEL = PointVorticesPanel()
