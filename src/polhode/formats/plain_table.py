"""Numbers of chosen columns of a plain table, in blocks of lines by NumPy's reader, line by line where that fails."""

from __future__ import annotations

import io
import re
import warnings
from collections.abc import Callable, Iterator, Sequence
from itertools import islice
from pathlib import Path
from typing import NamedTuple

import numpy as np

from polhode.errors import FormatError, shown
from polhode.formats.numerals import LIMITS, MAY_VANISH, read_number
from polhode.formats.opening import MB, open_file
from polhode.formats.table_form import COMMENT, Line, TableForm, detect_form, is_comment, split_cells
from polhode.formats.table_form import LIMITS as FORM_LIMITS
from polhode.types import Array, Float64, Integer

LARGEST_FILE = 2000 * MB
BLOCK = 2_000_000  # characters that are in memory at once
MISSING = ("", "nan", "na", "n/a", "null", "none", "-")
"""The text of cells without a number, in lower case."""
_NO_CELLS = re.compile(rf"(?m)^\s*(?:[{''.join(COMMENT)}]|$)")
_DECIMAL_COMMA = re.compile(r"[+-]?\d*,\d+(?:[eE][+-]?\d+)?", re.ASCII)


class PlainTable(NamedTuple):
    """Columns of a table.

    Attributes:
        numbers: (n, k), NaN where a cell is blank or NaN.
        lines: (n,) the number of the line of each row.
    """

    numbers: Float64[Array, "rows columns"]
    lines: Integer[Array, "rows"]


def table_form(path: Path) -> TableForm:
    """Return the form of a table.

    Raises:
        InvalidInput: for a file that is missing, not regular, or cannot be read.
        FormatError: for a file that is not text, or not a table.
    """
    return detect_form(path, first_lines(path))


def first_lines(path: Path) -> list[Line]:
    """Return the lines from which the form is detected; raises as ``table_form`` does."""
    return list(islice(_read_lines(path), FORM_LIMITS.max_comments + FORM_LIMITS.max_rows))


def detect_decimal(path: Path, form: TableForm) -> str:
    """Return "comma" where the first numbers have commas and no points, else "point", also where all are blank.

    Raises:
        InvalidInput, FormatError: as ``table_form`` does.
    """
    if form.delimiter == ",":
        return "point"
    texts = [line.text for line in first_lines(path) if line.number >= form.first and not is_comment(line.text)]
    cells = [cell.strip(' "') for text in texts[: FORM_LIMITS.max_rows] for cell in text.split(form.delimiter)]
    commas = any(map(_DECIMAL_COMMA.fullmatch, cells))
    return "comma" if commas and not any("." in cell for cell in cells) else "point"


def read_cells(
    path: Path, form: TableForm, columns: Sequence[int], decimal: str, progress: Callable[[int], None] | None = None
) -> PlainTable:
    """Return the numbers of some columns.

    Args:
        path: of the table.
        form: of the table.
        columns: which, from 0.
        decimal: "point" or "comma".
        progress: called with the number of lines read, now and then.

    Raises:
        InvalidInput: as ``table_form`` does.
        FormatError: naming line and column, for a cell that is neither a number nor blank, and for lines of another
            number of cells.
    """
    numbers: list[Array] = [np.zeros((0, len(columns)))]
    places: list[Array] = [np.zeros(0, dtype=int)]
    for first, texts in _read_blocks(path):
        at = np.arange(first, first + len(texts))
        last = first + len(texts) - 1
        if first < form.first or _NO_CELLS.search("\n".join(texts)):
            kept = [k for k, text in enumerate(texts) if at[k] >= form.first and not is_comment(text)]
            texts, at = [texts[k] for k in kept], at[kept]
        if texts:
            block = _by_numpy(texts, form, columns, decimal)
            numbers.append(_line_by_line(path, at, texts, form, columns, decimal) if block is None else block)
            places.append(at)
        if progress is not None:
            progress(last)
    return PlainTable(_join_blocks(numbers), _join_blocks(places))


def _join_blocks(blocks: list[Array]) -> Array:
    """Return blocks as one array; each is freed as soon as it is copied, so that memory holds the table once."""
    whole = np.empty((sum(map(len, blocks)), *blocks[0].shape[1:]), blocks[0].dtype)
    end = len(whole)
    while blocks:
        block = blocks.pop()
        whole[end - len(block) : end] = block
        end -= len(block)
    return whole


def read_texts(path: Path, form: TableForm, column: int) -> Iterator[str]:
    """Yield the cells of a column unchanged, from a table that ``read_cells`` has read without an error.

    Raises:
        InvalidInput, FormatError: as ``table_form`` does.
    """
    for line in _read_lines(path):
        if line.number >= form.first and not is_comment(line.text):
            yield split_cells(line.text, form.delimiter)[column]


