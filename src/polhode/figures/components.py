"""Angular velocity and momentum along the principal axes over time."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure

from polhode.exact.free_body import FreeMotion
from polhode.figures import style
from polhode.figures.free_motion import free_motion_of
from polhode.motion.inputs import finite
from polhode.motion.trajectory import Trajectory

LONGEST = 4  # periods shown; more would only blur


def draw_components(shown: FreeMotion | Trajectory) -> Figure:
    """Return components of Ω and L against time, at most the first few periods, which the figure then says."""
    motion, samples = free_motion_of(shown)
    figure = style.new_figure(height=3.4)
    upper, lower = figure.subplots(2, 1, sharex=True)
    whole = end = float(np.asarray(samples.times)[-1])
    start = float(np.asarray(samples.times)[0])
    period = finite(motion.period)
    if period is not None:
        end = min(end, start + LONGEST * period)
    words = f", the first {LONGEST} periods" if end < whole else ""
    slow = style.power_of_ten((start, end))
    times = np.linspace(start, end, 1200)
    momentum = motion.momentum(times)
    velocity = momentum / np.asarray(motion.moments)
    larger = style.magnifications(momentum)
    for axes, values, symbol, unit in ((upper, velocity, "Ω", "rad/s"), (lower, momentum, "L", "kg m²/s")):
        power = style.power_of_ten(values)
        for k in range(3):
            axes.plot(times / 10.0**slow, values[:, k] * 10.0 ** (larger[k] - power), color=style.AXIS_COLOURS[k],
                      lw=1.1, ls=("-", "--", "-.")[k], label=style.magnified(f"axis {k + 1}", larger[k]))  # fmt: skip
        axes.set_ylabel(f"{symbol}  [{style.factor(power)}{unit}]")
        axes.axhline(0.0, color=style.LIGHT, lw=0.6, zorder=0)
        axes.set_xlim(start / 10.0**slow, end / 10.0**slow)
        style.tidy(axes)
    lower.set_xlabel(f"time{words}  [{style.factor(slow)}s]")
    figure.legend(*upper.get_legend_handles_labels(), loc="outside upper center", ncols=3, fontsize=style.FONT - 1,
                  frameon=False, handlelength=2.2)  # fmt: skip
    return figure
