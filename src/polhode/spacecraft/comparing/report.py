"""The report on a comparison of two attitude histories."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING, ClassVar, NamedTuple

import numpy as np

from polhode.errors import one_line
from polhode.reports.answer import Answer, Group, Table
from polhode.reports.report import StudyReport
from polhode.reports.wording import KEPT, angle, count_known_digits, number, vector
from polhode.spacecraft.comparing._clock_offset import ClockOffset
from polhode.spacecraft.comparing.comparison import Comparison, Invariants

if TYPE_CHECKING:
    from matplotlib.figure import Figure

NAMES = {"energy": "energy", **KEPT, "vertical_momentum": "L upwards"}
INVARIANT_UNITS = {"energy": "J"}


class ReportLimits(NamedTuple):
    """What the report says of small differences, and of a fit."""

    min_angle: float = 3e-16  # rad; rounding of a quaternion's components alone makes as much
    max_left: float = 0.01  # rad, by which a fit explains most of a difference; more is another motion
    max_share_left: float = 0.1  # of the rms angle; nine numbers fitted to any angles leave a third of it


LIMITS = ReportLimits()


@dataclass(frozen=True)
class ComparisonReport(StudyReport):
    """The report on a comparison of two attitude histories.

    Attributes:
        comparison: the numbers.
        clocks: how the two clocks were related.
        aligned: their offset, A's clock at B's zero, where it was estimated.
        warned: further caveats.
        unknown: why energy and momentum are unknown for both, where they are.
        reading: how tables among the two were understood.
    """

    kind: ClassVar[str] = "comparison"
    comparison: Comparison
    clocks: str
    aligned: ClockOffset | None = None
    warned: tuple[str, ...] = ()
    unknown: str = "energy and momentum need the body's moments; give a spec of a free body or top with `spec`."
    reading: tuple[Group, ...] = ()

    @property
    def name(self) -> str:
        first, second = self.comparison.names
        return one_line(f"{first} (A) and {second} (B)")

    @property
    def summary(self) -> str:
        """The result in a sentence or two."""
        comparison = self.comparison
        if comparison.is_rounding:
            size = f"{max(comparison.largest, LIMITS.min_angle):.1e} rad"
            if len(comparison.times) == 1:
                return f"Both agree to {size} at the only time they have in common; nothing is known of other times."
            return f"Both agree to {size}: to rounding."
        if len(comparison.times) == 1:
            return f"They differ by {self._word_angle(comparison.largest)} at the only time they have in common."
        text = f"They differ by up to {self._word_angle(comparison.largest)}, {self._word_angle(comparison.rms)} rms"
        noise = comparison.noise
        if comparison.is_noise:
            return f"{text}: no more than the noise of the samples, {noise:.2g} rad."
        if comparison.alignment is None:
            return f"{text}."
        rest = float(comparison.alignment.remaining.max())
        fit, share = "Constant misalignments and a constant rate", comparison.alignment.rms / comparison.rms
        if comparison.explained:
            return f"{text}. {fit} explain all but {rest:.3g} rad of it, which is no more than errors of the samples."
        beyond = f", {comparison.alignment.rms / noise:.3g} times the noise of the samples" if noise else ""
        if share < LIMITS.max_share_left and rest < LIMITS.max_left:
            return f"{text}. {fit} explain most of it; the best fit leaves {rest:.3g} rad{beyond}."
        return f"{text}. {fit} do not explain it: the best fit leaves {rest:.3g} rad."

    @property
    def answers(self) -> list[Group | Table]:
        fit = [Group("", [Answer("alignment", None)])] if self.comparison.alignment is None else [self._fit()]
        names = Group("", [Answer("names", self.comparison.names)])
        return [names, *self.reading, self._times(), self._angle(), *fit, *self._invariants()]

    def _times(self) -> Group:
        comparison = self.comparison
        first, last, missed = float(comparison.times[0]), float(comparison.times[-1]), comparison.interpolation_error
        words = None if missed is None else f"less than {missed:.2g} rad"
        sources = [
            Answer("", None, "", f"angular velocity of {side}", "", None if kept is None else kept.source)
            for side, kept in zip("AB", comparison.invariants, strict=True)
        ]
        return Group("Times", [
            Answer("clocks", self.clocks, "", "clocks"),
            *self._offset(),
            Answer("times.first", first, "s", "compared from", "A's", f"{first:.9g} to {last:.9g} s of A"),
            Answer("times.last", last, "s", "", "A's"),
            Answer("times.samples", len(comparison.times), "", "samples", "", str(len(comparison.times))),
            Answer("method", comparison.method, "", "how"),
            Answer("interpolation_error", missed, "rad", "interpolation misses", "", words),
            *sources,
        ])

    def _offset(self) -> list[Answer]:
        """Return the estimated offset of the clocks; empty where it was given."""
        aligned = self.aligned
        if aligned is None:
            return []
        agreeing = None if aligned.agreeing is None else dict(zip(("value", "error"), aligned.agreeing, strict=True))
        return [
            Answer("clock_offset.value", aligned.offset, "s"),
            Answer("clock_offset.error", aligned.error, "s"),
            Answer("clock_offset.turned", aligned.turned),
            Answer("clock_offset.supposes_body_axes", aligned.supposed),
            Answer("clock_offset.if_body_axes_agree", agreeing, "s"),
        ]

    def _angle(self) -> Group:
        comparison = self.comparison
        sizes = {"largest": comparison.largest, "rms": comparison.rms,
                 "first": comparison.angle[0], "last": comparison.angle[-1]}  # fmt: skip
        unseen = comparison.growth is None or comparison.is_rounding
        noise = None if comparison.noise is None else f"{comparison.noise:.2g} rad"
        growth = None if unseen else f"{comparison.growth:.{self._digits(6)}g} rad/s"
        said = "" if growth is None else "growth, best line"
        return Group("Angle between them", [
            *(Answer(f"angle.{name}", x, "rad", name, "", self._word_tiny(float(x))) for name, x in sizes.items()),
            Answer("noise", comparison.noise, "rad", "noise of the samples", "rms", noise),
            Answer("growth", comparison.growth, "rad/s", said, "", growth),
        ])

    def _fit(self) -> Group:
        fit = self.comparison.alignment
        assert fit is not None
        largest, turning = float(fit.remaining.max()), vector(fit.rate, "rad/s, space axes", digits=self._digits(6))
        missed = self.comparison.interpolation_error
        most, mean = (f"{x:.{count_known_digits(x, missed, 6)}g} rad" for x in (largest, fit.rms))
        rest, share = f"{most}, {mean} rms", fit.rms / self.comparison.rms
        explains = "yes" if self.comparison.explained else f"no, {100.0 * share:.3g} % of the rms angle remains"
        if self.comparison.is_noise:
            explains = "there is nothing to explain: the angle is noise"
        axes = {side: vector(getattr(fit, side), "rad", digits=self._digits(6)) for side in ("body", "space")}
        return Group("Best fit, A = turn(rate · t) · space · B · body", [
            Answer("alignment.body", fit.body, "rad", "body axes misaligned by", "", axes["body"]),
            Answer("alignment.space", fit.space, "rad", "space axes misaligned by", "", axes["space"]),
            Answer("alignment.rate", fit.rate, "rad/s", "turning at", "space axes", turning),
            Answer("alignment.remaining.largest", largest, "rad", "angle that remains", "", rest),
            Answer("alignment.remaining.rms", fit.rms, "rad"),
            Answer("alignment.determined", fit.determined),
            Answer("alignment.explains", self.comparison.explained, "", "explains it", "", explains),
        ])

    def _word_angle(self, value: float) -> str | None:
        """Return an angle [rad] in words, without digits finer than the error of interpolation."""
        return angle(value, self.comparison.interpolation_error)

    def _word_tiny(self, value: float) -> str | None:
        """Return an angle [rad] in words; angles below the rounding of a quaternion have no digits."""
        if value == 0.0:
            return "0"
        return f"less than {LIMITS.min_angle:.0e} rad" if value < LIMITS.min_angle else self._word_angle(value)

    def _digits(self, most: int) -> int:
        """Return the number of known digits of quantities fitted to the angles."""
        return count_known_digits(self.comparison.largest, self.comparison.interpolation_error, most)

    def _invariants(self) -> list[Group | Table]:
        both = self.comparison.invariants
        rows = [
            {"of": side, "name": name, "first": _first(kept, name), "drift": change}
            for side, kept in zip("AB", both, strict=True) if kept is not None for name, change in kept.drift.items()
        ]
        columns = {
            "of": lambda row: row["of"], "invariant": lambda row: NAMES[row["name"]],
            "at first": lambda row: row["first"], "drift, relative": lambda row: f"{row['drift']:.2e}",
        }  # fmt: skip
        values = [
            None if kept is None else {
                "source": kept.source, "drift": kept.drift,
                "first": {name: value[0] for name, value in kept.values.items()},
            } for kept in both
        ]
        answer = Answer("invariants", values, explanation="drift is relative")
        return [Group("", [answer]), Table("", "Invariants", columns, rows)]

    @property
    def notes(self) -> list[str]:
        comparison, notes = self.comparison, list(self.warned)
        if comparison.alignment is not None and not comparison.alignment.determined:
            notes.append("the motion does not determine all misalignments and the rate: others would fit equally well.")
        if comparison.interpolation_error is not None and comparison.largest <= comparison.interpolation_error:
            notes.append("the angle is no larger than the error of interpolation, and may be due to it.")
        if comparison.invariants == (None, None):
            notes.append(self.unknown)
        return notes

    def figures(self) -> Mapping[str, Callable[[], Figure | None]]:
        from polhode.spacecraft.comparing.figure import comparison

        return {"comparison": partial(comparison, self.comparison)}


def _first(kept: Invariants, name: str) -> str:
    value = np.asarray(kept.values[name][0])
    unit = INVARIANT_UNITS.get(name, "kg m²/s")
    return (vector(value.tolist(), unit) if value.ndim else number(float(value), unit)) or ""
