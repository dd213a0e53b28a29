"""The figures of a body with losses: path of L on the momentum sphere, energy, and angle to the major axis."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
from matplotlib.figure import Figure

from polhode.figures import style
from polhode.figures.energy_levels import default_frame, draw_legend, draw_levels, label_axes, mark_verdict
from polhode.figures.sphere import draw_curve, draw_disk, mark_point
from polhode.spacecraft.damped_body.answers import DampedBodyReport
from polhode.types import Array


def draw_damped_sphere(report: DampedBodyReport) -> Figure | None:
    """Return the direction of L on the unit sphere, body axes, with levels of the energy. None at rest."""
    coarsest = 0.6  # rad between samples up to which they are joined; beyond, lines would show what is not there
    if not report.axes:
        return None
    momentum = np.asarray(report.trajectory.momentum)
    norm = report.momentum_norm
    unit = momentum[norm > 0] / norm[norm > 0, None]
    moments = report.body.principal_moments
    figure, (axes,) = style.axes_for(None)
    frame = default_frame()
    draw_disk(axes)
    draw_levels(axes, frame, lambda u: np.sum(u * u / moments, axis=-1), None, style.LIGHT, 0.5)
    joined = np.linalg.norm(np.diff(unit, axis=0), axis=-1).max(initial=0.0) < coarsest
    if joined:
        draw_curve(axes, frame, _smooth(unit), style.BLUE, 0.8)
    else:
        x, y, depth = frame @ unit.T
        axes.plot(x[depth >= 0], y[depth >= 0], ".", ms=1.2, mew=0, color=style.BLUE, zorder=3)
    label_axes(axes, frame)
    for k, stability in enumerate(report.axes):
        for side in (1.0, -1.0):
            mark_verdict(axes, frame, side * np.eye(3)[k], stability.verdict)
    mark_point(axes, frame, unit[0])
    path = "direction of L" if joined else "L at the samples"
    lines = [(path, style.BLUE, 0.9), ("levels of energy", style.LIGHT, 0.5)]
    draw_legend(axes, lines, [stability.verdict for stability in report.axes])
    words = "Momentum sphere" if report.inside else "Direction of L"
    axes.set_title(f"{words}, body axes", fontsize=style.FONT, color=style.DARK)
    return figure


def _smooth(unit: Array) -> Array:
    """Return a path on the sphere with points between the samples, along great circles."""
    finest = 0.05  # rad between points of a curve that is drawn as one
    steps = np.linalg.norm(np.diff(unit, axis=0), axis=-1)
    count = int(np.clip(np.ceil(steps.max(initial=0.0) / finest), 1, 20))
    if count == 1:
        return unit
    part = (np.arange(count) / count)[:, None]
    path = np.concatenate([a + part * (b - a) for a, b in pairwise(unit)] + [unit[-1:]])
    return path / np.linalg.norm(path, axis=-1, keepdims=True)


def draw_damped_motion(report: DampedBodyReport) -> Figure:
    """Return the energy and the angle between L and the major axis against time."""
    times = np.asarray(report.trajectory.times)
    figure = style.new_figure(height=3.4)
    upper, lower = figure.subplots(2, 1, sharex=True)
    slow, power = style.power_of_ten((times[0], times[-1])), style.power_of_ten(report.energy)
    upper.plot(times / 10.0**slow, report.energy / 10.0**power, color=style.BLUE, lw=1.2, label="energy")
    if report.inside and report.axes:
        lowest = 0.5 * report.momentum_norm[0] ** 2 / report.body.principal_moments[2]
        upper.axhline(lowest / 10.0**power, color=style.GREY, lw=0.8, ls="--", label="lowest at this |L|")
    upper.set_ylim(bottom=0.0)
    upper.set_ylabel(f"energy  [{style.factor(power)}J]")
    upper.legend(fontsize=style.FONT - 1, frameon=False, loc="best")
    lower.plot(times / 10.0**slow, np.degrees(report.angle_to_major_axis), color=style.DARK, lw=1.1)
    lower.set_ylim(-2.0, 92.0)
    lower.set_yticks((0, 30, 60, 90))
    lower.set_ylabel("L to major axis  [°]")
    lower.set_xlabel(f"time  [{style.factor(slow)}s]")
    for axes in (upper, lower):
        axes.set_xlim(times[0] / 10.0**slow, times[-1] / 10.0**slow)
        style.tidy(axes)
    return figure


FIGURES = {"momentum_sphere": draw_damped_sphere, "motion": draw_damped_motion}
