"""Options that say what the columns of another tool's table are, and how such a table was understood."""

from __future__ import annotations

from pathlib import Path
from typing import Any, NamedTuple

from polhode.errors import FormatError, InvalidInput
from polhode.formats.column_mapping import ColumnMapping, mapping_of_words
from polhode.formats.labels import Recording
from polhode.motion.trajectory import Trajectory
from polhode.reports.answer import Answer, Group
from polhode.spec.parsing import read_tables

SIDES = ("a", "b")
APART = 0.5  # relative; rates that far from how the attitude turns are of another direction, order or unit
EXAMPLE = "--time t --time-unit s --quat qw,qx,qy,qz --order wxyz --gyro gx,gy,gz --unit deg/s"


class Table(NamedTuple):
    """A mapping, and whether it is for this file alone; one for both leaves tables of polhode's as they are."""

    mapping: ColumnMapping
    only: bool


class ColumnOptions(NamedTuple):
    """The options as they are given, each None where it is not."""

    mapping: Path | None = None
    time: str | None = None
    time_unit: str | None = None
    quat: str | None = None
    order: str | None = None
    direction: str | None = None
    euler: str | None = None
    sequence: str | None = None
    gyro: str | None = None
    unit: str | None = None
    decimal: str | None = None

    @property
    def words(self) -> dict[str, Any]:
        """Those that are given, without the mapping file."""
        return {name: value for name, value in self._asdict().items() if value is not None and name != "mapping"}


def table_to_import(options: ColumnOptions) -> Table | None:
    """Return the mapping of the file to import; None where nothing is said.

    Raises:
        InvalidInput: for words that are wrong, and for options beside a mapping file.
    """
    words = _all_words(options)
    if words is None:
        return None
    if sides := [side for side in SIDES if side in words]:
        why = f"has a table [{sides[0]}], which is for `polhode compare`"
        raise InvalidInput(f"{options.mapping}: {why}. Leave it out.")
    return Table(_mapping(words, _place(options)), True)


def tables_to_compare(options: ColumnOptions) -> tuple[Table | None, Table | None]:
    """Return the mappings of A and of B; None where nothing is said of one.

    Raises:
        InvalidInput: as ``table_to_import`` does.
    """
    words = _all_words(options)
    if words is None:
        return None, None
    own = {side: words.pop(side) for side in SIDES if side in words}
    for side, value in own.items():
        if not isinstance(value, dict):
            raise InvalidInput(f"{options.mapping}: [{side}] must be a table of words of a mapping.")
    found: list[Table | None] = []
    for side in SIDES:
        given = {**words, **own.get(side, {})}
        needed = side in own or not own  # with one side alone, the other needs no mapping
        where = f"{_place(options)}[{side}]: " if side in own else _place(options)
        found.append(Table(_mapping(given, where), side in own) if needed else None)
    return found[0], found[1]


def _all_words(options: ColumnOptions) -> dict[str, Any] | None:
    if options.mapping is None:
        return options.words or None
    if options.words:
        given = ", ".join(f"--{name.replace('_', '-')}" for name in options.words)
        raise InvalidInput(f"--mapping has what {given} would say. Give the file or the options.")
    words = read_tables(options.mapping, "mapping")
    if not words:
        raise FormatError(f"{options.mapping}: is empty. Write what the columns are, like time = \"t\".")
    return words


def _place(options: ColumnOptions) -> str:
    return "" if options.mapping is None else f"{options.mapping}: "


def _mapping(words: dict[str, Any], where: str) -> ColumnMapping:
    try:
        return mapping_of_words(words)
    except InvalidInput as error:
        raise InvalidInput(*(f"{where}{line if where else _of_options(line)}" for line in error.args)) from None


def _of_options(line: str) -> str:
    """Return what is wrong with a word of a mapping as what is wrong with the option that gave it."""
    name, *rest = line.split(" ", 1)
    return " ".join([f"--{name.replace('_', '-')}", *rest]) if name in ColumnOptions._fields else line


def needs_mapping(path: Path) -> InvalidInput:
    """Return the error for a table that nothing is said of, with its columns."""
    from polhode.formats.column_reading import COLUMNS_SHOWN
    from polhode.formats.plain_table import table_form

    form = table_form(path)
    more = ", …" if len(form.names) > COLUMNS_SHOWN else ""
    names = ", ".join(name or "(no name)" for name in form.names[:COLUMNS_SHOWN]) + more
    columns = f"with the columns {names}" if form.names else f"of {form.width} columns without names"
    return InvalidInput(f"{path}: is a table {columns}. Say what they are, like {EXAMPLE}.")


def about_reading(trajectory: Trajectory, title: str, level: str) -> Group:
    """Return how a table was understood.

    Args:
        trajectory: as ``read_columns`` gives it.
        title: of the group.
        level: of the answers' names, "" for none.
    """
    assert isinstance(trajectory.source, Recording)
    found = trajectory.source.attributes
    prefix = f"{level}." if level else ""
    off, apart = found["largest_deviation"], found["rates_apart"]
    span = f"{found['first']:.9g} to {found['last']:.9g} s"
    return Group(title, [
        Answer(f"{prefix}header", found["header"], "", "header"),
        Answer(f"{prefix}delimiter", found["delimiter"], "", "between columns"),
        Answer(f"{prefix}time", found["time"], "", "time"),
        Answer(f"{prefix}attitude", found["attitude"], "", "attitude"),
        Answer(f"{prefix}angular_velocity", found["angular_velocity"], "", "angular velocity"),
        Answer(f"{prefix}samples", found["samples"], "", "samples", "", f"{found['samples']}, {span}"),
        Answer(f"{prefix}counted_from", found["counted_from"], "", "times count from", "",
               None if found["counted_from"] is None else f"{found['counted_from']} s of its clock"),
        Answer(f"{prefix}left_out", found["left_out"], "", "lines without values" if found["left_out"] else "", "",
               f"{found['left_out']}, left out"),
        Answer(f"{prefix}repeated", found["repeated"], "", "lines that repeat" if found["repeated"] else "", "",
               f"{found['repeated']}, left out"),
        Answer(f"{prefix}largest_deviation", off, "", "largest deviation of |q| from 1", "",
               None if off is None else f"{off:.2g}, normalised"),
        Answer(f"{prefix}rates_apart", apart, "", "rates differ from the attitude's by", "relative, rms",
               None if apart is None else f"{100.0 * apart:.3g} %"),
    ])  # fmt: skip


def notes_on_reading(trajectory: Trajectory, name: str) -> list[str]:
    """Return what a reader should know of how a table was understood."""
    assert isinstance(trajectory.source, Recording)
    found = trajectory.source.attributes
    notes = [f"{name}: {note}" for note in found["notes"]]
    if (found["rates_apart"] or 0.0) > APART:
        notes.append(f"{name}: the attitude does not turn as the angular velocity says. Check direction, order, "
                     "sequence and units.")  # fmt: skip
    return notes
