"""The pictures of a body with a rotor on a page."""

from __future__ import annotations

from typing import Any

import numpy as np

from polhode.bodies.surface import Surface
from polhode.kinds.panel import KindPanel
from polhode.motion._trajectory import Trajectory
from polhode.systems.gyrostat import Gyrostat
from polhode.viewer.encoding import pack
from polhode.viewer.models import find_start
from polhode.viewer.panels import Panel, body_panels, find_moments, sphere_of_levels
from polhode.viewer.samples import Samples


def _find_rotor(trajectory: Trajectory, samples: Samples) -> dict[str, Any]:
    """Return the rotor's axis along those of the samples, and its rate against the body there, if that is known."""
    system, velocity, rates = trajectory.source, samples.angular_velocity, None
    if isinstance(system, Gyrostat):
        axis = np.asarray(system.rotor, dtype=float)
        axis = axis / (np.linalg.norm(axis) or 1.0) if axis.any() else np.array([0.0, 0.0, 1.0])
        if system.rotor_moment is not None and velocity is not None:
            rates = np.asarray(system.rotor_rate(np.asarray(velocity)))
    else:
        axis = np.asarray(system.axis, dtype=float)
        if velocity is not None:
            momentum = trajectory.layout.part(samples.states, "rotor_momentum")
            rates = momentum / float(system.rotor_moment) - np.asarray(velocity) @ axis
    return {"axis": axis.tolist(), "rates": None if rates is None else pack(rates, "f8")}


class GyrostatPanel(KindPanel):
    """The pictures of a body with a rotor on a page."""

    def model(self, trajectory: Trajectory) -> dict[str, Any] | None:
        """Return the body, its rotor and its start; None with a motor, and without attitudes."""
        system, start = trajectory.source, find_start(trajectory)
        if start is None or not isinstance(system, Gyrostat):
            return None
        rotor = np.asarray(system.rotor, dtype=float)
        drive = "free" if system.free else "constant-rate"
        numbers = {"rotor": rotor.tolist(), "rotor_moment": system.rotor_moment, "rotor_drive": drive}
        return {"solver": "Gyrostat", **numbers, **start}

    def panels(self, trajectory: Trajectory, samples: Samples, surface: Surface | None) -> list[Panel]:
        """Return the body and the momentum sphere with levels of the carrier's energy."""
        system, moments = trajectory.source, find_moments(trajectory.source)
        panels = body_panels(samples, moments, surface)
        for panel in panels:
            panel["rotor"] = _find_rotor(trajectory, samples)
        if samples.momentum is None or not np.linalg.norm(samples.momentum, axis=-1).any():
            return panels
        if isinstance(system, Gyrostat):
            rotor, words = np.asarray(system.rotor, dtype=float), "direction of L in body axes"
        else:
            last = float(trajectory.layout.part(samples.states, "rotor_momentum")[-1])
            rotor = last * np.asarray(system.axis, dtype=float)
            words = "direction of L in body axes; levels are those at the end"
        return [*panels, sphere_of_levels(samples.momentum, moments, rotor, words)]


PANEL = GyrostatPanel()
