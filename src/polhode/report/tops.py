"""The plain answers about tops: a body turning about a fixed point under its weight."""

from __future__ import annotations

import math
import warnings
from dataclasses import dataclass, field, replace
from typing import Any, ClassVar

import numpy as np

from polhode import rotation
from polhode.analysis.energy_casimir import Stability
from polhode.analysis.stability import stability
from polhode.bodies.frame import BodyFrame
from polhode.errors import InvalidInput
from polhode.exact.lagrange_top import LagrangeMotion
from polhode.exact.steady_precession import SteadyPrecession, sleeping_threshold, steady_precession
from polhode.report.base import AbstractReport, Listing, Section
from polhode.report.length import check_length, equal_steps, splitting_step
from polhode.report.wording import (
    angle,
    axes_lines,
    distinct,
    drifts,
    number,
    rate,
    stability_values,
    vector,
    verdicts,
)
from polhode.simulation import fastest_rate, simulate
from polhode.spec.reading import Spec
from polhode.spec.systems import HeavyTopTable, LagrangeTopTable
from polhode.systems.heavy_top import ALONG, HeavyTop
from polhode.systems.top_integrals import EQUAL
from polhode.trajectory import Trajectory

Array = Any
PERIODS = 10
EVEN = 1e-12  # radians between the limits of a tilt below which it is constant, but for rounding of what was given


@dataclass(frozen=True)
class TopReport(AbstractReport):
    """What both kinds of top have: the body about its pivot, the path of its axis, and its upright and hanging rest.

    Attributes:
        top: moments, axis and weight at the pivot.
        pivot: (3,) [m, given axes].
        verdicts: on the axis upright and hanging, at the spin about it that the motion starts with.
        free: whether the fixed point is the centre of mass.
        warned: what the integrator had to say.
    """

    kind: ClassVar[str] = "heavy-top"
    spec: Spec
    top: HeavyTop
    pivot: Array
    trajectory: Trajectory
    verdicts: dict[str, Stability]
    free: bool
    warned: tuple[str, ...] = ()

    @property
    def frame(self) -> BodyFrame:
        body = self.spec.body
        center, mass = (np.zeros(3), None) if body is None else (body.center_of_mass, body.mass)
        return BodyFrame(np.asarray(self.top.moments), np.asarray(self.top.axes), center, mass, self.pivot)

    @property
    def axis_in_space(self) -> Array:
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

    def values(self) -> dict[str, Any]:
        tilt = np.arccos(np.clip(self.axis_in_space[:, 2], -1.0, 1.0))
        first = {name: np.asarray(value)[0] for name, value in self.trajectory.invariants.items()}
        return {
            "mass": self.frame.mass,
            "center_of_mass": self.frame.center_of_mass,
            "pivot": self.pivot,
            "principal_moments": np.asarray(self.top.moments),
            "principal_axes": np.asarray(self.top.axes),
            "axis": np.asarray(self.top.axis),
            "mgl": float(self.top.mgl),
            "integrable_case": None if self.top.case is None else self.top.case[0],
            "tilt": {"smallest": tilt.min(), "largest": tilt.max()},
            "invariants": first,
            "equilibria": {name: stability_values(found) for name, found in self.verdicts.items()},
            "status": self.trajectory.status,
            "units": UNITS | {f"invariants.{name}": INVARIANT_UNITS[name] for name in first},
        }

    def sections(self) -> list[Section | Listing]:
        values = self.values()
        body = Section("Body about the fixed point", [
            ("mass", number(values["mass"], "kg")),
            ("fixed point", vector(self.pivot, "m") + "  (given axes)"),
            ("principal moments there", distinct(values["principal_moments"], "kg m²")),
            *axes_lines(values["principal_axes"]),
            ("centre of mass along", vector(values["axis"]) + "  (principal axes)"),
            ("weight × distance mgl", number(values["mgl"], "N m")),
            ("integrable case", values["integrable_case"] or "none"),
        ])  # fmt: skip
        standing = [verdicts("Axis to the centre of mass at rest", "position", self.verdicts)] if self.verdicts else []
        return [body, *standing, self.motion()]

    def motion(self) -> Section:
        """Return what is said of the motion."""
        values = self.values()
        kept = [(name.replace("_", " "), number(float(x), INVARIANT_UNITS[name]))
                for name, x in values["invariants"].items()]  # fmt: skip
        lean = values["tilt"]
        lines = [("smallest tilt sampled", angle(lean["smallest"])), ("largest tilt sampled", angle(lean["largest"]))]
        return Section("Motion", [*lines, *kept, ("drift", drifts(self.trajectory.drift))])


