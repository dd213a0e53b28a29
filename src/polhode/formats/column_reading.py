"""Attitudes and angular velocities from the columns of any plain table, by a mapping of their meaning."""

from __future__ import annotations

import difflib
from pathlib import Path
from typing import NamedTuple

import numpy as np

from polhode.errors import FormatError, InvalidInput, shown
from polhode.formats.column_mapping import ORDERS, ColumnMapping
from polhode.formats.column_meaning import Understood, agreement, keep_rising, make_attitude
from polhode.formats.header_words import (
    ANGLE_UNITS,
    IN_RADIANS,
    RATE_UNITS,
    TIME_UNITS,
    bare_name,
    components_in,
    unit_in,
)  # fmt: skip
from polhode.formats.labels import Recording
from polhode.formats.plain_table import PlainTable, name_column, read_cells, table_form
from polhode.formats.stamps import in_words, read_clock
from polhode.formats.table_form import DELIMITERS, TableForm
from polhode.motion._layout import ANGULAR_VELOCITY, ATTITUDE, StateLayout
from polhode.motion._outcome import Ending, Outcome
from polhode.motion._trajectory import Trajectory

COLUMNS_SHOWN = 12  # in a message


class Resolved(NamedTuple):
    """A mapping applied to a file: columns counted from 0, with units and orders that the header gives."""

    time: int
    time_unit: str
    attitude: tuple[int, ...]
    letters: str
    angle_unit: str
    gyro: tuple[int, ...]
    rate_unit: str
    notes: tuple[str, ...]


def read_columns(path: str | Path, mapping: ColumnMapping) -> Trajectory:
    """Return the motion in a table of another tool, along the axes that the file has it in.

    Delimiters (commas, semicolons, tabs, blanks) and the line of names are found by themselves; lines that begin with #
    or % are comments. Lines without any value in the columns asked for are left out, and so is a line that only repeats
    the one before it. The source is a ``Recording`` whose ``attributes`` say how the file was understood.

    Args:
        path: of the table.
        mapping: the meaning of its columns.

    Returns:
        Attitude body → space (T, 4) and angular velocity (T, 3) [rad/s, body axes], each None if the mapping has none;
        times [s] as they stand in the file, in its unit, but of stamps with more digits than a double holds from the
        first stamp on, which ``counted_from`` of the attributes tells.

    Raises:
        InvalidInput: with a line for each thing of the mapping that does not fit the file.
        FormatError: naming line and column, for what is not a number, not a rotation, or not later than the line
            before.

    >>> import tempfile
    >>> path = Path(tempfile.mkdtemp()) / "log.csv"
    >>> _ = path.write_text("time_ms;gx [deg/s];gy [deg/s];gz [deg/s]\\n0;0;0;180\\n10;0;0;90\\n")
    >>> trajectory = read_columns(path, ColumnMapping("time_ms", gyro="gx,gy,gz"))
    >>> trajectory.times.tolist(), trajectory.angular_velocity[:, 2].round(6).tolist()
    ([0.0, 0.01], [3.141593, 1.570796])
    """
    path = Path(path)
    form = table_form(path)
    resolved = resolve_mapping(path, form, mapping)
    wanted = (resolved.time, *resolved.attitude, *resolved.gyro)
    decimal = mapping.decimal or "point"
    table = read_cells(path, form, wanted, decimal)
    clock = read_clock(path, form, resolved.time, resolved.time_unit, decimal, table.numbers[:, 0])
    filled = _find_filled(path, form, wanted, table)
    left_out, times = int(len(filled) - filled.sum()), clock.times[filled]
    table = PlainTable(table.numbers[filled], table.lines[filled])
    kept = keep_rising(path, times, table)
    repeated = int(len(kept) - kept.sum())
    times, table = times[kept], PlainTable(table.numbers[kept], table.lines[kept])
    end = 1 + len(resolved.attitude)
    attitude, deviation = None, None
    if resolved.attitude:
        letters, unit = resolved.letters, resolved.angle_unit
        attitude, deviation = make_attitude(path, table, table.numbers[:, 1:end], mapping, letters, unit)
    velocity = table.numbers[:, end:] * IN_RADIANS[resolved.rate_unit] if resolved.gyro else None
    understood = Understood(
        header=_header(form), delimiter=DELIMITERS[form.delimiter], time=_time_words(form, resolved),
        attitude=_attitude_words(form, resolved, mapping), angular_velocity=_gyro_words(form, resolved),
        samples=len(times), first=float(times[0]), last=float(times[-1]), left_out=left_out, repeated=repeated,
        largest_deviation=deviation, rates_apart=agreement(times, attitude, velocity),
        notes=(*resolved.notes, *filter(None, (clock.note,))),
        counted_from=in_words(clock.begin) if clock.begin else None,
    )  # fmt: skip
    parts = [part for part, value in ((ATTITUDE, attitude), (ANGULAR_VELOCITY, velocity)) if value is not None][:1]
    states = velocity if attitude is None else attitude
    assert states is not None
    return Trajectory(
        times, states, StateLayout(tuple(parts)), attitude, None, velocity, outcome=Outcome(Ending.RECORDED),
        source=Recording(path.name, None, understood._asdict()),
    )  # fmt: skip


