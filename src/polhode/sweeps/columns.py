"""What a sweep keeps of each sample: answers and parts of states as columns, found by their names."""

from __future__ import annotations

import difflib
import math
from collections.abc import Iterable, Mapping
from typing import Any, NamedTuple

import numpy as np

from polhode.errors import InvalidInput, shown
from polhode.motion._trajectory import Trajectory
from polhode.reports.answer import Group, Table
from polhode.spec.keys import is_place
from polhode.sweeps.plan import STATES

YES, NO = "yes", "no"


class ColumnThresholds(NamedTuple):
    """A number that decides which outputs a sweep has.

    Attributes:
        max_word: characters of a word that is an output; longer texts are none.
    """

    max_word: int = 24


LIMITS = ColumnThresholds()


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


class NoSuchAnswer(InvalidInput):
    """A name that no answer has."""


def take_output(values: Mapping[str, Any], name: str) -> Any:
    """Return the values of an output, which may be one component of a computed vector."""
    if name in values:
        return values[name]
    whole, _, place = name.rpartition(".")
    return values[whole][:, int(place) - 1]


def pick(values: Any, name: str) -> Any:
    """Return an answer by its name in the JSON; places in lists count from 1. None where there is none."""
    for part in name.split("."):
        if isinstance(values, dict):
            values = values.get(part)
        elif isinstance(values, list) and is_place(part) and 1 <= int(part) <= len(values):
            values = values[int(part) - 1]
        else:
            return None
    return values


def fit_to_column(column: Column, value: Any) -> Any:
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


def answer_column(name: str, values: dict[str, Any], units: dict[str, str]) -> Column:
    """Return the type of an answer.

    Raises:
        NoSuchAnswer: for names that the report does not have, and texts.
    """
    if not has_answer(values, name):
        known = sorted(name for name in _names(values) if " " not in name)
        near = difflib.get_close_matches(name, known, 1)
        hint = f"did you mean {near[0]}?" if near else f"some that it has: {', '.join(known[:12])}, …"
        raise NoSuchAnswer(f"sweep.outputs: the report has no answer {shown(name)}; {hint} `polhode report SPEC "
                            "--json` shows all; places in lists count from 1.")
    value = pick(values, name)
    unit = _unit(units, name)
    if isinstance(value, bool):
        return Column(name, text=True)
    if isinstance(value, str):
        if len(value) > LIMITS.max_word:
            raise NoSuchAnswer(f"sweep.outputs: {name} is a sentence, not a number or a word. Leave it out.")
        return Column(name, text=True)
    try:
        shape = np.shape(np.array(0.0 if value is None else value, dtype=float))
    except (TypeError, ValueError):
        parts = ", ".join(sorted(f"{name}.{part}" for part in _names(value))[:6])
        raise NoSuchAnswer(f"sweep.outputs: {name} is a table of answers; name one, like {parts}.") from None
    return Column(name, shape, unit=unit, known=value is not None)


def has_answer(values: Any, name: str) -> bool:
    """Whether the JSON has a name, if only as null, or within one that is null here."""
    for part in name.split("."):
        if values is None:
            return True
        inside = pick(values, part)
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


def units_of(groups: Iterable[Group | Table]) -> dict[str, str]:
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


def state_column(name: str, trajectory: Trajectory, times: tuple[float, ...]) -> Column:
    part = name.removeprefix(STATES)
    own = [*trajectory.layout.names, *(["angular_velocity"] if trajectory.angular_velocity is not None else [])]
    if part not in own:
        has = ", ".join(dict.fromkeys(own))
        raise NoSuchAnswer(f"sweep.outputs: the state has no part {shown(part)}; it has {has}.")
    entry = next((one for one in trajectory.layout.parts if one.name == part), None)
    unit = "rad/s" if entry is None else entry.unit
    values = state_part(name, trajectory, times)
    frame = "" if trajectory.frame is None else "body axes are the principal ones"
    return Column(name, np.shape(values), unit=unit, note=frame)


def state_part(name: str, trajectory: Trajectory, times: tuple[float, ...]) -> Any:
    """Return a part of the state (time, …) at these times, NaN where the motion ended before."""
    part = name.removeprefix(STATES)
    layout, sampled = trajectory.layout, np.asarray(trajectory.times)
    values = layout.part(trajectory.states, part) if part in layout.names else getattr(trajectory, part)
    values = np.asarray(values, dtype=float)
    at = np.minimum(np.searchsorted(sampled, times), len(sampled) - 1)
    there = (sampled[at] == np.asarray(times)).reshape(-1, *[1] * (values.ndim - 1))
    return np.where(there, values[at], math.nan)
