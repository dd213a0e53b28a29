"""The commands ``certify`` and ``derive``."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from polhode.cli.arguments import whole_number
from polhode.cli.commands.application import AsJson, SpecPath


def certify(
    spec: SpecPath,
    json: AsJson = False,
    digits: Annotated[
        int, typer.Option("--digits", metavar="N", parser=whole_number(1, 1000), help="Decimals.")
    ] = 25,
    at: Annotated[
        list[str] | None, typer.Option("--at", metavar="T", help='Time of a state, like "1e9 s"; may be repeated.')
    ] = None,
) -> None:
    """Prove bounds of a free body's or a Lagrange top's motion, with up to 1000 digits.

    Printed are the regime and verdicts, decided in exact arithmetic, and periods, precession, geometric phase, action
    and states, each with a radius within which the truth lies.
    """
    from polhode.proving.enclosures.command import run_certify

    run_certify(spec, digits, at or [], json)


def derive(
    name: Annotated[
        str | None, typer.Argument(metavar="NAME", help="Like free-body; without one, all are listed.")
    ] = None,
    to: Annotated[
        str | None, typer.Option("--to", metavar="FORM", help="text, markdown, latex or html (default: text).")
    ] = None,
    out: Annotated[
        Path | None,
        typer.Option("--out", metavar="FILE", help="File to write; .txt, .md, .tex or .html selects the form."),
    ] = None,
) -> None:
    """Derive the equations of a system from its bracket, each step checked.

    Brackets, equations of motion, Casimirs, integrals and conditions of stability are computed by symbols and compared
    with the numerical system.
    """
    from polhode.proving.symbolic.command import run_derive

    run_derive(name, to, out)
