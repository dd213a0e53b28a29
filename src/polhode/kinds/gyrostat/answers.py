"""The answers about gyrostats: a body with a rotor inside."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import ClassVar

import numpy as np

from polhode import rotation
from polhode.analysis.gyrostat_rotations import (
    SteadyRotation,
    SymmetricRates,
    angle_from_axis,
    mean_winding_rate,
    steady_rotations,
    symmetric_rates,
)
from polhode.bodies.body import Body
from polhode.kinds.base import Spec, SpecMotion
from polhode.kinds.gyrostat.build import build, make_system, pack_start, usual_span
from polhode.kinds.gyrostat.losses import describe_losses, judge_losses
from polhode.kinds.gyrostat.table import GyrostatTable
from polhode.kinds.stepping import Start
from polhode.motion._trajectory import Trajectory
from polhode.motion.frame import BodyFrame
from polhode.reports.about import GIVEN, about_axes, about_body, accuracy, from_motion, stability_values, verdicts
from polhode.reports.answer import Answer, Group, Table
from polhode.reports.base import WITHOUT_MOTION, MotionReport
from polhode.reports.wording import distinct, vector
from polhode.systems.body_with_rotor import RotorInBody, find_direction
from polhode.systems.gyrostat import Gyrostat
from polhode.types import Array, Float64


@dataclass(frozen=True)
class GyrostatReport(MotionReport):
    """A body with a rotor; of many motions of one, what is marked (…) has an axis of samples, and the rest is not used.

    Attributes:
        table: the rotor as the spec gives it.
        assembly: body and rotor at the start.
    """

    kind: ClassVar[str] = "gyrostat"
    spec: Spec[GyrostatTable]
    table: GyrostatTable
    assembly: RotorInBody
    trajectory: Trajectory

    @property
    def moments(self) -> Float64[Array, "3"]:
        """(3,) of the motion: rotor locked, or of a free rotor less its axial moment [kg m²]."""
        return self.assembly.moments

    @property
    def axes(self) -> Float64[Array, "3 3"]:
        """(3, 3) their axes by columns in the given ones."""
        return self.assembly.axes

    @property
    def along(self) -> Float64[Array, "3"]:
        """(3,) unit vector of the rotor's axis along these axes."""
        return self.assembly.along

    @property
    def rotor(self) -> float:
        """Its momentum at the start [kg m²/s], relative to the body or, of a free one, whole."""
        return self.assembly.momentum

    @cached_property
    def equilibria(self) -> list[SteadyRotation]:
        """On the momentum sphere, lowest energy first; with a motor, those for the rotor's final momentum."""
        last = float(self.trajectory.part("rotor_momentum")[-1]) if self.motor else self.rotor
        return steady_rotations(Gyrostat(self.moments, last * self.along), float(np.linalg.norm(self.assembly.total)))

    @cached_property
    def rates(self) -> SymmetricRates | None:
        """Of L about the axis of a symmetric carrier; None for others, and with a motor."""
        return None if self.motor else symmetric_rates(self.assembly.gyrostat, self.assembly.velocity)

    @property
    def start_velocity(self) -> Float64[Array, "3"]:
        """(3,) Ω at the start [rad/s, given axes]."""
        return self.assembly.axes @ self.assembly.velocity

    @property
    def body(self) -> Body:
        assert self.spec.body is not None
        return self.spec.body

    @property
    def free(self) -> bool:
        """Whether the rotor is free, or driven by a motor of given torque, and not held at a constant rate."""
        return self.motor or self.table.rotor_drive == "free"

    @property
    def motor(self) -> bool:
        return self.table.motor_torque is not None

    @property
    def rotor_momentum(self) -> Float64[Array, "*batch time"]:
        """(…, T) along its axis [kg m²/s], relative to the body or, of a free one, whole."""
        if self.motor:
            return np.asarray(self.trajectory.part("rotor_momentum"))
        shape = np.shape(self.trajectory.states)[:-1]
        return np.broadcast_to(np.asarray(self.rotor)[..., None], shape)

    @property
    def rotor_rate(self) -> Float64[Array, "*batch time"]:
        """(…, T) relative to the body [rad/s]."""
        along = np.asarray(self.trajectory.angular_velocity) @ self.along if self.free else 0.0
        return self.rotor_momentum / self.table.rotor_moment - along

    @property
    def axis_to_momentum(self) -> Float64[Array, "*batch time"]:
        """(…, T) angle from the rotor's axis to L [rad]; zeros without momentum."""
        return angle_from_axis(self.trajectory.momentum, self.along)

    @property
    def energy(self) -> Float64[Array, "*batch time"]:
        """(…, T) ½ Ω·IΩ with the moments of the motion [J]."""
        return 0.5 * np.sum(self.moments * np.asarray(self.trajectory.angular_velocity) ** 2, axis=-1)

    @property
    def motor_work(self) -> float | None:
        """Work of the motor on body and rotor up to the end [J]; None without a motor."""
        return float(self.trajectory.received["energy"][-1]) if self.motor else None

    @property
    def summary(self) -> str:
        if not self.equilibria:
            return "Body and rotor have no momentum together."
        low, high = np.degrees([self.axis_to_momentum.min(), self.axis_to_momentum.max()])
        count = {word: sum(e.verdict.verdict == word for e in self.equilibria) for word in ("stable", "unstable")}
        said = " and ".join(f"{n} {word}" for word, n in count.items() if n)
        end = " as the rotor turns at the end" if self.motor else ""
        return self.rounded(
            f"The angular momentum L stays between {low:.5g}° and {high:.5g}° from the rotor's axis. With this |L| "
            f"there are {said} steady rotations{end}."
        )

    @property
    def notes(self) -> list[str]:
        notes = [*self.spec.remarks]
        if any(e.circle for e in self.equilibria):
            notes.append("two moments are equal: a row means the whole circle of equilibria that it lies on.")
        if any(e.verdict.verdict == "stable" and e.extremum == "maximum" for e in self.equilibria):
            notes.append("losses in the carrier make the body leave a steady rotation where the energy has a maximum.")
        return notes

    @property
    def rotor_at_start(self) -> float:
        """The first value of ``rotor_momentum``."""
        return float(self.rotor_momentum[0]) if self.motor else self.rotor

    def without_motion(self) -> list[Group | Table]:
        """Return the answers that need no trajectory, for a rotor without a motor."""
        groups = [about_body(self.body, "rotor locked"), self._about_rotor(), self._steady_rotations()]
        losses = None if self.motor else judge_losses(self.table, self.body, self.start_velocity)
        return groups if losses is None else [*groups, describe_losses(self.table, losses)]

    @property
    def answers(self) -> list[Group | Table]:
        return [*self.without_motion(), self._motion(self._mean_rates())]

    def iterate_answers(self) -> Iterator[Group | Table]:
        yield from (about_body(self.body, "rotor locked"), self._about_rotor(), self._motion())
        yield from self.without_motion()[2:]
        yield Group("", self._mean_rates())

    def _about_rotor(self) -> Group:
        axis, torque = find_direction(self.table.rotor_axis), self.table.motor_torque
        drive = "free" if self.free else "constant-rate"
        meaning = "whole" if self.free else "relative to the body"
        less = "less the rotor's axial one" if self.free else "rotor locked"
        axes = about_axes("axes", self.axes, "vectors are along them")
        return Group("Rotor", [
            Answer("rotor.axis", axis, "", "axis", "direction, given axes", vector(axis) + GIVEN),
            Answer("rotor.moment", self.table.rotor_moment, "kg m²", "moment"),
            Answer("rotor.rate", self.table.rotor_rate, "rad/s", "rate against the body", "relative to the body"),
            Answer("rotor.drive", drive, "", "drive", "", None if torque is None else f"motor torque {torque:.6g} N m"),
            Answer("rotor.motor_torque", torque, "N m"),
            Answer("rotor.momentum", self.rotor_at_start, "kg m²/s", f"momentum, {meaning}"),
            Answer("rotor.momentum_is", meaning),
            Answer("moments", self.moments, "kg m²", "moments of the motion", less,
                   f"{distinct(self.moments)} kg m², {less}"),
            *(axes if self.free else axes[:1]),
        ])

    def _steady_rotations(self) -> Table:
        when = ", as the rotor turns at the end" if self.motor else ""
        rows = [
            {"along": e.along, "spin": e.spin, "energy": e.energy, "extremum": e.extremum, "circle": e.circle,
             "nutation": e.nutation, **stability_values(e.verdict)} for e in self.equilibria
        ]
        units = {"along": "direction of L", "spin": "rad/s, positive along L", "energy": "J",
                 "nutation": "rad/s, of L in the body"}
        cell = lambda row: f"{vector(row['along'])} {row['spin']:+.5g} rad/s, energy {row['extremum']}"  # noqa: E731
        more = {"nutation": lambda row: "–" if row["nutation"] is None else f"{row['nutation']:.5g} rad/s"}
        title = f"Steady rotations at this |L|{when}"
        return verdicts("equilibria", title, "L along, Ω", cell, rows, units, more=more)

    def _motion(self, mean_rates: Sequence[Answer] = ()) -> Group:
        momentum, velocity = np.asarray(self.trajectory.momentum), np.asarray(self.trajectory.angular_velocity)
        norm, lean = float(np.linalg.norm(momentum[0])), self.axis_to_momentum
        nutation, around = self.rates or (None, None)
        leans = [Answer("rotor_axis_to_momentum", None)] if not norm else [
            Answer("rotor_axis_to_momentum.smallest", lean.min(), "rad", "smallest angle, rotor's axis to L"),
            Answer("rotor_axis_to_momentum.largest", lean.max(), "rad", "largest"),
        ]
        return Group("Motion", [
            Answer("momentum", momentum[0], "kg m²/s"),
            Answer("momentum_norm", norm, "kg m²/s", "|L|"),
            Answer("energy", float(self.energy[0]), "J", "energy of the carrier", "of the carrier"),
            Answer("angular_velocity", velocity[0], "rad/s", "Ω at the start"),
            *from_motion(self.trajectory, leans),
            Answer("nutation_rate", nutation, "rad/s", "nutation in the body", "in the body"),
            Answer("precession_rate", around, "rad/s", "precession in space", "in space"),
            Answer("final.time", float(np.asarray(self.trajectory.times)[-1]), "s"),
            *from_motion(self.trajectory, [
                *mean_rates,
                Answer("final.angular_velocity", velocity[-1], "rad/s", "Ω at the end"),
                Answer("final.rotor_rate", float(self.rotor_rate[-1]), "rad/s", "rotor against the body at the end",
                       "relative to the body"),
                Answer("final.rotor_momentum", float(self.rotor_momentum[-1]), "kg m²/s"),
                Answer("final.energy", float(self.energy[-1]), "J",
                       "energy of the carrier at the end" if self.motor else ""),
                Answer("final.motor_work", self.motor_work, "J", "work of the motor"),
            ]),
            *accuracy(self.trajectory),
        ])


    def _mean_rates(self) -> list[Answer]:
        """Return the mean rates of L round the nearest stable rotation in the body, and of the rotor's axis round L."""
        stable = [e.along for e in self.equilibria if e.verdict.verdict == "stable" and not e.circle]
        if self.motor or not stable:
            return []
        momentum = np.asarray(self.trajectory.momentum)
        nearest = max(stable, key=lambda along: float(momentum.mean(axis=0) @ along))
        times, attitude = self.trajectory.times, np.asarray(self.trajectory.attitude)
        axis, L = rotation.rotate(attitude, self.along), rotation.rotate(attitude[0], momentum[0])
        nutation, around = mean_winding_rate(times, momentum, nearest), mean_winding_rate(times, axis, L)
        return [
            Answer("mean_nutation_rate", nutation, "rad/s", "mean nutation, right-handed",
                   "of L round the nearest stable rotation, in the body"),
            Answer("mean_precession_rate", around, "rad/s", "mean precession", "of the rotor's axis round L, in space"),
        ]


