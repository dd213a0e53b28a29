"""``polhode wobble``: the Chandler wobble from measured polar motion."""

from __future__ import annotations

from pathlib import Path
from typing import NamedTuple

import typer

from polhode.celestial.wobble.study import wobble_report
from polhode.cli.destinations import check_spares
from polhode.cli.publish import NOT_DETERMINED, publish
from polhode.errors import InvalidInput, shown
from polhode.formats.numerals import read_number


class WobbleOptions(NamedTuple):
    """The options of the command as they are given; None where they are not."""

    start: str | None = None
    end: str | None = None
    window: str | None = None
    figures: Path | None = None
    out: Path | None = None


def run_wobble(path: Path | None, options: WobbleOptions, json: bool) -> None:
    """Estimate the wobble, print the results, and write data and figures where asked for.

    Raises:
        typer.Exit: with code 3 where something else moves the pole, so that nothing has a known error.
    """
    if options.out is not None and path is not None:
        check_spares(options.out, path)
    try:
        window = 6.0 if options.window is None else read_number(options.window)
    except ValueError:
        raise InvalidInput(f"--window must be a number of years, like 6; got {shown(options.window)}.") from None
    report = wobble_report(path, options.start, options.end, window)
    publish(report, json, options.out, options.figures)
    if not report.determined:
        raise typer.Exit(NOT_DETERMINED)
