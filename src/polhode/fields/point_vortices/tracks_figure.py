"""The paths of point vortices."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.figure import Figure

from polhode.fields.point_vortices.answers import VorticesReport
from polhode.fields.point_vortices.sides import flatten_side, new_sides
from polhode.figures import style
from polhode.types import Array, Float64

SENSES = {1.0: ("anticlockwise", style.BLUE), -1.0: ("clockwise", style.VERMILION)}


def draw_tracks(report: VorticesReport) -> Figure:
    """Return the tracks of the vortices, with rings at the start and dots at the end."""
    if report.sphere_radius is not None:
        return _on_sphere(report)
    figure = style.new_figure(height=style.COLUMN + 0.3)
    axes = figure.subplots()
    _draw(axes, report, report.positions)
    axes.set_aspect("equal", adjustable="datalim")
    axes.set_xlabel("x  [m]")
    axes.set_ylabel("y  [m]")
    style.tidy(axes)
    _legend(figure, axes)
    return figure


def _on_sphere(report: VorticesReport) -> Figure:
    figure, panels, rotation = new_sides(choose_axis(report))
    places = np.asarray(report.system.positions(report.trajectory.states)) @ rotation.T
    for axes, front in zip(panels, (True, False), strict=True):
        _draw(axes, report, flatten_side(places, front))
    _legend(figure, panels[0])
    return figure


def choose_axis(report: VorticesReport) -> Float64[Array, "3"]:
    """Return the axis (3,) from which a sphere is viewed: that of the turn, of J, or the north pole."""
    pole = np.array([0.0, 0.0, 1.0])
    if report.turn is not None and report.turn.axis is not None and report.turn.rate:
        axis = report.turn.axis
        return pole if abs(axis[2]) > 1.0 - 1e-9 else axis
    return pole


def _draw(axes: Any, report: VorticesReport, places: Array) -> None:
    for k, strength in enumerate(report.strengths):
        name, color = SENSES[float(np.sign(strength))]
        axes.plot(places[:, k, 0], places[:, k, 1], color=color, lw=0.8, label=name)
        axes.plot(*places[0, k], "o", ms=3.5, mfc="white", mec=color, mew=0.9)
        axes.plot(*places[-1, k], "o", ms=3.5, color=color)


def _legend(figure: Figure, axes: Any) -> None:
    handles, labels = axes.get_legend_handles_labels()
    first = dict(reversed(list(zip(labels, handles, strict=True))))
    (start,) = axes.plot([], [], "o", ms=3.5, mfc="white", mec=style.GREY, mew=0.9)
    (end,) = axes.plot([], [], "o", ms=3.5, color=style.GREY)
    figure.legend([*first.values(), start, end], [*first, "start", "end"], loc="outside upper center", ncols=4,
                  fontsize=style.FONT - 1, frameon=False, handlelength=1.6)
