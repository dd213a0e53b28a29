"""A figure of another package for reports on free bodies: how fast the body turns, over time."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from polhode.kinds import MotionReport


def draw_spin_rate(report: MotionReport) -> Figure | None:
    """Draw |Ω| against time; nothing for a motion without an angular velocity."""
    from matplotlib.figure import Figure

    shown = report.shown
    if shown.angular_velocity is None:
        return None
    figure = Figure(figsize=(6.0, 3.0), layout="constrained")
    axes = figure.subplots()
    axes.plot(shown.times, np.linalg.norm(shown.angular_velocity, axis=-1))
    axes.set_xlabel("time [s]")
    axes.set_ylabel("|Ω| [rad/s]")
    axes.set_title(report.name)
    return figure
