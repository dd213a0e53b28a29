"""The figures of a rigid body with mounts and torques: rates, pointing error, wheels."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.figure import Figure

from polhode.figures import style
from polhode.spacecraft.rigid_body.answers import RigidBodyReport

CURVES = (style.BLUE, style.VERMILION, style.GREEN, style.ORANGE, style.PURPLE, style.SKY)


def draw_rates(report: RigidBodyReport) -> Figure:
    """Return Ω and the momentum of all along the given axes against time."""
    figure, panels, times = _begin(report, 2)
    for axes, values, name, unit in (
        (panels[0], report.history.velocity, "Ω", "rad/s"), (panels[1], report.history.momentum, "L", "kg m²/s"),
    ):
        power = style.power_of_ten(values)
        for k in range(3):
            axes.plot(times, values[:, k] / 10.0**power, color=style.AXIS_COLOURS[k], lw=1.0,
                      ls=("-", "--", "-.")[k], label="xyz"[k])
        axes.set_ylabel(f"{name}  [{style.factor(power)}{unit}]")
    return _finish(figure, panels, 3)


def draw_pointing(report: RigidBodyReport) -> Figure | None:
    """Return the pointing error against time, or the angle from the axes that look down. None without either."""
    smallest = 1e-9  # of the largest error, below which a logarithm shows rounding
    history = report.history
    error = history.from_nadir if history.pointing is None else history.pointing
    if error is None:
        return None
    figure, panels, times = _begin(report, 1)
    degrees, axes = np.degrees(error), panels[0]
    if history.pointing is not None and degrees.max() > 0:
        axes.semilogy(times, np.maximum(degrees, smallest * degrees.max()), color=style.BLUE, lw=1.1)
        axes.axhline(np.degrees(report.within), color=style.GREY, lw=0.8, ls="--", label="settled below this")
        axes.legend(fontsize=style.FONT - 1, frameon=False, loc="best")
    else:
        axes.plot(times, degrees, color=style.BLUE, lw=1.1)
    axes.set_ylabel("pointing error  [°]" if history.pointing is not None else "from nadir axes  [°]")
    return _finish(figure, panels, 0)


def draw_wheels(report: RigidBodyReport) -> Figure | None:
    """Return the rates of the wheels and the torques of their motors against time. None without wheels."""
    history = report.history
    if not history.rates.shape[1]:
        return None
    figure, panels, times = _begin(report, 2)
    curves = (history.rates, "rate", "rad/s"), (history.motors, "torque", "N m")
    for axes, (values, name, unit) in zip(panels, curves, strict=True):
        power = style.power_of_ten(values)
        for k, curve in enumerate(values.T):
            axes.plot(times, curve / 10.0**power, color=CURVES[k % len(CURVES)], lw=1.0, label=f"wheel {k + 1}")
        axes.set_ylabel(f"{name}  [{style.factor(power)}{unit}]")
    return _finish(figure, panels, min(history.rates.shape[1], 4))


def _begin(report: RigidBodyReport, rows: int) -> tuple[Figure, list[Any], Any]:
    figure, panels = style.axes_for(None, rows, height=1.7 * rows + 0.3)
    times = np.asarray(report.trajectory.times)
    slow = style.power_of_ten((times[0], times[-1]))
    panels[-1].set_xlabel(f"time  [{style.factor(slow)}s]")
    for axes in panels:
        axes.set_xlim(times[0] / 10.0**slow, times[-1] / 10.0**slow)
    return figure, panels, times / 10.0**slow


def _finish(figure: Figure, panels: list[Any], columns: int) -> Figure:
    for axes in panels:
        style.tidy(axes)
    if columns:
        figure.legend(*panels[0].get_legend_handles_labels(), loc="outside upper center", ncols=columns,
                      fontsize=style.FONT - 1, frameon=False, handlelength=2.2)
    return figure


FIGURES = {"rates": draw_rates, "pointing": draw_pointing, "wheels": draw_wheels}
