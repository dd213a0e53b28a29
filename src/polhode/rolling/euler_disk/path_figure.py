"""The paths of a rolling disk's contact and centre, from above."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.cm import ScalarMappable
from matplotlib.collections import LineCollection
from matplotlib.colors import ListedColormap, Normalize
from matplotlib.figure import Figure

from polhode.figures import style
from polhode.rolling.euler_disk.report import EulerDiskReport
from polhode.types import Array


def draw_contact_path(report: EulerDiskReport) -> Figure:
    """Return the path over the last turns of a motion that ends, or the first of one that does not."""
    magnified = 8.0  # a centre whose path is smaller than the contact's by more than this is drawn again by itself
    still = 1e-9  # radii, below which a centre is at rest but for rounding
    path = report.path
    states, times = np.asarray(path.states), np.asarray(path.times)
    contact, center = path.contact, _centers(report, states)
    ends = path.outcome.event is not None
    slow = style.power_of_ten((times[0], times[-1]))
    heading = path.part("heading")
    turns = np.abs(heading - heading[0]) / (2.0 * np.pi)
    clock = turns[-1] - turns if ends else times / 10.0**slow
    shade = (clock - clock[0]) / ((clock[-1] - clock[0]) or 1.0)
    closer = 0.0 < magnified * float(np.ptp(center, axis=0).max()) < float(np.ptp(contact, axis=0).max())
    closer = closer and float(np.ptp(center, axis=0).max()) > still * report.table.radius
    figure = style.new_figure(height=5.2 if closer else 3.9)
    panels = figure.subplots(2, 1, height_ratios=(2.3, 1.0)) if closer else [figure.subplots()]
    if report.opening is not None:
        first = 1e3 * report.opening.contact
        panels[0].plot(*first.T, color=style.GREY, lw=0.9, ls="--", label="contact, first turn")
    for line, colour, words, order in ((contact, style.BLUE, "contact", 2), (center, style.VERMILION, "centre", 3)):
        _draw_fading(panels[0], 1e3 * line, shade, colour, order)
        what = f"{words}, last turns" if ends else words
        panels[0].plot([], [], color=colour, lw=1.1, marker="o", ms=3.5, label=what)
    if closer:
        _draw_fading(panels[1], 1e6 * (center - center[-1]), shade, style.VERMILION, 3)
        panels[1].set_xlabel("centre, from where it ends  [µm]")
        panels[1].set_ylabel("[µm]")
    panels[0].set_xlabel("X  [mm]")
    panels[0].set_ylabel("Y  [mm]")
    for axes in panels:
        axes.set_aspect("equal", adjustable="datalim")
        axes.margins(0.08)
        axes.locator_params(nbins=5)
        style.tidy(axes)
    words = f"turns before it is {path.outcome.event}" if ends else f"time  [{style.factor(slow)}s]"
    _bar(panels[-1], style.VERMILION if closer else style.DARK, clock, words, ends)
    figure.legend(*panels[0].get_legend_handles_labels(), loc="outside upper center", ncols=2, fontsize=style.FONT - 1,
                  frameon=False, handlelength=2.2)
    return figure


def _centers(report: EulerDiskReport, states: Array) -> Array:
    """Return where the centre is above the plane (T, 2) [m]."""
    return np.asarray(report.disk.center(states))[:, :2]


def _bar(axes: Any, colour: str, clock: Array, words: str, ends: bool) -> None:
    """Explain next to a panel what the strength of its colour means; in grey where it holds for several panels."""
    norm = Normalize(float(clock.min()), float(clock.max()))
    faded = ScalarMappable(norm, _fade(colour, reverse=ends))
    bar = axes.figure.colorbar(faded, ax=axes, fraction=0.05, pad=0.02)
    bar.set_label(words, size=style.FONT)
    bar.ax.tick_params(labelsize=style.FONT - 1, width=0.6, length=2.5)
    bar.outline.set_linewidth(0.6)
    if ends:
        bar.ax.invert_yaxis()


def _draw_fading(axes: Any, line: Array, shade: Array, colour: str, order: int) -> None:
    """Draw a line (T, 2) that grows from pale to full colour, and where it ends."""
    pieces: Any = np.stack([line[:-1], line[1:]], axis=1)
    drawn = LineCollection(pieces, colors=_fade(colour)(shade[1:]), linewidths=1.1, zorder=order, capstyle="round")
    axes.add_collection(drawn)
    axes.plot(*line[-1], "o", ms=4.5, color=colour, mec="white", mew=0.6, zorder=5)
    axes.update_datalim(line)
    axes.autoscale_view()


def _fade(colour: str, reverse: bool = False) -> ListedColormap:
    """Return a map from pale to full."""
    palest = 0.12  # share of a colour that is left at the first time
    full = np.array([int(colour[k : k + 2], 16) / 255.0 for k in (1, 3, 5)])
    strength = np.linspace(palest, 1.0, 256)[:, None]
    table = 1.0 - strength * (1.0 - full)
    return ListedColormap(table[::-1] if reverse else table)
