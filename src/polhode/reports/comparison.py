"""What a comparison of two attitude histories says, in words and as values."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from polhode.analysis.comparison import Comparison, Invariants
from polhode.reports.base import Listing, Section, plain
from polhode.reports.wording import angle, number, vector

Array = Any
UNITS = {
    "times": "s, A's", "angle": "rad", "growth": "rad/s", "alignment": "rad, rad/s", "interpolation_error": "rad",
    "invariants.drift": "relative",
}  # fmt: skip
LEAST = 1e-16  # rad; rounding of a quaternion's components alone makes more
NAMES = {"energy": "energy", "momentum_norm": "|L|", "momentum_space": "L in space", "vertical_momentum": "L upwards"}
INVARIANT_UNITS = {"energy": "J"}


@dataclass(frozen=True)
class ComparisonReport:
    """A comparison, and what its reader should know of how it was made.

    Attributes:
        comparison: the numbers.
        clocks: how the two times were laid side by side.
        notes: what else there is to know.
        unknown: why energy and momentum of neither are known, where they are not.
    """

    comparison: Comparison
    clocks: str
    notes: tuple[str, ...] = ()
    unknown: str = "energy and momentum need the body's moments; give a spec of a free body or top with --spec."

    @property
    def summary(self) -> str:
        """The result in a sentence or two."""
        found = self.comparison
        if found.is_rounding:
            size = f"{max(found.largest, LEAST):.1e} rad"
            if len(found.times) == 1:
                return f"Both agree to {size} at the only time they have in common; nothing is known of other times."
            return f"Both agree to {size}: to rounding."
        if len(found.times) == 1:
            return f"They differ by {angle(found.largest)} at the only time they have in common."
        text = f"They differ by up to {angle(found.largest)}, {angle(found.rms)} rms."
        if found.explained:
            assert found.alignment is not None
            rest = float(found.alignment.remaining.max())
            text += f" Constant misalignments and a constant rate explain all but {rest:.3g} rad of it."
        return text

    def sections(self) -> list[Section | Listing]:
        """Return the answers worded for people."""
        found = self.comparison
        first, last = float(found.times[0]), float(found.times[-1])
        growth = None if found.growth is None or found.is_rounding else f"{found.growth:.6g} rad/s"
        missed = None if found.interpolation_error is None else f"less than {found.interpolation_error:.2g} rad"
        sections: list[Section | Listing] = [
            Section("Times", [
                ("clocks", self.clocks), ("compared from", f"{first:.9g} to {last:.9g} s of A"),
                ("samples", str(len(found.times))), ("how", found.method), ("interpolation misses", missed),
                *((f"angular velocity of {side}", None if kept is None else kept.source)
                  for side, kept in zip("AB", found.invariants, strict=True)),
            ]),
            Section("Angle between them", [
                ("largest", _seen(found.largest)), ("rms", _seen(found.rms)),
                ("first", _seen(float(found.angle[0]))), ("last", _seen(float(found.angle[-1]))),
                ("growth, best line", growth),
            ]),
        ]  # fmt: skip
        return [*sections, *self._fit(), *self._invariants()]

    def _fit(self) -> list[Section | Listing]:
        fit = self.comparison.alignment
        if fit is None:
            return []
        rest = f"{float(fit.remaining.max()):.6g} rad, {fit.rms:.6g} rad rms"
        return [Section("Best fit, A = turn(rate · t) · space · B · body", [
            ("body axes misaligned by", vector(fit.body, "rad")),
            ("space axes misaligned by", vector(fit.space, "rad")),
            ("turning at", vector(fit.rate, "rad/s, space axes")), ("angle that remains", rest),
            ("explains it", "yes" if self.comparison.explained else "no"),
        ])]  # fmt: skip

    def _invariants(self) -> list[Section | Listing]:
        rows = []
        for side, kept in zip("AB", self.comparison.invariants, strict=True):
            for name, change in {} if kept is None else kept.drift.items():
                assert kept is not None
                rows.append((side, NAMES[name], _first(kept, name), f"{change:.2e}"))
        columns = ("of", "invariant", "at first", "drift, relative")
        return [Listing("Invariants", columns, rows)] if rows else []

    def all_notes(self) -> list[str]:
        """Return what a reader should know beside the numbers."""
        found, notes = self.comparison, list(self.notes)
        if found.alignment is not None and not found.alignment.determined:
            notes.append("the motion does not tell all misalignments and the rate apart: others would explain as much.")
        if found.interpolation_error is not None and found.largest <= found.interpolation_error:
            notes.append("the angle is no larger than what interpolation may miss: it may be the interpolation's own.")
        if found.invariants == (None, None):
            notes.append(self.unknown)
        return notes

    def as_json_dict(self) -> dict[str, Any]:
        """Return the answers as plain lists, numbers, strings and None."""
        found, fit = self.comparison, self.comparison.alignment
        alignment = None if fit is None else {
            "body": fit.body, "space": fit.space, "rate": fit.rate, "determined": fit.determined,
            "remaining": {"largest": fit.remaining.max(), "rms": fit.rms}, "explains": found.explained,
        }  # fmt: skip
        return plain({
            "names": found.names, "summary": self.summary, "clocks": self.clocks, "method": found.method,
            "times": {"first": found.times[0], "last": found.times[-1], "samples": len(found.times)},
            "angle": {"largest": found.largest, "rms": found.rms, "first": found.angle[0], "last": found.angle[-1]},
            "growth": found.growth, "interpolation_error": found.interpolation_error, "alignment": alignment,
            "invariants": [None if kept is None else {
                "source": kept.source, "drift": kept.drift,
                "first": {name: value[0] for name, value in kept.values.items()},
            } for kept in found.invariants],
            "notes": self.all_notes(), "units": UNITS,
        })  # fmt: skip


def _seen(value: float) -> str | None:
    """Return an angle [rad] in words, without digits of those that are less than rounding of a quaternion."""
    return "0" if value == 0.0 else f"less than {LEAST:.0e} rad" if value < LEAST else angle(value)


def _first(kept: Invariants, name: str) -> str:
    value = np.asarray(kept.values[name][0])
    unit = INVARIANT_UNITS.get(name, "kg m²/s")
    return (vector(value.tolist(), unit) if value.ndim else number(float(value), unit)) or ""
