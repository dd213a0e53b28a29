"""Curves on a sphere in an oblique view, the far side dimmed."""

from __future__ import annotations

from typing import Any

import numpy as np

from polhode.figures import style
from polhode.types import Array, ArrayLike, Float64, Real


def draw_disk(axes: Any) -> None:
    """Draw the disk of the sphere, and give the axes their window."""
    circle = np.linspace(0.0, 2.0 * np.pi, 400)
    axes.fill(np.cos(circle), np.sin(circle), color="#f4f4f4", zorder=-5)
    axes.plot(np.cos(circle), np.sin(circle), color=style.LIGHT, lw=0.8)
    axes.set_aspect("equal")
    axes.set_xlim(-1.36, 1.36)
    axes.set_ylim(-1.06, 1.36)
    axes.axis("off")


def view_frame(view: Real[ArrayLike, "3"]) -> Float64[np.ndarray, "3 3"]:
    """Return right, up and towards the viewer as rows; the third axis points up the page."""
    towards = np.asarray(view) / np.linalg.norm(view)
    right = np.cross([0.0, 0.0, 1.0], towards)
    right = right / np.linalg.norm(right)
    return np.stack([right, np.cross(towards, right), towards])


def draw_curve(
    axes: Any, frame: Float64[Array, "3 3"], curve: Float64[Array, "time 3"], colour: str, width: float
) -> None:
    """Draw a curve (T, 3) on the unit sphere."""
    x, y, depth = frame @ curve.T
    for front in (False, True):
        facing = (depth >= 0.0) == front
        # keep one neighbour so that both halves meet at the rim
        wide = facing | np.roll(facing, 1)
        axes.plot(np.where(wide, x, np.nan), np.where(wide, y, np.nan), color=colour, lw=width,
                  alpha=1.0 if front else 0.25, zorder=3 if front else 1, solid_capstyle="round")


def mark_point(axes: Any, frame: Float64[Array, "3 3"], point: Float64[Array, "3"]) -> None:
    """Draw where the motion starts."""
    x, y, depth = frame @ point
    axes.plot([x], [y], "o", ms=4, color=style.BLUE, mec="white", mew=0.6, zorder=5, alpha=1.0 if depth >= 0 else 0.4)
