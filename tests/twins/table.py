"""Reads TABLE.md: which promise is kept at which door or in which implementation, and by which test.

A cell holds ● where the tests of this folder are made from the pair, a letter where a test elsewhere shows it, and a
number where the pair does not apply; letters and numbers are explained below each table.
"""

from __future__ import annotations

import ast
import re
from functools import cache
from pathlib import Path
from typing import NamedTuple

HERE = Path(__file__).parent
TESTS = HERE.parent
MADE_HERE = "●"
_NOTE = re.compile(r"^\* \*\*(\w+)\*\*: (.+)$")
_NAMED = re.compile(r"`([\w/]+\.py)::(\w+)`")


class Cell(NamedTuple):
    """What the table says of one pair."""

    row: str
    column: str
    mark: str


class Table(NamedTuple):
    """One table with its notes by their mark."""

    title: str
    rows: list[str]
    columns: list[str]
    cells: list[Cell]
    notes: dict[str, str]

    def pairs(self, *columns: str) -> list[tuple[str, str]]:
        """Return the pairs whose tests are made in this folder, of some columns or all."""
        return [(row, column) for row, column, mark in self.cells
                if mark == MADE_HERE and (not columns or column in columns)]  # fmt: skip


@cache
def read_tables() -> dict[str, Table]:
    """Return the tables of TABLE.md by their titles."""
    parts = re.split(r"^## ", (HERE / "TABLE.md").read_text("utf-8"), flags=re.MULTILINE)[1:]
    return {table.title: table for table in map(read_table, parts)}


def read_table(part: str) -> Table:
    """Return one table from its title and lines."""
    title, *lines = part.splitlines()
    grid = [[word.strip() for word in line.strip()[1:-1].split("|")] for line in lines if line.startswith("|")]
    columns, rows = grid[0][1:], grid[2:]
    cells = [Cell(row[0], column, mark) for row in rows for column, mark in zip(columns, row[1:], strict=True)]
    notes = dict(found.groups() for line in lines if (found := _NOTE.match(line)))
    return Table(title, [row[0] for row in rows], columns, cells, notes)


def named_tests(note: str) -> list[tuple[Path, str]]:
    """Return the files and functions that a note names."""
    return [(TESTS / path, name) for path, name in _NAMED.findall(note)]


@cache
def functions_of(path: Path) -> frozenset[str]:
    """Return the names of the tests of a file."""
    tree = ast.parse(path.read_text("utf-8"))
    return frozenset(node.name for node in ast.walk(tree) if isinstance(node, ast.FunctionDef))
