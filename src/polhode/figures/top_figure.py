"""The top on its pivot, with the paths of its axis and its angular velocity, and the forces on it."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.figure import Figure

from polhode import rotation
from polhode.bodies._turned import revolve
from polhode.bodies.surface import Surface, box_in_place
from polhode.figures import style
from polhode.figures.scene import Scene, circle_about, draw_cone
from polhode.figures.sphere import view_frame
from polhode.figures.top_shown import Followed, TopShown, sample_axis, take_top
from polhode.motion._trajectory import Trajectory
from polhode.types import Array

if TYPE_CHECKING:
    from polhode.exact.lagrange_top import LagrangeMotion

ELEVATION = np.radians(20.0)
TURNED = np.radians(20.0)  # of the lean, from across the line of sight towards the viewer
BEYOND = 1.22  # length of the axis drawn, in the body's reach
L_LONG, OMEGA_LONG = 1.5, 1.38  # arrows, in the body's reach
STEADY = np.radians(1.0)  # nutation below which the cones of Ω are those of steady precession
WOOD, STAND = "#d9c9a8", "#b4b4b4"


def spinning_top(
    shown: LagrangeMotion | Trajectory, *, surface: Surface | None = None, axes: Any = None
) -> Figure | None:
    """Return the top where it leans most, with the cone its axis describes; in steady precession with the cones of Ω.

    None for bodies without weight.

    Args:
        shown: a Lagrange top's motion, or samples of a top's motion.
        surface: what the top looks like, in the given axes of a trajectory that has a frame, else along the principal
            axes about the fixed point [m]. Without it the box of the same inertia is drawn; where the frame or the
            mass for it is missing, a top as toyshops have it, which the title says.
        axes: matplotlib axes to draw on; a new figure without them.

    Raises:
        InvalidInput: for the motion of anything else, or of several tops.
    """
    top = take_top(shown)
    if top.weightless:
        return None
    solid, arm, words = _solid(top, surface)
    path = sample_axis(top)
    k = int(np.argmin(path.axis[:, 2]))
    placed = _turn_surface(solid, path.attitude[k])
    reach = float(np.linalg.norm(placed.vertices, axis=-1).max())
    placed = Surface(placed.vertices / reach, placed.faces)
    axis = path.axis[k]
    ground = min(0.0, float(placed.vertices[:, 2].min()) - 0.04)
    frame = _view(axis)
    window = _window(frame, path, k, ground, placed)
    figure, (axes,) = style.axes_for(axes, height=style.choose_height(window))
    scene = Scene(axes, frame, window)
    _draw_ground(scene, ground)
    scene.solid(placed, WOOD)
    scene.finish(order=1.5)
    if ground < 0.0:
        scene.line(np.linspace([0.0, 0.0, ground], [0.0, 0.0, 0.0], 40), STAND, 3.0, dim=0.4, over=1.6)
    handles = _cones(scene, path, k)
    scene.line(np.linspace([0.0, 0.0, 0.0], [0.0, 0.0, BEYOND], 80), style.GREY, 0.7, form=(0, (6, 2, 1, 2)), dim=0.4)
    scene.line(np.linspace(0.0 * axis, BEYOND * axis, 80), style.DARK, 0.9, form=(0, (6, 2, 1, 2)), dim=0.5)
    scene.line(BEYOND * path.axis, style.BLUE, 1.1, over=3.5)
    _arrows(scene, path, k, arm / reach * axis)
    handles.insert(0, scene.axes.plot([], [], color=style.BLUE, lw=1.1, label="tip of the axis")[0])
    scene.axes.legend(handles=handles, loc="upper center", bbox_to_anchor=(0.5, 0.0), ncols=2, frameon=False,
                      fontsize=style.FONT - 1, handlelength=1.6, columnspacing=1.4)
    lean = np.degrees(np.arccos(np.clip(axis[2], -1.0, 1.0)))
    part = ", precessing steadily" if _is_steady(path) else path.words
    scene.axes.set_title(f"Top leaning by {lean:.3g}°{part}{words}", fontsize=style.FONT, color=style.DARK)
    return figure


def _solid(top: TopShown, surface: Surface | None) -> tuple[Surface, float, str]:
    """Return the surface, along the principal axes, the distance of its centre of mass, and words for the title."""
    # radius, height
    profile = ((0.0, 0.0), (0.08, 0.1), (0.5, 0.52), (0.5, 0.62), (0.07, 0.7), (0.06, 1.0), (0.0, 1.0))
    center = 0.52
    frame = top.trajectory.frame
    if frame is not None and (solid := surface or box_in_place(frame)) is not None:
        return solid.along(frame), float(np.linalg.norm(np.asarray(frame.center_of_mass) - frame.origin)), ""
    if surface is not None:
        return surface, 0.5 * float(np.linalg.norm(np.asarray(surface.vertices), axis=-1).max()), ""
    toy = revolve(profile)
    upright = rotation.shortest_between(np.array([0.0, 0.0, 1.0]), top.axis)
    return Surface(rotation.rotate(upright, toy.vertices), toy.faces), center, "; its shape is not known"


def _turn_surface(surface: Surface, attitude: Array) -> Surface:
    return Surface(rotation.rotate(attitude, np.asarray(surface.vertices)), surface.faces)


def _view(axis: Array) -> Array:
    """Return the frame in which the axis leans to the right of the page, and a little towards the viewer."""
    lean = np.arctan2(axis[1], axis[0]) if np.hypot(axis[0], axis[1]) > 1e-9 else 0.0
    towards = lean - 0.5 * np.pi + TURNED
    flat = np.cos(ELEVATION)
    return view_frame(np.array([flat * np.cos(towards), flat * np.sin(towards), np.sin(ELEVATION)]))


def _window(frame: Array, path: Followed, k: int, ground: float, placed: Surface) -> tuple[float, float, float, float]:
    foot = np.array([0.0, 0.0, ground]) + circle_about(np.array([0.0, 0.0, 1.0]), 0.5 * np.pi, 0.6)
    ends = [BEYOND * path.axis, placed.vertices, foot, [[0.0, 0.0, BEYOND]]]
    for vector, long in ((path.momentum[k], L_LONG), (path.velocity[k], OMEGA_LONG)):
        ends.append(long * vector[None] / (np.linalg.norm(vector) or 1.0))
    right, up, _ = frame @ np.vstack(ends).T
    pad = 0.15
    return right.min() - pad, right.max() + pad, up.min() - 0.5 * pad, up.max() + pad


def _draw_ground(scene: Scene, height: float) -> None:
    rim = np.array([0.0, 0.0, height]) + circle_about(np.array([0.0, 0.0, 1.0]), 0.5 * np.pi, 0.55)
    x, y, _ = scene.project(rim)
    scene.axes.fill(x, y, color="#ececec", lw=0, zorder=0.2)


def _cones(scene: Scene, path: Followed, k: int) -> list[Any]:
    """Draw the cones and return their handles."""
    slant = 0.95  # of these cones
    up, axis = np.array([0.0, 0.0, 1.0]), path.axis[k]
    tilts, steady = _tilts(path), _is_steady(path)
    limits = [float(tilts.mean())] if steady else [float(tilts.min()), float(tilts.max())]
    handles = []
    for tilt in limits:
        if STEADY < tilt < np.pi - STEADY:
            draw_cone(scene, up, tilt, BEYOND, style.SEPARATRIX, 0.08)
    words = "cone of its precession" if steady else "cones at its least and largest tilt"
    handles.append(scene.axes.plot([], [], color=style.SEPARATRIX, lw=0.9, label=words)[0])
    speed = np.linalg.norm(path.velocity[k])
    if steady and speed > 0.0:
        omega = path.velocity[k] / speed
        for about, colour, words in ((up, style.HERPOLHODE, "space cone of Ω"),
                                     (axis, style.BODY_CONE, "body cone of Ω")):
            half = float(np.arctan2(np.linalg.norm(np.cross(about, omega)), about @ omega))
            draw_cone(scene, about, half, slant, colour)
            handles.append(scene.axes.plot([], [], color=colour, lw=0.9, label=words)[0])
    return handles


def _tilts(path: Followed) -> Array:
    return np.arccos(np.clip(path.axis[:, 2], -1.0, 1.0))


def _is_steady(path: Followed) -> bool:
    tilts = _tilts(path)
    return bool(np.ptp(tilts) < STEADY and STEADY < tilts.mean() < np.pi - STEADY)


def _arrows(scene: Scene, path: Followed, k: int, center: Array) -> None:
    """Draw Ω, L about the pivot and the weight; their lengths are not to scale with each other."""
    right, up, _ = scene.frame @ path.axis[k]
    across = np.array([-up, right]) / (np.hypot(right, up) or 1.0)
    for vector, colour, name, long, side in ((path.momentum[k], style.MOMENTUM, "L", L_LONG, 9.0),
                                             (path.velocity[k], style.VELOCITY, "Ω", OMEGA_LONG, -9.0)):
        size = np.linalg.norm(vector)
        if size > 0.0:
            scene.arrow(np.zeros(3), long * vector / size, colour, name, side=side * across)
    scene.arrow(center, center - np.array([0.0, 0.0, 0.45]), style.WEIGHT, "mg")