UNITS = {
    "mass": "kg", "center_of_mass": "m, given axes", "pivot": "m, given axes",
    "principal_moments": "kg m², about the pivot", "principal_axes": "columns, in the given frame",
    "axis": "direction from pivot to centre of mass, principal axes", "mgl": "N m", "tilt": "rad, of the samples",
    "equilibria.rate": "1/s",
}  # fmt: skip
LAGRANGE_UNITS = {
    "energy": "J", "nutation_limits": "cos of the tilt", "nutation_period": "s", "precession_per_period": "rad",
    "spin_per_period": "rad", "precession_rate": "rad/s", "spin_rate": "rad/s", "steady_precession": "rad/s",
    "sleeping_threshold": "rad/s", "spin": "rad/s", "start_tilt": "rad",
}  # fmt: skip
INVARIANT_UNITS = {
    "energy": "J", "vertical_momentum": "kg m²/s", "axial_momentum": "kg m²/s", "|Γ|²": "",
    "Euler's |Π|²": "kg² m⁴/s²", "Lagrange's Π·χ": "kg m²/s", "Kovalevskaya's integral": "1/s⁴",
    "Goryachev and Chaplygin's integral": "1/s³",
}  # fmt: skip
NAMES = {"|P|²": "|Γ|²", "Π·P": "vertical_momentum"}  # the Casimirs of se(3)*, called by what they are here


@dataclass(frozen=True)
class LagrangeTopReport(TopReport):
    """The symmetric top, exactly.

    Attributes:
        exact: its motion in closed form.
        steady: rates of steady precession at the tilt and spin of the start.
        threshold: spin from which the upright top is stable [rad/s].
    """

    kind: ClassVar[str] = "lagrange-top"
    exact: LagrangeMotion = field(kw_only=True)
    steady: SteadyPrecession | None = field(kw_only=True)
    threshold: float = field(kw_only=True)

    @property
    def even(self) -> bool:
        """Whether the axis goes round at constant tilt, steadily but for rounding."""
        low, high = self.exact.nutation_limits
        if self.exact.regime not in ("undulating", "cusp", "loop") or low is None or high is None:
            return self.exact.regime == "steady"
        return math.acos(low) - math.acos(high) < EVEN

    @property
    def summary(self) -> str:
        exact, period = self.exact, self.exact.nutation_period
        if self.even and exact.precession_rate is not None:
            return f"The top precesses steadily at constant tilt, at {exact.precession_rate:.6g} rad/s."
        words = _REGIMES[exact.regime]
        if exact.regime == "sleeping" and abs(self.values()["spin"]) < self.threshold:
            words = "The top stands upright, spinning too slowly to sleep: the least push fells it."
        if period is None:
            return words
        mean = None if exact.regime == "planar" else exact.precession_rate
        turn = "" if mean is None else f" and precesses at {mean:.6g} rad/s on average"
        return f"{words} It nutates every {period:.6g} s{turn}."

    def values(self) -> dict[str, Any]:
        exact = self.exact
        return super().values() | {
            "regime": exact.regime,
            "energy": exact.energy,
            "spin": float(exact.momentum_at_epoch[2] / exact.moments[2]),
            "start_tilt": math.acos(max(-1.0, min(1.0, float(self.axis_in_space[0, 2])))),
            "nutation_limits": exact.nutation_limits,
            "nutation_period": exact.nutation_period,
            "precession_per_period": exact.precession_per_period,
            "spin_per_period": exact.spin_per_period,
            # in a plane both only jump by half turns, through the verticals
            "precession_rate": None if exact.regime == "planar" else exact.precession_rate,
            "spin_rate": None if exact.regime == "planar" else exact.spin_rate,
            "steady_precession": None if self.steady is None else self.steady._asdict(),
            "sleeping_threshold": self.threshold,
            "units": super().values()["units"] | LAGRANGE_UNITS,
        }

    def motion(self) -> Section:
        values = self.values()
        low, high = self.exact.nutation_limits
        limits = None if low is None else f"{math.degrees(math.acos(low)):.8g}°, constant" if self.even else (
            f"{math.degrees(math.acos(high)):.8g}° to {math.degrees(math.acos(low)):.8g}°"
        )  # fmt: skip
        steady = None if self.steady is None else ", ".join(
            f"{name} {value:.8g} rad/s" for name, value in self.steady._asdict().items() if value is not None
        )  # fmt: skip
        return Section("Motion", [
            ("regime", "steady" if self.even else values["regime"]),
            ("spin about the axis", rate(values["spin"])),
            ("spin from which it sleeps", rate(self.threshold)),
            ("tilt", limits),
            *([] if self.even else [
                ("nutation period T", number(values["nutation_period"], "s")),
                ("precession per period Δφ", angle(values["precession_per_period"])),
                ("own turn per period Δψ", angle(values["spin_per_period"])),
            ]),
            ("mean precession", rate(values["precession_rate"])),
            ("mean own turn", rate(values["spin_rate"])),
            ("steady precession at this tilt", steady),
            ("energy", number(values["energy"], "J")),
            ("vertical momentum", number(self.exact.vertical_momentum, "kg m²/s")),
            ("axial momentum", number(self.exact.axial_momentum, "kg m²/s")),
            ("drift", drifts(self.trajectory.drift)),
        ])  # fmt: skip


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


