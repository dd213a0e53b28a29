"""Polar motion as the IERS writes it: series C04 (of 2014 and 2020) and the tables "finals" of Bulletin A.

Both give the pole's x towards Greenwich and y towards 90° West, in arcseconds, once a day.
"""

from __future__ import annotations

import math
import re
from dataclasses import dataclass
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from typing import NamedTuple

import numpy as np

from polhode.errors import FormatError, InvalidInput, shown
from polhode.formats.numerals import read_number
from polhode.formats.opening import MB, read_text
from polhode.formats.paths import as_path
from polhode.types import Array, Float64

KIND = "polar motion"
LIMIT = 64 * MB
ARCSECOND = math.pi / 648_000.0
DEFAULT = "eopc04.1962-now"
_FINALS = re.compile(r"[ \d]{2}[ \d]{2}[ \d]{2} \d{5}\.\d\d ")
_REMEDY = ("Give a C04 file (year, month, day, with or without hour, MJD, x, y, …) or finals2000A.all, as the IERS "
           "publishes them")


class FileLimits(NamedTuple):
    """What values a file of polar motion may have."""

    max_distance: float = 5.0  # arcseconds from the origin; the pole has stayed within 0.8
    first_day: float = 15_020.0  # modified Julian date, of 1900
    last_day: float = 90_000.0  # of 2105; numbers beyond are of another column


LIMITS = FileLimits()


@dataclass(frozen=True, eq=False)
class PoleSeries:
    """Polar motion from a file.

    Attributes:
        days: (n,) modified Julian dates, UTC, ascending.
        x, y: (n,) the pole towards Greenwich and towards 90° West [rad].
        x_error, y_error: (n,) their standard deviations as the file states them [rad]; NaN where it has none.
        form: "C04 20", "C04 14" or "finals".
        source: the file's name, or the package with its version.
        predicted: lines left out because they are predictions.
    """

    days: Float64[Array, "n"]
    x: Float64[Array, "n"]
    y: Float64[Array, "n"]
    x_error: Float64[Array, "n"]
    y_error: Float64[Array, "n"]
    form: str
    source: str
    predicted: int = 0


class _Form(NamedTuple):
    """Where a C04 file has its columns, counted from 0."""

    name: str
    mjd: int
    x: int
    x_error: int
    fewest: int


_C04 = {3: _Form("C04 14", 3, 4, 10, 12), 4: _Form("C04 20", 4, 5, 13, 15)}  # by the column of the MJD


def read_polar_motion(path: str | Path | None = None) -> PoleSeries:
    """Read polar motion from a file of the IERS, or from the series C04 that the package astropy-iers-data carries.

    Args:
        path: C04 of 2014 or 2020, or a table "finals" with its fixed columns; None for the package's C04 since 1962.

    Raises:
        InvalidInput: for a file that is missing or cannot be read, and for None where the package is not installed.
        FormatError: for anything else than those forms, with file, line and column.
    """
    if path is None:
        path, source = _find_installed()
    else:
        path = as_path("path", path)
        source = path.name
    lines = read_text(path, KIND, LIMIT).splitlines()
    first = next((line for line in lines if _is_data(line)), None)
    if first is None:
        what = "has no line of data" if any(line.strip() for line in lines) else "is empty"
        raise FormatError(f"{path}: {what}. {_REMEDY}.")
    if _FINALS.match(first):
        rows, predicted = _finals_rows(path, lines)
        form = "finals"
    else:
        form, rows = _c04_rows(path, lines, first)
        predicted = 0
    if not rows:
        raise FormatError(f"{path}: has no measured pole, only predictions or empty columns. {_REMEDY}.")
    table = np.array(rows)
    table[:, 1:] *= ARCSECOND
    days, x, y, x_error, y_error = table.T
    return PoleSeries(days, x, y, x_error, y_error, form, source, predicted)


def _find_installed() -> tuple[Path, str]:
    import astropy_iers_data

    try:
        number = version("astropy-iers-data")
    except PackageNotFoundError:
        number = "?"
    return Path(str(astropy_iers_data.IERS_B_FILE)), f"IERS C04 of astropy-iers-data {number}"


def _is_data(line: str) -> bool:
    """Whether a line begins with a number, unlike the words above the numbers."""
    return line.strip()[:1].isdigit()


