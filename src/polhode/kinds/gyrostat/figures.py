"""A gyrostat's momentum sphere with its equilibria, and its angular velocity over time."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.figure import Figure

from polhode.figures import style
from polhode.figures.energy_levels import default_frame, draw_legend, draw_levels, label_axes, mark_verdict
from polhode.figures.sphere import draw_curve, draw_disk, mark_point
from polhode.kinds.gyrostat.answers import GyrostatReport
from polhode.types import Array


def draw_gyrostat_sphere(report: GyrostatReport) -> Figure | None:
    """Return the sphere |L| = const with levels of the carrier's energy, equilibria and this motion. None at rest."""
    momentum = np.asarray(report.trajectory.momentum)
    norm = float(np.linalg.norm(momentum[0]))
    if not report.equilibria:
        return None
    rotor = report.rotor_momentum[-1] * report.along

    def energy(unit: Array) -> Array:
        return 0.5 * np.sum((norm * unit - rotor) ** 2 / report.moments, axis=-1)

    figure, (axes,) = style.axes_for(None)
    frame = default_frame()
    draw_disk(axes)
    draw_levels(axes, frame, energy, None, style.GREY, 0.5)
    saddles = [e.energy for e in report.equilibria if e.extremum == "saddle"]
    draw_levels(axes, frame, energy, saddles, style.VERMILION, 0.9)
    draw_curve(axes, frame, momentum / norm, style.BLUE, 1.8 if not report.motor else 0.9)
    label_axes(axes, frame)
    for equilibrium in report.equilibria:
        mark_verdict(axes, frame, equilibrium.along, equilibrium.verdict.verdict)
    mark_point(axes, frame, momentum[0] / norm)
    lines = [("this motion", style.BLUE, 1.8), ("levels of energy", style.GREY, 0.5)]
    if saddles:
        lines.insert(1, ("separatrix", style.VERMILION, 0.9))
    draw_legend(axes, lines, [e.verdict.verdict for e in report.equilibria])
    end = "; levels and rests at the end" if report.motor else ""
    axes.set_title(f"Momentum sphere, body axes{end}", fontsize=style.FONT, color=style.DARK)
    return figure


def draw_gyrostat_motion(report: GyrostatReport) -> Figure:
    """Return Ω along the body's axes, and the angle from the rotor's axis to L or the motor's work, against time."""
    times, velocity = np.asarray(report.trajectory.times), np.asarray(report.trajectory.angular_velocity)
    figure = style.new_figure(height=3.4)
    upper, lower = figure.subplots(2, 1, sharex=True)
    slow, power = style.power_of_ten((times[0], times[-1])), style.power_of_ten(velocity)
    for k in range(3):
        upper.plot(times / 10.0**slow, velocity[:, k] / 10.0**power, color=style.AXIS_COLOURS[k], lw=1.0,
                   ls=("-", "--", "-.")[k], label=f"axis {k + 1}")
    upper.set_ylabel(f"Ω  [{style.factor(power)}rad/s]")
    if report.motor:
        spin = style.power_of_ten(report.rotor_rate)
        lower.plot(times / 10.0**slow, report.rotor_rate / 10.0**spin, color=style.ROTOR, lw=1.1)
        lower.set_ylabel(f"rotor's rate  [{style.factor(spin)}rad/s]")
    else:
        lower.plot(times / 10.0**slow, np.degrees(report.axis_to_momentum), color=style.DARK, lw=1.1)
        lower.set_ylabel("rotor's axis to L  [°]")
        lower.ticklabel_format(axis="y", useOffset=False)
        _not_narrower(lower, np.degrees(report.axis_to_momentum))
    lower.set_xlabel(f"time  [{style.factor(slow)}s]")
    for axes in (upper, lower):
        axes.set_xlim(times[0] / 10.0**slow, times[-1] / 10.0**slow)
        style.tidy(axes)
    figure.legend(*upper.get_legend_handles_labels(), loc="outside upper center", ncols=3, fontsize=style.FONT - 1,
                  frameon=False, handlelength=2.2)
    return figure


def _not_narrower(axes: Any, values: Array) -> None:
    """Widen the axis so that rounding errors do not look like motion."""
    middle, half = 0.5 * (values.min() + values.max()), 0.5 * (values.max() - values.min())
    if half < 1e-3 * max(abs(middle), 1e-3):
        axes.set_ylim(middle - 0.05 * max(abs(middle), 1e-3), middle + 0.05 * max(abs(middle), 1e-3))


FIGURES = {"momentum_sphere": draw_gyrostat_sphere, "motion": draw_gyrostat_motion}
