"""Maps of functions on a sphere: an equal-area map, and the globe from outside."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
from matplotlib.figure import Figure
from scipy.ndimage import map_coordinates

from polhode.figures import style
from polhode.types import Array, Float64

COLOURS = "RdBu_r"
ROWS = 180  # of a map
TILT = np.radians(25.0)  # of the globe's axis towards the reader

COLATITUDES = (np.arange(ROWS) + 0.5) * np.pi / ROWS
LONGITUDES = (np.arange(2 * ROWS) + 0.5) * np.pi / ROWS - np.pi


class SphereMap(NamedTuple):
    """A function on the grid of ``COLATITUDES`` and ``LONGITUDES``.

    Attributes:
        title: above the map.
        values: (rows, columns), drawn in colours.
        contours: (rows, columns) of another function, drawn by lines; None for no lines.
    """

    title: str
    values: Float64[Array, "rows columns"]
    contours: Float64[Array, "rows columns"] | None = None


def mollweide_maps(maps: Sequence[SphereMap], label: str, columns: int = 1) -> Figure:
    """Return Mollweide's equal-area maps, row by row, with one scale of colours."""
    largest = colour_limit(np.stack([each.values for each in maps]))
    rows = -(-len(maps) // columns)
    figure = style.new_figure(width=style.COLUMN * (1.0 if columns == 1 else 0.9 * columns),
                              height=0.1 + 0.6 * style.COLUMN * rows)
    drawn: Any = None
    lines = 12  # contours
    for k, each in enumerate(maps):
        axes: Any = figure.add_subplot(rows, columns, k + 1, projection="mollweide")
        drawn = axes.pcolormesh(LONGITUDES, 0.5 * np.pi - COLATITUDES, each.values, cmap=COLOURS, vmin=-largest,
                                vmax=largest, shading="nearest", rasterized=True)
        if each.contours is not None and np.ptp(each.contours) > 0:
            axes.contour(LONGITUDES, 0.5 * np.pi - COLATITUDES, each.contours, lines, colors="k", linewidths=0.4)
        axes.set(xticklabels=[], yticklabels=[], title="")
        axes.grid(color=style.GREY, lw=0.3, alpha=0.5)
        axes.set_title(each.title, fontsize=style.FONT)
    bar = figure.colorbar(drawn, ax=figure.axes, orientation="horizontal", shrink=0.7, aspect=40, pad=0.02)
    bar.set_label(label, fontsize=style.FONT)
    bar.ax.tick_params(labelsize=style.FONT - 1)
    return figure


def both_sides(values: Float64[Array, "rows columns"], when: str) -> Figure:
    """Return a function from two opposite sides, in orthographic projection."""
    figure = style.new_figure(width=1.7 * style.COLUMN, height=0.95 * style.COLUMN)
    sides = [_project_globe(np.asarray(values), longitude) for longitude in (0.0, np.pi)]
    largest = colour_limit(np.stack(sides))
    panels = list(figure.subplots(1, 2))
    for axes, field, longitude in zip(panels, sides, (0, 180), strict=True):
        axes.imshow(field, extent=(-1.0, 1.0, -1.0, 1.0), origin="lower", cmap=COLOURS, vmin=-largest, vmax=largest)
        angle = np.linspace(0.0, 2.0 * np.pi, 181)
        axes.plot(np.cos(angle), np.sin(angle), color=style.GREY, lw=0.8)
        axes.set_title(f"from longitude {longitude}°, {when}", fontsize=style.FONT)
        axes.set_aspect("equal")
        axes.axis("off")
    return figure


def _project_globe(values: Array, longitude: float) -> Float64[np.ndarray, "across across"]:
    """Return the function on a square around the globe's disk, NaN outside."""
    points = 320  # across a globe
    across = np.linspace(-1.0, 1.0, points)
    x, y = np.meshgrid(across, across)
    square = 1.0 - x * x - y * y
    depth = np.sqrt(np.where(square >= 0.0, square, np.nan))
    z = y * np.cos(TILT) + depth * np.sin(TILT)
    front = depth * np.cos(TILT) - y * np.sin(TILT)
    theta, phi = np.arccos(np.clip(z, -1.0, 1.0)), np.arctan2(x, front) + longitude + np.pi
    padded = np.pad(np.pad(values, ((1, 1), (0, 0)), mode="edge"), ((0, 0), (1, 1)), mode="wrap")
    row = np.nan_to_num(theta) / np.pi * ROWS + 0.5
    column = np.mod(np.nan_to_num(phi) / (2.0 * np.pi), 1.0) * 2 * ROWS + 0.5
    return np.where(np.isfinite(depth), map_coordinates(padded, [row, column], order=1), np.nan)


def colour_limit(fields: Array) -> float:
    """Return the value at which colours end."""
    percentile = 99.7  # at which colours end: extreme values would leave the rest pale
    return float(np.nanpercentile(np.abs(fields), percentile)) or 1.0
