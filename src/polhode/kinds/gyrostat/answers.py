"""The plain answers about gyrostats: a body with a rotor inside."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, ClassVar, NamedTuple

import numpy as np

from polhode import rotation
from polhode.analysis.energy_casimir import Stability
from polhode.analysis.equilibria import find_equilibria
from polhode.analysis.stability import stability
from polhode.bodies.body import Body, principal_axes
from polhode.bodies.frame import BodyFrame
from polhode.errors import InvalidInput
from polhode.kinds.base import Spec
from polhode.kinds.gyrostat.table import GyrostatTable
from polhode.motion.trajectory import Trajectory
from polhode.reports.base import AbstractReport, Listing, Section
from polhode.reports.length import ADAPTIVE, SPLITTING, TURNING, check_length, equal_steps
from polhode.reports.wording import (
    accuracy_lines,
    angle,
    axes_lines,
    body_section,
    distinct,
    number,
    rate,
    stability_values,
    vector,
    verdicts,
)
from polhode.simulation import simulate
from polhode.systems.gyrostat import Gyrostat, TorquedGyrostat

Array = Any
TURNS = 10
STEP_ANGLE = 0.05  # rad by which the faster of body and momentum turns in a step
ORDER = 6
CLEAN = 1e-14  # components of the rotor's axis below it are rounding of the frame's
FLAT = 1e-9  # curvatures of the energy below it, relative to the largest, vanish

UNITS = {
    "mass": "kg", "center_of_mass": "m, given axes", "principal_moments": "kg m², rotor locked",
    "principal_axes": "columns, in the given frame, rotor locked", "moments": "kg m², those of the motion",
    "axes": "columns, in the given frame; vectors are along them", "rotor.axis": "direction, given axes",
    "rotor.moment": "kg m²", "rotor.rate": "rad/s, relative to the body", "rotor.momentum": "kg m²/s",
    "rotor.motor_torque": "N m", "angular_velocity": "rad/s", "momentum": "kg m²/s", "momentum_norm": "kg m²/s",
    "energy": "J, of the carrier", "rotor_axis_to_momentum": "rad", "nutation_rate": "rad/s, in the body",
    "precession_rate": "rad/s, in space", "equilibria.rate": "1/s", "equilibria.spin": "rad/s, positive along L",
    "equilibria.energy": "J", "equilibria.along": "direction of L", "final.rotor_momentum": "kg m²/s",
    "final.rotor_rate": "rad/s, relative to the body", "final.angular_velocity": "rad/s", "final.energy": "J",
    "final.time": "s", "final.motor_work": "J",
}  # fmt: skip


class Equilibrium(NamedTuple):
    """Steady rotation on the momentum sphere.

    Attributes:
        along: (3,) unit vector of L, axes of the motion.
        spin: Ω along it [rad/s].
        energy: of the carrier [J].
        extremum: "minimum", "maximum", "saddle" or "flat" of the energy on the sphere.
        circle: whether it stands for a circle of them, or for the whole sphere.
        verdict: on it.
    """

    along: Array
    spin: float
    energy: float
    extremum: str
    circle: bool
    verdict: Stability


@dataclass(frozen=True)
class GyrostatReport(AbstractReport):
    """A body with a rotor.

    Attributes:
        table: the rotor as it stands in the spec.
        moments: (3,) of the motion: rotor locked, or of a free rotor less its axial moment [kg m²].
        axes: (3, 3) their axes by columns in the given ones.
        rotor: (3,) its momentum at the start along these axes, relative to the body or, of a free one, whole.
        equilibria: on the momentum sphere, lowest energy first; with a motor as the rotor is at the end.
        nutation_rate: of L about the axis of a symmetric carrier, in the body [rad/s]; None for others.
    """

    kind: ClassVar[str] = "gyrostat"
    spec: Spec
    table: GyrostatTable
    moments: Array
    axes: Array
    rotor: Array
    trajectory: Trajectory
    equilibria: list[Equilibrium]
    nutation_rate: float | None

    @property
    def body(self) -> Body:
        assert self.spec.body is not None
        return self.spec.body

    @property
    def frame(self) -> BodyFrame:
        return BodyFrame(self.moments, self.axes, self.body.center_of_mass, self.body.mass)

    @property
    def free(self) -> bool:
        """Whether nothing, or a motor of given torque, turns the rotor."""
        return isinstance(self.trajectory.source, TorquedGyrostat) or self.table.rotor_drive == "free"

    @property
    def motor(self) -> bool:
        return self.table.motor_torque is not None

    @property
    def axis(self) -> Array:
        """(3,) unit vector of the rotor's axis along those of the motion."""
        return _cleaned(self.axes.T @ _unit(self.table.rotor_axis))

    @property
    def rotor_momentum(self) -> Array:
        """(T,) along its axis [kg m²/s], relative to the body or, of a free one, whole."""
        if self.motor:
            return np.asarray(self.trajectory.part("rotor_momentum"))
        return np.full(len(self.trajectory.times), float(self.rotor @ self.axis))

    @property
    def rotor_rate(self) -> Array:
        """(T,) relative to the body [rad/s]."""
        along = np.asarray(self.trajectory.angular_velocity) @ self.axis if self.free else 0.0
        return self.rotor_momentum / self.table.rotor_moment - along

    @property
    def axis_to_momentum(self) -> Array:
        """(T,) angle from the rotor's axis to L [rad]; zeros without momentum."""
        momentum = np.asarray(self.trajectory.momentum)
        across = np.linalg.norm(np.cross(momentum, self.axis), axis=-1)
        return np.arctan2(across, momentum @ self.axis)

    @property
    def energy(self) -> Array:
        """(T,) ½ Ω·IΩ with the moments of the motion [J]."""
        return 0.5 * np.sum(self.moments * np.asarray(self.trajectory.angular_velocity) ** 2, axis=-1)

    @property
    def motor_work(self) -> float | None:
        """What the motor put into body and rotor up to the end [J]; None without one."""
        return float(self.trajectory.received["energy"][-1]) if self.motor else None

    @property
    def summary(self) -> str:
        if not self.equilibria:
            return "Body and rotor have no momentum together."
        low, high = np.degrees([self.axis_to_momentum.min(), self.axis_to_momentum.max()])
        count = {word: sum(e.verdict.verdict == word for e in self.equilibria) for word in ("stable", "unstable")}
        said = " and ".join(f"{n} {word}" for word, n in count.items() if n)
        end = " as the rotor turns at the end" if self.motor else ""
        return (
            f"L stays between {low:.5g}° and {high:.5g}° from the rotor's axis. On its momentum sphere there are "
            f"{said} steady rotations{end}."
        )

    @property
    def notes(self) -> list[str]:
        notes = []
        if any(e.circle for e in self.equilibria):
            notes.append("two moments are equal: a row stands for the whole circle of equilibria that it lies on.")
        if any(e.verdict.verdict == "stable" and e.extremum == "maximum" for e in self.equilibria):
            notes.append("where the energy has a maximum, losses in the carrier make the body leave in the end.")
        return notes

    def values(self) -> dict[str, Any]:
        momentum, velocity = np.asarray(self.trajectory.momentum), np.asarray(self.trajectory.angular_velocity)
        norm = float(np.linalg.norm(momentum[0]))
        lean = self.axis_to_momentum
        return {
            "mass": self.body.mass,
            "center_of_mass": self.body.center_of_mass,
            "principal_moments": self.body.principal_moments,
            "principal_axes": self.body.principal_axes,
            "moments": self.moments,
            "axes": self.axes,
            "rotor": {
                "axis": _unit(self.table.rotor_axis),
                "moment": self.table.rotor_moment,
                "rate": self.table.rotor_rate,
                "drive": "free" if self.free else "constant-rate",
                "momentum": self.rotor_momentum[0],
                "momentum_is": "whole" if self.free else "relative to the body",
                "motor_torque": self.table.motor_torque,
            },
            "angular_velocity": velocity[0],
            "momentum": momentum[0],
            "momentum_norm": norm,
            "energy": self.energy[0],
            "rotor_axis_to_momentum": {"smallest": lean.min(), "largest": lean.max()} if norm else None,
            "nutation_rate": self.nutation_rate,
            "precession_rate": None if self.nutation_rate is None else norm / self.moments[_symmetry(self.moments) - 1],
            "equilibria": [
                {"along": e.along, "spin": e.spin, "energy": e.energy, "extremum": e.extremum, "circle": e.circle,
                 **stability_values(e.verdict)} for e in self.equilibria
            ],
            "final": {
                "time": float(np.asarray(self.trajectory.times)[-1]),
                "angular_velocity": velocity[-1],
                "rotor_rate": self.rotor_rate[-1],
                "rotor_momentum": self.rotor_momentum[-1],
                "energy": self.energy[-1],
                "motor_work": self.motor_work,
            },
            "status": str(self.trajectory.outcome),
            "units": UNITS,
        }  # fmt: skip

    def sections(self) -> list[Section | Listing]:
        values = self.values()
        rotor, final = values["rotor"], values["final"]
        less = "less the rotor's axial one" if self.free else "rotor locked"
        about_rotor = Section("Rotor", [
            ("axis", vector(rotor["axis"]) + "  (given axes)"),
            ("moment", number(rotor["moment"], "kg m²")),
            ("rate against the body", rate(rotor["rate"])),
            ("drive", f"motor torque {rotor['motor_torque']:.6g} N m" if self.motor else rotor["drive"]),
            (f"momentum, {rotor['momentum_is']}", number(float(rotor["momentum"]), "kg m²/s")),
            ("moments of the motion", f"{distinct(self.moments)} kg m², {less}"),
            *(axes_lines(self.axes) if self.free else []),
        ])  # fmt: skip
        when = ", as the rotor turns at the end" if self.motor else ""
        rows = {f"{vector(e.along)} {e.spin:+.5g} rad/s, energy {e.extremum}": e.verdict for e in self.equilibria}
        listing = verdicts(f"Steady rotations at this |L|{when}", "L along, Ω", rows)
        lean = values["rotor_axis_to_momentum"] or {}
        lines = [
            ("|L|", number(values["momentum_norm"], "kg m²/s")),
            ("energy of the carrier", number(float(values["energy"]), "J")),
            ("Ω at the start", vector(values["angular_velocity"], "rad/s")),
            ("smallest angle, rotor's axis to L", angle(lean.get("smallest"))),
            ("largest", angle(lean.get("largest"))),
            ("nutation in the body", rate(values["nutation_rate"])),
            ("precession in space", rate(values["precession_rate"])),
            ("Ω at the end", vector(final["angular_velocity"], "rad/s")),
            ("rotor against the body at the end", rate(float(final["rotor_rate"]))),
            ("energy of the carrier at the end", number(float(final["energy"]), "J") if self.motor else None),
            ("work of the motor", number(self.motor_work, "J")),
            *accuracy_lines(self.trajectory),
        ]
        parts: list[Section | Listing] = [body_section(self.body), about_rotor]
        return [*parts, *([listing] if rows else []), Section("Motion", lines)]


