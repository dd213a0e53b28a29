"""One picture of any motion, as ``motion.plot()`` and ``trajectory.plot()`` show it."""

from __future__ import annotations

from typing import TYPE_CHECKING

from polhode._base import check
from polhode._base.extras import needing
from polhode.errors import InvalidInput
from polhode.kinds.registry import kind_of_source
from polhode.motion._trajectory import Trajectory
from polhode.motion.base import AbstractMotion
from polhode.reports.report import Report

if TYPE_CHECKING:
    from matplotlib.figure import Figure


def plot(motion: AbstractMotion | Trajectory | Report) -> Figure:
    """Return the main picture of a motion: that of its kind, else its state against time.

    A free body's is its momentum sphere, with Ω and L over time; a top's is the path of its axis, with tilt and Ω. Of a
    report it is the first of its figures; ``report.plot()`` has them all by name.

    Args:
        motion: a motion in closed form, any trajectory of one body or system, or a report.

    Raises:
        InvalidInput: for a batch, a trajectory without samples, a report without figures, or anything else.

    >>> from polhode import FreeMotion
    >>> [axes.get_title() for axes in plot(FreeMotion((1.0, 2.0, 3.0), momentum=(0.3, 1.8, 1.5))).axes][0]
    'Momentum sphere, body axes'
    """
    with needing("Plots need"):
        from polhode.figures import style
        from polhode.figures.parts_figure import parts

    if isinstance(motion, Report):
        first = next((figure for draw in motion.figures().values() if (figure := draw()) is not None), None)
        if first is None:
            raise InvalidInput(f"a report of kind {motion.kind} has no figures. Print its `summary` and `answers`.")
        return first
    check.instance("motion", motion, (AbstractMotion, Trajectory), "a motion, a trajectory or a report")
    kind = kind_of_source(motion.source if isinstance(motion, Trajectory) else motion)
    sides = () if kind is None else kind.overview()
    if not sides:
        return parts(motion if isinstance(motion, Trajectory) else motion.sample())
    figure = style.new_figure(width=len(sides) * style.COLUMN, height=style.COLUMN)
    for half, (draw, rows) in zip(figure.subfigures(1, len(sides), squeeze=False)[0], sides, strict=True):
        panels = list(half.subplots(rows, 1, sharex=True, squeeze=False)[:, 0])
        if draw(motion, axes=panels if rows > 1 else panels[0]) is None:
            for panel in panels:
                panel.axis("off")
    return figure
