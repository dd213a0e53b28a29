"""Exercises as data: texts, numbers drawn from a seed, answers as expressions over polhode, hints for mistakes.

One file of TOML for each chapter, in the folder ``exercises``. Everything that shows an exercise reads it here: the
page that checks answers, the worksheet, the teacher's key, and the test that computes every answer by a second way.
"""

from __future__ import annotations

import difflib
import math
import re
import tomllib
import zlib
from collections.abc import Collection, Iterable
from functools import cache
from pathlib import Path
from typing import Any, Literal, NamedTuple

import numpy as np
from pydantic import BaseModel, ConfigDict, Field, ValidationError, field_validator, model_validator

from polhode.course.responses import respond
from polhode.errors import InvalidInput, shown

FOLDER = Path(__file__).parent / "exercises"
TIERS = ("beginner", "intermediate", "master")
Tier = Literal["beginner", "intermediate", "master"]
_NAME = r"^[a-z][a-z0-9-]*$"
_PLACE = re.compile(r"\{([A-Za-z]\w*)\}")


class ExerciseThresholds(NamedTuple):
    """Numbers that decide whether an exercise is refused.

    Attributes:
        max_draws: of its numbers, after which `require` counts as impossible.
    """

    max_draws: int = 200


LIMITS = ExerciseThresholds()


class _Data(BaseModel):
    model_config = ConfigDict(extra="forbid", frozen=True, populate_by_name=True)


class Draw(_Data):
    """A number to be drawn: from a range in steps, or one of a list.

    Attributes:
        start: least value ("from" in the file).
        stop: largest value ("to").
        step: between values; its decimals are those of the text.
        one_of: the values to choose from, instead of a range.
    """

    start: float | None = Field(None, alias="from")
    stop: float | None = Field(None, alias="to")
    step: float | None = None
    one_of: tuple[float, ...] = ()

    @model_validator(mode="after")
    def _is_range_or_list(self) -> Draw:
        if self.one_of:
            if (self.start, self.stop, self.step) != (None, None, None):
                raise ValueError("`one_of` excludes a range: leave out from, to and step")
        elif self.start is None or self.stop is None or self.step is None:
            raise ValueError("a number needs from, to and step, or one_of")
        elif not (self.step > 0.0 and self.stop > self.start):
            raise ValueError("`step` must be positive, and `to` more than `from`")
        return self

    def pick(self, generator: np.random.Generator) -> float:
        """Return one of the values."""
        if self.one_of:
            return self.one_of[int(generator.integers(len(self.one_of)))]
        assert self.start is not None and self.stop is not None and self.step is not None
        count = math.floor((self.stop - self.start) / self.step + 1e-9)
        digits = max(0, -math.floor(math.log10(self.step) + 1e-9) + 1)
        return round(self.start + self.step * int(generator.integers(count + 1)), digits)


class Mistake(_Data):
    """The result of a typical mistake, and a hint for it.

    Attributes:
        value: expression of the numbers and of `answer`.
        hint: a sentence.
    """

    value: str
    hint: str


class Question(NamedTuple):
    """An exercise with its numbers.

    Attributes:
        text: the question.
        answer: in the unit.
        unit: of the answer, as shown; empty for a plain number.
        tolerance: relative, within which an answer counts as right.
        mistakes: values that typical mistakes give, with a hint for each.
        solution: how to find the answer, in a few sentences.
    """

    text: str
    answer: float
    unit: str
    tolerance: float
    mistakes: tuple[tuple[float, str], ...]
    solution: str

    def respond_to(self, answer: str) -> str:
        """Return the response to an answer: "Right.", a hint, or in which direction it is off; see ``respond``.

        Args:
            answer: as typed; a comma may stand for the decimal point.
        """
        return respond(answer, self.answer, self.mistakes, self.tolerance)


class Exercise(_Data):
    """A question with numbers.

    Attributes:
        name: unique in its chapter.
        tier: "beginner", "intermediate" or "master".
        text: of the question; {name} represents a number.
        numbers: what is drawn, by name.
        require: a condition on the numbers.
        where: further values, by name, each an expression of those before.
        answer: expression over polhode.
        check: the same by a second way: arithmetic, an integral, another route.
        unit: of the answer.
        tolerance: relative.
        mistakes: typical ones.
        solution: how to find the answer; {name} and {answer} stand for numbers.
    """

    name: str = Field(pattern=_NAME)
    tier: Tier
    text: str
    numbers: dict[str, Draw] = {}
    require: str = "True"
    where: dict[str, str] = {}
    answer: str
    check: str
    unit: str = ""
    tolerance: float = Field(0.005, gt=0.0, lt=0.2)
    mistakes: tuple[Mistake, ...] = Field((), alias="mistake")
    solution: str

    @model_validator(mode="after")
    def _names_what_there_is(self) -> Exercise:
        known = {*self.numbers, *self.where, "answer"}
        for text in (self.text, self.solution):
            missing = set(_PLACE.findall(text)) - known
            if missing:
                raise ValueError(f"{{{missing.pop()}}} is none of its numbers")
        return self

    def draw(self, seed: int) -> Question:
        """Return the exercise with the numbers that belong to a seed.

        Args:
            seed: not negative; the same seed gives the same numbers.

        Raises:
            InvalidInput: if no numbers fulfil `require`.
        """
        values = self.values(seed)
        return Question(
            self._fill(self.text, values), values["answer"], self.unit, self.tolerance,
            tuple((float(evaluate(one.value, values)), one.hint) for one in self.mistakes),
            self._fill(self.solution, values),
        )

    def values(self, seed: int) -> dict[str, Any]:
        """Return the numbers of a seed by name, `where` and `answer` included; see ``draw``."""
        generator = np.random.default_rng([seed, zlib.crc32(self.name.encode())])
        for _ in range(LIMITS.max_draws):
            values: dict[str, Any] = {name: one.pick(generator) for name, one in self.numbers.items()}
            if evaluate(self.require, values):
                break
        else:
            raise InvalidInput(f"exercise {self.name}: no numbers of {LIMITS.max_draws} fulfil `require`; got "
                               f"{shown(self.require)}. Widen the ranges.")
        for name, expression in self.where.items():
            values[name] = evaluate(expression, values)
        values["answer"] = float(evaluate(self.answer, values))
        return values

    def _fill(self, text: str, values: dict[str, Any]) -> str:
        return _PLACE.sub(lambda place: self._write(place[1], values[place[1]]), text)

    def _write(self, name: str, value: Any) -> str:
        return str(value) if isinstance(value, str) else _in_digits(float(value), exact=name in self.numbers)


