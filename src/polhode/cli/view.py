"""``polhode view SPEC``: the motion as one page, opened in a browser."""

from __future__ import annotations

from pathlib import Path

import typer

from polhode.cli.destinations import check_spares
from polhode.errors import InvalidInput, NotConverged, one_line
from polhode.report.choice import report_of
from polhode.spec.reading import read_spec


def run_view(path: Path, out: Path | None, open_it: bool) -> None:
    """Read the spec, compute, write the page and open it."""
    from polhode.viewer import page_of_report

    target = out or Path(f"{path.stem}.html")
    check_spares(target, path)
    spec = read_spec(path)
    try:
        report = report_of(spec)
    except (InvalidInput, NotConverged) as error:
        raise type(error)(f"{path}: {error}") from None
    written = page_of_report(report, target, name=spec.name, surface=spec.surface)
    typer.echo(one_line(str(written)))
    if open_it:
        import webbrowser

        if not webbrowser.open(written.resolve().as_uri()):
            typer.echo("polhode: no browser was found to open it. Open the file yourself.", err=True)