def read_rows(path: Path, form: TableForm, columns: Sequence[int]) -> Iterator[tuple[int, tuple[str, ...]]]:
    """Yield the number of each line and its cells in some columns, as ``read_texts`` does.

    Raises:
        InvalidInput, FormatError: as ``table_form`` does.
    """
    for line in _read_lines(path):
        if line.number >= form.first and not is_comment(line.text):
            cells = split_cells(line.text, form.delimiter)
            yield line.number, tuple(cells[column] for column in columns)


def _read_lines(path: Path) -> Iterator[Line]:
    return (Line(first + k, text) for first, texts in _read_blocks(path) for k, text in enumerate(texts))


def _read_blocks(path: Path) -> Iterator[tuple[int, list[str]]]:
    """Yield the lines of a file in blocks, with the number of the first of each."""
    try:
        with io.TextIOWrapper(open_file(path, "table", LARGEST_FILE), "utf-8-sig") as file:
            first, rest, ended = 1, "", False
            while not ended:
                more = file.read(BLOCK)
                ended = not more
                texts = (rest + more).split("\n")
                rest = texts.pop()  # a line that may go on
                if ended and rest:
                    texts, rest = [rest], ""
                _check_lines(path, first, [*texts, rest])
                if texts:
                    yield first, texts
                first += len(texts)
    except UnicodeDecodeError:
        why = "is not UTF-8 text, so it is not a table that can be read"
        raise FormatError(f"{path}: {why}. Save it as UTF-8.") from None


def _check_lines(path: Path, first: int, texts: Sequence[str]) -> None:
    for k, text in enumerate(texts):
        if len(text) > LIMITS.max_line:
            raise FormatError(f"{path}, line {first + k}: has more than {LIMITS.max_line} characters.")
        if "\0" in text:
            raise FormatError(f"{path}, line {first + k}: has a NUL byte, so it is not a text file. Save it as "
                              "UTF-8 text.")


def _by_numpy(texts: Sequence[str], form: TableForm, columns: Sequence[int], decimal: str) -> Array | None:
    """Return the numbers of a block, None where it has to be read line by line."""
    sign = form.delimiter
    if sign == " ":
        regular = all(len(text.split()) == form.width for text in texts)
    else:
        regular = all(text.count(sign) == form.width - 1 for text in texts)
    whole = "\n".join(texts)
    if not regular or '"' in whole or MAY_VANISH.search(whole):
        return None
    if decimal == "comma":
        if "." in whole:
            return None
        whole = whole.replace(",", ".")
    # a cell that is blank would end NumPy's reading
    blank = re.compile(rf"(?m)(^|{re.escape(sign)})[ ]*(?={re.escape(sign)}|$)")
    for attempt in (lambda: whole, lambda: blank.sub(r"\1nan", whole)):
        try:
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")
                table = np.loadtxt(io.StringIO(attempt()), delimiter=None if sign == " " else sign, comments=None,
                                   usecols=columns, ndmin=2)
        except ValueError:
            continue
        if len(table) == len(texts) and not np.isinf(table).any():
            return table
    return None


def _line_by_line(
    path: Path, numbers: Integer[Array, "n"], texts: Sequence[str], form: TableForm, columns: Sequence[int],
    decimal: str,
) -> Array:
    values = np.empty((len(texts), len(columns)))
    for row, number, text in zip(values, numbers.tolist(), texts, strict=True):
        try:
            cells = split_cells(text, form.delimiter)
        except ValueError as error:
            raise FormatError(f"{path}, line {number}: {error}. Check the line.") from None
        while len(cells) > form.width and not cells[-1]:
            cells.pop()
        if len(cells) != form.width:
            hint = " Is the comma a decimal one? Then save it with semicolons." if form.delimiter == "," else ""
            raise FormatError(f"{path}, line {number}: has {len(cells)} cells, and line {form.first} has "
                              f"{form.width}. Check the line, or delete it.{hint}")
        for k, column in enumerate(columns):
            row[k] = _number(path, number, form, column, cells[column], decimal)
    return values


def _number(path: Path, line: int, form: TableForm, column: int, cell: str, decimal: str) -> float:
    if cell.lower() in MISSING:
        return np.nan
    where = f"{path}, line {line}, {name_column(form, column)}"
    if decimal == "comma" and "." in cell:
        raise FormatError(f"{where}: {shown(cell)} has a point, and decimal commas are announced. Choose one of them.")
    text = cell.replace(",", ".") if decimal == "comma" and _DECIMAL_COMMA.fullmatch(cell) else cell
    try:
        return read_number(text)
    except ValueError as error:
        remedy = "Correct it, or leave the cell blank."
        if decimal == "point" and _DECIMAL_COMMA.fullmatch(cell):
            remedy = "If its comma is a decimal one, say so by `decimal` comma."
        elif ":" in cell:
            remedy = "If times are dates or times of day, all of the column must be, and `time_unit` must be left out."
        raise FormatError(f"{where}: {shown(cell)} {error}. {remedy}") from None


def name_column(form: TableForm, column: int) -> str:
    """Return a column's name for messages; columns count from 0."""
    name = form.names[column] if form.names else ""
    return f"column {column + 1} {shown(name)}" if name else f"column {column + 1}"