def make_report(spec: Spec[GyrostatTable]) -> GyrostatReport:
    """Return the report on a body with a rotor, driven at a constant rate, free, or driven by a motor's torque.

    Raises:
        InvalidInput: for a rotor that does not fit into the body.
    """
    return begin_motion(spec).make_report()


def answers_without_motion(spec: Spec[GyrostatTable]) -> Iterator[Group | Table]:
    """Yield the answers that need no trajectory; none with a motor, as the steady rotations depend on the end.

    Raises:
        InvalidInput: for a rotor that does not fit into the body.
    """
    if spec.system.motor_torque is None:
        yield from GyrostatReport(spec, spec.system, build(spec), WITHOUT_MOTION).without_motion()


def begin_motion(spec: Spec[GyrostatTable]) -> Start:
    """Return the motion at the times of the spec, or for ten turns.

    Raises:
        InvalidInput: for a rotor that does not fit into the body.
    """
    table, body, assembly, times = spec.system, spec.body, build(spec), spec.times
    assert body is not None
    if times is None:
        times = np.linspace(0.0, usual_span(table, assembly), spec.samples)
    frame = BodyFrame(assembly.moments, assembly.axes, body.center_of_mass, body.mass)
    remedy = "" if table.step is None else "A longer `system.step` takes less."
    return Start(
        make_system(table, assembly), pack_start(table, assembly), times,
        lambda trajectory, _: GyrostatReport(spec, table, assembly, replace(trajectory, frame=frame)),
        spec.until, remedy, {"step": table.step},
    )


def simulate_motion(spec: Spec[GyrostatTable]) -> SpecMotion:
    """Return the motion alone.

    Raises:
        InvalidInput: for a rotor that does not fit into the body.
    """
    return SpecMotion(begin_motion(spec).make_report().trajectory, None)
