"""Which report a spec asks for."""

from __future__ import annotations

from importlib import import_module

import numpy as np

from polhode.report.base import AbstractReport
from polhode.report.free_body import free_body_report
from polhode.spec.reading import Spec

# imported only when asked for: most need JAX, which takes its time
MAKERS = {
    "heavy-top": ("tops", "heavy_top_report"),
    "lagrange-top": ("tops", "lagrange_top_report"),
    "gyrostat": ("gyrostat", "gyrostat_report"),
    "damped-body": ("damped_body", "damped_body_report"),
    "spin-orbit": ("spin_orbit", "spin_orbit_report"),
    "euler-disk": ("disk_motion", "euler_disk_report"),
}


def report_of(spec: Spec) -> AbstractReport:
    """Return the report on the system of a spec.

    Raises:
        InvalidInput: for values that the system refuses.
        NotConverged: where a motion could not be followed.
    """
    times = None if spec.until is None else np.linspace(0.0, spec.until, spec.samples)
    if spec.system is not None:
        module, maker = MAKERS[spec.system.kind]
        return getattr(import_module(f"polhode.report.{module}"), maker)(spec, spec.system, times)
    assert spec.body is not None
    momentum, attitude = spec.start(spec.body.principal_moments, spec.body.principal_axes)
    return free_body_report(spec.body, momentum, attitude, times, spec.samples)
