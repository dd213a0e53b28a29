"""The plain answers about tops: a body turning about a fixed point under its weight."""

from __future__ import annotations

import math
import warnings
from dataclasses import dataclass

import numpy as np

from polhode import rotation
from polhode.analysis.energy_casimir import Stability
from polhode.analysis.mechanics import Mechanics
from polhode.analysis.top_rests import top_stability
from polhode.bodies.body import Body
from polhode.bodies.surface import Surface
from polhode.errors import InvalidInput
from polhode.exact.lagrange_top import LagrangeMotion
from polhode.motion.frame import BodyFrame
from polhode.motion.trajectory import Trajectory
from polhode.reports.about import GIVEN, about_axes, accuracy, stability_values, verdicts
from polhode.reports.answer import Answer, Group, Table
from polhode.reports.base import AbstractReport
from polhode.reports.wording import distinct, unit_in_words, vector
from polhode.systems.heavy_top import ALONG, HeavyTop
from polhode.types import Array, ArrayLike, Float64, Real

PERIODS = 10
CONSTANT = 1e-12  # radians between the limits of a tilt below which it is constant, but for rounding of what was given


@dataclass(frozen=True)
class TopReport(AbstractReport):
    """What both kinds of top have: the body about its pivot, the path of its axis, and its upright and hanging rest.

    Attributes:
        body: as given.
        surface: what it looks like, in the given axes, or None.
        top: moments, axis and weight at the pivot.
        pivot: (3,) [m, given axes].
        verdicts: on the axis upright and hanging, at the spin about it that the motion starts with.
        free: whether the fixed point is the centre of mass.
        warned: what the integrator had to say.
    """

    body: Body
    surface: Surface | None
    top: HeavyTop
    pivot: Real[ArrayLike, "3"]
    trajectory: Trajectory
    verdicts: dict[str, Stability]
    free: bool
    warned: tuple[str, ...] = ()

    @property
    def frame(self) -> BodyFrame:
        """The principal axes at the fixed point."""
        return frame_of(self.top, self.body, self.pivot)

    @property
    def exact(self) -> LagrangeMotion | None:
        """The motion in closed form, where there is one."""
        found = self.trajectory.motion
        return found if isinstance(found, LagrangeMotion) else None

    @property
    def constant_tilt(self) -> bool:
        """Whether the axis goes round at constant tilt, steadily but for rounding."""
        exact = self.exact
        if exact is None:
            return False
        low, high = exact.nutation_limits
        if exact.regime not in ("undulating", "cusp", "loop") or low is None or high is None:
            return exact.regime == "steady"
        return math.acos(low) - math.acos(high) < CONSTANT

    @property
    def mechanics(self) -> Mechanics:
        weight = float(self.top.mgl) * np.asarray(self.top.axes) @ np.asarray(self.top.axis)
        return Mechanics(self.frame.inertia, weight)

    @property
    def axis_in_space(self) -> Float64[Array, "time 3"]:
        """(T, 3) unit vector from the fixed point to the centre of mass."""
        return rotation.rotate(np.asarray(self.trajectory.attitude), np.asarray(self.top.axis))

    @property
    def notes(self) -> list[str]:
        note = "the fixed point is the centre of mass: the weight has no torque, the body is free."
        found = [note] if self.free else []
        return found + [str(warning) for warning in self.warned]

    @property
    def summary(self) -> str:
        if self.free:
            return "The fixed point is the centre of mass: the body turns freely."
        low, high = np.degrees(np.arccos(np.clip(self.axis_in_space[:, 2].max(), -1, 1))), np.degrees(
            np.arccos(np.clip(self.axis_in_space[:, 2].min(), -1, 1)))  # fmt: skip
        case = "" if self.top.case is None else f" It is {self.top.case[0]}'s case, with a third integral."
        return f"The axis to the centre of mass leans between {low:.5g}° and {high:.5g}° from the vertical.{case}"

    def answers(self) -> list[Group | Table]:
        case = None if self.top.case is None else self.top.case[0]
        axes, axis = np.asarray(self.top.axes), np.asarray(self.top.axis)
        moments, there = np.asarray(self.top.moments), "about the pivot"
        body = Group("Body about the fixed point", [
            Answer("mass", self.body.mass, "kg", "mass"),
            Answer("center_of_mass", self.body.center_of_mass, "m", "", "given axes"),
            Answer("pivot", self.pivot, "m", "fixed point", "given axes", vector(self.pivot, "m") + GIVEN),
            Answer("principal_moments", moments, "kg m²", "principal moments there", there, distinct(moments, "kg m²")),
            *about_axes("principal_axes", axes),
            Answer("axis", axis, "", "centre of mass along", "direction from pivot to centre of mass, principal axes",
                   vector(axis) + "  (principal axes)"),
            Answer("mgl", float(self.top.mgl), "N m", "weight × distance mgl"),
            Answer("integrable_case", case, "", "integrable case", "", case or "none"),
        ])  # fmt: skip
        rows = [{"position": name, **stability_values(found)} for name, found in self.verdicts.items()]
        title = "Axis to the centre of mass at rest"
        standing = verdicts("equilibria", title, "position", lambda row: row["position"], rows, key="position")
        return [body, standing, self.motion()]

    def kept(self) -> list[Answer]:
        """Return the invariants at the start, and the tilt of the samples."""
        tilt = np.arccos(np.clip(self.axis_in_space[:, 2], -1.0, 1.0))
        return [
            Answer("tilt.smallest", float(tilt.min()), "rad", "smallest tilt sampled", "of the samples"),
            Answer("tilt.largest", float(tilt.max()), "rad", "largest tilt sampled", "of the samples"),
            *(
                Answer(f"invariants.{name}", float(np.asarray(value)[0]),
                       unit_in_words(self.trajectory.quantity(name).unit), name.replace("_", " "))
                for name, value in self.trajectory.invariants.items()
            ),
        ]  # fmt: skip

    def motion(self) -> Group:
        """Return what is said of the motion."""
        return Group("Motion", [*self.kept(), *accuracy(self.trajectory)])


