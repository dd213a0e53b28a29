"""An option of ``polhode report`` of another package: the report in a few lines, for a wiki."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from polhode.reports import Report


def write_card(report: Report, path: Path) -> tuple[list[str], list[str]]:
    """Also write name and summary as a Markdown file, PATH."""
    from polhode.formats import write_whole

    with write_whole(path) as draft:
        draft.write_text(f"# {report.name}\n\n{report.summary}\n", "utf-8")
    return [str(path)], []
