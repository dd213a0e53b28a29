"""``polhode view SPEC``: the motion as one page, opened in a browser."""

from __future__ import annotations

from pathlib import Path

import typer

from polhode.cli.destinations import check_spares
from polhode.cli.sources import report_of
from polhode.errors import one_line
from polhode.kinds.reading import read_spec


def run_view(path: Path, out: Path | None, open_it: bool) -> None:
    """Read the spec, compute, write the page and open it."""
    from polhode.kinds.page import page_of_report

    target = out or Path(f"{path.stem}.html")
    check_spares(target, path)
    spec = read_spec(path)
    report = report_of(path, spec)
    written = page_of_report(report, target, name=spec.name, surface=spec.surface)
    typer.echo(one_line(str(written)))
    if open_it:
        import webbrowser

        if not webbrowser.open(written.resolve().as_uri()):
            typer.echo("polhode: no browser was found to open it. Open the file yourself.", err=True)
