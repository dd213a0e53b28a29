"""Options that several commands share: the clocks of two files, and kernels for a C-kernel."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, NamedTuple

import typer

from polhode.cli.arguments import whole_number

ClockOffset = Annotated[
    str | None,
    typer.Option("--offset", metavar="TIME",
                 help="A's time at B's time zero, like -68.5s; or start: both begin at the same moment."),
]
AlignClock = Annotated[
    bool,
    typer.Option("--align-clock",
                 help="Find the offset of the clocks from the attitudes; of several, the nearest to --offset."),
]
ClockKernel = Annotated[
    Path | None, typer.Option("--sclk", metavar="FILE", help="Clock kernel of a C-kernel (default: next to it, .tsc).")
]
FrameKernel = Annotated[
    Path | None, typer.Option("--fk", metavar="FILE", help="Frame kernel of a C-kernel (default: next to it, .tf).")
]
LeapSeconds = Annotated[
    Path | None, typer.Option("--lsk", metavar="FILE", help="Leap-seconds kernel (default: next to it, .tls, or ours).")
]
SpiceId = Annotated[
    int | None,
    typer.Option("--spice-id", metavar="N", parser=whole_number(-(2**31), 2**31 - 1),
                 help="Whose attitude, of several in a kernel."),
]


class KernelOptions(NamedTuple):
    """Options for a C-kernel, each None where it is not given."""

    sclk: ClockKernel = None
    fk: FrameKernel = None
    lsk: LeapSeconds = None
    spice_id: SpiceId = None
