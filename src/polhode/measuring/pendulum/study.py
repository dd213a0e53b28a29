"""From a file of a pendulum's periods to a report on the inertia of the body that hung on it."""

from __future__ import annotations

from pathlib import Path

from polhode.measuring.pendulum.fitting import fit_pendulum
from polhode.measuring.pendulum.report import PendulumReport
from polhode.measuring.pendulum.swings import read_swings
from polhode.studies.naming import name_file_in_errors


def fit_periods(path: Path) -> PendulumReport:
    """Return the report on a body's moments of inertia from the periods in a file.

    Raises:
        InvalidInput: for mistakes in the file, and for swings that no body makes.
        FormatError: if the file is not TOML.
    """
    measured = read_swings(path)
    with name_file_in_errors(path):
        fit = fit_pendulum(measured.swings, measured.mass, measured.gravity)
    return PendulumReport(measured, fit)
