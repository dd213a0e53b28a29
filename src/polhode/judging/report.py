"""The report of the judge: its verdict in words, the numbers behind it, and a figure of each motion."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING, Any, ClassVar, NamedTuple

from polhode.judging._convergence import Convergence
from polhode.judging._run import LIMITS as RUN_LIMITS
from polhode.judging._run import Drift, SpinEnd
from polhode.judging._verdicts import GIVEN, Judgement
from polhode.reports.answer import Answer, Group, Table
from polhode.reports.report import StudyReport
from polhode.reports.wording import uncertain

if TYPE_CHECKING:
    from matplotlib.figure import Figure


class WordingThresholds(NamedTuple):
    """Numbers that decide how results are worded.

    Attributes:
        min_swing: relative; an invariant that swings by less is constant to rounding.
        max_percentage: relative change of a quaternion's length; a larger one is given as the length itself.
        order_difference: of momentum and attitude together, from which the momentum's own is mentioned.
    """

    min_swing: float = 1e-14
    max_percentage: float = 10.0
    order_difference: float = 0.5


LIMITS = WordingThresholds()


@dataclass(frozen=True)
class JudgeReport(StudyReport):
    """The verdict on an engine.

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
        """Over all motions: "right", "right, but …" where states end, "wrong: …", "unexplained" or "undecided"."""
        verdicts = [word_verdict(one) for one in self.judgements]
        for kind in ("wrong", "unexplained", "right, but", "undecided"):
            if worst := [verdict for verdict in verdicts if verdict.startswith(kind)]:
                return worst[0]
        return "right" if verdicts else "undecided"

    @property
    def summary(self) -> str:
        refused = f"{_count(len(self.refused), 'run')} {'was' if len(self.refused) == 1 else 'were'} refused."
        if not self.judgements:
            return f"Nothing was judged: {refused}"
        tail = [refused] if self.refused else []
        if len(self.judgements) == 1:
            one = self.judgements[0]
            return " ".join(filter(None, (describe_verdict(one), *describe_motion(one), *tail)))
        counts: dict[str, int] = {}
        for one in self.judgements:
            counts[word_verdict(one)] = counts.get(word_verdict(one), 0) + 1
        said = "; ".join(f"{verdict} in {count}" for verdict, count in counts.items())
        motions, runs = _count(len({one.motion for one in self.judgements}), "motion"), len(self.judgements)
        # runs of one motion whose steps are not halved are judged singly, and are no more motions for it
        of = motions if motions == _count(runs, "motion") else f"{_count(runs, 'run')} of {motions}"
        return " ".join((f"Of {of}: {said}.", *tail))

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
                 "largest_error": "rad", "dt": "s", "turned": "rad", "finite_until": "s"}  # fmt: skip
        groups: list[Group | Table] = [
            Group("Verdict", [Answer("verdict", self.verdict, "", "verdict")]),
            Table("motions", "Motions", columns, rows, units),
        ]
        if len(self.judgements) == 1:
            groups += [*_describe_steps(self.judgements[0]), *_describe_ends(self.judgements[0])]
        if self.refused:
            cases = [{"name": name, "reason": reason} for name, reason in self.refused]
            heads = {"case": lambda row: row["name"], "why it was refused": lambda row: row["reason"]}
            groups.append(Table("refused", "Refused", heads, cases))
        return groups

    @property
    def notes(self) -> Sequence[str]:
        notes = []
        unseen = dict.fromkeys(name for one in self.judgements for name in one.unseen)
        if unseen and all(set(unseen) <= set(one.unseen) for one in self.judgements):
            notes.append(f"this motion cannot show: {'; '.join(unseen)}. Judge with a body of three different moments, "
                         "turned about none of its axes.")
        if any(len(one.mistakes) > 1 for one in self.judgements):
            notes.append("several mistakes explain the states equally well; another motion may tell them apart.")
        if len(self.judgements) > 1 and (change := max((one.length_change for one in self.judgements), key=abs)):
            notes.append(_word_length(change, ""))
        if any(one.right is None and one.convergence is None for one in self.judgements):
            notes.append("states of one step size do not tell an error of the method from a mistake of the same size; "
                         "give the same motion with dt, dt/2 and dt/4.")
        return notes

    def figures(self) -> Mapping[str, Callable[[], Figure | None]]:
        from polhode.judging.figure import engine_errors

        names = [f"engine_{k + 1}" for k in range(len(self.judgements))] if len(self.judgements) > 1 else ["engine"]

        def draw(one: Judgement) -> Figure | None:
            return engine_errors(one.run, f"{self.name}, {one.name}", one.runs) if _is_measured(one) else None

        return {name: partial(draw, one) for name, one in zip(names, self.judgements, strict=True)}


