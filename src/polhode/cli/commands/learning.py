"""Commands for those who learn and teach; each imports what it needs only when it runs."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from polhode.cli.arguments import StrictCommand, whole_number
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


@app.command(cls=StrictCommand)
def learn(
    chapter: Annotated[
        str | None, typer.Argument(metavar="CHAPTER", help="Where to begin, like 5 or two-surfaces.")
    ] = None,
    worksheet: Annotated[
        bool, typer.Option("--worksheet", help="Write the chapter's exercises as a page to print.")
    ] = False,
    key: Annotated[bool, typer.Option("--key", help="Write the teacher's key: answers, solutions, mistakes.")] = False,
    seed: Annotated[
        int | None,
        typer.Option(
            "--seed", metavar="N", parser=whole_number(0, 10**9), help="Which numbers the exercises have (default: 0)."
        ),
    ] = None,
    out: Annotated[
        Path | None, typer.Option("--out", metavar="FILE.html", help="File of the worksheet or key.")
    ] = None,
    source: Annotated[
        Path | None, typer.Option("--from", metavar="DIR", help="Folder of a built course or documentation.")
    ] = None,
    no_open: Annotated[bool, typer.Option("--no-open", help="Print where the page is, and leave it closed.")] = False,
) -> None:
    """Open the course in a browser, without a network, or write a worksheet.

    Fourteen chapters at three tiers, each with a panel, a derivation and exercises that check themselves.
    """
    from polhode.cli.learn import run_learn

    run_learn(chapter, worksheet, key, seed, out, source, not no_open)
