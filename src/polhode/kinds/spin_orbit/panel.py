"""The picture of a spin on an orbit on a page."""

from __future__ import annotations

from typing import Any

import numpy as np

from polhode.systems.spin_orbit import LAYOUT
from polhode.viewer.encoding import packed
from polhode.viewer.panels import Content
from polhode.viewer.samples import Samples


def content_of(system: Any, samples: Samples, script: str) -> Content:
    """Return the moon on its orbit, seen from above."""
    orbit = system.orbit
    place = np.asarray(orbit.direction(samples.times)) * np.asarray(orbit.distance_ratio(samples.times))[:, None]
    panel = {
        "type": "orbit", "angle": packed(LAYOUT.part(samples.states, "angle")), "place": packed(place[:, :2]),
        "eccentricity": float(orbit.eccentricity), "asphericity": float(system.asphericity), "flat": True,
    }  # fmt: skip
    return Content([panel], (script,))
