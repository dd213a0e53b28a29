"""A report: what polhode found out about something, as one object, whatever that is."""

from __future__ import annotations

import html
import json
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from polhode.errors import printable
from polhode.reports.answer import Group, Table, units_of, values_of
from polhode.reports.base import plain


@dataclass(frozen=True)
class Report:
    """What was found out about something: in words, as values by name, in figures and in a file of data.

    A notebook shows it as it stands; ``values`` has its numbers, ``json`` a text for other programs.

    Attributes:
        name: of what it is about.
        kind: of report, like "tumble".
        summary: the answer in a sentence or two.
        answers: all that is said, by groups and tables.
        notes: what a reader should know beside the numbers.
        draw: returns the figures by name, as Matplotlib has them; None where there are none.
        data: writes what was found into a file and returns its path; None where there is nothing to write.
        determined: whether the question could be answered.

    >>> import polhode as ph
    >>> found = ph.tumble("apophis")
    >>> found.kind, round(found.values()["energy_ratio"], 3)
    ('tumble', 1.024)
    """

    name: str
    kind: str
    summary: str
    answers: Sequence[Group | Table]
    notes: Sequence[str] = ()
    draw: Callable[[], Mapping[str, Any]] | None = None
    data: Callable[[Path], Path] | None = None
    determined: bool = True

    def values(self) -> dict[str, Any]:
        """Return the answers by name, levels as nested dictionaries, SI units."""
        return values_of(self.answers)

    def units(self) -> dict[str, str]:
        """Return the units by the names of the answers, explanations after them."""
        return units_of(self.answers)

    def as_json_dict(self) -> dict[str, Any]:
        """Return all of it as plain lists, numbers, strings and None; undefined or infinite numbers are None."""
        head = {"name": self.name, "kind": self.kind, "summary": self.summary}
        return plain({**head, **self.values(), "units": self.units(), "notes": list(self.notes)})

    def json(self) -> str:
        """Return the same as a text in ASCII."""
        return json.dumps(self.as_json_dict(), indent=2, ensure_ascii=True, allow_nan=False)

    def plot(self) -> dict[str, Any]:
        """Return the figures by name, as Matplotlib has them."""
        return {} if self.draw is None else dict(self.draw())

    def _repr_html_(self) -> str:
        """Return the text as a notebook shows it."""
        parts = [f"<b>{_escaped(self.name)}</b>", f"<p>{_escaped(self.summary)}</p>" if self.summary else ""]
        for group in self.answers:
            head = list(group.columns) if isinstance(group, Table) else []
            rows = group.cells if isinstance(group, Table) else group.lines
            if rows:
                parts.append(_html_table(group.title, head, rows))
        return "".join([*parts, *(f"<p><i>Note: {_escaped(note)}</i></p>" for note in self.notes)])


def _html_table(title: str, head: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    top = f"<tr>{''.join(f'<th>{_escaped(cell)}</th>' for cell in head)}</tr>" if head else ""
    body = "".join(f"<tr>{''.join(f'<td>{_escaped(cell)}</td>' for cell in row)}</tr>" for row in rows)
    return f"<table><caption>{_escaped(title)}</caption>{top}{body}</table>"


def _escaped(text: str) -> str:
    return html.escape(printable(text))
