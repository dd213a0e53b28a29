"""Clocks of tables that count from a calendar day, or whose stamps take several columns.

Dates, Julian days, GPS weeks and POSIX seconds become whole seconds and picoseconds of their own time system, and
times count from the first of them, so that nothing is lost in doubles. Sums of columns are exact in decimal digits.

Source: IAU SOFA, *Time Scale and Calendar Tools*, for days of UTC with a leap second, which are 86401 s long here too;
IS-GPS-200, 20.3.3.3, for weeks of GPS; IEEE Std 1003.1, 4.19, for POSIX.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from decimal import ROUND_FLOOR, Decimal
from itertools import islice
from pathlib import Path
from typing import NamedTuple

import numpy as np

from polhode.errors import FormatError, InvalidInput, shown
from polhode.formats.dates import is_date, is_time_of_day, read_date, read_time_of_day
from polhode.formats.epochs import PICO, read_epoch, shortest, since
from polhode.formats.header_words import CALENDARS
from polhode.formats.leap_seconds import leap_seconds
from polhode.formats.plain_table import MISSING, name_column, read_rows, read_texts
from polhode.formats.stamps import IN_DECIMAL_SECONDS, Clock, exact_number
from polhode.formats.table_form import TableForm

DATE, TIME_OF_DAY = "dates", "times of day"
KINDS = (DATE, TIME_OF_DAY, *CALENDARS)
OWN_SYSTEM = {"gps": "GPS", "unix": "UTC", "unix-ms": "UTC", "unix-us": "UTC", "unix-ns": "UTC"}
FIRST_DAY = {"mjd": Decimal(40587), "jd": Decimal("2440587.5"), "gmat": Decimal("10587.5")}
"""1970-01-01T00:00 in each calendar's count [days]."""
GPS_ZERO = 3657 * 86400  # s from 1970-01-01 to 1980-01-06, both of a uniform system
WEEK = 604_800  # s
ROLLOVER = 1024  # weeks, after which receivers of the first signal begin again
PER_UNIX = {"unix": 1, "unix-ms": 10**3, "unix-us": 10**6, "unix-ns": 10**9}
Rows = Sequence[tuple[int, tuple[str, ...]]]
"""Numbers of lines, and the cells in the columns of times."""


class StampLimits(NamedTuple):
    """A number that decides what a column of stamps holds."""

    max_rows_inspected: int = 200  # of a column, searched for its first cell that is not blank


LIMITS = StampLimits()


class ClockColumns(NamedTuple):
    """Where a table has its times.

    Attributes:
        columns: from 0; two for weeks and seconds, or seconds and their fraction.
        units: of each; one of ``KINDS`` alone for a calendar.
        system: the given time system of a calendar; None where none is given.
    """

    columns: tuple[int, ...]
    units: tuple[str, ...]
    system: str | None = None

    @property
    def is_plain(self) -> bool:
        """Whether the times are one column of numbers in a unit of time."""
        return len(self.columns) == 1 and self.units[0] not in KINDS


def kind_of_cells(path: Path, form: TableForm, column: int) -> str | None:
    """Return "dates" or "times of day" where the first cell of a column is one; None for numbers."""
    for text in islice(read_texts(path, form, column), LIMITS.max_rows_inspected):
        if text.lower() not in MISSING:
            return DATE if is_date(text) else TIME_OF_DAY if is_time_of_day(text) else None
    return None


def first_odd_cell(path: Path, form: TableForm, column: int) -> str | None:
    """Return the first cell of a column that is not blank, unless it is a number."""
    for text in islice(read_texts(path, form, column), LIMITS.max_rows_inspected):
        if text.lower() not in MISSING:
            try:
                float(text.replace(",", "."))
            except ValueError:
                return text
            return None
    return None


def read_calendar(path: Path, form: TableForm, clock: ClockColumns, decimal: str) -> Clock:
    """Return the times of all rows, NaN where a row has none.

    Raises:
        InvalidInput: where the time system is needed, and neither given nor in the stamps.
        FormatError: naming the line, for text that is no stamp.
    """
    rows = list(read_rows(path, form, clock.columns))
    if decimal == "comma":
        rows = [(line, tuple(text.replace(",", ".") for text in row)) for line, row in rows]
    kind = clock.units[0]
    if kind == TIME_OF_DAY:
        return _read_times_of_day(path, form, clock, rows)
    if kind not in KINDS:
        return _read_sums(path, form, clock, rows)
    return _read_instants(path, form, clock, rows)


