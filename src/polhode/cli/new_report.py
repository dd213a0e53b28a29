"""A report that is computed, or taken from the cache, drawn and written."""

from __future__ import annotations

from pathlib import Path

from polhode.cli.kept import is_kept, load_or_make_page
from polhode.cli.report_options import write_more
from polhode.cli.spec_reports import make_page_report, make_report
from polhode.cli.written import Asked, Keeper, Written
from polhode.formats.paths import write_together
from polhode.kinds.added_figures import check_kinds_of_figures
from polhode.kinds.reading import read_spec
from polhode.kinds.registry import kind_names, next_steps


def write_new(asked: Asked, folder: Path) -> Written:
    """Write the figures and files of a spec's report, and what brought options write.

    Raises:
        InvalidInput: for what is wrong in the spec, and for files that cannot be written.
        NotConverged: where a motion could not be followed.
    """
    keeper = Keeper(asked)
    with keeper.note():
        spec = read_spec(asked.path)
        report = make_page_report(asked.path, spec) if asked.html else make_report(asked.path, spec)
        check_kinds_of_figures(kind_names())
        following = [(step.command, step.gives) for step in next_steps(spec)]
    with write_together(folder) as draft:
        with keeper.note():
            files = report.draw(draft, *asked.formats)
            if report.data_file:
                files.append(report.save(draft / report.data_file))
            if asked.html:
                from polhode.kinds.page import write_page_text

                files.append(write_page_text(load_or_make_page(spec, report, keeper.begun), draft / "page.html"))
        written = Written(report, [file.name for file in files], following)
        if is_kept(spec):
            keeper.keep(written, draft)
        return written._replace(more=list(write_more(report)))
