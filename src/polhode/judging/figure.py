"""An engine against the exact motion: error of attitude, change of energy and |L|, and where its spins go."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from polhode._base import check
from polhode.figures import style
from polhode.judging._run import EngineRun
from polhode.types import Array

COLOURS = (style.BLUE, style.ORANGE, style.PURPLE)


def engine_errors(run: EngineRun, name: str = "", runs: Mapping[str, EngineRun] | None = None) -> Figure:
    """Return the error of attitude over the rotation angle, the relative change of E and |L|, and 2E/|L|² of each spin.

    Args:
        run: states of the engine, with the exact motion.
        name: for the title.
        runs: of several starts, for the lowest panel, by their names; that panel is left out if not given.

    Raises:
        InvalidInput: for anything else than an ``EngineRun``.
    """
    check.instance("run", run, EngineRun, "an EngineRun, as a Judgement has it")
    figure = style.new_figure(height=5.2 if runs else 3.7)
    upper, middle, *lower = figure.subplots(3 if runs else 2, 1, sharex=True)
    _plot(upper, run.turned, run.angle, color=style.BLUE, label="error of attitude")
    upper.set_ylabel("angle  [rad]")
    with np.errstate(all="ignore"):
        for values, word, colour in ((run.energy, "energy", style.GREEN), (run.momentum_norm, "|L|", style.ORANGE)):
            change = values / values[0] - 1.0
            # the sign is that before a large change, after which a diverging engine may end anywhere
            large, rounding = 0.1, 1e-12
            out = np.flatnonzero(~(np.abs(change) < large))
            verb = "grows" if change[out[0] - 1 if len(out) and out[0] > 1 else -1] > 0.0 else "falls"
            label = f"{word} {verb}" if len(out) or np.abs(change).max() > rounding else f"{word} stays"
            _plot(middle, run.turned, np.abs(change), color=colour, label=label)
    middle.set_ylabel("change, relative")
    for axes in (upper, middle):
        axes.set_yscale("log")
        axes.set_ylim(top=min(axes.get_ylim()[1], 1e3))
    for axes in lower:
        _plot_ratios(axes, runs or {})
    for axes in (upper, middle, *lower):
        axes.legend(fontsize=style.FONT - 2, frameon=False, loc="lower left", bbox_to_anchor=(-0.02, 1.0), ncols=2,
                    borderaxespad=0.2, columnspacing=1.2, handlelength=2.0)
        style.tidy(axes)
    (lower or [middle])[-1].set_xlabel("rotation angle  [rad]")
    figure.suptitle(name, fontsize=style.FONT)
    return figure


def _plot(axes: Axes, angles: Array, values: Array, **look: str) -> None:
    finite = np.isfinite(values) & (angles > 0.0)
    drawn_zero = 1e-17  # rad or relative, on a logarithmic axis
    axes.plot(angles[finite], np.maximum(values[finite], drawn_zero), lw=0.9, **look)  # type: ignore[arg-type]


def _plot_ratios(axes: Axes, runs: Mapping[str, EngineRun]) -> None:
    for (name, run), colour in zip(runs.items(), COLOURS, strict=False):
        with np.errstate(all="ignore"):
            ratio = 2.0 * run.energy / run.momentum_norm**2
        finite = np.isfinite(ratio)
        axes.plot(run.turned[finite], ratio[finite], color=colour, lw=0.9, label=name.replace("the axis of ", ""))
    moments = np.linalg.eigvalsh(next(iter(runs.values())).inertia)
    for moment in moments:
        axes.axhline(1.0 / moment, color=style.GREY, lw=0.6, ls=":")
    span = 1.0 / moments[0] - 1.0 / moments[2]
    axes.set_ylim(1.0 / moments[2] - 0.08 * span, 1.0 / moments[0] + 0.08 * span)
    axes.set_ylabel("2E/|L|²")
