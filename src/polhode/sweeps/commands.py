"""The command ``sweep``."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from polhode.cli.arguments import whole_number
from polhode.cli.commands.application import AsJson, SpecPath


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
    from polhode.sweeps.command import SweepOptions, run_sweep

    run_sweep(spec, SweepOptions(out, workers, scheduler, dry_run, json, no_figures))
