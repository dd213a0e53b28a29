"""The plain answers about bodies that lose energy, inside or by drag."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import ClassVar

import diffrax
import numpy as np

from polhode.analysis.damped_axes import damped_axis_stability
from polhode.analysis.damped_motion import (
    ON_AXIS,
    angle_to_axis,
    angle_to_major_axis,
    drag_time_constant,
    settling_time,
    time_constant,
)
from polhode.analysis.energy_casimir import Stability
from polhode.analysis.energy_sink import FLAT, flat_spin_time, sink_rate_by_loss, sink_rate_by_time
from polhode.bodies.body import Body
from polhode.errors import InvalidInput
from polhode.kinds.base import Spec, SpecMotion
from polhode.kinds.damped_body.table import DampedBodyTable
from polhode.motion.trajectory import Trajectory
from polhode.reports.about import about_body, accuracy, stability_values, verdicts
from polhode.reports.answer import Answer, Group, Table
from polhode.reports.base import AbstractMotionReport
from polhode.reports.length import ADAPTIVE, ORBITING, TURNING, check_length
from polhode.reports.wording import angle, duration, uncertain
from polhode.simulation import simulate
from polhode.systems.double_bracket import DoubleBracket
from polhode.systems.kepler_orbit import KeplerOrbit
from polhode.systems.torqued_body import TorquedBody
from polhode.systems.torques import AbstractTorque, GravityGradient, LinearDrag, QuadraticDrag
from polhode.types import Array, Float64

FLAT_SPIN = "time to within 5° of a flat spin"
DECAYS = 5.0  # time constants of drag followed where no end is given
MOST_TURNS = 20_000.0  # of the start, followed where no end is given


@dataclass(frozen=True)
class DampedBodyReport(AbstractMotionReport):
    """A body with losses.

    Attributes:
        table: the losses as they stand in the spec.
        axes: verdicts on rotation about each principal axis, as a direction of L at the |L| of the start.
        cut: whether the motion was ended before it settled.
    """

    kind: ClassVar[str] = "damped-body"
    spec: Spec
    table: DampedBodyTable
    trajectory: Trajectory
    axes: tuple[Stability, ...]
    cut: bool

    @property
    def body(self) -> Body:
        assert self.spec.body is not None
        return self.spec.body

    @property
    def inside(self) -> bool:
        """Whether the losses are inside the body, which keeps L."""
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
    def time_constant(self) -> float | None:
        """Of the last approach to the major axis, or of the spin about it that drag brakes, at the start [s]."""
        if self.inside or not self.axes:
            return time_constant(self.axes[2]) if self.axes else None
        moment = float(self.body.principal_moments[2])
        return _drag_time(self.table, moment, float(self.momentum_norm[0]) / moment)

    @property
    def summary(self) -> str:
        if not self.axes and not self.momentum_norm.any():
            return "The body is at rest."
        if not self.axes:
            return "The body starts at rest; gravity turns it."
        first, last = np.degrees(self.angle_to_major_axis[[0, -1]])
        spent, left = (values[-1] / values[0] for values in (self.energy, self.momentum_norm))
        kept = "all" if self.inside else f"{left:.4g}"
        return (
            f"The angle between the angular momentum L and the major axis goes from {first:.5g}° to {last:.5g}°; the "
            f"body ends with {spent:.4g} of its energy and {kept} of its momentum."
        )

    @property
    def notes(self) -> list[str]:
        notes = [*self.spec.remarks]
        if self.inside and self.axes:
            notes += self._leaving()
        elif self.cut:
            notes.append(f"the motion is followed for {MOST_TURNS:.0f} turns of the start; give time.until for more.")
        if self.table.orbital_period is not None:
            notes.append("the verdicts on the axes are those of drag; gravity's pull on the body is left out of them.")
        return notes

    def _leaving(self) -> list[str]:
        """Return what losses inside make of a spin that is not about the major axis."""
        start, moments = np.asarray(self.trajectory.momentum)[0], self.body.principal_moments
        norm, settles = float(self.momentum_norm[0]), self.angle_to_major_axis[-1] <= math.radians(1.0)
        at = [k for k in (0, 1) if moments[k] < moments[2] and angle_to_axis(start, k) <= ON_AXIS]
        if at:
            later = self._from_one_degree()
            then = "" if later is None else f" From 1° off it comes to a flat spin in {duration(later)}."
            why = f"it starts exactly on axis {at[0] + 1}, where nothing pushes it off. The least disturbance makes it "
            return [f"{why}leave, as Explorer 1 did in 1958.{then} Give spin.tilt to see it."]
        found = []
        if moments[0] < moments[1] and 2.0 * float(self.energy[0]) * moments[1] > norm**2:
            found.append("it starts about the axis of least moment, which a body that loses energy inside leaves, as "
                         "Explorer 1 did in 1958, for a flat spin about the axis of largest moment.")  # fmt: skip
        if not settles:
            wanted = settling_time(self.axes, start, moments)
            wait = f' = "{1.1 * wanted:.3g} s"' if math.isfinite(wanted) else ""
            found.append(f"it has not settled; give a later time.until{wait}.")
        return found

    def _from_one_degree(self) -> float | None:
        """Return when a spin 1° off the axis that this one starts on comes to a flat spin [s]; None elsewhere."""
        start, norm = np.asarray(self.trajectory.momentum)[0], float(self.momentum_norm[0])
        moments = self.body.principal_moments
        at = [k for k in (0, 1) if norm and moments[k] < moments[2] and angle_to_axis(start, k) <= ON_AXIS]
        if not self.inside or self.damping is None or not at:
            return None
        off = np.full(3, math.sin(math.radians(1.0)) / math.sqrt(2.0))
        off[at[0]] = math.cos(math.radians(1.0))
        return flat_spin_time(moments, norm * off, self.damping / norm)

    def answers(self) -> list[Group | Table]:
        orbiting = self.table.orbital_period is not None
        losses = Group("Losses", [
            Answer("damping", self.damping, "", "losses inside", "α |L|"),
            Answer("damping_time", self.table.damping_time, "s", "given by the damping time"),
            Answer("loss_rate", self.table.loss_rate, "W", "given by the loss at the start"),
            Answer("linear_drag", self.table.linear_drag, "N m s", "linear drag"),
            Answer("quadratic_drag", self.table.quadratic_drag, "N m s²", "quadratic drag"),
            Answer("orbital_period", self.table.orbital_period, "s", "orbital period"),
            Answer("eccentricity", self.table.eccentricity or 0.0 if orbiting else None, "", "eccentricity"),
        ])  # fmt: skip
        rows = [
            {"axis": k + 1, "moment": self.body.principal_moments[k], "time_constant": time_constant(found),
             **stability_values(found)} for k, found in enumerate(self.axes)
        ]  # fmt: skip
        title = "L along each principal axis, with the losses, at the |L| of the start"
        units = {"moment": "kg m²", "time_constant": "s"}
        axes = verdicts("axes", title, "axis", lambda row: str(row["axis"]), rows, units)
        return [about_body(self.body), losses, axes, self._motion()]

    def _motion(self) -> Group:
        energy, norm, moments = self.energy, self.momentum_norm, self.body.principal_moments
        error = self.trajectory.error_estimate
        start, end = (float(self.angle_to_major_axis[k]) for k in (0, -1))
        lowest = float(0.5 * norm[0] ** 2 / moments[2]) if self.inside else None
        which = "of the approach to the major axis" if self.inside else "of the spin about the major axis, at first"
        return Group("Motion", [
            Answer("start.time", float(self.trajectory.times[0]), "s"),
            Answer("end.time", float(self.trajectory.times[-1]), "s", "time"),
            *self._at_both_ends("energy", energy, "J", "energy"),
            Answer("energy_lost", energy[0] - energy[-1], "J"),
            Answer("lowest_energy", lowest, "J", "lowest energy at this |L|", "at this |L|"),
            *self._at_both_ends("momentum_norm", norm, "kg m²/s", "|L|"),
            *self._at_both_ends("angular_velocity", np.asarray(self.trajectory.angular_velocity), "rad/s", "Ω",
                                "principal axes"),
            Answer("start.angle_to_major_axis", start, "rad", "L to the major axis at the start"),
            Answer("end.angle_to_major_axis", end, "rad", "L to the major axis at the end", "",
                   angle(end, None if error is None else float(error))),
            Answer("time_constant", self.time_constant, "s", f"time constant {which}"),
            *self._flat_spin(),
            *accuracy(self.trajectory, "drift of what is kept or balanced"),
        ])  # fmt: skip

    @property
    def damping(self) -> float | None:
        """α |L| of losses inside; None of others."""
        norm = float(self.momentum_norm[0])
        moments, start = self.body.principal_moments, np.asarray(self.trajectory.momentum)[0]
        return norm * _sink_rate(self.table, moments, start) if self.inside and norm else self.table.damping

    def _flat_spin(self) -> list[Answer]:
        """Return when L comes to stay within 5° of the major axis, by the energy-sink method and in the motion."""
        if not self.inside or self.damping is None or not self.momentum_norm[0]:
            return []
        moments, start = self.body.principal_moments, np.asarray(self.trajectory.momentum)[0]
        away = np.flatnonzero(self.angle_to_major_axis > FLAT)
        seen = None if len(away) and away[-1] == len(self.angle_to_major_axis) - 1 else 0.0
        if seen is not None and len(away):
            seen = float(self.trajectory.times[away[-1] + 1] - self.trajectory.times[0])
        spacing = None if seen is None or not len(away) else float(np.diff(self.trajectory.times)[away[-1]])
        words = None if seen is None else uncertain(seen, spacing, "s")
        expected = flat_spin_time(moments, start, self.damping / float(self.momentum_norm[0]))
        within = "L to stay within 5° of the major axis"
        return [
            Answer("flat_spin_time.energy_sink", expected, "s", f"{FLAT_SPIN}, by mean losses", within),
            Answer("flat_spin_time.from_one_degree", self._from_one_degree(), "s",
                   f"{FLAT_SPIN}, from 1° off", within),
            Answer("flat_spin_time.motion", seen, "s", f"{FLAT_SPIN}, in the motion", f"{within}, at a sample", words),
        ]

    def _at_both_ends(self, name: str, values: Array, unit: str, label: str, explanation: str = "") -> list[Answer]:
        return [
            Answer(f"{end}.{name}", values[k], unit, f"{label} at the {end}", explanation)
            for end, k in (("start", 0), ("end", -1))
        ]


def report_of(spec: Spec) -> DampedBodyReport:
    """Return the report on a body that loses energy inside, as a double bracket, or by drag.

    Raises:
        InvalidInput: for a body with a vanishing moment.
    """
    trajectory, axes, cut = _moved(spec, judged=True)
    return DampedBodyReport(spec, spec.system, trajectory, axes, cut)


def motion_of(spec: Spec) -> SpecMotion:
    """Return the motion alone.

    Raises:
        InvalidInput: for a body with a vanishing moment.
    """
    return SpecMotion(_moved(spec, judged=False)[0], None)


def _moved(spec: Spec, judged: bool) -> tuple[Trajectory, tuple[Stability, ...], bool]:
    """Return the motion, the verdicts if they are asked for or tell when it ends, and whether it is cut short."""
    table, times = spec.system, spec.times
    assert isinstance(table, DampedBodyTable) and spec.body is not None
    moments = spec.body.principal_moments
    if not moments[0] > 0:
        raise InvalidInput(
            "the body is a thin rod: its moment about its own axis is zero, and its spin about it is undefined. "
            "Give it a radius, as a cylinder."
        )
    momentum, attitude = spec.start(moments, spec.body.principal_axes)
    norm = float(np.linalg.norm(momentum))
    system = _system(table, moments, momentum)
    axes = damped_axis_stability(system, norm) if norm and (judged or times is None) else ()
    cut = False
    if times is None:
        end, cut = _end(table, moments, momentum, axes)
        times = np.linspace(0.0, end, spec.samples)
    state = np.concatenate([attitude, momentum])
    steps = _fewest_steps(table, moments, norm, float(np.ptp(times)))
    shown = check_length(spec.until, times, steps, ADAPTIVE)
    # adaptive steps, as they integrate the energy's balance together with the motion
    trajectory = simulate(system, state, times, method=diffrax.Dopri8(), progress=shown)
    return replace(trajectory, frame=spec.body.frame), axes, cut


def _fewest_steps(table: DampedBodyTable, moments: Array, norm: float, span: float) -> float:
    """Return about how many adaptive steps a run takes at least: those of the slowest rotation with this |L|.

    Drag takes |L| itself, and leaves what follows the orbit.
    """
    around = 0.0 if table.orbital_period is None else ORBITING * 2.0 * math.pi / table.orbital_period
    return span * (TURNING * norm / float(np.max(moments)) if table.inside else around)


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
    if not axes:
        return table.orbital_period or 1.0, False
    norm, turn = float(np.linalg.norm(momentum)), 2.0 * math.pi / float(np.linalg.norm(momentum / moments))
    if not table.inside:
        wanted = DECAYS * _drag_time(table, float(moments[2]), norm / float(moments[2]))
    else:
        wanted = settling_time(axes, momentum, moments)
    return min(wanted, MOST_TURNS * turn), wanted > MOST_TURNS * turn
