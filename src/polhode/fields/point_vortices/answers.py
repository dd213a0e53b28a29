"""The answers about point vortices."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import ClassVar, NamedTuple

import numpy as np

from polhode.analysis.energy_casimir import Stability
from polhode.errors import InvalidInput
from polhode.fields.point_vortices.equilibria import VortexTurn, vortex_stability, vortex_turn
from polhode.fields.point_vortices.system import PlaneVortices, SphereVortices
from polhode.fields.point_vortices.table import VorticesTable
from polhode.kinds.base import Spec
from polhode.motion._trajectory import Trajectory
from polhode.reports.about import about_stability, accuracy, from_motion, motion_error
from polhode.reports.answer import Answer, Group, Table
from polhode.reports.base import WITHOUT_MOTION, MotionReport
from polhode.reports.length import Watch
from polhode.reports.wording import duration, number, rate, vector
from polhode.simulation import simulate
from polhode.types import Array, Float64


class VorticesReportLimits(NamedTuple):
    """What the report on point vortices attempts.

    Attributes:
        max_judged_vortices: beyond it no verdict is given: second derivatives of all pairs are dense matrices.
    """

    max_judged_vortices: int = 40


LIMITS = VorticesReportLimits()


@dataclass(frozen=True)
class VorticesReport(MotionReport):
    """Point vortices: conserved quantities, rigid rotation and its stability, and the motion.

    Attributes:
        system: the vortices; on a sphere those of the unit sphere, with equal angular rates.
        sphere_radius: [m]; None in a plane.
        trajectory: samples of the motion.
        turn: of a rigid rotation; None where distances between vortices change.
        verdict: on the stability of that rotation; None without a rotation or a verdict.
        no_verdict: why a rotation has no verdict; empty otherwise.
    """

    kind: ClassVar[str] = "point-vortices"
    system: SphereVortices | PlaneVortices
    sphere_radius: float | None
    trajectory: Trajectory
    turn: VortexTurn | None
    verdict: Stability | None
    no_verdict: str = ""

    @property
    def strengths(self) -> Float64[Array, "n"]:
        """(n,) circulations [m²/s]."""
        return np.asarray(self.system.strengths) * (1.0 if self.sphere_radius is None else self.sphere_radius**2)

    @property
    def positions(self) -> Float64[Array, "time n k"]:
        """(T, n, 2) in the plane or (T, n, 3) from the centre of the sphere [m]."""
        unit = 1.0 if self.sphere_radius is None else self.sphere_radius
        return unit * np.asarray(self.system.positions(self.trajectory.states))

    @property
    def closest(self) -> tuple[float, float, tuple[int, int]]:
        """Least straight-line distance among the samples [m], its time [s], and the pair, counted from 1."""
        best = (math.inf, 0.0, (1, 2))
        places = self.positions
        for one in range(places.shape[1] - 1):
            apart = np.linalg.norm(places[:, one + 1 :] - places[:, one : one + 1], axis=-1)
            row, other = np.unravel_index(int(np.argmin(apart)), apart.shape)
            if apart[row, other] < best[0]:
                pair = (one + 1, one + 2 + int(other))
                best = float(apart[row, other]), float(np.asarray(self.trajectory.times)[row]), pair
        return best

    @property
    def summary(self) -> str:
        place = "in a plane" if self.sphere_radius is None else "on a sphere"
        who = f"{len(self.strengths)} vortices {place}"
        if self.turn is None:
            closest = f"the closest two come to {self.closest[0]:.4g} m"
            return f"The {who} change their distances; {self.rounded(closest)}."
        return f"The {who} {self._moves()}{self._describe_verdict()}."

    def _moves(self) -> str:
        turn = self.turn
        assert turn is not None
        if turn.rate:
            return f"turn as a whole in {duration(2.0 * math.pi / abs(turn.rate))}"
        if turn.velocity is not None and np.any(turn.velocity):
            return f"move straight at {float(np.linalg.norm(turn.velocity)):.6g} m/s"
        return "rest"

    def _describe_verdict(self) -> str:
        if self.verdict is None:
            return ""
        if self.verdict.verdict == "unstable" and self.verdict.rate:
            return f", but that is unstable: disturbances double in {math.log(2.0) / self.verdict.rate:.4g} s"
        words = {"stable": ", which is proved stable", "unstable": ", which is unstable"}
        return words.get(self.verdict.verdict, "; whether that is stable stays undecided")

    @property
    def notes(self) -> list[str]:
        notes = []
        if self.sphere_radius is not None and abs(self.strengths.sum()) > 1e-12 * np.abs(self.strengths).sum():
            notes.append("a uniform vorticity over the sphere makes up for the sum of the strengths; it moves nothing.")
        if self.turn is None and len(self.strengths) > 3:
            notes.append("more than three vortices may move chaotically: small differences of the start then grow.")
        if self.no_verdict:
            notes.append(f"no verdict: {self.no_verdict}")
        return notes

    @property
    def answers(self) -> list[Group | Table]:
        return [self._about_vortices(), self.about_turn(), self._table(), self._motion()]

    def _about_vortices(self) -> Group:
        strengths, on_sphere = self.strengths, self.sphere_radius is not None
        total, start = float(strengths.sum()), self.positions[0]
        moment = strengths @ start
        if on_sphere:
            own = [Answer("moment_of_vorticity", moment, "m³/s", "moment of vorticity J = ΣΓx", "from the centre",
                          vector(moment, "m³/s"))]  # fmt: skip
        else:
            center = moment / total if abs(total) > 1e-12 * np.abs(strengths).sum() else None
            words = "none: the strengths add up to zero" if center is None else vector(center, "m")
            own = [Answer("impulse", moment, "m³/s", "", "ΣΓx and ΣΓy"),
                   Answer("angular_impulse", float(strengths @ np.sum(start**2, axis=1)), "m⁴/s", "", "ΣΓ|z|²"),
                   Answer("center_of_vorticity", center, "m", "centre of vorticity", "", words)]  # fmt: skip
        return Group("Vortices", [
            Answer("surface", "sphere" if on_sphere else "plane", "", "surface"),
            Answer("sphere_radius", self.sphere_radius, "m", "radius"),
            Answer("strengths", strengths, "m²/s"),
            Answer("total_strength", total, "m²/s", "sum of the strengths", "", number(total, "m²/s")),
            *own,
        ])

    def about_turn(self) -> Group:
        turn, verdict = self.turn, self.verdict
        if turn is None:
            return Group("As a whole", [Answer("turn", None, "", "turns as a whole", "", "no: distances change")])
        period = 2.0 * math.pi / abs(turn.rate) if turn.rate else None
        values = [
            Answer("turn.rate", turn.rate, "rad/s", "turns at", "", rate(turn.rate)),
            Answer("turn.period", period, "s", "period", "", duration(period)),
            Answer("turn.axis", turn.axis, "", "axis", "", None if turn.axis is None else vector(turn.axis)),
            Answer("turn.center", turn.center, "m", "centre", "",
                   None if turn.center is None else vector(turn.center, "m")),
            Answer("turn.velocity", turn.velocity, "m/s", "velocity", "",
                   vector(turn.velocity, "m/s") if turn.velocity is not None and np.any(turn.velocity) else None),
        ]  # fmt: skip
        if verdict is not None:
            growing = f"{verdict.verdict}, growth {verdict.rate:.6g} /s" if verdict.rate else verdict.verdict
            values += [*about_stability("stability", verdict), Answer("", None, "", "verdict", "", growing),
                       Answer("", None, "", "because", "", verdict.words)]
        return Group("As a whole", values)

    def _table(self) -> Table:
        first, last = self.positions[0], self.positions[-1]
        rows = [
            {"vortex": k + 1, "strength": float(self.strengths[k]), "start": first[k].tolist(), "end": last[k].tolist()}
            for k in range(len(first))
        ]
        columns = {
            "vortex": lambda row: str(row["vortex"]),
            "strength": lambda row: f"{row['strength']:.6g} m²/s",
            "start": lambda row: self._place(row["start"]),
            "end": lambda row: self._place(row["end"]),
        }
        units = {"strength": "m²/s", "start": "m", "end": "m"}
        return Table("vortices", "Places", columns, rows, units, shown=lambda row: row["vortex"] <= 12,
                     errors={"end": motion_error(self.trajectory)})

    def _place(self, place: list[float]) -> str:
        if self.sphere_radius is None:
            return vector(place, "m") or ""
        latitude = math.degrees(math.asin(max(-1.0, min(1.0, place[2] / self.sphere_radius))))
        polar = 90.0 - 1e-5  # degrees of latitude from which a longitude means nothing
        if abs(latitude) > polar:
            return f"{latitude:.5g}°"
        return f"{_plain(latitude):.5g}°, {_plain(math.degrees(math.atan2(place[1], place[0]))):.5g}°"

    def _motion(self) -> Group:
        distance, time, pair = self.closest
        words = f"{distance:.6g} m, vortices {pair[0]} and {pair[1]} at {time:.6g} s"
        closest = Answer("closest.distance", distance, "m", "closest among the samples", "in a straight line", words)
        return Group("Motion", [
            *from_motion(self.trajectory, [closest]),
            Answer("closest.time", time, "s"),
            Answer("closest.vortices", list(pair)),
            *accuracy(self.trajectory),
        ])


def _plain(degrees: float) -> float:
    return 0.0 if abs(degrees) < 1e-9 else degrees


def make_report(spec: Spec[VorticesTable]) -> VorticesReport:
    """Return the report on point vortices.

    Raises:
        InvalidInput: for two vortices at one place, or a time that takes too many steps.
    """
    table = spec.system
    system, state, radius = _start(table)
    state = system.check_state(state)
    times = np.linspace(0.0, _usual_end(system, state), spec.samples) if spec.times is None else spec.times
    trajectory = simulate(system, state, times, progress=Watch(spec.until, times))
    turn = _find_turn(system, state)
    verdict, why = _judge(system, state, turn)
    return VorticesReport(system, radius, trajectory, turn, verdict, why)


def answers_without_motion(spec: Spec[VorticesTable]) -> Iterator[Group | Table]:
    """Yield the answers of the report that need no trajectory.

    Raises:
        InvalidInput: for two vortices at one place.
    """
    system, state, radius = _start(spec.system)
    state = system.check_state(state)
    turn = _find_turn(system, state)
    yield VorticesReport(system, radius, WITHOUT_MOTION, turn, *_judge(system, state, turn)).about_turn()


def _start(table: VorticesTable) -> tuple[SphereVortices | PlaneVortices, Array, float | None]:
    """Return the system, its first state, and the sphere's radius [m]."""
    strengths = np.asarray(table.strengths)
    if table.positions is not None or table.ring_radius is not None:
        plane = PlaneVortices(strengths)
        state = plane.pack(table.positions) if table.positions is not None else plane.polygon(table.ring_radius or 0.0)
        return plane, state, None
    radius = 1.0 if table.sphere_radius is None else table.sphere_radius
    sphere = SphereVortices(strengths / radius**2)
    if table.ring_latitude is not None:
        return sphere, sphere.ring(0.5 * math.pi - table.ring_latitude), radius
    latitude, longitude = np.asarray(table.coordinates).T
    along = np.cos(latitude)
    directions = np.stack([along * np.cos(longitude), along * np.sin(longitude), np.sin(latitude)], axis=-1)
    return sphere, sphere.pack(directions), radius


def _usual_end(system: SphereVortices | PlaneVortices, state: Array) -> float:
    """Return the default length of a run [s]: some revolutions of vortices at such distances."""
    places = np.asarray(system.positions(state))
    size = float(np.linalg.norm(places - places.mean(axis=0), axis=-1).mean())
    turnovers = 10.0  # revolutions of vortices of this strength about each other
    return turnovers * 4.0 * math.pi**2 * size**2 / float(np.abs(np.asarray(system.strengths)).sum())


def _judge(
    system: SphereVortices | PlaneVortices, state: Array, turn: VortexTurn | None
) -> tuple[Stability | None, str]:
    """Return the verdict, or why there is none."""
    if turn is None:
        return None, ""
    if len(system.strengths) > LIMITS.max_judged_vortices:
        return None, f"it is given for at most {LIMITS.max_judged_vortices} vortices."
    try:
        return vortex_stability(system, state), ""
    except InvalidInput as error:  # strengths or distances differ so much that derivatives are lost in rounding
        return None, str(error)


def _find_turn(system: SphereVortices | PlaneVortices, state: Array) -> VortexTurn | None:
    try:
        return vortex_turn(system, state)
    except InvalidInput:  # distances change
        return None
