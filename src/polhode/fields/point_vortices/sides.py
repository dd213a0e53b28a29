"""The two sides of a sphere as disks, as viewed from far away."""

from __future__ import annotations

from typing import Any

import numpy as np

from polhode.figures import style
from polhode.types import Array, Float64


def new_sides(axis: Float64[Array, "3"]) -> tuple[Any, list[Any], Float64[Array, "3 3"]]:
    """Return a figure, two axes, and the rotation matrix (3, 3) that points an axis at the viewer.

    Args:
        axis: (3,) unit vector, viewed from its tip on the left and from behind on the right.
    """
    helper = np.array([1.0, 0.0, 0.0]) if abs(axis[0]) < 0.9 else np.array([0.0, 1.0, 0.0])
    first = helper - (helper @ axis) * axis
    first = first / np.linalg.norm(first)
    figure = style.new_figure(width=1.7 * style.COLUMN, height=0.98 * style.COLUMN)
    axes = list(figure.subplots(1, 2))
    angle = np.linspace(0.0, 2.0 * np.pi, 181)
    circles = (30.0, 60.0)  # degrees from the pole, for orientation
    for panel, title in zip(axes, (f"from {_tip(axis)}", "from behind"), strict=True):
        panel.plot(np.cos(angle), np.sin(angle), color=style.GREY, lw=0.8)
        for step in np.radians(circles):
            panel.plot(np.sin(step) * np.cos(angle), np.sin(step) * np.sin(angle), color=style.LIGHT, lw=0.5)
        panel.set(xlim=(-1.03, 1.03), ylim=(-1.03, 1.03))
        panel.set_title(title, fontsize=style.FONT)
        panel.set_aspect("equal")
        panel.axis("off")
    return figure, axes, np.stack([first, np.cross(axis, first), axis])


def flatten_side(places: Float64[Array, "*batch 3"], front: bool) -> Float64[Array, "*batch 2"]:
    """Return rotated places as points of one side's disk (…, 2); NaN for places on the other side."""
    shown = np.where((places[..., 2] >= 0.0) == front, 1.0, np.nan)
    flipped = np.stack([places[..., 0] * (1.0 if front else -1.0), places[..., 1]], axis=-1)
    return flipped * shown[..., None]


def disk(count: int, front: bool) -> tuple[Float64[Array, "m m"], Float64[Array, "m m"], Float64[Array, "m m 3"]]:
    """Return a grid over a side's disk, and the rotated places that it shows; NaN outside of it."""
    across = np.linspace(-1.0, 1.0, count)
    x, y = np.meshgrid(across, across)
    square = 1.0 - x * x - y * y
    height = np.sqrt(np.where(square >= 0.0, square, np.nan))
    sign = 1.0 if front else -1.0
    return x, y, np.stack([sign * x, y + 0.0 * height, sign * height], axis=-1)


def _tip(axis: Float64[Array, "3"]) -> str:
    return "the north pole" if axis[2] > 1.0 - 1e-9 else "the axis's tip"
