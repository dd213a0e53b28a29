"""The command ``compare``."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from polhode.cli.column_options import ColumnOptions
from polhode.cli.commands.application import AsJson, BodySpec
from polhode.cli.grouped_options import grouped
from polhode.cli.source_options import AlignClock, ClockOffset, KernelOptions


@grouped
def compare(
    a: Annotated[
        Path, typer.Argument(metavar="A", help="Spec, dataset or CSV of polhode's, a file that import takes.")
    ],
    b: Annotated[Path, typer.Argument(metavar="B", help="The same; times are counted by A.")],
    json: AsJson = False,
    figures: Annotated[
        Path | None,
        typer.Option("--figures", metavar="DIR", help="Folder to draw the figure into (default: named after both)."),
    ] = None,
    spec: BodySpec = None,
    offset: ClockOffset = None,
    align_clock: AlignClock = False,
    *,
    kernels: KernelOptions,
    columns: ColumnOptions,
) -> None:
    """Say how two attitude histories differ.

    Printed are the angle over time, misalignments, and the drift of energy and momentum. Options of columns are for
    each table of another tool among the two; where both differ, a mapping file says it.
    """
    from polhode.formats.form import Kernels
    from polhode.spacecraft.comparing.command import run_compare

    run_compare(a, b, json, figures, spec, Kernels(*kernels), columns, offset, align_clock)
