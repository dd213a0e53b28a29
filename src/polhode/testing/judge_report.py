"""The report of the judge: its verdict in words, the numbers behind it, and a figure of each motion."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING, Any, ClassVar

from polhode.analysis._engine_run import Drift, SpinEnd
from polhode.reports.answer import Answer, Group, Table
from polhode.reports.report import StudyReport
from polhode.testing._judging import Judgement

if TYPE_CHECKING:
    from matplotlib.figure import Figure


@dataclass(frozen=True, eq=False)
class JudgeReport(StudyReport):
    """What a judge found of an engine.

    Attributes:
        name: the engine's.
        judgements: one for each motion.
        refused: name of a case that could not be judged, and why.
    """

    kind: ClassVar[str] = "engine"
    name: str
    judgements: tuple[Judgement, ...]
    refused: tuple[tuple[str, str], ...] = ()

    @property
    def verdict(self) -> str:
        """Of all motions: "right", "wrong: …", "unexplained" or "undecided"."""
        verdicts = [word_verdict(one) for one in self.judgements]
        for kind in ("wrong", "unexplained", "undecided"):
            if worst := [verdict for verdict in verdicts if verdict.startswith(kind)]:
                return worst[0]
        return "right" if verdicts else "undecided"

    @property
    def summary(self) -> str:
        if not self.judgements:
            return f"Nothing was judged: {len(self.refused)} of {len(self.refused)} cases were refused."
        if len(self.judgements) == 1:
            return " ".join(filter(None, (describe_verdict(self.judgements[0]), *describe_motion(self.judgements[0]))))
        counts: dict[str, int] = {}
        for one in self.judgements:
            counts[word_verdict(one)] = counts.get(word_verdict(one), 0) + 1
        said = "; ".join(f"{verdict} in {count}" for verdict, count in counts.items())
        refused = f" {len(self.refused)} cases were refused." if self.refused else ""
        return f"Of {len(self.judgements)} motions: {said}.{refused}"

    @property
    def answers(self) -> list[Group | Table]:
        rows = [_row(one) for one in self.judgements]
        columns: dict[str, Callable[[dict[str, Any]], str]] = {
            "motion": lambda row: row["name"], "verdict": lambda row: row["verdict"],
            "order": lambda row: _number(row["order"]), "E a radian": lambda row: _number(row["energy_per_radian"]),
            "|L| a radian": lambda row: _number(row["momentum_per_radian"]), "error grows": lambda row: row["growth"],
            "spin goes to": lambda row: row["goes_to"],
        }  # fmt: skip
        units = {"energy_per_radian": "1/rad", "momentum_per_radian": "1/rad", "lost_after": "rad",
                 "largest_error": "rad", "dt": "s", "turned": "rad"}  # fmt: skip
        found: list[Group | Table] = [
            Group("Verdict", [Answer("verdict", self.verdict, "", "verdict")]),
            Table("motions", "Motions", columns, rows, units),
        ]
        if len(self.judgements) == 1:
            found += [*_describe_steps(self.judgements[0]), *_describe_ends(self.judgements[0])]
        if self.refused:
            cases = [{"name": name, "reason": reason} for name, reason in self.refused]
            heads = {"case": lambda row: row["name"], "why it was refused": lambda row: row["reason"]}
            found.append(Table("refused", "Refused", heads, cases))
        return found

    @property
    def notes(self) -> Sequence[str]:
        notes = []
        unseen = dict.fromkeys(name for one in self.judgements for name in one.unseen)
        if unseen and all(set(unseen) <= set(one.unseen) for one in self.judgements):
            notes.append(f"this motion cannot show: {'; '.join(unseen)}. Judge with a body of three different moments, "
                         "turned about none of its axes.")  # fmt: skip
        if any(len(one.mistakes) > 1 for one in self.judgements):
            notes.append("several mistakes explain the states equally well; another motion may tell them apart.")
        if any(one.right is None for one in self.judgements):
            notes.append("states of one step size do not tell an error of the method from a mistake of the same size; "
                         "give the same motion with dt, dt/2 and dt/4.")  # fmt: skip
        return notes

    def figures(self) -> Mapping[str, Callable[[], Figure | None]]:
        from polhode.figures.engine_figure import engine_errors

        names = [f"engine_{k + 1}" for k in range(len(self.judgements))] if len(self.judgements) > 1 else ["engine"]
        return {name: partial(engine_errors, one.run, f"{self.name}, {one.name}", one.runs)
                for name, one in zip(names, self.judgements, strict=True)}  # fmt: skip


def word_verdict(one: Judgement) -> str:
    """Return the verdict on one motion in a few words."""
    if one.right:
        return "right"
    if one.mistakes:
        return "wrong: " + ", or ".join(one.mistakes)
    return "undecided" if one.right is None else "unexplained"


def describe_verdict(one: Judgement) -> str:
    """Return the verdict on one motion in a sentence, with what it rests on."""
    found = one.convergence
    if one.right and (found is None or found.by_rounding):
        return "Right: exact to rounding."
    if one.right and found is not None:
        other = found.momentum_order
        more = f", in momentum {other:.2f}" if other is not None and abs(other - (found.order or 0.0)) > 0.5 else ""
        return (f"Right: with shorter steps it converges to the exact motion with order {found.order:.2f}{more}; a "
                f"mistake that moves states by less than {found.unsure:.1e} would not be seen.")  # fmt: skip
    if one.mistakes:
        return f"Wrong, and explained: {', or '.join(one.mistakes)}. With that, its states are the exact ones."
    if one.right is None:
        return (f"Undecided: the states are off by {one.residual:.2g}, which a method of order 1 or better may be with "
                f"such steps (up to {one.allowed:.2g}).")  # fmt: skip
    if found is None:
        return f"Unexplained: the states are off by {one.residual:.2g}; such steps explain {one.allowed:.2g}."
    if found.limit is not None:
        return f"Unexplained: with shorter steps it converges, but {found.limit:.2g} away from the exact motion."
    return f"Unexplained: shorter steps do not converge; the errors are {', '.join(f'{x:.2g}' for x in found.errors)}."


def describe_motion(one: Judgement) -> list[str]:
    """Return sentences on drift, growth and where spins end; none of an engine whose states mean something else."""
    if one.mistakes:
        return []
    said = [f"At dt = {one.dt:.4g} s, {_word_drift(one.energy, 'energy')} and {_word_drift(one.momentum, '|L|')}."
            if one.dt else f"{_word_drift(one.energy, 'energy')}, {_word_drift(one.momentum, '|L|')}."]  # fmt: skip
    growth = one.growth
    if growth.lost_after is not None:
        said.append(f"The attitude is lost after {growth.lost_after:.3g} rad.")
    if growth.exponent is not None:
        said.append(f"Its error grows like the angle to the power {growth.exponent:.2f}: {growth.word}.")
    return [*said, word_ends(one.ends)]


def word_ends(ends: dict[str, SpinEnd]) -> str:
    """Return where spins go, in a sentence that claims an end only of those that have reached it."""
    goals = {end.toward for end in ends.values()}
    if not ends or goals <= {"none", "unknown"}:
        return "No spin was seen to leave its polhode." if ends and "none" in goals else ""
    if len(goals) == 1 and all(end.reached for end in ends.values()):
        return f"All {len(ends)} spins that were tried end at the axis of {_axis(goals.pop())}."
    said = [f"{name} {_goes(end)}" for name, end in ends.items()]
    return f"Spins: {'; '.join(said)}."


def _goes(end: SpinEnd) -> str:
    if end.reached:
        return f"ends at the axis of {_axis(end.toward)}"
    return {"none": "stays", "unknown": "cannot be followed"}.get(end.toward, f"drifts towards {end.toward}")


def _axis(toward: str) -> str:
    return f"{toward} moment"


def _word_drift(drift: Drift, name: str) -> str:
    if not drift.is_seen:
        return f"{name} only swings, by {drift.swing:.1e}" if drift.swing > 1e-14 else f"{name} stays"
    verb = "grows" if drift.per_radian > 0.0 else "falls"
    return f"{name} {verb} by {abs(drift.per_radian):.2g} of itself a radian"


def _row(one: Judgement) -> dict[str, Any]:
    end = one.ends.get("the given start") or next(iter(one.ends.values()), None)
    return {
        "name": one.name, "verdict": word_verdict(one),
        "order": None if one.convergence is None else one.convergence.order,
        "momentum_order": None if one.convergence is None else one.convergence.momentum_order,
        "dt": one.dt, "turned": one.run.turned[-1],
        "energy_per_radian": one.energy.per_radian if one.energy.is_seen else 0.0,
        "momentum_per_radian": one.momentum.per_radian if one.momentum.is_seen else 0.0,
        "growth": one.growth.word, "growth_exponent": one.growth.exponent, "largest_error": one.growth.largest,
        "lost_after": one.growth.lost_after, "goes_to": "" if end is None else end.toward,
        "mistakes": list(one.mistakes),
    }  # fmt: skip


def _number(value: float | None) -> str:
    return "" if value is None else "0" if value == 0.0 else f"{value:+.2e}" if abs(value) < 0.1 else f"{value:.2f}"


def _finite(value: float) -> str:
    return f"{value:.4g}" if math.isfinite(value) else ""


def _describe_steps(one: Judgement) -> list[Table]:
    found = one.convergence
    if found is None or one.dt is None:
        return []
    rows = [{"dt": one.dt / 2**k, "error": error} for k, error in enumerate(found.errors)]
    columns = {"dt [s]": lambda row: f"{row['dt']:.5g}", "error": lambda row: f"{row['error']:.3g}"}
    return [Table("steps", "Short runs with shorter steps: attitude [rad] and L, relative, together", columns, rows)]


def _describe_ends(one: Judgement) -> list[Table]:
    rows = [{"from": name, "start": end.start, "end": end.end, "toward": end.toward} for name, end in one.ends.items()]
    columns = {"spin": lambda row: row["from"], "2E/|L|² at first": lambda row: f"{row['start']:.4g}",
               "at last": lambda row: _finite(row["end"]), "goes to": lambda row: row["toward"]}  # fmt: skip
    return [Table("ends", "Where spins end", columns, rows, {"start": "1/(kg m²)", "end": "1/(kg m²)"})] if rows else []
