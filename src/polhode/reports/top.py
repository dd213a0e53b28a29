"""The answers about tops: a body turning about a fixed point under its weight."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from polhode.analysis._mechanics import Mechanics
from polhode.analysis.energy_casimir import Stability
from polhode.analysis.top_motion import axial_spin, axis_in_space, axis_tilt, is_steady_precession, top_period
from polhode.analysis.top_rates import TopRates, gyroscopic_rates, mean_top_rates, steady_top_rates
from polhode.analysis.top_rests import top_stability
from polhode.bodies.body import Body
from polhode.bodies.surface import Surface
from polhode.motion._trajectory import Trajectory
from polhode.motion.frame import BodyFrame
from polhode.reports.about import (
    GIVEN,
    about_axes,
    accuracy,
    from_motion,
    motion_error,
    stability_values,
    verdicts,
)
from polhode.reports.answer import Answer, Group, Table
from polhode.reports.base import MotionReport
from polhode.reports.wording import distinct, unit_in_words, vector
from polhode.systems.heavy_top import HeavyTop
from polhode.types import Array, ArrayLike, Float64, Real

if TYPE_CHECKING:
    from polhode.exact.lagrange_top import LagrangeMotion


@dataclass(frozen=True)
class TopReport(MotionReport):
    """What both kinds of top report: inertia about the pivot, path of the axis, and verdicts on its rests.

    Attributes:
        body: as given.
        surface: its shape, in the given axes, or None.
        top: moments, axis and weight at the pivot.
        trajectory: its frame has the principal axes at the pivot.
        momentum: (3,) at the start [kg m²/s, principal axes].
        warned: warnings of the integrator.
        remarks: on how the spec was understood.
    """

    body: Body
    surface: Surface | None
    top: HeavyTop
    trajectory: Trajectory
    momentum: Float64[Array, "3"]
    warned: tuple[str, ...] = ()
    remarks: tuple[str, ...] = ()

    @cached_property
    def verdicts(self) -> dict[str, Stability]:
        """On the axis upright and hanging, at the spin about it that the motion starts with."""
        return rest_verdicts(self.top, self.momentum)

    @property
    def free(self) -> bool:
        """Whether the fixed point is the centre of mass."""
        return float(self.top.mgl) == 0.0

    @property
    def frame(self) -> BodyFrame:
        """The principal axes at the fixed point."""
        assert self.trajectory.frame is not None
        return self.trajectory.frame

    @property
    def exact(self) -> LagrangeMotion | None:
        """The motion in closed form, where there is one."""
        return None

    @property
    def constant_tilt(self) -> bool:
        """Whether the precession is steady: constant tilt to rounding."""
        return self.exact is not None and is_steady_precession(self.exact)

    @property
    def mechanics(self) -> Mechanics:
        return build_mechanics(self.top, self.frame)

    @property
    def axis_in_space(self) -> Float64[Array, "time 3"]:
        """(T, 3) unit vector from the fixed point to the centre of mass."""
        return axis_in_space(self.top, self.trajectory.attitude)

    @cached_property
    def tilt(self) -> Float64[Array, "time"]:
        """(T,) angle of the axis from the vertical [rad]."""
        return axis_tilt(self.top, self.trajectory.attitude)

    @property
    def notes(self) -> list[str]:
        note = "the fixed point is the centre of mass: the weight has no torque, the body is free."
        notes = [note] if self.free else []
        return [*self.remarks, *notes] + [str(warning) for warning in self.warned]

    @property
    def summary(self) -> str:
        if self.free:
            return "The fixed point is the centre of mass: the body turns freely."
        low, high = np.degrees([self.tilt.min(), self.tilt.max()])
        case = "" if self.top.case is None else f" It is {self.top.case[0]}'s case, with a third integral."
        least, most = f"{low:.5g}°", f"{high:.5g}°"
        leans = f"by {least}" if least == most else f"between {least} and {most}"
        return self.rounded(f"The axis to the centre of mass leans {leans} from the vertical.{case}")

    @property
    def answers(self) -> list[Group | Table]:
        return [about_body(self.body, self.top, self.frame), about_rests(self.verdicts), *self._rates(), self.motion()]

    def iterate_answers(self) -> Iterator[Group | Table]:
        yield about_body(self.body, self.top, self.frame)
        yield self.motion()
        yield from self._rates()
        yield about_rests(self.verdicts)

    @property
    def mean_rates(self) -> TopRates:
        """Mean rates of precession and nutation of the motion."""
        return mean_top_rates(self.trajectory.times, self.axis_in_space)

    def _rates(self) -> list[Table]:
        """Return precession and nutation of the motion, beside those of steady precession and of a fast gyroscope."""
        if self.free:
            return []
        momentum, middle = self.axial_momentum, 0.5 * float(self.tilt.min() + self.tilt.max())
        cases = {
            "motion": ("the motion, on average", self.mean_rates),
            "steady": ("small nutation about steady precession, at the middle tilt",
                       steady_top_rates(self.top, momentum, middle)),
            "gyroscopic": ("gyroscope: mgl/I₃ω, I₃ω/I₁", gyroscopic_rates(self.top, momentum)),
        }  # fmt: skip
        rows = [
            {"by": name, "words": words, **(rates or TopRates(None, None))._asdict()}
            for name, (words, rates) in cases.items()
        ]
        said = lambda what: lambda row: "–" if row[what] is None else f"{row[what]:.6g} rad/s"  # noqa: E731
        columns = {"": lambda row: row["words"], "precession": said("precession"), "nutation": said("nutation")}
        units = {"precession": "rad/s", "nutation": "rad/s"}
        errors = {head: motion_error(self.trajectory) for head in ("precession", "nutation")}
        return [Table("rates", "Precession and nutation", columns, rows, units, key="by", errors=errors)]

    @property
    def axial_momentum(self) -> float:
        """Along the line to the centre of mass, the mean of the samples [kg m²/s]."""
        return float(np.mean(np.asarray(self.trajectory.momentum) @ np.asarray(self.top.axis)))

    def kept(self) -> list[Answer]:
        """Return the invariants at the start, and the tilt of the samples."""
        return [
            *from_motion(self.trajectory, [
                Answer("tilt.smallest", float(self.tilt.min()), "rad", "smallest tilt sampled", "of the samples"),
                Answer("tilt.largest", float(self.tilt.max()), "rad", "largest tilt sampled", "of the samples"),
            ]),
            *(
                Answer(f"invariants.{name}", float(np.asarray(value)[0]),
                       unit_in_words(self.trajectory.quantity(name).unit), name.replace("_", " "))
                for name, value in self.trajectory.invariants.items()
            ),
        ]  # fmt: skip

    def motion(self) -> Group:
        """Return the answers about the motion."""
        return Group("Motion", [*self.kept(), *accuracy(self.trajectory)])


def about_body(body: Body, top: HeavyTop, frame: BodyFrame) -> Group:
    """Return the answers about the body at the fixed point, along its principal axes there."""
    case = None if top.case is None else top.case[0]
    axes, axis, pivot = np.asarray(top.axes), np.asarray(top.axis), frame.origin
    moments, there = np.asarray(top.moments), "about the pivot"
    return Group("Body about the fixed point", [
        Answer("mass", body.mass, "kg", "mass"),
        Answer("center_of_mass", body.center_of_mass, "m", "", "given axes"),
        Answer("pivot", pivot, "m", "fixed point", "given axes", vector(pivot, "m") + GIVEN),
        Answer("principal_moments", moments, "kg m²", "principal moments there", there, distinct(moments, "kg m²")),
        *about_axes("principal_axes", axes),
        Answer("axis", axis, "", "centre of mass along", "direction from pivot to centre of mass, principal axes",
               vector(axis) + "  (principal axes)"),
        Answer("mgl", float(top.mgl), "N m", "weight × distance mgl"),
        Answer("integrable_case", case, "", "integrable case", "", case or "none"),
    ])


def about_rests(judgements: dict[str, Stability]) -> Table:
    """Return the verdicts on the axis upright and hanging, by words."""
    rows = [{"position": name, **stability_values(verdict)} for name, verdict in judgements.items()]
    title = "Axis to the centre of mass, upright and hanging"
    return verdicts("equilibria", title, "position", lambda row: row["position"], rows, key="position")


def build_frame(top: HeavyTop, body: Body, pivot: Real[ArrayLike, "3"]) -> BodyFrame:
    """Return the principal axes at the fixed point, and the mass properties."""
    return BodyFrame(np.asarray(top.moments), np.asarray(top.axes), body.center_of_mass, body.mass, np.asarray(pivot))


def build_mechanics(top: HeavyTop, frame: BodyFrame) -> Mechanics:
    """Return the mechanics from which energy and momentum of a top follow, along the given axes."""
    return Mechanics(frame.inertia, np.asarray(top.weight))


def rest_verdicts(top: HeavyTop, momentum: Float64[Array, "3"]) -> dict[str, Stability]:
    """Return verdicts on the axis upright and hanging, by words, at the spin about it if it is a principal axis."""
    if float(top.mgl) == 0.0:
        return {}
    spin = axial_spin(top, momentum)
    words = f"at {abs(spin):.6g} rad/s" if spin else "at rest"
    return {f"{name}, {words}": verdict for name, verdict in top_stability(top, spin)._asdict().items()}


def usual_times(
    span: float | None, top: HeavyTop, momentum: Float64[Array, "3"], samples: int
) -> Float64[Array, "{samples}"]:
    """Return times (T,) over ten spans [s]; over ten swings or turns where no span is given."""
    periods = 10
    at_rest = 0.1  # s, of a body that nothing moves
    return np.linspace(0.0, periods * (span or top_period(top, momentum) or at_rest), samples)
