"""The report on a tumbling body."""

from __future__ import annotations

import csv
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, ClassVar

import numpy as np

from polhode.celestial.tumbling.estimation import Tumbling
from polhode.celestial.tumbling.tumbler import Damping, LightCurve
from polhode.errors import InvalidInput, shown
from polhode.formats.paths import write_whole
from polhode.reports.answer import Answer, Group, Table
from polhode.reports.report import StudyReport
from polhode.reports.wording import angle, duration, in_its_unit, order_words, uncertain

if TYPE_CHECKING:
    from matplotlib.figure import Figure

CALM = {"short-axis": 3, "long-axis": 1}
EXTREME = {"short-axis": "largest", "long-axis": "smallest"}
WORDS = {"short-axis": "short-axis mode (SAM)", "long-axis": "long-axis mode (LAM)"}


@dataclass(frozen=True)
class TumbleReport(StudyReport):
    """The report on a tumbling body's motion.

    Attributes:
        name: of the body.
        source: of its periods; empty where the caller gave them.
        motion: the motion that has these periods.
        others: those of the other mode with the same periods.
        limits: least ratio of rotation to precession in each mode.
        light: its light curve; None for a flat body.
        damping: None where the friction is not known.
    """

    kind: ClassVar[str] = "tumble"
    name: str
    source: str
    motion: Tumbling
    others: tuple[Tumbling, ...]
    limits: tuple[float, float]
    light: LightCurve | None
    damping: Damping | None

    @property
    def summary(self) -> str:
        motion = self.motion
        low, high = (f"{np.degrees(x):.4g}°" for x in motion.tilts)
        mode = WORDS[motion.mode]
        axis = f"the axis of {EXTREME[motion.mode]} moment, axis {CALM[motion.mode]}"
        return (
            f"{mode[0].upper()}{mode[1:]}: L circles {axis}, at {low} to {high}; the energy is {_energy(motion)} times "
            "the least for this angular momentum."
        )

    @property
    def notes(self) -> list[str]:
        notes = []
        if self.others:
            notes.append(f"the {WORDS[self.others[0].mode]} has the same periods; only a light curve or an image can "
                         f'decide. `mode="{self.others[0].mode}"` takes the other.')
        interval = self.motion.interval
        if interval is not None and interval.admissible < 0.975:
            notes.append(f"only {100 * interval.admissible:.0f} % of the periods and moments within the errors have a "
                         "motion in this mode; the intervals are computed from these.")
        if self.light is None:
            notes.append("I1 + I2 = I3: the body is flat, and there is no ellipsoid to draw a light curve of.")
        return notes

    @property
    def answers(self) -> list[Group | Table]:
        return [_state(self.motion), _periods(self.motion), _body(self), *_describe_damping(self.damping),
                *_others(self.others), *_light(self)]  # fmt: skip

    def figures(self) -> Mapping[str, Callable[[], Figure | None]]:
        from polhode.celestial.tumbling.figures import light_curve, polhode, spectrum

        lit = {} if self.light is None else {
            "light_curve": partial(light_curve, self.light), "spectrum": partial(spectrum, self.light, self.motion)}
        return {"polhode": partial(polhode, self.name, self.motion, self.others), **lit}

    def _write_data(self, path: Path) -> Path:
        """Write the light curve as .csv, or a spec of the motion as .toml.

        Raises:
            InvalidInput: for another ending, and for the light curve of a flat body.
        """
        ending = path.suffix.lower()
        if ending not in (".csv", ".toml"):
            raise InvalidInput(f"{path}: must end in .csv (light curve) or .toml (spec); got {shown(path.suffix)}.")
        if ending == ".toml":
            with write_whole(path) as draft:
                draft.write_text(_spec(self), "utf-8")
            return path
        if self.light is None:
            why = "a flat body, I1 + I2 = I3, has no light curve here. Give moments of a solid body."
            raise InvalidInput(f"{path}: {why}")
        with write_whole(path) as draft, draft.open("w", encoding="utf-8", newline="") as file:
            writer = csv.writer(file)
            writer.writerow(["time [s]", "magnitude [mag]"])
            writer.writerows(zip(self.light.times.tolist(), self.light.magnitudes.tolist(), strict=True))
        return path

