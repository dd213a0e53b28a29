"""Commands that take a spec; each imports what it needs only when it runs."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from polhode.cli.arguments import StrictCommand
from polhode.cli.commands.application import AsJson, SpecPath, app
from polhode.cli.report_options import ReportCommand


@app.command(cls=ReportCommand)
def report(
    spec: SpecPath,
    json: AsJson = False,
    out: Annotated[
        Path | None,
        typer.Option("--out", metavar="DIR", help="Folder for figures and dataset (default: named after the spec)."),
    ] = None,
    figure_format: Annotated[
        list[str] | None,
        typer.Option("--figure-format", metavar="FORMAT", help="png, svg, pdf, or several with commas (default: png)."),
    ] = None,
    html: Annotated[bool, typer.Option("--html", help="Also write the page of the motion, page.html.")] = False,
    certificates: Annotated[
        bool, typer.Option("--certificates", help="Also print the formula that each verdict rests on.")
    ] = False,
) -> None:
    """Say how the body rotates; write figures and a NetCDF dataset.

    Motion, stability and periods are printed.
    """
    from polhode.cli.report import run_report

    run_report(spec, json, out, figure_format or [], html, certificates)


@app.command(cls=StrictCommand)
def new(
    example: Annotated[
        str | None, typer.Argument(metavar="EXAMPLE", help="Which one to copy; without one, all are listed.")
    ] = None,
    out: Annotated[
        Path | None, typer.Option("--out", metavar="DIR", help="Folder to copy it to (default: the present one).")
    ] = None,
) -> None:
    """Copy a commented spec to begin with, or list the available ones."""
    from polhode.cli.new import run_new

    run_new(example, out)


@app.command(cls=StrictCommand)
def view(
    spec: Annotated[
        Path | None, typer.Argument(metavar="SPEC", help="TOML file; without one, a playground of many motions.")
    ] = None,
    out: Annotated[
        Path | None,
        typer.Option("--out", metavar="FILE", help="The page (default: named after the spec, in this folder)."),
    ] = None,
    no_open: Annotated[bool, typer.Option("--no-open", help="Write the page without opening it.")] = False,
) -> None:
    """Write the motion as one HTML page, and open it.

    The page needs nothing else. Free bodies and Lagrange tops can be set there, and go on for ever.
    """
    from polhode.cli.view import run_view

    run_view(spec, out, not no_open)


@app.command(cls=StrictCommand)
def body(
    spec: SpecPath,
    json: AsJson = False,
    about: Annotated[
        str | None,
        typer.Option(
            "--about",
            metavar="PLACE",
            help='Also the inertia about a point ("0 m, 0 m, 5 cm"), an axis (x, y, z, 1, 2, 3 or "1, 0, 1", perhaps '
            '" through " a point) or a part (its name, or "part 2").',
        ),
    ] = None,
) -> None:
    """Print the body's mass properties alone."""
    from polhode.cli.body import run_body

    run_body(spec, json, about)
