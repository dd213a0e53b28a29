"""From a plan to outputs of its samples: all at once where the kind can, otherwise by a report on each."""

from __future__ import annotations

import difflib
import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np

from polhode.errors import InvalidInput, NotConverged, shown
from polhode.kinds.base import Spec
from polhode.kinds.ensembles import Ensemble, ManySpecs
from polhode.kinds.reading import build_spec
from polhode.motion._trajectory import Trajectory
from polhode.reports.answer import Group, Table, collect_values, plain
from polhode.reports.base import SystemReport
from polhode.spec.keys import is_place, with_value, write_quantity
from polhode.sweeps.bodies import vary_body
from polhode.sweeps.plan import STATES, Plan, choose_chunk

STATUS = "sample_status"  # the array of how each sample ended; reports have a "status" too
YES, NO = "yes", "no"
DONE, REFUSED, LOST = "done", "refused", "not converged"


class EvaluationThresholds(NamedTuple):
    """Numbers that decide which outputs a sweep has, and whether it is refused.

    Attributes:
        max_word: characters of a word that is an output; longer texts are none.
        probes: samples that are tried for the types of the outputs.
        spread_probes: further ones, from all over the sweep, of which one must have a motion.
    """

    max_word: int = 24
    probes: int = 16
    spread_probes: int = 256


LIMITS = EvaluationThresholds()


class Column(NamedTuple):
    """The type of the values of one output or input.

    Attributes:
        name: of it.
        shape: of one sample's value.
        text: whether they are words.
        unit: in SI, as people write it.
        note: an explanation.
        known: whether a value is defined in a sample that was tried; where none is, the output counts as a number.
    """

    name: str
    shape: tuple[int, ...] = ()
    text: bool = False
    unit: str = ""
    note: str = ""
    known: bool = True

    @property
    def type(self) -> Any:
        """Of the array that holds them."""
        return np.dtype(f"<U{LIMITS.max_word}") if self.text else np.dtype("<f8")

    def blank(self, count: int) -> Any:
        """Return blank values of samples."""
        return np.full((count, *self.shape), "" if self.text else math.nan, dtype=self.type)


class Chunk(NamedTuple):
    """Some samples of a sweep.

    Attributes:
        values: name → values (sample, …) of inputs and outputs, and their ``STATUS``.
        reasons: what the first refused samples were refused for: number of the sample and text.
    """

    values: dict[str, Any]
    reasons: list[tuple[int, str]]


