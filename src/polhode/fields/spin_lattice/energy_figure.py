"""Energy and magnetisation of spins over time."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure

from polhode.fields.spin_lattice.answers import MILLI, SpinLatticeReport
from polhode.figures import style


def draw_energy(report: SpinLatticeReport) -> Figure:
    """Return energy per spin, and the components of the magnetisation, over time."""
    figure = style.new_figure(height=1.2 * style.COLUMN)
    upper, lower = figure.subplots(2, 1, sharex=True)
    pico = 1e-12
    times = np.asarray(report.trajectory.times) / pico
    upper.plot(times, report.energies / MILLI, color=style.BLUE, lw=0.9)
    if report.thermal is not None:
        upper.axhline(report.thermal[0] / MILLI, color=style.GREY, lw=0.8, ls="--", label="mean of the later half")
        upper.legend(fontsize=style.FONT - 1, frameon=False)
    steady = 1e-5  # of the energy: a smaller change is drawn as none
    if float(np.ptp(report.energies)) <= steady * float(np.abs(report.energies).max()):
        middle = float(report.energies.mean()) / MILLI
        upper.set_ylim(middle - 0.05 * abs(middle or 1.0), middle + 0.05 * abs(middle or 1.0))
    upper.set_ylabel("energy per spin  [meV]")
    for k, (name, color) in enumerate(zip("xyz", style.AXIS_COLOURS, strict=True)):
        lower.plot(times, report.magnetizations[:, k], color=color, lw=0.9, label=name)
    lower.set(ylim=(-1.05, 1.05))
    lower.set_ylabel("magnetisation")
    lower.set_xlabel("time  [ps]")
    lower.legend(fontsize=style.FONT - 1, frameon=False, ncols=3)
    for axes in (upper, lower):
        style.tidy(axes)
    return figure
