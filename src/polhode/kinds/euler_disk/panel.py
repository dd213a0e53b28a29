"""The picture of a rolling disk on a page."""

from __future__ import annotations

import numpy as np

from polhode.bodies.surface import Surface
from polhode.motion.trajectory import Trajectory
from polhode.viewer.encoding import packed
from polhode.viewer.panels import Panel
from polhode.viewer.samples import Samples

STEEP = 0.62  # rad from which the path, which lies flat, is looked at


def panels_of(trajectory: Trajectory, samples: Samples, surface: Surface | None) -> list[Panel]:
    """Return the disk, the path of its contact and that of its centre."""
    disk, layout = trajectory.source, trajectory.layout
    contact = np.stack([layout.part(samples.states, name) for name in ("contact_x", "contact_y")], axis=-1)
    return [{
        "type": "disk", "radius": float(disk.mechanics.radius), "thickness": 2.0 * float(disk.mechanics.half_thickness),
        "contact": packed(contact), "center": packed(np.asarray(disk.center(samples.states))), "elevation": STEEP,
    }]  # fmt: skip
