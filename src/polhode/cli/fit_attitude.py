"""``polhode fit LOG`` of a log of attitudes: tables with a quaternion or Euler angles, AEMs, C-kernels, datasets."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from polhode.cli.columns import Table
from polhode.cli.fit_scale import KnownScale
from polhode.cli.render import as_json, print_report
from polhode.cli.sources import Kernels, kind_of, source_of
from polhode.errors import InvalidInput
from polhode.estimation.attitude_fit import fit_attitude
from polhode.estimation.flight import Window
from polhode.reports.answer import units_of, values_of
from polhode.reports.base import plain
from polhode.reports.throw import attitude_groups, attitude_summary

KINDS = ("aem", "ck", "dataset", "csv")


def has_attitude(path: Path, table: Table | None) -> bool:
    """Whether a file is a log of attitudes, by its content or by what is said of its columns."""
    if table is not None and table.mapping.attitude:
        return True
    return path.is_file() and kind_of(path, table) in KINDS


def run_fit_attitude(path: Path, table: Table | None, windows: list[Window], known: KnownScale, json: bool) -> None:
    """Fit the attitudes, and print what they say."""
    trajectory = source_of(path, Kernels(), table).trajectory
    times, attitude = np.asarray(trajectory.times), np.asarray(trajectory.attitude)
    if len(windows) > 1:
        raise InvalidInput(f"--window must be given once at most for a log of attitudes; got {len(windows)}.")
    for window in windows:
        inside = (times >= window.start) & (times <= window.end)
        times, attitude = times[inside], attitude[inside]
    try:
        fit = fit_attitude(times, attitude)
    except InvalidInput as error:
        raise InvalidInput(f"{path}: {error}") from None
    groups = attitude_groups(fit, known.moments(fit, None))
    if json:
        told = {"name": path.name, **values_of(groups), "units": units_of(groups)}
        print(as_json(plain({**told, "notes": [], "files": []})))
        return
    print_report(path.name, attitude_summary(fit), groups, [], [])
