"""A rolling disk's tilt and precession: in log-log towards the singularity, or against time if there is none."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.figure import Figure
from matplotlib.ticker import FormatStrFormatter, LogLocator, NullFormatter

from polhode.figures import style
from polhode.rolling.euler_disk._power_law import PowerLaw
from polhode.rolling.euler_disk.report import EulerDiskReport
from polhode.rolling.euler_disk.spin_down import SpinDown
from polhode.types import Array

COLOURS = {"end of asymptotic regime": style.GREEN}  # of events; all others end the motion


def draw_disk_end(report: EulerDiskReport) -> Figure:
    """Return tilt and rate of precession, with fits and events where the motion has a finite end."""
    spin_down, motion = report.spin_down, report.trajectory if report.laws else report.path
    states = np.asarray(motion.states)
    tilt, precession = np.degrees(motion.part("tilt")), np.asarray(report.disk.precession(states))
    figure = style.new_figure(height=3.8)
    panels = figure.subplots(2, 1, sharex=True)
    if spin_down is None or spin_down.remaining is None:
        words = "" if motion.times[-1] == report.trajectory.times[-1] else ", first turns"
        _against_time(panels, np.asarray(motion.times), (tilt, precession), words)
    else:
        _towards_the_end(panels, spin_down, (tilt, np.abs(precession)))
        figure.legend(*panels[0].get_legend_handles_labels(), loc="outside upper center", ncols=2,
                      fontsize=style.FONT - 1, frameon=False, handlelength=2.2)
    for axes, words in zip(panels, ("tilt from the plane  [°]", "precession  [rad/s]"), strict=True):
        axes.set_ylabel(words)
        style.tidy(axes)
        axes.tick_params(which="minor", width=0.4, length=1.5)
    return figure


def _against_time(panels: Any, times: Array, values: tuple[Array, Array], words: str) -> None:
    slow = style.power_of_ten((times[0], times[-1]))
    for axes, y in zip(panels, values, strict=True):
        axes.plot(times / 10.0**slow, y, color=style.BLUE, lw=1.0)
        if np.ptp(y) < 1e-6 * np.abs(y).max():  # steady: rounding is not to fill the panel
            middle = float(np.mean(y))
            axes.set_ylim(*sorted((0.9 * middle, 1.1 * middle)))
    panels[1].set_xlim(times[0] / 10.0**slow, times[-1] / 10.0**slow)
    panels[1].set_xlabel(f"time{words}  [{style.factor(slow)}s]")


def _towards_the_end(panels: Any, spin_down: SpinDown, values: tuple[Array, Array]) -> None:
    """Draw against t0 − t, which decreases to the right."""
    margin = 3.0  # factor by which a panel reaches beyond what comes before the fall
    left = np.asarray(spin_down.remaining)
    ahead = left > 0.0
    fitted = spin_down.late
    for axes, y, fit in zip(panels, values, (spin_down.tilt, spin_down.precession), strict=True):
        axes.loglog(left[ahead], y[ahead], color=style.BLUE, lw=1.2, label="motion")
        x, line = _fit(left[fitted], y[fitted], fit, left[ahead].min())
        axes.loglog(x, line, color=style.ORANGE, lw=1.1, ls="--", label="fitted power law", zorder=4)
        sign = "−" if fit.exponent < 0 else ""
        axes.text(0.03, 0.08 if fit.exponent > 0 else 0.92, f"exponent {sign}{abs(fit.exponent):.3f}",
                  transform=axes.transAxes, fontsize=style.FONT - 1, va="bottom" if fit.exponent > 0 else "top",
                  color=style.DARK)
        axes.axvspan(left[fitted].max(), left[fitted].min(), color=style.LIGHT, alpha=0.35, lw=0,
                     label="samples fitted")
        for name, time in spin_down.events.items():
            _mark(axes, name, time, spin_down)
        before = y[np.asarray(spin_down.trajectory.times) <= min(spin_down.events.values(), default=np.inf)]
        axes.set_ylim(before.min() / margin, before.max() * margin)
        axes.yaxis.set_major_locator(LogLocator(10, subs=(1.0, 3.0)))
        axes.yaxis.set_major_formatter(FormatStrFormatter("%g"))
        axes.yaxis.set_minor_formatter(NullFormatter())
    panels[1].set_xlim(left[ahead].max(), left[ahead].min() / 1.5)
    panels[1].set_xlabel("t$_0$ − t  [s]")


def _mark(axes: Any, name: str, time: float, spin_down: SpinDown) -> None:
    """Mark an event; one after t0 is outside the axes, so only the legend names it."""
    k = int(np.argmin(np.abs(np.asarray(spin_down.trajectory.times) - time)))
    left = float(np.asarray(spin_down.remaining)[k])
    colour = COLOURS.get(name, style.VERMILION)
    if left > 0.0:
        axes.axvline(left, color=colour, lw=1.0, ls=":" if name in COLOURS else "-.", label=name)
    else:
        axes.plot([], [], color=colour, lw=1.0, ls="-.", label=f"{name}: {-left:.2g} s after t$_0$")


def _fit(x: Array, y: Array, fit: PowerLaw, end: float) -> tuple[Array, Array]:
    """Return the fitted power law from where it was fitted to the end."""
    middle = np.mean(np.log(y)) - fit.exponent * np.mean(np.log(x))
    reach = np.geomspace(x.max(), end, 100)
    return reach, np.exp(middle + fit.exponent * np.log(reach))
