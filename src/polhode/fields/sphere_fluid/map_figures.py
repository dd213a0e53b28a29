"""Maps of the vorticity: an equal-area map, and the globe from outside."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure

from polhode.fields.sphere.maps import COLATITUDES, LONGITUDES, SphereMap, both_sides, mollweide_maps
from polhode.fields.sphere_fluid.answers import FluidReport


def draw_vorticity(report: FluidReport) -> Figure:
    """Return Mollweide's equal-area maps of the relative vorticity at start, middle and end."""
    count = len(report.trajectory.times)
    chosen = sorted({0, count // 2, count - 1})
    states = np.asarray(report.trajectory.states)[chosen]
    fields = np.asarray(report.system.on_grid(states, COLATITUDES, LONGITUDES))
    maps = [SphereMap(f"after {float(report.trajectory.times[k]):.4g} s", field)
            for k, field in zip(chosen, fields, strict=True)]
    return mollweide_maps(maps, "relative vorticity  [rad/s]")


def draw_globe(report: FluidReport) -> Figure:
    """Return the relative vorticity at the end from two opposite sides, in orthographic projection."""
    return both_sides(report.system.on_grid(report.trajectory.states[-1], COLATITUDES, LONGITUDES), "at the end")
