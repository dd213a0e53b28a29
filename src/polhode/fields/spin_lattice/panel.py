"""The picture of spins on a lattice on a page."""

from __future__ import annotations

from typing import Any

import numpy as np

from polhode.bodies.surface import Surface
from polhode.kinds.panel import KindPanel
from polhode.motion._trajectory import Trajectory
from polhode.viewer.encoding import pack
from polhode.viewer.panels import Panel
from polhode.viewer.samples import Samples


class SpinLatticePanel(KindPanel):
    """The picture of spins on a lattice on a page."""

    def panels(self, trajectory: Trajectory, samples: Samples, surface: Surface | None) -> list[Panel]:
        """Return places and directions of the spins of the first layer, or of as many of its cells as a page holds."""
        system = trajectory.source
        lattice = system.lattice
        first, second = lattice.shape[:2]
        most_arrows = 1600
        while first * second * lattice.sites > most_arrows:
            first, second = (-(-first // 2), second) if first >= second else (first, -(-second // 2))
        places = np.asarray(lattice.positions())[:first, :second, :1, :, :2].reshape(-1, 2)
        chosen = np.asarray(samples.states)[:, :first, :second, :1] / np.asarray(system.spin)[:, None]
        spins = chosen.reshape(len(chosen), -1, 3)
        most_bytes = 360_000  # of all their directions, so that a page stays small
        count = max(2, min(len(spins), most_bytes // (3 * len(places))))
        frames = np.unique(np.linspace(0, len(spins) - 1, count).astype(int))
        places = places - 0.5 * (places.max(axis=0) + places.min(axis=0))
        size = float(np.abs(places).max()) or 1.0
        apart = np.linalg.norm(places[1:] - places[0], axis=1).min(initial=size) if len(places) > 1 else size
        levels = np.round(np.clip(127.5 + 127.5 * spins[frames], 0.0, 255.0))
        return [{
            "type": "spins", "flat": True, "place": pack(places / size, "f4"), "apart": float(apart / size),
            "frames": pack(frames, "u4"), "spins": pack(levels, "u1"),
        }]  # fmt: skip

    def plots(self, trajectory: Trajectory, samples: Samples) -> dict[str, Any]:
        """Return the components of the magnetisation over time."""
        states = np.asarray(samples.states)
        mean = states.mean(axis=(1, 2, 3, 4)) / float(np.mean(trajectory.source.spin))
        series = [{"name": name, "values": pack(mean[:, k], "f4")} for k, name in enumerate("xyz")]
        return {"plots": [{"title": "magnetisation", "unit": "of the largest", "series": series}]}


PANEL = SpinLatticePanel()
