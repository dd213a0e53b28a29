"""The answers about a heavy top: any body about a fixed point, by Taylor series or splitting into exact flows."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import ClassVar

import numpy as np

from polhode import rotation
from polhode.kinds.base import Spec, SpecMotion
from polhode.kinds.heavy_top.table import HeavyTopTable
from polhode.kinds.registry import other_kind
from polhode.kinds.stepping import Start
from polhode.motion._layout import Quantity
from polhode.motion._trajectory import Trajectory
from polhode.reports.answer import Group, Table
from polhode.reports.top import (
    TopReport,
    about_body,
    about_rests,
    build_frame,
    rest_verdicts,
    usual_times,
)
from polhode.reports.top_starts import build_start, build_top
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


def begin_motion(spec: Spec[HeavyTopTable]) -> Start:
    """Return the motion of any body about a fixed point, by Taylor series or splitting into exact flows.

    Raises:
        InvalidInput: for a body without mass.
    """
    table, body, times = spec.system, spec.body, spec.times
    assert body is not None
    top = build_top(body, table.pivot, table.gravity)
    momentum, attitude = _start(spec, top)
    state = pack_start(momentum, attitude)
    if times is None:
        times = usual_times(None, top, momentum, spec.samples)

    def report(trajectory: Trajectory, warned: tuple[str, ...]) -> HeavyTopReport:
        named = replace(rename_invariants(trajectory), frame=build_frame(top, body, table.pivot))
        return HeavyTopReport(body, spec.surface, top, named, momentum, warned, spec.remarks)

    return Start(top, state, times, report, spec.until, _remedy(spec), {"step": table.step, "order": table.order},
                 keeps_warnings=True)


def make_report(spec: Spec[HeavyTopTable]) -> HeavyTopReport:
    """Return the report on any body about a fixed point.

    Raises:
        InvalidInput: for a body without mass.
    """
    return begin_motion(spec).make_report()


def simulate_motion(spec: Spec[HeavyTopTable]) -> SpecMotion:
    """Return the motion alone.

    Raises:
        InvalidInput: for a body without mass.
    """
    report = make_report(spec)
    return SpecMotion(report.trajectory, report.mechanics)


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


def _start(spec: Spec[HeavyTopTable], top: HeavyTop) -> tuple[Float64[Array, "3"], Float64[Array, "4"]]:
    """Return momentum along the principal axes, and their attitude, at the start."""
    momentum, attitude = spec.start(np.asarray(top.moments), np.asarray(top.axes))
    return build_start(top, spec.spin, momentum, attitude, spec.system.lean)


def pack_start(
    momentum: Float64[Array, "*#batch 3"], attitude: Float64[Array, "*#batch 4"]
) -> Float64[Array, "*batch 10"]:
    """Return packed states (…, 10) from momenta (…, 3) along, and attitudes (…, 4) of, the principal axes."""
    unit = rotation.normalize(attitude)
    up = rotation.rotate(rotation.conjugate(unit), np.array([0.0, 0.0, 1.0]))
    shape = np.broadcast_shapes(momentum.shape[:-1], unit.shape[:-1])
    return np.concatenate([np.broadcast_to(part, (*shape, part.shape[-1])) for part in (unit, momentum, up)], axis=-1)


def _remedy(spec: Spec[HeavyTopTable]) -> str:
    """Return the remedies for a long run: longer steps, or a kind of top in closed form."""
    exact = other_kind(spec.kind.subject, in_closed_form=True)
    longer = "" if spec.system.step is None else "A longer `system.step` takes less. "
    return longer + ("" if exact is None else f'kind = "{exact.name}" takes no steps, if it is one.')


def rename_invariants(trajectory: Trajectory) -> Trajectory:
    """Return the trajectory with its invariants named as usual for a top."""
    rename = lambda values: {NAMES.get(k, k): v for k, v in values.items() if k != "linear_space"}  # noqa: E731
    return replace(
        trajectory, invariants=rename(trajectory.invariants), drift=rename(trajectory.drift),
        quantities=trajectory.quantities | QUANTITIES,
    )
