"""Which report a spec asks for."""

from __future__ import annotations

import numpy as np

from polhode.report.base import AbstractReport
from polhode.report.damped_body import damped_body_report
from polhode.report.free_body import free_body_report
from polhode.report.gyrostat import gyrostat_report
from polhode.report.tops import heavy_top_report, lagrange_top_report
from polhode.spec.reading import Spec
from polhode.spec.systems import DampedBodyTable, GyrostatTable, HeavyTopTable, LagrangeTopTable


def report_of(spec: Spec) -> AbstractReport:
    """Return the report on the system of a spec.

    Raises:
        InvalidInput: for values that the system refuses.
        NotConverged: where a motion could not be followed.
    """
    times = None if spec.until is None else np.linspace(0.0, spec.until, spec.samples)
    system = spec.system
    if isinstance(system, HeavyTopTable):
        return heavy_top_report(spec, system, times)
    if isinstance(system, LagrangeTopTable):
        return lagrange_top_report(spec, system, times)
    if isinstance(system, GyrostatTable):
        return gyrostat_report(spec, system, times)
    if isinstance(system, DampedBodyTable):
        return damped_body_report(spec, system, times)
    assert spec.body is not None
    momentum, attitude = spec.start(spec.body.principal_moments, spec.body.principal_axes)
    return free_body_report(spec.body, momentum, attitude, times, spec.samples)
