"""Reports for people to read, and for programs as JSON."""

from __future__ import annotations

import json
from collections.abc import Iterable, Sequence
from typing import Any

from rich.console import Console
from rich.markup import escape
from rich.table import Table

from polhode.report.base import Listing, Section

STYLES = {"stable": "green", "unstable": "red", "undecided": "yellow"}


def as_json(values: dict[str, Any]) -> str:
    """Return one JSON object; there is no NaN or infinity in it, and it would be an error if there were."""
    return json.dumps(values, indent=2, ensure_ascii=False, allow_nan=False)


def print_report(
    name: str, summary: str, sections: Iterable[Section | Listing], notes: Sequence[str], files: Sequence[str],
    removed: Sequence[str] = (),
) -> None:  # fmt: skip
    """Print a report; parts that are empty are left out."""
    console = Console()
    console.print(f"[bold]{escape(name)}[/bold]")
    if summary:
        console.print(escape(summary), highlight=False)
    for section in sections:
        console.print(_listing(section) if isinstance(section, Listing) else _section(section))
    for note in notes:
        console.print(f"Note: {escape(note)}", style="yellow", highlight=False)
    if files:
        console.print("Written:", escape(", ".join(files)), style="dim", highlight=False)
    if removed:
        console.print("Removed, of an earlier report:", escape(", ".join(removed)), style="dim", highlight=False)


def _section(section: Section) -> Table:
    table = _table(section.title, ("", ""))
    table.show_header = False
    for label, text in section.lines:
        if text is not None:
            table.add_row(label, escape(text))
    return table


def _listing(listing: Listing) -> Table:
    table = _table(listing.title, listing.columns)
    for row in listing.rows:
        table.add_row(*(_cell(text) for text in row))
    return table


def _cell(text: str) -> str:
    style = STYLES.get(text.split(" ")[0].rstrip(",;"))
    return f"[{style}]{escape(text)}[/{style}]" if style and len(text) < 24 else escape(text)


def _table(title: str, columns: Sequence[str]) -> Table:
    table = Table(title=title, title_justify="left", title_style="bold", box=None, padding=(0, 2, 0, 0))
    for name in columns:
        table.add_column(name, overflow="fold")
    return table
