"""What ``polhode report`` wrote and printed, kept for when it is asked for the same again.

The words, the values, and the bytes of figures, data and page: with these nothing is read, computed or drawn anew, and
neither JAX nor a kind is imported. They are kept by the path of the spec and what was asked for, and are true while the
files that were read, the program, what other packages bring, and the settings by which figures are drawn are the same.

Nothing is kept of a report that came with a warning, which would not be said again, nor where a file that was read may
have changed meanwhile. Python's option ``-W`` and PYTHONWARNINGS say which warnings are shown, so what is kept under
one choice is not taken under another.
"""

from __future__ import annotations

import contextlib
import hashlib
import json
import os
import sys
import time
from collections.abc import Iterator, Sequence
from importlib import metadata
from importlib.util import find_spec
from operator import itemgetter
from pathlib import Path
from typing import Any, NamedTuple

from polhode._base.plugins import list_plugins
from polhode._base.plugins.program import program_digest
from polhode.cli.entries import (
    LARGEST,
    WRITTEN,
    Origin,
    folder_of_entries,
    keep_entry,
    load_entry,
    may_have_changed,
    record_warnings,
)
from polhode.errors import InvalidInput
from polhode.formats.opening import content_digest, record_files
from polhode.formats.paths import write_together
from polhode.reports.answer import Answer, Group, Table
from polhode.reports.report import PlainReport, Report

DRAWN_BY = "matplotlib", "contourpy", "kiwisolver", "pillow", "fonttools"  # whose versions change figures


class Asked:
    """What is asked of ``polhode report``, besides where it goes and how it is printed.

    Attributes:
        path: of the spec.
        formats: of the figures.
        html: whether the page is written too.
        plugins: all that other packages bring: what is added to kinds, and what they offer, shows in reports on others.
        place: of the entry; None where none are kept.
    """

    def __init__(self, path: Path, formats: Sequence[str], html: bool) -> None:
        """Find the place, before anything is read."""
        self.path, self.formats, self.html = path, formats, html
        self.plugins = list_plugins()
        versions = [(name, _version(name)) for name in DRAWN_BY]
        named = str(path), str(path.absolute())  # messages have it as it is given
        settings = list(_settings_of_figures()), sys.warnoptions
        facts = program_digest(), named, tuple(formats), html, versions, settings, self.plugins
        folder = folder_of_entries()
        name = f"{hashlib.sha256(repr(facts).encode()).hexdigest()}{WRITTEN}"
        self.place = None if folder is None else folder / name


class Written(NamedTuple):
    """What it wrote and has to print.

    Attributes:
        report: of which words and values are printed.
        files: names of its files in their folder, in the order in which they are listed.
        following: commands to try next, each with what it gives.
        more: files that options of wings and other packages wrote, and notes on them.
    """

    report: Report
    files: Sequence[str]
    following: Sequence[tuple[str, str]]
    more: Sequence[tuple[Sequence[str], Sequence[str]]] = ()


class ReportInWords(PlainReport):
    """A report as far as it is printed."""

    def __init__(self, words: dict[str, Any]) -> None:
        """Take what ``_in_words`` returns."""
        groups = [_read_table(**each) if "columns" in each else _read_group(**each) for each in words["answers"]]
        super().__init__(words["name"], words["kind"], words["summary"], groups, words["notes"])
        self._values = words["values"]

    def as_json_dict(self) -> dict[str, Any]:
        return self._values


class Keeper:
    """Notes from what a report is made, so that what it wrote can be kept.

    Attributes:
        begun: when this was [ns since 1970].
    """

    def __init__(self, asked: Asked) -> None:
        """Begin before anything is read."""
        self._asked, self.begun = asked, time.time_ns()
        self._read: dict[Path, str] = {}
        self._has_warned = False

    @contextlib.contextmanager
    def note(self) -> Iterator[None]:
        """Note the files that the block reads, and whether it warns."""
        with record_warnings() as shown, record_files() as read:
            yield
        self._has_warned |= bool(shown)
        self._read |= read

    def keep(self, written: Written, folder: Path) -> None:
        """Keep what was written into a folder, where it will be true."""
        place = self._asked.place
        if place is None or self._has_warned or may_have_changed(self._read, self.begun):
            return
        with contextlib.suppress(Exception):  # what cannot be kept is made again
            sizes = {name: (folder / name).stat().st_size for name in written.files}
            if sum(sizes.values()) > LARGEST:
                return
            head = {"report": _in_words(written.report), "files": sizes, "following": written.following}
            packed = b"".join([json.dumps(head).encode(), b"\n", *((folder / name).read_bytes() for name in sizes)])
            keep_entry(packed, Origin.of(self._asked.plugins, self._read), place)


def write_again(asked: Asked, folder: Path) -> Written | None:
    """Write what was written when the same was asked before; None where that is not kept, or no longer true.

    Raises:
        InvalidInput: for files that cannot be written.
    """
    kept = None if asked.place is None else load_entry(asked.place)
    if kept is None:
        return None
    first, _, packed = kept[1].partition(b"\n")
    head, begin = json.loads(first), 0
    with write_together(folder) as draft:
        for name, size in head["files"].items():
            (draft / name).write_bytes(packed[begin : begin + size])
            begin += size
    following = [(command, gives) for command, gives in head["following"]]
    return Written(ReportInWords(head["report"]), list(head["files"]), following)


def _version(name: str) -> str:
    try:
        return metadata.version(name)
    except metadata.PackageNotFoundError:
        return ""


def _settings_of_figures() -> Iterator[str]:
    """Yield the digests of the files in which matplotlib looks for settings, "" for those that it cannot read."""
    named, own = os.environ.get("MATPLOTLIBRC", ""), os.environ.get("MPLCONFIGDIR")
    try:
        home = Path.home()
    except RuntimeError:  # HOME is not set, and the user has no entry
        home = Path(os.devnull)
    folders = [Path(), Path(named), home / ".matplotlib",
               Path(own) if own else Path(os.environ.get("XDG_CONFIG_HOME") or home / ".config") / "matplotlib"]
    library = find_spec("matplotlib")  # without importing it
    folders += [Path(folder) / "mpl-data" for folder in (library and library.submodule_search_locations) or ()]
    for place in (*(folder / "matplotlibrc" for folder in folders), Path(named)):
        try:
            yield content_digest(place)
        except InvalidInput:  # a folder, or not for this user
            yield ""


def _in_words(report: Report) -> dict[str, Any]:
    """Return what is printed of a report, as JSON has it."""
    answers = [_table_in_words(each) if isinstance(each, Table) else {"title": each.title, "lines": each.lines}
               for each in report.answers]
    return {"name": report.name, "kind": report.kind, "summary": report.summary, "notes": list(report.notes),
            "answers": answers, "values": report.as_json_dict()}


def _table_in_words(table: Table) -> dict[str, Any]:
    whole = table.with_proofs()
    return {"title": table.title, "columns": list(table.columns), "proofs": list(table.proofs), "cells": whole.cells}


def _read_group(title: str, lines: Sequence[Sequence[str]]) -> Group:
    return Group(title, [Answer("", words, label=label, text=words) for label, words in lines])


def _read_table(title: str, columns: Sequence[str], proofs: Sequence[str], cells: Sequence[Sequence[str]]) -> Table:
    rows = [dict(zip((*columns, *proofs), row, strict=True)) for row in cells]
    return Table("", title, {name: itemgetter(name) for name in columns}, rows,
                 proofs={name: itemgetter(name) for name in proofs})
