"""One look for every figure: column width, colours safe for the colour-blind, no global state."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
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


def power_of_ten(values: Any) -> int:
    """Return the power of ten to take out of an axis, a multiple of three, zero for handy numbers."""
    largest = float(np.max(np.abs(values)))
    if largest == 0.0 or 1e-2 <= largest < 1e4:
        return 0
    return 3 * int(np.floor(np.log10(largest) / 3.0))


def factor(power: int) -> str:
    """Return the power of ten as it stands before an axis's unit."""
    return f"10$^{{{power}}}$ " if power else ""


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
    kinds = {".png": {"Software": "polhode"}, ".svg": {"Creator": "polhode"}, ".pdf": {"Creator": "polhode"}}
    figure.savefig(path, dpi=DOTS_PER_INCH, facecolor="white", metadata=kinds.get(path.suffix))
    return path
