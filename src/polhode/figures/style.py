"""One look for every figure: column width, colours safe for the colour-blind, no global state."""

from __future__ import annotations

import json
from collections.abc import Sequence
from importlib import resources
from io import BytesIO
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.ticker import ScalarFormatter

from polhode.errors import InvalidInput, shown
from polhode.formats.figure_file import DOTS_PER_INCH
from polhode.formats.figure_file import save_figure as save  # noqa: F401  (polhode.figures.save)

COLUMN = 3.6  # inches, a journal's column
COLOURS: dict[str, Any] = json.loads((resources.files("polhode.figures") / "colours.json").read_text("utf-8"))
BLUE, ORANGE, GREEN, VERMILION, SKY, PURPLE = COLOURS["palette"]  # Okabe & Ito's
ROLES: dict[str, Any] = COLOURS["light"]  # colours by their roles, which pages take from this table too
AXIS_COLOURS = tuple(ROLES["axes"])
MOTION, SEPARATRIX, STABLE, UNDECIDED = (ROLES[name] for name in ("motion", "border", "stable", "undecided"))
MOMENTUM, VELOCITY, WEIGHT, ROTOR = (ROLES[name] for name in ("momentum", "velocity", "weight", "rotor"))
HERPOLHODE, BODY_CONE = ROLES["herpolhode"], ROLES["bodyCone"]
ENSEMBLE, CLASSICAL = ROLES["ensemble"], ROLES["classical"]
GREY, LIGHT, DARK = "#6f6f6f", "#c8c8c8", "#222222"
FONT = 8


class Picture(Figure):
    """A figure that notebooks show whether or not pyplot was imported."""

    def _repr_png_(self) -> bytes:
        drawn = BytesIO()
        self.savefig(drawn, format="png", dpi=DOTS_PER_INCH, facecolor="white")
        return drawn.getvalue()


def new_figure(width: float = COLUMN, height: float = COLUMN) -> Figure:
    """Return an empty figure with its own canvas."""
    figure = Picture(figsize=(width, height), dpi=DOTS_PER_INCH, layout="constrained")
    FigureCanvasAgg(figure)
    return figure


def axes_for(axes: Any, rows: int = 1, height: float = COLUMN) -> tuple[Any, list[Any]]:
    """Return figure and axes to draw on: the axes given, or as many one above the other in a figure of its own.

    Args:
        axes: of matplotlib; one, or a sequence of as many as the figure has rows. None for a new figure.
        rows: how many the figure needs.
        height: of a new figure [inches].

    Raises:
        InvalidInput: for anything else, axes in space or of angles, or another number of axes.
    """
    if axes is None:
        figure = new_figure(height=height)
        return figure, list(np.atleast_1d(figure.subplots(rows, 1, sharex=True)))
    panels = [axes] if isinstance(axes, Axes) else list(axes) if isinstance(axes, list | tuple | np.ndarray) else []
    if len(panels) != rows or not all(isinstance(each, Axes) for each in panels):
        wanted = "one matplotlib Axes" if rows == 1 else f"a sequence of {rows} matplotlib Axes"
        raise InvalidInput(f"`axes` must be {wanted}; got {shown(axes)}. Leave it out for a new figure.")
    if strange := [each.name for each in panels if each.name != "rectilinear"]:
        raise InvalidInput(f"`axes` must be flat ones, with x and y; got {strange[0]} axes. Make them without that.")
    return panels[0].figure.figure, panels  # of a part of a figure, the whole


def label_time(panels: Sequence[Any], words: str) -> None:
    """Label the time axis below the last panel, and below those that do not share it."""
    for panel in panels[:-1]:
        if not panel.get_shared_x_axes().joined(panel, panels[-1]):
            panel.set_xlabel(words)
    panels[-1].set_xlabel(words)


def legend_above(axes: Any, user_axes: Any, handles: Any, labels: Any) -> None:
    """Draw a legend above the uppermost axes: outside of them in a figure of its own, at their edge on given ones."""
    settings: Any = {"ncols": 3, "fontsize": FONT - 1, "frameon": False, "handlelength": 2.2}
    if user_axes is None:
        axes.figure.legend(handles, labels, loc="outside upper center", **settings)
    else:
        axes.legend(handles, labels, loc="lower center", bbox_to_anchor=(0.5, 1.0), borderaxespad=0.2, **settings)


def choose_height(window: tuple[float, float, float, float], around: float = 0.6) -> float:
    """Return the height [inches] of a column-wide picture of this window, with room for title and legend."""
    left, right, bottom, top = window
    return float(np.clip(COLUMN * (top - bottom) / (right - left) + around, 2.0, 4.6))


def power_of_ten(values: Any) -> int:
    """Return the power of ten to take out of an axis, a multiple of three, zero for handy numbers."""
    largest = float(np.max(np.abs(values)))
    if largest == 0.0 or 1e-2 <= largest < 1e4:
        return 0
    return 3 * int(np.floor(np.log10(largest) / 3.0))


def factor(power: int) -> str:
    """Return the power of ten in the form that precedes an axis's unit."""
    return f"10$^{{{power}}}$ " if power else ""


def magnifications(series: Any, lost: float = 0.03) -> list[int]:
    """Return the powers of ten by which columns of (T, n), smaller than ``lost`` of the largest, are enlarged."""
    rounding = 1e-12  # of the largest: smaller curves are rounding
    sizes = np.abs(np.asarray(series)).max(axis=0)
    largest = float(sizes.max())
    return [int(np.floor(np.log10(largest / x))) if largest * rounding < x < lost * largest else 0 for x in sizes]


def magnify(name: str, power: int) -> str:
    """Return the name of a curve with its factor of enlargement."""
    return f"{name} × 10$^{{{power}}}$" if power > 1 else f"{name} × 10" if power else name


def tidy(axes: Any) -> None:
    """Give axes the house's fonts and thin spines, and labels one beneath the other."""
    axes.tick_params(labelsize=FONT - 1, colors=DARK, width=0.6, length=2.5)
    axes.xaxis.label.set_size(FONT)
    axes.yaxis.label.set_size(FONT)
    axes.figure.align_ylabels()
    for axis in (axes.xaxis, axes.yaxis):
        if isinstance(axis.get_major_formatter(), ScalarFormatter):
            axis.get_major_formatter().set_useOffset(False)
    for spine in axes.spines.values():
        spine.set_linewidth(0.6)
        spine.set_color(GREY)


def show_constant(axes: Any, values: Any, around: float) -> None:
    """Give a curve that is constant but for rounding a range, so that rounding does not fill the axes."""
    constant = 1e-9  # of a curve's size: what varies by less is constant, by rounding and its growth
    low, high = float(np.min(values)), float(np.max(values))
    if high - low <= constant * max(abs(low), abs(high)):
        axes.set_ylim(low - around, high + around)
