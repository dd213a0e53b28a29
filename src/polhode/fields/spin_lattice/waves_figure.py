"""The structure factor of the spins, with the frequencies of linear spin waves."""

from __future__ import annotations

import math

import numpy as np
from matplotlib.figure import Figure
from scipy.constants import hbar

from polhode.fields.spin_lattice.answers import MILLI, SpinLatticeReport
from polhode.fields.spin_lattice.build import wave_path
from polhode.fields.spin_lattice.correlations import structure_factor
from polhode.figures import style


def draw_waves(report: SpinLatticeReport) -> Figure | None:
    """Return S(q, ω) along the first reciprocal vector with the linear waves; None where neither can be computed."""
    waves, times = report.waves, np.asarray(report.trajectory.times)
    margin = 1.3  # of the highest wave, up to which frequencies are shown
    top = margin * float(waves.max()) if waves is not None else math.inf
    resolved = np.ptp(times) * min(top, math.pi * (len(times) - 1) / np.ptp(times)) / (2.0 * math.pi)
    fewest = 12  # frequencies, with fewer a spectrum shows nothing
    spectral = resolved >= fewest and not report.system.is_damped
    if waves is None and not spectral:
        return None
    figure = style.new_figure(height=style.COLUMN)
    axes = figure.subplots()
    unit = hbar / MILLI
    decades = 5.0  # of the spectrum
    still = 3  # lowest frequencies, into which the static part is blurred
    if spectral:
        count = report.system.lattice.shape[0]
        q, shares = wave_path(report.system, count + 1 if count % 2 == 0 else count)
        omega, power = structure_factor(report.system.lattice, times, report.trajectory.states, q)
        rows = (omega >= 0.0) & (omega <= top)
        log = np.log10(power[:, rows].T + 1e-300)
        brightest = float(log[still:].max())  # the mean spin, which does not move, outshines the waves
        axes.pcolormesh(shares, unit * omega[rows], log, vmin=brightest - decades, vmax=brightest, cmap="viridis",
                        shading="nearest", rasterized=True)
    if waves is not None:
        _, shares = wave_path(report.system)
        for k, mode in enumerate(np.asarray(waves).T):
            axes.plot(shares, unit * mode, "--", color="white" if spectral else style.BLUE, lw=0.9,
                      label="linear spin waves" if k == 0 else None)
        axes.legend(fontsize=style.FONT - 1, labelcolor="white" if spectral else style.DARK, frameon=False)
    axes.set_xlabel("wave vector, of the first reciprocal one")
    axes.set_ylabel("energy  [meV]")
    axes.set_ylim(bottom=0.0)
    style.tidy(axes)
    return figure