def _c04_rows(path: Path, lines: list[str], first: str) -> tuple[str, list[tuple[float, ...]]]:
    form = _c04_form(path, lines.index(first) + 1, first.split())
    rows: list[tuple[float, ...]] = []
    started = False
    for count, line in enumerate(lines, 1):
        if not (_is_data(line) if not started else line.strip() and not line.startswith("#")):
            continue
        started = True
        words = line.split()
        if len(words) < form.fewest:
            raise FormatError(f"{path}, line {count}: has {len(words)} columns; {form.name} has at least "
                              f"{form.fewest}, up to the errors of x and y. {_REMEDY}.")
        places = (form.mjd, form.x, form.x + 1, form.x_error, form.x_error + 1)
        row = tuple(_number(path, count, place + 1, words[place]) for place in places)
        rows.append(_check_row(path, count, row, rows[-1][0] if rows else None))
    return form.name, rows


def _c04_form(path: Path, line: int, words: list[str]) -> _Form:
    for place, form in _C04.items():
        try:
            if len(words) > place and LIMITS.first_day < read_number(words[place]) < LIMITS.last_day:
                return form
        except ValueError:
            continue
    raise FormatError(f"{path}, line {line}: is no line of polar motion: no modified Julian date is in column "
                      f"4 or 5. {_REMEDY}.")


def _finals_rows(path: Path, lines: list[str]) -> tuple[list[tuple[float, ...]], int]:
    """Return the rows of a table with fixed columns, and how many predictions were left out."""
    rows: list[tuple[float, ...]] = []
    predicted = 0
    for count, line in enumerate(lines, 1):
        if not line.strip():
            continue
        if not line[16:55].strip():  # dates behind the last prediction
            continue
        flag = line[16:17]
        if flag not in ("I", "P"):
            raise FormatError(f"{path}, line {count}, column 17: must be I (measured) or P (predicted); got "
                              f"{shown(flag)}. {_REMEDY}.")
        if flag == "P":
            predicted += 1
            continue
        cuts = ((7, 15), (18, 27), (37, 46), (27, 36), (46, 55))
        row = tuple(_number(path, count, a + 1, line[a:b].strip()) for a, b in cuts)
        rows.append(_check_row(path, count, row, rows[-1][0] if rows else None))
    return rows, predicted


def _number(path: Path, line: int, column: int, word: str) -> float:
    try:
        return read_number(word)
    except ValueError as error:
        what = f"{shown(word)} {error}" if word else "is empty"
        raise FormatError(f"{path}, line {line}, column {column}: {what}. Correct the line, or leave it out.") from None


def _check_row(path: Path, line: int, row: tuple[float, ...], before: float | None) -> tuple[float, ...]:
    day, x, y, x_error, y_error = row
    where = f"{path}, line {line}"
    if not LIMITS.first_day < day < LIMITS.last_day:
        raise FormatError(f"{where}: {day:g} is no modified Julian date between 1900 and 2105. {_REMEDY}.")
    if before is not None and day <= before:
        raise FormatError(f"{where}: MJD {day:g} comes after {before:g}; dates must ascend. Sort the lines.")
    if max(abs(x), abs(y)) > LIMITS.max_distance:
        raise FormatError(f"{where}: the pole is at ({x:g}, {y:g}) arcseconds; it stays within "
                          f"{LIMITS.max_distance:g}. Correct the line, or give arcseconds.")
    if x_error < 0.0 or y_error < 0.0:
        raise FormatError(f"{where}: errors of x and y must not be negative; got {x_error:g} and {y_error:g}. "
                          "Correct the line.")
    return row


def parse_day(text: str, name: str) -> float:
    """Return the modified Julian date of a calendar day like 1976-01-01.

    Raises:
        InvalidInput: for anything else, naming the argument.

    >>> parse_day("2000-01-01", "`start`")
    51544.0
    """
    try:
        if not re.fullmatch(r"\d{4}-\d\d-\d\d", text, re.ASCII):
            raise ValueError
        day = np.datetime64(text, "D")
    except ValueError:
        raise InvalidInput(f"{name} must be a day like 1976-01-01; got {shown(text)}.") from None
    return float((day - np.datetime64("1858-11-17", "D")).astype(int))


def format_day(day: float) -> str:
    """Return the calendar day of a modified Julian date.

    >>> format_day(51544.3)
    '2000-01-01'
    """
    return str(np.datetime64("1858-11-17", "D") + np.timedelta64(math.floor(day), "D"))
