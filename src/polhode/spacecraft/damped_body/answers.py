"""The answers about bodies that lose energy, inside or by drag."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import cached_property
from typing import ClassVar, NamedTuple

import numpy as np

from polhode.analysis.energy_casimir import Stability
from polhode.bodies.body import Body
from polhode.errors import InvalidInput
from polhode.kinds.base import Spec, SpecMotion
from polhode.motion._trajectory import Trajectory
from polhode.reports.about import (
    about_body,
    about_orbital_rests,
    accuracy,
    from_motion,
    motion_error,
    stability_values,
    verdicts,
)
from polhode.reports.answer import Answer, Group, Table
from polhode.reports.base import MotionReport
from polhode.reports.length import Watch
from polhode.reports.wording import duration, uncertain
from polhode.simulation import simulate
from polhode.spacecraft.damped_body.damped_axes import damped_axis_stability
from polhode.spacecraft.damped_body.damped_motion import LIMITS as AXES
from polhode.spacecraft.damped_body.damped_motion import (
    angle_to_axis,
    angle_to_major_axis,
    drag_time_constant,
    settling_time,
    time_constant,
)
from polhode.spacecraft.damped_body.energy_sink import FLAT, flat_spin_time, sink_rate_by_loss, sink_rate_by_time
from polhode.spacecraft.damped_body.table import DampedBodyTable
from polhode.spacecraft.systems.torqued_body import TorquedBody
from polhode.spacecraft.torques import AbstractTorque, GravityGradient, LinearDrag, QuadraticDrag
from polhode.systems.double_bracket import DoubleBracket
from polhode.systems.kepler_orbit import KeplerOrbit
from polhode.types import Array, Float64

WITHIN = "L to stay within 5° of the major axis"
FLAT_SPIN = "time to within 5° of a flat spin"


class MotionLimits(NamedTuple):
    """How long a motion is followed where no end is given."""

    max_turns: float = 20_000.0  # of the start


LIMITS = MotionLimits()


@dataclass(frozen=True, eq=False)
class DampedStart:
    """The answers about a body with losses that follow from its start alone.

    Attributes:
        spec: as it was read.
        table: the losses as the spec gives them.
        momentum: (3,) L at the start [kg m²/s, principal axes].
        attitude: (4,) at the start, of the principal axes.
        system: what moves.
    """

    spec: Spec[DampedBodyTable]
    table: DampedBodyTable
    momentum: Float64[Array, "3"]
    attitude: Float64[Array, "4"]
    system: DoubleBracket | TorquedBody

    @property
    def body(self) -> Body:
        assert self.spec.body is not None
        return self.spec.body

    @property
    def norm(self) -> float:
        """|L| [kg m²/s]."""
        return float(np.linalg.norm(self.momentum))

    @cached_property
    def axes(self) -> tuple[Stability, ...]:
        """Verdicts on rotation about each principal axis, as a direction of L at this |L|; none at rest."""
        return damped_axis_stability(self.system, self.norm) if self.norm else ()

    @property
    def time_constant(self) -> float | None:
        """Time constant [s] at the start: of the approach to the major axis or, with drag, of the spin about it."""
        if self.table.inside or not self.axes:
            return time_constant(self.axes[2]) if self.axes else None
        moment = float(self.body.principal_moments[2])
        return _drag_time(self.table, moment, self.norm / moment)

    @property
    def damping(self) -> float | None:
        """α |L| of internal losses; None with other losses."""
        if not (self.table.inside and self.norm):
            return self.table.damping
        return self.norm * _sink_rate(self.table, self.body.principal_moments, self.momentum)

    def from_one_degree(self) -> float | None:
        """Return the time [s] to a flat spin from 1° off the axis of the start; None unless that is a minor axis."""
        moments, norm = self.body.principal_moments, self.norm
        at = [k for k in (0, 1) if norm and moments[k] < moments[2] and angle_to_axis(self.momentum, k) <= AXES.on_axis]
        if not self.table.inside or self.damping is None or not at:
            return None
        off = np.full(3, math.sin(math.radians(1.0)) / math.sqrt(2.0))
        off[at[0]] = math.cos(math.radians(1.0))
        return flat_spin_time(moments, norm * off, self.damping / norm)

    def losses(self) -> Group:
        """Return the answers about the losses, and how they were given."""
        orbiting = self.table.orbital_period is not None
        return Group("Losses", [
            Answer("damping", self.damping, "", "losses inside", "α |L|"),
            Answer("damping_time", self.table.damping_time, "s", "given by the damping time"),
            Answer("loss_rate", self.table.loss_rate, "W", "given by the loss at the start"),
            Answer("linear_drag", self.table.linear_drag, "N m s", "linear drag"),
            Answer("quadratic_drag", self.table.quadratic_drag, "N m s²", "quadratic drag"),
            Answer("orbital_period", self.table.orbital_period, "s", "orbital period"),
            Answer("eccentricity", self.table.eccentricity or 0.0 if orbiting else None, "", "eccentricity"),
        ])

    def rests(self) -> list[Table]:
        """Return how gravity alone lets the body rest in the frame of a circular orbit."""
        period, eccentric = self.table.orbital_period, self.table.eccentricity
        if period is None or eccentric:
            return []
        return [about_orbital_rests(self.body.principal_moments, 2.0 * math.pi / period)]

    def verdicts(self) -> Table:
        """Return the verdicts on the axes."""
        rows = [
            {"axis": k + 1, "moment": self.body.principal_moments[k], "time_constant": time_constant(stability),
             **stability_values(stability)} for k, stability in enumerate(self.axes)
        ]
        title = "L along each principal axis, with the losses, at the |L| of the start"
        units = {"moment": "kg m²", "time_constant": "s"}
        return verdicts("axes", title, "axis", lambda row: str(row["axis"]), rows, units)

    def settling(self) -> Answer:
        """Return the time constant at the start."""
        which = "approach to the major axis" if self.table.inside else "spin about the major axis, at first"
        return Answer("time_constant", self.time_constant, "s", f"time constant of the {which}")

    def flat_spin(self) -> list[Answer]:
        """Return when L comes to stay within 5° of the major axis, by the energy-sink method."""
        if not self.table.inside or self.damping is None or not self.norm:
            return []
        expected = flat_spin_time(self.body.principal_moments, self.momentum, self.damping / self.norm)
        return [
            Answer("flat_spin_time.energy_sink", expected, "s", f"{FLAT_SPIN}, by mean losses", WITHIN),
            Answer("flat_spin_time.from_one_degree", self.from_one_degree(), "s", f"{FLAT_SPIN}, from 1° off", WITHIN),
        ]


@dataclass(frozen=True)
class DampedBodyReport(MotionReport):
    """A body with losses.

    Attributes:
        start: the answers that need no motion.
        cut: whether the motion ends before it has settled.
    """

    kind: ClassVar[str] = "damped-body"
    start: DampedStart
    trajectory: Trajectory
    cut: bool

    @property
    def table(self) -> DampedBodyTable:
        """The losses as the spec gives them."""
        return self.start.table

    @property
    def axes(self) -> tuple[Stability, ...]:
        """Verdicts on rotation about each principal axis, as a direction of L at the |L| of the start."""
        return self.start.axes

    @property
    def body(self) -> Body:
        return self.start.body

    @property
    def inside(self) -> bool:
        """Whether the losses are internal, which conserves L."""
        return self.table.inside

    @property
    def energy(self) -> Float64[Array, "time"]:
        """(T,) of rotation [J]."""
        name = "energy" if self.inside else "kinetic_energy"
        return np.asarray(self.trajectory.balances[name])

    @property
    def momentum_norm(self) -> Float64[Array, "time"]:
        """(T,) |L| [kg m²/s]."""
        return np.linalg.norm(np.asarray(self.trajectory.momentum), axis=-1)

    @property
    def angle_to_major_axis(self) -> Float64[Array, "time"]:
        """(T,) angle from L to the nearest line of largest moment [rad]."""
        return angle_to_major_axis(self.trajectory.momentum, self.body.principal_moments)

    @property
    def summary(self) -> str:
        if not self.axes and not self.momentum_norm.any():
            return "The body is at rest."
        if not self.axes:
            return "The body starts at rest; gravity turns it."
        first, last = np.degrees(self.angle_to_major_axis[[0, -1]])
        spent, left = (values[-1] / values[0] for values in (self.energy, self.momentum_norm))
        kept = "all" if self.inside else f"{left:.4g}"
        return self.rounded(
            f"The angle between the angular momentum L and the major axis goes from {first:.5g}° to {last:.5g}°; the "
            f"body ends with {spent:.4g} of its energy and {kept} of its momentum."
        )

    @property
    def notes(self) -> list[str]:
        notes = [*self.start.spec.remarks]
        if self.inside and self.axes:
            notes += self._leaving()
        elif self.cut:
            turns = f"{LIMITS.max_turns:.0f} turns of the start"
            notes.append(f"the motion is followed for {turns}; give time.until for more.")
        if self.table.orbital_period is not None:
            notes.append("the verdicts on the axes are those of drag; gravity's pull on the body is left out of them.")
        return notes

    def _leaving(self) -> list[str]:
        """Return notes on a spin that is not about the major axis under internal losses."""
        start, moments = self.start.momentum, self.body.principal_moments
        norm, settles = self.start.norm, self.angle_to_major_axis[-1] <= math.radians(1.0)
        at = [k for k in (0, 1) if moments[k] < moments[2] and angle_to_axis(start, k) <= AXES.on_axis]
        if at:
            later = self.start.from_one_degree()
            then = "" if later is None else f" From 1° off it comes to a flat spin in {duration(later)}."
            why = f"it starts exactly on axis {at[0] + 1}, where nothing pushes it off. The least disturbance makes it "
            return [f"{why}leave, as Explorer 1 did in 1958.{then} Give spin.tilt to see it."]
        notes = []
        if moments[0] < moments[1] and 2.0 * float(self.energy[0]) * moments[1] > norm**2:
            notes.append("it starts about the axis of least moment, which a body that loses energy inside leaves, as "
                         "Explorer 1 did in 1958, for a flat spin about the axis of largest moment.")
        if not settles:
            wanted = settling_time(self.axes, start, moments)
            wait = f' = "{1.1 * wanted:.3g} s"' if math.isfinite(wanted) else ""
            notes.append(f"it has not settled; give a later time.until{wait}.")
        return notes

    @property
    def answers(self) -> list[Group | Table]:
        start = self.start
        return [about_body(self.body), start.losses(), start.verdicts(), *start.rests(), self._motion()]

    def _motion(self) -> Group:
        energy, norm, moments = self.energy, self.momentum_norm, self.body.principal_moments
        start, end = (float(self.angle_to_major_axis[k]) for k in (0, -1))
        error = motion_error(self.trajectory)
        error = None if error is None else error / (end or 1.0)  # of a direction, in rad
        lowest = float(0.5 * norm[0] ** 2 / moments[2]) if self.inside else None
        return Group("Motion", [
            Answer("start.time", float(self.trajectory.times[0]), "s"),
            Answer("end.time", float(self.trajectory.times[-1]), "s", "time"),
            *self._at_both_ends("energy", energy, "J", "energy"),
            *from_motion(self.trajectory, [Answer("energy_lost", energy[0] - energy[-1], "J")]),
            Answer("lowest_energy", lowest, "J", "lowest energy at this |L|", "at this |L|"),
            *self._at_both_ends("momentum_norm", norm, "kg m²/s", "|L|"),
            *self._at_both_ends("angular_velocity", np.asarray(self.trajectory.angular_velocity), "rad/s", "Ω",
                                "principal axes"),
            Answer("start.angle_to_major_axis", start, "rad", "L to the major axis at the start"),
            Answer("end.angle_to_major_axis", end, "rad", "L to the major axis at the end", error=error),
            self.start.settling(),
            *self.start.flat_spin(),
            *self._flat_spin_seen(),
            *accuracy(self.trajectory, "drift of conserved and balanced quantities"),
        ])

    def _flat_spin_seen(self) -> list[Answer]:
        """Return the time after which L stays within 5° of the major axis."""
        if not self.start.flat_spin():
            return []
        away = np.flatnonzero(self.angle_to_major_axis > FLAT)
        reached = None if len(away) and away[-1] == len(self.angle_to_major_axis) - 1 else 0.0
        if reached is not None and len(away):
            reached = float(self.trajectory.times[away[-1] + 1] - self.trajectory.times[0])
        spacing = None if reached is None or not len(away) else float(np.diff(self.trajectory.times)[away[-1]])
        words = None if reached is None else uncertain(reached, spacing, "s")
        said = f"{FLAT_SPIN}, in the motion"
        return [Answer("flat_spin_time.motion", reached, "s", said, f"{WITHIN}, at a sample", words)]

    def _at_both_ends(self, name: str, values: Array, unit: str, label: str, explanation: str = "") -> list[Answer]:
        start, end = (
            Answer(f"{end}.{name}", values[k], unit, f"{label} at the {end}", explanation)
            for end, k in (("start", 0), ("end", -1))
        )
        return [start, *from_motion(self.trajectory, [end])]


def make_report(spec: Spec[DampedBodyTable]) -> DampedBodyReport:
    """Return the report on a body that loses energy inside, as a double bracket, or by drag.

    Raises:
        InvalidInput: for a body with a vanishing moment.
    """
    start = _make_start(spec)
    return DampedBodyReport(start, *_simulate(spec, start))


def simulate_motion(spec: Spec[DampedBodyTable]) -> SpecMotion:
    """Return the motion alone.

    Raises:
        InvalidInput: for a body with a vanishing moment.
    """
    return SpecMotion(_simulate(spec, _make_start(spec))[0], None)


def answers_without_motion(spec: Spec[DampedBodyTable]) -> Iterator[Group | Table]:
    """Yield the answers of the report that need no trajectory.

    Raises:
        InvalidInput: for a body with a vanishing moment.
    """
    start = _make_start(spec)
    yield about_body(start.body)
    yield start.losses()
    yield Group("Motion", start.flat_spin())
    yield from start.rests()
    yield start.verdicts()
    yield Group("Motion", [start.settling()])


def _make_start(spec: Spec[DampedBodyTable]) -> DampedStart:
    table = spec.system
    assert spec.body is not None
    moments = spec.body.principal_moments
    if not moments[0] > 0:
        raise InvalidInput(
            "the body is a thin rod: its moment about its own axis is zero, and its spin about it is undefined. "
            "Give it a radius, as a cylinder."
        )
    momentum, attitude = spec.start(moments, spec.body.principal_axes)
    return DampedStart(spec, table, momentum, attitude, _system(table, moments, momentum))


def _simulate(spec: Spec[DampedBodyTable], start: DampedStart) -> tuple[Trajectory, bool]:
    """Return the motion, and whether it is cut short."""
    times, moments, cut = spec.times, start.body.principal_moments, False
    if times is None:
        end, cut = _end(start.table, moments, start.momentum, start.axes)
        times = np.linspace(0.0, end, spec.samples)
    state = np.concatenate([start.attitude, start.momentum])
    trajectory = simulate(start.system, state, times, progress=Watch(spec.until, times))
    return replace(trajectory, frame=start.body.frame), cut


def _sink_rate(table: DampedBodyTable, moments: Array, momentum: Array) -> float:
    """Return α of the losses inside, zero at rest."""
    norm = float(np.linalg.norm(momentum))
    if not norm:
        return 0.0
    if table.damping_time is not None:
        return sink_rate_by_time(moments, norm, table.damping_time)
    if table.loss_rate is not None:
        return sink_rate_by_loss(moments, momentum, table.loss_rate)
    assert table.damping is not None
    return table.damping / norm


def _system(table: DampedBodyTable, moments: Array, momentum: Array) -> DoubleBracket | TorquedBody:
    if table.inside:
        return DoubleBracket(moments, _sink_rate(table, moments, momentum))
    torques: list[AbstractTorque] = []
    if table.linear_drag is not None:
        torques.append(LinearDrag(table.linear_drag))
    if table.quadratic_drag is not None:
        torques.append(QuadraticDrag(table.quadratic_drag))
    if table.orbital_period is not None:
        orbit = KeplerOrbit(2.0 * math.pi / table.orbital_period, table.eccentricity or 0.0)
        torques.append(GravityGradient(orbit, moments))
    return TorquedBody(moments, torques)


def _drag_time(table: DampedBodyTable, moment: float, spin: float) -> float:
    return drag_time_constant(moment, spin, table.linear_drag or 0.0, table.quadratic_drag or 0.0)


def _end(table: DampedBodyTable, moments: Array, momentum: Array, axes: tuple[Stability, ...]) -> tuple[float, bool]:
    """Return a time by which the motion has settled, and whether it is cut short."""
    decays = 5.0  # time constants of drag that are followed
    if not axes:
        return table.orbital_period or 1.0, False
    norm, turn = float(np.linalg.norm(momentum)), 2.0 * math.pi / float(np.linalg.norm(momentum / moments))
    if not table.inside:
        wanted = decays * _drag_time(table, float(moments[2]), norm / float(moments[2]))
    else:
        wanted = settling_time(axes, momentum, moments)
    return min(wanted, LIMITS.max_turns * turn), wanted > LIMITS.max_turns * turn
