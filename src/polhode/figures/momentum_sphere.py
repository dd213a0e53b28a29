"""The momentum sphere with its family of polhodes, the separatrix and the motion at hand."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.figure import Figure

from polhode.exact.free_body import FreeMotion
from polhode.figures import style
from polhode.figures.sphere import draw_curve, mark_point, sphere_axes, view_frame
from polhode.report.free_body import FreeBodyReport

Array = Any
VIEW = (0.80, 0.46, 0.38)
POLHODES = (0.08, 0.25, 0.5, 0.75)  # of the way from an axis to the separatrix


def draw_momentum_sphere(report: FreeBodyReport) -> Figure | None:
    """Return the sphere |L| = const seen obliquely, far side dimmed; axes are the principal ones. None at rest."""
    norm = report.motion.momentum_norm
    if not norm:
        return None
    figure = style.new_figure()
    axes = sphere_axes(figure)
    moments = np.asarray(report.motion.moments)
    frame = view_frame(VIEW)
    family = _family(moments)
    for curve in family:
        draw_curve(axes, frame, curve, style.GREY, 0.5)
    for curve in _separatrix(moments):
        draw_curve(axes, frame, curve, style.VERMILION, 0.9)
    unit, span = np.asarray(report.trajectory.momentum) / norm, report.motion.period
    if span is not None:
        unit = report.motion.momentum(np.linspace(0.0, span, 2000)) / norm
    draw_curve(axes, frame, unit, style.BLUE, 1.8)
    mark_point(axes, frame, unit[0])
    for k in range(3):
        _label(axes, frame, k)
    still = report.motion.regime in ("permanent", "spherical")
    dot: Any = {"marker": "o", "ls": "", "ms": 4, "mec": "white"} if still else {"lw": 1.8}
    handles = [axes.plot([], [], color=style.BLUE, label="this motion", **dot)[0]]
    if family:
        handles.append(axes.plot([], [], color=style.GREY, lw=0.5, label="other polhodes")[0])
    if moments[0] < moments[1] < moments[2]:
        handles.insert(1, axes.plot([], [], color=style.VERMILION, lw=0.9, label="separatrix")[0])
    axes.legend(handles=handles, loc="upper center", bbox_to_anchor=(0.5, -0.01), ncols=3, fontsize=style.FONT - 1,
                frameon=False, handlelength=1.6, columnspacing=1.2)  # fmt: skip
    axes.set_title("Momentum sphere, body axes", fontsize=style.FONT, color=style.DARK)
    return figure


def _family(moments: Array) -> list[Array]:
    """Return unit polhodes around the stable axes, at given fractions of the way to the separatrix."""
    I1, I2, I3 = moments
    curves = []
    if I1 == I3:
        return curves
    for axis in (0, 2):
        # on the great circle through axes 1 and 3 the separatrix stands at this angle from axis 3
        saddle = np.arctan2(np.sqrt((I3 - I2) * I1), np.sqrt((I2 - I1) * I3))
        reach = saddle if axis == 2 else 0.5 * np.pi - saddle
        for part in POLHODES if reach > 1e-9 else ():
            angle = part * reach
            near, far = np.cos(angle), np.sin(angle)
            start = (far, 0.0, near) if axis == 2 else (near, 0.0, far)
            motion = FreeMotion(moments, start)
            if motion.period is None:
                continue
            curve = motion.momentum(np.linspace(0.0, motion.period, 400))
            curves += [curve, -curve]
    return curves


def _separatrix(moments: Array) -> list[Array]:
    """Return the two great circles on which A L1² = B L3²."""
    I1, I2, I3 = moments
    if not I1 < I2 < I3:
        return []
    a, b = np.sqrt((I2 - I1) * I3), np.sqrt((I3 - I2) * I1)
    size = np.hypot(a, b)
    turn = np.linspace(0.0, 2.0 * np.pi, 400)
    return [
        np.stack([np.cos(turn) * b / size, np.sin(turn), side * np.cos(turn) * a / size], axis=-1) for side in (1, -1)
    ]


def _label(axes: Any, frame: Array, k: int) -> None:
    x, y, _ = frame @ np.eye(3)[k]
    size = np.hypot(x, y)
    reach = 1.0 + 0.12 / size
    axes.plot([x, reach * x], [y, reach * y], color=style.DARK, lw=0.7, zorder=4)
    axes.plot([x], [y], ".", color=style.DARK, ms=2.5, zorder=4)
    beyond = reach + 0.10 / size
    axes.text(beyond * x, beyond * y, f"$L_{k + 1}$", fontsize=style.FONT + 1, ha="center", va="center",
              color=style.DARK, zorder=6, bbox={"fc": "white", "ec": "none", "pad": 0.6, "alpha": 0.85})  # fmt: skip
