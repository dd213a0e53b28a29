"""Polar motion: the pole's spiral, the wobble's amplitude and phase over time, the spectrum of both senses."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.collections import LineCollection
from matplotlib.figure import Figure

from polhode.celestial.wobble.estimation import ChandlerFit
from polhode.celestial.wobble.process import ChandlerProcess
from polhode.celestial.wobble.series_files import PoleSeries
from polhode.celestial.wobble.units import DAY, MAS, YEAR
from polhode.celestial.wobble.windows import ChandlerWindows, PoleSpectrum
from polhode.figures import style


def _years(seconds: Any) -> Any:
    first = 1858.8761  # year of the modified Julian date 0
    return first + np.asarray(seconds) / YEAR


def spiral(series: PoleSeries, line: ChandlerFit) -> Figure:
    """Return the pole's path from above the North Pole: 90° West, y, to the left, Greenwich, x, up."""
    every = 5  # days from point to point
    x, y = series.x[::every] / MAS, series.y[::every] / MAS
    years = _years(series.days[::every] * DAY)
    figure = style.new_figure(width=style.COLUMN * 1.1)
    axes = figure.add_subplot()
    points = np.stack([y, x], axis=1)
    lines = LineCollection(list(np.stack([points[:-1], points[1:]], axis=1)), array=years[:-1], cmap="viridis", lw=0.5)
    axes.add_collection(lines)
    mean = complex(*line.terms.value[-4:-2])
    drift = complex(*line.terms.value[-2:])
    ends = mean + drift * (np.array([series.days[0], series.days[-1]]) * DAY - line.epoch)
    axes.plot(-ends.imag / MAS, ends.real / MAS, color=style.VERMILION, lw=1.4, label="fitted drift")
    axes.plot(-ends.imag[1:] / MAS, ends.real[1:] / MAS, "o", color=style.VERMILION, ms=3)
    axes.set_aspect("equal")
    axes.autoscale()
    axes.invert_xaxis()
    axes.set_xlabel("y, towards 90° West  [mas]")
    axes.set_ylabel("x, towards Greenwich  [mas]")
    axes.legend(loc="best", fontsize=style.FONT - 1, frameon=False)
    bar = figure.colorbar(lines, ax=axes, shrink=0.8)
    bar.set_label("year", fontsize=style.FONT)
    bar.ax.tick_params(labelsize=style.FONT - 1)
    style.tidy(axes)
    return figure


def over_time(windows: ChandlerWindows, process: ChandlerProcess, line: ChandlerFit) -> Figure:
    """Return amplitude and phase of the wobble over time."""
    figure = style.new_figure(width=style.COLUMN * 1.3)
    above, below = figure.subplots(2, 1, sharex=True, height_ratios=(3, 2))
    years = _years(windows.centres)
    steady = process.wobble * np.exp(-1j * windows.rate * (process.times - windows.epoch))
    smooth = np.unwrap(np.angle(steady))
    apart = np.interp(process.times, windows.centres, windows.phase) - smooth
    smooth += 2.0 * np.pi * np.round(np.median(apart) / (2.0 * np.pi))
    for axes, value, error, other, spread, unit in (
        (above, windows.amplitude, windows.amplitude_error, np.abs(steady), process.wobble_error, MAS),
        (below, windows.phase, windows.phase_error, smooth, process.wobble_error / np.abs(steady), np.pi / 180.0),
    ):
        axes.fill_between(years, (value - error) / unit, (value + error) / unit, color=style.BLUE, alpha=0.25, lw=0)
        axes.plot(years, value / unit, color=style.BLUE, lw=1.2, label=f"windows of {windows.window / YEAR:.3g} years")
        axes.errorbar(_years(process.times), other / unit, spread / unit, fmt=".", ms=2.5, lw=0.6, color=style.ORANGE,
                      label="Gauss–Markov process")
        style.tidy(axes)
    period, amplitude = line.estimate.value[:2]
    above.axhline(amplitude / MAS, color=style.GREY, lw=0.8, ls="--", label="one line")
    above.set_ylim(0.0, None)
    above.set_ylabel("amplitude  [mas]")
    below.set_ylabel("phase  [°]")
    low, high = np.degrees([windows.phase.min(), windows.phase.max()])
    below.set_ylim(low - 40.0, high + 60.0)
    below.set_xlabel(f"year; the phase is against a period of {period / DAY:.1f} d")
    style.legend_above(above, None, *above.get_legend_handles_labels())
    return figure


def spectrum(pole_spectrum: PoleSpectrum, line: ChandlerFit) -> Figure:
    """Return the spectrum of both senses of turning."""
    highest = 2.3  # cycles a year
    frequencies = pole_spectrum.frequencies * YEAR
    density = pole_spectrum.density / MAS**2 / YEAR
    figure = style.new_figure(width=style.COLUMN * 1.3, height=2.8)
    axes = figure.add_subplot()
    for sign, colour, name in ((1.0, style.BLUE, "prograde"), (-1.0, style.ORANGE, "retrograde")):
        side = (sign * frequencies > 0.0) & (np.abs(frequencies) <= highest)
        order = np.argsort(np.abs(frequencies[side]))
        axes.semilogy(np.abs(frequencies[side])[order], density[side][order], color=colour, lw=0.9, label=name)
    top = float(density[np.abs(frequencies) <= highest].max())
    chandler = YEAR / float(line.estimate.value[0])
    for place, name, to in ((chandler, "Chandler", "right"), (1.0, "annual", "left"), (2.0, "semiannual", "right")):
        axes.axvline(place, color=style.LIGHT, lw=0.8, zorder=0)
        axes.text(place + (0.02 if to == "left" else -0.02), 2.0 * top, name, fontsize=style.FONT - 1, ha=to,
                  color=style.GREY)
    axes.set_xlim(0.0, highest)
    axes.set_ylim(None, 6.0 * top)
    axes.set_xlabel("frequency  [cycles a year]")
    axes.set_ylabel("density  [mas² per cycle a year]")
    style.tidy(axes)
    style.legend_above(axes, None, *axes.get_legend_handles_labels())
    return figure