class Option(_Data):
    """One of the answers to choose from.

    Attributes:
        text: the answer.
        right: whether it is.
        response: what to tell who chooses it.
    """

    text: str
    right: bool = False
    response: str


class Choice(_Data):
    """A question with answers to choose from.

    Attributes:
        name: unique in its chapter.
        tier: "beginner", "intermediate" or "master".
        text: of the question.
        options: two at least, one of them right.
    """

    name: str = Field(pattern=_NAME)
    tier: Tier
    text: str
    options: tuple[Option, ...] = Field(alias="option", min_length=2)

    @field_validator("options")
    @classmethod
    def _has_one_right(cls, options: tuple[Option, ...]) -> tuple[Option, ...]:
        if sum(one.right for one in options) != 1:
            raise ValueError("exactly one option must be right")
        return options


class Chapter(_Data):
    """The exercises of a chapter.

    Attributes:
        title: of the chapter.
        exercises: with numbers, in their order.
        choices: with answers to choose from, in their order.
    """

    title: str
    exercises: tuple[Exercise, ...] = Field((), alias="exercise")
    choices: tuple[Choice, ...] = Field((), alias="choice")

    @model_validator(mode="after")
    def _has_unique_names(self) -> Chapter:
        names = [one.name for one in (*self.exercises, *self.choices)]
        twice = {name for name in names if names.count(name) > 1}
        if twice:
            raise ValueError(f"the name {twice.pop()} is used twice")
        return self

    def find(self, name: str) -> Exercise | Choice:
        """Return an exercise or a choice by its name.

        Raises:
            InvalidInput: for an unknown name.
        """
        for one in (*self.exercises, *self.choices):
            if one.name == name:
                return one
        names = [one.name for one in (*self.exercises, *self.choices)]
        raise InvalidInput(f"an exercise of “{self.title}” must be one of {', '.join(names)}; got {shown(name)}."
                           f"{suggest_name(name, names)}")


def chapter_names() -> list[str]:
    """Return the names of the chapters that have exercises, in their order."""
    return list(chapters_of_files(FOLDER.glob("*.toml")))


@cache
def read_chapter(name: str) -> Chapter:
    """Return the exercises of a chapter.

    Args:
        name: such as "two-surfaces", or its number, such as "5"; ``chapter_names`` lists them.

    Raises:
        InvalidInput: for an unknown name, or a file that breaks a rule.
    """
    paths = chapters_of_files(FOLDER.glob("*.toml"))
    path = paths[choose_chapter(paths, name)]
    try:
        return Chapter.model_validate(tomllib.loads(path.read_text("utf-8")))
    except (tomllib.TOMLDecodeError, ValidationError) as error:
        raise InvalidInput(f"{path.name}: {error}") from None


def chapters_of_files(paths: Iterable[Path]) -> dict[str, Path]:
    """Return the files of chapters by the chapters' names, in their order: "two-surfaces" for 05_two_surfaces.toml."""
    return {path.stem.partition("_")[2].replace("_", "-"): path for path in sorted(paths)}


def choose_chapter(names: Collection[str], chapter: str) -> str:
    """Return the name of a chapter that is given by its name or number.

    Raises:
        InvalidInput: for a chapter that there is not.
    """
    by_number = {str(number): name for number, name in enumerate(names, 1)}
    name = by_number.get(chapter.lstrip("0"), chapter)
    if name not in names:
        raise InvalidInput(f"a chapter must be a number from 1 to {len(names)} or one of {', '.join(names)}; "
                           f"got {shown(chapter)}.{suggest_name(chapter, list(names))}")
    return name


def evaluate(expression: str, values: dict[str, Any]) -> Any:
    """Return the value of an expression over polhode (`ph`), NumPy (`np`), SciPy's `integrate` and `math`'s functions.

    Only files of the package come here: an expression is code.
    """
    return eval(expression, {**_namespace(), **values})


@cache
def _namespace() -> dict[str, Any]:
    from scipy import integrate

    import polhode

    functions = {name: getattr(math, name) for name in dir(math) if not name.startswith("_")}
    return {**functions, "np": np, "ph": polhode, "integrate": integrate}


def _in_digits(value: float, *, exact: bool) -> str:
    """Return a number for a text: a drawn one with all its digits, a computed one with four."""
    text = f"{value:.12g}" if exact else f"{value:.4g}"
    if "e" in text:
        mantissa, _, exponent = text.partition("e")
        return f"{mantissa.replace('-', '−')}·10{str(int(exponent)).translate(_RAISED)}"
    return text.replace("-", "−")


_RAISED = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


def suggest_name(name: str, names: list[str]) -> str:
    """Return " Did you mean …?" for a name that is close to one of several, else nothing."""
    near = difflib.get_close_matches(str(name), names, 1)
    return f" Did you mean {near[0]}?" if near else ""
