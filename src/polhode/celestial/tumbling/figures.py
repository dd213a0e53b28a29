"""Figures of a tumbler: its polhode among others, its light curve, and the frequencies of the light curve."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from matplotlib.figure import Figure

from polhode.analysis.polhodes import polhode_family, separatrix
from polhode.celestial.tumbling.estimation import Tumbling
from polhode.celestial.tumbling.tumbler import LightCurve
from polhode.figures import style
from polhode.figures.energy_levels import label_axes
from polhode.figures.sphere import draw_curve, draw_disk, view_frame
from polhode.reports.wording import LONG, order_words
from polhode.types import Array


def polhode(body: str, motion: Tumbling, others: Sequence[Tumbling]) -> Figure:
    """Return the path of the angular momentum among the polhodes of the body."""
    figure = style.new_figure(height=style.COLUMN * 1.05)
    axes = figure.subplots()
    draw_disk(axes)
    frame = view_frame((0.80, 0.46, 0.38))
    moments = motion.moments
    for curve in polhode_family(moments):
        draw_curve(axes, frame, curve, style.LIGHT, 0.5)
    for curve in separatrix(moments):
        draw_curve(axes, frame, curve, style.VERMILION, 0.8)
    draw_curve(axes, frame, _path(motion), style.BLUE, 1.4)
    for other in others:
        draw_curve(axes, frame, _path(other), style.SKY, 0.9)
    label_axes(axes, frame)
    named = [(style.BLUE, 1.4, f"{motion.mode} mode"), (style.VERMILION, 0.8, "separatrix")]
    named += [(style.SKY, 0.9, f"{other.mode} mode") for other in others]
    handles = [axes.plot([], [], color=colour, lw=width, label=words)[0] for colour, width, words in named]
    axes.legend(handles=handles, loc="upper center", bbox_to_anchor=(0.5, -0.01), ncols=3, fontsize=style.FONT - 1,
                frameon=False)
    axes.set_title(f"{body}: angular momentum along the principal axes", fontsize=style.FONT, color=style.DARK)
    return figure


def _path(motion: Tumbling) -> Array:
    times = np.linspace(0.0, motion.rotation, 2000)
    return np.asarray(motion.motion.momentum(times)) / float(np.asarray(motion.motion.momentum_norm))


def light_curve(light: LightCurve) -> Figure:
    """Return the magnitude over time."""
    figure = style.new_figure(width=1.8 * style.COLUMN, height=0.7 * style.COLUMN)
    axes = figure.subplots()
    size, unit = next(((size, unit) for least, size, unit in LONG if light.times[-1] >= least), (1.0, "s"))
    axes.plot(light.times / size, light.magnitudes, color=style.BLUE, lw=0.9)
    axes.invert_yaxis()
    axes.set_xlabel(f"time  [{unit}]")
    axes.set_ylabel("magnitude")
    axes.set_title(f"Ellipsoid {' : '.join(f'{x:.3g}' for x in light.semi_axes)}, phase angle "
                   f"{np.degrees(light.phase):.3g}°, L at {np.degrees(light.aspect):.3g}° from the observer",
                   fontsize=style.FONT, color=style.DARK)
    axes.margins(x=0.0)
    style.tidy(axes)
    return figure


def spectrum(light: LightCurve, motion: Tumbling) -> Figure:
    """Return the frequencies of the light curve, by their orders."""
    named = 6  # lines that have their names in the figure
    figure = style.new_figure(width=1.8 * style.COLUMN, height=0.8 * style.COLUMN)
    axes = figure.subplots()
    lines = light.lines
    scaled = lines.frequency * motion.precession
    axes.vlines(scaled, 0.0, 1e3 * lines.amplitude, color=style.BLUE, lw=1.2)
    top = 1e3 * float(lines.amplitude.max())
    for k in range(min(named, len(scaled))):
        words = order_words(int(lines.precession_order[k]), int(lines.rotation_order[k]))
        axes.annotate(words.replace("P_φ", r"$P_\phi$").replace("P_ψ", r"$P_\psi$"),
                      (float(scaled[k]), 1e3 * float(lines.amplitude[k])), (0, 3), textcoords="offset points",
                      rotation=90, fontsize=style.FONT - 1.5, ha="center", va="bottom", color=style.DARK)
    axes.set_ylim(0.0, 1.4 * top)
    axes.set_xlim(0.0, 1.12 * float(scaled.max()))
    axes.set_xlabel(r"frequency  [$1/P_\phi$]")
    axes.set_ylabel("amplitude  [mmag]")
    axes.set_title("Frequencies of the light curve", fontsize=style.FONT, color=style.DARK)
    style.tidy(axes)
    return figure