def word_verdict(one: Judgement) -> str:
    """Return the verdict on one motion in a few words."""
    stop = _word_stop(one)
    if one.right:
        return f"right, but {stop}" if stop else "right"
    if one.mistakes:
        return "wrong: " + ", or ".join(one.mistakes)
    if stop and _is_lost(one):
        return f"wrong: {stop}"
    return " and ".join(filter(None, ("undecided" if one.right is None else "unexplained", stop)))


def _is_lost(one: Judgement) -> bool:
    """Whether the short runs, too, have states that are not finite: there is no limit to compare."""
    return one.convergence is not None and not all(map(math.isfinite, one.convergence.errors[-3:]))


def _word_stop(one: Judgement, step: bool = False) -> str:
    """Return since when states are not finite, as the middle of a sentence; nothing where all are."""
    if one.stop is None:
        return ""
    stop, start = one.stop
    return (stop.words + (f" (step {stop.step})" if step else "")
            + ("" if start == GIVEN else f", started {start}"))


def describe_verdict(one: Judgement) -> str:
    """Return the verdict on one motion in a sentence, with its evidence."""
    convergence, stop = one.convergence, _word_stop(one, step=True)
    right = f"Right with short steps, but at dt = {one.dt:.4g} s {stop}" if stop else "Right"
    if one.right and (convergence is None or convergence.by_rounding):
        return f"{right}: exact to {'the digits that were printed' if one.run.printed_unit else 'rounding'}."
    if one.right and convergence is not None:
        other = convergence.momentum_order
        apart = 0.0 if other is None else abs(other - (convergence.order or 0.0))
        more = f", in momentum {other:.2f}" if apart > LIMITS.order_difference else ""
        return (f"{right}: with shorter steps it converges to the exact motion with order {convergence.order:.2f}"
                f"{more}; a mistake that moves states by less than {convergence.unsure:.1e} would not be "
                "seen.")
    if one.mistakes:
        return f"Wrong, and explained: {', or '.join(one.mistakes)}. {_word_explained(one)}"
    if stop and _is_lost(one):
        return f"Wrong: {stop}, at dt = {one.dt:.4g} s; with shorter steps, too, its states do not stay finite."
    after = f" {stop[:1].upper()}{stop[1:]}." if stop else ""
    if one.right is None and convergence is not None:
        return f"Undecided: {_word_open(convergence)}{after}"
    if one.right is None:
        return (f"Undecided: the states are off by {one.residual:.2g}, which a method of order 1 or better may be with "
                f"such steps (up to {one.allowed:.2g}).{after}")
    if convergence is None:
        return f"Unexplained: the states are off by {one.residual:.2g}; such steps explain {one.allowed:.2g}.{after}"
    if convergence.limit is not None:
        return (f"Unexplained: with shorter steps it converges, but {convergence.limit:.2g} away from the exact "
                f"motion.{after}")
    errors = ", ".join(_error(x, 2) for x in convergence.errors)
    return f"Unexplained: shorter steps do not converge; the errors are {errors}.{after}"


