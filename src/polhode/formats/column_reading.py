"""Attitudes and angular velocities from the columns of any plain table, by a mapping of their meaning."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path

import numpy as np

from polhode import rotation
from polhode.errors import FormatError
from polhode.formats.attitude_columns import make_attitude
from polhode.formats.calendar_stamps import ClockColumns, read_calendar, words_of
from polhode.formats.column_mapping import ColumnMapping
from polhode.formats.column_meaning import Understood, agreement, find_direction, order_times
from polhode.formats.column_resolution import Resolved, resolve_mapping
from polhode.formats.header_words import IN_RADIANS
from polhode.formats.labels import AttitudeLabels, Recording, nameless
from polhode.formats.paths import as_path
from polhode.formats.plain_table import PlainTable, name_column, read_cells, table_form
from polhode.formats.rate_scale import read_scale
from polhode.formats.stamps import Clock, in_words, read_clock
from polhode.formats.table_form import DELIMITERS, TableForm
from polhode.motion._layout import ANGULAR_VELOCITY, ATTITUDE, StateLayout
from polhode.motion._outcome import Ending, Outcome
from polhode.motion._trajectory import Trajectory


def read_timed(
    path: Path, form: TableForm, time: ClockColumns, columns: Sequence[int], decimal: str,
    progress: Callable[[int], None] | None = None,
) -> tuple[PlainTable, Clock]:
    """Return the columns of a table with times [s] before them, NaN where there is none, and the clock.

    Raises:
        InvalidInput, FormatError: as reading the cells and the clock does.
    """
    if time.is_plain:
        table = read_cells(path, form, (time.columns[0], *columns), decimal, progress)
        return table, read_clock(path, form, time.columns[0], time.units[0], decimal, table.numbers[:, 0])
    table = read_cells(path, form, columns, decimal, progress)
    clock = read_calendar(path, form, time, decimal)
    return PlainTable(np.concatenate([clock.times[:, None], table.numbers], axis=1), table.lines), clock


def rate_of_one(mapping: ColumnMapping, resolved: Resolved) -> float:
    """Return the angular velocity [rad/s] of a 1 in the table."""
    return read_scale(mapping.scale) if mapping.scale else IN_RADIANS[resolved.rate_unit]


def read_columns(path: str | Path, mapping: ColumnMapping) -> Trajectory:
    """Return the motion in a table of another tool, along the axes that the file has it in.

    Delimiters (commas, semicolons, tabs, blanks) and the line of names are detected; lines that begin with # or % are
    comments. Lines without any value in the columns asked for are left out, and so is a line that only repeats
    the one before it. The source is a ``Recording`` whose ``attributes`` say how the file was understood.

    Args:
        path: of the table.
        mapping: the meaning of its columns.

    Returns:
        Attitude body → space (T, 4) and angular velocity (T, 3) [rad/s, body axes], each None if the mapping has none;
        times [s] as in the file, but of stamps with more digits than a double holds since the first stamp, which is
        ``counted_from`` of the attributes.

    Raises:
        InvalidInput: with a line for each word of the mapping that does not fit the file.
        FormatError: naming line and column, for a cell that is no number, values that are no rotation, and a time not
            later than that of the line before.

    >>> import tempfile
    >>> path = Path(tempfile.mkdtemp()) / "log.csv"
    >>> _ = path.write_text("time_ms;gx [deg/s];gy [deg/s];gz [deg/s]\\n0;0;0;180\\n10;0;0;90\\n")
    >>> trajectory = read_columns(path, ColumnMapping("time_ms", gyro="gx,gy,gz"))
    >>> trajectory.times.tolist(), trajectory.angular_velocity[:, 2].round(6).tolist()
    ([0.0, 0.01], [3.141593, 1.570796])
    """
    path = as_path("path", path)
    form = table_form(path)
    resolved = resolve_mapping(path, form, mapping)
    wanted = (*resolved.attitude, *resolved.gyro)
    decimal = mapping.decimal or "point"
    table, clock = read_timed(path, form, resolved.time, wanted, decimal)
    filled = _find_filled(path, form, (resolved.time.columns[0], *wanted), table)
    left_out, times = int(len(filled) - filled.sum()), clock.times[filled]
    table = PlainTable(table.numbers[filled], table.lines[filled])
    times, kept, spread = order_times(path, times, table)
    repeated = int(len(kept) - kept.sum())
    table = PlainTable(table.numbers[kept], table.lines[kept])
    end = 1 + len(resolved.attitude)
    velocity = table.numbers[:, end:] * rate_of_one(mapping, resolved) if resolved.gyro else None
    attitude, deviation, backward = None, None, mapping.is_backward
    if resolved.attitude:
        letters, unit = resolved.letters, resolved.angle_unit
        attitude, deviation = make_attitude(path, table, table.numbers[:, 1:end], mapping, letters, unit)
        if mapping.matrix and mapping.direction is None:
            backward = find_direction(path, times, attitude, velocity)
        attitude = rotation.conjugate(attitude) if backward else attitude
    understood = Understood(
        header=_header(form), delimiter=DELIMITERS[form.delimiter], time=words_of(resolved.time, form),
        attitude=_attitude_words(form, resolved, mapping, backward),
        angular_velocity=_gyro_words(form, resolved, mapping),
        samples=len(times), first=float(times[0]), last=float(times[-1]), left_out=left_out, repeated=repeated,
        spread=spread, largest_deviation=deviation, deviation_from="RᵀR" if mapping.matrix else "|q|",
        rates_apart=agreement(times, attitude, velocity),
        notes=(*resolved.notes, *clock.notes, *_spread_note(spread)),
        counted_from=in_words(clock.begin) if clock.begin else None, time_resolution=clock.resolution,
    )
    parts = [part for part, value in ((ATTITUDE, attitude), (ANGULAR_VELOCITY, velocity)) if value is not None][:1]
    states = velocity if attitude is None else attitude
    assert states is not None
    return Trajectory(
        times, states, StateLayout(tuple(parts)), attitude, None, velocity, outcome=Outcome(Ending.RECORDED),
        source=Recording(path.name, _labels(clock), understood._asdict()),
    )


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
                          "that are filled together.")
    if empty.all():
        raise FormatError(f"{path}: no line has values in the columns asked for. Choose other columns.")
    return ~empty


def _header(form: TableForm) -> str:
    return f"in line {form.named_in}" if form.named_in else "none; columns by number"


def _attitude_words(form: TableForm, resolved: Resolved, mapping: ColumnMapping, backward: bool) -> str | None:
    if not resolved.attitude:
        return None
    direction = "from space to body" if backward else "from body to space"
    names = [name_column(form, place) for place in resolved.attitude]
    if mapping.matrix:
        shown = mapping.direction is None
        entries = ", ".join(f"R{entry} = {name}" for entry, name in zip(resolved.letters.split(), names, strict=True))
        return f"matrix {entries}; {direction}{', as the angular velocity shows' if shown else ''}"
    if mapping.mrp or (mapping.quat and len(names) == 3):
        vector = "vector part of a quaternion, the scalar by continuity,"
        what = "modified Rodrigues parameters" if mapping.mrp else vector
        parts = ", ".join(f"{axis} = {name}" for axis, name in zip("xyz", names, strict=True))
        return f"{what} {parts}; {direction}"
    if mapping.quat:
        parts = ", ".join(f"{letter} = {name}" for letter, name in zip(resolved.letters, names, strict=True))
        return f"quaternion {parts}; {direction}"
    assert mapping.sequence is not None
    axes = "the body's own axes" if mapping.sequence.isupper() else "the axes of space"
    turns = ", then ".join(f"{letter} by {name}" for letter, name in zip(mapping.sequence, names, strict=True))
    return f"turns about {axes}, {turns}, in {resolved.angle_unit}; {direction}"


def _gyro_words(form: TableForm, resolved: Resolved, mapping: ColumnMapping) -> str | None:
    if not resolved.gyro:
        return None
    parts = ", ".join(f"{axis} = {name_column(form, place)}" for axis, place in zip("xyz", resolved.gyro, strict=True))
    return f"{parts}, body axes, {f'counts at {mapping.scale}' if mapping.scale else f'in {resolved.rate_unit}'}"


def _spread_note(spread: int) -> tuple[str, ...]:
    if not spread:
        return ()
    note = (f"its clock is rounded: {spread} lines come at a time that was there already, with other values; they are "
            "taken at equal steps.")
    return (note,)


def _labels(clock: Clock) -> AttitudeLabels | None:
    """Return labels with the epoch of the stamps, and no names, as a table has none; None without an epoch."""
    if clock.epoch is None:
        return None
    epoch, system = clock.epoch
    return nameless(epoch, system)
