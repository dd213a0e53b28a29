"""Where a top's axis points: its path on the sphere, between the circles that bound it."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from matplotlib.figure import Figure

from polhode import rotation
from polhode.figures import style
from polhode.figures.sphere import draw_curve, mark_point, sphere_axes, view_frame
from polhode.motion.inputs import finite
from polhode.reports.top import TopReport
from polhode.types import Array, Float64

VIEW = (0.62, -0.62, 0.48)
PERIODS = 4  # drawn at most
SAMPLES = 6000


def draw_axis_locus(report: TopReport) -> Figure:
    """Return the path of the axis on the unit sphere, space axes, up on the page."""
    figure = style.new_figure()
    axes = sphere_axes(figure)
    frame = view_frame(VIEW)
    path = followed(report)
    curve, limits = path.axis, path.limits
    kind = ", space axes"
    if report.exact is not None:
        kind = ": steady precession" if report.constant_tilt else f": {report.exact.regime}"
    for height in limits:
        turn = np.linspace(0.0, 2.0 * np.pi, 400)
        radius = np.sqrt(max(0.0, 1.0 - height * height))
        circle = np.stack([radius * np.cos(turn), radius * np.sin(turn), np.full(400, height)], axis=-1)
        draw_curve(axes, frame, circle, style.VERMILION, 0.7)
    draw_curve(axes, frame, curve, style.BLUE, 1.2)
    mark_point(axes, frame, curve[0])
    up = frame @ np.array([0.0, 0.0, 1.0])
    axes.annotate("", (1.22 * up[0], 1.22 * up[1]), (up[0], up[1]),
                  arrowprops={"arrowstyle": "->", "color": style.DARK, "lw": 0.8})  # fmt: skip
    axes.text(1.28 * up[0], 1.28 * up[1], "up", fontsize=style.FONT, ha="center", va="bottom", color=style.DARK)
    handles = [axes.plot([], [], color=style.BLUE, lw=1.2, label="axis of the top")[0]]
    if limits:
        handles.append(axes.plot([], [], color=style.VERMILION, lw=0.7, label="limits of its tilt")[0])
    axes.legend(handles=handles, loc="upper center", bbox_to_anchor=(0.5, -0.01), ncols=2, fontsize=style.FONT - 1,
                frameon=False, handlelength=1.6)  # fmt: skip
    axes.set_title(f"Path of the axis{kind}{path.words}", fontsize=style.FONT, color=style.DARK)
    return figure


class Followed(NamedTuple):
    """The part of a top's motion that is drawn, space axes.

    Attributes:
        attitude: (T, 4).
        axis: (T, 3) unit vector from the pivot to the centre of mass.
        momentum: (T, 3) about the pivot [kg m²/s].
        velocity: (T, 3) angular velocity [rad/s].
        limits: heights of the circles that bound the axis, where known.
        words: which part it is, beginning with a comma; empty for all of it.
    """

    attitude: Float64[Array, "time 4"]
    axis: Float64[Array, "time 3"]
    momentum: Float64[Array, "time 3"]
    velocity: Float64[Array, "time 3"]
    limits: list[float]
    words: str


def followed(report: TopReport) -> Followed:
    """Return the first nutations of a Lagrange top, finely sampled, or all samples of another one."""
    exact = report.exact
    if exact is None:
        motion = report.trajectory
        attitude = np.asarray(motion.attitude)
        momentum = rotation.rotate(attitude, np.asarray(motion.momentum))
        velocity = rotation.rotate(attitude, np.asarray(motion.angular_velocity))
        return Followed(attitude, report.axis_in_space, momentum, velocity, [], "")
    start, end = float(report.trajectory.times[0]), float(report.trajectory.times[-1])
    words = ""
    period = finite(exact.nutation_period)
    if period is not None and end - start > PERIODS * period:
        end = start + PERIODS * period
        words = f", first {end - start:.3g} s" if report.constant_tilt else f", first {PERIODS} nutations"
    attitude, momentum = exact.state(np.linspace(start, end, SAMPLES))
    # at constant tilt the path itself is the circle
    limits = [] if report.constant_tilt else [x for x in exact.nutation_limits if x is not None and abs(x) < 1.0]
    up, L, omega = (rotation.rotate(attitude, v) for v in ([0.0, 0.0, 1.0], momentum, momentum / exact.moments))
    return Followed(attitude, up, L, omega, limits, words)
