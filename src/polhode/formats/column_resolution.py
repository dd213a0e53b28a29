"""Applies a mapping to a table: the quantity, unit and order of its columns, by the mapping and the header."""

from __future__ import annotations

import difflib
from collections.abc import Callable
from pathlib import Path
from typing import NamedTuple

from polhode.errors import InvalidInput, shown
from polhode.formats.calendar_stamps import ClockColumns, first_odd_cell, kind_of_cells
from polhode.formats.column_mapping import ORDERS, ColumnMapping
from polhode.formats.header_words import (
    ANGLE_UNITS,
    CALENDARS,
    ENTRIES,
    RATE_UNITS,
    TIME_UNITS,
    bare_name,
    components_in,
    entries_in,
    explain_vector_names,
    unit_in,
)
from polhode.formats.plain_table import name_column
from polhode.formats.table_form import TableForm

COLUMNS_SHOWN = 12  # in a message
COUNTS_TOO = ", or of raw counts by `scale`, like \"131 LSB/(deg/s)\""
CALENDARS_TOO = f", or, of times that count from a day of a calendar, {'|'.join(CALENDARS)}"


class Resolved(NamedTuple):
    """A mapping applied to a file: columns counted from 0, with units and orders that the header gives."""

    time: ClockColumns
    attitude: tuple[int, ...]
    letters: str
    angle_unit: str
    gyro: tuple[int, ...]
    rate_unit: str
    notes: tuple[str, ...]


def resolve_mapping(path: Path, form: TableForm, mapping: ColumnMapping) -> Resolved:
    """Apply a mapping to a file.

    Raises:
        InvalidInput: with a line for each column that is not there, and each unit and order that neither gives.
    """
    problems: list[str] = []
    time = _time_columns(form, mapping.time)
    places = {name: _places(form, columns, problems)
              for name, columns in (("time", time), ("attitude", mapping.attitude), ("gyro", mapping.gyro))}
    used = [place for group in places.values() for place in group if place is not None]
    for place in sorted({place for place in used if used.count(place) > 1}):
        problems.append(f"{name_column(form, place)} is given twice. Every column has one meaning.")
    groups = {name: tuple(place for place in group if place is not None) for name, group in places.items()}
    notes: list[str] = []

    def unit(what: str, group: str, said: str | None, units: dict[str, tuple[str, ...]], name: str) -> str:
        if not groups[group] and said is None:
            return ""
        names = [form.names[place] for place in groups[group]] if form.names else []
        header_units = {unit_in(name, units) for name in names} - {None}
        in_header = " and ".join(sorted(map(str, header_units)))
        if said is not None:
            if header_units - {said}:
                notes.append(f"the header names {in_header} for {what}; it is read in {said}, as said.")
            return said
        if len(header_units) == 1:
            return in_header
        why = f"the header names {in_header}" if header_units else "the file does not say it"
        more = {"gyro": COUNTS_TOO, "time": CALENDARS_TOO}.get(group, "")
        problems.append(f"the unit of {what} is not known: {why}. Say it by `{name}` {'|'.join(units)}{more}.")
        return ""

    time_units = _find_time_units(path, form, mapping, groups["time"], unit, problems)
    angle_unit = rate_unit = letters = ""
    if mapping.euler:
        angle_unit = unit("the angles", "attitude", mapping.angle_unit, ANGLE_UNITS, "unit")
    if mapping.gyro and not mapping.scale:
        rate_unit = unit("the angular velocity", "gyro", mapping.rate_unit, RATE_UNITS, "unit")
    names = [form.names[place] for place in groups["attitude"]] if form.names else []
    if mapping.quat and len(groups["attitude"]) == 4:
        letters = _letters(names, mapping.order, problems)
    if mapping.quat and len(groups["attitude"]) == 3 and (why := explain_vector_names(names, form.names)):
        problems.append(f"the quaternion has three columns, {', '.join(names)}, which are its vector part x, y, z, and "
                        f"{why}. Give four, w, x, y, z, or the vector part alone.")
    if mapping.matrix and len(groups["attitude"]) == 9:
        letters = entries_in(names) or ENTRIES
    if mapping.decimal == "comma" and form.delimiter == ",":
        problems.append("decimal commas cannot be distinguished from commas between columns. Save it with semicolons.")
    if problems:
        raise InvalidInput(*(f"{path}: {problem}" for problem in problems))
    clock = ClockColumns(groups["time"], time_units, mapping.time_system)
    return Resolved(clock, groups["attitude"], letters, angle_unit, groups["gyro"], rate_unit,
                    tuple(notes))


