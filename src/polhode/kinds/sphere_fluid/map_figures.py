"""Maps of the vorticity: equal in area, and as one sees a globe."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.figure import Figure

from polhode.figures import style
from polhode.kinds.sphere_fluid.answers import FluidReport
from polhode.types import Array

COLOURS = "RdBu_r"
ROWS = 180  # of a map
TILT = np.radians(25.0)  # of the globe's axis towards the reader
ACROSS = 320  # points across a globe


def draw_vorticity(report: FluidReport) -> Figure:
    """Return Mollweide's equal-area maps of the relative vorticity at start, middle and end."""
    count = len(report.trajectory.times)
    chosen = sorted({0, count // 2, count - 1})
    states = np.asarray(report.trajectory.states)[chosen]
    theta = (np.arange(ROWS) + 0.5) * np.pi / ROWS
    phi = (np.arange(2 * ROWS) + 0.5) * np.pi / ROWS - np.pi
    fields = np.asarray(report.system.on_grid(states, theta, phi))
    largest = _largest(fields)
    figure = style.new_figure(height=0.1 + 0.6 * style.COLUMN * len(chosen))
    for k, field in enumerate(fields):
        axes: Any = figure.add_subplot(len(chosen), 1, k + 1, projection="mollweide")
        drawn = axes.pcolormesh(phi, 0.5 * np.pi - theta, field, cmap=COLOURS, vmin=-largest, vmax=largest,
                                shading="nearest", rasterized=True)  # fmt: skip
        axes.set(xticklabels=[], yticklabels=[], title="")
        axes.grid(color=style.GREY, lw=0.3, alpha=0.5)
        axes.set_title(f"after {float(report.trajectory.times[chosen[k]]):.4g} s", fontsize=style.FONT)
        if k == len(chosen) - 1:
            bar = figure.colorbar(drawn, ax=figure.axes, orientation="horizontal", shrink=0.7, aspect=40, pad=0.02)
            bar.set_label("relative vorticity  [rad/s]", fontsize=style.FONT)
            bar.ax.tick_params(labelsize=style.FONT - 1)
    return figure


def draw_globe(report: FluidReport) -> Figure:
    """Return the relative vorticity at the end from two opposite sides, in orthographic projection."""
    figure = style.new_figure(width=1.7 * style.COLUMN, height=0.95 * style.COLUMN)
    sides = [_seen(report, longitude) for longitude in (0.0, np.pi)]
    largest = _largest(np.stack([field for field, _ in sides]))
    panels = list(figure.subplots(1, 2))
    for axes, (field, extent), longitude in zip(panels, sides, (0, 180), strict=True):
        axes.imshow(field, extent=extent, origin="lower", cmap=COLOURS, vmin=-largest, vmax=largest)
        angle = np.linspace(0.0, 2.0 * np.pi, 181)
        axes.plot(np.cos(angle), np.sin(angle), color=style.GREY, lw=0.8)
        axes.set_title(f"from longitude {longitude}°, at the end", fontsize=style.FONT)
        axes.set_aspect("equal")
        axes.axis("off")
    return figure


def _seen(report: FluidReport, longitude: float) -> tuple[Array, tuple[float, float, float, float]]:
    """Return the vorticity on a square around the globe's disk, NaN outside, and the square."""
    across = np.linspace(-1.0, 1.0, ACROSS)
    x, y = np.meshgrid(across, across)
    square = 1.0 - x * x - y * y
    depth = np.sqrt(np.where(square >= 0.0, square, np.nan))
    z = y * np.cos(TILT) + depth * np.sin(TILT)
    front = depth * np.cos(TILT) - y * np.sin(TILT)
    theta, phi = np.arccos(np.clip(z, -1.0, 1.0)), np.arctan2(x, front) + longitude
    rows, columns = 2 * ROWS, 4 * ROWS
    grid = np.asarray(report.system.on_grid(
        report.trajectory.states[-1], (np.arange(rows) + 0.5) * np.pi / rows,
        (np.arange(columns) + 0.5) * 2.0 * np.pi / columns,
    ))  # fmt: skip
    inside = np.isfinite(depth)
    row = np.where(inside, np.minimum(np.nan_to_num(theta) / np.pi * rows, rows - 1), 0).astype(int)
    column = np.where(inside, np.mod(np.nan_to_num(phi), 2.0 * np.pi) / (2.0 * np.pi) * columns, 0).astype(int)
    field = np.where(inside, grid[row, np.minimum(column, columns - 1)], np.nan)
    return field, (-1.0, 1.0, -1.0, 1.0)


def _largest(fields: Array) -> float:
    """Return the value at which colours end: extreme vortices would leave the rest pale."""
    return float(np.nanpercentile(np.abs(fields), 99.7)) or 1.0
