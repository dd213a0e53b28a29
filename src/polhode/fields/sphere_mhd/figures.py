"""The figures of a conducting fluid on a sphere."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure

from polhode.fields.sphere.maps import COLATITUDES, LONGITUDES, SphereMap, both_sides, mollweide_maps
from polhode.fields.sphere_mhd.answers import MagneticReport
from polhode.figures import style


def draw_maps(report: MagneticReport) -> Figure:
    """Return equal-area maps of vorticity and current at start, middle and end, with the lines of the field."""
    count, system = len(report.trajectory.times), report.system
    chosen = sorted({0, count // 2, count - 1})
    maps = []
    for k in chosen:
        state = report.trajectory.states[k]
        potential, vorticity = np.asarray(system.on_grid(state, COLATITUDES, LONGITUDES))
        current = np.asarray(system.fluid.on_grid(system.current(state) + system.fluid.planetary,
                                                  COLATITUDES, LONGITUDES))
        when = f"after {float(report.trajectory.times[k]):.4g} s"
        maps += [SphereMap(f"vorticity {when}", vorticity, potential), SphereMap(f"current {when}", current, potential)]
    return mollweide_maps(maps, "vorticity and current  [rad/s], with lines of the field", columns=2)


def draw_globe(report: MagneticReport) -> Figure:
    """Return the relative vorticity at the end from two opposite sides, in orthographic projection."""
    return both_sides(report.system.on_grid(report.trajectory.states[-1], COLATITUDES, LONGITUDES)[1], "at the end")


def draw_energies(report: MagneticReport) -> Figure:
    """Return kinetic and magnetic energy against time."""
    figure = style.new_figure(height=0.8 * style.COLUMN)
    axes = figure.subplots()
    totals = report.energies.sum(axis=-1)
    for values, name, color in ((totals[:, 0], "kinetic", style.BLUE), (totals[:, 1], "magnetic", style.VERMILION),
                                (totals.sum(axis=-1), "both", style.GREY)):
        axes.plot(report.trajectory.times, values, color=color, lw=1.1, label=name)
    axes.set_ylim(0.0, 1.15 * float(totals.sum(axis=-1).max()))
    axes.set_xlabel("time  [s]")
    axes.set_ylabel("energy  [rad²/s²]")
    axes.legend(fontsize=style.FONT - 1, frameon=False, ncols=3)
    style.tidy(axes)
    return figure


def draw_spectrum(report: MagneticReport) -> Figure:
    """Return kinetic and magnetic energies by degree, at start and end."""
    figure = style.new_figure(height=style.COLUMN)
    axes = figure.subplots()
    degree, largest = np.arange(1, report.system.size), float(report.energies[[0, -1]].max())
    smallest = 1e-8  # of the largest energy, below which nothing is drawn
    for k, (name, color) in enumerate((("kinetic", style.BLUE), ("magnetic", style.VERMILION))):
        for when, line, label in ((0, "o:", "start"), (-1, "o-", "end")):
            values = report.energies[when, k, 1:]
            axes.loglog(degree, np.where(values > smallest * largest, values, np.nan), line, color=color, ms=2.5,
                        lw=0.9, label=f"{name}, {label}")
    axes.set_xlabel("degree")
    axes.set_ylabel("energy  [rad²/s²]")
    axes.legend(fontsize=style.FONT - 1, frameon=False)
    style.tidy(axes)
    return figure


FIGURES = {"maps": draw_maps, "globe": draw_globe, "energies": draw_energies, "spectrum": draw_spectrum}
