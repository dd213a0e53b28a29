"""Printing a report, as text or JSON, and writing its figures and data where asked for."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from polhode.cli.render import as_json, print_report
from polhode.reports.report import Report


def publish(
    report: Report, json: bool, data: Path | None = None, figures: Path | None = None, following: str = ""
) -> None:
    """Write a report's data and figures where asked for, and print it.

    Args:
        report: what was found out.
        json: whether it is printed as one JSON object, which always has name, kind, summary, units, notes and files.
        data: file for what was found, of a report that has data.
        figures: folder for the figures.
        following: a command to try next.

    Raises:
        InvalidInput: if a file cannot be written.
    """
    files = [*_data(report, data), *_figures(report, figures)]
    if json:
        print(as_json({**report.as_json_dict(), "files": files}))
    else:
        print_report(report.name, report.summary, report.answers, report.notes, files, following=following)


def _data(report: Report, path: Path | None) -> Sequence[str]:
    if path is None or report.data is None:
        return []
    return [str(report.data(path))]


def _figures(report: Report, folder: Path | None) -> Sequence[str]:
    if folder is None:
        return []
    from polhode.figures.style import save
    from polhode.formats.paths import written_together

    with written_together(folder) as draft:
        drawn = [save(figure, draft / f"{name}.png") for name, figure in report.plot().items()]
    return [str(folder / path.name) for path in drawn]
