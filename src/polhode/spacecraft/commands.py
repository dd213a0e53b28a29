"""The command ``compare``."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from polhode.cli.commands.application import AsJson, BodySpec
from polhode.cli.source_options import (
    AlignClock,
    ClockKernel,
    ClockOffset,
    ColumnUnit,
    CountScale,
    Decimal,
    Direction,
    EulerColumns,
    EulerSequence,
    FrameKernel,
    GyroColumns,
    LeapSeconds,
    MappingFile,
    MatrixColumns,
    MrpColumns,
    QuatColumns,
    QuatOrder,
    SpiceId,
    TimeColumn,
    TimeSystem,
    TimeUnit,
)


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
    sclk: ClockKernel = None,
    fk: FrameKernel = None,
    lsk: LeapSeconds = None,
    spice_id: SpiceId = None,
    mapping: MappingFile = None,
    time: TimeColumn = None,
    time_unit: TimeUnit = None,
    time_system: TimeSystem = None,
    quat: QuatColumns = None,
    order: QuatOrder = None,
    direction: Direction = None,
    matrix: MatrixColumns = None,
    mrp: MrpColumns = None,
    euler: EulerColumns = None,
    sequence: EulerSequence = None,
    gyro: GyroColumns = None,
    unit: ColumnUnit = None,
    scale: CountScale = None,
    decimal: Decimal = None,
) -> None:
    """Say how two attitude histories differ.

    Printed are the angle over time, misalignments, and the drift of energy and momentum. Options of columns are for
    each table of another tool among the two; where both differ, a mapping file says it.
    """
    from polhode.cli.columns import ColumnOptions
    from polhode.formats.form import Kernels
    from polhode.spacecraft.comparing.command import run_compare

    columns = ColumnOptions(mapping, time, time_unit, time_system, quat, order, direction, matrix, mrp, euler, sequence,
                            gyro, unit, scale, decimal)  # fmt: skip
    run_compare(a, b, json, figures, spec, Kernels(sclk, fk, lsk, spice_id), columns, offset, align_clock)
