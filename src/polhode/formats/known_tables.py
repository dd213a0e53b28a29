"""Tables that other programs write with columns of known names, which need no mapping.

Each of these programs has a module in ``formats/forms`` that knows its names; here are their common functions.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from polhode.formats.form import Form, Kernels

if TYPE_CHECKING:
    from polhode.motion._trajectory import Trajectory

Words = dict[str, Any]
"""Words of a mapping, as ``ColumnMapping`` takes them."""


def make_table_form(
    name: str, title: str, holds: str, words_for: Callable[[Sequence[str]], Words | None], ending: str = ".csv"
) -> Form:
    """Return the form of a table that is known by the names of its columns.

    Args:
        name, title, holds, ending: as those of ``Form``.
        words_for: returns the mapping of a table with these columns; None where it is not such a table.
    """

    def read(path: Path, kernels: Kernels) -> Trajectory:
        from polhode.errors import FormatError
        from polhode.formats.column_mapping import make_mapping
        from polhode.formats.column_reading import read_columns
        from polhode.formats.plain_table import table_form

        words = words_for(table_form(path).names)
        if words is None:
            raise FormatError(f"{path}: begins like {title} and has other columns. Say what they are, by `time` and "
                              "`quat`.")
        return read_columns(path, make_mapping(words))

    def begins(head: bytes) -> bool:
        return any(words_for(names) is not None for names in _headers(head))

    return Form(name, title, ending, holds, None, read, begins, of_attitudes=True, has_labels=True, is_table=True)


def _headers(head: bytes) -> list[list[str]]:
    """Return the cells of the first lines of a file, by each possible delimiter."""
    max_lines = 20  # that are searched for names
    lines = head[:20000].decode("utf-8", "replace").splitlines()[:max_lines]
    signs = [sign for sign in (",", ";", "\t") if any(sign in line for line in lines)] or [None]
    return [[cell.strip(' "') for cell in line.lstrip("#% ").split(sign)] for line in lines for sign in signs]


def find_one(names: Sequence[str], pattern: str) -> int | None:
    """Return the column, from 1, whose name in lower case matches a pattern; None for none or several."""
    places = [k for k, name in enumerate(names, 1) if re.search(pattern, name.strip().lower())]
    return places[0] if len(places) == 1 else None


def find_series(names: Sequence[str], pattern: str, marks: Sequence[str]) -> list[int] | None:
    """Return the columns, from 1, of a pattern with each of some marks for its {}; None where one is missing."""
    places = [find_one(names, pattern.replace("{}", re.escape(mark))) for mark in marks]
    return [place for place in places if place is not None] if None not in places else None
