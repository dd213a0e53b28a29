"""A quantum body that turns over about its middle axis, beside the classical ones."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from matplotlib.figure import Figure

from polhode.figures import style
from polhode.spectra.racket import Racket


def racket_flip(racket: Racket, *, axes: Any = None) -> Figure:
    """Return ⟨L_b⟩ of the quantum body against time, with the classical body and the classical ensemble.

    A body beside the middle axis has a second panel, as far as the revival, where T_rev marks it and its half.

    Args:
        racket: any.
        axes: matplotlib axes to draw on, two for a racket beside its middle axis; a new figure without them.

    >>> from polhode.spectra import Racket
    >>> len(racket_flip(Racket((27.0, 14.0, 9.0), 5)).axes)
    1
    """
    revival = racket.revival_time
    if axes is None:
        figure = style.new_figure(4.8, 2.8 if revival is None else 4.6)
        panels = list(np.atleast_1d(figure.subplots(1 if revival is None else 2, 1)))
    else:
        figure, panels = style.axes_for(axes, rows=1 if revival is None else 2)
    # quantum and ensemble part at a quarter of this time, which ends the first panel of a body on its axis
    growth = (4.0 * (1.5 * math.log(racket.J) + 3.0)) / racket.rate
    periods = 6.0  # of the first panel
    times = np.linspace(0.0, growth if revival is None else periods * racket.period, 500)
    power = style.power_of_ten(times)
    shown = times / 10.0**power
    panels[0].plot(shown, racket.ensemble(times), color=style.ENSEMBLE, lw=1.1, label="classical ensemble")
    panels[0].plot(shown, racket.classical(times), color=style.CLASSICAL, lw=0.8, ls="--", label="classical body")
    panels[0].plot(shown, racket.quantum(times), color=style.BLUE, lw=1.1, label="quantum")
    _tidy_panel(panels[0], power, shown[-1])
    if revival is not None:
        _draw_long(panels[1], racket, revival)
    style.legend_above(panels[0], axes, *panels[0].get_legend_handles_labels())
    return figure


def _draw_long(panel: Any, racket: Racket, revival: float) -> None:
    points, most_points, per_period, until = 500, 6000, 12, 1.12  # `until` in times of revival
    count = min(most_points, max(points, math.ceil(per_period * until * revival / racket.period)))
    times = np.linspace(0.0, until * revival, count)
    power = style.power_of_ten(times)
    shown = times / 10.0**power
    every = max(1, count // points)
    panel.plot(shown[::every], racket.ensemble(times[::every]), color=style.ENSEMBLE, lw=0.9, zorder=3)
    panel.plot(shown, racket.quantum(times), color=style.BLUE, lw=0.5)
    for share, name in ((0.5, "½ $T_{rev}$"), (1.0, "$T_{rev}$")):
        panel.axvline(share * revival / 10.0**power, color=style.VERMILION, lw=0.7, ls=":")
        panel.text(share * revival / 10.0**power, 1.06, name, fontsize=style.FONT - 2, ha="center", va="bottom",
                   color=style.VERMILION)
    _tidy_panel(panel, power, shown[-1])


def _tidy_panel(panel: Any, power: int, end: float) -> None:
    panel.set_xlim(0.0, end)
    panel.set_ylim(-1.05, 1.05)
    panel.set_xlabel(f"time  [{style.factor(power)}s]")
    panel.set_ylabel("$L_b$ / J")
    style.tidy(panel)