def report_of(spec: Spec) -> GyrostatReport:
    """Return the report on a body with a rotor, driven at a constant rate, free, or turned by a motor.

    Raises:
        InvalidInput: for a rotor that does not fit into the body.
    """
    table, times = spec.system, spec.times
    assert isinstance(table, GyrostatTable) and spec.body is not None
    axis = _unit(table.rotor_axis)
    _check_fits(spec.body, axis, table.rotor_moment)
    free = table.rotor_drive == "free" or table.motor_torque is not None
    moments, axes = spec.body.principal_moments, spec.body.principal_axes
    velocity, attitude = _start(spec, table.rotor_moment * table.rotor_rate * axis)
    if free:
        moments, axes = principal_axes(spec.body.inertia - table.rotor_moment * np.outer(axis, axis))
    along, velocity = _cleaned(axes.T @ axis), axes.T @ velocity
    attitude = rotation.multiply(attitude, rotation.from_matrix(axes))
    momentum = table.rotor_moment * (table.rotor_rate + (float(along @ velocity) if free else 0.0))
    total = moments * velocity + momentum * along
    if times is None:
        times = np.linspace(0.0, _span(table, moments, velocity, total), spec.samples)
    state = np.concatenate([attitude, total])
    span = float(np.ptp(times))
    if table.motor_torque is None:
        steps = equal_steps(span, _rate(moments, velocity, total), table.step)
        check_length(spec.until, times, steps, SPLITTING, "A longer `system.step` takes less.")
        trajectory = simulate(Gyrostat(moments, momentum * along), state, times, order=ORDER,
                              step=table.step or _step(moments, velocity, total))  # fmt: skip
        last = momentum
    else:
        system = TorquedGyrostat(moments, along, table.rotor_moment, table.motor_torque)
        steps = max(_driven_steps(table, moments, along, total, span), span / (table.step or math.inf))
        shown = check_length(spec.until, times, steps, ADAPTIVE)
        trajectory = simulate(system, np.append(state, momentum), times, step=table.step, progress=shown)
        last = float(trajectory.part("rotor_momentum")[-1])
    k = _symmetry(moments, along)
    nutation = None
    if k is not None and table.motor_torque is None:
        nutation = float(((moments[k] - moments[k - 1]) * velocity[k] + momentum * along[k]) / moments[k - 1])
    found = steady_rotations(moments, last * along, float(np.linalg.norm(total)))
    return GyrostatReport(spec, table, moments, axes, momentum * along, trajectory, found, nutation)