def heavy_top_report(spec: Spec, table: HeavyTopTable, times: Array | None) -> TopReport:
    """Return the report on any body about a fixed point, by splitting into exact flows.

    Raises:
        InvalidInput: for a body without mass.
    """
    top, free = _top(spec, table)
    momentum, attitude = _start(spec, table, top)
    state = top.state(rotation.multiply(attitude, rotation.conjugate(rotation.from_matrix(np.asarray(top.axes)))),
                      momentum=np.asarray(top.axes) @ momentum)  # fmt: skip
    if times is None:
        times = np.linspace(0.0, PERIODS * _natural_period(top, momentum), spec.samples)
    rate, span = fastest_rate(top, state), float(np.ptp(times))
    check_length(spec.until, times, equal_steps(span, rate, table.step, table.order), splitting_step(table.order),
                 'A longer `system.step` takes less, and kind = "lagrange-top" none, if it is one.')  # fmt: skip
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always", UserWarning)
        trajectory = _called(simulate(top, state, times, step=table.step, order=table.order))
    warned = tuple(str(warning.message) for warning in caught)
    return TopReport(spec, top, np.asarray(table.pivot), trajectory, _verdicts(top, momentum), free, warned)


def _called(trajectory: Trajectory) -> Trajectory:
    """Return the trajectory with its invariants called by what they are for a top."""
    rename = lambda values: {NAMES.get(k, k): v for k, v in values.items() if k != "linear_space"}  # noqa: E731
    return replace(trajectory, invariants=rename(trajectory.invariants), drift=rename(trajectory.drift))


def lagrange_top_report(spec: Spec, table: LagrangeTopTable, times: Array | None) -> LagrangeTopReport:
    """Return the report on a symmetric body about a point of its axis, exactly.

    Raises:
        InvalidInput: for a body without mass, or one not symmetric about the line to its centre of mass.
    """
    top, free = _top(spec, table)
    top = _axis_third(top)
    momentum, attitude = _start(spec, table, top)
    exact = LagrangeMotion(np.asarray(top.moments), float(top.mgl), momentum, attitude)
    if times is None:
        span = exact.nutation_period or _natural_period(top, momentum)
        times = np.linspace(0.0, PERIODS * span, spec.samples)
    moments = (float(top.moments[0]), float(top.moments[0]), float(top.moments[2]))
    axis = rotation.rotate(exact.state(0.0)[0], np.array([0.0, 0.0, 1.0]))
    tilt = math.acos(max(-1.0, min(1.0, float(axis[2]))))
    spin = float(momentum[2]) / moments[2]
    steady = steady_precession(moments, float(top.mgl), tilt, spin) if 1e-12 < tilt < math.pi - 1e-12 else None
    return LagrangeTopReport(
        spec, top, np.asarray(table.pivot), exact.sample(times), _verdicts(top, momentum), free,
        exact=exact, steady=steady, threshold=sleeping_threshold(moments, float(top.mgl)),
    )  # fmt: skip


def _top(spec: Spec, table: HeavyTopTable | LagrangeTopTable) -> tuple[HeavyTop, bool]:
    """Return the top and whether it is free, its fixed point being the centre of mass."""
    assert spec.body is not None
    if spec.body.mass is None:
        raise InvalidInput("`body.mass` is needed for the weight of a top; give it beside moments or inertia.")
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        top = HeavyTop.from_body(spec.body, table.pivot, table.gravity)
    return top, bool(caught)


