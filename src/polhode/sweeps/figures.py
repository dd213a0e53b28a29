"""Figures of a sweep: histograms, maps of verdicts over two inputs, and sensitivities."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.figure import Figure

from polhode.figures import style
from polhode.sweeps.columns import Column
from polhode.sweeps.distributions import Grid
from polhode.sweeps.evaluation import DONE, LOST, REFUSED, STATUS
from polhode.sweeps.summary import Numbers

if TYPE_CHECKING:
    from polhode.sweeps.answers import SweepReport

MAX_SAMPLES = 200_000  # of a figure, evenly chosen
MAX_PANELS = 12
PALETTE = (style.BLUE, style.ORANGE, style.GREEN, style.VERMILION, style.SKY, style.PURPLE)
MARKS = "o^sDvP"


def histograms(report: SweepReport) -> Figure | None:
    """Return the distribution of each output: densities of numbers, shares of words."""
    panels = [(column, k) for column in report.outputs for k in range(int(np.prod(column.shape, dtype=int)))]
    panels = [(column, k) for column, k in panels[:MAX_PANELS] if _varies(report, column, k)]
    if not panels:
        return None
    columns = min(2, len(panels))
    rows = -(-len(panels) // columns)
    figure = style.new_figure(width=style.COLUMN * columns, height=1.0 + 1.35 * rows)
    for place, (column, k) in enumerate(panels):
        axes = figure.add_subplot(rows, columns, place + 1)
        (_bars if column.text else _density)(axes, report, column, k)
        style.tidy(axes)
    return figure


def _varies(report: SweepReport, column: Column, k: int) -> bool:
    """Whether there is something to see: any words, or numbers that differ by more than rounding."""
    summary = report.summaries[column.name]
    if isinstance(summary, dict):
        return any(summary)
    return summary[k].high - summary[k].low > 1e-12 * max(abs(summary[k].low), abs(summary[k].high))


def _bars(axes: Any, report: SweepReport, column: Column, k: int) -> None:
    summary = report.summaries[column.name]
    assert isinstance(summary, dict)
    known = {word: count for word, count in summary.items() if word}
    total = sum(known.values())
    words = sorted(known, key=lambda word: known[word])[-8:]
    axes.barh(words, [100.0 * known[word] / total for word in words], color=style.BLUE, height=0.6)
    axes.set_xlim(0.0, 100.0)
    axes.set_ylim(-0.7, max(len(words), 3) - 0.3)
    axes.set_xlabel(f"{column.name}  [% of samples]")


def _density(axes: Any, report: SweepReport, column: Column, k: int) -> None:
    summary = report.summaries[column.name]
    assert not isinstance(summary, dict)
    values, weights = _drawable(report, column, k, summary[k])
    power = style.power_of_ten((summary[k].low, summary[k].high))
    unit = f"  [{style.factor(power)}{column.unit}]" if column.unit or power else ""
    scaled = values / 10.0**power
    bins = min(48, max(8, len(scaled) // 8))
    axes.hist(scaled, bins=bins, weights=weights, density=True, color=style.BLUE, alpha=0.85)
    axes.set_yticks([])
    part = f", component {k + 1}" if column.shape else ""
    axes.set_xlabel(f"{column.name}{part}{unit}")


def _drawable(report: SweepReport, column: Column, k: int, summary: Numbers) -> tuple[Any, Any]:
    """Return values and weights: of the samples, or of the summary kept in place of them."""
    if report.sweep.plan.keep == "all":
        values = report.store.read(column.name, MAX_SAMPLES)
        values = values.reshape(len(values), -1)[:, k]
        values = values[~np.isnan(values)]
        if len(values):
            return values, np.ones(len(values))
    parts = summary.parts
    return (np.concatenate([knots for _, knots in parts]),
            np.concatenate([np.full(len(knots), count / len(knots)) for count, knots in parts]))  # fmt: skip


def verdict_map(report: SweepReport) -> Figure | None:
    """Return a map of the first output of words, over the first two inputs that are single numbers."""
    plan = report.sweep.plan
    texts = [column for column in report.outputs if column.text]
    varied = [column for column in texts if len([word for word in report.summaries[column.name] if word]) > 1]
    words = next(iter(varied or texts), None)
    axes_of = [key for key, how in plan.design.inputs.items() if not how.length][:2]
    if words is None or len(axes_of) < 2 or plan.keep != "all":
        return None
    x, y, verdicts, status = (report.store.read(name, MAX_SAMPLES) for name in (*axes_of, words.name, STATUS))
    verdicts = np.where(status == DONE, verdicts, status)
    known = sorted({str(word) for word in verdicts if word}, key=lambda word: (word in (REFUSED, LOST), word))
    if not known:
        return None
    figure = style.new_figure(height=3.4)
    axes = figure.subplots()
    powers = [style.power_of_ten(values) for values in (x, y)]
    x, y = x / 10.0 ** powers[0], y / 10.0 ** powers[1]
    if all(isinstance(plan.design.inputs[key], Grid) for key in axes_of):
        _tiles(axes, x, y, verdicts, known)
    else:
        _dots(axes, x, y, verdicts, known)
    for power, key, say in zip(powers, axes_of, (axes.set_xlabel, axes.set_ylabel), strict=True):
        unit = plan.units[key].replace("*", " ").replace("^2", "²").replace("^3", "³")
        say(f"{key}  [{style.factor(power)}{unit}]" if unit or power else key)
    handles = [make_style(word, known) for word in known]
    axes.set_title(words.name, fontsize=style.FONT)
    figure.legend(handles=handles, loc="outside upper center", ncols=3, fontsize=style.FONT - 1, frameon=False)
    style.tidy(axes)
    return figure


def _colour(word: str, k: int) -> str:
    return style.LIGHT if word in (REFUSED, LOST) else PALETTE[k % len(PALETTE)]


def make_style(word: str, known: list[str]) -> Any:
    """Return the legend entry of a word."""
    from matplotlib.lines import Line2D

    k = known.index(word) % len(MARKS)
    return Line2D([], [], ls="", marker=MARKS[k], ms=5, mec="none", color=_colour(word, k), label=word)


def _tiles(axes: Any, x: Any, y: Any, verdicts: Any, known: list[str]) -> None:
    """Colour each point of a grid by its commonest word."""
    from matplotlib.colors import ListedColormap

    across, along = np.unique(x), np.unique(y)
    counts = np.zeros((len(known), len(along), len(across)))
    columns, rows = np.searchsorted(across, x), np.searchsorted(along, y)
    for k, word in enumerate(known):
        np.add.at(counts[k], (rows[verdicts == word], columns[verdicts == word]), 1.0)
    most = np.where(counts.sum(axis=0) > 0.0, counts.argmax(axis=0), np.nan)
    colours = [_colour(word, k) for k, word in enumerate(known)]
    axes.pcolormesh(across, along, most, cmap=ListedColormap(colours), vmin=-0.5, vmax=len(known) - 0.5,
                    shading="nearest", rasterized=True)


def _dots(axes: Any, x: Any, y: Any, verdicts: Any, known: list[str]) -> None:
    dots = min(6_000, len(x))  # more would only blur
    shown = np.unique(np.linspace(0, len(x) - 1, dots).astype(int))
    x, y, verdicts = x[shown], y[shown], verdicts[shown]
    for k, word in enumerate(known):
        here = verdicts == word
        axes.plot(x[here], y[here], ls="", marker=MARKS[k % len(MARKS)], ms=2.2, mec="none", alpha=0.7,
                  color=_colour(word, k), rasterized=True)


def sensitivities(report: SweepReport) -> Figure | None:
    """Return the shares of each output's variance that inputs explain, alone and in all; None without an analysis."""
    rows = [dict(row) for group in report.answers if getattr(group, "name", "") == "sensitivities"
            for row in getattr(group, "rows", [])]
    if not rows:
        return None
    outputs = list(dict.fromkeys(row["output"] for row in rows))[:MAX_PANELS]
    inputs = list(report.sweep.plan.design.inputs)
    figure = style.new_figure(width=style.COLUMN * 1.4, height=0.9 + 0.24 * len(outputs) * (len(inputs) + 0.6))
    axes = figure.subplots()
    ticks, labels, at = [], [], 0.0
    for output in outputs:
        axes.text(0.0, at - 0.1, output, fontsize=style.FONT - 1, weight="bold", va="center")
        for name in inputs:
            at += 1.0
            row = next(row for row in rows if row["output"] == output and row["input"] == name)
            axes.barh(at, row["total"], xerr=row["total_error"], color=style.SKY, height=0.7, ecolor=style.GREY)
            axes.barh(at, row["first"], color=style.BLUE, height=0.35)
            ticks, labels = [*ticks, at], [*labels, name]
        at += 1.4
    axes.set_yticks(ticks, labels)
    axes.set_ylim(at - 0.6, -0.7)
    axes.set_xlim(left=min(0.0, *(row["first"] for row in rows)))
    axes.set_xlabel("share of the variance: alone (dark), in all (light)")
    style.tidy(axes)
    return figure


FIGURES: dict[str, Callable[[SweepReport], Figure | None]] = {
    "histograms": histograms, "verdict_map": verdict_map, "sensitivities": sensitivities,
}  # fmt: skip
