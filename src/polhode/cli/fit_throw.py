"""``polhode fit LOG…``: the inertia of a thrown body from the log of a gyro on it."""

from __future__ import annotations

import math
import sys
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any, NamedTuple

from polhode.cli.columns import ColumnOptions, table_to_import
from polhode.cli.destinations import check_spares
from polhode.cli.fit_attitude import AttitudeOptions, has_attitude, run_fit_attitude
from polhode.cli.fit_scale import KnownScale
from polhode.cli.publish import publish
from polhode.errors import InvalidInput, shown
from polhode.estimation.flight import SHORTEST, Flights, Window, find_flights
from polhode.estimation.saturation import saturation
from polhode.estimation.throw import ThrowFit, fit_throw
from polhode.formats.gyro_logs import ReadLog, read_gyro_log
from polhode.formats.numerals import read_number
from polhode.reports.answer import Group, Table
from polhode.reports.flights import left_out_note, left_out_table, left_out_words
from polhode.reports.report import Report
from polhode.reports.throw import throw_groups, throw_notes, throw_summary
from polhode.spec.uncertain import quantity

EVERY = 1_000_000  # lines, after which progress is told


class ThrowOptions(NamedTuple):
    """The options of a fit of throws, as they are given; None and empty where they are not."""

    windows: list[str]
    drag: bool | None = None
    gain: bool | None = None
    clip: str | None = None
    figures: Path | None = None
    torque: bool | None = None
    rotor: bool | None = None


def named(options: Any) -> list[str]:
    """Return the options that are given, as they are called."""
    given = [name for name, value in options._asdict().items() if value not in (None, [])]
    return [f"--{name.replace('_', '-').replace('windows', 'window')}" for name in given]


def run_fit_throw(
    paths: Sequence[Path], options: ThrowOptions, known: KnownScale, weighted: Sequence[Path], columns: ColumnOptions,
    out: Path | None, json: bool,
) -> bool:  # fmt: skip
    """Fit the logs together, print what they say, and write data and figures where asked for.

    Returns:
        Whether they tell the inertia.
    """
    # alone it is the unit of a known app's table, of which the rest is known
    unit = columns.unit if columns.mapping is None and columns.words.keys() == {"unit"} else None
    table = None if unit else table_to_import(columns)
    mapping = None if table is None else table.mapping
    if has_attitude(paths[0], table):
        table = table if unit is None else table_to_import(columns)  # which says what is missing
        wrong = named(options._replace(windows=[], figures=None, torque=None))
        wrong += ["--weighted"] if weighted else []
        if wrong or len(paths) > 1:
            what = f"{', '.join(wrong)} is for gyro logs" if wrong else f"got {len(paths)} logs"
            raise InvalidInput(f"{paths[0]}: is a log of attitudes, which is fitted alone, and {what}. Leave it out.")
        windows = [_window(text) for text in options.windows]
        asked = AttitudeOptions(windows, "auto" if options.torque is None else options.torque, options.figures, out)
        return run_fit_attitude(paths[0], table, asked, known, json)
    if options.torque is not None:
        raise InvalidInput(f"{paths[0]}: --torque and --no-torque are for a log of attitudes, and this is a gyro's. "
                           "Leave it out.")  # fmt: skip
    if out is not None:
        for path in (*paths, *weighted):
            check_spares(out, path)
    logs = [read_gyro_log(path, mapping, _progress(path), unit) for path in paths]
    names = [path.name or str(path) for path in paths]
    clip = saturation([each.log for each in logs]) if options.clip is None else quantity(
        "--clip", options.clip, "rad/s")  # fmt: skip
    flights = _flights(options.windows, names, logs, clip)
    drag: bool | str = "auto" if options.drag is None else options.drag
    rotor: bool | str = "auto" if options.rotor is None else options.rotor
    fit = fit_throw([each.log for each in logs], [each.windows for each in flights], drag, options.gain is not False,
                    math.inf if clip is None else clip, rotor=rotor)  # fmt: skip
    heavier = None
    if weighted:
        more = [read_gyro_log(path, mapping, _progress(path), unit).log for path in weighted]
        heavier = fit_throw(more, None, drag, options.gain is not False, clip, rotor=rotor)
    moments = known.moments(fit, heavier)
    groups = [*throw_groups(fit, names, logs, moments), left_out_table(names, flights)]
    notes = [*throw_notes(fit, names, logs), *left_out_note(flights)]
    publish(_report(fit, names, groups, notes), json, out, options.figures)
    return fit.degenerate is None


def _report(fit: ThrowFit, names: Sequence[str], groups: list[Group | Table], notes: list[str]) -> Report:
    def draw() -> dict[str, Any]:
        from polhode.figures.throw_figure import throw_figures

        return throw_figures(fit)

    def write(path: Path) -> Path:
        from polhode.formats.throw_dataset import write_throw

        return write_throw(fit, names, path)

    return Report(", ".join(names), "throw fit", throw_summary(fit), groups, notes, draw, write,
                  fit.degenerate is None)  # fmt: skip


def _flights(given: Sequence[str], names: Sequence[str], logs: Sequence[ReadLog], clip: float | None) -> list[Flights]:
    """Return what is fitted of each log: the windows that are given, else all flights that are found."""
    if given:
        return [Flights(windows, []) for windows in _windows(given, len(logs))]
    found = [find_flights(read.log, clip) for read in logs]
    if not any(each.windows for each in found):
        left = left_out_words([one for each in found for one in each.left_out])
        raise InvalidInput(f"{', '.join(names)}: no free flight was found: no stretch of {SHORTEST} s feels no weight, "
                           f"or keeps an angular momentum while it turns faster than 1 rad/s.{left} If there is one, "
                           "say where by --window START,END.")  # fmt: skip
    for read, each in zip(logs, found, strict=True):
        if not (each.windows or each.left_out):
            each.left_out.append(Window(float(read.log.times[0]), float(read.log.times[-1]), "no free flight in it"))
    return found


def _windows(given: Sequence[str], logs: int) -> list[list[Window]]:
    """Return the windows of each log: all are of a single log, otherwise one is for each."""
    windows = [_window(text) for text in given]
    if logs == 1:
        return [windows]
    if len(windows) != logs:
        raise InvalidInput(f"--window must be given once for each log, in their order: {logs} logs, and "
                           f"{len(windows)} windows.")  # fmt: skip
    return [[window] for window in windows]


def _window(text: str) -> Window:
    try:
        start, end = map(read_number, text.split(","))
    except ValueError:
        raise InvalidInput(f"--window must be two times in seconds with a comma, like 1.2,1.9; got {shown(text)}."
                           ) from None  # fmt: skip
    return Window(start, end)


def _progress(path: Path) -> Callable[[int], None]:
    """Return what tells a person who waits how far the reading is; files of few lines tell nothing."""
    told = 0

    def tell(line: int) -> None:
        nonlocal told
        if line - told >= EVERY:
            told = line
            print(f"{path.name}: {line} lines read", file=sys.stderr, flush=True)

    return tell
