"""Logs of gyroscopes and accelerometers from the files of phones and flight controllers, or from any table."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from decimal import Decimal
from pathlib import Path, PurePosixPath
from typing import NamedTuple

from polhode.errors import FormatError, InvalidInput, PolhodeError
from polhode.formats.column_mapping import ColumnMapping
from polhode.formats.column_reading import rate_of_one, read_timed
from polhode.formats.column_resolution import COLUMNS_SHOWN, resolve_mapping
from polhode.formats.header_words import RATE_UNITS, TIME_UNITS, unit_in
from polhode.formats.opening import check_is_file, is_folder
from polhode.formats.paths import as_path
from polhode.formats.plain_table import LARGEST_FILE, detect_decimal, first_lines, read_cells
from polhode.formats.stamps import read_clock
from polhode.formats.table_form import DELIMITERS, Line, TableForm, detect_form, split_cells
from polhode.measuring.throws.gyro_dialects import (
    DIALECTS,
    GYRO_FILES,
    GyroDialect,
    acceleration_unit,
    detect_dialect,
    find_places,
    time_place,
)
from polhode.measuring.throws.gyro_log import GyroLog, clean_log
from polhode.measuring.throws.log_archives import is_archive, unpack_log
from polhode.types import Array

Progress = Callable[[int], None] | None
"""Called with the number of lines read, now and then."""
EXAMPLE = '`columns={"time": "t", "time_unit": "s", "gyro": "gx,gy,gz", "unit": "deg/s"}` of `polhode.fit`'


class ReadLog(NamedTuple):
    """A log, and how its file was understood.

    Attributes:
        log: samples in the order of time.
        dialect: name of the program that wrote it; "a mapping" where the columns were given.
        rate_unit: of the file.
        acceleration_from: the file with the accelerations; None without them.
        notes: caveats.
    """

    log: GyroLog
    dialect: str
    rate_unit: str
    acceleration_from: str | None
    notes: tuple[str, ...]


def read_gyro_log(
    path: str | Path, mapping: ColumnMapping | None = None, progress: Progress = None, rate_unit: str | None = None
) -> ReadLog:
    """Return a gyro log from a table, a folder with one, or a zip archive with one; the notes say which file was read.

    The header identifies the program that wrote it: phyphox, Sensor Logger, AndroSensor, Betaflight. Lines before the
    header are skipped, decimal commas are noticed, lines need not be in the order of time, and lines without values
    are dropped samples. An accelerometer with its own clock readings is read from its own file in the same folder.

    Args:
        path: of the table, the folder or the archive.
        mapping: the meaning of the columns, for tables of other programs.
        progress: called with the number of lines read, now and then.
        rate_unit: "deg/s", "rad/s" or "rpm" of a known app's table that says it wrongly; where there is no mapping.

    Raises:
        InvalidInput: for what is missing, is not a file, or has no usable samples.
        FormatError: naming file and line, for what is not a log.

    >>> import tempfile
    >>> path = Path(tempfile.mkdtemp()) / "Gyroscope.csv"
    >>> rows = "".join(f"{k},{k / 100},3,2,{k}\\n" for k in range(9))
    >>> _ = path.write_text("time,seconds_elapsed,z,y,x\\n" + rows)
    >>> read = read_gyro_log(path)
    >>> read.dialect, read.log.rates[-1].tolist()
    ('Sensor Logger', [8.0, 2.0, 3.0])
    """
    path = as_path("path", path)
    if is_folder(path):
        return _read_table(_gyro_file(path), mapping, progress, rate_unit)
    check_is_file(path, "log", LARGEST_FILE)
    if not is_archive(path):
        return _read_table(path, mapping, progress, rate_unit)
    beside = [name for dialect in DIALECTS for name in dialect.beside]
    with unpack_log(path, GYRO_FILES, beside) as (table, member):
        try:
            read = _read_table(table, mapping, progress, rate_unit)
        except PolhodeError as error:
            inside = str(PurePosixPath(member).parent).removeprefix(".")
            place = "/".join(filter(None, (str(path), inside)))
            raise type(error)(*(str(line).replace(str(table.parent), place) for line in error.args)) from None
    return read._replace(notes=(f"{member} in the archive is read.", *read.notes))


def _gyro_file(folder: Path) -> Path:
    paths = [folder / name for name in GYRO_FILES if (folder / name).is_file()]
    if not paths:
        raise InvalidInput(f"{folder}: has no {' or '.join(GYRO_FILES)}. Name the file with the angular velocities.")
    return paths[0]


def _read_table(path: Path, mapping: ColumnMapping | None, progress: Progress, rate_unit: str | None) -> ReadLog:
    form, dialect = _form(path, mapping)
    notes: list[str] = []
    if mapping is None:
        assert dialect is not None
        mapping = _make_mapping(form, dialect, rate_unit)
    if not mapping.gyro:
        raise InvalidInput(f"{path}: its angular velocities are needed. Say their columns by `gyro`.")
    resolved = resolve_mapping(path, form, mapping)
    decimal = mapping.decimal or detect_decimal(path, form)
    felt = _acceleration(form, dialect, notes) if dialect else None
    table, clock_of_rates = read_timed(
        path, form, resolved.time, (*resolved.gyro, *(felt[0] if felt else ())), decimal, progress
    )
    numbers, times = table.numbers, clock_of_rates.times
    rates = numbers[:, 1:4] * rate_of_one(mapping, resolved)
    acceleration, clock, source = (numbers[:, 4:] * felt[1], times, path.name) if felt else (None, None, None)
    del table, numbers  # of long logs these are the most memory
    if not felt and dialect:
        clock, acceleration, source = _beside(path, dialect, clock_of_rates.begin, progress)
    try:
        log = clean_log(times, rates, clock, acceleration)
    except InvalidInput as error:
        raise InvalidInput(f"{path}: {error}") from None
    notes += [*resolved.notes, *clock_of_rates.notes, *_remarks(log)]
    unit = mapping.scale or resolved.rate_unit
    return ReadLog(log, dialect.name if dialect else "a mapping", unit, source, tuple(notes))


def _form(path: Path, mapping: ColumnMapping | None) -> tuple[TableForm, GyroDialect | None]:
    """Return the table's layout, from the first line with known names on, if there is one."""
    lines = first_lines(path)
    if mapping is not None:
        return detect_form(path, lines), None
    for k, line in enumerate(lines):
        for delimiter in DELIMITERS:
            try:
                dialect = detect_dialect(split_cells(line.text, delimiter))
            except ValueError:
                dialect = None
            if dialect is not None:
                return detect_form(path, _below(path, lines[k:])), dialect
    form = detect_form(path, lines)
    more = ", …" if len(form.names) > COLUMNS_SHOWN else ""
    names = ", ".join(name or "(no name)" for name in form.names[:COLUMNS_SHOWN]) + more
    columns = f"has the columns {names}" if form.names else f"has {form.width} columns without names"
    known = ", ".join(dict.fromkeys(dialect.name.split(",")[0] for dialect in DIALECTS))
    raise FormatError(f"{path}: {columns}, which are not a gyro log of {known}. Say what they are, like {EXAMPLE}.")


