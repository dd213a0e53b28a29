"""The herpolhode: the path of the inertia ellipsoid's contact point in the invariable plane."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.figure import Figure

from polhode.analysis import poinsot
from polhode.exact.free_body import FreeMotion
from polhode.figures import style
from polhode.figures.free_motion import take_free_motion
from polhode.motion._inputs import finite
from polhode.motion._trajectory import Trajectory
from polhode.types import Array


def herpolhode(shown: FreeMotion | Trajectory, *, axes: Any = None) -> Figure | None:
    """Return the herpolhode between its two circles; None where the contact point stays or there is no motion.

    Args:
        shown: a free body's motion, or samples of one.
        axes: matplotlib axes to draw on; a new figure without them.

    Raises:
        InvalidInput: for the motion of anything else, or of several bodies.
    """
    line_width = 2e-3  # of the outer radius: circles closer than this are one line in print
    motion, samples = take_free_motion(shown)
    limits = poinsot.herpolhode(motion)
    if limits is None or limits.outer_radius <= 1e-12 * limits.plane_distance:
        return None
    power = style.power_of_ten(limits.outer_radius)
    outer = limits.outer_radius / 10.0**power
    curve = poinsot.herpolhode_curve(motion, _times(motion, samples)) / 10.0**power
    user_axes = axes
    figure, (axes,) = style.axes_for(axes, height=3.9)
    circle = np.linspace(0.0, 2.0 * np.pi, 400)
    # where both circles coincide with the curve, they would only hide it
    distinct = limits.outer_radius - limits.inner_radius > line_width * limits.outer_radius
    for radius in () if not distinct else {limits.inner_radius / 10.0**power, outer}:
        axes.plot(radius * np.cos(circle), radius * np.sin(circle), color=style.VERMILION, lw=0.7, ls="--", zorder=1,
                  label="its limits" if radius == outer else None)
    axes.plot(*curve.T, color=style.HERPOLHODE, lw=0.9, label="herpolhode")
    axes.plot(*curve[0], "o", ms=3.5, color=style.HERPOLHODE, mec="white", mew=0.5)
    axes.plot(0.0, 0.0, "+", color=style.DARK, ms=6, mew=0.8)
    axes.set_aspect("equal")
    axes.set_xlim(-1.12 * outer, 1.12 * outer)
    axes.set_ylim(-1.12 * outer, 1.12 * outer)
    unit = f"[{style.factor(power)}(kg m²)$^{{-1/2}}$]"
    axes.set_xlabel(f"across L  {unit}")
    axes.set_ylabel(f"across L, 90° on  {unit}")
    axes.set_title("Herpolhode, L towards the viewer", fontsize=style.FONT, color=style.DARK)
    style.tidy(axes)
    settings: Any = {"ncols": 2, "fontsize": style.FONT - 1, "frameon": False, "handlelength": 2.2}
    if user_axes is None:
        figure.legend(*axes.get_legend_handles_labels(), loc="outside lower center", **settings)
    else:
        axes.legend(loc="upper center", bbox_to_anchor=(0.5, -0.18), **settings)
    return figure


def _times(motion: FreeMotion, samples: Trajectory) -> Array:
    """Return times that follow every turn of the contact point, which the samples need not."""
    most_periods, most_turns = 6, 24  # drawn at most
    per_turn = 120
    times, period = np.asarray(samples.times), finite(motion.period)
    fastest = float(np.linalg.norm(np.asarray(samples.angular_velocity), axis=-1).max())
    fastest += 2.0 * np.pi / period if period is not None else 0.0
    repeats = most_periods * period if period is not None else np.inf
    span = min(float(np.ptp(times)), 2.0 * np.pi * most_turns / fastest, repeats)
    count = int(np.ceil(span * fastest / (2.0 * np.pi) * per_turn)) + 2
    return np.linspace(times[0], times[0] + span, count)
