"""The inertia ellipsoid with its polhodes: narrow ovals about the stable axes, wide arcs past the middle one.

The point x = Ω/√(2E) of Σ I_i x_i² = 1, at which it touches the invariable plane; on the momentum sphere it is the
direction u of L, so that x = (u/I)/√(Σ u²/I). Source: Poinsot 1834; Goldstein, *Classical Mechanics*, §5.6.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.figure import Figure

from polhode.analysis.poinsot import ellipsoid_semi_axes, touching_point
from polhode.analysis.polhodes import polhode_family, separatrix
from polhode.bodies._turned import ball
from polhode.bodies.surface import Surface
from polhode.exact.free_body import FreeMotion
from polhode.figures import style
from polhode.figures.energy_levels import default_frame
from polhode.figures.free_motion import take_free_motion
from polhode.figures.scene import Scene
from polhode.motion._inputs import finite
from polhode.motion._trajectory import Trajectory
from polhode.types import Array

BODY = "#eef0f3"


def inertia_ellipsoid(shown: FreeMotion | Trajectory, *, axes: Any = None) -> Figure | None:
    """Return an oblique view of the ellipsoid, its longest semi-axis as 1, far side dimmed. None at rest.

    Args:
        shown: a free body's motion, or samples of one.
        axes: matplotlib axes to draw on; a new figure without them.

    Raises:
        InvalidInput: for the motion of anything else, or of several bodies.
    """
    motion, samples = take_free_motion(shown)
    if not motion.momentum_norm:
        return None
    moments = np.asarray(motion.moments)
    semi = ellipsoid_semi_axes(moments)
    power = style.power_of_ten(semi)
    scale = float(semi.max())
    frame, shape = default_frame(), semi / scale
    # how far its silhouette reaches to the right and up
    right, up = np.sqrt(np.sum((frame[:2] * shape) ** 2, axis=-1))
    ends = frame[:2] @ np.diag(shape + 0.30)
    reach = np.maximum([right, up], np.abs(ends).max(axis=-1)) + 0.10
    window = (-reach[0], reach[0], -up - 0.10, max(up, ends[1].max()) + 0.10)
    figure, (axes,) = style.axes_for(axes, height=style.choose_height(window, 1.0))
    scene = Scene(axes, frame, window)
    scene.solid(Surface(ball(96).vertices * shape, ball(96).faces), BODY, ambient=0.82)
    scene.finish(order=0.0)
    family = polhode_family(moments)
    for curve in family:
        scene.line(touching_point(curve, moments) / scale, style.GREY, 0.5)
    great = separatrix(moments)
    for curve in great:
        scene.line(touching_point(curve, moments) / scale, style.VERMILION, 0.9)
    own = touching_point(_own(motion, samples), moments) / scale
    _axes(scene, shape)
    scene.line(own, style.BLUE, 1.8, over=4.0)
    _direction(scene, own)
    _mark(scene, own[0])
    _legend(scene, motion.regime in ("permanent", "spherical"), bool(family), bool(great))
    sizes = ", ".join(f"{x / 10.0**power:.4g}" for x in semi)
    scene.axes.set_title(f"Inertia ellipsoid, body axes\nsemi-axes 1/√I: {sizes}  [{style.factor(power)}"
                         "(kg m²)$^{-1/2}$]", fontsize=style.FONT, color=style.DARK)
    return figure


def _own(motion: FreeMotion, samples: Trajectory) -> Array:
    """Return the direction of L (T, 3) over a period, or at the samples without one."""
    period = finite(motion.period)
    if period is None:
        return np.asarray(samples.momentum) / motion.momentum_norm
    return motion.momentum(motion.epoch + np.linspace(0.0, period, 2000)) / motion.momentum_norm


def _axes(scene: Scene, shape: Array) -> None:
    for k in range(3):
        axis = np.eye(3)[k]
        scene.line(np.linspace(-shape[k] * axis, (shape[k] + 0.16) * axis, 120), style.DARK, 0.7, dim=0.18)
        x, y, _ = scene.project((shape[k] + 0.27) * axis)
        scene.axes.text(x, y, f"$x_{k + 1}$", fontsize=style.FONT + 1, ha="center", va="center", color=style.DARK,
                        zorder=6, bbox={"fc": "white", "ec": "none", "pad": 0.6, "alpha": 0.85})


def _direction(scene: Scene, curve: Array) -> None:
    """Put heads of arrows on the visible parts of a curve, evenly along its length on the page."""
    spacing = 0.55  # of the heads of arrows, in longest semi-axes
    x, y, _ = scene.project(curve)
    length = np.concatenate([[0.0], np.cumsum(np.hypot(np.diff(x), np.diff(y)))])
    visible, count = scene.is_visible(curve), int(length[-1] / spacing + 0.5)
    for part in (np.arange(count) + 0.5) / max(count, 1):
        k = int(np.searchsorted(length, part * length[-1]))
        ahead = min(len(x) - 1, int(np.searchsorted(length, part * length[-1] + 0.012)))
        if not visible[k] or ahead == k:
            continue
        scene.axes.annotate("", (x[ahead], y[ahead]), (x[k], y[k]), zorder=5, arrowprops={
            "arrowstyle": "-|>,head_width=0.22,head_length=0.45", "color": style.BLUE, "lw": 0.8, "mutation_scale": 10,
            "shrinkA": 0, "shrinkB": 0})


def _mark(scene: Scene, point: Array) -> None:
    x, y, _ = scene.project(point)
    scene.axes.plot([x], [y], "o", ms=4, color=style.BLUE, mec="white", mew=0.6, zorder=5.5,
                    alpha=1.0 if scene.is_visible(point) else 0.4)


def _legend(scene: Scene, still: bool, family: bool, great: bool) -> None:
    dot: Any = {"marker": "o", "ls": "", "ms": 4, "mec": "white"} if still else {"lw": 1.8}
    handles = [scene.axes.plot([], [], color=style.BLUE, label="this motion", **dot)[0]]
    if great:
        handles.append(scene.axes.plot([], [], color=style.VERMILION, lw=0.9, label="separatrix")[0])
    if family:
        handles.append(scene.axes.plot([], [], color=style.GREY, lw=0.5, label="other polhodes")[0])
    scene.axes.legend(handles=handles, loc="upper center", bbox_to_anchor=(0.5, 0.0), ncols=3, frameon=False,
                      fontsize=style.FONT - 1, handlelength=1.6, columnspacing=1.2)
