"""``polhode view SPEC``: the motion as one page, opened in a browser."""

from __future__ import annotations

import time
from pathlib import Path

import typer

from polhode.cli.destinations import check_spares
from polhode.cli.kept import load_or_make_page
from polhode.cli.spec_reports import make_page_report
from polhode.cli.terminal import open_in_browser
from polhode.errors import one_line
from polhode.kinds.reading import read_spec


def run_view(path: Path | None, out: Path | None, open_it: bool) -> None:
    """Read the spec, compute, write the page and open it; without a spec, the playground."""
    written = _playground(out) if path is None else _page(path, out)
    typer.echo(one_line(str(written)))
    if open_it:
        open_in_browser(written)


def _page(path: Path, out: Path | None) -> Path:
    from polhode.kinds.page import write_page_text

    target = out or Path(f"{path.stem}.html")
    check_spares(target, path)
    spec = read_spec(path)
    begun = time.time_ns()
    return write_page_text(load_or_make_page(spec, make_page_report(path, spec), begun), target)


def _playground(out: Path | None) -> Path:
    from polhode.cli.new import examples
    from polhode.kinds.playground import write_playground

    return write_playground(out or Path("playground.html"), examples(), make_page_report)
