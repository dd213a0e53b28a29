"""The commands and their options; each imports what it needs only when it runs."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from polhode.cli import fit_options as options
from polhode.cli import spectrum_options as spectrum
from polhode.cli import tumble_options as tumbling
from polhode.cli.arguments import StrictCommand, whole_number
from polhode.cli.foreign import Commands
from polhode.cli.source_options import (
    ClockKernel,
    ClockOffset,
    ColumnUnit,
    Decimal,
    Direction,
    EulerColumns,
    EulerSequence,
    FrameKernel,
    GyroColumns,
    LeapSeconds,
    MappingFile,
    QuatColumns,
    QuatOrder,
    SpiceId,
    TimeColumn,
    TimeUnit,
)
from polhode.formats.form_registry import writable_forms

app = typer.Typer(
    name="polhode",
    cls=Commands,
    help="How does this thing rotate? Exact motion of rigid bodies, and what it means.",
    no_args_is_help=True,
    add_completion=False,
    pretty_exceptions_enable=False,
    rich_markup_mode=None,  # half of the time that `--help` would take
)


def _list_forms() -> str:
    """Return the names of the forms of files, for the help."""
    *names, last = writable_forms()
    return f"{', '.join(names)} or {last}"


SpecPath = Annotated[Path, typer.Argument(metavar="SPEC", help="TOML file: what body, how it spins, when.")]
AsJson = Annotated[bool, typer.Option("--json", help="Print one JSON object (SI values) on standard output.")]
BodySpec = Annotated[Path | None, typer.Option("--spec", metavar="SPEC", help="Whose body it is, for its moments.")]


@app.callback(invoke_without_command=True)
def about(
    version: Annotated[bool, typer.Option("--version", help="Print the version and stop.", is_eager=True)] = False,
) -> None:
    """How does this thing rotate? Exact motion of rigid bodies, and what it means."""
    if version:
        from polhode import __version__

        typer.echo(f"polhode {__version__}")
        raise typer.Exit


@app.command(cls=StrictCommand)
def report(
    spec: SpecPath,
    json: AsJson = False,
    out: Annotated[
        Path | None,
        typer.Option("--out", metavar="DIR", help="Folder for figures and dataset (default: named after the spec)."),
    ] = None,
    figures: Annotated[
        list[str] | None,
        typer.Option("--figures", metavar="FORM", help="png, svg, pdf, or several with commas (default: png)."),
    ] = None,
    html: Annotated[bool, typer.Option("--html", help="Also write the page of the motion, page.html.")] = False,
    certificates: Annotated[
        bool, typer.Option("--certificates", help="Also print the formula that each verdict rests on.")
    ] = False,
    proof: Annotated[
        Path | None,
        typer.Option("--proof", metavar="DIR", help="Also write each verdict as a proof that Rocq checks, into DIR."),
    ] = None,
) -> None:
    """Say how the body rotates; write figures and a NetCDF dataset.

    Motion, stability and periods are printed.
    """
    from polhode.cli.report import run_report

    run_report(spec, json, out, figures or [], html, certificates, proof)


@app.command(cls=StrictCommand)
def new(
    example: Annotated[
        str | None, typer.Argument(metavar="[EXAMPLE]", help="Which one to copy; without one, all are listed.")
    ] = None,
    out: Annotated[
        Path | None, typer.Option("--out", metavar="DIR", help="Folder to copy it to (default: the present one).")
    ] = None,
) -> None:
    """Copy a commented spec to begin with, or list those that there are."""
    from polhode.cli.new import run_new

    run_new(example, out)


@app.command(cls=StrictCommand)
def view(
    spec: Annotated[
        Path | None, typer.Argument(metavar="[SPEC]", help="TOML file; without one, a playground of many motions.")
    ] = None,
    out: Annotated[
        Path | None,
        typer.Option("--out", metavar="FILE", help="The page (default: named after the spec, in this folder)."),
    ] = None,
    no_open: Annotated[bool, typer.Option("--no-open", help="Write the page without opening it.")] = False,
) -> None:
    """Write the motion as one HTML page, and open it.

    The page needs nothing else. Free bodies and Lagrange tops can be set there, and go on for ever.
    """
    from polhode.cli.view import run_view

    run_view(spec, out, not no_open)


@app.command(cls=StrictCommand)
def body(spec: SpecPath, json: AsJson = False) -> None:
    """Print the body's mass properties alone."""
    from polhode.cli.body import run_body

    run_body(spec, json)


