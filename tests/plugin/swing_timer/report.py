"""From times of passing to a report on the period."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, ClassVar

import numpy as np

from polhode.errors import InvalidInput
from polhode.figures import COLOURS, new_figure, tidy
from polhode.formats import write_whole
from polhode.reports import Answer, Group, StudyReport, Table

if TYPE_CHECKING:
    from matplotlib.figure import Figure


@dataclass(frozen=True)
class SwingReport(StudyReport):
    """The period of a swing, by a straight line through the times of passing."""

    kind: ClassVar[str] = "swings"
    data_file: ClassVar[str] = "residuals.csv"
    name: str
    period: float
    error: float
    residuals: tuple[float, ...]

    @property
    def summary(self) -> str:
        return f"A swing takes {self.period:.6g} s, give or take {self.error:.2g} s."

    @property
    def answers(self) -> list[Group | Table]:
        return [Group("Swings", [
            Answer("period", self.period, "s", "period"), Answer("error", self.error, "s", "standard error"),
            Answer("swings", (len(self.residuals) - 1) / 2, "", "swings"),
        ])]  # fmt: skip

    def figures(self) -> Mapping[str, Callable[[], Figure | None]]:
        return {"residuals": partial(_drawn, self)}

    def _write_data(self, path: Path) -> Path:
        with write_whole(path) as draft:
            draft.write_text("".join(f"{x!r}\n" for x in self.residuals))
        return path


def _drawn(report: SwingReport) -> Figure:
    figure = new_figure()
    axes = figure.subplots()
    axes.plot(1e3 * np.asarray(report.residuals), ".", color=COLOURS["palette"][0])
    axes.set_ylabel("residual  [ms]")
    tidy(axes)
    return figure


def time_swings(path: Path) -> SwingReport:
    """Return the report on a file with a time [s] a line, two of each swing.

    Raises:
        InvalidInput: for fewer than three times, or what are no numbers.
    """
    try:
        times = np.loadtxt(path, ndmin=1)
    except (OSError, ValueError) as error:
        raise InvalidInput(f"{path}: cannot be read ({error}). Give a file with a time on each line.") from None
    if len(times) < 3:
        raise InvalidInput(f"{path}: has {len(times)} times, and a period with its error needs three. Count longer.")
    if not (np.isfinite(times).all() and (np.diff(times) > 0.0).all()):
        raise InvalidInput(f"{path}: times must be numbers that rise. Sort them, each once.")
    count = np.arange(len(times)) / 2.0
    (period, start), covariance = np.polyfit(count, times, 1, cov="unscaled")
    residuals = times - (start + period * count)
    noise = float(np.sum(residuals**2)) / max(1, len(times) - 2)
    return SwingReport(path.name, float(period), float(np.sqrt(noise * covariance[0, 0])), tuple(residuals.tolist()))
