"""Options of ``polhode tumble``."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from polhode.cli.arguments import real_number

Body = Annotated[
    str | None,
    typer.Argument(metavar="BODY", show_default=False, help="A known tumbler, like apophis; --list shows them."),
]
ListBodies = Annotated[bool, typer.Option("--list", help="Print the known tumblers with their sources.")]
Precession = Annotated[
    str | None,
    typer.Option("--precession", metavar="TIME", help='Mean period of an axis about L, like "27.38 ± 0.07 h".'),
]
Rotation = Annotated[
    str | None,
    typer.Option("--rotation", metavar="TIME", help='Period of the motion along the body\'s axes, like "263 ± 6 h".'),
]
Moments = Annotated[
    tuple[str, str, str] | None,
    typer.Option("--moments", metavar="I1 I2 I3", help='Principal moments in any unit; "0.61 ± 0.03" with an error.'),
]
SemiAxes = Annotated[
    tuple[float, float, float] | None,
    typer.Option("--semi-axes", metavar="A B C", help="Of a uniform ellipsoid, in place of --moments."),
]
Axis = Annotated[
    str | None,
    typer.Option("--axis", metavar="AXIS", help="Whose precession: encircled (default; long in the long-axis mode, "
                 "short in the short-axis mode), long, or short."),
]
Mode = Annotated[
    str | None,
    typer.Option("--mode", metavar="MODE", help="short-axis or long-axis (default: the one of least energy)."),
]
Diameter = Annotated[
    str | None,
    typer.Option("--diameter", metavar="LENGTH", help='Mean, like "340 m", for the damping by internal friction.'),
]
Density = Annotated[
    str | None, typer.Option("--density", metavar="DENSITY", help="For the damping (default: 2000 kg/m^3).")
]
Rigidity = Annotated[
    str | None,
    typer.Option("--rigidity", metavar="PRESSURE", help="μQ, shear modulus times quality factor (default: 5e11 Pa)."),
]
ShapeFactor = Annotated[
    float | None,
    typer.Option("--shape-factor", metavar="K2", parser=real_number,
                 help="K₃² of the damping, .01 round to .1 long (default: .03)."),
]
Aspect = Annotated[
    str | None,
    typer.Option("--aspect", metavar="ANGLE", help="Between L and the observer, of the light curve (default: 60 deg)."),
]
Phase = Annotated[
    str | None,
    typer.Option("--phase", metavar="ANGLE", help="Between Sun and observer, across L (default: 20 deg)."),
]
Figures = Annotated[Path | None, typer.Option("--figures", metavar="DIR", help="Folder to draw figures into.")]
Out = Annotated[
    Path | None,
    typer.Option("--out", metavar="FILE", help="Light curve as .csv, or a spec of the motion as .toml."),
]