def _time_columns(form: TableForm, time: object) -> tuple[str | int, ...]:
    """Return the columns of times; a text with a comma is two of them, unless a column has it as its name."""
    if isinstance(time, list | tuple):
        return tuple(time)
    assert isinstance(time, str | int)
    if isinstance(time, str) and "," in time and time not in form.names:
        first, _, second = time.partition(",")
        return first.strip(), second.strip()
    return (time,)


def _find_time_units(
    path: Path, form: TableForm, mapping: ColumnMapping, places: tuple[int, ...], unit: Callable[..., str],
    problems: list[str],
) -> tuple[str, ...]:
    """Return the unit of each column of times, or the kind of calendar that they are of."""
    said = None if mapping.time_unit is None else tuple(map(str, mapping.time_unit))
    if len(places) == 1 and (said is None or len(said) == 1):
        calendar = kind_of_cells(path, form, places[0]) if said is None else None
        named = form.names[places[0]].strip().lower() if form.names else ""
        if calendar is None and said is None and bare_name(named) in ("mjd", "jd"):
            calendar = bare_name(named)
        if calendar is None and said is None and (odd := first_odd_cell(path, form, places[0])):
            problems.append(f"{name_column(form, places[0])} begins with {shown(odd)}, which is neither a number nor a "
                            "date or time of day. Write dates like 2026-03-01T12:00:00.")
            return ("",)
        if calendar:
            return (calendar,)
        return (unit("the time", "time", said[0] if said else None, TIME_UNITS, "time_unit"),)
    if len(places) == 2 and said in (("gps",), ("unix",)):
        return said * 2
    if len(places) == 2 and (said is None or len(said) != 2):
        problems.append("two columns of times need a unit each, like `time_unit` s,ns, or gps for weeks and seconds.")
    if len(places) == 1 and said is not None:
        problems.append(f"`time_unit` has {len(said)} units, and one column has the times. Give one, or name both "
                        "columns by `time`.")
    return said or ("",)


def _letters(names: list[str], order: str | None, problems: list[str]) -> str:
    """Return which of w, x, y and z each column of a quaternion is."""
    letters = components_in(names)
    if order is None and letters is None:
        problems.append("the order of the quaternion is not known: its columns are not named by w, x, y and z. Say it "
                        f"by `order` {'|'.join(ORDERS)}.")
    if order and letters and order != letters:
        problems.append(f"order is {order}, and the columns are named in the order {letters}. Correct one of them.")
    return order or letters or ""


def _places(form: TableForm, columns: object, problems: list[str]) -> list[int | None]:
    """Return the columns' indices, from 0; None for a name that no column or several have."""
    assert isinstance(columns, tuple | None)
    return [_place(form, column, problems) for column in columns or ()]


def _place(form: TableForm, column: str | int, problems: list[str]) -> int | None:
    if isinstance(column, str):
        for called in (lambda name: name, bare_name):
            places = [place for place, name in enumerate(form.names) if called(name) == column]
            if len(places) == 1:
                return places[0]
            if places:
                numbers = " and ".join(str(place + 1) for place in places)
                problems.append(f"{shown(column)} is the name of columns {numbers}. Give the number instead.")
                return None
        if not (column.isascii() and column.isdigit()):
            problems.append(f"has no column {shown(column)}. {_there_are(form, column)}")
            return None
    number = int(column) if len(str(column)) < 9 else 10**9
    if not 1 <= number <= form.width:
        problems.append(f"has no column {shown(number)}, as its columns are 1 to {form.width}.")
        return None
    return number - 1


def _there_are(form: TableForm, column: str) -> str:
    if not form.names:
        return f"No line names its columns; give a number from 1 to {form.width}."
    near = difflib.get_close_matches(column.lower(), {name.lower() for name in form.names if name}, 1)
    hint = f"Did you mean {shown(next(name for name in form.names if name.lower() == near[0]))}? " if near else ""
    listed = ", ".join(map(shown, form.names[:COLUMNS_SHOWN]))
    more = f" and {len(form.names) - COLUMNS_SHOWN} more" if len(form.names) > COLUMNS_SHOWN else ""
    return f"{hint}Its columns are {listed}{more}."
