"""Options that describe the columns of another tool's table."""

from __future__ import annotations

from typing import Any

from polhode.cli.column_options import ColumnOptions
from polhode.errors import FormatError, InvalidInput
from polhode.formats.column_mapping import ColumnMapping, make_mapping
from polhode.spec.parsing import read_tables
from polhode.studies.tables import TableMapping

SIDES = ("a", "b")


def table_to_import(options: ColumnOptions) -> TableMapping | None:
    """Return the mapping of the file to import; None without options for columns.

    Raises:
        InvalidInput: for words that are wrong, and for options beside a mapping file.
    """
    words = _all_words(options)
    if words is None:
        return None
    if sides := [side for side in SIDES if side in words]:
        why = f"has a table [{sides[0]}], which is for `polhode compare`"
        raise InvalidInput(f"{options.mapping}: {why}. Leave it out.")
    return TableMapping(_make_mapping(words, _place(options)), True)


def tables_to_compare(options: ColumnOptions) -> tuple[TableMapping | None, TableMapping | None]:
    """Return the mappings of A and of B; None for a file without one.

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
    tables: list[TableMapping | None] = []
    for side in SIDES:
        settings = {**words, **own.get(side, {})}
        needed = side in own or not own  # with options for one side alone, the other needs no mapping
        where = f"{_place(options)}[{side}]: " if side in own else _place(options)
        tables.append(TableMapping(_make_mapping(settings, where), side in own) if needed else None)
    return tables[0], tables[1]


def _all_words(options: ColumnOptions) -> dict[str, Any] | None:
    if options.mapping is None:
        return options.words or None
    if options.words:
        flags = ", ".join(f"--{name.replace('_', '-')}" for name in options.words)
        raise InvalidInput(f"--mapping has what {flags} would say. Give the file or the options.")
    words = read_tables(options.mapping, "mapping")
    if not words:
        raise FormatError(f"{options.mapping}: is empty. Write what the columns are, like time = \"t\".")
    return words


def _place(options: ColumnOptions) -> str:
    return "" if options.mapping is None else f"{options.mapping}: "


def _make_mapping(words: dict[str, Any], where: str) -> ColumnMapping:
    try:
        return make_mapping(words)
    except InvalidInput as error:
        raise InvalidInput(*(f"{where}{line if where else _of_options(line)}" for line in error.args)) from None


def _of_options(line: str) -> str:
    """Return a mistake in a word of a mapping as a mistake in the option that gave it."""
    name, *rest = line.split(" ", 1)
    return " ".join([f"--{name.replace('_', '-')}", *rest]) if name in ColumnOptions._fields else line
