"""Two attitude histories against each other: the angle between them, and what each loses of its invariants."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.figure import Figure

from polhode.analysis.comparison import Comparison, Invariants
from polhode.figures import style

Array = Any
LEAST = 1e-17  # rad or relative: where zero is drawn, on an axis that has none
STRETCHES = 240  # a curve of more samples is the largest of each stretch: noise would fill the picture


def draw_comparison(found: Comparison) -> Figure:
    """Return the angle over time, and the relative change of energy and momentum of each below, on logarithmic axes."""
    known = [(side, kept) for side, kept in zip("AB", found.invariants, strict=True) if kept is not None]
    figure = style.new_figure(height=3.8 if known else 2.4)
    upper, *rest = np.atleast_1d(figure.subplots(2 if known else 1, 1, sharex=True))
    power = style.power_of_ten((found.times[0], found.times[-1]))
    unit = 10.0**power
    if found.interpolation_error is not None and found.interpolation_error > 0.0:
        upper.axhline(found.interpolation_error, color=style.GREY, lw=0.8, ls=":", label="interpolation misses less")
    _plot(upper, found.times / unit, found.angle, color=style.BLUE, lw=1.1, label="angle between them")
    if found.alignment is not None and found.explained:
        _plot(upper, found.times / unit, found.alignment.remaining, color=style.VERMILION, lw=0.9, ls="--",
              label="after the best fit")  # fmt: skip
    upper.set_ylabel("angle  [rad]")
    for axes in rest:
        for side, kept in known:
            _plot_changes(axes, kept, side, unit)
        axes.set_ylabel("change, relative")
    for axes in (upper, *rest):
        _logarithmic(axes)
        axes.legend(fontsize=style.FONT - 2, frameon=False, loc="lower left", bbox_to_anchor=(-0.02, 1.0), ncols=2,
                    borderaxespad=0.2, columnspacing=1.2, handlelength=2.2)  # fmt: skip
        style.tidy(axes)
    (rest or [upper])[-1].set_xlabel(f"time of A  [{style.factor(power)}s]")
    return figure


def _plot_changes(axes: Any, kept: Invariants, side: str, unit: float) -> None:
    """Draw how energy and momentum of one history leave their first values."""
    of_side = {"A": (style.GREEN, "-"), "B": (style.ORANGE, "--")}[side]
    names = {"energy": "energy", "momentum_space": "L", "vertical_momentum": "L upwards"}
    for name, width in (("energy", 1.1), ("momentum_space", 0.6), ("vertical_momentum", 0.6)):
        if name in kept.values:
            change, size = _change(kept, name)
            _plot(axes, kept.times / unit, change / size, color=of_side[0], ls=of_side[1], lw=width,
                  label=f"{names[name]} of {side}")  # fmt: skip


def _change(kept: Invariants, name: str) -> tuple[Array, float]:
    """Return how far an invariant is from its first value, and the size that its drift is relative to."""
    values = kept.values[name]
    change = np.linalg.norm(values - values[:1], axis=-1) if values.ndim == 2 else np.abs(values - values[0])
    return change, float(change.max()) / kept.drift[name] if kept.drift[name] > 0.0 else 1.0


def _plot(axes: Any, times: Array, values: Array, **style_of_line: Any) -> None:
    if len(times) > STRETCHES:
        edges = np.linspace(0, len(times), STRETCHES + 1).astype(int)
        times, values = times[(edges[:-1] + edges[1:] - 1) // 2], np.maximum.reduceat(values, edges[:-1])
    axes.plot(times, np.maximum(values, LEAST), marker="o" if len(times) == 1 else None, ms=3, **style_of_line)


def _logarithmic(axes: Any) -> None:
    values = np.concatenate([np.atleast_1d(line.get_ydata()) for line in axes.get_lines()])
    low, high = float(values.min()), float(values.max())
    axes.set_yscale("log")
    axes.set_ylim(0.4 * min(low, 0.1 * high), 2.5 * max(high, 10.0 * LEAST))
    if low <= LEAST:
        axes.axhline(LEAST, color=style.LIGHT, lw=0.6, zorder=0)
        axes.annotate("0", (1.0, LEAST), xycoords=("axes fraction", "data"), xytext=(3, -2), textcoords="offset points",
                      fontsize=style.FONT - 1, color=style.DARK)  # fmt: skip
