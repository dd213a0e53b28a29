"""``polhode wobble``: the Chandler wobble from measured polar motion."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import NamedTuple

from polhode.cli.destinations import check_spares
from polhode.cli.render import as_json, print_report
from polhode.errors import InvalidInput, shown
from polhode.estimation.euler_periods import euler_chain
from polhode.estimation.excitation import polar_excitation
from polhode.estimation.polar_motion import chandler_fit
from polhode.estimation.pole_series import DAY, YEAR
from polhode.estimation.wobble_process import chandler_process
from polhode.estimation.wobble_windows import chandler_windows, pole_spectrum
from polhode.formats.numerals import read_number
from polhode.formats.polar_motion import PoleSeries, date_of, day_of, read_polar_motion
from polhode.reports.answer import units_of, values_of
from polhode.reports.base import plain
from polhode.reports.wobble import Wobble, wobble_groups, wobble_notes, wobble_summary


class WobbleOptions(NamedTuple):
    """The options of the command as they are given; None where they are not."""

    start: str | None = None
    end: str | None = None
    window: str | None = None
    figures: Path | None = None
    out: Path | None = None


def run_wobble(path: Path | None, options: WobbleOptions, json: bool) -> None:
    """Estimate the wobble, print what is found, and write data and figures where asked for."""
    start = None if options.start is None else day_of(options.start, "--from")
    end = None if options.end is None else day_of(options.end, "--to")
    if start is not None and end is not None and start >= end:
        raise InvalidInput(f"--from must be before --to; got {options.start} and {options.end}. Swap them.")
    window = _window(options.window)
    if options.out is not None and path is not None:
        check_spares(options.out, path)
    series = _between(read_polar_motion(path), start, end)
    found = _found(series, window)
    groups, notes = wobble_groups(found), wobble_notes(found)
    files = _written(found, options)
    if json:
        told = {"name": series.source, **values_of(groups), "units": units_of(groups)}
        print(as_json(plain({**told, "notes": notes, "files": files})))
        return
    print_report(series.source, wobble_summary(found), groups, notes, files)


def _window(text: str | None) -> float:
    try:
        return (6.0 if text is None else read_number(text)) * YEAR
    except ValueError:
        raise InvalidInput(f"--window must be a number of years, like 6; got {shown(text)}.") from None


def _between(series: PoleSeries, start: float | None, end: float | None) -> PoleSeries:
    inside = (series.days >= (-1.0 if start is None else start)) & (series.days < (1e9 if end is None else end))
    if not inside.any():
        raise InvalidInput(f"nothing of {series.source} stands between --from and --to: it has days from "
                           f"{date_of(float(series.days[0]))} to {date_of(float(series.days[-1]))}. Choose among these."
                           )  # fmt: skip
    names = ("days", "x", "y", "x_error", "y_error")
    return replace(series, **{name: getattr(series, name)[inside] for name in names})


def _found(series: PoleSeries, window: float) -> Wobble:
    pole = (series.days * DAY, series.x, series.y)
    line = chandler_fit(*pole)
    process = chandler_process(*pole)
    period, quality = (float(value) for value in process.estimate.value)
    return Wobble(series, line, process, chandler_windows(*pole, window, float(line.estimate.value[0])),
                  polar_excitation(*pole, period, quality), pole_spectrum(*pole), euler_chain())  # fmt: skip


def _written(found: Wobble, options: WobbleOptions) -> list[str]:
    files = []
    if options.out is not None:
        from polhode.formats.wobble_dataset import write_wobble

        written = write_wobble(found.windows, found.process, found.excitation, found.series.source, options.out)
        files.append(str(written))
    if options.figures is not None:
        from polhode.figures.style import save
        from polhode.figures.wobble_figure import wobble_figures
        from polhode.formats.paths import written_together

        with written_together(options.figures) as draft:
            for name, figure in wobble_figures(found).items():
                save(figure, draft / f"{name}.png")
                files.append(str(options.figures / f"{name}.png"))
    return files
