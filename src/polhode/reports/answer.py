"""Answers as data: values with name, unit and label, from which text, JSON and units are made."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Sequence
from typing import Any, NamedTuple

import numpy as np

from polhode.reports.wording import round_words, write_value


class Answer(NamedTuple):
    """One value in a report.

    Attributes:
        name: its place in the JSON, a dot between levels: "rotor.moment". Empty where it is in the text alone.
        value: in SI units: a number, array, string, truth value or a mapping of such; None where it is not defined.
        unit: as people write it: "kg m²/s".
        label: of its line in the text. Empty where it is in the JSON alone.
        explanation: further facts about the value: along which axes, when, of which thing.
        text: the value for people; None to write it by its unit. An answer without a value has no line.
        error: estimate of the value's error relative to its size, which decides how many digits the words have; None
            where there is none, zero where the value does not come from steps.
    """

    name: str
    value: Any
    unit: str = ""
    label: str = ""
    explanation: str = ""
    text: str | None = None
    error: float | None = 0.0

    @property
    def words(self) -> str | None:
        """The value for people; None where there is nothing to print."""
        if isinstance(self.value, float) and math.isnan(self.value):
            return None
        words = write_value(self.value, self.unit) if self.text is None else self.text
        return None if words is None else round_words(words, self.error)


class Group(NamedTuple):
    """Answers that belong together, under a title."""

    title: str
    answers: Sequence[Answer]

    @property
    def lines(self) -> list[tuple[str, str]]:
        """Label and words of each line of the text."""
        said = ((answer.label, answer.words) for answer in self.answers if answer.label)
        return [(label, words) for label, words in said if words is not None]


class Table(NamedTuple):
    """Answers about several things, one row each.

    Attributes:
        name: its place in the JSON.
        title: above it in the text.
        columns: head of a column → its cell, from the values of a row.
        rows: the values of each, by name.
        units: name of a value → its unit.
        key: value by which the JSON has the rows, as an object; empty for a list of rows.
        shown: whether a row is printed in the text, from its values.
        proofs: columns like ``columns`` that are printed only where proofs are asked for.
        errors: head of a column → error of its numbers, as an ``Answer`` has it; other columns do not come from steps.
    """

    name: str
    title: str
    columns: dict[str, Callable[[dict[str, Any]], str]]
    rows: Sequence[dict[str, Any]]
    units: dict[str, str] = {}  # noqa: RUF012
    key: str = ""
    shown: Callable[[dict[str, Any]], bool] = lambda row: True
    proofs: dict[str, Callable[[dict[str, Any]], str]] = {}  # noqa: RUF012
    errors: dict[str, float | None] = {}  # noqa: RUF012

    @property
    def cells(self) -> list[list[str]]:
        """The rows of the text."""
        return [[round_words(cell(row), self.errors.get(head, 0.0)) for head, cell in self.columns.items()]
                for row in self.rows if self.shown(row)]

    def with_proofs(self) -> Table:
        """Return the table with the columns of its proofs."""
        return self._replace(columns={**self.columns, **self.proofs})


def collect_values(groups: Iterable[Group | Table]) -> dict[str, Any]:
    """Return the answers by name, levels as nested dictionaries."""
    values: dict[str, Any] = {}
    for name, value in _list_named(groups):
        *parents, last = name.split(".")
        level = values
        for parent in parents:
            level = level.setdefault(parent, {})
        assert last not in level, f"two answers are called {name}"
        level[last] = value
    return values


def collect_units(groups: Iterable[Group | Table]) -> dict[str, str]:
    """Return the units by the names of the answers, explanations after them."""
    units: dict[str, str] = {}
    for group in groups:
        if isinstance(group, Table):
            if group.name and group.rows:
                units |= {f"{group.name}.{name}": unit for name, unit in group.units.items()}
            continue
        for answer in group.answers:
            said = ", ".join(filter(None, (answer.unit, answer.explanation)))
            if answer.name and said:
                units[answer.name] = said
    return units


def _list_named(groups: Iterable[Group | Table]) -> Iterator[tuple[str, Any]]:
    for group in groups:
        if isinstance(group, Group):
            yield from ((answer.name, answer.value) for answer in group.answers if answer.name)
        elif group.key:
            yield group.name, {row[group.key]: _without(row, group.key) for row in group.rows}
        elif group.name:
            yield group.name, list(group.rows)


def _without(row: dict[str, Any], key: str) -> dict[str, Any]:
    return {name: value for name, value in row.items() if name != key}


def plain(value: Any) -> Any:
    """Return nested data as JSON has it; numbers that are not finite become None."""
    if isinstance(value, dict):
        return {key: plain(item) for key, item in value.items()}
    if isinstance(value, list | tuple):
        return [plain(item) for item in value]
    if isinstance(value, bool | str) or value is None:
        return value
    if np.ndim(value):
        return plain(np.asarray(value).tolist())
    if isinstance(value, int | np.integer):
        return int(value)
    number = float(value)
    return number if math.isfinite(number) else None
