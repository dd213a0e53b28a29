"""The data of any body's motion for the page's own solvers."""

from __future__ import annotations

from typing import Any

import numpy as np

from polhode.motion._trajectory import Trajectory


def find_start(trajectory: Trajectory) -> dict[str, Any] | None:
    """Return moments and the first state of one body, along the principal axes; None without attitude or momentum."""
    if trajectory.attitude is None or trajectory.momentum is None or trajectory.batch_shape or not len(trajectory):
        return None
    return {
        "moments": np.asarray(trajectory.source.moments, dtype=float).tolist(),
        "momentum": np.asarray(trajectory.momentum, dtype=float)[0].tolist(),
        "attitude": np.asarray(trajectory.attitude, dtype=float)[0].tolist(),
        "epoch": float(np.asarray(trajectory.times)[0]),
    }