def steady_rotations(moments: Array, rotor: Array, norm: float) -> list[Equilibrium]:
    """Return the equilibria on the sphere |L| = norm with verdicts, lowest energy first; none for norm zero.

    On a carrier of revolution about the rotor's axis, where (Π − h)/I = λ Π, they are the two poles and, for
    |h| I1 < |L| |I1 − I3|, a circle at Π3 = h I1/(I1 − I3), of which one point is given.

    Args:
        moments: (3,) [kg m²].
        rotor: (3,) h [kg m²/s].
        norm: |L| [kg m²/s].
    """
    if not norm:
        return []
    system, k = Gyrostat(moments, rotor), _symmetry(moments, rotor)
    if k is None:
        level = -norm * _unit(rotor) if rotor.any() else norm * np.eye(3)[0]  # where the body does not rest
        points = [(point, False) for point in find_equilibria(system, level)]
    elif (moments == moments[0]).all() and not rotor.any():
        points = [(norm * np.eye(3)[0], True)]
    else:
        pole, side = np.eye(3)[k], np.eye(3)[(k + 1) % 3]
        points = [(norm * pole, False), (-norm * pole, False)]
        gap = moments[k - 1] - moments[k]
        if abs(rotor[k]) * moments[k - 1] < norm * abs(gap):
            height = rotor[k] * moments[k - 1] / gap
            points.append((height * pole + math.sqrt(norm**2 - height**2) * side, True))
    found = []
    for point, circle in points:
        velocity = (point - rotor) / moments
        multiplier = float(velocity @ point) / norm**2
        verdict, energy = stability(system, point), float(system.energy(point))
        along = _cleaned(point / norm)
        found.append(
            Equilibrium(along, multiplier * norm, energy, _extremum(moments, along, multiplier), circle, verdict)
        )
    return sorted(found, key=lambda e: e.energy)


