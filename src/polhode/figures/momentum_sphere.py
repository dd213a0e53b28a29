"""The momentum sphere with its family of polhodes, the separatrix and the motion at hand."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.figure import Figure

from polhode.exact.free_body import FreeMotion
from polhode.figures import style
from polhode.report import Report

Array = Any
VIEW = np.array([0.80, 0.46, 0.38]) / np.linalg.norm([0.80, 0.46, 0.38])
POLHODES = (0.08, 0.25, 0.5, 0.75)  # of the way from an axis to the separatrix


def draw_momentum_sphere(report: Report) -> Figure | None:
    """Return the sphere |L| = const seen obliquely, far side dimmed; axes are the principal ones. None at rest."""
    norm = report.motion.momentum_norm
    if not norm:
        return None
    figure = style.new_figure()
    axes = figure.add_subplot()
    moments = np.asarray(report.motion.moments)
    frame = _view_frame()
    circle = np.linspace(0.0, 2.0 * np.pi, 400)
    axes.fill(np.cos(circle), np.sin(circle), color="#f4f4f4", zorder=-5)
    axes.plot(np.cos(circle), np.sin(circle), color=style.LIGHT, lw=0.8)
    family = _family(moments)
    for curve in family:
        _draw(axes, frame, curve, style.GREY, 0.5)
    for curve in _separatrix(moments):
        _draw(axes, frame, curve, style.VERMILION, 0.9)
    unit, span = np.asarray(report.trajectory.momentum) / norm, report.motion.period
    if span is not None:
        unit = report.motion.momentum(np.linspace(0.0, span, 2000)) / norm
    _draw(axes, frame, unit, style.BLUE, 1.8)
    _mark(axes, frame, unit[0])
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
    axes.set_aspect("equal")
    axes.set_xlim(-1.36, 1.36)
    axes.set_ylim(-1.3, 1.36)
    axes.axis("off")
    return figure


def _view_frame() -> Array:
    """Return right, up and towards the viewer as rows; the third axis points up the page."""
    right = np.cross([0.0, 0.0, 1.0], VIEW)
    right = right / np.linalg.norm(right)
    return np.stack([right, np.cross(VIEW, right), VIEW])


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


def _draw(axes: Any, frame: Array, curve: Array, colour: str, width: float) -> None:
    x, y, depth = frame @ curve.T
    for front in (False, True):
        seen = (depth >= 0.0) == front
        # keep one neighbour so that both halves meet at the rim
        wide = seen | np.roll(seen, 1)
        axes.plot(np.where(wide, x, np.nan), np.where(wide, y, np.nan), color=colour, lw=width,
                  alpha=1.0 if front else 0.25, zorder=3 if front else 1, solid_capstyle="round")  # fmt: skip


def _mark(axes: Any, frame: Array, point: Array) -> None:
    x, y, depth = frame @ point
    axes.plot([x], [y], "o", ms=4, color=style.BLUE, mec="white", mew=0.6, zorder=5, alpha=1.0 if depth >= 0 else 0.4)


def _label(axes: Any, frame: Array, k: int) -> None:
    x, y, _ = frame @ np.eye(3)[k]
    size = np.hypot(x, y)
    reach = 1.0 + 0.12 / size
    axes.plot([x, reach * x], [y, reach * y], color=style.DARK, lw=0.7, zorder=4)
    axes.plot([x], [y], ".", color=style.DARK, ms=2.5, zorder=4)
    beyond = reach + 0.10 / size
    axes.text(beyond * x, beyond * y, f"$L_{k + 1}$", fontsize=style.FONT + 1, ha="center", va="center",
              color=style.DARK, zorder=6, bbox={"fc": "white", "ec": "none", "pad": 0.6, "alpha": 0.85})  # fmt: skip