@dataclass(frozen=True, eq=False)
class Evaluator:
    """Computes the samples of a plan."""

    plan: Plan

    def draw_inputs(self, low: int, high: int) -> dict[str, Any]:
        return self.plan.design.values(low, high)

    def make_spec(self, inputs: Mapping[str, Any], k: int) -> Spec:
        """Return the spec of one of the samples with these inputs.

        Raises:
            InvalidInput: as reading a file does.
        """
        tables = self.plan.tables
        for key, values in inputs.items():
            value = np.asarray(values[k]).tolist()
            try:
                tables = with_value(tables, key, write_quantity(value, self.plan.units[key]))
            except ValueError as error:
                raise InvalidInput(f"{self.plan.path}: sweep.inputs.{key}: {error}.") from None
        return build_spec(tables, self.plan.path)

    @cached_property
    def _probe(self) -> tuple[Spec, list[Column], int]:
        """Return the spec of a sample that has a motion, the outputs of it, and its number.

        Raises:
            InvalidInput: for names that no answer has, or if no sample has a motion.
        """
        count = self.plan.design.count
        first, probe, error = min(LIMITS.probes, count), None, None
        tried = list(range(first))
        if count > first:
            tried += np.unique(np.linspace(first, count - 1, LIMITS.spread_probes).astype(int)).tolist()
        for place, k in enumerate(tried):
            if probe is not None and place >= first:
                break
            try:
                spec = self.make_spec(self.draw_inputs(k, k + 1), 0)
                columns = self._columns(spec)
            except (InvalidInput, NotConverged) as refusal:
                if isinstance(refusal, _NoSuchAnswer):
                    raise
                error = error or refusal
                continue
            if probe is None:
                probe = spec, columns, k
            known = [a if a.known else b for a, b in zip(probe[1], columns, strict=True)]
            probe = probe[0], known, probe[2]
            if all(column.known for column in known):
                break
        if probe is None:
            assert error is not None
            head, *rest = error.args
            raise InvalidInput(f"none of {len(tried)} samples tried can be computed; of the first: {head}", *rest)
        return probe

    def _columns(self, spec: Spec) -> list[Column]:
        """Return the types of the outputs of one sample; undefined numbers may turn out to be words later."""
        answers, groups = self._answers(spec)
        units = _units(groups)
        trajectory = self._trajectory(spec) if self.plan.states else None
        return [
            _state_column(name, trajectory, self.plan.times) if trajectory is not None and name in self.plan.states
            else _answer_column(name, answers, units) for name in self.plan.outputs
        ]

    @cached_property
    def columns(self) -> list[Column]:
        """The outputs of the sweep; where no sample has defined an output yet, its type is that of the kind."""
        columns, first = self._probe[1], self._first
        if first is None:
            return columns
        texts = {name for name, values in first.values.items() if np.asarray(values).dtype.kind == "U"}
        return [column if column.known else column._replace(text=column.name in texts) for column in columns]

    @cached_property
    def _first(self) -> Ensemble | None:
        number = self._probe[2]
        return self._ensemble(self.draw_inputs(number, number + 1))

    @property
    def at_once(self) -> bool:
        """Whether the kind computes many samples at once."""
        return self._first is not None

    @property
    def chunk_size(self) -> int:
        """How many samples are computed together."""
        count = self.plan.design.count
        return min(self.plan.chunk or choose_chunk(count, self.at_once), count)

    def chunk(self, low: int, high: int) -> Chunk:
        """Return the samples low, …, high − 1."""
        inputs = self.draw_inputs(low, high)
        values, refused, lost = self._together(inputs) if self.at_once else self._one_by_one(inputs, high - low)
        status = np.full(high - low, DONE, dtype=f"<U{LIMITS.max_word}")
        status[list(refused)], status[list(lost)] = REFUSED, LOST
        wrong, outputs = [*refused, *lost], {}
        for column in self.columns:
            array = np.array(_take_output(values, column.name), dtype=column.type)
            array[wrong] = "" if column.text else math.nan
            if not column.text:
                array[~np.isfinite(array)] = math.nan
            outputs[column.name] = array
        reasons = sorted((low + k, why) for k, why in (refused | lost).items())[:3]
        return Chunk({**inputs, **outputs, STATUS: status}, reasons)

    def _ensemble(self, inputs: dict[str, Any]) -> Ensemble | None:
        spec, names = self._probe[0], []
        for column in self._probe[1]:
            whole, _, place = column.name.rpartition(".")
            names.append(whole if place.isdecimal() else column.name)
        bodies = vary_body(spec, self.plan.tables, inputs, self.plan.units)
        times = np.asarray(self.plan.times, dtype=float)
        samples = ManySpecs(spec, inputs, bodies, lambda k: self.make_spec(inputs, k))
        return spec.kind.ensemble(samples, list(dict.fromkeys(names)), times)

    def _together(self, inputs: dict[str, Any]) -> tuple[dict[str, Any], dict[int, str], dict[int, str]]:
        refused: dict[int, str] = {}
        try:
            ensemble = self._ensemble(inputs)
        except InvalidInput:
            refused = self._impossible(inputs, 0, len(next(iter(inputs.values()))))
            # a possible sample replaces impossible ones: the others are then computed with equal bits
            number = self._probe[2]
            good, wrong = self.draw_inputs(number, number + 1), list(refused)
            inputs = {key: np.array(values) for key, values in inputs.items()}
            for key, values in inputs.items():
                values[wrong] = good[key][0]
            ensemble = self._ensemble(inputs)
        assert ensemble is not None
        return ensemble.values, ensemble.refused | refused, ensemble.lost

    def _impossible(self, inputs: dict[str, Any], low: int, high: int) -> dict[int, str]:
        """Find by bisection the samples that make a joint computation fail, and why."""
        try:
            self._ensemble({key: values[low:high] for key, values in inputs.items()})
        except InvalidInput as error:
            if high - low > 1:
                middle = (low + high) // 2
                return self._impossible(inputs, low, middle) | self._impossible(inputs, middle, high)
            return {low: self._explain_refusal(inputs, low) or str(error)}
        return {}

    def _explain_refusal(self, inputs: dict[str, Any], k: int) -> str:
        """Return the error of reading the sample's own spec, which names the key."""
        try:
            self.make_spec(inputs, k).report()
        except InvalidInput as error:
            return str(error)
        return ""

    def _one_by_one(self, inputs: dict[str, Any], count: int) -> tuple[dict[str, Any], dict[int, str], dict[int, str]]:
        values = {column.name: column.blank(count) for column in self.columns}
        refused, lost, specs = {}, {}, {}
        for k in range(count):
            try:
                specs[k] = self.make_spec(inputs, k)
            except InvalidInput as error:
                refused[k] = str(error)
        for (k, spec), report in zip(specs.items(), self._reports(list(specs.values())), strict=True):
            try:
                answers, _ = self._answers(spec, report)
                trajectory = self._trajectory(spec) if self.plan.states else None
                for column in self.columns:
                    if trajectory is not None and column.name in self.plan.states:
                        value = _state(column.name, trajectory, self.plan.times)
                    else:
                        value = _fit_to_column(column, _pick(answers, column.name))
                    values[column.name][k] = value
            except InvalidInput as error:
                refused[k] = str(error)
            except NotConverged as error:
                lost[k] = str(error)
        return values, refused, lost

    @cached_property
    def _wanted(self) -> list[str]:
        return [name for name in self.plan.outputs if name not in self.plan.states]

    @cached_property
    def _needs_reports(self) -> bool:
        """Whether some answer needs a motion."""
        spec = self._probe[0]
        return bool(self._wanted) and _take_until(self._wanted, spec.kind.answers_without_motion(spec)) is None

    def _reports(self, specs: list[Spec]) -> Iterable[SystemReport | InvalidInput | NotConverged | None]:
        return self.plan.kind.reports(specs) if self._needs_reports else [None] * len(specs)

    def _answers(
        self, spec: Spec, report: SystemReport | InvalidInput | NotConverged | None = None
    ) -> tuple[dict[str, Any], Sequence[Group | Table]]:
        """Return answers as in the JSON, with all outputs, and their groups; none that no output needs.

        A motion is computed only if an output needs one.

        Args:
            spec: of the sample.
            report: on it, where some answer needs one, or why there is none.
        """
        if not self._wanted:
            return {}, []
        if isinstance(report, InvalidInput | NotConverged):
            raise report
        if report is None:
            if answers := _take_until(self._wanted, spec.kind.answers_without_motion(spec)):
                return answers
            report = spec.report()
        with spec.within_double_precision():
            return _take_until(self._wanted, report.iterate_answers()) or (report.as_json_dict(), report.answers)

    def _trajectory(self, spec: Spec) -> Trajectory:
        """Return the motion with samples at the times of the states."""
        times = (0.0, *self.plan.times)
        return replace(spec, until=times[-1], samples=len(times), instants=times).motion().trajectory


