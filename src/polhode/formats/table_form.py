"""The layout of a plain table: its separator, the line that names its columns, and where its numbers begin.

It is detected from the first lines: the delimiter divides most of them into equally many cells, mostly numbers.
"""

from __future__ import annotations

import csv
import re
from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

from polhode.errors import FormatError, shown
from polhode.formats.header_words import ANGLE_UNITS, RATE_UNITS, TIME_UNITS, find_unit

COMMENT = ("#", "%")
DELIMITERS = {";": "semicolons", "\t": "tabs", ",": "commas", " ": "blanks"}
"""Tried in this order: where a semicolon divides lines into equal numbers, commas are decimal ones."""
_NUMBER = re.compile(r"[+-]?(?:\d+[.,]?\d*|[.,]\d+)(?:[eE][+-]?\d+)?|[+-]?(?:nan|inf|infinity)", re.ASCII | re.I)
_TWO_NUMBERS = re.compile(r"[+-]?[\d.]+(?:[eE][+-]?\d+)?\s+[+-]?[\d.]+(?:[eE][+-]?\d+)?", re.ASCII)
_DATE = re.compile(r"(?<!\S)\d{1,2}\s+[A-Za-z]{3,9}\s+\d{4}\s+\d\d:\d\d:\d\d(?:[.,]\d*)?(?!\S)", re.ASCII)
_WORD = re.compile(r'"[^"]*"|[^\s\[("]+(?:[ \t]*(?:\[[^\]]*\]|\([^)]*\)))?')


class FormLimits(NamedTuple):
    """Numbers of lines from which the form of a table is detected."""

    max_rows: int = 60  # with cells
    max_comments: int = 2000  # before these


LIMITS = FormLimits()


class Line(NamedTuple):
    """A line of a file, without its end, and its number from 1."""

    number: int
    text: str


class TableForm(NamedTuple):
    """The form of a table.

    Attributes:
        delimiter: one of ``DELIMITERS``; a blank means any number of blanks and tabs.
        width: how many columns it has.
        names: of the columns; none where no line names them.
        named_in: the number of the line that does.
        first: the number of the first line with numbers.
    """

    delimiter: str
    width: int
    names: tuple[str, ...]
    named_in: int | None
    first: int


def is_comment(text: str) -> bool:
    """Whether a line holds no cells: it is blank, or begins with # or %."""
    stripped = text.lstrip()
    return not stripped or stripped.startswith(COMMENT)


def split_cells(text: str, delimiter: str) -> list[str]:
    """Return the cells of a line, without the blanks around them and the quotes.

    Between blanks a date is one cell, though it has blanks of its own.

    Raises:
        ValueError: for quotes that do not close.

    >>> split_cells('"t, s"; 1.5 ;', ";")
    ['t, s', '1.5', '']
    >>> split_cells("01 Mar 2026 12:00:00.000   0.5", " ")
    ['01 Mar 2026 12:00:00.000', '0.5']
    """
    if delimiter == " " and ":" in text and '"' not in text:
        text = _DATE.sub(lambda match: f'"{match[0]}"', text)
    if '"' not in text:
        return text.split() if delimiter == " " else [cell.strip() for cell in text.split(delimiter)]
    text = " ".join(text.split()) if delimiter == " " else text
    try:
        cells = next(csv.reader([text], delimiter=delimiter, skipinitialspace=True, strict=True))
        return [cell.strip() for cell in cells]
    except (csv.Error, StopIteration) as error:
        raise ValueError(f"has quotes that do not close ({error})") from None


def detect_form(path: Path, lines: Sequence[Line]) -> TableForm:
    """Return the form of a table from its first lines.

    Args:
        path: for messages.
        lines: the first ones of the file, comments and blank ones too.

    Raises:
        FormatError: where no line holds numbers in two columns or more.
    """
    content = [line for line in lines if not is_comment(line.text)][:LIMITS.max_rows]
    tried = [(_count_agreeing(content, delimiter), delimiter) for delimiter in DELIMITERS]
    (count, begin), delimiter = max(tried, key=lambda one: one[0][0])  # the first of equals
    if not count:
        said = f"; its first line is {shown(content[0].text)}" if content else ""
        why = f"has no line of numbers in two columns or more, between commas, semicolons, tabs or blanks{said}"
        raise FormatError(f"{path}: {why}. Save it as a table with one sample in each line.")
    row = split_cells(content[begin].text, delimiter)
    comments = [line for line in lines if is_comment(line.text) and line.text.strip()]
    comments = [line for line in comments if line.number < content[0].number][-1:] if begin == 0 else []
    if begin > 1 and (named := _with_units(content[begin - 2].text, content[begin - 1].text, delimiter, row)):
        return TableForm(delimiter, len(row), named, content[begin - 2].number, content[begin].number)
    candidates = [content[begin - 1]] if begin else comments
    for line in candidates:
        if names := _names(line.text, delimiter, row):
            return TableForm(delimiter, len(row), names, line.number, content[begin].number)
    if begin:
        got = len(_header_cells(candidates[0].text, delimiter))
        raise FormatError(f"{path}, line {candidates[0].number}: must name the {len(row)} columns that line "
                          f"{content[begin].number} has; got {got} names. Name each, or delete the line.")
    return TableForm(delimiter, len(row), (), None, content[begin].number)


def _count_agreeing(content: Sequence[Line], delimiter: str) -> tuple[int, int]:
    """Return how many lines have as many cells as the first line of numbers, and the index of that; 0 without one."""
    widths = []
    begin = None
    for k, line in enumerate(content):
        try:
            cells = split_cells(line.text, delimiter)
        except ValueError:
            cells = []
        if begin is None and _has_numbers(cells):
            begin = k
        if begin is not None:
            widths.append(len(cells))
    return (0, 0) if begin is None else (widths.count(widths[0]), begin)


def _has_numbers(cells: Sequence[str]) -> bool:
    filled = [cell for cell in cells if cell]
    numbers = [cell for cell in filled if _NUMBER.fullmatch(cell)]
    return len(cells) > 1 and 2 * len(numbers) > len(filled) and not any(map(_TWO_NUMBERS.fullmatch, filled))


def _names(text: str, delimiter: str, row: Sequence[str]) -> tuple[str, ...]:
    """Return the names in a line for the columns of a row; none where it does not name them."""
    names = _header_cells(text, delimiter)
    if delimiter == " " and len(names) != len(row):
        names = [word.strip('"') for word in _WORD.findall(text.lstrip().lstrip("".join(COMMENT)))]
    if len(names) == len(row) - 1 and not row[-1]:
        names = [*names, ""]  # lines of numbers alone end in a delimiter
    fits = len(names) == len(row) and any(names) and not any(map(_NUMBER.fullmatch, names))
    return tuple(names) if fits else ()


def _with_units(text: str, units: str, delimiter: str, row: Sequence[str]) -> tuple[str, ...]:
    """Return names with the units of the line below them in brackets; none where that line is not one of units."""
    names, below = _names(text, delimiter, row), [cell.strip("[]()") for cell in _names(units, delimiter, row)]
    if not (names and any(map(_is_unit, below))) or any(map(_is_unit, names)):
        return ()
    return tuple(f"{name} [{unit}]" if unit else name for name, unit in zip(names, below, strict=True))


def _is_unit(word: str) -> bool:
    return any(find_unit(word, units) for units in (TIME_UNITS, ANGLE_UNITS, RATE_UNITS))


def _header_cells(text: str, delimiter: str) -> list[str]:
    try:
        return split_cells(text.lstrip().lstrip("".join(COMMENT)), delimiter)
    except ValueError:
        return []
