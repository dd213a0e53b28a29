"""The picture of a fluid on a sphere on a page."""

from __future__ import annotations

from typing import Any

import numpy as np

from polhode.bodies.surface import Surface
from polhode.kinds.panel import KindPanel
from polhode.motion._trajectory import Trajectory
from polhode.viewer.encoding import pack
from polhode.viewer.panels import Panel
from polhode.viewer.samples import Samples


class SphereFluidPanel(KindPanel):
    """The picture of a fluid on a sphere on a page."""

    def panels(self, trajectory: Trajectory, samples: Samples, surface: Surface | None) -> list[Panel]:
        """Return maps of the relative vorticity, from south to north, which the page lays around a globe."""
        most_rows = 64  # of the map that is laid around the globe
        rows = min(most_rows, 3 * trajectory.source.size)
        most_bytes = 360_000  # of all maps, so that a page stays small
        count = max(2, min(len(samples.times), most_bytes // (2 * rows * rows)))
        frames = np.unique(np.linspace(0, len(samples.times) - 1, count).astype(int))
        theta = np.pi * (1.0 - (np.arange(rows) + 0.5) / rows)
        phi = 2.0 * np.pi * (np.arange(2 * rows) + 0.5) / (2 * rows)
        fields = np.asarray(trajectory.source.on_grid(samples.states[frames], theta, phi))
        percentile = 99.7  # of the vorticity at which colours end
        largest = float(np.percentile(np.abs(fields), percentile)) or 1.0
        levels = np.clip(127.5 + 127.5 * fields / largest, 0.0, 255.0)
        return [{
            "type": "vorticity", "rows": rows, "columns": 2 * rows, "frames": pack(frames, "u4"),
            "levels": pack(np.round(levels), "u1"), "largest": largest,
        }]  # fmt: skip

    def plots(self, trajectory: Trajectory, samples: Samples) -> dict[str, Any]:
        """Return the share of the energy in the largest eddies against time."""
        energies = np.cumsum(np.asarray(trajectory.source.energy_spectrum(samples.states)), axis=1)
        shares = energies / energies[:, -1:]
        degrees = (2, 4, 8, 16)  # up to which energies are added
        series = [
            {"name": ["up to degree {degree}", {"degree": k}], "values": pack(shares[:, k], "f4")}
            for k in degrees if k < trajectory.source.size
        ]
        return {"plots": [{"title": "energy in eddies", "unit": "of all", "series": series}]}


PANEL = SphereFluidPanel()
