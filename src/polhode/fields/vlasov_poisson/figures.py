"""The figures of a plasma: its field over time, and its electrons in phase space."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure
from scipy.interpolate import LinearNDInterpolator
from scipy.spatial import QhullError

from polhode.fields.vlasov_poisson.answers import PlasmaReport
from polhode.figures import style
from polhode.types import Array


def draw_field(report: PlasmaReport) -> Figure:
    """Return the amplitude of the longest wave against time, with the prediction of linear theory."""
    figure = style.new_figure(height=0.85 * style.COLUMN)
    axes = figure.subplots()
    times, field = np.asarray(report.trajectory.times), report.field
    axes.semilogy(times, np.where(field > 0.0, field, np.nan), color=style.BLUE, lw=1.0, label="run")
    wave = report.wave
    if wave is not None:
        size = abs(report.table.amplitude) * wave.response * (1.0 if wave.frequency else 0.5)
        with np.errstate(over="ignore"):
            line = size * np.exp(wave.growth * times)
        inside = line < 3.0 * field.max()
        axes.semilogy(times[inside], line[inside], "--", color=style.VERMILION, lw=1.0, label="linear theory")
    if report.recurrence_time < times[-1]:
        axes.axvline(report.recurrence_time, color=style.GREY, lw=0.8, ls=":", label="velocities in step again")
    largest = float(field.max())
    axes.set(xlim=(0.0, times[-1]), ylim=(max(0.5 * float(field[field > 0.0].min()), 1e-8 * largest), 3.0 * largest))
    axes.set_xlabel("time  [1/ω$_p$]")
    axes.set_ylabel("field, longest wave")
    axes.legend(fontsize=style.FONT - 1, frameon=False)
    style.tidy(axes)
    return figure


def draw_phase_space(report: PlasmaReport) -> Figure:
    """Return f at start, middle and end: each particle keeps its value."""
    states = np.asarray(report.trajectory.states)
    chosen = sorted({0, len(states) // 2, len(states) - 1})
    figure = style.new_figure(width=style.COLUMN * 0.7 * len(chosen), height=0.95 * style.COLUMN)
    panels = np.atleast_1d(figure.subplots(1, len(chosen), sharey=True))
    values = report.distribution(states[0])
    length = float(report.system.length)
    shown = 5.0  # spreads of the fastest beam that are shown
    fastest = min(report.fastest, max(abs(beam.drift) + shown * beam.spread for beam in report.beams))
    for axes, k in zip(panels, chosen, strict=True):
        try:
            density = _grid_density(states[k], values, length, fastest)
            axes.imshow(density, extent=(0.0, length, -fastest, fastest), origin="lower", aspect="auto", cmap="viridis",
                        vmin=0.0, vmax=float(values.max()), interpolation="nearest")
        except QhullError:  # particles of one velocity span no area between them
            axes.plot(np.mod(states[k][:, 1], length), states[k][:, 0], ",", color=style.BLUE)
            axes.set(xlim=(0.0, length), ylim=(-fastest, fastest))
        axes.set_title(f"t = {float(report.trajectory.times[k]):.4g}", fontsize=style.FONT)
        axes.set_xlabel("x  [λ$_D$]")
    panels[0].set_ylabel("v  [v$_{th}$]")
    return figure


def _grid_density(state: Array, values: Array, length: float, fastest: float) -> Array:
    """Return f (rows of v, columns of x) between the particles that are nearest, the box closed."""
    v, x = state[:, 0], np.mod(state[:, 1], length)
    near = 0.15 * length
    left, right = x > length - near, x < near
    points = np.column_stack([
        np.concatenate([x, x[left] - length, x[right] + length]) / length,
        np.concatenate([v, v[left], v[right]]) / fastest,
    ])  # fmt: skip
    rows, columns = 240, 160
    across = (np.arange(columns) + 0.5) / columns
    up = 2.0 * (np.arange(rows) + 0.5) / rows - 1.0
    interpolated = LinearNDInterpolator(points, np.concatenate([values, values[left], values[right]]), fill_value=0.0)
    return interpolated(*np.meshgrid(across, up))


FIGURES = {"field": draw_field, "phase_space": draw_phase_space}
