"""Options that several commands share: the columns of a table."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Any, NamedTuple

import typer

TimeColumn = Annotated[
    str | None,
    typer.Option("--time", metavar="COLUMN",
                 help="Of a table: column of the times, by name or number; or two that add up."),
]
TimeUnit = Annotated[
    str | None,
    typer.Option("--time-unit", metavar="UNIT",
                 help="s, ms, us, ns, min, h, d, unless the column's name says it; or mjd, jd, gps, unix, unix-ns, or "
                      "gmat: days from JD 2430000."),
]
TimeSystem = Annotated[
    str | None,
    typer.Option("--time-system", metavar="SYSTEM",
                 help="UTC, TAI, TT, TDB or GPS, of dates without a zone and of Julian days."),
]
QuatColumns = Annotated[
    str | None,
    typer.Option("--quat", metavar="C,C,C,C", help="Columns of the attitude quaternion, or of its vector part alone."),
]
QuatOrder = Annotated[
    str | None,
    typer.Option("--order", metavar="ORDER", help="wxyz or xyzw, unless the columns' names end in these letters."),
]
Direction = Annotated[
    str | None,
    typer.Option("--direction", metavar="WAY", help="body-to-space (default) or space-to-body, of the attitude."),
]
MatrixColumns = Annotated[
    str | None,
    typer.Option("--matrix", metavar="C,C,…", help="Nine columns of the rotation matrix, row by row."),
]
MrpColumns = Annotated[
    str | None, typer.Option("--mrp", metavar="C,C,C", help="Columns of modified Rodrigues parameters.")
]
EulerColumns = Annotated[
    str | None,
    typer.Option("--euler", metavar="C,C,C", help="Columns of Euler angles, in the order of --sequence."),
]
EulerSequence = Annotated[
    str | None,
    typer.Option("--sequence", metavar="AXES", help="Like ZYX about the body's own axes, xyz about those of space."),
]
GyroColumns = Annotated[
    str | None,
    typer.Option("--gyro", metavar="C,C,C", help="Columns of the angular velocity along the body's x, y, z."),
]
ColumnUnit = Annotated[
    str | None,
    typer.Option("--unit", metavar="UNIT", help="deg/s, rad/s or rpm of --gyro, deg or rad of --euler; or deg,deg/s."),
]
CountScale = Annotated[
    str | None,
    typer.Option("--scale", metavar="SCALE",
                 help='Of raw counts in --gyro, like "131 LSB/(deg/s)", instead of --unit.'),
]
Decimal = Annotated[
    str | None, typer.Option("--decimal", metavar="SIGN", help="point (default) or comma, of the numbers.")
]
MappingFile = Annotated[
    Path | None,
    typer.Option("--mapping", metavar="FILE", help="TOML file with these words; [a] and [b] for one file each."),
]


class ColumnOptions(NamedTuple):
    """Options for the columns of a table, each None where it is not given."""

    mapping: MappingFile = None
    time: TimeColumn = None
    time_unit: TimeUnit = None
    time_system: TimeSystem = None
    quat: QuatColumns = None
    order: QuatOrder = None
    direction: Direction = None
    matrix: MatrixColumns = None
    mrp: MrpColumns = None
    euler: EulerColumns = None
    sequence: EulerSequence = None
    gyro: GyroColumns = None
    unit: ColumnUnit = None
    scale: CountScale = None
    decimal: Decimal = None

    @property
    def words(self) -> dict[str, Any]:
        """The given options, without the mapping file."""
        return {name: value for name, value in self._asdict().items() if value is not None and name != "mapping"}
