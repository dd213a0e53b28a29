"""The line spectrum of a molecule, one stick for each line."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.collections import LineCollection
from matplotlib.figure import Figure

from polhode.figures import style
from polhode.spectra._strengths import Lines
from polhode.spectra.reports import AREA


def spectrum(lines: Lines, *, axes: Any = None) -> Figure | None:
    """Return absorption lines as sticks of the lg of their intensity, by branch. None without visible lines.

    Args:
        lines: with intensities.
        axes: matplotlib axes to draw on; a new figure without them.

    >>> from polhode.spectra import Rotor
    >>> from polhode.spectra import DEBYE
    >>> spectrum(Rotor((27e9, 14e9, 9e9), dipole=(0.0, DEBYE, 0.0)).lines(3, 300.0)).axes[0].get_xlabel()
    'frequency  [GHz]'
    """
    visible = (lines.intensity > 0.0) & np.isfinite(lines.intensity)
    if not visible.any():
        return None
    size = np.log10(lines.intensity[visible] / AREA)
    nu, change = lines.frequency[visible], lines.upper[visible, 0] - lines.lower[visible, 0]
    weak = 1e-3  # of the strongest: the range of frequencies ends with the last line above it
    strong = size > size.max() + np.log10(weak)
    units = ((1e12, "THz"), (1e9, "GHz"), (1e6, "MHz"))
    unit, name = next(entry for entry in units if nu[strong].max() >= entry[0] or entry == units[-1])
    if axes is None:
        figure = style.new_figure(5.6, 2.8)
        axes = figure.subplots()
    else:
        figure, (axes,) = style.axes_for(axes)
    decades = 6.0  # of intensity
    floor = size.max() - decades
    inside = (size > floor) & (nu <= 1.05 * nu[strong].max())
    branches = (("R, J to J + 1", 1, style.BLUE), ("Q, J to J", 0, style.GREEN), ("P, J to J − 1", -1, style.ORANGE))
    for label, step, colour in branches:
        own = inside & (change == step)
        if own.any():
            sticks = [[(x, floor), (x, y)] for x, y in zip(nu[own] / unit, size[own], strict=True)]
            axes.add_collection(LineCollection(sticks, colors=colour, linewidths=0.6), autolim=False)
            axes.plot([], [], color=colour, lw=1.2, label=label)
    axes.set_xlim(0.0, 1.05 * nu[strong].max() / unit)
    axes.set_ylim(floor, size.max() + 0.09 * decades)
    _name_strongest(axes, lines, visible, nu / unit, size)
    axes.set_xlabel(f"frequency  [{name}]")
    axes.set_ylabel("lg intensity  [nm² MHz]")
    style.tidy(axes)
    style.legend_above(axes, None, *axes.get_legend_handles_labels())
    return figure


def _name_strongest(axes: Any, lines: Lines, visible: Any, nu: Any, size: Any) -> None:
    """Write the upper and lower level of the strongest lines that are far enough apart."""
    upper, lower, taken = lines.upper[visible], lines.lower[visible], []
    width = 0.13 * axes.get_xlim()[1]
    most_names = 6
    for k in np.argsort(size)[::-1]:
        if all(abs(nu[k] - other) > width for other in taken):
            taken.append(float(nu[k]))
            names = [f"{J}$_{{{Ka},{Kc}}}$" for J, Ka, Kc in (upper[k], lower[k])]
            axes.text(nu[k], size[k] + 0.1, "–".join(names), fontsize=style.FONT - 3, ha="center", va="bottom",
                      color=style.DARK, clip_on=True,
                      bbox={"fc": "white", "ec": "none", "pad": 0.3, "alpha": 0.8})
        if len(taken) == most_names:
            break
