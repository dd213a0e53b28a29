"""The answers about a Lagrange top: a symmetric body about a point of its axis, exactly."""

from __future__ import annotations

import math
import warnings
from dataclasses import dataclass, field, replace
from typing import ClassVar

import numpy as np

from polhode.analysis.top_motion import steady_precession_of
from polhode.analysis.top_rates import TopRates
from polhode.bodies._pivot import about_pivot
from polhode.bodies.body import Body
from polhode.errors import InvalidInput
from polhode.exact.lagrange_top import LagrangeMotion
from polhode.exact.lagrange_top._symmetry import third_axis_to_centre
from polhode.exact.lagrange_top.steady_precession import SteadyPrecession, sleeping_threshold
from polhode.kinds.base import Spec, SpecMotion
from polhode.kinds.lagrange_top.table import LagrangeTopTable
from polhode.kinds.registry import other_kind
from polhode.motion._inputs import finite, name_of
from polhode.motion._trajectory import Trajectory
from polhode.reports.about import accuracy
from polhode.reports.answer import Answer, Group
from polhode.reports.top import (
    TopReport,
    build_frame,
    build_mechanics,
    usual_times,
)
from polhode.reports.top_starts import build_start, build_top
from polhode.systems.heavy_top import HeavyTop
from polhode.types import Array, Float64


@dataclass(frozen=True)
class LagrangeTopReport(TopReport):
    """The symmetric top, exactly.

    Attributes:
        steady: rates of steady precession at the tilt and spin of the start.
        threshold: spin from which the upright top is stable [rad/s].
    """

    kind: ClassVar[str] = "lagrange-top"
    steady: SteadyPrecession | None = field(kw_only=True)
    threshold: float = field(kw_only=True)

    @property
    def exact(self) -> LagrangeMotion:
        motion = self.trajectory.motion
        assert isinstance(motion, LagrangeMotion)
        return motion

    @property
    def summary(self) -> str:
        exact, period = self.exact, finite(self.exact.nutation_period)
        if self.constant_tilt and exact.precession_rate is not None:
            return f"The top precesses steadily at constant tilt, at {exact.precession_rate:.6g} rad/s."
        words = _REGIMES[name_of(exact.regime)]
        if exact.regime == "sleeping" and abs(self.spin) < self.threshold:
            words = "The top stands upright, spinning too slowly to sleep: the least push fells it."
        if period is None:
            return words
        mean = None if exact.regime == "planar" else exact.precession_rate
        turn = "" if mean is None else f" and precesses at {mean:.6g} rad/s on average"
        return f"{words} It nutates every {period:.6g} s{turn}."

    @property
    def spin(self) -> float:
        """About its own axis, at the start [rad/s]."""
        return float(self.exact.momentum_at_epoch[2] / self.exact.moments[2])

    @property
    def mean_rates(self) -> TopRates:
        """The motion in closed form."""
        period = None if self.constant_tilt else finite(self.exact.nutation_period)
        precession = None if self.exact.regime == "planar" else finite(self.exact.precession_rate)
        return TopRates(precession, None if period is None else 2.0 * math.pi / period)

    def motion(self) -> Group:
        exact, planar = self.exact, self.exact.regime == "planar"
        low, high = exact.nutation_limits
        limits = None if low is None or high is None else (
            f"{math.degrees(math.acos(low)):.8g}°, constant" if self.constant_tilt
            else f"{math.degrees(math.acos(high)):.8g}° to {math.degrees(math.acos(low)):.8g}°"
        )
        varying = lambda label: "" if self.constant_tilt else label  # noqa: E731
        steady = None if self.steady is None else self.steady._asdict()
        rates = ", ".join(f"{name} {x:.8g} rad/s" for name, x in (steady or {}).items() if x is not None)
        return Group("Motion", [
            Answer("regime", exact.regime, "", "regime", "", "steady" if self.constant_tilt else name_of(exact.regime)),
            Answer("spin", self.spin, "rad/s", "spin about the axis"),
            Answer("sleeping_threshold", self.threshold, "rad/s", "least spin to sleep, upright"),
            Answer("start_tilt", float(self.tilt[0]), "rad"),
            Answer("nutation_limits", exact.nutation_limits, "", "tilt", "cos of the tilt", limits),
            Answer("nutation_period", exact.nutation_period, "s", varying("nutation period T")),
            Answer("precession_per_period", exact.precession_per_period, "rad", varying("precession per period Δφ")),
            Answer("spin_per_period", exact.spin_per_period, "rad", varying("own turn per period Δψ")),
            # in a plane both only jump by half turns, through the verticals
            Answer("precession_rate", None if planar else exact.precession_rate, "rad/s", "mean precession"),
            Answer("spin_rate", None if planar else exact.spin_rate, "rad/s", "mean own turn"),
            Answer("steady_precession", steady, "rad/s", "steady precession at this tilt", "", rates or None),
            Answer("energy", exact.energy, "J", "energy"),
            Answer("", exact.vertical_momentum, "kg m²/s", "vertical momentum"),
            Answer("", exact.axial_momentum, "kg m²/s", "axial momentum"),
            *(answer._replace(label="") for answer in self.kept()),
            *accuracy(self.trajectory),
        ])


