"""The stroboscopic section at periapsis: a family of starts, the motion, and the zones of the resonances."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.figure import Figure

from polhode.celestial.spin_orbit.answers import SpinOrbitReport, ratio
from polhode.celestial.spin_orbit.motion import steps_for
from polhode.celestial.spin_orbit.resonances import poincare_section
from polhode.figures import style
from polhode.types import Array


def draw_spin_section(report: SpinOrbitReport) -> Figure:
    """Return θ̇/n against θ at periapsis, with bars at the side for the resonances' zones."""
    count = 22  # rates of the family, at the long axis along and across the periapsis' direction each
    coarser, fewest_steps = 3, 32  # fewer steps per orbit for the other starts, right to 1e-7 rad after ten orbits
    system, n = report.system, float(report.system.mean_motion)
    steps, orbits = steps_for(system, float(report.trajectory.part("rate")[0]) / n), report.section_orbits
    own = report.motion.section[: orbits + 1]
    if len(own) <= orbits:
        own = poincare_section(system, report.start, orbits, steps)
    own = _fold_angles(own, n)
    low, high = _window(report, own[:, 1])
    rates = np.linspace(low, high, count + 2)[1:-1] * n
    starts = np.stack(np.meshgrid([0.0, 0.5 * np.pi], rates), axis=-1).reshape(-1, 2)
    others = poincare_section(system, starts, orbits, max(fewest_steps, steps // coarser))
    others = _fold_angles(others, n).reshape(-1, 2)
    figure = style.new_figure(height=3.9)
    axes, side = figure.subplots(1, 2, sharey=True, width_ratios=(8, 1))
    axes.plot(*others.T, ".", color=style.GREY, ms=1.2, mew=0, label="other starts", rasterized=True)
    axes.plot(*own.T, ".", color=style.BLUE, ms=2.6, mew=0, label="this motion", rasterized=True)
    axes.set(xlim=(-90, 90), ylim=(low, high), xticks=(-90, -45, 0, 45, 90))
    axes.set_xlabel("θ at periapsis  [°]")
    axes.set_ylabel("$\\dot{θ}$/n  [turns per orbit]")
    handles, labels = axes.get_legend_handles_labels()
    if zones := _zones(report, side, low, high):
        handles, labels = [*handles, zones], [*labels, "zones of resonances"]
    figure.legend(handles, labels, loc="outside upper center", ncols=3, fontsize=style.FONT - 1, frameon=False,
                  handlelength=1.0, markerscale=3.0, columnspacing=1.2)
    style.tidy(axes)
    return figure


def _zones(report: SpinOrbitReport, side: Any, low: float, high: float) -> Any:
    """Draw a bar for each visible zone, neighbours side by side to show an overlap; None without any."""
    crowded = 0.04  # of the height: names closer to each other than that would overlap
    n = float(report.system.mean_motion)
    handle, named = None, -np.inf
    for k, zone in enumerate(report.resonances):
        width = zone.half_width / n
        if not low < zone.order < high or width == 0.0:
            continue
        x = k % 2
        (handle,) = side.plot([x, x], [zone.order - width, zone.order + width], color=style.VERMILION, lw=1.4)
        side.plot([x - 0.25, x + 0.25], [zone.order] * 2, color=style.VERMILION, lw=1.4)
        if zone.order - named > crowded * (high - low):
            side.text(1.8, zone.order, ratio(zone.order), fontsize=style.FONT - 1, va="center", color=style.DARK)
            named = zone.order
    side.set(xlim=(-0.6, 3.4))
    side.axis("off")
    return handle


def _window(report: SpinOrbitReport, rates: Array) -> tuple[float, float]:
    """Return the rates to show: this motion and the zone nearest to it, or all zones where they are wide."""
    wide = 0.25  # half-width of a zone, from which all of them are shown
    feeble = 0.05  # of the widest zone: narrower ones do not set what is shown
    n, mean = float(report.system.mean_motion), float(np.mean(rates))
    widths = {zone.order: zone.half_width / n for zone in report.resonances}
    widest = max(widths.values())
    near = [order for order, width in widths.items() if width > feeble * widest]
    low, high = -0.2, 3.2
    if not near:
        low, high = mean - 0.5, mean + 0.5
    elif widest < wide:
        order = min(near, key=lambda p: abs(p - mean))
        low, high = order - 3.0 * widths[order], order + 3.0 * widths[order]
    pad = 0.05 * (max(high, float(rates.max())) - min(low, float(rates.min())))
    return min(low, float(rates.min()) - pad), max(high, float(rates.max()) + pad)


def _fold_angles(points: Array, n: float) -> Array:
    """Return angles within ±90°, as half a turn makes no difference, and rates in units of n."""
    angles = np.degrees(points[..., 0] - np.pi * np.round(points[..., 0] / np.pi))
    return np.stack([angles, points[..., 1] / n], axis=-1)
