"""Curves of a fluid on a sphere: energy by degree with its flux, and the mean flow by latitude."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure

from polhode.fields.sphere_fluid.answers import FluidReport
from polhode.figures import style


def draw_spectrum(report: FluidReport) -> Figure:
    """Return energies by degree at start and end, and the flux of energy beyond each degree at the end."""
    figure = style.new_figure(height=1.35 * style.COLUMN)
    upper, lower = figure.subplots(2, 1, sharex=True, height_ratios=(3, 2))
    degree = np.arange(1, report.system.size)
    for k, (name, color) in enumerate((("start", style.GREY), ("end", style.BLUE))):
        upper.loglog(degree, np.where(report.energies[k, 1:] > 0.0, report.energies[k, 1:], np.nan), "o-", color=color,
                     ms=2.5, lw=0.9, label=name)
    largest = float(report.energies.max())
    smallest = 1e-8  # of the largest energy, below which nothing is drawn
    least = max(float(report.energies[1, 1:].min()), smallest * largest)
    upper.set(ylim=(0.3 * least, 3.0 * largest))
    upper.set_ylabel("energy  [rad²/s²]")
    upper.legend(fontsize=style.FONT - 1, frameon=False)
    flux = -np.cumsum(np.asarray(report.system.energy_transfer(report.trajectory.states[-1])))[1:]
    lower.axhline(0.0, color=style.LIGHT, lw=0.8)
    lower.plot(degree, flux, "o-", color=style.VERMILION, ms=2.5, lw=0.9)
    lower.set_ylabel("flux beyond  [rad²/s³]")
    lower.set_xlabel("degree")
    for axes in (upper, lower):
        style.tidy(axes)
    return figure


def draw_zonal(report: FluidReport) -> Figure:
    """Return the eastward velocity, averaged over longitude, by latitude at start and end."""
    figure = style.new_figure(height=style.COLUMN)
    axes = figure.subplots()
    latitudes = 181
    theta = np.linspace(0.0, np.pi, latitudes)
    states = np.asarray(report.trajectory.states)[[0, -1]]
    flows = report.table.radius * np.asarray(report.system.zonal_velocity(states, theta))
    for flow, name, color in zip(flows, ("start", "end"), (style.GREY, style.BLUE), strict=True):
        axes.plot(flow, 90.0 - np.degrees(theta), color=color, lw=1.2, label=name)
    axes.axvline(0.0, color=style.LIGHT, lw=0.8, zorder=0)
    axes.set(ylim=(-90, 90), yticks=(-90, -60, -30, 0, 30, 60, 90))
    axes.set_xlabel("mean eastward velocity  [m/s]")
    axes.set_ylabel("latitude  [°]")
    axes.legend(fontsize=style.FONT - 1, frameon=False)
    style.tidy(axes)
    return figure
