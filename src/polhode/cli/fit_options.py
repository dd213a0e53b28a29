"""Options of ``polhode fit``, besides those of columns, which other commands have too."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, NamedTuple

import typer

FitFiles = Annotated[
    list[Path],
    typer.Argument(metavar="LOG… | SPEC LINES | PERIODS", help="Gyro logs of throws (CSV, a folder, a zip), or a log "
                   "of the attitude; or a molecule by a spec or atoms, and its measured lines, a .lin file; or with "
                   "--pendulum a TOML file of a pendulum's periods."),
]
Pendulum = Annotated[
    bool, typer.Option("--pendulum", help="The file has periods of a bifilar, trifilar or compound pendulum.")
]
FreeNames = Annotated[
    str | None,
    typer.Option("--free", metavar="NAMES",
                 help="Of a molecule: like A,B,C,D_J (default: those of the spec that lines depend on)."),
]
FitOut = Annotated[
    Path | None,
    typer.Option("--out", metavar="FILE",
                 help="Of logs: dataset, .nc; of a molecule: constants, .par, or .var with correlations."),
]
FitFigures = Annotated[
    Path | None, typer.Option("--figures", metavar="DIR", help="Of logs: folder to draw figures into.")
]
FitWindows = Annotated[
    list[str] | None,
    typer.Option("--window", metavar="START,END",
                 help="Of logs: free flight [s], like 1.2,1.9, in place of the detected one; once for each throw."),
]
WithDrag = Annotated[
    bool | None, typer.Option("--drag/--no-drag", help="Of logs: drag or none (default: by a criterion).")
]
WithRotor = Annotated[
    bool | None,
    typer.Option("--rotor/--no-rotor", help="Of logs: a wheel that turns in the body, or none (default: by a "
                 "criterion)."),
]
WithTorque = Annotated[
    bool | None,
    typer.Option("--torque/--no-torque", help="Of a log of attitudes: a constant torque in the body, or none "
                 "(default: by a criterion)."),
]
WithGain = Annotated[
    bool | None, typer.Option("--gain/--no-gain", help="Of logs: gains of the axes or none (default: gains).")
]
ClipRate = Annotated[
    str | None, typer.Option("--clip", metavar="RATE", help='Of logs: the gyro\'s limit, like "2000 deg/s".')
]
OneMoment = Annotated[
    str | None,
    typer.Option("--moment", metavar="MOMENT", help='Of logs: one that is known, like "I3 = 1.2e-4 kg m^2".'),
]
WeightedLogs = Annotated[
    list[Path] | None,
    typer.Option("--weighted", metavar="LOG", help="Log of throws with the added weight; may be given several times."),
]
BodyMass = Annotated[
    str | None, typer.Option("--mass", metavar="MASS", help='Of the body without the weight, like "150 g".')
]
AddedWeight = Annotated[
    str | None,
    typer.Option("--added-weight", metavar="WEIGHT",
                 help='Like "20 g at 0, 70, 0 mm", from the body\'s centre of mass along the device\'s axes.'),
]


class ThrowOptions(NamedTuple):
    """Options of ``fit`` for logs of throws, each None where it is not given."""

    window: FitWindows = None
    drag: WithDrag = None
    torque: WithTorque = None
    rotor: WithRotor = None
    gain: WithGain = None
    clip: ClipRate = None
    moment: OneMoment = None
    mass: BodyMass = None
    added_weight: AddedWeight = None
    weighted: WeightedLogs = None
