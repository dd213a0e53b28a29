"""From a plan to outputs of its samples: all at once where the kind can, otherwise by a report on each."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np

from polhode.errors import InvalidInput, NotConverged
from polhode.kinds.base import Spec
from polhode.kinds.ensembles import Ensemble, ManySpecs
from polhode.kinds.reading import build_spec
from polhode.motion._trajectory import Trajectory
from polhode.reports.answer import Group, Table, collect_values, plain
from polhode.reports.base import SystemReport
from polhode.spec.keys import with_value, write_quantity
from polhode.spec.reach import beyond_reach
from polhode.sweeps.bodies import vary_body
from polhode.sweeps.columns import LIMITS as COLUMNS
from polhode.sweeps.columns import (
    Column,
    NoSuchAnswer,
    answer_column,
    fit_to_column,
    has_answer,
    pick,
    state_column,
    state_part,
    take_output,
    units_of,
)
from polhode.sweeps.plan import Plan, choose_chunk

STATUS = "sample_status"  # the array of how each sample ended; reports have a "status" too
DONE, REFUSED, LOST = "done", "refused", "not converged"


class EvaluationThresholds(NamedTuple):
    """Numbers that decide which outputs a sweep has, and whether it is refused.

    Attributes:
        probes: samples that are tried for the types of the outputs.
        spread_probes: further ones, from all over the sweep, of which one must have a motion.
        usual_size: of numbers of a spec in SI, and one over the smallest, beyond which a sample's whole report is made,
            as it may refuse what no output shows; products of six numbers within stay in the range of doubles.
    """

    probes: int = 16
    spread_probes: int = 256
    usual_size: float = 1e50


LIMITS = EvaluationThresholds()


class Chunk(NamedTuple):
    """Some samples of a sweep.

    Attributes:
        values: name → values (sample, …) of inputs and outputs, and their ``STATUS``.
        reasons: what the first refused samples were refused for: number of the sample and text.
    """

    values: dict[str, Any]
    reasons: list[tuple[int, str]]


class Found(NamedTuple):
    """Answers about a sample.

    Attributes:
        values: by name, as in the JSON.
        groups: that they are from.
    """

    values: dict[str, Any]
    groups: Sequence[Group | Table]


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
                if isinstance(refusal, NoSuchAnswer):
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
        units = units_of(groups)
        trajectory = self._trajectory(spec) if self.plan.states else None
        return [
            state_column(name, trajectory, self.plan.times) if trajectory is not None and name in self.plan.states
            else answer_column(name, answers, units) for name in self.plan.outputs
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
    def by_steps(self) -> bool:
        """Whether what is computed at once goes by steps."""
        return self._first is not None and self._first.by_steps

    @property
    def chunk_size(self) -> int:
        """How many samples are computed together."""
        count = self.plan.design.count
        return min(self.plan.chunk or choose_chunk(count, self.at_once, by_steps=self.by_steps), count)

    def chunk(self, low: int, high: int) -> Chunk:
        """Return the samples low, …, high − 1."""
        inputs = self.draw_inputs(low, high)
        values, refused, lost = self._together(inputs) if self.at_once else self._one_by_one(inputs, high - low)
        status = np.full(high - low, DONE, dtype=f"<U{COLUMNS.max_word}")
        status[list(refused)], status[list(lost)] = REFUSED, LOST
        wrong, outputs = [*refused, *lost], {}
        for column in self.columns:
            array = np.array(take_output(values, column.name), dtype=column.type)
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
        if not ensemble.alone:
            return ensemble.values, ensemble.refused | refused, {}
        return self._join(ensemble, ensemble.refused | refused, inputs)

    def _join(
        self, ensemble: Ensemble, refused: dict[int, str], inputs: dict[str, Any]
    ) -> tuple[dict[str, Any], dict[int, str], dict[int, str]]:
        """Return the answers of an ensemble, with those of the samples that it leaves to their own reports."""
        count = len(next(iter(inputs.values())))
        alone = [k for k in ensemble.alone if k not in refused]
        own, not_possible, not_followed = self._one_by_one({key: array[alone] for key, array in inputs.items()},
                                                           len(alone))
        together, values = np.setdiff1d(np.arange(count), ensemble.alone), {}
        for column in self.columns:
            values[column.name] = column.blank(count)
            values[column.name][alone] = own[column.name]
            if len(together):
                values[column.name][together] = take_output(ensemble.values, column.name)[together]
        refused = refused | {alone[k]: why for k, why in not_possible.items()}
        return values, refused, {alone[k]: why for k, why in not_followed.items()}

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
                if _is_extreme(spec):
                    spec.report()
                answers, _ = self._answers(spec, report)
                trajectory = self._trajectory(spec) if self.plan.states else None
                for column in self.columns:
                    if trajectory is not None and column.name in self.plan.states:
                        value = state_part(column.name, trajectory, self.plan.times)
                    else:
                        value = fit_to_column(column, pick(answers, column.name))
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

    def _answers(self, spec: Spec, report: SystemReport | InvalidInput | NotConverged | None = None) -> Found:
        """Return answers with all outputs; none that no output needs.

        A motion is computed only if an output needs one.

        Args:
            spec: of the sample.
            report: on it, where some answer needs one, or why there is none.

        Raises:
            InvalidInput, NotConverged: where the sample's own report does, for what was computed.
        """
        if not self._wanted:
            return Found({}, [])
        if isinstance(report, InvalidInput | NotConverged):
            raise report
        if report is None:
            found = _take_until(self._wanted, spec.kind.answers_without_motion(spec))
            if found and _are_finite(found):
                return found
            report = spec.report()
        with spec.within_double_precision():
            found = _take_until(self._wanted, report.iterate_answers())
            found = found or Found(report.as_json_dict(), report.answers)
        # sentences may need what no output does, so they are made only where some number is infinite: as that of an
        # interval between flips may be, or as one that has left double precision, which the sample's own report refuses
        if not _are_finite(found):
            spec.check_sentences(report)
        return found

    def _trajectory(self, spec: Spec) -> Trajectory:
        """Return the motion with samples at the times of the states."""
        times = (0.0, *self.plan.times)
        return replace(spec, until=times[-1], samples=len(times), instants=times).motion().trajectory


def _take_until(wanted: Sequence[str], answers: Iterable[Group | Table]) -> Found | None:
    """Return the answers up to the last wanted one; None if one is missing."""
    groups: list[Group | Table] = []
    for group in answers:
        groups.append(group)
        values = plain(collect_values(groups))
        if all(has_answer(values, name) for name in wanted):
            return Found(values, groups)
    return None


def _is_extreme(spec: Spec) -> bool:
    """Whether a number of the spec is of so unusual a size that its report may be refused for what follows from it."""
    tables = {"system": spec.system, "body": spec.source, "spin": spec.spin, "until": spec.until}
    return next(beyond_reach(tables, (), LIMITS.usual_size), None) is not None


def _are_finite(found: Found) -> bool:
    """Return whether all numbers among answers are finite, which the JSON has as undefined otherwise."""

    def finite(value: Any) -> bool:
        if isinstance(value, dict):
            return all(map(finite, value.values()))
        if isinstance(value, list | tuple):
            return all(map(finite, value))
        numbers = np.asarray(value)
        return numbers.dtype.kind not in "fc" or bool(np.isfinite(numbers).all())

    return finite(collect_values(found.groups))
