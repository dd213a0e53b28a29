"""The plain answers about a heavy top: any body about a fixed point, by splitting into exact flows."""

from __future__ import annotations

import warnings
from dataclasses import dataclass, replace
from typing import ClassVar

import numpy as np

from polhode import rotation
from polhode.kinds.base import Spec
from polhode.kinds.heavy_top.table import HeavyTopTable
from polhode.motion.layout import Quantity
from polhode.motion.trajectory import Trajectory
from polhode.reports.length import check_length, equal_steps, splitting_step
from polhode.reports.top import TopReport, frame_of, leaned, natural_period, rest_verdicts, top_of
from polhode.simulation import fastest_rate, simulate

PERIODS = 10
NAMES = {"|P|²": "|Γ|²", "Π·P": "vertical_momentum"}  # the Casimirs of se(3)*, called by what they are here
QUANTITIES = {
    "|Γ|²": Quantity("1", "squared length of the upward direction"),
    "vertical_momentum": Quantity("kg m2 s-1", "angular momentum about the vertical"),
}


@dataclass(frozen=True)
class HeavyTopReport(TopReport):
    """A top of any shape, integrated."""

    kind: ClassVar[str] = "heavy-top"


def report_of(spec: Spec) -> HeavyTopReport:
    """Return the report on any body about a fixed point, by splitting into exact flows.

    Raises:
        InvalidInput: for a body without mass.
    """
    table, body, times = spec.system, spec.body, spec.times
    assert isinstance(table, HeavyTopTable) and body is not None
    top, free = top_of(body, table.pivot, table.gravity)
    momentum, attitude = spec.start(np.asarray(top.moments), np.asarray(top.axes))
    attitude = leaned(top, attitude, table.lean)
    state = top.pack(rotation.multiply(attitude, rotation.conjugate(rotation.from_matrix(np.asarray(top.axes)))),
                      momentum=np.asarray(top.axes) @ momentum)  # fmt: skip
    if times is None:
        times = np.linspace(0.0, PERIODS * natural_period(top, momentum), spec.samples)
    rate, span = fastest_rate(top, state), float(np.ptp(times))
    check_length(spec.until, times, equal_steps(span, rate, table.step, table.order), splitting_step(table.order),
                 'A longer `system.step` takes less, and kind = "lagrange-top" none, if it is one.')  # fmt: skip
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always", UserWarning)
        trajectory = _called(simulate(top, state, times, step=table.step, order=table.order))
    trajectory = replace(trajectory, frame=frame_of(top, body, table.pivot))
    warned = tuple(str(warning.message) for warning in caught)
    return HeavyTopReport(
        body, spec.surface, top, np.asarray(table.pivot), trajectory, rest_verdicts(top, momentum), free, warned
    )


def _called(trajectory: Trajectory) -> Trajectory:
    """Return the trajectory with its invariants called by what they are for a top."""
    rename = lambda values: {NAMES.get(k, k): v for k, v in values.items() if k != "linear_space"}  # noqa: E731
    return replace(
        trajectory, invariants=rename(trajectory.invariants), drift=rename(trajectory.drift),
        quantities=trajectory.quantities | QUANTITIES,
    )  # fmt: skip
