"""The answers about a freely rotating body."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import ClassVar, NamedTuple

import numpy as np

from polhode.analysis._mechanics import Mechanics
from polhode.analysis.cone import LIMITS as CONE_LIMITS
from polhode.analysis.cone import axis_angles, rotation_form, velocity_angles
from polhode.analysis.energy_casimir import Stability
from polhode.analysis.free_axes import axis_stability
from polhode.analysis.poinsot import Herpolhode, herpolhode
from polhode.analysis.precession import (
    Precession,
    body_precession,
    fastest_rate,
    rotation_period,
    space_precession,
    turn_per_flip,
)
from polhode.bodies.body import Body
from polhode.errors import InvalidInput
from polhode.exact.free_body import FreeMotion
from polhode.kinds.base import Spec
from polhode.kinds.free_body.headline import headline
from polhode.kinds.free_body.table import FreeBodyTable
from polhode.motion._inputs import finite
from polhode.motion._trajectory import Trajectory
from polhode.reports.about import about_body, accuracy, stability_values, verdicts
from polhode.reports.answer import Answer, Group, Table
from polhode.reports.base import MotionReport
from polhode.reports.wording import LIMITS as UNIT_LIMITS
from polhode.reports.wording import angles, rate, vector
from polhode.types import ArrayLike, Real


class FreeBodyLimits(NamedTuple):
    """Numbers that decide whether a spin is refused and a phase is doubted."""

    # energy and momentum in SI, and their reciprocal; products of the two stay within the range of numbers
    largest: float = 1e200
    max_exact_turns: float = 2.0**50


LIMITS = FreeBodyLimits()


@dataclass(frozen=True)
class FreeBodyReport(MotionReport):
    """The report on a free body and its motion; undefined or infinite values are None.

    Attributes:
        twist_per_flip: turn about L from one flip to the next [rad]; None for a body that cones or tumbles.
        remarks: on how the spec was understood.
    """

    kind: ClassVar[str] = "free-body"
    body: Body
    motion: FreeMotion
    trajectory: Trajectory
    stability: tuple[Stability, Stability, Stability]
    herpolhode: Herpolhode | None
    precession_body: Precession | None
    precession_space: Precession | None
    rotation_period: float | None
    twist_per_flip: float | None
    remarks: tuple[str, ...] = ()

    @property
    def mechanics(self) -> Mechanics:
        return Mechanics(self.body.frame.inertia)

    @property
    def answers(self) -> list[Group | Table]:
        title = "Rotation about each principal axis, at this |L|"
        leaning = axis_angles(self.motion)
        axes = [
            {"axis": k + 1, "moment": self.motion.moments[k],
             "angle_to_momentum": None if leaning is None else leaning[k], **stability_values(stability)}
            for k, stability in enumerate(self.stability)
        ]
        units = {"moment": "kg m²", "angle_to_momentum": "rad, smallest and largest over all time"}
        more = {} if leaning is None else {"from L": lambda row: angles(row["angle_to_momentum"])}
        table = verdicts("axes", title, "axis", lambda row: str(row["axis"]), axes, units, more=more)
        return [about_body(self.body), self._start(), table, self._motion()]

    def _start(self) -> Group:
        motion, principal = self.motion, "principal axes"
        velocity = motion.momentum_at_epoch / motion.moments
        speed, lean = float(np.linalg.norm(velocity)), velocity_angles(motion)
        words = f"{rate(speed)} = {math.degrees(speed):.6g}°/s" if speed < UNIT_LIMITS.fast else rate(speed)
        return Group("Start", [
            Answer("angular_velocity", velocity, "rad/s", "Ω", principal, f"{vector(velocity)} rad/s  ({principal})"),
            Answer("angular_speed", speed, "rad/s", "|Ω|", "", words),
            Answer("momentum", motion.momentum_at_epoch, "kg m²/s", "L", principal,
                   f"{vector(motion.momentum_at_epoch)} kg m²/s  ({principal})"),
            Answer("angle_of_velocity_to_momentum", lean, "rad", "Ω from L", "smallest and largest over all time",
                   None if lean is None else angles(lean)),
        ])

    def _motion(self) -> Group:
        motion, curve = self.motion, self.herpolhode
        tumbling, form = motion.tumbling_periods, rotation_form(motion)
        flips = motion.flip_interval if form == "flipping" else None
        encircled = None if motion.encircled_axis is None else motion.encircled_axis + 1
        periods = ", ".join(f"{x:.8g} s" for x in tumbling if finite(x) is not None)
        unit = "1/√(kg m²)"
        radii = None if curve is None else (
            f"{curve.inner_radius:.6g} and {curve.outer_radius:.6g} {unit}, on a plane {curve.plane_distance:.6g} "
            f"{unit} from the centre of the inertia ellipsoid"
        )
        return Group("Motion", [
            Answer("form", form),
            Answer("regime", motion.regime, "", "regime"),
            Answer("encircled_axis", encircled),
            Answer("modulus", motion.modulus),
            Answer("energy", motion.energy, "J", "energy"),
            Answer("momentum_norm", motion.momentum_norm, "kg m²/s", "|L|"),
            Answer("polhode_period", motion.period, "s", "polhode period T"),
            Answer("rotation_period", self.rotation_period, "s", "rotation period"),
            Answer("flip_interval", flips, "s", "flip interval T/2"),
            Answer("twist_per_flip", self.twist_per_flip, "rad", "turn about L per flip"),
            *_precession("body", self.precession_body),
            *_precession("space", self.precession_space),
            Answer("precession_rate", motion.precession_rate, "rad/s"),
            Answer("precession_per_period", motion.precession_per_period, "rad", "precession per period"),
            Answer("geometric_phase", motion.geometric_phase, "rad", "geometric phase"),
            Answer("action", motion.action, "J s", "action"),
            Answer("tumbling_periods", {"P_phi": tumbling[0], "P_psi": tumbling[1]}, "s"),
            Answer("", None, "", "tumbling periods P_φ, P_ψ", "", periods or None),
            Answer("long_axis_period", motion.long_axis_period, "s", "long-axis period P₁"),
            Answer("herpolhode", None if curve is None else curve._asdict(), unit, "herpolhode between radii", "",
                   radii),
            *accuracy(self.trajectory),
        ])

    @property
    def notes(self) -> list[str]:
        notes = [*self.remarks]
        if self._spins_about_least():
            notes.append(
                "this is spin about the axis of least moment: any internal loss of energy makes the body leave it, as "
                "Explorer 1 did in 1958, and end in a flat spin about the axis of largest moment. A spec with losses "
                "gives the time that takes."
            )
        if self._spins_about_middle():
            notes.append(
                "this is spin exactly about the intermediate axis, which is unstable: the least disturbance makes the "
                "body turn over, again and again. Give spin.tilt to see it."
            )
        farthest = float(np.abs(np.asarray(self.trajectory.times)).max())
        turns = farthest * fastest_rate(self.motion) / (2.0 * math.pi)
        if turns > LIMITS.max_exact_turns:
            note = f"the times reach {turns:.1e} turns; beyond 2⁵⁰ the error of the attitude grows with them, and the "
            notes.append(note + "spin itself, known to 16 digits, no longer says how the body lies.")
        return notes

    def _spins_about_middle(self) -> bool:
        """Whether L lies exactly along the intermediate axis of three different moments."""
        moments, momentum = np.asarray(self.motion.moments), np.abs(np.asarray(self.motion.momentum_at_epoch))
        middle = int(np.argsort(moments)[1])
        return len(set(moments.tolist())) == 3 and bool(momentum.sum() == momentum[middle] > 0.0)

    def _spins_about_least(self) -> bool:
        """Whether the body spins, steadily or coning, about an axis whose moment is less than the others."""
        moments, leaning = np.asarray(self.motion.moments), axis_angles(self.motion)
        least = int(moments.argmin())
        if leaning is None or (moments == moments[least]).sum() > 1:
            return False
        nearest = min(leaning[least, 1], math.pi - leaning[least, 0])
        return bool(nearest < CONE_LIMITS.coning)

    @property
    def summary(self) -> str:
        return headline(self.motion)


def make_report(spec: Spec[FreeBodyTable]) -> FreeBodyReport:
    """Return the report on the free motion of a spec's body."""
    assert spec.body is not None
    momentum, attitude = spec.start(spec.body.principal_moments, spec.body.principal_axes)
    report = free_body_report(spec.body, momentum, attitude, spec.times, spec.samples)
    return replace(report, remarks=spec.remarks)


