"""The command ``learn``."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from polhode.cli.arguments import whole_number


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

    Fourteen chapters at three tiers, each with a panel, a derivation and exercises that check themselves. Releases have
    the course; a checkout builds it first, by Sphinx, which the extra docs brings.
    """
    from polhode.course.command import run_learn

    run_learn(chapter, worksheet, key, seed, out, source, not no_open)