def _energy(motion: Tumbling) -> str:
    error = None if motion.interval is None else float(motion.interval.estimate.standard_error[0])
    return uncertain(motion.energy_ratio, error) if error else f"{motion.energy_ratio:.7g}"


def _state(motion: Tumbling) -> Group:
    axis = CALM[motion.mode]
    interval = motion.interval
    error = None if interval is None else interval.estimate.standard_error.tolist()
    calm = 2 * np.pi / motion.momentum_rate
    answers = [
        Answer("mode", motion.mode, "", "mode", "", f"{WORDS[motion.mode]}, the polhode runs round axis {axis}"),
        Answer("energy_ratio", motion.energy_ratio, "", "energy over the least", "E/E0, E0 = L²/2I3", _energy(motion)),
        Answer("cone_angle", motion.cone_angle, "rad", f"tilt of axis {axis} where L₂ = 0", "against L",
               _degrees(motion.cone_angle, None if error is None else error[1])),
        Answer("tilt", list(motion.tilts), "rad", f"tilt of axis {axis}", "least and greatest, against L",
               f"{np.degrees(motion.tilts[0]):.6g}° to {np.degrees(motion.tilts[1]):.6g}°"),
        Answer("momentum_rate", motion.momentum_rate, "rad/s", "L/I3", "the spin after all free energy has gone",
               f"{motion.momentum_rate:.6g} rad/s: one turn in {in_its_unit(calm)} when the body has calmed down"),
    ]  # fmt: skip
    if interval is not None and error is not None:
        for k, name in enumerate(("energy_ratio", "cone_angle", "momentum_rate")):
            spread = {"standard_error": error[k], "interval": [interval.low[k], interval.high[k]]}
            answers.append(Answer(f"errors.{name}", spread, "", "", "interval of 95 %"))
        low, high = interval.low[0], interval.high[0]
        answers.append(Answer("", None, "", "95 % of the energy ratio", "", f"{low:.6g} to {high:.6g}"))
        answers.append(Answer("admissible", interval.admissible, "", "",
                              "share of the draws within the errors that have a motion in this mode"))
    return Group("State", answers)


def _degrees(value: float, error: float | None) -> str | None:
    return angle(value) if not error else f"{uncertain(np.degrees(value), np.degrees(error))}°"


def _periods(motion: Tumbling) -> Group:
    named = {
        "precession": (motion.precession, "P_φ, the encircled axis about L"),
        "rotation": (motion.rotation, "P_ψ, along the body's axes"),
        "long_axis": (motion.long_axis, "the long axis about L"),
        "short_axis": (motion.short_axis, "the short axis about L"),
    }
    return Group("Mean periods", [
        Answer(f"periods.{name}", value, "s", words, "", duration(value)) for name, (value, words) in named.items()
    ])


def _body(report: TumbleReport) -> Group:
    motion = report.motion
    short, long = report.limits
    ratio = motion.rotation / motion.precession
    axes = None if report.light is None else report.light.semi_axes.tolist()
    said = [f"{limit:.4g} ({name})" for limit, name in ((short, "SAM"), (long, "LAM")) if np.isfinite(limit)]
    return Group("Body", [
        Answer("moments", motion.moments.tolist(), "", "I1, I2, I3 over I3", "over I3",
               ", ".join(f"{x:.6g}" for x in motion.moments)),
        Answer("semi_axes", axes, "", "equivalent ellipsoid a : b : c", "over a, of the uniform ellipsoid",
               None if axes is None else " : ".join(f"{x:.4g}" for x in axes)),
        Answer("period_ratio", ratio, "", "P_ψ/P_φ", "", f"{ratio:.5g}; possible: above {', '.join(said)}"),
        Answer("least_period_ratios", {"short-axis": _or_none(short), "long-axis": _or_none(long)}),
        Answer("source", report.source or None, "", "source"),
    ])


