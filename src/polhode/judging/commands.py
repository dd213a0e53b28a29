"""The command ``judge``."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from polhode.cli.commands.application import AsJson


def judge(
    file: Annotated[Path, typer.Argument(metavar="FILE", help="JSON with the states that an engine wrote.")],
    json: AsJson = False,
    figures: Annotated[
        Path | None, typer.Option("--figures", metavar="DIR", help="Folder to draw figures into, one a motion.")
    ] = None,
    spec: Annotated[
        Path | None, typer.Option("--spec", metavar="SPEC", help="Of a free body, for runs that name no motion.")
    ] = None,
) -> None:
    """Judge a physics engine by the states that it wrote of free bodies.

    Printed are a verdict for each motion, the order of the method where the file has three step sizes, the drift of
    energy and momentum, how the error grows, and mistakes that explain it. Runs that cannot be judged are listed.
    """
    from polhode.judging.command import run_judge

    run_judge(file, json, figures, spec)