def _stamped_rows(rows: Rows) -> Iterator[tuple[int, int, tuple[str, ...]]]:
    """Yield the rows that have a stamp, with their index and line."""
    for k, (line, row) in enumerate(rows):
        if not any(text.lower() in MISSING for text in row):
            yield k, line, row


def _wrong(path: Path, form: TableForm, clock: ClockColumns, line: int, what: object) -> FormatError:
    """Return the error on the stamp of a line."""
    named = " and ".join(name_column(form, column) for column in clock.columns)
    return FormatError(f"{path}, line {line}, {named}: {what}. Correct it, or leave the cell blank.")


def _read_times_of_day(path: Path, form: TableForm, clock: ClockColumns, rows: Rows) -> Clock:
    half_a_day = 43_200  # s; times of day that fall by more have passed midnight
    times, days, before = np.full(len(rows), np.nan), 0, None
    for k, line, row in _stamped_rows(rows):
        try:
            seconds = read_time_of_day(row[0])
        except ValueError as error:
            raise _wrong(path, form, clock, line, error) from None
        days += before is not None and before - seconds > half_a_day
        before, times[k] = seconds, float(seconds + 86400 * days)
    passed = f" and pass midnight {days} times" if days > 1 else " and pass midnight once" if days else ""
    note = f"its times are of a day without a date{passed}; they count in seconds from the first midnight."
    return Clock(times, Decimal(0), remarks=(note,))


def _read_sums(path: Path, form: TableForm, clock: ClockColumns, rows: Rows) -> Clock:
    """Return times that are sums of columns, counted from the first of them, which is kept exactly."""
    scales = [IN_DECIMAL_SECONDS[unit] for unit in clock.units]
    times, begin = np.full(len(rows), np.nan), None
    for k, line, row in _stamped_rows(rows):
        try:
            total = sum((exact_number(text) * scale for text, scale in zip(row, scales, strict=True)), Decimal(0))
        except ValueError as error:
            raise _wrong(path, form, clock, line, f"{shown(', '.join(row))} {error}") from None
        begin = total if begin is None else begin
        times[k] = float(total - begin)
    return Clock(times, begin or Decimal(0))


def _read_instants(path: Path, form: TableForm, clock: ClockColumns, rows: Rows) -> Clock:
    kind = clock.units[0]
    system = _system(path, form, clock, next((row for _, _, row in _stamped_rows(rows)), ()))
    whole, rest = np.zeros(len(rows), dtype=np.int64), np.zeros(len(rows), dtype=np.int64)
    there = np.zeros(len(rows), dtype=bool)
    digits, largest = 0, Decimal(0)
    for k, line, row in _stamped_rows(rows):
        try:
            if kind == DATE:
                whole[k], rest[k] = _read_moment(row[0], system, clock.system is not None)
            else:
                numbers = [exact_number(text) for text in row]
                whole[k], rest[k] = _instant(kind, numbers, system)
                digits = max(digits, -min(int(number.as_tuple().exponent) for number in numbers))
                largest = max(largest, *map(abs, numbers))
        except ValueError as error:
            raise _wrong(path, form, clock, line, error) from None
        there[k] = True
    if not there.any():
        return Clock(np.full(len(rows), np.nan), Decimal(0))
    first = int(np.argmax(there))
    zero = int(whole[first]), int(rest[first])
    times = np.where(there, since(zero, whole, rest), np.nan)
    remarks = [f"its times count from its first stamp, {shortest(zero, system)} {system}."]
    resolution = 0.0
    if kind in FIRST_DAY:
        resolution, note = _resolve_days(digits, float(largest))
        remarks.append(note)
    if kind == "gps" and len(clock.columns) == 2 and _weeks(rows, first) < ROLLOVER:
        remarks.append(f"its weeks are below {ROLLOVER}; if the receiver counts them modulo {ROLLOVER}, its epoch is "
                       "too early by as many.")
    return Clock(times, Decimal(0), (shortest(zero, system), system), resolution, tuple(remarks))


