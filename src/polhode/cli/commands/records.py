"""Commands that read or write measurements and motions in files; each imports what it needs only when it runs."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from polhode.cli import fit_options as options
from polhode.cli.arguments import StrictCommand
from polhode.cli.column_options import ColumnOptions
from polhode.cli.commands.application import AsJson, BodySpec, SpecPath, app
from polhode.cli.grouped_options import grouped
from polhode.cli.source_options import KernelOptions
from polhode.formats.form_registry import extra_of, writable_names


def _list_forms() -> str:
    """Return the names of the forms of files, for the help, each with the extra that it needs, if any."""
    *names, last = (f"{name} (extra {extra})" if (extra := extra_of(name)) else name for name in writable_names())
    return f"{', '.join(names)} or {last}"


@app.command(cls=StrictCommand)
@grouped
def fit(
    files: options.FitFiles,
    json: AsJson = False,
    pendulum: options.Pendulum = False,
    free: options.FreeNames = None,
    out: options.FitOut = None,
    figures: options.FitFigures = None,
    *,
    throws: options.ThrowOptions,
    columns: ColumnOptions,
) -> None:
    """Fit the inertia of a body to gyro logs of throws or to a pendulum's periods, or a molecule's constants to lines.

    Logs of phyphox, Sensor Logger, AndroSensor and Betaflight are known by their headers; of others say which columns
    are what, like --time t --time-unit s --gyro gx,gy,gz --unit deg/s. Several logs are of the same thing. The exit
    code is 3 where the logs do not tell the inertia; the report says why.
    """
    from polhode.cli.fit import run_fit
    from polhode.studies.fit_request import FitOptions

    for_throws = FitOptions(throws.window or (), *throws[1:-1], throws.weighted or ())
    run_fit(files, free, for_throws, columns, out, figures, json, pendulum)


@app.command(cls=StrictCommand)
def export(
    spec: SpecPath,
    to: Annotated[
        list[str],
        typer.Option("--to", metavar="FORM", help=f"{_list_forms()}; may be repeated."),
    ],
    out: Annotated[
        Path | None,
        typer.Option("--out", metavar="FILE", help="The file (default: named after the spec, in the present folder)."),
    ] = None,
    json: AsJson = False,
) -> None:
    """Write the motion as files for other tools."""
    from polhode.cli.export import run_export

    run_export(spec, to, out, json)


@app.command("import", cls=StrictCommand)
@grouped
def import_(
    file: Annotated[
        Path, typer.Argument(metavar="FILE", help="Of CCSDS, SPICE (extra spice), STK, 42 and others, or any table of "
                             "numbers.")
    ],
    json: AsJson = False,
    out: Annotated[
        Path | None,
        typer.Option("--out", metavar="FILE", help="Dataset, .nc, or a spec, .toml (default: the file's name and "
                     "_imported)."),
    ] = None,
    spec: BodySpec = None,
    *,
    kernels: KernelOptions,
    columns: ColumnOptions,
) -> None:
    """Read another tool's attitude history; write it as NetCDF.

    What the history holds is printed. Files of CCSDS, SPICE, STK and 42, and tables of PX4, ArduPilot, ROS, Basilisk
    and GMAT are known by what they begin with. Of other tables say which columns are what, like
    --time t --time-unit s --quat qw,qx,qy,qz --gyro gx,gy,gz --unit deg/s; how they are read is printed. Of a message
    with inertia and spin at one time, an APM, a spec is written.
    """
    from polhode.cli.importing import run_import
    from polhode.formats.form import Kernels

    run_import(file, json, out, spec, Kernels(*kernels), columns)