_REGIMES = {
    "rest": "The top is at rest.",
    "sleeping": "The top sleeps upright.",
    "hanging": "The top hangs and spins.",
    "steady": "The top precesses steadily at constant tilt.",
    "free": "No weight: a free symmetric body.",
    "planar": "The top swings in a plane like a pendulum.",
    "undulating": "The axis undulates, always onward.",
    "cusp": "The axis halts in cusps.",
    "loop": "The axis turns back in loops.",
    "separatrix": "The axis comes to rest upright, in infinite time.",
}


def make_report(spec: Spec[LagrangeTopTable]) -> LagrangeTopReport:
    """Return the report on a symmetric body about a point of its axis, exactly.

    Raises:
        InvalidInput: for a body without mass, or one not symmetric about the line to its centre of mass.
    """
    assert spec.body is not None
    top, exact, trajectory = _simulate(spec)
    I1, _, I3 = (float(x) for x in exact.moments)
    return LagrangeTopReport(
        spec.body, spec.surface, top, trajectory, np.asarray(exact.momentum_at_epoch), remarks=spec.remarks,
        steady=steady_precession_of(exact), threshold=sleeping_threshold((I1, I1, I3), float(exact.mgl)),
    )


def simulate_motion(spec: Spec[LagrangeTopTable]) -> SpecMotion:
    """Return the motion alone.

    Raises:
        InvalidInput: as ``make_report`` does.
    """
    top, _, trajectory = _simulate(spec)
    assert trajectory.frame is not None
    return SpecMotion(trajectory, build_mechanics(top, trajectory.frame))


def _simulate(spec: Spec[LagrangeTopTable]) -> tuple[HeavyTop, LagrangeMotion, Trajectory]:
    body, times = spec.body, spec.times
    assert body is not None
    top, exact = _make_both(spec)
    if times is None:
        times = usual_times(finite(exact.nutation_period), top, exact.momentum_at_epoch, spec.samples)
    return top, exact, replace(exact.sample(times), frame=build_frame(top, body, spec.system.pivot))


def make_motion(spec: Spec[LagrangeTopTable]) -> LagrangeMotion:
    """Return the motion in closed form.

    Raises:
        InvalidInput: as ``make_report`` does.
    """
    return _make_both(spec)[1]


def _make_both(spec: Spec[LagrangeTopTable]) -> tuple[HeavyTop, LagrangeMotion]:
    top, momentum, attitude = make_start(spec)
    return top, LagrangeMotion(np.asarray(top.moments), mgl=float(top.mgl), momentum=momentum, attitude=attitude)


def make_start(spec: Spec[LagrangeTopTable]) -> tuple[HeavyTop, Float64[Array, "3"], Float64[Array, "4"]]:
    """Return the top of a spec, its axis third, with momentum (3,) along and attitude (4,) of its axes at the start.

    Raises:
        InvalidInput: as ``make_report`` does.
    """
    table, body = spec.system, spec.body
    assert body is not None
    top = _build_top(body, table, spec.kind.subject)
    momentum, attitude = spec.start(np.asarray(top.moments), np.asarray(top.axes))
    return top, *build_start(top, spec.spin, momentum, attitude, table.lean)


def _build_top(body: Body, table: LagrangeTopTable, subject: str) -> HeavyTop:
    """Return the top, with its axis third.

    Raises:
        InvalidInput: for a body without mass, or one that is not a Lagrange top about its pivot.
    """
    build_top(body, table.pivot, table.gravity)  # refuses values that no top has
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", UserWarning)  # the report says that the body is free
        try:
            pivoted = about_pivot(body, table.pivot, table.gravity)
            moments, axes = third_axis_to_centre(pivoted)
            return HeavyTop(moments, pivoted.mgl, (0.0, 0.0, 1.0), axes)
        except InvalidInput as error:
            other = other_kind(subject, in_closed_form=False)
            remedy = "" if other is None else f' In a spec ask for kind = "{other.name}".'
            raise InvalidInput(f"{error}{remedy}") from None
