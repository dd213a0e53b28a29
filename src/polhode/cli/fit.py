"""``polhode fit FILE…``: the inertia of a body from gyro logs or a pendulum, or a molecule's constants from lines."""

from __future__ import annotations

import sys
from collections.abc import Callable
from pathlib import Path

import typer

from polhode.cli.column_options import ColumnOptions
from polhode.cli.columns import table_to_import
from polhode.cli.destinations import check_spares
from polhode.cli.publish import NOT_DETERMINED, publish
from polhode.cli.terminal import say_if_long
from polhode.studies.fit import fit_files
from polhode.studies.fit_request import FitOptions


def run_fit(
    files: list[Path], free: str | None, options: FitOptions, columns: ColumnOptions, out: Path | None,
    figures: Path | None, json: bool, pendulum: bool = False,
) -> None:
    """Fit the files, print the report, and write data and figures where asked for.

    Raises:
        typer.Exit: with code 3 where the report says that the inertia is not determined.
    """
    if out is not None:
        for path in (*files, *options.weighted):
            check_spares(out, path)
    # alone it is the unit of a known app's table, of which the rest is known
    unit = columns.unit if columns.mapping is None and columns.words.keys() == {"unit"} else None
    options = options._replace(table=None if unit else table_to_import(columns), unit=unit)

    with say_if_long("several models are fitted, which takes up to some minutes for long logs"):
        report = fit_files(files, None if free is None else free.split(","), options, _progress, pendulum)
    publish(report, json, out, figures)
    if not report.determined:
        raise typer.Exit(NOT_DETERMINED)


def _progress(path: Path) -> Callable[[int], None]:
    """Return a function that shows how far the reading of a file is; short files show nothing."""
    interval = 1_000_000  # lines, after which progress is shown
    last = 0

    def tell(line: int) -> None:
        nonlocal last
        if line - last >= interval:
            last = line
            print(f"{path.name}: {line} lines read", file=sys.stderr, flush=True)

    return tell