def _start(spec: Spec, table: HeavyTopTable | LagrangeTopTable, top: HeavyTop) -> tuple[Array, Array]:
    """Return momentum along and attitude of the principal axes; with ``lean`` the axis leans towards −y."""
    axes = np.asarray(top.axes)
    momentum, attitude = spec.start(np.asarray(top.moments), axes)
    if table.lean is None:
        return momentum, attitude
    axis = axes @ np.asarray(top.axis)
    upright = rotation.shortest_between(axis, (0.0, 0.0, 1.0))
    if float(top.mgl) == 0.0:
        raise InvalidInput("`system.lean` needs a centre of mass apart from the fixed point; leave it out.")
    leaning = rotation.multiply(np.array([*_half_turn(table.lean), 0.0, 0.0]), upright)
    return momentum, rotation.multiply(leaning, rotation.from_matrix(axes))


def _half_turn(angle: float) -> tuple[float, float]:
    """Return cosine and sine of half an angle from 0 to π, exact at its ends and alike at π/2."""
    if abs(angle - 0.5 * math.pi) < 1e-15:
        return math.sqrt(0.5), math.sqrt(0.5)
    return (0.0, 1.0) if abs(angle - math.pi) < 1e-15 else (math.cos(0.5 * angle), math.sin(0.5 * angle))


def _axis_third(top: HeavyTop) -> HeavyTop:
    """Return a symmetric top along axes whose third points to the centre of mass, moments of the others equal."""
    moments, axes = np.asarray(top.moments), np.asarray(top.axes)
    case, k = top.case or ("none", 0)
    axis = np.asarray(top.axis)
    if case == "Euler":  # any axis of symmetry will do
        pairs = [k for k in range(3) if abs(moments[(k + 1) % 3] - moments[(k + 2) % 3]) <= EQUAL * moments.max()]
        case, k = ("Lagrange", pairs[0]) if pairs else ("none", 0)
        axis = np.eye(3)[k]
    if case != "Lagrange":
        raise InvalidInput(
            f"the body is not symmetric about the line from pivot to centre of mass; its moments there are "
            f"{distinct(moments)} kg m², the line {vector(axis)} along their axes. Ask for kind = \"heavy-top\"."
        )
    if k < 0:
        first = rotation.perpendicular(axis)
        turned = np.stack([first, np.cross(axis, first), axis], axis=-1)
        return HeavyTop((moments[1],) * 3, float(top.mgl), (0.0, 0.0, 1.0), axes @ turned)  # equal but for rounding
    i, j = (k + 1) % 3, (k + 2) % 3
    side = -1.0 if axis[k] < 0 else 1.0
    turned = np.stack([np.eye(3)[i], side * np.eye(3)[j], side * np.eye(3)[k]], axis=-1)
    return HeavyTop((moments[i], moments[i], moments[k]), float(top.mgl), (0.0, 0.0, 1.0), axes @ turned)


def _verdicts(top: HeavyTop, momentum: Array) -> dict[str, Stability]:
    """Return verdicts on the axis upright and hanging; spinning where it is a principal axis, else at rest."""
    axis = np.asarray(top.axis)
    k = int(np.argmax(np.abs(axis)))
    along = np.linalg.norm(np.delete(axis, k)) <= ALONG
    spin = float(momentum[k] * axis[k] / top.moments[k]) if along else 0.0
    if float(top.mgl) == 0.0:
        return {}
    words = f"at {abs(spin):.6g} rad/s" if spin else "at rest"
    found = {"upright": stability(top, top.upright(spin)), "hanging": stability(top, top.upright(spin, hanging=True))}
    return {f"{name}, {words}": _in_a_tops_words(verdict) for name, verdict in found.items()}


def _in_a_tops_words(found: Stability) -> Stability:
    """Return a verdict with the Casimirs of se(3)* and Lagrange's integral called by what they are here."""
    text = found.certificate.replace("|P|²", "|Γ|²").replace("Π·P", "Π·Γ").replace("Lagrange's ", "")
    return replace(found, certificate=text)


def _natural_period(top: HeavyTop, momentum: Array) -> float:
    """Return the time of a small swing, or of a turn where there is no weight."""
    largest = float(np.max(np.asarray(top.moments)))
    if float(top.mgl) != 0.0:
        return 2.0 * math.pi * math.sqrt(largest / abs(float(top.mgl)))
    turn = float(np.linalg.norm(momentum / np.asarray(top.moments)))
    return 2.0 * math.pi / turn if turn else 0.1
