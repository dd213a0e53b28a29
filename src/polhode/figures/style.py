"""One look for every figure: column width, colours safe for the colour-blind, no global state."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import matplotlib
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
LOST, TOO_SMALL = 0.03, 1e-12  # of the largest: curves between are enlarged, those below are rounding
SETTINGS: Any = {
    "pdf.fonttype": 42,  # TrueType, embedded: publishers refuse type 3
    # text stays text, so that it can be searched, read aloud and set anew; among the fonts named for where DejaVu is
    # missing, Verdana has nearly its widths
    "svg.fonttype": "none",
    "svg.hashsalt": "polhode",  # names of clips and markers, otherwise drawn by chance
}
# what files say of themselves; without a date, so that the same motion gives the same file
METADATA: dict[str, dict[str, Any]] = {
    "png": {"Software": "polhode"},
    "svg": {"Creator": "polhode", "Date": None},
    "pdf": {"Creator": "polhode", "CreationDate": None},
}
_MARKS = {"png": b"Software\0polhode", "svg": b"<dc:title>polhode</dc:title>", "pdf": b"/Creator (polhode)"}


def new_figure(width: float = COLUMN, height: float = COLUMN) -> Figure:
    """Return an empty figure with its own canvas."""
    figure = Figure(figsize=(width, height), dpi=DOTS_PER_INCH, layout="constrained")
    FigureCanvasAgg(figure)
    return figure


def height_of(window: tuple[float, float, float, float], around: float = 0.6) -> float:
    """Return the height [inches] of a column-wide picture of this window, with so much for title and legend."""
    left, right, bottom, top = window
    return float(np.clip(COLUMN * (top - bottom) / (right - left) + around, 2.0, 4.6))


def power_of_ten(values: Any) -> int:
    """Return the power of ten to take out of an axis, a multiple of three, zero for handy numbers."""
    largest = float(np.max(np.abs(values)))
    if largest == 0.0 or 1e-2 <= largest < 1e4:
        return 0
    return 3 * int(np.floor(np.log10(largest) / 3.0))


def factor(power: int) -> str:
    """Return the power of ten as it stands before an axis's unit."""
    return f"10$^{{{power}}}$ " if power else ""


def magnifications(series: Any) -> list[int]:
    """Return the powers of ten by which columns of (T, n) are enlarged to be seen beside the largest."""
    sizes = np.abs(np.asarray(series)).max(axis=0)
    largest = float(sizes.max())
    return [int(np.floor(np.log10(largest / x))) if largest * TOO_SMALL < x < LOST * largest else 0 for x in sizes]


def magnified(name: str, power: int) -> str:
    """Return the name of a curve with what it is enlarged by."""
    return f"{name} × 10$^{{{power}}}$" if power > 1 else f"{name} × 10" if power else name


def tidy(axes: Any) -> None:
    """Give axes the house's fonts and thin spines, and labels one beneath the other."""
    axes.tick_params(labelsize=FONT - 1, colors=DARK, width=0.6, length=2.5)
    axes.xaxis.label.set_size(FONT)
    axes.yaxis.label.set_size(FONT)
    axes.figure.align_ylabels()
    for spine in axes.spines.values():
        spine.set_linewidth(0.6)
        spine.set_color(GREY)


def save(figure: Figure, path: Path) -> Path:
    """Write the figure in the form its ending names: png, svg or pdf."""
    kind = path.suffix.removeprefix(".")
    with matplotlib.rc_context(SETTINGS):
        figure.savefig(path, dpi=DOTS_PER_INCH, facecolor="white", metadata=METADATA[kind])
    return path


def is_ours(path: Path) -> bool:
    """Whether a file is a figure that `save` wrote, as it says itself."""
    mark = _MARKS.get(path.suffix.removeprefix("."))
    return mark is not None and path.is_file() and mark in path.read_bytes()
