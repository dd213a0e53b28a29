"""The report on the Chandler wobble."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any, ClassVar, NamedTuple

import numpy as np

from polhode.celestial.tumbling.euler_periods import EulerPeriod
from polhode.celestial.wobble.estimation import ChandlerFit
from polhode.celestial.wobble.excitation import PolarExcitation
from polhode.celestial.wobble.process import ChandlerProcess
from polhode.celestial.wobble.series_files import PoleSeries, format_day
from polhode.celestial.wobble.units import DAY, MAS, YEAR
from polhode.celestial.wobble.windows import ChandlerWindows, PoleSpectrum
from polhode.reports.answer import Answer, Group, Table
from polhode.reports.report import StudyReport
from polhode.reports.wording import uncertain

if TYPE_CHECKING:
    from matplotlib.figure import Figure

ROWS = 3.0 * YEAR  # between the windows that the text shows


class WobbleReportLimits(NamedTuple):
    """What the notes of a report warn of."""

    max_retrograde_energy: float = 0.01  # of the prograde; the Earth's wobble is a circle but for a thousandth
    max_disagreement: float = 2.0  # standard errors between two estimates of the period
    min_whiteness: float = 0.01  # probability of the innovations; below it the errors of the process are doubtful


LIMITS = WobbleReportLimits()


@dataclass(frozen=True)
class WobbleReport(StudyReport):
    """All results from one series of polar motion."""

    kind: ClassVar[str] = "wobble"
    data_file: ClassVar[str] = "wobble.nc"
    data_endings: ClassVar[tuple[str, ...]] = (".nc",)
    series: PoleSeries
    line: ChandlerFit
    process: ChandlerProcess
    windows: ChandlerWindows
    excitation: PolarExcitation
    spectrum: PoleSpectrum
    chain: Sequence[EulerPeriod]

    @property
    def name(self) -> str:
        return self.series.source

    @property
    def summary(self) -> str:
        period, amplitude = self.line.estimate.value[:2]
        errors = self.line.estimate.standard_error
        said = (f"The Chandler wobble: {uncertain(period / DAY, errors[0] / DAY, 'd')}, "
                f"{uncertain(amplitude / MAS, errors[1] / MAS, 'mas')} on the mean, "
                f"Q = {_quality_in_words(self, 0.6827)}; a rigid Earth would take "
                f"{self.chain[0].period / DAY:.1f} d.")
        return f"{said} {self._misfit}".rstrip()

    @property
    def determined(self) -> bool:
        return not self._misfit

    @property
    def _misfit(self) -> str:
        """A sentence that something else moves the pole than line or process; empty where the residuals are noise."""
        line, process = self.line.noise.test, self.process
        of_line = (f"what the line leaves next to it is not noise (noise has such frequencies with a probability of "
                   f"{line.probability:.1g})")
        of_process = ("what the process does not foresee is not noise (white noise is so correlated with a probability "
                      f"of {process.whiteness:.1g}, by Ljung and Box)")
        left = [of_line] * (not line.is_noise) + [of_process] * (not process.is_noise)
        if not left:
            return ""
        return f"Something else moves the pole than this model: {'; '.join(left)}. Errors are not known."

    @property
    def answers(self) -> list[Group | Table]:
        return [_line(self), _process(self), _terms(self), _windows(self.windows), _excitation(self), _chain(self),
                _data(self)]  # fmt: skip

    @property
    def notes(self) -> list[str]:
        notes = []
        series, line, process = self.series, self.line, self.process
        if series.predicted:
            notes.append(f"{series.predicted} lines are predictions and were left out.")
        if line.energy_ratio > LIMITS.max_retrograde_energy:
            notes.append(f"the retrograde Chandler energy is {100.0 * line.energy_ratio:.2g} % of the prograde one; "
                         "the Earth's is below 1 %. Check signs and units of x and y.")
        amplitudes = self.windows.amplitude
        if amplitudes.max() > 2.0 * amplitudes.min():
            low, high = amplitudes.min() / MAS, amplitudes.max() / MAS
            notes.append(f"the amplitude changed from {low:.0f} to {high:.0f} mas: "
                         "that of the single line is the mean of a wobble that changes, not what it is at any time."
                         )
        apart = abs(line.estimate.value[0] - process.estimate.value[0])
        error = math.hypot(line.estimate.standard_error[0], process.estimate.standard_error[0])
        if apart > LIMITS.max_disagreement * error:
            notes.append("line and process disagree on the period by more than their errors allow.")
        if process.is_noise and process.whiteness < LIMITS.min_whiteness:
            notes.append("what the process does not foresee is correlated (Ljung–Box): its errors may be too small.")
        if math.isinf(process.quality_intervals[0.95][1]):
            notes.append("the series does not refuse a wobble without damping: Q has no upper end at 95 %.")
        return notes

    def figures(self) -> Mapping[str, Callable[[], Figure | None]]:
        from polhode.celestial.wobble.figures import over_time, spectrum, spiral

        return {
            "pole_spiral": partial(spiral, self.series, self.line),
            "chandler_over_time": partial(over_time, self.windows, self.process, self.line),
            "pole_spectrum": partial(spectrum, self.spectrum, self.line),
        }

    def _write_data(self, path: Path) -> Path:
        from polhode.celestial.wobble.dataset import write_wobble

        return write_wobble(self.windows, self.process, self.excitation, self.series.source, path)


def _q(value: float) -> str:
    return f"{value:.0f}" if math.isfinite(value) else "infinite"


def _quality_in_words(report: WobbleReport, level: float) -> str:
    """Return Q with its interval, or few digits where it has none."""
    quality = float(report.process.estimate.value[1])
    if not report.process.is_noise:
        return uncertain(quality, float("nan"))
    low, high = report.process.quality_intervals[level]
    return f"{_q(quality)} ({_q(low)} to {_q(high)})"


def _known(ends: Sequence[float]) -> list[float] | None:
    """Return an interval, or None where errors are not known."""
    return None if any(math.isnan(end) for end in ends) else list(ends)


def _line(report: WobbleReport) -> Group:
    fit = report.line
    period, amplitude, phase = fit.estimate.value
    errors = fit.estimate.standard_error
    ends = _known((fit.estimate.interval()[0] / DAY).tolist())
    return Group("The Chandler wobble, as one line by least squares", [
        Answer("chandler_period_days", period / DAY, "d", "period", "", uncertain(period / DAY, errors[0] / DAY, "d")),
        Answer("chandler_period_days_error", errors[0] / DAY, "d", "", "standard error"),
        Answer("chandler_period_days_interval", ends, "d", "period, 95 %", "",
               None if ends is None else f"{ends[0]:.1f} to {ends[1]:.1f} d"),
        Answer("chandler_amplitude_mas", amplitude / MAS, "mas", "amplitude", "of the mean wobble",
               uncertain(amplitude / MAS, errors[1] / MAS, "mas")),
        Answer("chandler_amplitude_mas_error", errors[1] / MAS, "mas", "", "standard error"),
        Answer("chandler_phase", phase, "rad", "", "at the middle of the span, from Greenwich eastward"),
        Answer("chandler_phase_error", errors[2], "rad", "", "standard error"),
        Answer("retrograde_energy_ratio", fit.energy_ratio, "", "retrograde energy", "over the prograde one",
               f"{100.0 * fit.energy_ratio:.2g} % of the prograde one"),
        Answer("residual_rms_mas", fit.rms / MAS, "mas", "residuals", "of a coordinate",
               f"{fit.rms / MAS:.3g} mas rms"),
        Answer("residual_probability", fit.noise.test.probability, "", "",
               "of a band of frequencies next to the line as strong as the strongest, were it noise"),
    ])


def _process(report: WobbleReport) -> Group:
    process = report.process
    period, quality = process.estimate.value
    errors = process.estimate.standard_error
    span = _known([end / DAY for end in process.period_intervals[0.95]])
    near, far = (_known(process.quality_intervals[level]) for level in (0.6827, 0.95))
    said = uncertain(quality, float("nan")) if near is None else f"{_q(quality)}, 68 %: {_q(near[0])} to {_q(near[1])}"
    return Group("The same as a damped wobble kept going by white excitation, by likelihood", [
        Answer("quality_factor", quality, "", "Q", "", said),
        Answer("quality_factor_error", errors[1], "", "", "by the curvature of the likelihood; the interval says more"),
        Answer("quality_factor_interval_68", near, "", "", "of 68 %"),
        Answer("quality_factor_interval", far, "", "Q, 95 %", "",
               None if far is None else f"{_q(far[0])} to {_q(far[1])}"),
        Answer("process_period_days", period / DAY, "d", "period", "", uncertain(period / DAY, errors[0] / DAY, "d")),
        Answer("process_period_days_error", errors[0] / DAY, "d", "", "standard error"),
        Answer("process_period_days_interval", span, "d", "period, 95 %", "",
               None if span is None else f"{span[0]:.1f} to {span[1]:.1f} d"),
        Answer("damping_time", quality * period / math.pi, "s", "dies away to 1/e in"),
        Answer("whiteness", process.whiteness, "", "", "probability of innovations so correlated, were they white"),
    ])


def _terms(report: WobbleReport) -> Table:
    fit = report.line
    rows: list[dict[str, Any]] = []
    for name, rate in fit.rates.items():
        size, error = fit.amplitude(name)
        rows.append({"term": name, "period_days": 2.0 * math.pi / abs(rate) / DAY, "amplitude_mas": size / MAS,
                     "amplitude_mas_error": error / MAS, "phase": float(np.angle(fit.term(name)))})
    return Table("terms", "Terms of the fit", {
        "term": lambda row: row["term"].replace("_", " "),
        "period": lambda row: f"{row['period_days']:.2f} d",
        "amplitude": lambda row: uncertain(row["amplitude_mas"], row["amplitude_mas_error"], "mas"),
    }, rows, {"period_days": "d", "amplitude_mas": "mas", "amplitude_mas_error": "mas", "phase": "rad"},
        "term")


def _windows(windows: ChandlerWindows) -> Table:
    rows: list[dict[str, Any]] = [
        {"centre": format_day(centre / DAY), "amplitude_mas": a / MAS, "amplitude_mas_error": b / MAS, "phase": p,
         "phase_error": q}
        for centre, a, b, p, q in zip(windows.centres, windows.amplitude, windows.amplitude_error, windows.phase,
                                      windows.phase_error, strict=True)
    ]
    every = max(1, round(ROWS / (windows.centres[1] - windows.centres[0]))) if len(rows) > 1 else 1
    shown = {row["centre"] for row in rows[::every]}
    return Table("windows", f"Windows of {windows.window / YEAR:.3g} years", {
        "middle": lambda row: row["centre"],
        "amplitude": lambda row: uncertain(row["amplitude_mas"], row["amplitude_mas_error"], "mas"),
        "phase": lambda row: uncertain(math.degrees(row["phase"]), math.degrees(row["phase_error"]), "°"),
    }, rows, {"amplitude_mas": "mas", "amplitude_mas_error": "mas", "phase": "rad", "phase_error": "rad"},
        shown=lambda row: row["centre"] in shown)


def _excitation(report: WobbleReport) -> Group:
    excitation = report.excitation
    density = report.process.excitation / MAS**2 / YEAR
    rms = float(np.sqrt(0.5 * np.mean(np.abs(excitation.psi - excitation.psi.mean()) ** 2)) / MAS)
    return Group("Excitation, by deconvolution", [
        Answer("excitation.rms_mas", rms, "mas", "of a component", f"means over {excitation.step / DAY:g} d",
               f"{rms:.3g} mas rms, means over {excitation.step / DAY:g} d"),
        Answer("excitation.density", density, "mas²/(1/a)", "density at the wobble's rate",
               "two-sided, that keeps the wobble going", f"{density:.3g} mas² per cycle a year"),
    ])


def _chain(report: WobbleReport) -> Table:
    rows: list[dict[str, Any]] = [
        {"stage": stage.name, "period_days": stage.period / DAY, "cause": stage.cause} for stage in report.chain
    ]
    return Table("euler_chain", "From Euler's period to Chandler's", {
        "Earth": lambda row: row["stage"].replace("_", " "),
        "period": lambda row: f"{row['period_days']:.1f} d",
        "cause": lambda row: row["cause"],
    }, rows, {"period_days": "d"})


def _data(report: WobbleReport) -> Group:
    days = report.series.days
    span = [format_day(float(days[0])), format_day(float(days[-1]))]
    return Group("Data", [
        Answer("source", report.series.source, "", "source"),
        Answer("form", report.series.form, "", "form"),
        Answer("span", span, "", "days", "", f"{span[0]} to {span[1]}, {len(days)} of them"),
        Answer("samples", len(days)),
    ])
