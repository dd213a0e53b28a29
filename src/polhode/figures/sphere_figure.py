"""The momentum sphere with its family of polhodes, the separatrix and the motion at hand."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.figure import Figure

from polhode.analysis.polhodes import polhode_family, separatrix
from polhode.exact.free_body import FreeMotion
from polhode.figures import style
from polhode.figures.free_motion import take_free_motion
from polhode.figures.sphere import draw_curve, draw_disk, mark_point, view_frame
from polhode.motion._inputs import finite
from polhode.motion._trajectory import Trajectory
from polhode.types import Array


def momentum_sphere(shown: FreeMotion | Trajectory, *, axes: Any = None) -> Figure | None:
    """Return an oblique view of the sphere |L| = const, far side dimmed; axes are the principal ones. None at rest.

    Args:
        shown: a free body's motion, or samples of one.
        axes: matplotlib axes to draw on; a new figure without them.

    Raises:
        InvalidInput: for the motion of anything else, or of several bodies.

    >>> from polhode import FreeMotion
    >>> momentum_sphere(FreeMotion((1.0, 2.0, 3.0), momentum=(0.3, 1.8, 1.5))).axes[0].get_title()
    'Momentum sphere, body axes'
    """
    direction = (0.80, 0.46, 0.38)
    motion, samples = take_free_motion(shown)
    norm = motion.momentum_norm
    if not norm:
        return None
    figure, (axes,) = style.axes_for(axes)
    draw_disk(axes)
    moments = np.asarray(motion.moments)
    frame = view_frame(direction)
    family = polhode_family(moments)
    for curve in family:
        draw_curve(axes, frame, curve, style.GREY, 0.5)
    for curve in separatrix(moments):
        draw_curve(axes, frame, curve, style.VERMILION, 0.9)
    unit, span = np.asarray(samples.momentum) / norm, finite(motion.period)
    if span is not None:
        unit = motion.momentum(motion.epoch + np.linspace(0.0, span, 2000)) / norm
    draw_curve(axes, frame, unit, style.BLUE, 1.8)
    mark_point(axes, frame, unit[0])
    for k in range(3):
        _label(axes, frame, k)
    still = motion.regime in ("permanent", "spherical")
    dot: Any = {"marker": "o", "ls": "", "ms": 4, "mec": "white"} if still else {"lw": 1.8}
    handles = [axes.plot([], [], color=style.BLUE, label="this motion", **dot)[0]]
    if family:
        handles.append(axes.plot([], [], color=style.GREY, lw=0.5, label="other polhodes")[0])
    if moments[0] < moments[1] < moments[2]:
        handles.insert(1, axes.plot([], [], color=style.VERMILION, lw=0.9, label="separatrix")[0])
    axes.legend(handles=handles, loc="upper center", bbox_to_anchor=(0.5, -0.01), ncols=3, fontsize=style.FONT - 1,
                frameon=False, handlelength=1.6, columnspacing=1.2)
    axes.set_title("Momentum sphere, body axes", fontsize=style.FONT, color=style.DARK)
    return figure


def _label(axes: Any, frame: Array, k: int) -> None:
    x, y, _ = frame @ np.eye(3)[k]
    size = np.hypot(x, y)
    reach = 1.0 + 0.12 / size
    axes.plot([x, reach * x], [y, reach * y], color=style.DARK, lw=0.7, zorder=4)
    axes.plot([x], [y], ".", color=style.DARK, ms=2.5, zorder=4)
    beyond = reach + 0.10 / size
    axes.text(beyond * x, beyond * y, f"$L_{k + 1}$", fontsize=style.FONT + 1, ha="center", va="center",
              color=style.DARK, zorder=6, bbox={"fc": "white", "ec": "none", "pad": 0.6, "alpha": 0.85})