def _word_open(convergence: Convergence) -> str:
    """Return why the states do not decide the verdict, with the remedy."""
    if convergence.by_rounding:
        return (f"the states are exact as far as their digits show, to {convergence.unsure:.1e}, which is too little "
                "for a verdict. Write more digits, or take fewer steps.")
    if convergence.limit is None:
        errors = ", ".join(_error(x, 2) for x in convergence.errors)
        return f"the errors fall with shorter steps ({errors}), but not yet as a power of the step. Give shorter steps."
    return (f"with shorter steps it comes as near to the exact motion as such steps show, within "
            f"{convergence.unsure:.1e}. Give shorter steps.")


def _word_explained(one: Judgement) -> str:
    """Return the residual with the first of the mistakes, in a sentence.

    It is not zero: the method has its own errors, which only short steps make small.
    """
    left = one.explained
    if not isinstance(left, Convergence):
        return f"With that, its states are off by {left:.2g}, and by {one.residual:.2g} without."
    if left.by_rounding or left.order is None:
        return "With that, its states are exact to rounding."
    return f"With that, its errors shrink with shorter steps as those of order {left.order:.2f} do."


def describe_motion(one: Judgement) -> list[str]:
    """Return sentences on drift, growth and where spins end; none where a mistake gives the states another meaning."""
    if one.mistakes:
        return []
    said = []
    if _is_measured(one):
        drifts = f"{_word_drift(one.energy, 'energy')} and {_word_drift(one.momentum, '|L|')}"
        when = [*(["until then"] if GIVEN in one.stops else []), *([f"at dt = {one.dt:.4g} s"] if one.dt else [])]
        said.append(_capital(f"{', '.join([*when, drifts])}."))
    growth = one.growth
    if growth.lost_after is not None:
        said.append(f"The attitude is lost after {growth.lost_after:.3g} rad.")
    if growth.exponent is not None:
        said.append(f"Its error grows like the angle to the power {growth.exponent:.2f}: {growth.word}.")
    if one.length_change:
        said.append(_capital(_word_length(one.length_change, f" within {one.run.turned[-1]:.3g} rad")))
    return [*said, word_ends(one.ends)]


def _is_measured(one: Judgement) -> bool:
    """Whether there are enough states to measure drifts; an engine that stops at once has none."""
    return not one.stops or len(one.run.times) >= RUN_LIMITS.min_samples


def _capital(text: str) -> str:
    return text[:1].upper() + text[1:]


def _word_length(change: float, within: str) -> str:
    """Return how a quaternion's length changes, and the remedy; a change of more than tenfold as the length itself."""
    amount = f"by {100.0 * abs(change):.2g} %" if change < LIMITS.max_percentage else f"to {1.0 + change:.3g}"
    return (f"the length of its quaternion {'grows' if change > 0.0 else 'falls'} {amount}{within}: normalize it after "
            "each step; attitudes were compared at length 1.")


def _count(number: int, word: str) -> str:
    return f"{number} {word}{'' if number == 1 else 's'}"


def word_ends(ends: dict[str, SpinEnd]) -> str:
    """Return in a sentence where spins go; only those that have reached an axis end there."""
    goals = {end.toward for end in ends.values()}
    if ends and goals == {"undecided"}:
        return "Where spins go cannot be said of less than two periods of the polhode."
    if not ends or goals <= {"none", "unknown"}:
        return "No spin was seen to leave its polhode." if ends and "none" in goals else ""
    if len(goals) == 1 and all(end.reached for end in ends.values()):
        return f"All {len(ends)} spins that were tried end at the axis of {_axis(goals.pop())}."
    said = [f"{name} {_goes(end)}" for name, end in ends.items()]
    return f"Spins: {'; '.join(said)}."


def _goes(end: SpinEnd) -> str:
    if end.reached:
        return f"ends at the axis of {_axis(end.toward)}"
    words = {"none": "stays", "unknown": "cannot be followed", "undecided": "is followed for too short a time"}
    return words.get(end.toward, f"drifts towards {end.toward}")


