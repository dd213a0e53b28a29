"""The plain answers about bodies that lose energy, inside or by drag."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import Any, ClassVar

import diffrax
import jax
import jax.numpy as jnp
import numpy as np

from polhode.analysis.energy_casimir import Stability
from polhode.analysis.first_method import first_method
from polhode.bodies.body import Body
from polhode.bodies.frame import BodyFrame
from polhode.errors import InvalidInput
from polhode.kinds.base import Spec
from polhode.kinds.damped_body.table import DampedBodyTable
from polhode.motion.trajectory import Trajectory
from polhode.reports.base import AbstractReport, Listing, Section
from polhode.reports.length import ADAPTIVE, ORBITING, TURNING, check_length
from polhode.reports.wording import (
    accuracy_lines,
    angle,
    body_section,
    body_summary,
    number,
    stability_values,
    vector,
    verdicts,
)
from polhode.simulation import simulate
from polhode.systems.double_bracket import DoubleBracket
from polhode.systems.kepler_orbit import KeplerOrbit
from polhode.systems.torqued_body import TorquedBody
from polhode.systems.torques import AbstractTorque, GravityGradient, LinearDrag, QuadraticDrag

Array = Any
SETTLED = 12.0  # time constants in which what is left of an angle is 6e-6 of it
DECAYS = 5.0  # time constants of drag followed where no end is given
MOST_TURNS = 2000.0  # of the start, followed where no end is given
ON_AXIS = 1e-9  # angle [rad] below which a start counts as being on an axis

UNITS = {
    "mass": "kg", "center_of_mass": "m, given axes", "principal_moments": "kg m²",
    "principal_axes": "columns, in the given frame", "damping": "α |L|", "linear_drag": "N m s",
    "quadratic_drag": "N m s²", "orbital_period": "s", "start.energy": "J", "start.momentum_norm": "kg m²/s",
    "start.angular_velocity": "rad/s, principal axes", "start.angle_to_major_axis": "rad", "start.time": "s",
    "end.energy": "J", "end.momentum_norm": "kg m²/s", "end.angular_velocity": "rad/s, principal axes",
    "end.angle_to_major_axis": "rad", "end.time": "s", "energy_lost": "J", "lowest_energy": "J, at this |L|",
    "time_constant": "s", "axes.rate": "1/s", "axes.moment": "kg m²", "axes.time_constant": "s",
}  # fmt: skip


@dataclass(frozen=True)
class DampedBodyReport(AbstractReport):
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
    def frame(self) -> BodyFrame:
        return BodyFrame.of(self.body)

    @property
    def inside(self) -> bool:
        """Whether the losses are inside the body, which keeps L."""
        return self.table.damping is not None

    @property
    def energy(self) -> Array:
        """(T,) of rotation [J]."""
        name = "energy" if self.inside else "kinetic_energy"
        return np.asarray(self.trajectory.balances[name])

    @property
    def momentum_norm(self) -> Array:
        """(T,) |L| [kg m²/s]."""
        return np.linalg.norm(np.asarray(self.trajectory.momentum), axis=-1)

    @property
    def angle_to_major_axis(self) -> Array:
        """(T,) angle from L to the nearest line of largest moment [rad]."""
        momentum, moments = np.asarray(self.trajectory.momentum), self.body.principal_moments
        major = moments == moments[2]
        return np.arctan2(np.linalg.norm(momentum[:, ~major], axis=-1), np.linalg.norm(momentum[:, major], axis=-1))

    @property
    def time_constant(self) -> float | None:
        """Of the last approach to the major axis, or of the spin about it that drag brakes, at the start [s]."""
        if self.inside or not self.axes:
            return _time_constant(self.axes[2]) if self.axes else None
        moment, spin = self.body.principal_moments[2], self.momentum_norm[0] / self.body.principal_moments[2]
        return float(moment / ((self.table.linear_drag or 0.0) + (self.table.quadratic_drag or 0.0) * spin))

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
            f"L goes from {first:.5g}° to {last:.5g}° from the major axis; the body ends with {spent:.4g} of its "
            f"energy and {kept} of its momentum."
        )

    @property
    def notes(self) -> list[str]:
        notes = []
        if self.inside and self.axes and self.angle_to_major_axis[-1] > math.radians(1.0):
            at = [k for k in (0, 1) if _off(np.asarray(self.trajectory.momentum)[0], k) <= ON_AXIS]
            why = f"it starts exactly on axis {at[0] + 1}, where nothing pushes it off" if at else "it has not settled"
            notes.append(f"{why}; " + ("give spin.tilt." if at else "give a later time.until."))
        elif self.cut:
            notes.append(f"the motion is followed for {MOST_TURNS:.0f} turns of the start; give time.until for more.")
        if self.table.orbital_period is not None:
            notes.append("the verdicts on the axes are those of drag; gravity's pull on the body is left out of them.")
        return notes

    def _state(self, k: int) -> dict[str, Any]:
        return {
            "time": np.asarray(self.trajectory.times)[k],
            "energy": self.energy[k],
            "momentum_norm": self.momentum_norm[k],
            "angular_velocity": np.asarray(self.trajectory.angular_velocity)[k],
            "angle_to_major_axis": self.angle_to_major_axis[k],
        }

    def values(self) -> dict[str, Any]:
        moments, norm = self.body.principal_moments, self.momentum_norm
        return {
            **body_summary(self.body),
            "damping": self.table.damping,
            "linear_drag": self.table.linear_drag,
            "quadratic_drag": self.table.quadratic_drag,
            "orbital_period": self.table.orbital_period,
            "eccentricity": None if self.table.orbital_period is None else self.table.eccentricity or 0.0,
            "start": self._state(0),
            "end": self._state(-1),
            "energy_lost": self.energy[0] - self.energy[-1],
            "lowest_energy": 0.5 * norm[0] ** 2 / moments[2] if self.inside else None,
            "time_constant": self.time_constant,
            "axes": [
                {"axis": k + 1, "moment": moments[k], "time_constant": _time_constant(found), **stability_values(found)}
                for k, found in enumerate(self.axes)
            ],
            "status": str(self.trajectory.outcome),
            "units": UNITS,
        }

    def sections(self) -> list[Section | Listing]:
        values, start, end = self.values(), self._state(0), self._state(-1)
        losses = Section("Losses", [
            ("inside, α |L|", number(self.table.damping)),
            ("linear drag", number(self.table.linear_drag, "N m s")),
            ("quadratic drag", number(self.table.quadratic_drag, "N m s²")),
            ("orbital period", number(self.table.orbital_period, "s")),
            ("eccentricity", number(values["eccentricity"])),
        ])  # fmt: skip
        rows = {str(k + 1): found for k, found in enumerate(self.axes)}
        listing = verdicts("L along each principal axis, with the losses, at the |L| of the start", "axis", rows)
        word = "of the approach to the major axis" if self.inside else "of the spin about the major axis, at first"
        lines = [
            ("time", number(float(end["time"]), "s")),
            ("energy at the start", number(float(start["energy"]), "J")),
            ("energy at the end", number(float(end["energy"]), "J")),
            ("lowest energy at this |L|", number(values["lowest_energy"], "J")),
            ("|L| at the start", number(float(start["momentum_norm"]), "kg m²/s")),
            ("|L| at the end", number(float(end["momentum_norm"]), "kg m²/s")),
            ("Ω at the start", vector(start["angular_velocity"], "rad/s")),
            ("Ω at the end", vector(end["angular_velocity"], "rad/s")),
            ("L to the major axis at the start", angle(float(start["angle_to_major_axis"]))),
            ("L to the major axis at the end", angle(float(end["angle_to_major_axis"]))),
            (f"time constant {word}", number(values["time_constant"], "s")),
            *accuracy_lines(self.trajectory, "drift of what is kept or balanced"),
        ]
        parts: list[Section | Listing] = [body_section(self.body), losses]
        return [*parts, *([listing] if rows else []), Section("Motion", lines)]


def report_of(spec: Spec) -> DampedBodyReport:
    """Return the report on a body that loses energy inside, as a double bracket, or by drag.

    Raises:
        InvalidInput: for a body with a vanishing moment.
    """
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
    system = _system(table, moments, norm)
    axes = tuple(_verdict(system, moments, norm, k) for k in range(3)) if norm else ()
    cut = False
    if times is None:
        end, cut = _end(table, moments, momentum, axes)
        times = np.linspace(0.0, end, spec.samples)
    state = np.concatenate([attitude, momentum])
    steps = _fewest_steps(table, moments, norm, float(np.ptp(times)))
    shown = check_length(spec.until, times, steps, ADAPTIVE)
    # adaptive steps, as they integrate the energy's balance beside the motion
    trajectory = simulate(system, state, times, method=diffrax.Dopri8(), progress=shown)
    return DampedBodyReport(spec, table, trajectory, axes, cut)


def _fewest_steps(table: DampedBodyTable, moments: Array, norm: float, span: float) -> float:
    """Return about how many adaptive steps a run takes at least: those of the slowest rotation with this |L|.

    Drag takes |L| itself, and leaves what follows the orbit.
    """
    around = 0.0 if table.orbital_period is None else ORBITING * 2.0 * math.pi / table.orbital_period
    return span * (TURNING * norm / float(np.max(moments)) if table.damping is not None else around)


def _system(table: DampedBodyTable, moments: Array, norm: float) -> DoubleBracket | TorquedBody:
    if table.damping is not None:
        return DoubleBracket(moments, table.damping / norm if norm else 0.0)
    torques: list[AbstractTorque] = []
    if table.linear_drag is not None:
        torques.append(LinearDrag(table.linear_drag))
    if table.quadratic_drag is not None:
        torques.append(QuadraticDrag(table.quadratic_drag))
    if table.orbital_period is not None:
        orbit = KeplerOrbit(2.0 * math.pi / table.orbital_period, table.eccentricity or 0.0)
        torques.append(GravityGradient(orbit, moments))
    return TorquedBody(moments, torques)


def _verdict(system: DoubleBracket | TorquedBody, moments: Array, norm: float, k: int) -> Stability:
    """Judge principal axis k as a direction n of L, |L| frozen: ṅ is the field less its part along n.

    Under drag L itself dies away; whether it meanwhile turns towards the axis or away from it is what is judged.
    """
    if isinstance(system, TorquedBody):
        system = TorquedBody(moments, [torque for torque in system.torques if not torque.needs_attitude])

    def turning(direction: Array) -> Array:
        field = system.vector_field(0.0, norm * direction) / norm
        return field - direction * jnp.sum(field * direction)

    axis = np.eye(3)[k]
    across = np.delete(np.eye(3), k, axis=1)
    found = first_method(np.asarray(jax.jacfwd(turning)(jnp.asarray(axis))), across)
    return found if found.verdict != "undecided" else _along_family(found, moments, k)


def _along_family(found: Stability, moments: Array, k: int) -> Stability:
    """Return the verdict where what does not decay is the drift along other axes of the same moment, all alike at rest.

    Across a circle of equilibria the exponent decides: where it is negative, neighbours settle on the circle as near as
    they started.
    """
    alike = int((moments == moments[k]).sum())
    if alike == 3:
        return replace(found, verdict="stable", certificate="every axis of a sphere is a rest of L")
    rest = float(np.min(found.spectrum.real))
    if alike == 2 and rest < 0 and np.min(np.abs(found.spectrum)) < abs(rest) * 1e-6:
        text = f"neighbours settle on the circle of axes of equal moment, as near as they start: {rest:.6g}/s across it"
        return replace(found, verdict="stable", rate=rest, certificate=text)
    return found


def _time_constant(found: Stability) -> float | None:
    return 1.0 / abs(found.rate) if found.rate else None


def _end(
    table: DampedBodyTable, moments: Array, momentum: Array, axes: tuple[Stability, ...]
) -> tuple[float, bool]:
    """Return a time by which the motion has settled, and whether it is cut short."""
    if not axes:
        return table.orbital_period or 1.0, False
    norm, turn = float(np.linalg.norm(momentum)), 2.0 * math.pi / float(np.linalg.norm(momentum / moments))
    if table.damping is None:
        spin = norm / float(moments[2])
        wanted = DECAYS * float(moments[2]) / ((table.linear_drag or 0.0) + (table.quadratic_drag or 0.0) * spin)
    else:
        wanted = SETTLED * (_time_constant(axes[2]) or turn)
        for k in (0, 1):
            off = _off(momentum, k)
            if axes[k].verdict == "unstable" and ON_AXIS < off < 1.0:
                wanted += math.log(1.0 / off) / axes[k].rate
    return min(wanted, MOST_TURNS * turn), wanted > MOST_TURNS * turn


def _off(momentum: Array, k: int) -> float:
    """Return the angle between a momentum and axis k, either end [rad]."""
    return math.atan2(float(np.linalg.norm(np.delete(momentum, k))), abs(float(momentum[k])))
