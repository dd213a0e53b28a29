"""The pictures of a conducting fluid on a sphere on a page."""

from __future__ import annotations

from typing import Any

import numpy as np

from polhode.bodies.surface import Surface
from polhode.kinds.panel import KindPanel
from polhode.motion._trajectory import Trajectory
from polhode.types import Array
from polhode.viewer.encoding import pack
from polhode.viewer.panels import Panel
from polhode.viewer.samples import Samples


def _levels(fields: Array) -> dict[str, Any]:
    percentile = 99.7  # at which colours end
    largest = float(np.percentile(np.abs(fields), percentile)) or 1.0
    levels = np.clip(127.5 + 127.5 * fields / largest, 0.0, 255.0)
    return {"levels": pack(np.round(levels), "u1"), "largest": largest}


class SphereMHDPanel(KindPanel):
    """The pictures of a conducting fluid on a sphere on a page."""

    def panels(self, trajectory: Trajectory, samples: Samples, surface: Surface | None) -> list[Panel]:
        """Return maps of the relative vorticity and of the current, both with lines of the field."""
        system = trajectory.source
        most_rows = 64  # of the maps that are laid around the globes
        rows = min(most_rows, 3 * system.size)
        most_bytes = 360_000  # of all maps of one globe, so that a page stays small
        count = max(2, min(len(samples.times), most_bytes // (4 * rows * rows)))
        frames = np.unique(np.linspace(0, len(samples.times) - 1, count).astype(int))
        theta = np.pi * (1.0 - (np.arange(rows) + 0.5) / rows)
        phi = 2.0 * np.pi * (np.arange(2 * rows) + 0.5) / (2 * rows)
        states = samples.states[frames]
        potential, vorticity = np.moveaxis(np.asarray(system.on_grid(states, theta, phi)), 1, 0)
        current = np.asarray(system.fluid.on_grid(system.current(states) + system.fluid.planetary, theta, phi))
        reach = float(np.abs(potential).max()) or 1.0
        lines = np.round(127.5 + 127.5 * potential / reach)
        bands = 14  # between the lines of the field
        common = {"rows": rows, "columns": 2 * rows, "frames": pack(frames, "u4"), "lines": pack(lines, "u1"),
                  "bands": bands}  # fmt: skip
        return [{"type": f"magnetic_{name}", **common, **_levels(field)}
                for name, field in (("vorticity", vorticity), ("current", current))]

    def plots(self, trajectory: Trajectory, samples: Samples) -> dict[str, Any]:
        """Return kinetic and magnetic energy over time."""
        totals = np.asarray(trajectory.source.energy_spectrum(samples.states)).sum(axis=-1)
        series = [{"name": name, "values": pack(totals[:, k], "f4")} for k, name in enumerate(("kinetic", "magnetic"))]
        return {"plots": [{"title": "energy", "unit": "rad²/s²", "series": series}]}


PANEL = SphereMHDPanel()
