"""Fits of throws: data against fit, residuals, the polhode through the data, and how errors of the ratios correlate."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Any

import numpy as np
from matplotlib.figure import Figure

from polhode._base import check
from polhode.analysis.polhodes import polhode_family, separatrix
from polhode.estimation._estimate import Estimate
from polhode.exact.free_body import FreeMotion
from polhode.figures import style
from polhode.figures.energy_levels import label_axes
from polhode.figures.sphere import draw_curve, draw_disk, view_frame
from polhode.measuring.attitudes.attitude_fit import AttitudeFit
from polhode.measuring.throws.throw import FittedThrow, ThrowFit
from polhode.motion._inputs import finite
from polhode.types import Array

MAX_THROWS = 4  # that are drawn


def throw_figures(fit: ThrowFit) -> dict[str, Callable[[], Figure]]:
    """Return the functions that draw the figures of a fit, by name; only the data where the inertia is not determined,
    and no corner where residuals are not noise.

    Args:
        fit: as ``polhode.measuring.fit_throw`` returns it.

    Raises:
        InvalidInput: for anything else.
    """
    check.instance("fit", fit, ThrowFit, "a ThrowFit, as fit_throw returns it")
    figures: dict[str, Callable[[], Figure]] = {"data_and_fit": partial(_data, fit)}
    if fit.degenerate is None and fit.ratios is not None and fit.axes is not None:
        figures["residuals"] = partial(_residuals, fit)
        if fit.misfit is None:  # else nothing has an error
            known = [part for part in (fit.ratios, fit.drag) if part is not None]
            figures["corner"] = partial(_corner, known)
        if fit.rotor is None:  # with a wheel the motion is on no polhode of the body
            figures["polhode"] = partial(_polhode, fit)
    return figures


def attitude_figures(fit: AttitudeFit) -> dict[str, Callable[[], Figure]]:
    """Return the functions that draw the figures of a fit of attitudes, by name; no corner without errors.

    Args:
        fit: as ``polhode.measuring.fit_attitude`` returns it.

    Raises:
        InvalidInput: for anything else.
    """
    check.instance("fit", fit, AttitudeFit, "an AttitudeFit, as fit_attitude returns it")
    figures: dict[str, Callable[[], Figure]] = {"residuals": partial(_attitude_residuals, fit)}
    known = fit.ratios if fit.misfit is None else None
    return figures if known is None else figures | {"corner": partial(_corner, [known])}


def _attitude_residuals(fit: AttitudeFit) -> Figure:
    figure = style.new_figure(width=1.5 * style.COLUMN, height=2.4)
    axes = figure.subplots()
    for k, colour in enumerate(style.AXIS_COLOURS):
        axes.plot(fit.times, 1e3 * fit.residuals[:, k], ".-", ms=2.5, lw=0.4, color=colour, label=f"about {'xyz'[k]}")
    axes.axhline(0.0, color=style.GREY, lw=0.6)
    axes.set_xlabel("time  [s]")
    axes.set_ylabel("fitted → measured  [mrad]")
    style.tidy(axes)
    handles, labels = axes.get_legend_handles_labels()
    figure.legend(handles, labels, loc="outside upper center", ncols=3, fontsize=style.FONT - 1, frameon=False,
                  title=f"residuals, {1e3 * fit.rms:.3g} mrad rms", title_fontsize=style.FONT - 1)
    return figure


def _panels(fit: ThrowFit, height: float) -> tuple[Figure, list[Any]]:
    throws = fit.throws[:MAX_THROWS]
    figure = style.new_figure(width=style.COLUMN * max(1.0, 0.7 * len(throws)), height=height)
    panels = list(np.atleast_1d(figure.subplots(1, len(throws), sharey=True, squeeze=False)[0]))
    for axes in panels:
        axes.set_xlabel("time  [s]")
        style.tidy(axes)
    return figure, panels


def _data(fit: ThrowFit) -> Figure:
    figure, panels = _panels(fit, 2.9)
    for axes, throw in zip(panels, fit.throws, strict=False):
        for k, colour in enumerate(style.AXIS_COLOURS):
            axes.plot(throw.times, throw.rates[:, k], ".", ms=2.8, color=colour)
            if fit.degenerate is None:
                axes.plot(throw.times, throw.predicted[:, k], color=colour, lw=0.9)
    handles = [panels[0].plot([], [], color=colour, lw=0.9, marker=".", label=rf"$\omega_{name}$")[0]
               for name, colour in zip("xyz", style.AXIS_COLOURS, strict=True)]
    panels[0].set_ylabel("angular velocity, device axes  [rad/s]")
    what = "dots measured, lines fitted" if fit.degenerate is None else "measured; no fit is determined"
    figure.legend(handles=handles, loc="outside upper center", ncols=3, fontsize=style.FONT - 1, frameon=False,
                  title=what, title_fontsize=style.FONT - 1)
    return figure


def _residuals(fit: ThrowFit) -> Figure:
    figure, panels = _panels(fit, 2.4)
    for axes, throw in zip(panels, fit.throws, strict=False):
        left = 1e3 * (throw.rates - throw.predicted)
        for k, colour in enumerate(style.AXIS_COLOURS):
            axes.plot(throw.times, left[:, k], ".-", ms=2.5, lw=0.4, color=colour, label=rf"$\omega_{'xyz'[k]}$")
        axes.axhline(0.0, color=style.GREY, lw=0.6)
    panels[0].set_ylabel("measured − fitted  [mrad/s]")
    handles, labels = panels[0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="outside upper center", ncols=3, fontsize=style.FONT - 1, frameon=False,
                  title=f"residuals, {1e3 * fit.rms:.3g} mrad/s rms", title_fontsize=style.FONT - 1)
    return figure


def _polhode(fit: ThrowFit) -> Figure:
    """Return the momentum sphere with the motion of each throw and its samples, without bias and gains."""
    known = [throw for throw in fit.throws if throw.motion is not None][:MAX_THROWS]
    figure = style.new_figure()
    axes = figure.add_subplot()
    frame = view_frame((0.80, 0.46, 0.38))
    draw_disk(axes)
    assert known[0].motion is not None
    moments = np.asarray(known[0].motion.moments)
    for curve in polhode_family(moments):
        draw_curve(axes, frame, curve, style.GREY, 0.4)
    if moments[0] < moments[1] < moments[2]:
        for curve in separatrix(moments):
            draw_curve(axes, frame, curve, style.VERMILION, 0.8)
    for throw in known:
        assert throw.motion is not None
        draw_curve(axes, frame, _path(throw, throw.motion), style.BLUE, 1.3)
        x, y, depth = frame @ _samples(fit, throw, moments).T
        for front in (False, True):
            shown_side = (depth >= 0.0) == front
            axes.plot(x[shown_side], y[shown_side], "o", ms=2.6, color=style.ORANGE, mec=style.DARK, mew=0.25,
                      alpha=1.0 if front else 0.35, zorder=4 if front else 2)
    label_axes(axes, frame)
    handles = [axes.plot([], [], color=style.BLUE, lw=1.3, label="fitted polhode")[0],
               axes.plot([], [], "o", ms=2.6, color=style.ORANGE, mec=style.DARK, mew=0.25, label="samples")[0],
               axes.plot([], [], color=style.VERMILION, lw=0.8, label="separatrix")[0]]  # fmt: skip
    axes.legend(handles=handles, loc="upper center", bbox_to_anchor=(0.5, -0.01), ncols=3, fontsize=style.FONT - 1,
                frameon=False)
    axes.set_title("Momentum along the fitted principal axes", fontsize=style.FONT, color=style.DARK)
    return figure


def _path(throw: FittedThrow, motion: FreeMotion) -> Array:
    span = finite(motion.period)
    duration = throw.times[-1] - throw.times[0]
    times = motion.epoch + np.linspace(0.0, 1.0, 2000) * (duration if span is None else span)
    return np.asarray(motion.momentum(times)) / float(np.asarray(motion.momentum_norm))


def _samples(fit: ThrowFit, throw: FittedThrow, moments: Array) -> Array:
    """Return the directions (n, 3) of the momentum from the samples."""
    assert fit.axes is not None
    turning = np.linalg.solve(fit.gains, (throw.rates - fit.bias.value).T).T
    momentum = turning @ fit.axes * moments
    return momentum / np.linalg.norm(momentum, axis=1, keepdims=True)


def _corner(parts: list[Estimate]) -> Figure:
    """Return densities of the estimates, and the ellipses of each two, by their covariances."""
    names = [name for part in parts for name in part.names]
    value = np.concatenate([part.value for part in parts])
    covariance = np.zeros((len(value), len(value)))
    at = 0
    for part in parts:
        size = len(part.value)
        covariance[at : at + size, at : at + size] = part.covariance
        at += size
    error = np.sqrt(np.diagonal(covariance))
    blocks = np.repeat(np.arange(len(parts)), [len(part.value) for part in parts])
    count = len(value)
    figure = style.new_figure(width=max(style.COLUMN, 1.25 * count), height=max(style.COLUMN, 1.25 * count))
    grid = figure.subplots(count, count, squeeze=False)
    for i in range(count):
        for j in range(count):
            axes = grid[i, j]
            if j > i or (blocks[i] != blocks[j]):
                axes.axis("off")
                continue
            _cell(axes, value, error, covariance, i, j)
            axes.tick_params(labelsize=style.FONT - 2)
            axes.locator_params(nbins=3)
            if i == count - 1 or blocks[i + 1] != blocks[j]:
                axes.set_xlabel(names[j], fontsize=style.FONT)
            if j < i and (j == 0 or blocks[j - 1] != blocks[i]):
                axes.set_ylabel(names[i], fontsize=style.FONT)
    figure.suptitle("Errors by the fit's covariance: 68 % and 95 %", fontsize=style.FONT, color=style.DARK)
    return figure


def _cell(axes: Any, value: Array, error: Array, covariance: Array, i: int, j: int) -> None:
    if i == j:
        x = value[i] + error[i] * np.linspace(-3.5, 3.5, 200)
        axes.plot(x, np.exp(-0.5 * ((x - value[i]) / error[i]) ** 2), color=style.BLUE, lw=1.0)
        for edge in (-1.96, 1.96):
            axes.axvline(value[i] + edge * error[i], color=style.GREY, lw=0.7, ls="--")
        axes.set_yticks([])
    else:
        both = covariance[np.ix_([j, i], [j, i])]
        turn = np.linspace(0.0, 2.0 * np.pi, 200)
        circle = np.linalg.cholesky(both) @ np.stack([np.cos(turn), np.sin(turn)])
        for level in (0.683, 0.954):  # of two numbers, χ² below −2 ln(1 − p) has probability p
            x, y = circle * np.sqrt(-2.0 * np.log(1.0 - level))
            axes.plot(value[j] + x, value[i] + y, color=style.BLUE, lw=1.0)
        axes.plot([value[j]], [value[i]], "+", color=style.DARK, ms=5)
        axes.set_ylim(value[i] - 3.5 * error[i], value[i] + 3.5 * error[i])
    axes.set_xlim(value[j] - 3.5 * error[j], value[j] + 3.5 * error[j])
