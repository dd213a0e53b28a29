"""What the wings of polhode bring: kinds, formats, commands, from the table ``plugin.toml`` in each one's folder.

The table has a part for each group of entry points, with the same names and values that another package writes into its
own: ``[kinds]`` is what ``polhode.kinds`` is there. A wing whose folder is missing brings nothing.
"""

from __future__ import annotations

import tomllib
from collections.abc import Iterator
from functools import cache
from importlib.metadata import EntryPoint
from pathlib import Path
from typing import Any

TABLE = "plugin.toml"
PACKAGE = Path(__file__).parents[1]


def wing_names() -> list[str]:
    """Return the names of the wings that are there, each a package of polhode."""
    return [name for name, _ in _tables()]


@cache
def wing_points(group: str) -> dict[str, EntryPoint]:
    """Return what wings bring for a group of entry points, by name, in the order of their tables, without importing."""
    return {name: EntryPoint(name, entry["object"], group) for name, entry in _entries(group)}


@cache
def wing_details(group: str) -> dict[str, dict[str, Any]]:
    """Return what tables say of each name besides its object, such as the line of a command in the help."""
    return {name: {word: value for word, value in entry.items() if word != "object"} for name, entry in _entries(group)}


def _entries(group: str) -> Iterator[tuple[str, dict[str, Any]]]:
    for _, table in _tables():
        for name, entry in table.get(group.removeprefix("polhode."), {}).items():
            yield name, entry if isinstance(entry, dict) else {"object": entry}


@cache
def _tables() -> list[tuple[str, dict[str, Any]]]:
    found = sorted(PACKAGE.glob(f"*/{TABLE}"))
    return [(path.parent.name, tomllib.loads(path.read_text("utf-8"))) for path in found]