def _axis(toward: str) -> str:
    return f"{toward} moment"


def _word_drift(drift: Drift, name: str) -> str:
    if not math.isfinite(drift.per_radian):
        return f"{name} leaves double precision"
    if _runs_away(drift):
        return f"{name} grows to {1.0 + drift.change:.2g} times itself"
    if not drift.is_seen and drift.swing > LIMITS.min_swing:
        if math.isnan(drift.error):
            return f"{name} changes by {drift.change:.1e} of itself, in too short a run to tell a drift from a swing"
        trend = uncertain(drift.per_radian, drift.error)
        return f"{name} only swings, by {drift.swing:.1e} of itself, with a trend of {trend} a radian"
    if not drift.is_seen:
        return f"{name} stays"
    verb = "grows" if drift.per_radian > 0.0 else "falls"
    return f"{name} {verb} by {abs(drift.per_radian):.2g} of itself a radian"


def _runs_away(drift: Drift) -> bool:
    """Whether an invariant ends far above its start in too few samples for a line; it does not swing."""
    return not drift.is_seen and drift.swing > 1.0 and drift.change > 1.0


def _row(one: Judgement) -> dict[str, Any]:
    end = one.ends.get(GIVEN) or next(iter(one.ends.values()), None)
    return {
        "name": one.name, "verdict": word_verdict(one),
        "order": None if one.convergence is None else one.convergence.order,
        "momentum_order": None if one.convergence is None else one.convergence.momentum_order,
        "dt": one.dt, "turned": one.run.turned[-1],
        "energy_per_radian": _rate(one, one.energy), "momentum_per_radian": _rate(one, one.momentum),
        "growth": one.growth.word if _is_measured(one) else "unknown", "growth_exponent": one.growth.exponent,
        "largest_error": one.growth.largest,
        "lost_after": one.growth.lost_after, "goes_to": "" if end is None else end.toward,
        "mistakes": list(one.mistakes), "quaternion_length_change": one.length_change,
        "finite_until": None if one.stop is None else one.stop[0].time,
    }  # fmt: skip


def _rate(one: Judgement, drift: Drift) -> float | None:
    if not _is_measured(one) or not math.isfinite(drift.per_radian) or _runs_away(drift):
        return None
    if not drift.is_seen and math.isnan(drift.error) and drift.swing > LIMITS.min_swing:
        return None
    return drift.per_radian if drift.is_seen else 0.0


def _number(value: float | None) -> str:
    return "" if value is None else "0" if value == 0.0 else f"{value:+.2e}" if abs(value) < 0.1 else f"{value:.2f}"


def _finite(value: float) -> str:
    return f"{value:.4g}" if math.isfinite(value) else ""


def _error(value: float, digits: int = 3) -> str:
    return f"{value:.{digits}g}" if math.isfinite(value) else "not finite"


def _describe_steps(one: Judgement) -> list[Table]:
    convergence = one.convergence
    if convergence is None or one.dt is None:
        return []
    rows = [{"dt": one.dt / 2**k, "error": error} for k, error in enumerate(convergence.errors)]
    columns = {"dt [s]": lambda row: f"{row['dt']:.5g}", "error": lambda row: _error(row["error"])}
    return [Table("steps", "Short runs with shorter steps: attitude [rad] and L, relative, together", columns, rows)]


def _describe_ends(one: Judgement) -> list[Table]:
    rows = [{"from": name, "start": end.start, "end": end.end, "toward": end.toward} for name, end in one.ends.items()]
    columns = {"spin": lambda row: row["from"], "2E/|L|² at first": lambda row: f"{row['start']:.4g}",
               "at last": lambda row: _finite(row["end"]), "goes to": lambda row: row["toward"]}  # fmt: skip
    return [Table("ends", "Where spins end", columns, rows, {"start": "1/(kg m²)", "end": "1/(kg m²)"})] if rows else []
