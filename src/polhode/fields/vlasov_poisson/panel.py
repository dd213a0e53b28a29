"""The picture of a plasma on a page: phase space."""

from __future__ import annotations

from typing import Any

import numpy as np
from scipy.spatial import KDTree

from polhode.bodies.surface import Surface
from polhode.kinds.panel import KindPanel
from polhode.motion._trajectory import Trajectory
from polhode.viewer.encoding import pack
from polhode.viewer.panels import Panel
from polhode.viewer.samples import Samples


class VlasovPoissonPanel(KindPanel):
    """The picture of a plasma on a page: phase space."""

    def panels(self, trajectory: Trajectory, samples: Samples, surface: Surface | None) -> list[Panel]:
        """Return pictures of phase space: at each place the weight of the particle next to it, which it keeps."""
        rows, columns = 96, 72
        most_bytes = 350_000  # of all pictures, so that a page stays small
        count = max(2, min(len(samples.times), most_bytes // (rows * columns)))
        frames = np.unique(np.linspace(0, len(samples.times) - 1, count).astype(int))
        length, states = float(trajectory.source.length), np.asarray(samples.states)
        weights = 1.0 / states[0, :, 2]
        fastest = float(np.abs(states[0, :, 0]).max())
        across, up = (np.arange(columns) + 0.5) / columns, 2.0 * (np.arange(rows) + 0.5) / rows
        asked = np.stack(np.meshgrid(across, up), axis=-1).reshape(-1, 2)
        levels = []
        for k in frames:
            x, v = np.mod(states[k, :, 1] / length, 1.0), np.clip(states[k, :, 0] / fastest + 1.0, 0.0, 2.0 - 1e-12)
            tree = KDTree(np.column_stack([np.where(x < 1.0, x, 0.0), v]), boxsize=(1.0, 4.0))
            levels.append(255.0 * weights[tree.query(asked)[1]] / weights.max())
        return [{
            "type": "phase_space", "rows": rows, "columns": columns, "frames": pack(frames, "u4"),
            "levels": pack(np.round(np.array(levels)), "u1"), "flat": True,
        }]  # fmt: skip

    def plots(self, trajectory: Trajectory, samples: Samples) -> dict[str, Any]:
        """Return the logarithm of the field's waves over time."""
        field = np.asarray(trajectory.source.field_amplitudes(samples.states))
        shown = np.log10(np.maximum(field, 1e-12 * (field.max() or 1.0)))[:, :4]
        series = [
            {"name": ["wave {number}", {"number": k + 1}], "values": pack(values, "f4")}
            for k, values in enumerate(shown.T)
        ]
        return {"plots": [{"title": "field", "unit": "log₁₀", "series": series}]}


PANEL = VlasovPoissonPanel()
