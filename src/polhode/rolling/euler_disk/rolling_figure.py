"""A rolling disk on its plane in perspective, several times, with the paths of its contact and its centre."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.figure import Figure

from polhode import rotation
from polhode.bodies.surface import Surface
from polhode.figures import style
from polhode.figures.scene import Scene, circle_about
from polhode.figures.sphere import view_frame
from polhode.rolling.euler_disk.report import EulerDiskReport
from polhode.rolling.euler_disk.system import LAYOUT
from polhode.rolling.euler_disk.turns import DiskPath
from polhode.spec.surfaces import surface_of_disk
from polhode.types import Array

EYE = 9.0  # distance of the eye, in half-widths of the picture
STEEL, PLANE = "#b9c4d0", "#f3f1ec"


def draw_rolling_disk(report: EulerDiskReport) -> Figure:
    """Return the disk from its first position, faint, to its last visible one, with the paths of contact and centre."""
    faintest = 0.35
    a = report.table.radius
    times, states = _choose_moments(report)
    placed = [_disk(report, state) for state in states]
    first, last = _paths(report)
    centers = np.asarray(report.disk.center(np.asarray(report.path.states)))
    everything = np.vstack([surface.vertices for surface in placed])
    middle = 0.5 * (everything.min(axis=0) + everything.max(axis=0)) * [1.0, 1.0, 0.0]
    half = float(np.abs((everything - middle)[:, :2]).max())
    placing = lambda points: (np.asarray(points) - middle) / half  # noqa: E731
    frame = view_frame(np.array([0.0, -0.88, 0.48]))
    plane = _plane(placing(_flat(last)), a / half)
    window = _window(frame, [placing(surface.vertices) for surface in placed] + [plane])
    figure = style.new_figure(height=style.choose_height(window, 1.0))
    axes = figure.add_subplot()
    ground = Scene(axes, frame, window, EYE)
    x, y, _ = ground.project(plane)
    axes.fill(x, y, color=PLANE, ec=style.LIGHT, lw=0.5, zorder=0.1)
    strengths = np.geomspace(faintest, 1.0, len(placed))
    scene = ground
    for k, (surface, strength) in enumerate(zip(placed, strengths, strict=True)):
        scene = Scene(axes, frame, window, EYE)
        scene.solid(Surface(placing(surface.vertices), surface.faces), STEEL)
        scene.finish(strength, 1.0 + 0.1 * k)
    handles = []
    if first is not None:
        scene.line(placing(_flat(first)), style.GREY, 0.9, form=(0, (4, 2)), dim=0.5, over=2.5)
        handles.append(axes.plot([], [], color=style.GREY, lw=0.9, ls=(0, (4, 2)), label="contact, first turn")[0])
    scene.line(placing(_flat(last)), style.BLUE, 1.2, dim=0.45, over=2.6)
    scene.line(placing(centers), style.VERMILION, 1.2, dim=0.8, over=2.7)
    x, y, _ = scene.project(placing(_flat(DiskPath(times, states, report.path.outcome).contact[-1:])))
    axes.plot(x, y, "o", ms=4, color=style.BLUE, mec="white", mew=0.6, zorder=6)
    x, y, _ = scene.project(placing(np.asarray(report.disk.center(states[-1:]))))
    axes.plot(x, y, "o", ms=4, color=style.VERMILION, mec="white", mew=0.6, zorder=6)
    words = "" if report.opening is None else ", last turns"
    handles.append(axes.plot([], [], color=style.BLUE, lw=1.2, label=f"contact{words}")[0])
    handles.append(axes.plot([], [], color=style.VERMILION, lw=1.2, marker="o", ms=3.5, label=f"centre{words}")[0])
    _scale_bar(scene, placing, last, a)
    axes.legend(handles=handles, loc="upper center", bbox_to_anchor=(0.5, 0.0), ncols=2, frameon=False,
                fontsize=style.FONT - 1, handlelength=1.8, columnspacing=1.0)
    axes.set_title(_words(times, np.degrees(LAYOUT.part(states, "tilt"))), fontsize=style.FONT, color=style.DARK)
    return figure


def _words(times: Array, tilts: Array) -> str:
    """Return a title with the times and tilts of the positions."""
    slow = style.power_of_ten((times[0], times[-1]))
    clock = [f"{x / 10.0**slow:.3g}" for x in times]
    unit = f"[{style.factor(slow)}s]"
    if np.ptp(tilts) < 0.05:
        every = f"{times[1] / 10.0**slow:.3g} {style.factor(slow)}s" if len(times) > 1 else unit
        return f"Rolling disk tilted by {tilts[0]:.3g}°, every {every}"
    return f"Rolling disk tilted by {', '.join(f'{x:.1f}°' for x in tilts)}\nat times {', '.join(clock)}  {unit}"


def _choose_moments(report: EulerDiskReport) -> tuple[Array, Array]:
    """Return times (n,) and states (n, 8): while it falls, at tilts evenly spread; else evenly in time."""
    going_round = 8  # positions
    falling = 5
    if report.opening is not None:
        motion: Any = report.trajectory
        states, tilts = np.asarray(motion.states), np.asarray(motion.part("tilt"))
        index = [int(np.argmin(np.abs(tilts - tilt))) for tilt in tilts[0] * np.linspace(1.0, 0.0, falling)]
    else:
        motion = report.path
        states = np.asarray(motion.states)
        # not all round a closed path, where the last would cover the first
        index = np.linspace(0, 0.85 * (len(states) - 1), going_round).astype(int)
    index = sorted(set(int(k) for k in index))
    return np.asarray(motion.times)[index], states[index]


def _paths(report: EulerDiskReport) -> tuple[Array | None, Array]:
    """Return the state of the contact's first turn, if it differs from later ones, and its path (T, 2) [m]."""
    opening = None if report.opening is None else report.opening.contact
    return opening, report.path.contact