class _NoSuchAnswer(InvalidInput):
    """A name that no answer has."""


def _take_output(values: Mapping[str, Any], name: str) -> Any:
    """Return the values of an output, which may be one component of a computed vector."""
    if name in values:
        return values[name]
    whole, _, place = name.rpartition(".")
    return values[whole][:, int(place) - 1]


def _pick(values: Any, name: str) -> Any:
    """Return an answer by its name in the JSON; places in lists count from 1. None where there is none."""
    for part in name.split("."):
        if isinstance(values, dict):
            values = values.get(part)
        elif isinstance(values, list) and is_place(part) and 1 <= int(part) <= len(values):
            values = values[int(part) - 1]
        else:
            return None
    return values


def _fit_to_column(column: Column, value: Any) -> Any:
    """Return a value as its column takes it.

    Raises:
        InvalidInput: for texts that are too long, or lists of another length than in other samples.
    """
    if isinstance(value, bool):
        value = YES if value else NO
    if value is None or (column.text and isinstance(value, str) and len(value) <= LIMITS.max_word):
        return column.blank(1)[0] if value is None else value
    if column.text or isinstance(value, str) or np.shape(value) != column.shape:
        raise InvalidInput(f"the answer {column.name} is {shown(value)}, of another form than in other samples")
    return np.array(value, dtype=float)


