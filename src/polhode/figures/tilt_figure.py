"""A top's tilt and angular velocity over time."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.figure import Figure

from polhode.figures import style
from polhode.figures.top_shown import TopShown, take_top
from polhode.motion._inputs import finite
from polhode.motion._trajectory import Trajectory

if TYPE_CHECKING:
    from polhode.exact.lagrange_top import LagrangeMotion


def top_motion(shown: LagrangeMotion | Trajectory, *, axes: Any = None) -> Figure:
    """Return a top's tilt and the components of its Ω along the principal axes against time.

    Args:
        shown: a Lagrange top's motion, or samples of a top's motion.
        axes: two of matplotlib's, for tilt and Ω; a new figure without them.

    Raises:
        InvalidInput: for the motion of anything else, or of several tops.
    """
    lost = 0.1  # of the largest rate: curves smaller than this are enlarged, their fast swings being a band else
    even = 0.5  # degrees on either side of a tilt that is constant
    times, tilt, velocity, words = _series(take_top(shown))
    figure, (upper, lower) = style.axes_for(axes, 2, height=3.4)
    slow = style.power_of_ten((times[0], times[-1]))
    upper.plot(times / 10.0**slow, np.degrees(tilt), color=style.DARK, lw=1.1)
    style.show_constant(upper, np.degrees(tilt), even)
    upper.set_ylabel("tilt of the axis  [°]")
    power = style.power_of_ten(velocity)
    larger = style.magnifications(velocity, lost)
    for k in range(3):
        lower.plot(times / 10.0**slow, velocity[:, k] * 10.0 ** (larger[k] - power), color=style.AXIS_COLOURS[k],
                   lw=1.0, ls=("-", "--", "-.")[k], label=style.magnify(f"axis {k + 1}", larger[k]))
    lower.set_ylabel(f"Ω  [{style.factor(power)}rad/s]")
    style.label_time((upper, lower), f"time{words}  [{style.factor(slow)}s]")
    for panel in (upper, lower):
        panel.set_xlim(times[0] / 10.0**slow, times[-1] / 10.0**slow)
        style.tidy(panel)
    style.legend_above(upper, axes, *lower.get_legend_handles_labels())
    return figure


def _series(top: TopShown) -> tuple[np.ndarray, np.ndarray, np.ndarray, str]:
    # of the body about its axis shown at most, so that each swing of Ω is visible, but one nutation at least
    most_turns = 30
    most_periods = 6  # nutations or swings shown where there are more
    all_swings = 12  # up to which all swings are shown
    times = np.asarray(top.trajectory.times)
    exact = top.exact
    if exact is not None:
        period = finite(exact.nutation_period)
        end, words = times[-1], ""
        turns = abs(finite(exact.spin_per_period) or 0.0) / (2.0 * np.pi)
        count = int(np.clip(most_turns / turns, 1, most_periods)) if turns else most_periods
        if period is not None and times[-1] - times[0] > count * period:
            end = times[0] + count * period
            nutations = f"first {count} nutations" if count > 1 else "first nutation"
            words = f", first {end - times[0]:.3g} s" if top.constant_tilt else f", {nutations}"
        times = np.linspace(times[0], end, 2000)
        attitude, momentum = exact.state(times)
        w, x, y, z = (attitude[:, k] for k in range(4))
        return times, 2.0 * np.arctan2(np.hypot(x, y), np.hypot(w, z)), np.asarray(momentum / exact.moments), words
    axis = top.axis_in_space
    tilt = np.arctan2(np.hypot(axis[:, 0], axis[:, 1]), axis[:, 2])
    highest = np.flatnonzero((tilt[1:-1] > tilt[:-2]) & (tilt[1:-1] >= tilt[2:])) + 1
    end, words = len(times), ""
    if len(highest) > all_swings:
        end, words = int(highest[most_periods]) + 1, f", first {most_periods} swings"
    return times[:end], tilt[:end], np.asarray(top.trajectory.angular_velocity)[:end], words
