"""The picture of a spin on an orbit on a page."""

from __future__ import annotations

from typing import Any

import numpy as np

from polhode._base.arrays import compiled_for_few_calls
from polhode.bodies.surface import Surface
from polhode.celestial.spin_orbit.motion import steps_for
from polhode.celestial.spin_orbit.resonances import poincare_section
from polhode.kinds.panel import KindPanel
from polhode.motion._trajectory import Trajectory
from polhode.simulation import simulate
from polhode.systems.kepler_orbit import KeplerOrbit
from polhode.types import Array
from polhode.viewer.encoding import pack
from polhode.viewer.panels import Panel
from polhode.viewer.samples import Samples


def _series(name: str, values: Array) -> dict[str, Any]:
    return {"name": name, "values": pack(values, "f4")}


@compiled_for_few_calls
def _places(orbit: KeplerOrbit, times: Array) -> Array:
    """Return where the moon is (…, 3), in units of the semi-major axis."""
    return orbit.direction(times) * orbit.distance_ratio(times)[..., None]


class SpinOrbitPanel(KindPanel):
    """The picture of a spin on an orbit on a page."""

    def panels(self, trajectory: Trajectory, samples: Samples, surface: Surface | None) -> list[Panel]:
        """Return the moon on its orbit, from above."""
        system, orbit = trajectory.source, trajectory.source.orbit
        place = np.asarray(_places(orbit, samples.times))
        return [{
            "type": "orbit", "place": pack(place[:, :2]),
            "angle": pack(trajectory.layout.part(samples.states, "angle")),
            "eccentricity": float(orbit.eccentricity), "asphericity": float(system.asphericity), "flat": True,
        }]  # fmt: skip

    def plots(self, trajectory: Trajectory, samples: Samples) -> dict[str, Any]:
        """Return angle and rate, the distance to a motion from a nearby start, and the section at periapsis."""
        offset = 1e-6  # rad
        least = 1e-9  # rad, where a distance of zero is drawn
        orbits = 1500  # of the section
        system, n = trajectory.source, float(trajectory.source.mean_motion)
        angle, rate = (trajectory.layout.part(samples.states, name) for name in ("angle", "rate"))
        plots = [
            {"title": "angle of the long axis, half turns taken off", "unit": "°",
             "series": [_series("angle", np.degrees(angle - np.pi * np.round(angle / np.pi)))]},
            {"title": "rate", "unit": "turns per orbit", "series": [_series("rate", rate / n)]},
        ]  # fmt: skip
        if samples.times[0] != 0.0 or len(samples.times) < 2:
            return {"plots": plots}
        start = np.array([angle[0], rate[0]])
        other = simulate(system, start + np.array([offset, 0.0]), samples.times, estimate_error=False)
        apart = np.log10(np.maximum(np.abs(np.asarray(other.part("angle")) - angle), least))
        plots.insert(1, {"title": "distance to a twin that starts 10⁻⁶ rad apart", "unit": "log₁₀ rad",
                         "series": [_series("distance", apart)]})
        points = poincare_section(system, start, orbits, steps_for(system, float(rate[0]) / n))
        angles = points[:, 0] - np.pi * np.round(points[:, 0] / np.pi)
        section = {"title": "Section at periapsis", "words": ["{count} orbits: θ̇/n against θ [°]", {"count": orbits}],
                   "x": pack(np.degrees(angles), "f4"), "y": pack(points[:, 1] / n, "f4")}  # fmt: skip
        return {"plots": plots, "scatters": (section,)}


PANEL = SpinOrbitPanel()