@app.command(cls=StrictCommand)
def certify(
    spec: SpecPath,
    json: AsJson = False,
    digits: Annotated[
        int, typer.Option("--digits", metavar="N", parser=whole_number(1, 1000), help="Decimals (default: 25).")
    ] = 25,
    at: Annotated[
        list[str] | None, typer.Option("--at", metavar="T", help='Time of a state, like "1e9 s"; may be repeated.')
    ] = None,
) -> None:
    """Prove bounds of a free body's or a Lagrange top's motion, to any number of digits.

    Printed are the regime and verdicts, decided in exact arithmetic, and periods, precession, geometric phase, action
    and states, each with a radius within which the truth lies. Needs the extra symbolic.
    """
    from polhode.cli.certify import run_certify

    run_certify(spec, digits, at or [], json)


@app.command(cls=StrictCommand)
def levels(
    file: spectrum.MoleculeFile, json: AsJson = False, j_max: spectrum.LargestJ = None,
    out: spectrum.SpectrumFile = None,
) -> None:  # fmt: skip
    """Print a molecule's rotational levels."""
    from polhode.cli.spectra import run_levels

    run_levels(file, j_max, json, out)


@app.command(cls=StrictCommand)
def lines(
    file: spectrum.MoleculeFile, json: AsJson = False, j_max: spectrum.LargestJ = None,
    temperature: spectrum.Temperature = None, lowest: spectrum.Lowest = None, highest: spectrum.Highest = None,
    min_intensity: spectrum.SmallestIntensity = None, most: spectrum.Strongest = 50, dipole: spectrum.Dipole = None,
    out: spectrum.SpectrumFile = None,
) -> None:  # fmt: skip
    """Print a molecule's rotational lines by frequency, with intensities."""
    from polhode.cli.spectra import LineOptions, run_lines

    run_lines(file, LineOptions(j_max, temperature, lowest, highest, min_intensity, most, dipole), json, out)


@app.command(cls=StrictCommand)
def fit(
    files: options.FitFiles,
    json: AsJson = False,
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
    quat: QuatColumns = None,
    order: QuatOrder = None,
    direction: Direction = None,
    euler: EulerColumns = None,
    sequence: EulerSequence = None,
    gyro: GyroColumns = None,
    unit: ColumnUnit = None,
    decimal: Decimal = None,
) -> None:
    """Fit the inertia of a thrown body to gyro logs, or a molecule's constants to measured lines.

    Logs of phyphox, Sensor Logger, AndroSensor and Betaflight are known by their headers; of others say which columns
    are what, like --time t --time-unit s --gyro gx,gy,gz --unit deg/s. Several logs are of the same thing. The exit
    code is 3 where the logs do not tell the inertia; the report says why.
    """
    from polhode.cli.columns import ColumnOptions
    from polhode.cli.fit import run_fit
    from polhode.studies.throws import ThrowOptions

    columns = ColumnOptions(mapping, time, time_unit, quat, order, direction, euler, sequence, gyro, unit, decimal)
    for_throws = ThrowOptions(window or (), drag, torque, rotor, gain, clip, moment, mass, added_weight, weighted or ())
    run_fit(files, free, for_throws, columns, out, figures, json)


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
    file: Annotated[Path, typer.Argument(metavar="FILE", help="CCSDS AEM, SPICE C-kernel, or any table of numbers.")],
    json: AsJson = False,
    out: Annotated[
        Path | None,
        typer.Option("--out", metavar="FILE.nc", help="Dataset to write (default: the file's name and _imported.nc)."),
    ] = None,
    spec: BodySpec = None,
    sclk: ClockKernel = None,
    fk: FrameKernel = None,
    lsk: LeapSeconds = None,
    spice_id: SpiceId = None,
    mapping: MappingFile = None,
    time: TimeColumn = None,
    time_unit: TimeUnit = None,
    quat: QuatColumns = None,
    order: QuatOrder = None,
    direction: Direction = None,
    euler: EulerColumns = None,
    sequence: EulerSequence = None,
    gyro: GyroColumns = None,
    unit: ColumnUnit = None,
    decimal: Decimal = None,
) -> None:
    """Read another tool's attitude history; write it as NetCDF.

    What the history holds is printed. Of a table, such as a CSV file, say which columns are what, like
    --time t --time-unit s --quat qw,qx,qy,qz --gyro gx,gy,gz --unit deg/s; how it is read is printed.
    """
    from polhode.cli.columns import ColumnOptions
    from polhode.cli.importing import run_import
    from polhode.formats.form import Kernels

    columns = ColumnOptions(mapping, time, time_unit, quat, order, direction, euler, sequence, gyro, unit, decimal)
    run_import(file, json, out, spec, Kernels(sclk, fk, lsk, spice_id), columns)