def _disk(report: EulerDiskReport, state: Array) -> Surface:
    """Return the disk's surface in space [m]."""
    pieces = 96  # of the rim
    vertices, faces = surface_of_disk(report.table.radius, report.table.thickness, pieces)
    attitude = np.asarray(report.disk.vectors(state).attitude)
    return Surface(rotation.rotate(attitude, vertices) + np.asarray(report.disk.center(state)), faces)


def _flat(path: Array) -> Array:
    return np.concatenate([path, np.zeros((len(path), 1))], axis=-1)


def _window(frame: Array, clouds: list[Array]) -> tuple[float, float, float, float]:
    depth = np.vstack(clouds) @ frame.T
    scale = EYE / (EYE - depth[:, 2])
    right, up = depth[:, 0] * scale, depth[:, 1] * scale
    pad = 0.05
    return right.min() - pad, right.max() + pad, up.min() - pad, up.max() + pad


def _plane(path: Array, radius: float) -> Array:
    """Return the edge (n, 3) of a round piece of the plane under the path."""
    middle = 0.5 * (path.min(axis=0) + path.max(axis=0))
    wide = 0.5 * float(np.ptp(path[:, :2], axis=0).max()) + 0.45 * radius
    return middle + circle_about(np.array([0.0, 0.0, 1.0]), 0.5 * np.pi, wide)


def _scale_bar(scene: Scene, placing: Any, path: Array, radius: float) -> None:
    """Draw a length on the plane, before the path, and say how long it is."""
    power = 10.0 ** np.floor(np.log10(radius))
    length = power * max(k for k in (1.0, 2.0, 5.0) if k * power <= radius)
    middle, front = path.mean(axis=0), path[:, 1].min() - 0.12 * radius
    ends = placing(np.array([[middle[0] - 0.5 * length, front, 0.0], [middle[0] + 0.5 * length, front, 0.0]]))
    x, y, _ = scene.project(ends)
    scene.axes.plot(x, y, color=style.DARK, lw=1.4, solid_capstyle="butt", zorder=6)
    scene.axes.annotate(f"{1e3 * length:g} mm", (x.mean(), y.mean()), (0.0, -3.0), textcoords="offset points",
                        ha="center", va="top", fontsize=style.FONT - 1, color=style.DARK, zorder=6)