def _answer_column(name: str, values: dict[str, Any], units: dict[str, str]) -> Column:
    """Return the type of an answer.

    Raises:
        _NoSuchAnswer: for names that the report does not have, and texts.
    """
    if not _has(values, name):
        known = sorted(name for name in _names(values) if " " not in name)
        near = difflib.get_close_matches(name, known, 1)
        hint = f"did you mean {near[0]}?" if near else f"some that it has: {', '.join(known[:12])}, …"
        raise _NoSuchAnswer(f"sweep.outputs: the report has no answer {shown(name)}; {hint} `polhode report SPEC "
                            "--json` shows all; places in lists count from 1.")
    value = _pick(values, name)
    unit = _unit(units, name)
    if isinstance(value, bool):
        return Column(name, text=True)
    if isinstance(value, str):
        if len(value) > LIMITS.max_word:
            raise _NoSuchAnswer(f"sweep.outputs: {name} is a sentence, not a number or a word. Leave it out.")
        return Column(name, text=True)
    try:
        shape = np.shape(np.array(0.0 if value is None else value, dtype=float))
    except (TypeError, ValueError):
        parts = ", ".join(sorted(f"{name}.{part}" for part in _names(value))[:6])
        raise _NoSuchAnswer(f"sweep.outputs: {name} is a table of answers; name one, like {parts}.") from None
    return Column(name, shape, unit=unit, known=value is not None)


def _take_until(
    wanted: Sequence[str], answers: Iterable[Group | Table]
) -> tuple[dict[str, Any], Sequence[Group | Table]] | None:
    """Return answers as in the JSON, and their groups, up to the last wanted one; None if one is missing."""
    groups: list[Group | Table] = []
    for group in answers:
        groups.append(group)
        values = plain(collect_values(groups))
        if all(_has(values, name) for name in wanted):
            return values, groups
    return None


def _has(values: Any, name: str) -> bool:
    """Whether the JSON has a name, if only as null, or within one that is null here."""
    for part in name.split("."):
        if values is None:
            return True
        inside = _pick(values, part)
        if inside is None and not (isinstance(values, dict) and part in values):
            return False
        values = inside
    return True


def _names(values: Any, before: str = "") -> Iterable[str]:
    """Yield the names of all answers."""
    items = values.items() if isinstance(values, dict) else (
        ((str(k + 1), item) for k, item in enumerate(values)) if isinstance(values, list) else ())
    for key, item in items:
        nested = isinstance(item, dict) or (isinstance(item, list) and item and isinstance(item[0], dict))
        if nested:
            yield from _names(item, f"{before}{key}.")
        elif key not in ("units", "notes", "summary"):
            yield f"{before}{key}"


def _units(groups: Iterable[Group | Table]) -> dict[str, str]:
    """Return the units of answers by name, without explanations."""
    units: dict[str, str] = {}
    for group in groups:
        if isinstance(group, Table):
            units |= {f"{group.name}.{key}": unit.split(",")[0] for key, unit in group.units.items()}
        else:
            units |= {answer.name: answer.unit for answer in group.answers if answer.name}
    return units


def _unit(units: dict[str, str], name: str) -> str:
    """Return the unit of an answer; of a part of it, that of the whole."""
    plain = ".".join(part for part in name.split(".") if not part.isdecimal())
    while plain:
        if plain in units:
            return units[plain]
        plain = plain.rpartition(".")[0]
    return ""


def _state_column(name: str, trajectory: Trajectory, times: tuple[float, ...]) -> Column:
    part = name.removeprefix(STATES)
    own = [*trajectory.layout.names, *(["angular_velocity"] if trajectory.angular_velocity is not None else [])]
    if part not in own:
        has = ", ".join(dict.fromkeys(own))
        raise _NoSuchAnswer(f"sweep.outputs: the state has no part {shown(part)}; it has {has}.")
    entry = next((one for one in trajectory.layout.parts if one.name == part), None)
    unit = "rad/s" if entry is None else entry.unit
    values = _state(name, trajectory, times)
    frame = "" if trajectory.frame is None else "body axes are the principal ones"
    return Column(name, np.shape(values), unit=unit, note=frame)


def _state(name: str, trajectory: Trajectory, times: tuple[float, ...]) -> Any:
    """Return a part of the state (time, …) at these times, NaN where the motion ended before."""
    part = name.removeprefix(STATES)
    layout, sampled = trajectory.layout, np.asarray(trajectory.times)
    values = layout.part(trajectory.states, part) if part in layout.names else getattr(trajectory, part)
    values = np.asarray(values, dtype=float)
    at = np.minimum(np.searchsorted(sampled, times), len(sampled) - 1)
    there = (sampled[at] == np.asarray(times)).reshape(-1, *[1] * (values.ndim - 1))
    return np.where(there, values[at], math.nan)
