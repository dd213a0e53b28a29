"""Reports on specs, taken from the cache or computed now; errors name the file."""

from __future__ import annotations

from pathlib import Path

from polhode.cli.kept import load_or_make_report
from polhode.cli.terminal import say_if_long
from polhode.kinds.base import Spec, require_motion_report
from polhode.reports.base import MotionReport, SystemReport
from polhode.studies.naming import name_file_in_errors


def make_report(path: Path, spec: Spec) -> SystemReport:
    """Return the report on a spec; errors name the file."""
    long = 20.0  # s; a run says how long it takes as soon as this is known, which with many switchings is late
    with name_file_in_errors(path), say_if_long("the report is still being computed", long):
        return load_or_make_report(spec)


def make_motion_report(path: Path, spec: Spec) -> MotionReport:
    """Return the report on a spec that has a motion; one without is refused before anything is computed."""
    with name_file_in_errors(path):
        spec.kind.check_motion()
    return require_motion_report(make_report(path, spec))


def make_page_report(path: Path, spec: Spec) -> SystemReport:
    """Return the report on a spec that has a page; one without is refused before anything is computed."""
    with name_file_in_errors(path):
        spec.kind.check_page()
    return make_report(path, spec)
