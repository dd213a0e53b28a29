"""Reports as text for people, and as JSON for programs."""

from __future__ import annotations

import json
from collections.abc import Iterable, Sequence
from typing import Any

from rich.console import Console
from rich.table import Table as Grid
from rich.text import Text

from polhode.errors import one_line, printable
from polhode.reports.answer import Group, Table

STYLES = {"stable": "green", "unstable": "red", "undecided": "yellow"}


def as_json(values: dict[str, Any]) -> str:
    """Return one JSON object in ASCII, which every encoding can hold.

    Raises:
        ValueError: for NaN or an infinity, which reports replace by null.
    """
    return json.dumps(values, indent=2, ensure_ascii=True, allow_nan=False)


def print_report(
    name: str, summary: str, groups: Iterable[Group | Table], notes: Sequence[str], files: Sequence[str],
    removed: Sequence[str] = (), certificates: bool = False, following: str = "",
) -> None:
    """Print a report, with the functions that verdicts rest on if asked for, and the command to try next.

    Parts that are empty are left out.
    """
    console = Console()
    console.print(_text(name, "bold"))
    if summary:
        console.print(_text(summary))
    for group in groups:
        if isinstance(group, Table) and certificates:
            group = group.with_proofs()
        grid = _lines(group) if isinstance(group, Group) else _table(group)
        if grid.row_count:
            console.print(grid)
    for note in notes:
        console.print(_text(f"Note: {note}", "yellow"))
    if files:
        console.print(_text(f"Written: {', '.join(map(one_line, files))}", "dim"))
    if removed:
        console.print(_text(f"Removed, of an earlier report: {', '.join(map(one_line, removed))}", "dim"))
    if following:
        console.print(_text(f"Next: {following}", "dim"))


def _text(text: str, style: str = "") -> Text:
    """Return text for rich to print as it is: markup is not interpreted, and control characters are escaped."""
    return Text(printable(text), style)


def _lines(group: Group) -> Grid:
    grid = _grid(group.title, ("", ""))
    grid.show_header = False
    for line in group.lines:
        grid.add_row(*map(_text, line))
    return grid


def _table(table: Table) -> Grid:
    grid = _grid(table.title, list(table.columns))
    for row in table.cells:
        grid.add_row(*map(_cell, row))
    return grid


def _cell(text: str) -> Text:
    style = STYLES.get(text.split(" ")[0].rstrip(",;"), "")
    return _text(text, style if len(text) < 24 else "")


def _grid(title: str, columns: Sequence[str]) -> Grid:
    grid = Grid(title=_text(title, "bold"), title_justify="left", box=None, padding=(0, 2, 0, 0))
    for name in columns:
        grid.add_column(_text(name), overflow="fold")
    return grid