def _below(path: Path, lines: Sequence[Line]) -> Sequence[Line]:
    """Return a header and the lines below it, of which one at least must have something."""
    if not any(line.text.strip(" \t;,") for line in lines[1:]):
        raise FormatError(f"{path}, line {lines[0].number}: no sample follows the header. Log again.")
    return lines


def _make_mapping(form: TableForm, dialect: GyroDialect, rate_unit: str | None) -> ColumnMapping:
    time, gyro = time_place(form.names, dialect), find_places(form.names, dialect.gyro)
    assert time is not None and gyro is not None
    named = unit_in(form.names[time], TIME_UNITS), unit_in(form.names[gyro[0]], RATE_UNITS)
    return ColumnMapping(
        time + 1, time_unit=None if named[0] else dialect.time_unit, gyro=tuple(place + 1 for place in gyro),
        unit=rate_unit or (None if named[1] else dialect.rate_unit),
    )


def _acceleration(form: TableForm, dialect: GyroDialect, notes: list[str]) -> tuple[tuple[int, ...], float] | None:
    """Return the columns of accelerations in the gyro's own table, and their unit in m/s²; None without them."""
    candidates = (find_places(form.names, names) for names in dialect.acceleration if names != dialect.gyro)
    places = next(filter(None, candidates), None)
    if places is None:
        return None
    unit = acceleration_unit(form.names[places[0]], dialect)
    if unit is None:
        notes.append("accelerations are left out, as their unit is not known; have Betaflight's blackbox_decode write "
                     "them by its option --unit-acceleration m/s2.")
        return None
    return places, unit


def _beside(
    path: Path, dialect: GyroDialect, begin: Decimal, progress: Progress
) -> tuple[Array | None, Array | None, str | None]:
    """Return times [s] and accelerations [m/s²] from the file next to the gyro's, None without one, and its name.

    Times count from ``begin`` [s], as those of the gyro's file do.
    """
    for name in dialect.beside:
        other = path.with_name(name)
        if other == path or not other.is_file():
            continue
        form = detect_form(other, first_lines(other))
        time = time_place(form.names, dialect)
        places = next(filter(None, (find_places(form.names, names) for names in dialect.acceleration)), None)
        unit = acceleration_unit(form.names[places[0]], dialect) if places else None
        if time is None or places is None or unit is None:
            continue
        decimal = detect_decimal(other, form)
        numbers = read_cells(other, form, (time, *places), decimal, progress).numbers
        time_unit = unit_in(form.names[time], TIME_UNITS) or dialect.time_unit
        clock = read_clock(other, form, time, time_unit, decimal, numbers[:, 0], begin)
        return clock.times, numbers[:, 1:] * unit, name
    return None, None, None


def _remarks(log: GyroLog) -> list[str]:
    remarks = []
    if log.reordered:
        remarks.append("lines are not in the order of time; they were sorted.")
    if log.repeats:
        remarks.append(f"{log.repeats} samples come at a time that was there already; the first of each is kept.")
    if log.spread:
        remarks.append(f"the clock is rounded: {log.spread} samples come at a time that was there already, with other "
                     "values; they are taken at equal steps.")
    if log.dropped:
        remarks.append(f"{log.dropped} lines without finite values are left out." if log.dropped > 1
                       else "1 line without finite values is left out.")
    return remarks
