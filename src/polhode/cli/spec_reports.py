"""Reports on specs, taken from the cache or computed now; errors name the file."""

from __future__ import annotations

from pathlib import Path

from polhode.cli.kept import kept_report
from polhode.kinds.base import Spec, motion_report_of
from polhode.reports.base import MotionReport, SystemReport
from polhode.studies.naming import naming


def report_of(path: Path, spec: Spec) -> SystemReport:
    """Return the report on a spec; what it refuses names the file."""
    with naming(path):
        return kept_report(spec)


def moving_report_of(path: Path, spec: Spec) -> MotionReport:
    """Return the report on a spec that has a motion; one without is refused before anything is computed."""
    with naming(path):
        spec.kind.check_motion()
    return motion_report_of(report_of(path, spec))


def shown_report_of(path: Path, spec: Spec) -> SystemReport:
    """Return the report on a spec that has a page; one without is refused before anything is computed."""
    with naming(path):
        spec.kind.check_page()
    return report_of(path, spec)
