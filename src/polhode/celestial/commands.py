"""The commands ``tumble`` and ``wobble``."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from polhode.celestial.tumbling import options as tumbling
from polhode.cli.commands.application import AsJson


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
    from polhode.celestial.tumbling.command import TumbleOptions, run_list, run_tumble

    if list_bodies:
        run_list(json)
        return
    run_tumble(body, TumbleOptions(precession, rotation, moments, semi_axes, axis, mode, diameter, density, rigidity,
                                   shape_factor, aspect, phase, figures, out), json)


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
    from polhode.celestial.wobble.command import WobbleOptions, run_wobble

    run_wobble(file, WobbleOptions(start, end, window, figures, out), json)
