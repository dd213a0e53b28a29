"""The report on a fit of throws."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any, ClassVar, NamedTuple

import numpy as np

from polhode.estimation._estimate import Estimate
from polhode.measuring.answers import (
    about_axes,
    about_inertia,
    about_misfit,
    about_moments,
    describe_turning,
    each,
    in_words,
    sentence,
    tell_misfit,
    values,
)
from polhode.measuring.throws._throw_fit import LIMITS as FIT_LIMITS
from polhode.measuring.throws.flight import Flights
from polhode.measuring.throws.gyro_logs import ReadLog
from polhode.measuring.throws.left_out import left_out_note, left_out_table
from polhode.measuring.throws.throw import GAIN_SPREAD, ThrowFit
from polhode.reports.answer import Answer, Group, Table
from polhode.reports.report import StudyReport
from polhode.reports.wording import uncertain, write_count

if TYPE_CHECKING:
    from matplotlib.figure import Figure


class NoteThresholds(NamedTuple):
    """Numbers that decide which notes a reader gets.

    Attributes:
        large_bias: rad/s; offsets of gyros are smaller, but a fit may put into one what its motion does not explain.
        large_torque: over I3 |ω|², of a torque that no model has.
        gain_ratio: of the spread of the gains to the expected one.
        wheel_error_ratio: of errors beside a wheel to those without.
        min_wheel: of the slowest throw's rate; a smaller momentum acts like air, with torques of some .01 I3 |ω|².
        hardly_preferred: difference of AICc, below which the criterion hardly prefers one model.
    """

    large_bias: float = 0.1
    large_torque: float = 0.002
    gain_ratio: float = 1.5
    wheel_error_ratio: float = 2.0
    min_wheel: float = 0.05
    hardly_preferred: float = 2.0


LIMITS = NoteThresholds()


@dataclass(frozen=True)
class ThrowReport(StudyReport):
    """The report on the inertia of a thrown body from gyro logs.

    Attributes:
        fit: the numbers.
        names: of the logs.
        logs: the read logs.
        flights: of each log, the fitted stretches and those left out.
        moments: I1, I2, I3 [kg m²]; None where only their ratios are known.
    """

    kind: ClassVar[str] = "throw-fit"
    data_file: ClassVar[str] = "fit.nc"
    data_endings: ClassVar[tuple[str, ...]] = (".nc",)
    fit: ThrowFit
    names: Sequence[str]
    logs: Sequence[ReadLog]
    flights: Sequence[Flights]
    moments: Estimate | None

    @property
    def name(self) -> str:
        return ", ".join(self.names)

    @property
    def determined(self) -> bool:
        return self.fit.degenerate is None and self.fit.misfit is None

    @property
    def summary(self) -> str:
        fit = self.fit
        what = write_count(len(fit.throws), "throw")
        if fit.degenerate is not None or fit.ratios is None:
            return f"{what}: the inertia is not determined. {sentence(fit.degenerate or '')}"
        if fit.misfit is not None:
            reason = tell_misfit(fit, "rad/s")
            return f"{what}: {reason[0].lower()}{reason[1:]}"
        said = ", ".join(f"{name} = {uncertain(value, error)}" for name, value, error in each(fit.ratios))
        first = fit.throws[0]
        how = describe_turning(first.motion, first.times, fit.equal)
        if fit.rotor is not None:
            how = ("a wheel seems to turn in the body" if is_wheel_sure(fit) else
                   "something small acts across its axes, as air does")
        return f"{what}: {said}; {how}, residuals {fit.rms:.2g} rad/s rms."

    @property
    def answers(self) -> list[Group | Table]:
        fit, names = self.fit, self.names
        return [about_inertia(fit), *about_moments(self.moments), about_axes(fit), _gyro(fit), _quality(fit),
                _throws(fit, names), _models(fit), _logs(names, self.logs),
                left_out_table(names, self.flights)]  # fmt: skip

    @property
    def notes(self) -> list[str]:
        fit = self.fit
        notes = [f"{name}: {note}" for name, read in zip(self.names, self.logs, strict=True) for note in read.notes]
        if fit.clip is not None:
            notes.append(f"samples at the gyro's limit, {_of_sensor(fit.clip)}, are left out.")
        if fit.equal:
            notes.append(f"{fit.equal} within their errors: the axes between them are not determined.")
        if fit.degenerate is None:
            if fit.misfit is not None:
                notes.append("look at the residuals by `draw`, and give the free flight by `windows`.")
            else:
                notes += _doubts(fit)
            chosen = next((score for score in fit.criterion if score.chosen), None)
            others = [score for score in fit.criterion if not score.chosen]
            if chosen and others and min(score.aicc for score in others) - chosen.aicc < LIMITS.hardly_preferred:
                notes.append("the criterion hardly prefers the chosen model to the next one; see the table of models.")
            if fit.gain is None and fit.misfit is None:
                notes.append("no gains were fitted, so the intervals hold for a calibrated gyro: a gain or cross-axis "
                             "sensitivity of 1 % moves the ratios by about as much.")
        return [*notes, *left_out_note(self.flights)]

    def figures(self) -> Mapping[str, Callable[[], Figure | None]]:
        from polhode.measuring.throws.figures import throw_figures

        return throw_figures(self.fit)

    def _write_data(self, path: Path) -> Path:
        from polhode.measuring.throws.dataset import write_throw

        return write_throw(self.fit, self.names, path)


def is_wheel_sure(fit: ThrowFit) -> bool:
    """Whether a fitted wheel explains clearly more than air and gains do, and exceeds what air can simulate.

    Drag −|ω| C ω with an antisymmetric C is |ω| k × ω: in throws of one speed that is h × ω of a wheel, h = |ω| k.
    """
    if fit.rotor is None or fit.with_or_without:
        return False
    slowest = min(float(np.median(np.linalg.norm(throw.rates, axis=1))) for throw in fit.throws)
    return float(np.linalg.norm(fit.rotor.value)) > LIMITS.min_wheel * slowest


def _doubts(fit: ThrowFit) -> list[str]:
    """Return notes on reasons to doubt numbers of a fit."""
    notes = []
    if fit.rotor is not None:
        size = float(np.linalg.norm(fit.rotor.value))
        of_body = ("The moments are of the body with the wheel; where no motor keeps its speed, without the wheel's "
                   "own moment about its axis.")
        if is_wheel_sure(fit):
            notes.append(f"the rates indicate a wheel that turns in the body: its momentum is {size:.3g} rad/s of the "
                         f"largest moment. {of_body}")
        else:
            notes.append(f"the model with a wheel of {size:.2g} rad/s of the largest moment does best, but air on a "
                         "body that is not symmetric or wrong gains may do the same: the log does not tell which. "
                         f"With a wheel: {of_body[0].lower()}{of_body[1:]}")
    if fit.with_or_without:
        notes.append("the log hardly distinguishes a body with a wheel from one without: the intervals cover both. "
                     "Choose by `rotor=True` or `rotor=False`.")
    size = float(np.abs(fit.bias.value).max())
    if size > LIMITS.large_bias and fit.rest is None:
        notes.append(f"the bias is large, {size:.2g} rad/s, and no rest in the log confirms it: it may stand for "
                     "something that the motion does not explain, and the ratios may be wrong by more than their "
                     "intervals. Let the device lie still for a second before and after the throw.")
    elif fit.rest is None:
        notes.append("no rest was found in the log, so that the bias was assumed to be "
                     f"0 ± {FIT_LIMITS.bias_spread:.2g} rad/s "
                     "along each axis: with a larger one the bias and its errors are wrong, and so may the ratios be. "
                     "Let the device lie still for a second before and after the throw.")
    if fit.beside_wheel is not None and fit.ratios is not None and not fit.with_or_without:
        both = np.stack([fit.beside_wheel, fit.ratios.standard_error])
        if (both[0] > LIMITS.wheel_error_ratio * both[1]).any():
            first, second = (f"{error:.2g}" for error in both[0])
            notes.append("it is assumed that no wheel turns in the body. If one does, the intervals are too narrow: "
                         f"the log then determines I1/I3 only to ± {first} and I2/I3 to ± {second}. A longer throw, or "
                         "one with more tumble, distinguishes the two.")
    if fit.unmodelled > LIMITS.large_torque:
        notes.append(f"a torque of about {fit.unmodelled:.2g} I3 |ω|² acts that no model has; the intervals allow "
                     "for it.")
    if fit.gain is not None and fit.gain_spread > LIMITS.gain_ratio * GAIN_SPREAD:
        compared = " Fit each throw alone and compare." if len(fit.throws) > 1 else ""
        notes.append(f"the gyro's gains are off by about {100 * fit.gain_spread:.2g} %, more than expected, or "
                     f"stand for what no model has, like air across axes: errors include it.{compared}")
    return notes


def _gyro(fit: ThrowFit) -> Group:
    sure, noisy = fit.degenerate is None, fit.degenerate is None and fit.misfit is None
    rest, gain, cross = fit.rest, fit.gain, fit.cross_axis
    return Group("Gyro and air", [
        Answer("bias", values(fit.bias) if sure else None, "rad/s", "bias", "along the device's x, y, z",
               _bias_in_words(fit) if sure else None),
        Answer("rest", None if rest is None else values(rest), "rad/s", "bias at rest",
               "known beforehand to this; null where no log has rests",
               None if rest is None else f"{in_words(rest)} rad/s"),
        Answer("gain", None if gain is None else values(gain), "", "gains", "along the device's x, y, z",
               None if gain is None else in_words(gain)),
        Answer("cross_axis", None if cross is None else values(cross), "", "cross-axis gains",
               "of y and z, x and z, x and y", None if cross is None else in_words(cross)),
        Answer("gain_spread", fit.gain_spread if noisy and gain is not None else None, "", "",
               "standard deviation of the gains, by the log and by what was known beforehand"),
        _describe_torque("drag", fit.drag, "", "drag c/I3", "−c_i |ω| ω_i", "none" if sure else None),
        _describe_torque("linear_drag", fit.linear_drag, "1/s", "linear drag b/I3", "−b_i ω_i"),
        _describe_torque("one_sided_drag", fit.one_sided_drag, "", "one-sided drag d/I3", "−d_i |ω| |ω_i|"),
        Answer("rotor", None if fit.rotor is None else values(fit.rotor), "rad/s", "wheel's momentum h/I3",
               "along the principal axes; null where none is fitted",
               ("none assumed" if sure else None) if fit.rotor is None else f"{in_words(fit.rotor)} rad/s"),
        Answer("beside_wheel", None if fit.beside_wheel is None else fit.beside_wheel.tolist(), "", "",
               "standard errors of the ratios if a wheel might turn in the body; null where one was fitted"),
        Answer("unmodelled", fit.unmodelled if noisy else None, "", "",
               "torque over I3 |ω|² that no model has, rms; intervals allow for it"),
        Answer("widened", fit.widened if noisy else None, "", "",
               "factor on the variances of the noise, because neighbouring residuals are alike"),
    ])


def _bias_in_words(fit: ThrowFit) -> str:
    assumed = "" if fit.rest is not None else f" (no rest: assumed to be within {FIT_LIMITS.bias_spread:.2g} of 0)"
    return f"{in_words(fit.bias)} rad/s{assumed}"


def _describe_torque(key: str, estimate: Estimate | None, unit: str, label: str, torque: str, words: str | None = None
               ) -> Answer:
    if estimate is None:
        return Answer(key, None, unit, label if words else "", "", words)
    about = f"of the torque {torque} along the principal axes; null where there is none"
    return Answer(key, values(estimate), unit, label, about, f"{in_words(estimate)} {unit}".strip())


def _quality(fit: ThrowFit) -> Group:
    sure = fit.degenerate is None and len(fit.residuals) > 0
    noisy = sure and fit.misfit is None
    first = fit.throws[0]
    how = "as given" if first.window.reason == "given" else first.window.reason
    how += f"; {write_count(len(fit.throws) - 1, 'more throw')} below" if len(fit.throws) > 1 else ""
    return Group("Fit", [
        Answer("rms", fit.rms if sure else None, "rad/s", "residuals", "root mean square",
               f"{fit.rms:.3g} rad/s rms" if sure else None),
        Answer("sigma", fit.sigma if noisy else None, "rad/s", "noise of a sample", "",
               f"{fit.sigma:.3g} rad/s" if noisy else None),
        Answer("jitter", fit.jitter if noisy else None, "s", "jitter of the clock" if fit.jitter > 0 else "", "",
               f"{fit.jitter:.2g} s rms" if noisy else None),
        Answer("samples", sum(len(throw.times) for throw in fit.throws), "", "samples used"),
        Answer("clip", fit.clip, "rad/s", "gyro's limit", "", None if fit.clip is None else _of_sensor(fit.clip)),
        about_misfit(fit.misfit),
        Answer("window", [first.window.start, first.window.end], "s", "free flight", "of the first throw",
               f"{first.window.start:.6g} to {first.window.end:.6g} s, {how}"),
        Answer("regime", first.regime, "", "", "of the first throw"),
    ])


def _throws(fit: ThrowFit, names: Sequence[str]) -> Table:
    rows: list[dict[str, Any]] = []
    for throw in fit.throws:
        motion = throw.motion
        rows.append({
            "log": names[throw.log], "window": [throw.window.start, throw.window.end],
            "found_by": throw.window.reason, "samples": len(throw.times), "regime": throw.regime,
            "period": None if motion is None else motion.period,
            "fastest": float(np.linalg.norm(throw.rates, axis=1).max()),
        })
    return Table("throws", "Throws", {
        "log": lambda row: row["log"],
        "from – to": lambda row: f"{row['window'][0]:.4g} – {row['window'][1]:.4g} s",
        "samples": lambda row: str(row["samples"]),
        "motion": lambda row: row["regime"] or "–",
        "polhode period": lambda row: f"{row['period']:.4g} s" if row["period"] and np.isfinite(row["period"]) else "–",
        "up to": lambda row: f"{row['fastest']:.3g} rad/s",
    }, rows, {"window": "s", "period": "s", "fastest": "rad/s"})


def _models(fit: ThrowFit) -> Table:
    least = min((score.aicc for score in fit.criterion), default=0.0)
    rows = [{"drag": s.drag, "rotor": s.rotor, "gain": s.gain, "parameters": s.parameters, "aicc": s.aicc,
             "bic": s.bic, "rms": s.rms, "chosen": s.chosen} for s in fit.criterion]
    return Table("models", "Models, by Akaike's corrected criterion", {
        "model": lambda row: ("bias" + (", gains" if row["gain"] else "") + (", a wheel" if row["rotor"] else "")
                              + ("" if row["drag"] == "none" else f", {row['drag']} drag")),
        "parameters": lambda row: str(row["parameters"]),
        "AICc above the least": lambda row: f"{row['aicc'] - least:.1f}",
        "residuals": lambda row: f"{row['rms']:.3g} rad/s",
        "": lambda row: "chosen" if row["chosen"] else "",
    }, rows, {"rms": "rad/s"})


def _logs(names: Sequence[str], logs: Sequence[ReadLog]) -> Table:
    rows: list[dict[str, Any]] = []
    for name, read in zip(names, logs, strict=True):
        log = read.log
        rows.append({
            "file": name, "header_of": read.dialect, "samples": len(log.times), "first": float(log.times[0]),
            "last": float(log.times[-1]), "usual_step": float(np.median(np.diff(log.times))), "unit": read.rate_unit,
            "acceleration_from": read.acceleration_from, "dropped": log.dropped, "repeated": log.repeats,
        })
    return Table("logs", "Logs", {
        "log": lambda row: row["file"],
        "header of": lambda row: row["header_of"],
        "samples": lambda row: f"{row['samples']}, {row['first']:.4g} to {row['last']:.4g} s",
        "rate": lambda row: f"{1.0 / row['usual_step']:.4g} Hz",
        "unit": lambda row: row["unit"],
        "accelerations": lambda row: row["acceleration_from"] or "none",
    }, rows, {"first": "s", "last": "s", "usual_step": "s"})


def _of_sensor(rate: float) -> str:
    """Return a rate [rad/s] as data sheets of gyros state their ranges.

    >>> _of_sensor(34.906585)
    '2000 deg/s (34.9066 rad/s)'
    """
    return f"{np.degrees(rate):.6g} deg/s ({rate:.6g} rad/s)"
