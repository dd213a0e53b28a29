"""The spins at the end, viewed along z."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.figure import Figure

from polhode.fields.spin_lattice.answers import SpinLatticeReport
from polhode.figures import style
from polhode.types import Array


def draw_spins(report: SpinLatticeReport) -> Figure:
    """Return arrows of the spins in the plane of x and y, coloured by z; of a body the first layer."""
    lattice = report.system.lattice
    places, spins = _layer(report)
    chain = 0.35  # height of a chain's picture, of a column
    high = max(chain, min(1.3, float(np.ptp(places[:, 1]) / (np.ptp(places[:, 0]) or 1.0))))
    figure = style.new_figure(width=1.4 * style.COLUMN, height=high * 1.4 * style.COLUMN)
    axes: Any = figure.subplots()
    step = _apart(places)
    drawn = axes.scatter(places[:, 0], places[:, 1], c=spins[:, 2], cmap="RdBu_r", vmin=-1.0, vmax=1.0, marker="s",
                         s=_size(step, places, high), linewidths=0, alpha=0.75)
    most_arrows = 2500
    if len(places) <= most_arrows:
        axes.quiver(places[:, 0], places[:, 1], spins[:, 0], spins[:, 1], pivot="mid", units="xy", scale=1.1 / step,
                    width=0.08 * step, color=style.DARK)
    bar = figure.colorbar(drawn, ax=axes, shrink=0.8, aspect=30)
    bar.set_label("S$_z$/S", fontsize=style.FONT)
    bar.ax.tick_params(labelsize=style.FONT - 1)
    axes.set_aspect("equal")
    axes.set(xlim=(places[:, 0].min() - step, places[:, 0].max() + step),
             ylim=(places[:, 1].min() - step, places[:, 1].max() + step))
    layer = ", first layer" if lattice.dimension == 3 and lattice.shape[2] > 1 else ""
    axes.set_title(f"after {float(report.trajectory.times[-1]) * 1e12:.4g} ps{layer}", fontsize=style.FONT)
    axes.axis("off")
    return figure


def _layer(report: SpinLatticeReport) -> tuple[Array, Array]:
    """Return places (n, 2) and spins (n, 3) over their lengths of the first layer along the third vector."""
    spins = np.asarray(report.trajectory.states)[-1][:, :, :1] / np.asarray(report.system.spin)[:, None]
    places = np.asarray(report.system.lattice.positions())[:, :, :1, :, :2]
    return places.reshape(-1, 2), spins.reshape(-1, 3)


def _apart(places: Array) -> float:
    """Return how far the nearest other site is from the first."""
    far = np.linalg.norm(places[1:] - places[0], axis=1) if len(places) > 1 else np.ones(1)
    return float(far[far > 0.0].min(initial=np.inf)) if (far > 0.0).any() else 1.0


def _size(step: float, places: Array, high: float) -> float:
    """Return the area of a square of a site [points²] for a picture as wide as the lattice."""
    width = float(np.ptp(places[:, 0])) + 2.0 * step
    return (0.83 * 1.4 * style.COLUMN * 72.0 * step / width) ** 2
