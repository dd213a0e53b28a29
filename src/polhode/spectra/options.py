"""Options of ``polhode levels`` and ``polhode lines``."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from polhode.cli.arguments import real_number, whole_number

MoleculeFile = Annotated[
    Path,
    typer.Argument(metavar="FILE",
                   help="Spec in TOML, of any kind with a molecule, or atoms: .xyz, or others by the extra molecules."),
]
LargestJ = Annotated[
    int | None,
    typer.Option("--j-max", metavar="J", parser=whole_number(0, 1000), help="The largest J (default: the spec's own)."),
]
SpectrumFile = Annotated[
    Path | None, typer.Option("--out", metavar="FILE.nc", help="Also write them as NetCDF, with units.")
]
Temperature = Annotated[
    str | None, typer.Option("--temperature", metavar="T", help='Like "50 K" (default: the spec\'s own, or 300 K).')
]
Lowest = Annotated[str | None, typer.Option("--from", metavar="FREQUENCY", help='Like "80 GHz" or "10 cm^-1".')]
Highest = Annotated[str | None, typer.Option("--to", metavar="FREQUENCY", help="The same.")]
SmallestIntensity = Annotated[
    float | None,
    typer.Option("--min-intensity", metavar="I", parser=real_number, help="Of the lines, in nm² MHz, like 1e-5."),
]
Strongest = Annotated[
    int,
    typer.Option("--most", metavar="N", parser=whole_number(1, 10**7),
                 help="How many, the strongest of them."),
]
Dipole = Annotated[
    str | None, typer.Option("--dipole", metavar="D,D,D", help="Along a, b, c in debye, in place of the spec's.")
]
