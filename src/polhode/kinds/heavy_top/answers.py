"""The answers about a heavy top: any body about a fixed point, by Taylor series or splitting into exact flows."""

from __future__ import annotations

import warnings
from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import ClassVar, NamedTuple

import numpy as np

from polhode import rotation
from polhode.kinds.base import Spec, SpecMotion
from polhode.kinds.heavy_top.table import HeavyTopTable
from polhode.kinds.registry import other_kind
from polhode.motion._layout import Quantity
from polhode.motion._trajectory import Trajectory
from polhode.reports.answer import Group, Table
from polhode.reports.length import Watch
from polhode.reports.top import (
    TopReport,
    about_body,
    about_rests,
    build_frame,
    build_mechanics,
    rest_verdicts,
    usual_times,
)
from polhode.reports.top_starts import build_start, build_top
from polhode.simulation import simulate
from polhode.systems.heavy_top import HeavyTop
from polhode.types import Array, Float64

NAMES = {"|P|²": "|Γ|²", "Π·P": "vertical_momentum"}  # the Casimirs of se(3)*, by their names for a top
QUANTITIES = {
    "|Γ|²": Quantity("1", "squared length of the upward direction"),
    "vertical_momentum": Quantity("kg m2 s-1", "angular momentum about the vertical"),
}


@dataclass(frozen=True)
class HeavyTopReport(TopReport):
    """A top of any shape, integrated."""

    kind: ClassVar[str] = "heavy-top"


def make_report(spec: Spec[HeavyTopTable]) -> HeavyTopReport:
    """Return the report on any body about a fixed point, by Taylor series or splitting into exact flows.

    Raises:
        InvalidInput: for a body without mass.
    """
    moved = _simulate(spec)
    assert spec.body is not None
    verdicts = rest_verdicts(moved.top, moved.momentum)
    return HeavyTopReport(spec.body, spec.surface, moved.top, moved.trajectory, verdicts, moved.warned, spec.remarks)


def simulate_motion(spec: Spec[HeavyTopTable]) -> SpecMotion:
    """Return the motion alone.

    Raises:
        InvalidInput: for a body without mass.
    """
    moved = _simulate(spec)
    assert moved.trajectory.frame is not None
    return SpecMotion(moved.trajectory, build_mechanics(moved.top, moved.trajectory.frame))


def answers_without_motion(spec: Spec[HeavyTopTable]) -> Iterator[Group | Table]:
    """Yield the answers of the report that need no trajectory.

    Raises:
        InvalidInput: for a body without mass.
    """
    table, body = spec.system, spec.body
    assert body is not None
    top = build_top(body, table.pivot, table.gravity)
    yield about_body(body, top, build_frame(top, body, table.pivot))
    yield about_rests(rest_verdicts(top, _start(spec, top)[0]))


class _Moved(NamedTuple):
    """A top, its momentum (3,) at the start along the principal axes, its motion, and warnings."""

    top: HeavyTop
    momentum: Float64[Array, "3"]
    trajectory: Trajectory
    warned: tuple[str, ...]


def _simulate(spec: Spec[HeavyTopTable]) -> _Moved:
    table, body, times = spec.system, spec.body, spec.times
    assert body is not None
    top = build_top(body, table.pivot, table.gravity)
    momentum, attitude = _start(spec, top)
    state = top.pack(rotation.multiply(attitude, rotation.conjugate(rotation.from_matrix(np.asarray(top.axes)))),
                      momentum=np.asarray(top.axes) @ momentum)
    if times is None:
        times = usual_times(None, top, momentum, spec.samples)
    watch = Watch(spec.until, times, _remedy(spec))
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always", UserWarning)
        trajectory = _rename_invariants(simulate(top, state, times, step=table.step, order=table.order, progress=watch))
    trajectory = replace(trajectory, frame=build_frame(top, body, table.pivot))
    return _Moved(top, momentum, trajectory, tuple(str(warning.message) for warning in caught))


def _start(spec: Spec[HeavyTopTable], top: HeavyTop) -> tuple[Float64[Array, "3"], Float64[Array, "4"]]:
    """Return momentum along the principal axes, and their attitude, at the start."""
    momentum, attitude = spec.start(np.asarray(top.moments), np.asarray(top.axes))
    return build_start(top, spec.spin, momentum, attitude, spec.system.lean)


def _remedy(spec: Spec[HeavyTopTable]) -> str:
    """Return the remedies for a long run: longer steps, or a kind of top in closed form."""
    exact = other_kind(spec.kind.subject, in_closed_form=True)
    longer = "" if spec.system.step is None else "A longer `system.step` takes less. "
    return longer + ("" if exact is None else f'kind = "{exact.name}" takes no steps, if it is one.')


def _rename_invariants(trajectory: Trajectory) -> Trajectory:
    """Return the trajectory with its invariants named as usual for a top."""
    rename = lambda values: {NAMES.get(k, k): v for k, v in values.items() if k != "linear_space"}  # noqa: E731
    return replace(
        trajectory, invariants=rename(trajectory.invariants), drift=rename(trajectory.drift),
        quantities=trajectory.quantities | QUANTITIES,
    )
