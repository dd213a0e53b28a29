"""Reports for people to read, and for programs as JSON."""

from __future__ import annotations

import json
from collections.abc import Iterable, Sequence
from typing import Any

from rich.console import Console
from rich.table import Table
from rich.text import Text

from polhode.errors import one_line, printable
from polhode.reports.base import Listing, Section

STYLES = {"stable": "green", "unstable": "red", "undecided": "yellow"}


def as_json(values: dict[str, Any]) -> str:
    """Return one JSON object in ASCII, which every encoding can hold.

    Raises:
        ValueError: for NaN or an infinity, which reports replace by null.
    """
    return json.dumps(values, indent=2, ensure_ascii=True, allow_nan=False)


def print_report(
    name: str, summary: str, sections: Iterable[Section | Listing], notes: Sequence[str], files: Sequence[str],
    removed: Sequence[str] = (),
) -> None:  # fmt: skip
    """Print a report; parts that are empty are left out."""
    console = Console()
    console.print(_text(name, "bold"))
    if summary:
        console.print(_text(summary))
    for section in sections:
        console.print(_listing(section) if isinstance(section, Listing) else _section(section))
    for note in notes:
        console.print(_text(f"Note: {note}", "yellow"))
    if files:
        console.print(_text(f"Written: {', '.join(map(one_line, files))}", "dim"))
    if removed:
        console.print(_text(f"Removed, of an earlier report: {', '.join(map(one_line, removed))}", "dim"))


def _text(text: str, style: str = "") -> Text:
    """Return text for rich to print as it is: markup is not interpreted, and control characters are escaped."""
    return Text(printable(text), style)


def _section(section: Section) -> Table:
    table = _table(section.title, ("", ""))
    table.show_header = False
    for label, text in section.lines:
        if text is not None:
            table.add_row(_text(label), _text(text))
    return table


def _listing(listing: Listing) -> Table:
    table = _table(listing.title, listing.columns)
    for row in listing.rows:
        table.add_row(*(_cell(text) for text in row))
    return table


def _cell(text: str) -> Text:
    style = STYLES.get(text.split(" ")[0].rstrip(",;"), "")
    return _text(text, style if len(text) < 24 else "")


def _table(title: str, columns: Sequence[str]) -> Table:
    table = Table(title=_text(title, "bold"), title_justify="left", box=None, padding=(0, 2, 0, 0))
    for name in columns:
        table.add_column(_text(name), overflow="fold")
    return table