def _extremum(moments: Array, along: Array, multiplier: float) -> str:
    """Return what the energy has on the sphere: the curvature is that of ½ Σ (1/I − λ) δΠ² on the tangent plane."""
    across = np.linalg.svd(along[None])[2][1:]
    bends = np.linalg.eigvalsh(across @ np.diag(1.0 / moments - multiplier) @ across.T)
    bends = np.where(np.abs(bends) < FLAT * np.max(1.0 / moments), 0.0, bends)
    if (bends == 0).all():
        return "flat"
    if bends[0] < 0 < bends[1]:
        return "saddle"
    return "maximum" if bends[0] < 0 else "minimum"


def _check_fits(body: Body, axis: Array, moment: float) -> None:
    """Refuse a rotor whose inertia, at least that of a thin disk, leaves none that a carrier could have."""
    inertia = body.inertia - 0.5 * moment * (np.eye(3) + np.outer(axis, axis))
    try:
        fits = bool(Body(None, (0.0, 0.0, 0.0), inertia).principal_moments[0] > 0)
    except InvalidInput:
        fits = False
    if not fits or not axis @ body.inertia @ axis > moment:
        raise InvalidInput(
            f"`system.rotor_moment` must be that of a part of the body; got {moment:.6g} kg m², beside which the body "
            f"would be left with moments of at most {vector(principal_axes(inertia)[0])} kg m². No body has these; "
            "check rotor_moment and rotor_axis, and that [body] has the rotor in it."
        )