def resolve_mapping(path: Path, form: TableForm, mapping: ColumnMapping) -> Resolved:
    """Apply a mapping to a file.

    Raises:
        InvalidInput: with a line for each column that is not there, and each unit and order that neither gives.
    """
    problems: list[str] = []
    places = {name: _places(form, columns, problems)
              for name, columns in (("time", (mapping.time,)), ("attitude", mapping.attitude), ("gyro", mapping.gyro))}
    used = [place for group in places.values() for place in group if place is not None]
    for place in sorted({place for place in used if used.count(place) > 1}):
        problems.append(f"{name_column(form, place)} is given twice. Every column has one meaning.")
    groups = {name: tuple(place for place in group if place is not None) for name, group in places.items()}
    notes: list[str] = []

    def unit(what: str, group: str, said: str | None, units: dict[str, tuple[str, ...]], option: str) -> str:
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
        problems.append(f"the unit of {what} is not known: {why}. Say it by {option} {'|'.join(units)}.")
        return ""

    time_unit = unit("the time", "time", mapping.time_unit, TIME_UNITS, "--time-unit")
    angle_unit = rate_unit = letters = ""
    if mapping.euler:
        angle_unit = unit("the angles", "attitude", mapping.angle_unit, ANGLE_UNITS, "--unit")
    if mapping.gyro:
        rate_unit = unit("the angular velocity", "gyro", mapping.rate_unit, RATE_UNITS, "--unit")
    if mapping.quat and len(groups["attitude"]) == 4:
        names = [form.names[place] for place in groups["attitude"]] if form.names else []
        letters = _letters(names, mapping.order, problems)
    if mapping.decimal == "comma" and form.delimiter == ",":
        problems.append("decimal commas cannot be distinguished from commas between columns. Save it with semicolons.")
    if problems:
        raise InvalidInput(*(f"{path}: {problem}" for problem in problems))
    return Resolved(groups["time"][0], time_unit, groups["attitude"], letters, angle_unit, groups["gyro"], rate_unit,
                     tuple(notes))  # fmt: skip


def _letters(names: list[str], order: str | None, problems: list[str]) -> str:
    """Return which of w, x, y and z each column of a quaternion is."""
    letters = components_in(names)
    if order is None and letters is None:
        problems.append("the order of the quaternion is not known: its columns are not named by w, x, y and z. Say it "
                        f"by --order {'|'.join(ORDERS)}.")  # fmt: skip
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


def _find_filled(path: Path, form: TableForm, columns: tuple[int, ...], table: PlainTable) -> np.ndarray:
    """Return which rows (n,) have values; the others have none.

    Raises:
        FormatError: for a row that has some of them.
    """
    missing = np.isnan(table.numbers)
    empty = np.all(missing[:, 1:], axis=1)
    partly = missing.any(axis=1) & ~empty
    if partly.any():
        row = int(np.argmax(partly))
        where = f"{path}, line {table.lines[row]}, {name_column(form, columns[int(np.argmax(missing[row]))])}"
        raise FormatError(f"{where}: has no value, and others of the line have. Delete the line, or map only columns "
                          "that are filled together.")  # fmt: skip
    if empty.all():
        raise FormatError(f"{path}: no line has values in the columns asked for. Choose other columns.")
    return ~empty


def _header(form: TableForm) -> str:
    return f"in line {form.named_in}" if form.named_in else "none; columns by number"


def _time_words(form: TableForm, resolved: Resolved) -> str:
    return f"{name_column(form, resolved.time)}, in {resolved.time_unit}"


def _attitude_words(form: TableForm, resolved: Resolved, mapping: ColumnMapping) -> str | None:
    if not resolved.attitude:
        return None
    direction = "from space to body" if mapping.is_backward else "from body to space"
    names = [name_column(form, place) for place in resolved.attitude]
    if mapping.quat:
        parts = ", ".join(f"{letter} = {name}" for letter, name in zip(resolved.letters, names, strict=True))
        return f"quaternion {parts}; {direction}"
    assert mapping.sequence is not None
    axes = "the body's own axes" if mapping.sequence.isupper() else "the axes of space"
    turns = ", then ".join(f"{letter} by {name}" for letter, name in zip(mapping.sequence, names, strict=True))
    return f"turns about {axes}, {turns}, in {resolved.angle_unit}; {direction}"


def _gyro_words(form: TableForm, resolved: Resolved) -> str | None:
    if not resolved.gyro:
        return None
    parts = ", ".join(f"{axis} = {name_column(form, place)}" for axis, place in zip("xyz", resolved.gyro, strict=True))
    return f"{parts}, body axes, in {resolved.rate_unit}"
