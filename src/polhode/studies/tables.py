"""How a table of another tool is to be read, and how it was understood."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any, NamedTuple

from polhode.errors import InvalidInput, shown
from polhode.formats.column_mapping import ColumnMapping, make_mapping
from polhode.formats.labels import Recording
from polhode.motion._trajectory import Trajectory
from polhode.reports.answer import Answer, Group

EXAMPLE = ('`columns={"time": "t", "time_unit": "s", "quat": "qw,qx,qy,qz", "order": "wxyz", "gyro": "gx,gy,gz", '
           '"unit": "deg/s"}`')


class ReadingLimits(NamedTuple):
    """A number that decides whether rates contradict the attitudes."""

    max_rate_residual: float = 0.5  # relative; more is of another direction, order or unit


LIMITS = ReadingLimits()


class TableMapping(NamedTuple):
    """A mapping, and whether it is for this file alone; one for both leaves tables of polhode's as they are."""

    mapping: ColumnMapping
    only: bool


def take_columns(columns: Mapping[str, Any] | None, only: bool) -> TableMapping | None:
    """Return the mapping in the argument `columns` of a function; None where it is left out.

    Raises:
        InvalidInput: for anything but words by name, and for words that are not those of a mapping.
    """
    if columns is None:
        return None
    if not isinstance(columns, Mapping):
        raise InvalidInput(f'`columns` must be words by name, like {{"time": "t"}}; got {shown(columns)}.')
    return TableMapping(make_mapping(columns), only)


def needs_mapping(path: Path) -> InvalidInput:
    """Return the error for a table without a mapping; it lists the columns."""
    from polhode.formats.column_resolution import COLUMNS_SHOWN
    from polhode.formats.plain_table import table_form

    form = table_form(path)
    more = ", …" if len(form.names) > COLUMNS_SHOWN else ""
    names = ", ".join(name or "(no name)" for name in form.names[:COLUMNS_SHOWN]) + more
    columns = f"with the columns {names}" if form.names else f"of {form.width} columns without names"
    return InvalidInput(f"{path}: is a table {columns}. Say what they are, like {EXAMPLE}.")


def describe_reading(trajectory: Trajectory, title: str, level: str) -> Group:
    """Return how a table was understood.

    Args:
        trajectory: as ``read_columns`` gives it.
        title: of the group.
        level: of the answers' names, "" for none.
    """
    assert isinstance(trajectory.source, Recording)
    reading = trajectory.source.attributes
    prefix = f"{level}." if level else ""
    off, apart = reading["largest_deviation"], reading["rates_apart"]
    span = f"{reading['first']:.9g} to {reading['last']:.9g} s"
    return Group(title, [
        Answer(f"{prefix}header", reading["header"], "", "header"),
        Answer(f"{prefix}delimiter", reading["delimiter"], "", "between columns"),
        Answer(f"{prefix}time", reading["time"], "", "time"),
        Answer(f"{prefix}attitude", reading["attitude"], "", "attitude"),
        Answer(f"{prefix}angular_velocity", reading["angular_velocity"], "", "angular velocity"),
        Answer(f"{prefix}samples", reading["samples"], "", "samples", "", f"{reading['samples']}, {span}"),
        Answer(f"{prefix}counted_from", reading["counted_from"], "", "times count from", "",
               None if reading["counted_from"] is None else f"{reading['counted_from']} s of its clock"),
        Answer(f"{prefix}left_out", reading["left_out"], "", "lines without values" if reading["left_out"] else "", "",
               f"{reading['left_out']}, left out"),
        Answer(f"{prefix}repeated", reading["repeated"], "", "lines that repeat" if reading["repeated"] else "", "",
               f"{reading['repeated']}, left out"),
        Answer(f"{prefix}spread", reading["spread"]),
        Answer(f"{prefix}largest_deviation", off, "", f"largest deviation of {reading['deviation_from']} from 1", "",
               None if off is None else f"{off:.2g}, normalised"),
        Answer(f"{prefix}rates_apart", apart, "", "rates differ from the attitude's by", "relative, rms",
               None if apart is None else f"{100.0 * apart:.3g} %"),
    ])


def list_reading_notes(trajectory: Trajectory, name: str) -> list[str]:
    """Return caveats about how a table was understood."""
    assert isinstance(trajectory.source, Recording)
    reading = trajectory.source.attributes
    notes = [f"{name}: {note}" for note in reading["notes"]]
    if (reading["rates_apart"] or 0.0) > LIMITS.max_rate_residual:
        notes.append(f"{name}: the attitude does not follow the angular velocity. Check direction, order, "
                     "sequence and units.")
    return notes
