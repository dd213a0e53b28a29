"""Commands that read or write measurements and motions in files; each imports what it needs only when it runs."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from polhode.cli import fit_options as options
from polhode.cli import tumble_options as tumbling
from polhode.cli.arguments import StrictCommand
from polhode.cli.commands.application import AsJson, BodySpec, SpecPath, app
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
from polhode.formats.form_registry import writable_forms


def _list_forms() -> str:
    """Return the names of the forms of files, for the help."""
    *names, last = writable_forms()
    return f"{', '.join(names)} or {last}"


@app.command(cls=StrictCommand)
def fit(
    files: options.FitFiles,
    json: AsJson = False,
    pendulum: options.Pendulum = False,
    free: options.FreeNames = None,
    out: options.FitOut = None,
    figures: options.FitFigures = None,
    window: options.FitWindows = None,
    drag: options.WithDrag = None,
    torque: options.WithTorque = None,
    rotor: options.WithRotor = None,
    gain: options.WithGain = None,
    clip: options.ClipRate = None,
    moment: options.OneMoment = None,
    mass: options.BodyMass = None,
    added_weight: options.AddedWeight = None,
    weighted: options.WeightedLogs = None,
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
    """Fit the inertia of a body to gyro logs of throws or to a pendulum's periods, or a molecule's constants to lines.

    Logs of phyphox, Sensor Logger, AndroSensor and Betaflight are known by their headers; of others say which columns
    are what, like --time t --time-unit s --gyro gx,gy,gz --unit deg/s. Several logs are of the same thing. The exit
    code is 3 where the logs do not tell the inertia; the report says why.
    """
    from polhode.cli.columns import ColumnOptions
    from polhode.cli.fit import run_fit
    from polhode.studies.throws import ThrowOptions

    columns = ColumnOptions(mapping, time, time_unit, time_system, quat, order, direction, matrix, mrp, euler, sequence,
                            gyro, unit, scale, decimal)  # fmt: skip
    for_throws = ThrowOptions(window or (), drag, torque, rotor, gain, clip, moment, mass, added_weight, weighted or ())
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
def import_(
    file: Annotated[
        Path, typer.Argument(metavar="FILE", help="Of CCSDS, SPICE, STK, 42 and others, or any table of numbers.")
    ],
    json: AsJson = False,
    out: Annotated[
        Path | None,
        typer.Option("--out", metavar="FILE", help="Dataset, .nc, or a spec, .toml (default: the file's name and "
                     "_imported)."),
    ] = None,
    spec: BodySpec = None,
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
    """Read another tool's attitude history; write it as NetCDF.

    What the history holds is printed. Files of CCSDS, SPICE, STK and 42, and tables of PX4, ArduPilot, ROS, Basilisk
    and GMAT are known by what they begin with. Of other tables say which columns are what, like
    --time t --time-unit s --quat qw,qx,qy,qz --gyro gx,gy,gz --unit deg/s; how they are read is printed. Of a message
    with inertia and spin at one time, an APM, a spec is written.
    """
    from polhode.cli.columns import ColumnOptions
    from polhode.cli.importing import run_import
    from polhode.formats.form import Kernels

    columns = ColumnOptions(mapping, time, time_unit, time_system, quat, order, direction, matrix, mrp, euler, sequence,
                            gyro, unit, scale, decimal)  # fmt: skip
    run_import(file, json, out, spec, Kernels(sclk, fk, lsk, spice_id), columns)


@app.command(cls=StrictCommand)
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
    from polhode.cli.compare import run_compare
    from polhode.formats.form import Kernels

    columns = ColumnOptions(mapping, time, time_unit, time_system, quat, order, direction, matrix, mrp, euler, sequence,
                            gyro, unit, scale, decimal)  # fmt: skip
    run_compare(a, b, json, figures, spec, Kernels(sclk, fk, lsk, spice_id), columns, offset, align_clock)


@app.command(cls=StrictCommand)
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
    from polhode.cli.judge import run_judge

    run_judge(file, json, figures, spec)


@app.command(cls=StrictCommand)
def tumble(
    body: tumbling.Body = None,
    precession: tumbling.Precession = None,
    rotation: tumbling.Rotation = None,
    moments: tumbling.Moments = None,
    semi_axes: tumbling.SemiAxes = None,
    axis: tumbling.Axis = None,
    mode: tumbling.Mode = None,
    diameter: tumbling.Diameter = None,
    density: tumbling.Density = None,
    rigidity: tumbling.Rigidity = None,
    shape_factor: tumbling.ShapeFactor = None,
    aspect: tumbling.Aspect = None,
    phase: tumbling.Phase = None,
    figures: tumbling.Figures = None,
    out: tumbling.Out = None,
    list_bodies: tumbling.ListBodies = False,
    json: AsJson = False,
) -> None:
    """Tell how an asteroid tumbles, from its two periods and the ratios of its moments of inertia.

    Energy, mode and tilt, what the moments admit, the time of damping, and the light curve of an ellipsoid with the
    frequencies of which it is made.
    """
    from polhode.cli.tumble import TumbleOptions, run_list, run_tumble

    if list_bodies:
        run_list(json)
        return
    run_tumble(body, TumbleOptions(precession, rotation, moments, semi_axes, axis, mode, diameter, density, rigidity,
                                   shape_factor, aspect, phase, figures, out), json)  # fmt: skip


@app.command(cls=StrictCommand)
def wobble(
    file: Annotated[
        Path | None,
        typer.Argument(metavar="FILE", help="IERS C04 or finals2000A (default: C04 of astropy-iers-data)."),
    ] = None,
    start: Annotated[
        str | None, typer.Option("--from", metavar="DAY", help="First day to use, like 1976-01-01.")
    ] = None,
    end: Annotated[str | None, typer.Option("--to", metavar="DAY", help="Day before which to stop.")] = None,
    window: Annotated[
        str | None, typer.Option("--window", metavar="YEARS", help="Length of sliding windows (default: 6).")
    ] = None,
    figures: Annotated[
        Path | None, typer.Option("--figures", metavar="DIR", help="Folder to draw figures into.")
    ] = None,
    json: AsJson = False,
    out: Annotated[
        Path | None, typer.Option("--out", metavar="FILE.nc", help="Dataset of windows, process and excitation.")
    ] = None,
) -> None:
    """Say how the Earth's pole wobbles, from measured polar motion.

    Printed are the Chandler wobble's period, amplitude and Q with errors, the seasons, the wobble in sliding
    windows, and why its period is not Euler's 304 days.
    """
    from polhode.cli.wobble import WobbleOptions, run_wobble

    run_wobble(file, WobbleOptions(start, end, window, figures, out), json)
