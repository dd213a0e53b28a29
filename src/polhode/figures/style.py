"""One look for every figure: column width, colours safe for the colour-blind, no global state."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

COLUMN = 3.6  # inches, a journal's column
DOTS_PER_INCH = 200
# Okabe & Ito's palette
BLUE, ORANGE, GREEN, VERMILION, SKY, PURPLE = "#0072B2", "#E69F00", "#009E73", "#D55E00", "#56B4E9", "#CC79A7"
AXIS_COLOURS = (BLUE, ORANGE, GREEN)
GREY, LIGHT, DARK = "#6f6f6f", "#c8c8c8", "#222222"
FONT = 8


def new_figure(width: float = COLUMN, height: float = COLUMN) -> Figure:
    """Return an empty figure with its own canvas."""
    figure = Figure(figsize=(width, height), dpi=DOTS_PER_INCH, layout="constrained")
    FigureCanvasAgg(figure)
    return figure


def tidy(axes: Any) -> None:
    """Give axes the house's fonts and thin spines."""
    axes.tick_params(labelsize=FONT - 1, colors=DARK, width=0.6, length=2.5)
    axes.xaxis.label.set_size(FONT)
    axes.yaxis.label.set_size(FONT)
    for spine in axes.spines.values():
        spine.set_linewidth(0.6)
        spine.set_color(GREY)


def save(figure: Figure, path: Path) -> Path:
    """Write the figure in the form its ending names."""
    figure.savefig(path, dpi=DOTS_PER_INCH, facecolor="white")
    return path
