"""The figures of a spherical pendulum."""

from __future__ import annotations

from matplotlib.figure import Figure

from polhode.figures import COLOURS, new_figure, tidy
from spherical_pendulum.answers import PendulumReport


def draw_path(report: PendulumReport) -> Figure:
    """Return the path of the mass from above."""
    figure = new_figure()
    axes = figure.add_subplot()
    axes.plot(report.trajectory.part("x"), report.trajectory.part("y"), color=COLOURS["palette"][0], lw=0.9)
    axes.set_aspect("equal", adjustable="datalim")
    axes.set_xlabel("x  [m]")
    axes.set_ylabel("y  [m]")
    tidy(axes)
    return figure


FIGURES = {"path": draw_path}
