"""``polhode fit LOG`` of a log of attitudes: tables with a quaternion or Euler angles, AEMs, C-kernels, datasets."""

from __future__ import annotations

from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from polhode.cli.columns import Table
from polhode.cli.destinations import check_spares
from polhode.cli.fit_scale import KnownScale
from polhode.cli.publish import publish
from polhode.cli.sources import Kernels, kind_of, source_of
from polhode.errors import InvalidInput
from polhode.estimation.attitude_fit import AttitudeFit, fit_attitude
from polhode.estimation.flight import Window
from polhode.formats.log_archives import is_archive
from polhode.reports.report import Report
from polhode.reports.throw import attitude_groups, attitude_notes, attitude_summary

KINDS = ("aem", "ck", "dataset", "csv")


def has_attitude(path: Path, table: Table | None) -> bool:
    """Whether a file is a log of attitudes, by its content or by what is said of its columns."""
    if table is not None and table.mapping.attitude:
        return True
    return path.is_file() and not is_archive(path) and kind_of(path, table) in KINDS


class AttitudeOptions(NamedTuple):
    """Windows [s], whether there is a torque, and where figures and data go."""

    windows: list[Window]
    torque: bool | str
    figures: Path | None
    out: Path | None


def run_fit_attitude(
    path: Path, table: Table | None, options: AttitudeOptions, known: KnownScale, json: bool
) -> bool:
    """Fit the attitudes and the rates that are with them, print what they say, and draw figures where asked for.

    Returns:
        Whether they tell the inertia.
    """
    if options.out is not None:
        check_spares(options.out, path)
    trajectory = source_of(path, Kernels(), table).trajectory
    times, attitude = np.asarray(trajectory.times), np.asarray(trajectory.attitude)
    rates = None if trajectory.angular_velocity is None else np.asarray(trajectory.angular_velocity)
    windows = options.windows
    if len(windows) > 1:
        raise InvalidInput(f"--window must be given once at most for a log of attitudes; got {len(windows)}.")
    for window in windows:
        inside = (times >= window.start) & (times <= window.end)
        times, attitude, rates = times[inside], attitude[inside], None if rates is None else rates[inside]
    try:
        fit = fit_attitude(times, attitude, rates, options.torque)
    except InvalidInput as error:
        raise InvalidInput(f"{path}: {error}") from None
    publish(_report(path.name, fit, known), json, options.out, options.figures)
    return fit.degenerate is None


def _report(name: str, fit: AttitudeFit, known: KnownScale) -> Report:
    def draw() -> dict[str, Any]:
        from polhode.figures.throw_figure import attitude_figures

        return attitude_figures(fit)

    def write(path: Path) -> Path:
        from polhode.formats.throw_dataset import write_attitude_fit

        return write_attitude_fit(fit, name, path)

    groups = attitude_groups(fit, known.moments(fit, None))
    return Report(name, "attitude fit", attitude_summary(fit), groups, attitude_notes(fit), draw, write,
                  fit.degenerate is None)  # fmt: skip
