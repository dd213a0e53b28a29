"""Pages of motions: one HTML file each, or a frame in a notebook."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

from polhode.bodies.surface import Surface
from polhode.errors import InvalidInput
from polhode.formats.paths import write_whole
from polhode.kinds.base import Spec
from polhode.kinds.registry import find_kind, kind_of_source
from polhode.motion._trajectory import Trajectory
from polhode.motion.base import AbstractMotion
from polhode.reports.base import MotionReport, SystemReport
from polhode.reports.report import Report
from polhode.viewer.encoding import with_powers
from polhode.viewer.page import NotebookPage, Page, make_page
from polhode.viewer.panels import PageContent
from polhode.viewer.samples import Samples

Shown = AbstractMotion | Trajectory | Spec[Any] | Report


def write_page(
    motion: Shown,
    path: str | Path,
    *,
    name: str | None = None,
    summary: str = "",
    surface: Surface | None = None,
    notes: Sequence[str] = (),
) -> Path:
    """Write a motion as one HTML file that opens from disk; the file appears whole or not at all.

    Args:
        motion: an exact motion or a trajectory of one body, or a report on a motion or a spec, whose page says what the
            report says.
        path: the file; its folder must exist.
        name: heading of the page; the object's or the system's name if left out.
        summary: a sentence below it.
        surface: what the body looks like, in the given axes; without it, a shape with the same inertia is drawn.
        notes: more lines below.

    Raises:
        InvalidInput: for a trajectory that is empty, a batch, not finite, or has nothing to draw, and for a path that
            cannot be written.

    >>> import polhode as ph, tempfile, pathlib
    >>> motion = ph.FreeMotion((1.0, 2.0, 3.0), momentum=(0.3, 1.8, 1.5))
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     path = write_page(motion, pathlib.Path(folder) / "motion.html", name="a body")
    ...     path.stat().st_size < 1_500_000
    True
    """
    return write_page_text(_page(motion, name, summary, surface, notes), Path(path))


def write_page_text(page: Page, path: Path) -> Path:
    """Write a page as a file that appears whole or not at all."""
    with write_whole(path) as draft:
        draft.write_text(page.text, "utf-8")
    return path


def show(
    motion: Shown,
    *,
    name: str | None = None,
    summary: str = "",
    surface: Surface | None = None,
    notes: Sequence[str] = (),
    height: int = 760,
) -> NotebookPage:
    """Return a motion's page for a notebook to show, as the last line of a cell.

    Args:
        motion: an exact motion or a trajectory of one body, or a report on a motion or a spec, whose page says what the
            report says.
        name: heading of the page; the object's or the system's name if left out.
        summary: a sentence below it.
        surface: what the body looks like, in the given axes; without it, a shape with the same inertia is drawn.
        notes: more lines below.
        height: of the frame [pixels].

    Raises:
        InvalidInput: as ``write_page`` does.
    """
    return NotebookPage(_page(motion, name, summary, surface, notes).text, height)


def _page(motion: Shown, name: str | None, summary: str, surface: Surface | None, notes: Sequence[str]) -> Page:
    if isinstance(motion, Spec | Report) and (summary or notes):
        raise InvalidInput("`summary` and `notes` are what a report says, and a spec has its own. Leave them out.")
    if isinstance(motion, Spec):
        motion.kind.check_page()
        return page_of_answers(motion.report(), name or motion.name, motion.picture if surface is None else surface)
    if isinstance(motion, Report):
        return _page_of_any_report(motion, name or motion.name, surface)
    if isinstance(motion, AbstractMotion):
        motion = motion.sample()
    return make_page(motion, name=name, summary=summary, surface=surface, notes=notes, content=_content)


def _page_of_any_report(report: Report, name: str, surface: Surface | None) -> Page:
    if isinstance(report, SystemReport):
        if (kind := find_kind(report.kind)) is not None:
            kind.check_page()
        return page_of_answers(report, name, surface)
    if report.trajectory is None:
        raise InvalidInput(f"a report of kind {report.kind} has no motion to show. Its figures are in plot().")
    return make_page(report.trajectory, name=name, summary=with_powers(report.summary), surface=surface,
                     notes=[with_powers(note) for note in report.notes], content=_content)


def page_of_report(report: SystemReport, path: str | Path, *, surface: Surface | None = None) -> Path:
    """Write the page of a report, with the report's text.

    Args:
        report: any.
        path: the file.
        surface: what the body looks like, in the given axes.

    Raises:
        InvalidInput: as ``write_page`` does.
    """
    return write_page_text(page_of_answers(report, report.name, surface), Path(path))


def page_of_answers(report: SystemReport, name: str, surface: Surface | None) -> Page:
    """Return the content of a report's page."""
    kind = find_kind(report.kind)
    said = {"name": name, "summary": with_powers(report.summary), "surface": surface}
    if isinstance(report, MotionReport):
        notes = [with_powers(note) for note in [*report.notes, *filter(None, [report.shown_part])]]
        panel = None if kind is None else kind.panel()
        scatters = () if panel is None else panel.scatters(report)
        return make_page(report.shown, **said, notes=notes, scatters=scatters, content=_content)
    assert kind is not None, f"a report of kind {report.kind} has no kind"
    notes = [with_powers(note) for note in report.notes]
    return make_page(kind.shown(report), **said, notes=notes,
                   content=lambda _, samples, drawn: kind.content_of_report(report, samples, drawn))


def _content(trajectory: Trajectory, samples: Samples, surface: Surface | None) -> PageContent | None:
    """Return the own pictures of the motion's kind."""
    kind = kind_of_source(trajectory.source)
    return None if kind is None else kind.content(trajectory, samples, surface)
