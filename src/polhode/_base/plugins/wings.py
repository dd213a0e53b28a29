"""What the wings of polhode bring: kinds, formats, commands, from the table ``plugin.toml`` in each one's folder.

The table has a part for each group of entry points, with the same names and values that another package writes into its
own: ``[kinds]`` is what ``polhode.kinds`` is there. A wing whose folder is missing brings nothing. Beside the object a
table may say what must be known of it before it is imported; the core's own table has only that, as the core finds its
kinds and formats in their folders.
"""

from __future__ import annotations

import tomllib
from collections.abc import Iterator
from functools import cache
from importlib.metadata import EntryPoint
from pathlib import Path
from typing import Any

TABLE = "plugin.toml"
PACKAGE = Path(__file__).parents[2]


def wing_names() -> list[str]:
    """Return the names of the wings that are there, each a package of polhode."""
    return [name for name, _ in _tables() if name]


@cache
def wing_points(group: str) -> dict[str, EntryPoint]:
    """Return what wings bring for a group of entry points, by name, in the order of their tables, without importing."""
    return {name: EntryPoint(name, entry["object"], group) for name, entry in _entries(group) if "object" in entry}


@cache
def wing_details(group: str) -> dict[str, dict[str, Any]]:
    """Return what tables, the core's too, say of each name besides its object, such as a command's line in the help."""
    return {name: {word: value for word, value in entry.items() if word != "object"} for name, entry in _entries(group)}


def _entries(group: str) -> Iterator[tuple[str, dict[str, Any]]]:
    for _, table in _tables():
        for name, entry in table.get(group.removeprefix("polhode."), {}).items():
            yield name, entry if isinstance(entry, dict) else {"object": entry}


@cache
def _tables() -> list[tuple[str, dict[str, Any]]]:
    """Return the tables by their wings, the core's first, by an empty name."""
    found = {"": PACKAGE / TABLE} | {path.parent.name: path for path in sorted(PACKAGE.glob(f"*/{TABLE}"))}
    return [(name, tomllib.loads(path.read_text("utf-8"))) for name, path in found.items()]
