"""Requests to ``polhode.fit``, and the branches that answer them, one for each sort of files.

A wing offers a branch under [fits] of its ``plugin.toml``, another package in the entry-point group ``polhode.fits``.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from polhode._base.plugins import FAILURES, find_entry_points, load_entry_point
from polhode._base.plugins.wings import wing_points
from polhode.errors import InvalidInput, PolhodeError, one_line, shown
from polhode.reports.report import StudyReport
from polhode.studies.tables import TableMapping

GROUP = "polhode.fits"
Progress = Callable[[Path], Callable[[int], None] | None]
"""Returns the function that is called with the number of lines read of a file."""


class FitOptions(NamedTuple):
    """Options of ``fit`` besides its files, None or empty where they are not given. See there."""

    windows: Sequence[str | tuple[float, float]] = ()
    drag: bool | None = None
    torque: bool | None = None
    rotor: bool | None = None
    gain: bool | None = None
    clip: str | float | None = None
    moment: str | None = None
    mass: str | None = None
    added_weight: str | None = None
    weighted: Sequence[Path] = ()
    table: TableMapping | None = None
    unit: str | None = None

    @property
    def given(self) -> list[str]:
        """The names of the given options, without those for columns."""
        values = self._replace(table=None, unit=None)._asdict()
        return [name for name, value in values.items() if value is not None and len(np.atleast_1d(value))]

    @property
    def with_columns(self) -> list[str]:
        """The names of the given options; those for columns are together the last one, ``columns``."""
        return [*self.given, *(["columns"] if self.table is not None or self.unit is not None else [])]


class FitRequest(NamedTuple):
    """A request to ``fit``.

    Attributes:
        files: one or more.
        free: names of the fitted quantities; None where they are not given.
        options: the other ones.
        progress: called with the number of lines read of a file; may be None.
        pendulum: whether the file has periods of a pendulum.
    """

    files: Sequence[Path]
    free: Sequence[str] | None
    options: FitOptions
    progress: Progress | None = None
    pendulum: bool = False


@dataclass(frozen=True)
class FitBranch:
    """A model that ``fit`` fits to files of one sort. Its module is cheap to import: functions import what they need.

    Attributes:
        knows: whether files are of this sort; it is quick, and says yes only where they can be nothing else. None for
            the one branch that takes all other files.
        fit: returns the report, and refuses options that are not for these files.
    """

    knows: Callable[[FitRequest], bool] | None
    fit: Callable[[FitRequest], StudyReport]


def fit_request(request: FitRequest) -> StudyReport:
    """Return the report of the branch that knows the files: one of a wing, then one of another package.

    Raises:
        InvalidInput: for files that no branch takes, and as the branch does.
    """
    own = [point.load() for point in wing_points(GROUP).values()]
    for branch in own:
        if branch.knows is not None and branch.knows(request):
            return branch.fit(request)
    for name, point in _others().items():
        report = _ask_others(name, point, request)
        if report is not None:
            return report
    rest = next((branch for branch in own if branch.knows is None), None)
    if rest is None:
        raise InvalidInput(f"{request.files[0]}: is of no sort that can be fitted. Check the file.")
    return rest.fit(request)


def _ask_others(name: str, point: Any, request: FitRequest) -> StudyReport | None:
    """Return the report of a branch of another package, None where the files are not of its sort."""
    branch, of_others = load_entry_point(point), f"the fit {name} of another package"
    if not isinstance(branch, FitBranch) or branch.knows is None:
        raise InvalidInput(f"{of_others}, {point.value}, is not a FitBranch that knows its files. Update it.")
    try:
        knows = branch.knows(request)
        report = branch.fit(request) if knows else None
    except PolhodeError:
        raise
    except FAILURES as error:
        what = f"{type(error).__name__}: {one_line(str(error))}"
        raise InvalidInput(f"{request.files[0]}: {of_others} fails ({what}). Update or remove it.") from error
    if not (isinstance(report, StudyReport) or (report is None and not knows)):
        raise InvalidInput(f"{request.files[0]}: {of_others} gives {shown(report)}, not a StudyReport. Update it.")
    return report


@cache
def _others() -> dict[str, Any]:
    """Return entry points by name, in the order of the names."""
    return dict(sorted(find_entry_points(GROUP, wing_points(GROUP)).items()))
