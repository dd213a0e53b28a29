"""The picture of a rolling disk on a page."""

from __future__ import annotations

from typing import Any

import numpy as np

from polhode.bodies.surface import Surface
from polhode.kinds.panel import KindPanel
from polhode.motion._trajectory import Trajectory
from polhode.rolling.euler_disk.dissipation import LAWS as MODELS
from polhode.rolling.euler_disk.laws import LAWS
from polhode.rolling.euler_disk.report import EulerDiskReport
from polhode.viewer.encoding import pack
from polhode.viewer.panels import Panel
from polhode.viewer.samples import Samples


class EulerDiskPanel(KindPanel):
    """The picture of a rolling disk on a page."""

    def panels(self, trajectory: Trajectory, samples: Samples, surface: Surface | None) -> list[Panel]:
        """Return the disk, the path of its contact and that of its centre."""
        elevation = 0.62  # rad, from which the path, which lies flat, is viewed
        disk, layout = trajectory.source, trajectory.layout
        contact = np.stack([layout.part(samples.states, name) for name in ("contact_x", "contact_y")], axis=-1)
        return [{
            "type": "disk", "radius": float(disk.mechanics.radius),
            "thickness": 2.0 * float(disk.mechanics.half_thickness),
            "contact": pack(contact), "center": pack(np.asarray(disk.center(samples.states))), "elevation": elevation,
        }]  # fmt: skip

    def model(self, trajectory: Trajectory) -> dict[str, Any] | None:
        """Return the disk, its losses and its start; None with a law that specs do not know."""
        disk, body = trajectory.source, trajectory.source.mechanics
        laws = disk.dissipation
        if trajectory.batch_shape or not len(trajectory) or any(type(law) not in MODELS for law in laws):
            return None
        moments = [float(body.diametral_moment), float(body.axial_moment)]
        return {
            "solver": "EulerDisk", "mass": float(body.mass), "radius": float(body.radius),
            "half_thickness": float(body.half_thickness), "diametral_moment": moments[0], "axial_moment": moments[1],
            "gravity": float(body.gravity),
            "dissipation": {law.name: float(getattr(law, LAWS[law.name].key)) for law in laws},
            "start": np.asarray(trajectory.states, dtype=float)[0].tolist(), "epoch": float(trajectory.times[0]),
        }  # fmt: skip

    def scatters(self, report: EulerDiskReport) -> tuple[dict[str, Any], ...]:
        """Return tilt and precession against the time left, for a motion that ends."""
        spin_down = report.spin_down
        if spin_down is None or spin_down.remaining is None:
            return ()
        left = np.asarray(spin_down.remaining)
        ahead = left > 0.0
        states = np.asarray(spin_down.trajectory.states)[ahead]
        tilt = np.degrees(np.asarray(spin_down.trajectory.part("tilt"))[ahead])
        rate = np.abs(report.disk.precession(states))
        words = "the whole motion: log₁₀ {unit} against log₁₀ of the time left [s], which runs to the left"
        return tuple(
            {"title": title, "words": [words, {"unit": unit}], "x": pack(np.log10(left[ahead]), "f4"),
             "y": pack(np.log10(np.asarray(values)), "f4")}
            for title, unit, values in (("Tilt", "[°]", tilt), ("Precession", "[rad/s]", rate))
        )


PANEL = EulerDiskPanel()
