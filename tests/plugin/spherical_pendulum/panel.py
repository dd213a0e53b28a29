"""The picture of a spherical pendulum on a page."""

from __future__ import annotations

import numpy as np

from polhode.motion.trajectory import Trajectory
from polhode.viewer.encoding import packed
from polhode.viewer.panels import Content
from polhode.viewer.samples import Samples


def content_of(trajectory: Trajectory, samples: Samples, script: str) -> Content:
    """Return the rod, the mass and its path, in lengths of the rod."""
    place = np.asarray(samples.states)[:, :3] / float(trajectory.source.length)
    return Content([{"type": "pendulum", "place": packed(place)}], (script,))
