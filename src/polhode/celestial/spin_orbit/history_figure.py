"""A spin's angle and rate over time, beside the rotation that keeps step with the orbit."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure

from polhode.celestial.spin_orbit.answers import DAY, SpinOrbitReport, ratio
from polhode.figures import style


def draw_spin_history(report: SpinOrbitReport) -> Figure:
    """Return θ − p n t and θ̇/n against time in orbits, p of the resonance that the spin is in, or the nearest."""
    most = 20_000  # samples shown
    coarse = 16  # samples per orbit, or turn, below which a line between them would mislead
    system, n = report.system, float(report.system.mean_motion)
    period = float(system.orbit.period)
    turns = np.asarray(report.trajectory.times) / period
    words = "" if len(turns) <= most else f", first {most} samples"
    angle, rate = (np.asarray(report.trajectory.part(name))[:most] for name in ("angle", "rate"))
    turns, order = turns[:most], _order(report)
    fastest = max(1.0, float(np.abs(rate).max()) / n)
    form = "-" if (turns[1] - turns[0]) * fastest < 1.0 / coarse else "."
    figure = style.new_figure(height=3.4)
    upper, lower = figure.subplots(2, 1, sharex=True)
    name = {0.0: "θ", 1.0: "θ − n t"}.get(order, f"θ − {ratio(order).replace(':', '/').removesuffix('/1')} n t")
    upper.plot(turns, np.degrees(angle - 2.0 * np.pi * order * turns), form, color=style.BLUE, lw=1.1, ms=2)
    upper.set_ylabel(f"{name}  [°]")
    lower.plot(turns, rate / n, form, color=style.BLUE, lw=1.1, ms=2)
    lower.set_ylabel("$\\dot{θ}$/n  [turns per orbit]")
    lower.set_xlabel(f"time{words}  [orbits of {_period(period)}]")
    for axes in (upper, lower):
        axes.set_xlim(turns[0], turns[-1])
        style.tidy(axes)
    return figure


def _order(report: SpinOrbitReport) -> float:
    if report.motion.verdict == "chaotic":
        return 1.0
    return 0.5 * round(2.0 * report.motion.mean_rate / float(report.system.mean_motion))


def _period(seconds: float) -> str:
    return f"{seconds / DAY:.5g} d" if seconds >= 0.1 * DAY else f"{seconds:.5g} s"
