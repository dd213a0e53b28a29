"""From gyro logs of throws, or a log of attitudes, to a report on the inertia of the body."""

from __future__ import annotations

import math
from collections.abc import Sequence
from pathlib import Path

import numpy as np

from polhode._base import check
from polhode.errors import InvalidInput, shown
from polhode.formats.form import Kernels
from polhode.formats.form_registry import find_form
from polhode.formats.numerals import read_number
from polhode.measuring.attitudes.attitude_fit import fit_attitude
from polhode.measuring.attitudes.report import AttitudeReport
from polhode.measuring.scaling import read_scale
from polhode.measuring.throws._saturation import saturation
from polhode.measuring.throws.flight import LIMITS as FLIGHT_LIMITS
from polhode.measuring.throws.flight import Flights, Window, find_flights
from polhode.measuring.throws.gyro_logs import ReadLog, read_gyro_log
from polhode.measuring.throws.left_out import left_out_words
from polhode.measuring.throws.log_archives import is_archive
from polhode.measuring.throws.report import ThrowReport
from polhode.measuring.throws.throw import ThrowFit, fit_throw
from polhode.spec.uncertain import quantity
from polhode.studies.fit_request import FitOptions, Progress
from polhode.studies.naming import name_arguments
from polhode.studies.sources import detect_kind, load_source
from polhode.studies.tables import TableMapping


def fit_logs(
    paths: Sequence[Path], options: FitOptions, progress: Progress | None = None
) -> ThrowReport | AttitudeReport:
    """Return the report on logs of throws, fitted together, or on a log of attitudes.

    Args:
        paths: of the logs.
        options: for the logs.
        progress: called with how far the reading of a log is.

    Raises:
        InvalidInput: for what cannot be read or fitted, and for options that are of the other kind of log.
    """
    every = [*paths, *options.weighted]
    there = [path for path in every if path.exists()]
    if twice := [path for k, path in enumerate(there) if any(map(path.samefile, there[:k]))]:
        raise InvalidInput(f"{twice[0]}: is given twice, and a log counts once. Leave it out.")
    kind = _attitude_kind(paths[0], options.table)
    if kind is None:
        return _fit_throws(paths, options, progress)
    wrong = [name for name in options.given if name not in ("windows", "torque", "moment", "mass", "added_weight")]
    if options.unit is not None:
        wrong.append("unit")
    if wrong or len(paths) > 1:
        are = "is" if len(wrong) == 1 else "are"
        what = f"{name_arguments(wrong)} {are} for gyro logs" if wrong else f"got {len(paths)} logs"
        raise InvalidInput(f"{paths[0]}: is a log of attitudes, which is fitted alone, and {what}. Leave it out.")
    return _fit_attitudes(paths[0], kind, options)


def _attitude_kind(path: Path, table: TableMapping | None) -> str | None:
    """Return the form of a log of attitudes, by its content or its mapping; None for other files."""
    if table is not None and table.mapping.attitude:
        return detect_kind(path, table)
    if not path.is_file() or is_archive(path):
        return None
    kind = detect_kind(path, table)
    return None if find_form(kind) is None else kind


def _fit_attitudes(path: Path, kind: str, options: FitOptions) -> AttitudeReport:
    windows = [_window(span) for span in options.windows]
    if len(windows) > 1:
        raise InvalidInput(f"`windows` must be given once at most for a log of attitudes; got "
                           f"{len(windows)}.")
    known = read_scale(options.moment, options.mass, options.added_weight, bool(options.weighted))
    trajectory = load_source(path, Kernels(), options.table, kind).trajectory
    times, attitude = np.asarray(trajectory.times), np.asarray(trajectory.attitude)
    rates = None if trajectory.angular_velocity is None else np.asarray(trajectory.angular_velocity)
    for window in windows:
        inside = (times >= window.start) & (times <= window.end)
        times, attitude, rates = times[inside], attitude[inside], None if rates is None else rates[inside]
    try:
        fit = fit_attitude(times, attitude, rates, "auto" if options.torque is None else options.torque)
    except InvalidInput as error:
        raise InvalidInput(f"{path}: {error}") from None
    return AttitudeReport(path.name, fit, known.moments(fit, None))


def _fit_throws(paths: Sequence[Path], options: FitOptions, progress: Progress | None) -> ThrowReport:
    if options.torque is not None:
        raise InvalidInput(f"{paths[0]}: `torque` is for a log of attitudes, and this is a gyro's. Leave it out.")
    known = read_scale(options.moment, options.mass, options.added_weight, bool(options.weighted))

    def read(path: Path) -> ReadLog:
        mapping = None if options.table is None else options.table.mapping
        return read_gyro_log(path, mapping, None if progress is None else progress(path), options.unit)

    logs = [read(path) for path in paths]
    names = [path.name or str(path) for path in paths]
    clip = options.clip
    if clip is None:
        clip = saturation([each.log for each in logs])
    elif isinstance(clip, str):
        clip = quantity("`clip`", clip, "rad/s")
    else:
        clip = check.number("clip", clip, "rad/s", above=0, infinite=True)
    flights = _flights(options.windows, names, logs, clip)

    def fit(some: Sequence[ReadLog], windows: Sequence[Sequence[Window]] | None, limit: float | None) -> ThrowFit:
        drag, rotor = ("auto" if asked is None else asked for asked in (options.drag, options.rotor))
        return fit_throw([each.log for each in some], windows, drag, options.gain is not False, limit, rotor=rotor)

    result = fit(logs, [each.windows for each in flights], math.inf if clip is None else clip)
    heavier = fit([read(path) for path in options.weighted], None, clip) if options.weighted else None
    return ThrowReport(result, names, logs, flights, known.moments(result, heavier))


def _flights(
    spans: Sequence[str | tuple[float, float]], names: Sequence[str], logs: Sequence[ReadLog], clip: float | None
) -> list[Flights]:
    """Return the stretches of each log to fit: the given windows, else all that ``find_flights`` detects."""
    if spans:
        return [Flights(windows, []) for windows in _windows(spans, len(logs))]
    flights = [find_flights(read.log, clip) for read in logs]
    if not any(each.windows for each in flights):
        left = left_out_words([one for each in flights for one in each.left_out])
        raise InvalidInput(f"{', '.join(names)}: has no free flight: no stretch of "
                           f"{FLIGHT_LIMITS.min_duration} s feels no weight, or keeps an angular momentum while it "
                           f"turns faster than 1 rad/s.{left} If there is one, say where by `windows=[(start, "
                           "end)]`.")
    for read, each in zip(logs, flights, strict=True):
        if not (each.windows or each.left_out):
            each.left_out.append(Window(float(read.log.times[0]), float(read.log.times[-1]), "no free flight in it"))
    return flights


def _windows(spans: Sequence[str | tuple[float, float]], logs: int) -> list[list[Window]]:
    """Return the windows of each log: all windows for a single log, otherwise one for each log."""
    windows = [_window(one) for one in spans]
    if logs == 1:
        return [windows]
    if len(windows) != logs:
        raise InvalidInput(f"`windows` must be given once for each log, in their order: {logs} logs, and "
                           f"{len(windows)} windows.")
    return [[window] for window in windows]


def _window(span: str | tuple[float, float]) -> Window:
    try:
        start, end = (read_number(part) if isinstance(part, str) else float(part)
                      for part in (span.split(",") if isinstance(span, str) else span))
    except (TypeError, ValueError):
        raise InvalidInput(f"`windows` must be two times in seconds with a comma, like 1.2,1.9; got "
                           f"{shown(span)}.") from None
    return Window(start, end)
