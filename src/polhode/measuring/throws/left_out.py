"""Parts of logs of throws that were left out, and why."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from polhode.measuring.throws.flight import Flights, Window
from polhode.reports.answer import Table

MAX_LISTED = 8  # stretches in a message


def left_out_table(names: Sequence[str], flights: Sequence[Flights]) -> Table:
    """Return the stretches of each log that look like flights and are left out."""
    rows: list[dict[str, Any]] = [
        {"log": name, "window": [one.start, one.end], "why": one.reason, "score": one.score}
        for name, per_log in zip(names, flights, strict=True) for one in per_log.left_out
    ]
    return Table("left_out", "Left out", {
        "log": lambda row: row["log"],
        "from – to": lambda row: f"{row['window'][0]:.4g} – {row['window'][1]:.4g} s",
        "why": lambda row: row["why"],
    }, rows, {"window": "s"})


def left_out_note(flights: Sequence[Flights]) -> list[str]:
    """Return a note on stretches that were left out, if any."""
    left = sum(len(per_log.left_out) for per_log in flights)
    if not left:
        return []
    what = "1 stretch that may be a flight is" if left == 1 else f"{left} stretches that may be flights are"
    return [f"{what} left out, see the table; `windows` takes such."]


def left_out_words(left_out: Sequence[Window]) -> str:
    """Return the stretches that were left out in a sentence; empty for none."""
    said = [f"{one.start:.4g} to {one.end:.4g} s {one.reason}" for one in left_out[:MAX_LISTED]]
    more = f"; and {len(left_out) - MAX_LISTED} more" if len(left_out) > MAX_LISTED else ""
    return f" Left out: {'; '.join(said)}{more}." if said else ""
