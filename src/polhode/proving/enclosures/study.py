"""Proved enclosures of the motion of a spec: the report that ``polhode certify`` prints."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path
from typing import Any, ClassVar

from polhode.errors import InvalidInput, shown
from polhode.kinds.reading import read_spec
from polhode.kinds.registry import closed_form_kinds
from polhode.proving.enclosures._motion_starts import GIVEN
from polhode.proving.enclosures.certification import certify
from polhode.proving.enclosures.decimals import exact_numbers
from polhode.proving.enclosures.enclosed_numbers import EnclosedNumber, EnclosedState
from polhode.proving.enclosures.motion_enclosures import FreeEnclosure, MotionEnclosure, TopEnclosure
from polhode.reports.answer import Answer, Group, Table
from polhode.reports.report import StudyReport
from polhode.spec.units import parse_exactly
from polhode.studies.naming import name_file_in_errors

IN_THE_FILE = "the decimals in the file"
COMPONENTS = (*(("attitude", k, "") for k in "wxyz"), *(("momentum", f"L{k}", "kg m²/s") for k in "123"))
# name, label and unit of each number; the period comes first
OF_BODIES = (
    ("period", "polhode period T", "s"), ("precession_per_period", "precession per period", "rad"),
    ("precession_rate", "mean precession", "rad/s"), ("geometric_phase", "geometric phase", "rad"),
    ("solid_angle", "solid angle of the cap", "sr"), ("action", "action", "J s"), ("energy", "energy", "J"),
    ("momentum_norm", "|L|", "kg m²/s"), ("momentum_square", "|L|²", "kg² m⁴/s²"),
)  # fmt: skip
OF_TOPS = (
    ("nutation_period", "nutation period T", "s"), ("precession_per_period", "precession per period Δφ", "rad"),
    ("spin_per_period", "own turn per period Δψ", "rad"), ("precession_rate", "mean precession", "rad/s"),
    ("spin_rate", "mean own turn", "rad/s"), ("action", "action of the nutation", "J s"), ("energy", "energy", "J"),
    ("vertical_momentum", "vertical momentum", "kg m²/s"), ("axial_momentum", "axial momentum", "kg m²/s"),
)  # fmt: skip
NUMBERS: dict[type, Sequence[tuple[str, str, str]]] = {FreeEnclosure: OF_BODIES, TopEnclosure: OF_TOPS}


@dataclass(frozen=True)
class CertifyReport(StudyReport):
    """Enclosures of the constants of a motion in closed form, and of its states at some times.

    Attributes:
        name: of the body.
        enclosure: of the motion.
        states: time as given → the state's.
    """

    kind: ClassVar[str] = "certify"
    name: str
    enclosure: MotionEnclosure
    states: Mapping[str, EnclosedState]

    @property
    def summary(self) -> str:
        period = getattr(self.enclosure, NUMBERS[type(self.enclosure)][0][0])
        verdict = "" if self.enclosure.verdict is None else f", {self.enclosure.verdict}"
        regime = f"The motion is in the regime {self.enclosure.regime}{verdict}, decided in exact arithmetic."
        if period is None:
            return regime
        return f"{regime} Its period is {_words(period, 's')}."

    @property
    def answers(self) -> list[Group | Table]:
        return [self._taken(), self._numbers(), self._verdicts(), *([self._states()] if self.states else [])]

    @property
    def notes(self) -> list[str]:
        if not self.states:
            return []
        return ["states are along the principal axes; the attitude takes them to space, as a unit quaternion."]

    def _taken(self) -> Group:
        words = {name: IN_THE_FILE if how == GIVEN else how for name, how in self.enclosure.taken.items()}
        return Group("Numbers, exactly as", [
            Answer(f"taken.{name}", how, "", name.replace("_", " ")) for name, how in words.items() if name != "epoch"
        ])

    def _numbers(self) -> Group:
        enclosure = self.enclosure
        answers = [Answer("regime", enclosure.regime, "", "regime"), Answer("digits", enclosure.digits)]
        if isinstance(enclosure, FreeEnclosure):
            axis = None if enclosure.encircled_axis is None else enclosure.encircled_axis + 1
            answers.append(Answer("encircled_axis", axis, "", "encircled axis"))
        if isinstance(enclosure, TopEnclosure):
            low, high = enclosure.nutation_limits
            answers += [*_enclosed("nutation_limits.lowest", low, "least cos of the tilt", ""),
                        *_enclosed("nutation_limits.highest", high, "largest cos of the tilt", "")]
        for name, label, unit in NUMBERS[type(enclosure)]:
            answers += _enclosed(name, getattr(enclosure, name), label, unit)
        return Group("Enclosures: the number lies in value ± radius", answers)

    def _verdicts(self) -> Group:
        what = "spin about " if isinstance(self.enclosure, FreeEnclosure) else "axis "
        answers = [Answer(f"verdicts.{name.replace(' ', '_')}", verdict, "", f"{what}{name}")
                   for name, verdict in self.enclosure.verdicts.items()]
        return Group("Stability, by comparison of exact numbers", [*answers, Answer("verdict", self.enclosure.verdict)])

    def _states(self) -> Table:
        rows: list[dict[str, Any]] = []
        for time, state in self.states.items():
            numbers = (*state.attitude, *state.momentum)
            for (part, name, unit), number in zip(COMPONENTS, numbers, strict=True):
                rows.append({"time": time, "part": part, "component": name, "unit": unit, **_parts(number)})
        return Table("states", "States", {
            "at": lambda row: row["time"] if row["component"] == "w" else "",
            "": lambda row: row["component"],
            "value": lambda row: f"{row['decimals']} ± {row['radius']} {row['unit']}".rstrip(),
        }, rows)


def certify_report(path: Path, digits: int, at: Sequence[str]) -> CertifyReport:
    """Return the report on a spec.

    Args:
        path: of the spec.
        digits: of each enclosure.
        at: times of states, quantities like "1e9 s", taken as exact decimals.

    Raises:
        InvalidInput: for a kind without a closed form, an invalid time, or as the spec and ``certify`` do.
    """
    times = {text: _exact_time(text) for text in at}
    with name_file_in_errors(path):
        spec = read_spec(path)
        motion = spec.kind.closed_form(spec)
        if motion is None:
            raise InvalidInput(
                f"{path}: the system {spec.kind.name} has no closed form, which enclosures of so many digits need; "
                f"{' and '.join(closed_form_kinds())} have one. In Python, `polhode.certify` proves bounds for other "
                "systems."
            )
        # the numbers of a free body are those in the file; a top's are about its pivot
        of_file = None if motion.free_moments is None else spec.body
        exact = {} if of_file is None else exact_numbers(path, of_file.principal_axes)
        enclosure = certify(motion, digits=digits, exact=exact)
        return CertifyReport(spec.name, enclosure, {text: enclosure.state(time) for text, time in times.items()})


def _exact_time(text: str) -> Fraction:
    try:
        time = parse_exactly(text, "s")
    except ValueError as error:
        raise InvalidInput(f"`at` {error}.") from None
    if time is None:
        raise InvalidInput(f"`at` must be in a unit that is a decimal of the second, like s; got {shown(text)}.")
    return time


def _enclosed(name: str, number: EnclosedNumber | None, label: str, unit: str) -> list[Answer]:
    """Return the answers on a number: value, decimals and radius, of which the text has one line."""
    if number is None:
        return [Answer(name, None)]
    parts = _parts(number)
    return [Answer(f"{name}.value", parts["value"], unit, label, "the nearest double", _words(number, unit)),
            Answer(f"{name}.decimals", parts["decimals"], unit, "", "text"),
            Answer(f"{name}.radius", parts["radius"], unit, "", "text, around the decimals")]  # fmt: skip


def _parts(number: EnclosedNumber) -> dict[str, Any]:
    middle, radius = number.parts
    return {"value": float(number), "decimals": middle, "radius": radius or "0"}


def _words(number: EnclosedNumber, unit: str) -> str:
    if float(number) == float("inf"):
        return "infinite"
    return f"{number} {unit}".rstrip()