def make_motion(spec: Spec[FreeBodyTable]) -> FreeMotion:
    """Return the free motion of a spec's body, along its principal axes.

    Raises:
        InvalidInput: for a body with a vanishing moment.
    """
    assert spec.body is not None
    momentum, attitude = spec.start(spec.body.principal_moments, spec.body.principal_axes)
    return _motion_of(spec.body, momentum, attitude)


def _motion_of(body: Body, momentum: Real[ArrayLike, "3"], attitude: Real[ArrayLike, "4"]) -> FreeMotion:
    if not body.principal_moments[0] > 0:
        raise InvalidInput(
            "the body is a thin rod: its moment about its own axis is zero, and its spin about it is undefined. "
            "Give it a radius, as a cylinder; of a linear molecule, `polhode body` gives the moments."
        )
    return FreeMotion(body.principal_moments, momentum=momentum, attitude=attitude)


def free_body_report(
    body: Body,
    momentum: Real[ArrayLike, "3"],
    attitude: Real[ArrayLike, "4"],
    times: Real[ArrayLike, "time"] | None = None,
    samples: int = 2000,
) -> FreeBodyReport:
    """Return the report on a body's free motion.

    Args:
        body: the body.
        momentum: (3,) [kg m²/s, principal axes].
        attitude: (4,) unit quaternion wxyz, principal axes → space.
        times: (T,) [s]; None for ten periods (ten turns where there is no period).
        samples: how many times to take then.

    Raises:
        InvalidInput: for a body with a vanishing moment, or values that are not finite.
    """
    periods = 10
    motion = _motion_of(body, momentum, attitude)
    energy, size = float(motion.energy), float(motion.momentum_norm)
    if any(x and not 1.0 / LIMITS.largest < x < LIMITS.largest for x in (energy, size)) or (size and not energy):
        raise InvalidInput(
            f"the spin must give an energy and |L| within 1e±200, or none; its momentum is "
            f"{np.asarray(momentum).tolist()} kg m²/s. Check the rate and its unit."
        )
    if times is None:
        times = np.linspace(0.0, periods * motion.cycle, samples)
    return FreeBodyReport(
        body=body,
        motion=motion,
        trajectory=replace(motion.sample(times), frame=body.frame),
        stability=axis_stability(motion.moments, size),
        herpolhode=herpolhode(motion),
        precession_body=body_precession(motion),
        precession_space=space_precession(motion),
        rotation_period=rotation_period(motion),
        twist_per_flip=turn_per_flip(motion) if rotation_form(motion) == "flipping" else None,
    )


def _precession(place: str, value: Precession | None) -> list[Answer]:
    name, label = f"precession.{place}", f"precession in {'the ' * (place == 'body')}{place}"
    if value is None:
        return [Answer(name, None)]
    return [
        Answer(f"{name}.frame", value.frame),
        Answer(f"{name}.rate", value.rate, "rad/s", label, "", f"{value.rate:.8g} rad/s {value.sense}"),
        Answer(f"{name}.sense", value.sense),
    ]
