"""``polhode swings FILE``."""

from pathlib import Path
from typing import Annotated

import typer

import polhode as ph
from swing_timer.report import time_swings


def swings(
    file: Annotated[Path, typer.Argument(metavar="FILE", help="A time on each line, two of each swing.")],
    json: Annotated[bool, typer.Option("--json", help="Print one JSON object.")] = False,
    figures: Annotated[Path | None, typer.Option("--figures", metavar="DIR", help="Folder to draw into.")] = None,
    out: Annotated[Path | None, typer.Option("--out", metavar="FILE", help="File for the residuals.")] = None,
) -> None:
    """Tell the period of a swing."""
    ph.publish(time_swings(file), json, out, figures, read=[file])
