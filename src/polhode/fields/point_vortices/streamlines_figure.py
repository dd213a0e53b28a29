"""Streamlines of the fluid around point vortices at the start."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.figure import Figure

from polhode.fields.point_vortices.answers import VorticesReport
from polhode.fields.point_vortices.sides import disk, new_sides
from polhode.fields.point_vortices.system import PlaneVortices
from polhode.fields.point_vortices.tracks_figure import SENSES, choose_axis
from polhode.figures import style
from polhode.types import Array

POINTS_ACROSS = 240


def draw_streamlines(report: VorticesReport) -> Figure:
    """Return the streamlines at the start, in a frame that turns or moves with the vortices."""
    if report.sphere_radius is not None:
        return _on_sphere(report)
    system, start = report.system, report.positions[0]
    assert isinstance(system, PlaneVortices)
    figure = style.new_figure(height=style.COLUMN + 0.3)
    axes = figure.subplots()
    low, high = start.min(axis=0), start.max(axis=0)
    margin = 0.9  # of the vortices' extent, on each side
    middle, half = 0.5 * (low + high), (0.5 + margin) * float((high - low).max())
    across = np.linspace(-half, half, POINTS_ACROSS)
    x, y = np.meshgrid(middle[0] + across, middle[1] + across)
    psi = np.asarray(system.stream_function(report.trajectory.states[0], np.stack([x, y], axis=-1)))
    turn = report.turn
    if turn is not None and turn.center is not None:
        psi = psi - 0.5 * turn.rate * ((x - turn.center[0]) ** 2 + (y - turn.center[1]) ** 2)
    elif turn is not None and turn.velocity is not None:
        psi = psi - (turn.velocity[1] * x - turn.velocity[0] * y)
    axes.contour(x, y, psi, levels=_levels(psi), colors=style.GREY, linewidths=0.6, linestyles="solid")
    _mark(axes, report, start)
    axes.set_aspect("equal")
    axes.set_xlabel("x  [m]")
    axes.set_ylabel("y  [m]")
    axes.set_title(_describe_view(report), fontsize=style.FONT)
    style.tidy(axes)
    return figure


def _on_sphere(report: VorticesReport) -> Figure:
    figure, panels, rotation = new_sides(choose_axis(report))
    system, state, turn = report.system, report.trajectory.states[0], report.turn
    places = np.asarray(system.positions(state)) @ rotation.T
    sides = [disk(POINTS_ACROSS, front) for front in (True, False)]
    fields = []
    for _, _, shown in sides:
        at = shown @ rotation
        psi = np.asarray(system.stream_function(state, at))
        fields.append(psi if turn is None or turn.axis is None else psi + turn.rate * (at @ turn.axis))
    levels = _levels(np.stack(fields))
    for axes, (x, y, _), psi, front in zip(panels, sides, fields, (True, False), strict=True):
        axes.contour(x, y, psi, levels=levels, colors=style.GREY, linewidths=0.6, linestyles="solid")
        here = (places[:, 2] >= 0.0) == front
        marked = np.where(here[:, None], places[:, :2] * np.array([1.0 if front else -1.0, 1.0]), np.nan)
        _mark(axes, report, marked)
    figure.suptitle(_describe_view(report), fontsize=style.FONT)
    return figure


def _levels(psi: Array) -> Array:
    """Return levels away from the poles of the stream function, near which all levels would crowd."""
    percentiles = (1.5, 98.5)  # of the stream function between which lines are drawn
    low, high = np.nanpercentile(psi, percentiles)
    return np.linspace(low, high, 28)


def _mark(axes: Any, report: VorticesReport, places: Array) -> None:
    for strength, place in zip(report.strengths, places, strict=True):
        axes.plot(*place, "o", ms=4, color=SENSES[float(np.sign(strength))][1])


def _describe_view(report: VorticesReport) -> str:
    turn = report.turn
    if turn is None:
        return "streamlines at the start"
    return "streamlines, turning with the vortices" if turn.rate else "streamlines, moving with the vortices"
