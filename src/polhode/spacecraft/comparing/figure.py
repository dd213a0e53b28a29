"""Two attitude histories against each other: the angle between them, and how the invariants of each drift."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from matplotlib.figure import Figure

from polhode._base import check
from polhode.figures import style
from polhode.spacecraft.comparing.comparison import Comparison, Invariants
from polhode.types import Array


class CurveLimits(NamedTuple):
    """What a curve and a title of the figure hold."""

    drawn_zero: float = 1e-17  # rad or relative: where zero is drawn, on an axis that has none
    max_points: int = 240  # of a curve; beyond, each is the largest of its bin, as noise would fill the picture
    name_length: int = 60  # characters that fit into the figure's width


LIMITS = CurveLimits()


def comparison(comparison: Comparison) -> Figure:
    """Return the angle over time, and the relative change of energy and momentum of each below, on logarithmic axes.

    Args:
        comparison: as ``polhode.compare`` returns it.

    Raises:
        InvalidInput: for anything else.
    """
    check.instance("comparison", comparison, Comparison, "a Comparison, as polhode.compare(a, b) returns it")
    known = [(side, kept) for side, kept in zip("AB", comparison.invariants, strict=True) if kept is not None]
    figure = style.new_figure(height=4.1 if known else 2.7)
    upper, *rest = np.atleast_1d(figure.subplots(2 if known else 1, 1, sharex=True))
    power = style.power_of_ten((comparison.times[0], comparison.times[-1]))
    unit = 10.0**power
    binned = ", largest of each stretch" if len(comparison.times) > LIMITS.max_points else ""
    if comparison.interpolation_error is not None and comparison.interpolation_error > 0.0:
        upper.axhline(comparison.interpolation_error, color=style.GREY, lw=0.8, ls=":",
                      label="interpolation misses less")
    _plot(upper, comparison.times / unit, comparison.angle, color=style.BLUE, lw=1.1,
          label=f"angle between them{binned}")
    if comparison.alignment is not None and comparison.explained:
        _plot(upper, comparison.times / unit, comparison.alignment.remaining, color=style.VERMILION, lw=0.9, ls="--",
              label="after the best fit")
    upper.set_ylabel("angle  [rad]")
    for axes in rest:
        for side, kept in known:
            _plot_changes(axes, kept, side, unit)
        axes.set_ylabel("change, relative")
    for axes in (upper, *rest):
        _logarithmic(axes)
        axes.legend(fontsize=style.FONT - 2, frameon=False, loc="lower left", bbox_to_anchor=(-0.02, 1.0), ncols=2,
                    borderaxespad=0.2, columnspacing=1.2, handlelength=2.2)
        style.tidy(axes)
    if len(comparison.times) == 1:
        upper.set_xticks([comparison.times[0] / unit])
    _write_title(figure, comparison.names)
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
                  label=f"{names[name]} of {side}")


def _change(kept: Invariants, name: str) -> tuple[Array, float]:
    """Return the deviation of an invariant from its first value, and the size that its drift is relative to."""
    values = kept.values[name]
    change = np.linalg.norm(values - values[:1], axis=-1) if values.ndim == 2 else np.abs(values - values[0])
    return change, float(change.max()) / kept.drift[name] if kept.drift[name] > 0.0 else 1.0


def _plot(axes: Any, times: Array, values: Array, **style_of_line: Any) -> None:
    if len(times) > LIMITS.max_points:
        edges = np.linspace(0, len(times), LIMITS.max_points + 1).astype(int)
        times, values = times[(edges[:-1] + edges[1:] - 1) // 2], np.maximum.reduceat(values, edges[:-1])
    marker = "o" if len(times) == 1 else None
    axes.plot(times, np.maximum(values, LIMITS.drawn_zero), marker=marker, ms=3, **style_of_line)


def _logarithmic(axes: Any) -> None:
    """Make an axis logarithmic; zeros are a decade below the least of the others, at a tick that says 0."""
    values = np.concatenate([np.atleast_1d(line.get_ydata()) for line in axes.get_lines()])
    zero = LIMITS.drawn_zero
    others = values[values > zero]
    high, zeros = float(values.max()), len(others) < len(values)
    axes.set_yscale("log")
    if not zeros:
        axes.set_ylim(0.4 * min(float(values.min()), 0.1 * high), 2.5 * high)
        return
    floor = max(zero, 10.0 ** (int(np.floor(np.log10(others.min()))) - 1)) if len(others) else zero
    for line in axes.get_lines():
        line.set_ydata(np.maximum(line.get_ydata(), floor))
    axes.set_ylim(0.4 * floor, 2.5 * max(high, floor))
    lowest, highest = round(np.log10(floor)), int(np.floor(np.log10(2.5 * max(high, floor))))
    powers = list(range(highest, lowest, -max(1, (highest - lowest + 3) // 4)))
    axes.set_yticks([floor, *(10.0**power for power in powers)], ["0", *(f"10$^{{{power}}}$" for power in powers)])
    axes.minorticks_off()


def _write_title(figure: Figure, names: tuple[str, str]) -> None:
    lines = [f"{side}: {name if len(name) <= LIMITS.name_length else name[: LIMITS.name_length - 1] + '…'}"
             for side, name in zip("AB", names, strict=True)]
    figure.suptitle("\n".join(lines), fontsize=style.FONT - 1, x=0.02, ha="left", color=style.DARK, parse_math=False)
