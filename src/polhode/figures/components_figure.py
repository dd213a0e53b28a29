"""Angular velocity and momentum along the principal axes over time."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.figure import Figure

from polhode.exact.free_body import FreeMotion
from polhode.figures import style
from polhode.figures.free_motion import take_free_motion
from polhode.motion._inputs import finite
from polhode.motion._trajectory import Trajectory


def components(shown: FreeMotion | Trajectory, *, axes: Any = None) -> Figure:
    """Return components of Ω and L against time, at most the first few periods, which the figure then says.

    Args:
        shown: a free body's motion, or samples of one.
        axes: two of matplotlib's, for Ω and L; a new figure without them.

    Raises:
        InvalidInput: for the motion of anything else, or of several bodies.
    """
    periods = 4  # shown; more would only blur
    motion, samples = take_free_motion(shown)
    figure, (upper, lower) = style.axes_for(axes, 2, height=3.4)
    whole = end = float(np.asarray(samples.times)[-1])
    start = float(np.asarray(samples.times)[0])
    period = finite(motion.period)
    if period is not None:
        end = min(end, start + periods * period)
    words = f", the first {periods} periods" if end < whole else ""
    slow = style.power_of_ten((start, end))
    times = np.linspace(start, end, 1200)
    momentum = motion.momentum(times)
    velocity = momentum / np.asarray(motion.moments)
    larger = style.magnifications(momentum)
    for panel, values, symbol, unit in ((upper, velocity, "Ω", "rad/s"), (lower, momentum, "L", "kg m²/s")):
        power = style.power_of_ten(values)
        for k in range(3):
            panel.plot(times / 10.0**slow, values[:, k] * 10.0 ** (larger[k] - power), color=style.AXIS_COLOURS[k],
                       lw=1.1, ls=("-", "--", "-.")[k], label=style.magnify(f"axis {k + 1}", larger[k]))
        panel.set_ylabel(f"{symbol}  [{style.factor(power)}{unit}]")
        panel.axhline(0.0, color=style.LIGHT, lw=0.6, zorder=0)
        panel.set_xlim(start / 10.0**slow, end / 10.0**slow)
        style.tidy(panel)
    style.label_time((upper, lower), f"time{words}  [{style.factor(slow)}s]")
    style.legend_above(upper, axes, *upper.get_legend_handles_labels())
    return figure
