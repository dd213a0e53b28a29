"""The command ``derive``, which imports what it needs only when it runs."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from polhode.cli.arguments import StrictCommand
from polhode.cli.commands.application import app


@app.command(cls=StrictCommand)
def derive(
    name: Annotated[
        str | None, typer.Argument(metavar="NAME", help="Like free-body; without one, all are listed.")
    ] = None,
    to: Annotated[
        str | None, typer.Option("--to", metavar="FORM", help="text, markdown, latex or html (default: text).")
    ] = None,
    out: Annotated[
        Path | None,
        typer.Option("--out", metavar="FILE", help="File to write; .txt, .md, .tex or .html tells the form."),
    ] = None,
) -> None:
    """Derive the equations of a system from its bracket, each step checked.

    Brackets, equations of motion, Casimirs, integrals and conditions of stability are computed by symbols and compared
    with the numerical system. Needs the extra symbolic.
    """
    from polhode.cli.derive import run_derive

    run_derive(name, to, out)
