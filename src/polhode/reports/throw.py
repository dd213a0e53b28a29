"""What a fit of throws says, as answers."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from polhode.estimation.attitude_fit import AttitudeFit
from polhode.estimation.estimate import Estimate
from polhode.estimation.throw import GAIN_SPREAD, ThrowFit
from polhode.estimation.throw_fit import BIAS_SPREAD
from polhode.formats.gyro_logs import ReadLog
from polhode.reports.answer import Answer, Group, Table
from polhode.reports.wording import counted, known_digits, uncertain
from polhode.types import Array

EXACT = 1e-9  # rad; residuals of computed attitudes, which rounding makes alike
ALIKE = 0.5  # correlation of neighbouring residuals, above which a fit does not explain its data
LARGE_BIAS = 0.1  # rad/s: a gyro's offset is smaller, but a fit may put into it what its motion does not explain
PUSHED = 0.002  # over I3 |ω|²: a torque that no model has, from which a reader should know of it
LARGER = 1.5  # times the gains that were expected
HIDDEN = 2.0  # times the errors: those with a wheel, from which a reader should know of it
BARELY = 2.0  # AICc less than this apart: the criterion hardly prefers one model


def throw_summary(fit: ThrowFit) -> str:
    """Return the answer in a sentence."""
    what = counted(len(fit.throws), "throw")
    if fit.degenerate is not None or fit.ratios is None:
        return f"{what}: the inertia cannot be told. {_sentence(fit.degenerate or '')}"
    said = ", ".join(f"{name} = {uncertain(value, error)}" for name, value, error in _each(fit.ratios))
    how = _named(fit.throws[0].regime) if fit.rotor is None else "a wheel turns in the body"
    return f"{what}: {said}; {how}, residuals {fit.rms:.2g} rad/s rms."


def throw_groups(
    fit: ThrowFit, names: Sequence[str], logs: Sequence[ReadLog], moments: Estimate | None
) -> list[Group | Table]:
    """Return what a fit says, by groups."""
    return [_inertia(fit), *_moments(moments), _axes(fit), _gyro(fit), _quality(fit), _throws(fit, names),
            _models(fit), _logs(names, logs)]  # fmt: skip


def throw_notes(fit: ThrowFit, names: Sequence[str], logs: Sequence[ReadLog]) -> list[str]:
    """Return what a reader should know of files and fit."""
    notes = [f"{name}: {note}" for name, read in zip(names, logs, strict=True) for note in read.notes]
    if fit.clip is not None:
        notes.append(f"samples at the gyro's limit, {_of_sensor(fit.clip)}, are left out.")
    if fit.equal:
        notes.append(f"{fit.equal} within their errors: the axes between them are not determined.")
    if fit.degenerate is None:
        misses = [throw.rates - throw.predicted for throw in fit.throws]
        wider = f"the intervals are widened by {np.sqrt(fit.widened):.2g} for it, which may not be enough"
        notes += _misfit(misses, wider, "Look at the residuals by --figures, and give the free flight by --window")
        notes += _doubts(fit)
        chosen = next((score for score in fit.criterion if score.chosen), None)
        others = [score for score in fit.criterion if not score.chosen]
        if chosen and others and min(score.aicc for score in others) - chosen.aicc < BARELY:
            notes.append("the criterion hardly prefers the chosen model to the next one; see the table of models.")
        if fit.gain is None:
            notes.append("no gains were fitted, so the intervals hold for a calibrated gyro: a gain or cross-axis "
                         "sensitivity of 1 % moves the ratios by about as much.")  # fmt: skip
    return notes


def attitude_notes(fit: AttitudeFit) -> list[str]:
    """Return what a reader should know of a fit of attitudes."""
    if fit.degenerate is not None:
        return []
    remedy = "Look at the residuals by --figures: a torque may act that changes in the body"
    notes = [] if fit.rms < EXACT else _misfit([fit.residuals], "the intervals are too narrow", remedy)
    if fit.equal:
        notes.append(f"{fit.equal} within their errors: the axes between them are not determined.")
    return notes


def _doubts(fit: ThrowFit) -> list[str]:
    """Return notes on what makes numbers of a fit less sure than they look."""
    notes = []
    if fit.rotor is not None:
        size = float(np.linalg.norm(fit.rotor.value))
        notes.append(f"a wheel turns in the body, by what the rates say: its momentum is {size:.3g} rad/s of the "
                     "largest moment. The moments are of the body with the wheel; where no motor keeps its speed, "
                     "without the wheel's own moment about its axis.")  # fmt: skip
    if fit.with_or_without:
        notes.append("the log can hardly tell whether a wheel turns in the body: the intervals reach from what it says "
                     "with one to what it says without. --rotor or --no-rotor decides it.")  # fmt: skip
    size = float(np.abs(fit.bias.value).max())
    if size > LARGE_BIAS and fit.rest is None:
        notes.append(f"the bias is large, {size:.2g} rad/s, and no rest in the log confirms it: it may stand for "
                     "something that the motion does not explain, and the ratios may be wrong by more than their "
                     "intervals. Let the device lie still for a second before and after the throw.")  # fmt: skip
    elif fit.rest is None:
        notes.append(f"no rest was found in the log, so that the bias was assumed to be 0 ± {BIAS_SPREAD:.2g} rad/s "
                     "along each axis: with a larger one the bias and its errors are wrong, and so may the ratios be. "
                     "Let the device lie still for a second before and after the throw.")  # fmt: skip
    if fit.beside_wheel is not None and fit.ratios is not None and not fit.with_or_without:
        both = np.stack([fit.beside_wheel, fit.ratios.standard_error])
        if (both[0] > HIDDEN * both[1]).any():
            first, second = (f"{error:.2g}" for error in both[0])
            notes.append("it is assumed that no wheel turns in the body: if one might, the log would tell I1/I3 only "
                         f"to ± {first} and I2/I3 to ± {second}, and the intervals are too narrow. Throw it longer, "
                         "or with more tumble, to tell them apart.")  # fmt: skip
    if fit.unmodelled > PUSHED:
        notes.append(f"a torque acts that no model has, about {fit.unmodelled:.2g} I3 |ω|²: the intervals allow for "
                     "it.")  # fmt: skip
    if fit.gain is not None and fit.gain_spread > LARGER * GAIN_SPREAD:
        notes.append(f"the gyro's gains are off by about {100 * fit.gain_spread:.2g} %, more than expected: the "
                     "intervals allow for it.")  # fmt: skip
    return notes


def _misfit(residuals: Sequence[Array], so: str, remedy: str) -> list[str]:
    """Return a note where neighbouring residuals are alike: then the model does not explain the data."""
    pairs = [(r[:-1], r[1:]) for r in residuals if len(r) > 2]
    alike = sum(float((a * b).sum()) for a, b in pairs) / max(sum(float((a * a).sum()) for a, _ in pairs), 1e-300)
    if alike < ALIKE:
        return []
    said = f"neighbouring residuals are alike (correlation {alike:.2f}): the fitted motion does not explain the data"
    return [f"{said}, and {so}. {remedy}."]


def attitude_summary(fit: AttitudeFit) -> str:
    """Return the answer of a log of attitudes in a sentence."""
    if fit.degenerate is not None or fit.ratios is None:
        return f"The inertia cannot be told. {_sentence(fit.degenerate or '')}"
    said = ", ".join(f"{name} = {uncertain(value, error)}" for name, value, error in _each(fit.ratios))
    return f"{said}; {_named(fit.regime)}, residuals {fit.rms:.2g} rad rms."


def attitude_groups(fit: AttitudeFit, moments: Estimate | None) -> list[Group | Table]:
    """Return what a fit of attitudes says, by groups."""
    span = [float(fit.times[0]), float(fit.times[-1])]
    return [_inertia(fit), *_moments(moments), _axes(fit), *_torque(fit, moments), Group("Fit", [
        Answer("rms", fit.rms, "rad", "residuals", "root mean square", f"{fit.rms:.3g} rad rms"),
        Answer("sigma", fit.sigma, "rad", "noise of an attitude", "about each axis", f"{fit.sigma:.3g} rad"),
        Answer("rate_sigma", fit.rate_sigma, "rad/s", "noise of a rate", "along each axis",
               None if fit.rate_sigma is None else f"{fit.rate_sigma:.3g} rad/s"),
        Answer("samples", len(fit.times), "", "samples used"),
        Answer("window", span, "s", "times", "", f"{span[0]:.6g} to {span[1]:.6g} s"),
        Answer("regime", fit.regime, "", "regime"),
    ])]  # fmt: skip


def _torque(fit: AttitudeFit, moments: Estimate | None) -> list[Group]:
    """Return the constant torque, in N m too where a moment is known, and how the criterion decided."""
    both = len(fit.aicc) > 1
    better = fit.aicc["free"] - fit.aicc["torque"] if both else 0.0
    said = f"AICc {'prefers' if better > 0 else 'speaks against'} a torque by {abs(better):.3g}" if both else None
    torque, absolute = fit.torque, None
    if torque is not None and moments is not None:
        largest, error = float(moments.value[2]), float(moments.standard_error[2])
        size = np.hypot(torque.standard_error * largest, torque.value * error)
        absolute = Estimate(("Nx", "Ny", "Nz"), torque.value * largest, np.diag(size**2), torque.degrees_of_freedom)
    return [Group("Torque", [
        Answer("torque", None if torque is None else _values(torque), "rad/s²", "N/I3 along x, y, z",
               "constant in the body, over the largest moment; null where there is none",
               "none" if torque is None else f"{_listed(torque)} rad/s²"),
        Answer("torque_absolute", None if absolute is None else _values(absolute), "N m",
               "N along x, y, z", "", None if absolute is None else f"{_listed(absolute)} N m"),
        Answer("aicc", fit.aicc, "", "criterion" if both else "", "", said),
    ])]  # fmt: skip


def _inertia(fit: ThrowFit | AttitudeFit) -> Group:
    if fit.ratios is None:
        return Group("Inertia", [
            Answer("ratios", None),
            Answer("degenerate", fit.degenerate, "", "not determined", "", _sentence(fit.degenerate or "")),
            Answer("equal", None),
        ])  # fmt: skip
    intervals = fit.ratios.interval()
    answers = []
    for (name, value, error), (low, high) in zip(_each(fit.ratios), intervals.tolist(), strict=True):
        digits = known_digits(value, error, 16) + 2
        words = f"{uncertain(value, error)}, 95 %: {low:.{digits}g} to {high:.{digits}g}"
        found = {"value": value, "standard_error": error, "interval": [low, high]}
        answers.append(Answer(f"ratios.{name}", found, "", name, "interval of 95 %", words))
    return Group("Inertia", [
        *answers, Answer("degenerate", None), Answer("equal", fit.equal, "", "equal within errors"),
    ])  # fmt: skip


def _moments(moments: Estimate | None) -> list[Group]:
    if moments is None:
        return []
    return [Group("Moments", [
        Answer("moments.value", moments.value.tolist(), "kg m²", "I1, I2, I3", "", f"{_listed(moments)} kg m²"),
        Answer("moments.standard_error", moments.standard_error.tolist(), "kg m²"),
    ])]  # fmt: skip


def _axes(fit: ThrowFit | AttitudeFit) -> Group:
    axes, turn = fit.axes, fit.axes_error
    named = []
    for k in range(3):
        words = None
        if axes is not None:
            words = ", ".join(f"{x:+.4f}" for x in axes[:, k])
            if turn is not None:  # an axis tilts by the turns about the other two
                tilt = float(np.sqrt(np.sum(np.delete(turn.standard_error, k) ** 2)))
                words += f"  ± {np.degrees(tilt):.2g}°" if tilt < 1.0 else "  (direction not determined)"
        named.append(Answer("", None, "", f"axis {k + 1} along x, y, z", "", words))
    error = None if turn is None else turn.standard_error.tolist()
    return Group("Principal axes in the device", [
        *named,
        Answer("axes", None if axes is None else axes.tolist(), "", "", "principal axes by columns, in device axes"),
        Answer("axes_error", error, "rad", "", "standard deviations of turns about the axes themselves"),
    ])  # fmt: skip


def _gyro(fit: ThrowFit) -> Group:
    sure = fit.degenerate is None
    rest, gain, cross = fit.rest, fit.gain, fit.cross_axis
    return Group("Gyro and air", [
        Answer("bias", _values(fit.bias) if sure else None, "rad/s", "bias", "along the device's x, y, z",
               _bias_in_words(fit) if sure else None),
        Answer("rest", None if rest is None else _values(rest), "rad/s", "bias at rest",
               "known beforehand to this; null where no log has rests",
               None if rest is None else f"{_listed(rest)} rad/s"),
        Answer("gain", None if gain is None else _values(gain), "", "gains", "along the device's x, y, z",
               None if gain is None else _listed(gain)),
        Answer("cross_axis", None if cross is None else _values(cross), "", "cross-axis gains",
               "of y and z, x and z, x and y", None if cross is None else _listed(cross)),
        Answer("gain_spread", fit.gain_spread if sure and gain is not None else None, "", "",
               "standard deviation of the gains, by the log and by what was known beforehand"),
        _torque_of("drag", fit.drag, "", "drag c/I3", "−c_i |ω| ω_i", "none" if sure else None),
        _torque_of("linear_drag", fit.linear_drag, "1/s", "linear drag b/I3", "−b_i ω_i"),
        _torque_of("one_sided_drag", fit.one_sided_drag, "", "one-sided drag d/I3", "−d_i |ω| |ω_i|"),
        Answer("rotor", None if fit.rotor is None else _values(fit.rotor), "rad/s", "wheel's momentum h/I3",
               "along the principal axes; null where none is fitted",
               ("none assumed" if sure else None) if fit.rotor is None else f"{_listed(fit.rotor)} rad/s"),
        Answer("beside_wheel", None if fit.beside_wheel is None else fit.beside_wheel.tolist(), "", "",
               "standard errors of the ratios if a wheel might turn in the body; null where one was fitted"),
        Answer("unmodelled", fit.unmodelled if sure else None, "", "",
               "torque over I3 |ω|² that no model has, rms; intervals allow for it"),
        Answer("widened", fit.widened if sure else None, "", "",
               "factor on the variances of the noise, because neighbouring residuals are alike"),
    ])  # fmt: skip


def _bias_in_words(fit: ThrowFit) -> str:
    assumed = "" if fit.rest is not None else f" (no rest: assumed to be 0 ± {BIAS_SPREAD:.2g})"
    return f"{_listed(fit.bias)} rad/s{assumed}"


def _torque_of(key: str, found: Estimate | None, unit: str, label: str, torque: str, words: str | None = None
               ) -> Answer:  # fmt: skip
    if found is None:
        return Answer(key, None, unit, label if words else "", "", words)
    about = f"of the torque {torque} along the principal axes; null where there is none"
    return Answer(key, _values(found), unit, label, about, f"{_listed(found)} {unit}".strip())


def _quality(fit: ThrowFit) -> Group:
    sure = fit.degenerate is None and len(fit.residuals) > 0
    first = fit.throws[0]
    how = "as given" if first.window.reason == "given" else first.window.reason
    how += f"; {counted(len(fit.throws) - 1, 'more throw')} below" if len(fit.throws) > 1 else ""
    return Group("Fit", [
        Answer("rms", fit.rms if sure else None, "rad/s", "residuals", "root mean square",
               f"{fit.rms:.3g} rad/s rms" if sure else None),
        Answer("sigma", fit.sigma if sure else None, "rad/s", "noise of a sample", "",
               f"{fit.sigma:.3g} rad/s" if sure else None),
        Answer("jitter", fit.jitter if sure else None, "s", "jitter of the clock" if fit.jitter > 0 else "", "",
               f"{fit.jitter:.2g} s rms" if sure else None),
        Answer("samples", sum(len(throw.times) for throw in fit.throws), "", "samples used"),
        Answer("clip", fit.clip, "rad/s", "gyro's limit", "", None if fit.clip is None else _of_sensor(fit.clip)),
        Answer("window", [first.window.start, first.window.end], "s", "free flight", "of the first throw",
               f"{first.window.start:.6g} to {first.window.end:.6g} s, {how}"),
        Answer("regime", first.regime, "", "", "of the first throw"),
    ])  # fmt: skip


def _throws(fit: ThrowFit, names: Sequence[str]) -> Table:
    rows: list[dict[str, Any]] = []
    for throw in fit.throws:
        motion = throw.motion
        rows.append({
            "log": names[throw.log], "window": [throw.window.start, throw.window.end],
            "found_by": throw.window.reason, "samples": len(throw.times), "regime": throw.regime,
            "period": None if motion is None else float(motion.period),
            "fastest": float(np.linalg.norm(throw.rates, axis=1).max()),
        })  # fmt: skip
    return Table("throws", "Throws", {
        "log": lambda row: row["log"],
        "from – to": lambda row: f"{row['window'][0]:.4g} – {row['window'][1]:.4g} s",
        "samples": lambda row: str(row["samples"]),
        "motion": lambda row: row["regime"] or "–",
        "polhode period": lambda row: f"{row['period']:.4g} s" if row["period"] and np.isfinite(row["period"]) else "–",
        "up to": lambda row: f"{row['fastest']:.3g} rad/s",
    }, rows, {"window": "s", "period": "s", "fastest": "rad/s"})  # fmt: skip


def _models(fit: ThrowFit) -> Table:
    least = min((score.aicc for score in fit.criterion), default=0.0)
    rows = [{"drag": s.drag, "rotor": s.rotor, "gain": s.gain, "parameters": s.parameters, "aicc": s.aicc,
             "bic": s.bic, "rms": s.rms, "chosen": s.chosen} for s in fit.criterion]  # fmt: skip
    return Table("models", "Models, by Akaike's corrected criterion", {
        "model": lambda row: ("bias" + (", gains" if row["gain"] else "") + (", a wheel" if row["rotor"] else "")
                              + ("" if row["drag"] == "none" else f", {row['drag']} drag")),
        "parameters": lambda row: str(row["parameters"]),
        "AICc above the least": lambda row: f"{row['aicc'] - least:.1f}",
        "residuals": lambda row: f"{row['rms']:.3g} rad/s",
        "": lambda row: "chosen" if row["chosen"] else "",
    }, rows, {"rms": "rad/s"})  # fmt: skip


def _logs(names: Sequence[str], logs: Sequence[ReadLog]) -> Table:
    rows: list[dict[str, Any]] = []
    for name, read in zip(names, logs, strict=True):
        log = read.log
        rows.append({
            "file": name, "header_of": read.dialect, "samples": len(log.times), "first": float(log.times[0]),
            "last": float(log.times[-1]), "usual_step": float(np.median(np.diff(log.times))), "unit": read.rate_unit,
            "acceleration_from": read.acceleration_from, "dropped": log.dropped, "repeated": log.repeats,
        })  # fmt: skip
    return Table("logs", "Logs", {
        "log": lambda row: row["file"],
        "header of": lambda row: row["header_of"],
        "samples": lambda row: f"{row['samples']}, {row['first']:.4g} to {row['last']:.4g} s",
        "rate": lambda row: f"{1.0 / row['usual_step']:.4g} Hz",
        "unit": lambda row: row["unit"],
        "accelerations": lambda row: row["acceleration_from"] or "none",
    }, rows, {"first": "s", "last": "s", "usual_step": "s"})  # fmt: skip


def _named(regime: str | None) -> str:
    words = {"short-axis": "turning about the axis of the largest moment", "separatrix": "on the separatrix",
             "long-axis": "turning about the axis of the smallest moment", "permanent": "a steady spin"}  # fmt: skip
    return words.get(regime or "", regime or "–")


def _each(estimate: Estimate) -> list[tuple[str, float, float]]:
    return list(zip(estimate.names, estimate.value.tolist(), estimate.standard_error.tolist(), strict=True))


def _values(estimate: Estimate) -> dict[str, Any]:
    return {"value": estimate.value.tolist(), "standard_error": estimate.standard_error.tolist()}


def _listed(estimate: Estimate) -> str:
    return ", ".join(uncertain(value, error) for _, value, error in _each(estimate))


def _sentence(text: str) -> str:
    text = text.strip()
    return text[:1].upper() + text[1:] + ("" if text.endswith(".") else ".")


def _of_sensor(rate: float) -> str:
    """Return a rate [rad/s] as data sheets of gyros state their ranges.

    >>> _of_sensor(34.906585)
    '2000 deg/s (34.9066 rad/s)'
    """
    return f"{np.degrees(rate):.6g} deg/s ({rate:.6g} rad/s)"
