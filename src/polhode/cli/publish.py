"""Prints a report as text or JSON, and writes its figures and data where the user asks for it."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from polhode.cli.destinations import check_spares
from polhode.cli.naming import as_options
from polhode.cli.render import as_json, print_report
from polhode.errors import InvalidInput
from polhode.formats.paths import write_together
from polhode.reports.report import Report

NOT_DETERMINED = 3  # exit code for data that do not determine the answer, or not its error


def publish(
    report: Report, json: bool, data: Path | None = None, figures: Path | None = None, *, written: Sequence[str] = (),
    removed: Sequence[str] | None = None, certificates: bool = False, following: str = "", read: Sequence[Path] = (),
    remarks: Sequence[str] = (),
) -> None:
    """Write a report's data and figures where asked for, and print it.

    Args:
        report: the report.
        json: whether it is printed as one JSON object, which always has name, kind, summary, units, notes and files.
        data: file for the data of a report that has some.
        figures: folder for the figures.
        written: files that the command has written itself.
        removed: files of an earlier report that it has removed; None for a command that removes none.
        certificates: whether the functions that verdicts rest on are printed as well.
        following: a command to try next.
        read: files that were read, which are not written over.
        remarks: notes of the command's own, after those of the report.

    Raises:
        InvalidInput: if a file cannot be written, and for figures of a report that has none.
    """
    if figures is not None and not report.figures():
        raise InvalidInput(f"--figures: a report of kind {report.kind} has no figures. Leave it out.")
    if data is not None:
        for path in read:
            check_spares(data, path)
    files = [*written, *([] if data is None else [str(report.save(data))]), *_figures(report, figures)]
    if json:
        ends = {"files": files} | ({} if removed is None else {"removed": removed})
        values = report.as_json_dict()
        print(as_json({**values, "notes": [*map(as_options, [*values["notes"], *remarks])], **ends}))
    else:
        notes = [*map(as_options, [*report.notes, *remarks])]
        print_report(report.name, report.summary, report.answers, notes, files, removed or (), certificates, following)


def _figures(report: Report, folder: Path | None) -> Sequence[str]:
    if folder is None:
        return []
    with write_together(folder) as draft:
        drawn = report.draw(draft)
    return [str(folder / path.name) for path in drawn]
