"""The picture of a spin on an orbit on a page."""

from __future__ import annotations

import numpy as np

from polhode.bodies.surface import Surface
from polhode.motion.trajectory import Trajectory
from polhode.viewer.encoding import packed
from polhode.viewer.panels import Panel
from polhode.viewer.samples import Samples


def panels_of(trajectory: Trajectory, samples: Samples, surface: Surface | None) -> list[Panel]:
    """Return the moon on its orbit, seen from above."""
    system, orbit = trajectory.source, trajectory.source.orbit
    place = np.asarray(orbit.direction(samples.times)) * np.asarray(orbit.distance_ratio(samples.times))[:, None]
    return [{
        "type": "orbit", "place": packed(place[:, :2]),
        "angle": packed(trajectory.layout.part(samples.states, "angle")),
        "eccentricity": float(orbit.eccentricity), "asphericity": float(system.asphericity), "flat": True,
    }]  # fmt: skip