def _start(spec: Spec, rotor: Array) -> tuple[Array, Array]:
    """Return Ω (3,) along the given axes and their attitude (4,); a momentum in the spec is the whole one.

    Args:
        spec: with the start.
        rotor: (3,) relative momentum of the rotor [kg m²/s, given axes].
    """
    assert spec.body is not None
    moments, axes = spec.body.principal_moments, spec.body.principal_axes
    momentum, attitude = spec.start(moments, axes)
    if spec.spin is not None and spec.spin.momentum is not None:
        momentum = momentum - axes.T @ rotor
    back = rotation.conjugate(rotation.from_matrix(axes))
    return axes @ (momentum / moments), rotation.multiply(attitude, back)


def _symmetry(moments: Array, rotor: Array | None = None) -> Any:
    """Return the axis about which the other two moments are equal, and the rotor's momentum nothing; else None."""
    for k in (2, 0, 1):
        i, j = (k + 1) % 3, (k + 2) % 3
        if moments[i] == moments[j] and (rotor is None or not (rotor[i] or rotor[j])):
            return k
    return None


def _rate(moments: Array, velocity: Array, total: Array) -> float:
    """Return how fast body or momentum turn [rad/s]; beside a fast rotor L goes round a body that hardly turns."""
    return max(float(np.linalg.norm(velocity)), float(np.linalg.norm(total)) / float(np.min(moments)))


def _step(moments: Array, velocity: Array, total: Array) -> float | None:
    turning = _rate(moments, velocity, total)
    return STEP_ANGLE / turning if turning else None


def _driven_steps(table: GyrostatTable, moments: Array, along: Array, total: Array, span: float) -> float:
    """Return how many adaptive steps a run takes at least: L stays in space, so the carrier turns back as h grows.

    L turns in the carrier by the whole angle, the quaternion of a steady rotation by half of it: twice as many steps.
    """
    grown = 0.5 * abs(table.motor_torque or 0.0) * span * float(np.linalg.norm(along / moments))
    turned = (grown - float(np.linalg.norm(total)) / float(np.min(moments))) * span
    return 2.0 * TURNING * max(turned, 0.0)


def _span(table: GyrostatTable, moments: Array, velocity: Array, total: Array) -> float:
    """Return ten turns [s], or of a body at rest the time in which its motor gives the rotor ten."""
    turning = max(float(np.linalg.norm(velocity)), float(np.linalg.norm(total)) / float(np.max(moments)))
    if turning:
        return TURNS * 2.0 * math.pi / turning
    torque = abs(table.motor_torque or 0.0)
    return math.sqrt(4.0 * math.pi * TURNS * table.rotor_moment / torque) if torque else 1.0


def _unit(values: Array) -> Array:
    array = np.asarray(values, dtype=float)
    array = array / np.abs(array).max()  # so that squares neither vanish nor overflow
    return array / np.linalg.norm(array)


def _cleaned(direction: Array) -> Array:
    return np.where(np.abs(direction) < CLEAN, 0.0, direction)
