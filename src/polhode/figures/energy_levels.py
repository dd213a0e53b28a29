"""Curves of constant energy on the momentum sphere, which undamped motions follow."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
from matplotlib.collections import LineCollection

from polhode.analysis.polhodes import level_segments
from polhode.figures import style
from polhode.figures.sphere import view_frame
from polhode.types import Array, Float64

MARKS = {"stable": ("o", style.GREEN), "unstable": ("X", style.VERMILION), "undecided": ("s", style.UNDECIDED)}


def draw_levels(
    axes: Any,
    frame: Float64[np.ndarray, "3 3"],
    energy: Callable[[Array], Array],
    values: Sequence[float] | None,
    colour: str,
    width: float,
) -> None:
    """Draw where a function of unit vectors (…, 3) has the values, by default evenly spread ones; far side dimmed."""
    pieces = level_segments(energy, values)
    x, y, depth = np.moveaxis(pieces @ frame.T, -1, 0)
    for front in (False, True):
        facing = (depth.mean(axis=-1) >= 0.0) == front
        axes.add_collection(LineCollection(
            list(np.stack([x[facing], y[facing]], axis=-1)), colors=colour, linewidths=width, capstyle="butt",
            alpha=1.0 if front else 0.25, zorder=2 if front else 1,
        ), autolim=False)


def mark_verdict(axes: Any, frame: Float64[Array, "3 3"], point: Float64[Array, "3"], verdict: str) -> None:
    """Mark an equilibrium at a unit vector."""
    x, y, depth = frame @ point
    shape, colour = MARKS[verdict]
    axes.plot([x], [y], shape, ms=5, color=colour, mec="white", mew=0.6, zorder=6, alpha=1.0 if depth >= 0 else 0.4)


def label_axes(axes: Any, frame: Float64[Array, "3 3"], names: Sequence[str] = ("$L_1$", "$L_2$", "$L_3$")) -> None:
    """Draw the ends of the body's axes."""
    for k, name in enumerate(names):
        x, y, _ = frame @ np.eye(3)[k]
        size = np.hypot(x, y)
        reach, beyond = 1.0 + 0.12 / size, 1.0 + 0.22 / size
        axes.plot([x, reach * x], [y, reach * y], color=style.DARK, lw=0.7, zorder=4)
        axes.text(beyond * x, beyond * y, name, fontsize=style.FONT + 1, ha="center", va="center", color=style.DARK,
                  zorder=6, bbox={"fc": "white", "ec": "none", "pad": 0.6, "alpha": 0.85})


def draw_legend(axes: Any, lines: Sequence[tuple[str, str, float]], verdicts: Sequence[str]) -> None:
    """Draw the legend of lines (label, colour, width) and of verdicts marked."""
    handles = [axes.plot([], [], color=colour, lw=width, label=label)[0] for label, colour, width in lines]
    for word in MARKS:
        if word in verdicts:
            shape, colour = MARKS[word]
            handles.append(axes.plot([], [], shape, color=colour, ms=5, mec="white", mew=0.6, label=word)[0])
    axes.legend(handles=handles, loc="upper center", bbox_to_anchor=(0.5, -0.01), ncols=3, fontsize=style.FONT - 1,
                frameon=False, handlelength=1.6, columnspacing=1.2)


def default_frame() -> Float64[np.ndarray, "3 3"]:
    """Return the frame of the usual view."""
    direction = (0.80, 0.46, 0.38)
    return view_frame(direction)
