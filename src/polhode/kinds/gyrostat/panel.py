"""The pictures of a body with a rotor on a page."""

from __future__ import annotations

from typing import Any

import numpy as np

from polhode.bodies.surface import Surface
from polhode.motion.trajectory import Trajectory
from polhode.systems.gyrostat import Gyrostat
from polhode.viewer.models import start_of
from polhode.viewer.panels import Panel, body_panels, moments_of, sphere_of_levels
from polhode.viewer.samples import Samples


def model_of(trajectory: Trajectory) -> dict[str, Any] | None:
    """Return the body, its rotor and its start; None of one whose motor turns the rotor, and without attitudes."""
    system, start = trajectory.source, start_of(trajectory)
    if start is None or not isinstance(system, Gyrostat):
        return None
    return {"solver": "Gyrostat", "rotor": np.asarray(system.rotor, dtype=float).tolist(), **start}


def panels_of(trajectory: Trajectory, samples: Samples, surface: Surface | None) -> list[Panel]:
    """Return the body and the momentum sphere with levels of the carrier's energy."""
    system, moments = trajectory.source, moments_of(trajectory.source)
    found = body_panels(samples, moments, surface)
    if samples.momentum is None or not np.linalg.norm(samples.momentum, axis=-1).any():
        return found
    if isinstance(system, Gyrostat):
        rotor, words = np.asarray(system.rotor, dtype=float), ""
    else:
        last = float(trajectory.layout.part(samples.states, "rotor_momentum")[-1])
        rotor, words = last * np.asarray(system.axis, dtype=float), "; levels are those at the end"
    return [*found, sphere_of_levels(samples.momentum, moments, rotor, words)]
