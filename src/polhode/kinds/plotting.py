"""One picture of any motion, as ``motion.plot()`` and ``trajectory.plot()`` show it."""

from __future__ import annotations

from typing import TYPE_CHECKING

from polhode.errors import InvalidInput, shown
from polhode.kinds.registry import kind_of_source
from polhode.motion._trajectory import Trajectory
from polhode.motion.base import AbstractMotion

if TYPE_CHECKING:
    from matplotlib.figure import Figure


def plot(moved: AbstractMotion | Trajectory) -> Figure:
    """Return the most telling picture of a motion: that of its kind, else its state against time.

    A free body's is its momentum sphere, with Ω and L over time; a top's is the path of its axis, with tilt and Ω.

    Args:
        moved: a motion in closed form, or any trajectory of one body or system.

    Raises:
        InvalidInput: for a batch, a trajectory without samples, or anything else.

    >>> from polhode import FreeMotion
    >>> [axes.get_title() for axes in plot(FreeMotion((1.0, 2.0, 3.0), momentum=(0.3, 1.8, 1.5))).axes][0]
    'Momentum sphere, body axes'
    """
    from polhode.figures import style
    from polhode.figures.parts_figure import parts

    if not isinstance(moved, AbstractMotion | Trajectory):
        raise InvalidInput(f"`moved` must be a motion or a trajectory; got {shown(moved)}.")
    kind = kind_of_source(moved.source if isinstance(moved, Trajectory) else moved)
    sides = () if kind is None else kind.overview()
    if not sides:
        if isinstance(moved, Trajectory):
            return parts(moved)
        raise InvalidInput(f"`moved` is a {type(moved).__name__}, which no kind draws; plot moved.sample(times).")
    figure = style.new_figure(width=len(sides) * style.COLUMN, height=style.COLUMN)
    for half, (draw, rows) in zip(figure.subfigures(1, len(sides), squeeze=False)[0], sides, strict=True):
        panels = list(half.subplots(rows, 1, sharex=True, squeeze=False)[:, 0])
        if draw(moved, axes=panels if rows > 1 else panels[0]) is None:
            for panel in panels:
                panel.axis("off")
    return figure