def _read_moment(text: str, system: str, said: bool) -> tuple[int, int]:
    """Return the instant of a date.

    Args:
        text: the date.
        system: the time system of the column.
        said: whether the user gave it, and it is not that of the first date's zone.

    Raises:
        ValueError: with a message, for text that is not a date, and for a zone other than the column's.
    """
    date, zoned = read_date(text)
    if zoned and system != "UTC":
        raise ValueError(f"{shown(text)} is in UTC by its zone, and {system} was said")
    if not (zoned or said):
        raise ValueError(f"{shown(text)} has no zone, and the first date of the column has one; say `time_system` UTC "
                         "if both are in UTC")
    return read_epoch(date, system)


def _resolve_days(digits: int, largest: float) -> tuple[float, str]:
    """Return the resolution of times in days [s], and a note on it.

    Args:
        digits: decimals that the days are printed with.
        largest: of the days.

    A day that is printed with more digits than a double of its size resolves was computed as a double all the same.
    """
    printed, spacing = 0.5 * 86400 * 10.0**-digits, 86400 * float(np.spacing(largest))
    if printed >= 0.5 * spacing:
        return printed, f"its days have {digits} decimals, so that times are known to {printed:.2g} s."
    return 0.5 * spacing, (f"its days have {digits} decimals, and numbers of double precision, which programs count "
                           f"days in, are {spacing:.2g} s apart at that size, so that times are known to "
                           f"{0.5 * spacing:.2g} s.")  # fmt: skip


def _weeks(rows: Rows, first: int) -> Decimal:
    return exact_number(rows[first][1][0])


def _system(path: Path, form: TableForm, clock: ClockColumns, row: Sequence[str]) -> str:
    """Return the time system: that of the calendar, that of a date's zone, or the given one."""
    kind = clock.units[0]
    own = OWN_SYSTEM.get(kind)
    if kind == DATE and row:
        try:
            own = "UTC" if read_date(row[0])[1] else None
        except ValueError:
            own = None
    if own and clock.system and own != clock.system:
        raise InvalidInput(f"{path}: {name_column(form, clock.columns[0])} counts in {own}, and {clock.system} is "
                           "said. Leave `time_system` out.")
    system = own or clock.system
    if system is None:
        raise InvalidInput(f"{path}: the time system of {name_column(form, clock.columns[0])} is not known. Say it by "
                           "`time_system` UTC|TAI|TT|TDB|GPS.")
    return system


def _instant(kind: str, numbers: Sequence[Decimal], system: str) -> tuple[int, int]:
    """Return whole seconds and picoseconds from 1970-01-01 of the time system, leap seconds counted.

    Raises:
        ValueError: with a message, for UTC before 1972.
    """
    last_day = 2_932_897  # from 1970, with which the year 10000 begins
    if kind in FIRST_DAY:
        days = numbers[0] - FIRST_DAY[kind]
        day = int(days.to_integral_value(ROUND_FLOOR))
        length = 86401 if system == "UTC" and day + 1 in leap_seconds().after else 86400
        return _split(_midnight(day, system) + (days - day) * length)
    if kind == "gps":
        weeks, seconds = numbers if len(numbers) == 2 else (Decimal(0), numbers[0])
        return _split(GPS_ZERO + weeks * WEEK + seconds)
    scale = PER_UNIX[kind]
    seconds = numbers[0] / scale + (numbers[1] * IN_DECIMAL_SECONDS["ns"] if len(numbers) == 2 else 0)
    day = int((seconds / 86400).to_integral_value(ROUND_FLOOR))
    if not abs(day) < last_day:
        finer = f"; {list(PER_UNIX)[-1]} may be meant" if scale < 10**9 else ""
        raise ValueError(f"must be a time before the year 10000; got {numbers[0]} in {kind}{finer}")
    return _split(_midnight(day, system) + (seconds - 86400 * day))


def _midnight(day: int, system: str) -> int:
    date = np.datetime_as_string(np.datetime64(day, "D"))
    return read_epoch(f"{date}T00:00:00", system)[0]


def _split(seconds: Decimal) -> tuple[int, int]:
    picoseconds = int((seconds * PICO).to_integral_value())
    return divmod(picoseconds, PICO)


def words_of(clock: ClockColumns, form: TableForm) -> str:
    """Return how the times are read."""
    named = " and ".join(name_column(form, column) for column in clock.columns)
    if clock.units[0] in (DATE, TIME_OF_DAY):
        return f"{named}, {clock.units[0]}"
    if clock.units[0] == "gps" and len(clock.columns) == 2:
        return f"{named}, weeks and seconds of GPS"
    return f"{named}, in {' and '.join(clock.units)}"