@app.command(cls=StrictCommand)
def compare(
    a: Annotated[
        Path, typer.Argument(metavar="A", help="Spec, dataset or CSV of polhode's, CCSDS AEM, C-kernel, any table.")
    ],
    b: Annotated[Path, typer.Argument(metavar="B", help="The same; times are counted by A.")],
    json: AsJson = False,
    out: Annotated[
        Path | None, typer.Option("--out", metavar="DIR", help="Folder for the figure (default: named after both).")
    ] = None,
    spec: BodySpec = None,
    offset: ClockOffset = None,
    sclk: ClockKernel = None,
    fk: FrameKernel = None,
    lsk: LeapSeconds = None,
    spice_id: SpiceId = None,
    mapping: MappingFile = None,
    time: TimeColumn = None,
    time_unit: TimeUnit = None,
    quat: QuatColumns = None,
    order: QuatOrder = None,
    direction: Direction = None,
    euler: EulerColumns = None,
    sequence: EulerSequence = None,
    gyro: GyroColumns = None,
    unit: ColumnUnit = None,
    decimal: Decimal = None,
) -> None:
    """Say how two attitude histories differ.

    Printed are the angle over time, misalignments, and the drift of energy and momentum. Options of columns are for
    each table of another tool among the two; where both differ, a mapping file says it.
    """
    from polhode.cli.columns import ColumnOptions
    from polhode.cli.compare import run_compare
    from polhode.formats.form import Kernels

    columns = ColumnOptions(mapping, time, time_unit, quat, order, direction, euler, sequence, gyro, unit, decimal)
    run_compare(a, b, json, out, spec, Kernels(sclk, fk, lsk, spice_id), columns, offset)


@app.command(cls=StrictCommand)
def sweep(
    spec: SpecPath,
    out: Annotated[
        Path | None,
        typer.Option("--out", metavar="STORE.zarr", help="Zarr store to make or go on with (default: after the spec)."),
    ] = None,
    workers: Annotated[
        int | None,
        typer.Option("--workers", metavar="N", parser=whole_number(1, 1024),
                     help="Worker processes here (default: one for each core; short sweeps need none)."),
    ] = None,
    scheduler: Annotated[
        str | None,
        typer.Option("--scheduler", metavar="ADDRESS", help="Dask scheduler whose workers to use, like tcp://host:8786."),
    ] = None,
    dry_run: Annotated[bool, typer.Option("--dry-run", help="Say what time, memory and room it will take.")] = False,
    json: AsJson = False,
    no_figures: Annotated[bool, typer.Option("--no-figures", help="Draw no figures.")] = False,
) -> None:
    """Compute many motions, with numbers of the spec spread.

    The table [sweep] says which, and what to keep. Samples go into a Zarr store; statistics are printed and drawn. The
    same command again goes on with a sweep that was stopped.
    """
    from polhode.cli.sweep import SweepOptions, run_sweep

    run_sweep(spec, SweepOptions(out, workers, scheduler, dry_run, json, no_figures))


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
        typer.Argument(metavar="[FILE]", help="IERS C04 or finals2000A (default: C04 of astropy-iers-data)."),
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


@app.command(cls=StrictCommand)
def derive(
    name: Annotated[
        str | None, typer.Argument(metavar="[NAME]", help="Like free-body; without one, all are listed.")
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
