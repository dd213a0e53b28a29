"""The path of a top's axis on the sphere, between its bounding circles."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.figure import Figure

from polhode.figures import style
from polhode.figures.sphere import draw_curve, draw_disk, mark_point, view_frame
from polhode.figures.top_shown import sample_axis, take_top
from polhode.motion._trajectory import Trajectory

if TYPE_CHECKING:
    from polhode.exact.lagrange_top import LagrangeMotion


def axis_locus(shown: LagrangeMotion | Trajectory, *, axes: Any = None) -> Figure:
    """Return the path of a top's axis on the unit sphere, space axes, up on the page.

    Args:
        shown: a Lagrange top's motion, or samples of a top's motion.
        axes: matplotlib axes to draw on; a new figure without them.

    Raises:
        InvalidInput: for the motion of anything else, or of several tops.

    >>> from polhode import LagrangeMotion
    >>> axis_locus(LagrangeMotion((1.0, 1.0, 2.0), mgl=3.0, momentum=(1.0, 0.0, 6.0))).axes[0].get_title()[:16]
    'Path of the axis'
    """
    direction = (0.62, -0.62, 0.48)
    top = take_top(shown)
    figure, (axes,) = style.axes_for(axes)
    draw_disk(axes)
    frame = view_frame(direction)
    path = sample_axis(top)
    curve, limits = path.axis, path.limits
    kind = ", space axes"
    if top.exact is not None:
        kind = ": steady precession" if top.constant_tilt else f": {top.exact.regime}"
    for height in limits:
        turn = np.linspace(0.0, 2.0 * np.pi, 400)
        radius = np.sqrt(max(0.0, 1.0 - height * height))
        circle = np.stack([radius * np.cos(turn), radius * np.sin(turn), np.full(400, height)], axis=-1)
        draw_curve(axes, frame, circle, style.VERMILION, 0.7)
    draw_curve(axes, frame, curve, style.BLUE, 1.2)
    mark_point(axes, frame, curve[0])
    up = frame @ np.array([0.0, 0.0, 1.0])
    axes.annotate("", (1.22 * up[0], 1.22 * up[1]), (up[0], up[1]),
                  arrowprops={"arrowstyle": "->", "color": style.DARK, "lw": 0.8})
    axes.text(1.28 * up[0], 1.28 * up[1], "up", fontsize=style.FONT, ha="center", va="bottom", color=style.DARK)
    handles = [axes.plot([], [], color=style.BLUE, lw=1.2, label="axis of the top")[0]]
    if limits:
        handles.append(axes.plot([], [], color=style.VERMILION, lw=0.7, label="limits of its tilt")[0])
    axes.legend(handles=handles, loc="upper center", bbox_to_anchor=(0.5, -0.01), ncols=2, fontsize=style.FONT - 1,
                frameon=False, handlelength=1.6)
    axes.set_title(f"Path of the axis{kind}{path.words}", fontsize=style.FONT, color=style.DARK)
    return figure