def top_of(body: Body, pivot: Real[ArrayLike, "3"], gravity: float) -> tuple[HeavyTop, bool]:
    """Return the top and whether it is free, its fixed point being the centre of mass.

    Raises:
        InvalidInput: for a body without mass.
    """
    if body.mass is None:
        raise InvalidInput("`body.mass` is needed for the weight of a top; give it together with moments or inertia.")
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        top = HeavyTop.from_body(body, pivot, gravity)
    return top, bool(caught)


def frame_of(top: HeavyTop, body: Body, pivot: Real[ArrayLike, "3"]) -> BodyFrame:
    """Return the principal axes at the fixed point, and the mass properties."""
    return BodyFrame(np.asarray(top.moments), np.asarray(top.axes), body.center_of_mass, body.mass, np.asarray(pivot))


def leaned(top: HeavyTop, attitude: Float64[Array, "4"], lean: float | None) -> Float64[Array, "4"]:
    """Return the attitude (4,) of the principal axes; with ``lean`` [rad] the axis leans towards −y from upright.

    Raises:
        InvalidInput: for a top whose centre of mass is its fixed point.
    """
    if lean is None:
        return attitude
    axes = np.asarray(top.axes)
    axis = axes @ np.asarray(top.axis)
    upright = rotation.shortest_between(axis, (0.0, 0.0, 1.0))
    if float(top.mgl) == 0.0:
        raise InvalidInput("`system.lean` needs a centre of mass apart from the fixed point; leave it out.")
    leaning = rotation.multiply(np.array([*_half_turn(lean), 0.0, 0.0]), upright)
    return rotation.multiply(leaning, rotation.from_matrix(axes))


def _half_turn(angle: float) -> tuple[float, float]:
    """Return cosine and sine of half an angle from 0 to π, exact at its ends and alike at π/2."""
    if abs(angle - 0.5 * math.pi) < 1e-15:
        return math.sqrt(0.5), math.sqrt(0.5)
    return (0.0, 1.0) if abs(angle - math.pi) < 1e-15 else (math.cos(0.5 * angle), math.sin(0.5 * angle))


def rest_verdicts(top: HeavyTop, momentum: Float64[Array, "3"]) -> dict[str, Stability]:
    """Return verdicts on the axis upright and hanging; spinning where it is a principal axis, else at rest."""
    axis = np.asarray(top.axis)
    k = int(np.argmax(np.abs(axis)))
    along = np.linalg.norm(np.delete(axis, k)) <= ALONG
    spin = float(momentum[k] * axis[k] / top.moments[k]) if along else 0.0
    if float(top.mgl) == 0.0:
        return {}
    words = f"at {abs(spin):.6g} rad/s" if spin else "at rest"
    return {f"{name}, {words}": verdict for name, verdict in top_stability(top, spin)._asdict().items()}


def natural_period(top: HeavyTop, momentum: Float64[Array, "3"]) -> float:
    """Return the period of a small swing [s], or of a turn if no weight acts."""
    largest = float(np.max(np.asarray(top.moments)))
    if float(top.mgl) != 0.0:
        return 2.0 * math.pi * math.sqrt(largest / abs(float(top.mgl)))
    turn = float(np.linalg.norm(momentum / np.asarray(top.moments)))
    return 2.0 * math.pi / turn if turn else 0.1