def _describe_damping(damping: Damping | None) -> list[Group]:
    if damping is None:
        return []
    assumed = (f"D = {damping.diameter:.4g} m, ρ = {damping.density:.4g} kg/m³, μQ = {damping.rigidity:.3g} Pa, "
               f"K₃² = {damping.shape_factor:.3g}")
    return [Group("Internal friction", [
        Answer("damping_time", damping.time, "s", "time of damping", "μQ/(ρ K₃² R² ω³), Burns & Safronov 1973",
               f"{duration(damping.time)}, within a factor of ten or so"),
        Answer("", None, "", "with", "", assumed),
        Answer("damping.diameter", damping.diameter, "m"), Answer("damping.density", damping.density, "kg/m³"),
        Answer("damping.rigidity", damping.rigidity, "Pa"), Answer("damping.shape_factor", damping.shape_factor),
    ])]  # fmt: skip


def _others(others: tuple[Tumbling, ...]) -> list[Table]:
    rows = [{"mode": other.mode, "energy_ratio": other.energy_ratio, "cone_angle": other.cone_angle,
             "tilt": list(other.tilts), "momentum_rate": other.momentum_rate} for other in others]
    return [Table("others", "Other motions with these periods", {
        "mode": lambda row: WORDS[row["mode"]],
        "E/E0": lambda row: f"{row['energy_ratio']:.6g}",
        "tilt of the encircled axis": lambda row: " to ".join(f"{np.degrees(x):.4g}°" for x in row["tilt"]),
    }, rows, {"cone_angle": "rad", "tilt": "rad", "momentum_rate": "rad/s"})]  # fmt: skip


def _light(report: TumbleReport) -> list[Group | Table]:
    light = report.light
    if light is None:
        return [Group("Light curve", [Answer("light_curve", None)])]
    spread = float(np.ptp(light.magnitudes))
    columns = zip(*(column.tolist() for column in light.lines), strict=True)
    rows = [{"precession_order": m, "rotation_order": n, "frequency": f, "amplitude": a} for m, n, f, a in columns]
    return [
        Group("Light curve of the ellipsoid", [
            Answer("aspect", light.aspect, "rad", "angle between L and the observer", "",
                   f"{np.degrees(light.aspect):.6g}°"),
            Answer("phase", light.phase, "rad", "phase angle", "", f"{np.degrees(light.phase):.6g}°"),
            Answer("range", spread, "mag", "range", "", f"{spread:.3g} mag, by the law of Lommel and Seeliger"),
        ]),
        Table("frequencies", "Frequencies, strongest first", {
            "frequency": lambda row: order_words(row["precession_order"], row["rotation_order"]),
            "period": lambda row: duration(1.0 / row["frequency"]) or "–",
            "amplitude": lambda row: f"{row['amplitude']:.4f} mag",
        }, rows, {"frequency": "1/s", "amplitude": "mag"}),
    ]  # fmt: skip


def _or_none(value: float) -> float | None:
    return value if np.isfinite(value) else None


def _spec(report: TumbleReport) -> str:
    motion = report.motion
    spin = np.asarray(motion.motion.angular_velocity(0.0)).tolist()
    moments = ", ".join(f'"{x:.17g} kg*m^2"' for x in motion.moments.tolist())
    rates = ", ".join(f'"{x:.17g} rad/s"' for x in spin)
    return (
        f"# {report.name}: {motion.mode} mode, P_phi = {motion.precession:.10g} s, P_psi = {motion.rotation:.10g} s.\n"
        f"# Periods leave the scale of the moments open; the largest is 1 kg m^2 here.\n"
        f'name = "{report.name}"\n\n[body]\nmoments = [{moments}]\n\n'
        f'[spin]\nangular_velocity = [{rates}]\nframe = "principal"\n\n[time]\nuntil = "{5 * motion.rotation:.10g} s"\n'
    )
