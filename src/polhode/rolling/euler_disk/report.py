"""The answers about a disk that rolls on a plane, until it lies flat or for a given time."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import ClassVar, NamedTuple

import numpy as np

from polhode.motion._trajectory import Trajectory
from polhode.reports.about import about_stability, accuracy, from_motion, stability_values, verdicts
from polhode.reports.answer import Answer, Group, Table
from polhode.reports.base import MotionReport
from polhode.reports.wording import rate, uncertain
from polhode.rolling.euler_disk._power_law import PowerLaw
from polhode.rolling.euler_disk.laws import LAWS
from polhode.rolling.euler_disk.spin_down import END_OF_REGIME, SpinDown, predicted_exponents
from polhode.rolling.euler_disk.spin_down import LIMITS as SPIN_DOWN
from polhode.rolling.euler_disk.steady_rolling import SteadyRolling
from polhode.rolling.euler_disk.system import LAYOUT, EulerDisk
from polhode.rolling.euler_disk.table import EulerDiskTable
from polhode.rolling.euler_disk.turns import DiskPath
from polhode.types import Array

EVENTS = {END_OF_REGIME: "power laws hold up to"}  # labels of the report's rows; other events are their own labels
ENDS = {"flat": "lies flat", "lift-off": "lifts off the table", "on edge": "stands on its edge"}


class ReportLimits(NamedTuple):
    """What the report says of exponents and laws."""

    relative_uncertainty: float = 0.3  # of an exponent; a larger one does not distinguish 1/3, 4/9 and 1/2
    dominant_share: float = 0.9  # of the power, from which on one law is said to dominate


LIMITS = ReportLimits()


class LawShare(NamedTuple):
    """The dissipation of one law.

    Attributes:
        law: as a spec names it.
        exponent: n of α ∝ (t0 − t)^n if it alone acted.
        power: at the start [W].
        share: of the power at the start.
        share_late: of the power over the samples that exponents are fitted to, None without a fit.
    """

    law: str
    exponent: float
    power: float
    share: float
    share_late: float | None

@dataclass(frozen=True)
class EulerDiskReport(MotionReport):
    """The report on one motion of a rolling disk.

    Attributes:
        table: the table [system] of the spec.
        disk: the system.
        begin: state at the start.
        steady: None where no steady motion is near the start.
        laws: of dissipation.
        spin_down: how the motion ends; None without dissipation, or for a motion over a given time.
        end_by_energy: t0 by energy alone [s], None where it diverges or the motion does not end.
        path: the last turns of the contact of a motion that is followed to its end, else the first ones.
        opening: of a motion that is followed to its end, the first turn.
        thresholds: speed [m/s] and rate [rad/s] above which upright rolling and spinning are stable; None elsewhere.
    """

    kind: ClassVar[str] = "euler-disk"
    table: EulerDiskTable
    disk: EulerDisk
    trajectory: Trajectory
    begin: Array
    steady: SteadyRolling | None
    laws: list[LawShare]
    spin_down: SpinDown | None
    end_by_energy: float | None
    path: DiskPath
    opening: DiskPath | None
    thresholds: tuple[float, float] | None

    @property
    def shown(self) -> Trajectory:
        states = np.asarray(self.path.states)
        vectors, energy = self.disk.vectors(states), np.asarray(self.disk.energy(states))
        return replace(
            self.trajectory, times=np.asarray(self.path.times), states=states, attitude=np.asarray(vectors.attitude),
            momentum=np.asarray(vectors.momentum), angular_velocity=np.asarray(vectors.angular_velocity), invariants={},
            balances={"energy": energy}, received={}, outcome=self.path.outcome,
        )

    @property
    def shown_part(self) -> str:
        event = self.path.outcome.event
        return "" if event is None else f"Shown: the last turns, until the disk is {event}."

    @property
    def dominant(self) -> LawShare | None:
        """The law that dissipates most of the power over the samples that exponents are fitted to."""
        laws = [law for law in self.laws if law.share_late is not None]
        return max(laws, key=lambda law: law.share_late or 0.0, default=None)

    @property
    def turns(self) -> float:
        """Number of turns of the contact."""
        heading = np.asarray(self.trajectory.part("heading"))
        return abs(float(heading[-1] - heading[0])) / (2.0 * math.pi)

    @property
    def lowest_force(self) -> float:
        """The least normal force [N] of all samples, dense ones included."""
        states = (self.trajectory.states, self.path.states)
        return min(float(np.min(np.asarray(self.disk.normal_force(np.asarray(x))))) for x in states)

    @property
    def energies(self) -> tuple[float, float]:
        """Energy [J] at the start and at the end."""
        first, last = (float(self.disk.energy(self.trajectory.states[k])) for k in (0, -1))
        return first, last

    @property
    def summary(self) -> str:
        spin_down, end = self.spin_down, float(self.trajectory.times[-1])
        turns = self.rounded(f"{self.turns:.4g}")
        if spin_down is None:
            event = self.trajectory.outcome.event
            how = "rolls on" if event is None else f"ends: {event}"
            return f"The disk {how} after {end:.6g} s and {turns} turns of its contact."
        if spin_down.first_event is None:
            return f"In {end:.6g} s the disk goes round {turns} times, and its end is not reached."
        ends = [(name, time) for name, time in spin_down.events.items() if name != END_OF_REGIME]
        words = [f"{ENDS.get(name, name)} after {time:.8g} s" for name, time in ends]
        rounds = f"The disk goes round {turns} times" + (f" and {', then '.join(words)}." if words else ".")
        regime, end_time = spin_down.events.get(END_OF_REGIME), ""
        if spin_down.end is not None:
            end_time = f"; by them the tilt would vanish at {uncertain(spin_down.end, spin_down.end_uncertainty, 's')}"
        return rounds + ("" if regime is None else f" Its power laws hold up to {regime:.8g} s{end_time}.")

    @property
    def notes(self) -> list[str]:
        spin_down, dominant, notes = self.spin_down, self.dominant, []
        if spin_down is not None and dominant is not None and (dominant.share_late or 0.0) < LIMITS.dominant_share:
            notes.append("no law takes nearly all of the power where exponents are fitted: they lie between the laws', "
                         "and their uncertainty is that of the fit alone.")
        if spin_down is not None and self.table.thickness:
            notes.append("laws are predicted for a thin disk. A thick one does not keep its centre at rest: the spin "
                         "that losses leave it holds a part of the weight, and Ω grows more slowly by it than as "
                         "tilt^(−1/2).")
        if spin_down is not None and spin_down.first_event is None:
            notes.append("followed through four decades of tilt or a million steps without an event.")
        return notes

    @property
    def answers(self) -> list[Group | Table]:
        end = [] if self.spin_down is None else [self._exponents(self.spin_down), self._end(self.spin_down)]
        none = [] if end else [Group("", [Answer("spin_down", None)])]
        return [*self.without_motion(), self._laws(), *end, *none, self._motion()]

    def without_motion(self) -> list[Group | Table]:
        """Return the answers that need no trajectory."""
        return [self._disk(), self._start(), *self._steady()]

    def _disk(self) -> Group:
        table, mechanics = self.table, self.disk.mechanics
        axial, diametral = float(mechanics.axial_moment), float(mechanics.diametral_moment)
        return Group("Disk", [
            Answer("mass", table.mass, "kg", "mass"),
            Answer("radius", table.radius, "m", "radius"),
            Answer("thickness", table.thickness, "m", "thickness", "", None if table.thickness else "none (thin)"),
            Answer("axial_moment", axial, "kg m²"),
            Answer("diametral_moment", diametral, "kg m²"),
            Answer("", None, "", "moments, axial and diametral", "", f"{axial:.8g}, {diametral:.8g} kg m²"),
            Answer("gravity", table.gravity, "m/s²"),
        ])

    def _start(self) -> Group:
        state = self.begin
        start = {part.name: float(LAYOUT.part(state, part.name)) for part in LAYOUT.parts}
        rates = [start["tilt_rate"], start["rise_rate"], start["spin"]]
        precession = float(self.disk.precession(state))
        rolling, spinning = self.thresholds or (None, None)
        nutation = None if self.steady is None else self.steady.nutation
        ratio = nutation / abs(precession or math.inf) if nutation else None
        small = f"{rate(nutation)} = {ratio:.6g} times the precession" if ratio else None
        return Group("Start", [
            Answer("start.tilt", start["tilt"], "rad", "tilt from the plane"),
            Answer("start.heading", start["heading"], "rad"),
            Answer("start.precession", precession, "rad/s", "precession Ω of the contact"),
            Answer("start.face_rate", float(self.disk.face_rate(state)), "rad/s", "turning of a picture on its face"),
            Answer("start.spin", start["spin"], "rad/s", "spin about the axis"),
            Answer("start.tilt_rate", start["tilt_rate"], "rad/s", "rate of the tilt"),
            Answer("start.angular_velocity", math.hypot(*rates), "rad/s", "", "magnitude"),
            Answer("", None, "", "small nutation", "", small),
            Answer("critical_rolling_speed", rolling, "m/s", "rolls stably upright from"),
            Answer("critical_spin_rate", spinning, "rad/s", "spins stably upright from"),
            Answer("start.energy", float(self.disk.energy(state)), "J", "energy"),
            Answer("start.normal_force", float(self.disk.normal_force(state)), "N", "normal force"),
        ])

    def _steady(self) -> list[Group | Table]:
        steady = self.steady
        if steady is None:
            return [Group("", [Answer("steady", None)])]
        values = Group("", [
            Answer("steady.precession", float(self.disk.precession(steady.state)), "rad/s"),
            Answer("steady.spin", float(LAYOUT.part(steady.state, "spin")), "rad/s"),
            Answer("steady.nutation", steady.nutation, "rad/s"),
            *about_stability("steady.stability", steady.verdict),
        ])
        title = "Steady rolling at this tilt and precession without dissipation, in tilt and rates"
        tilt = math.degrees(float(LAYOUT.part(steady.state, "tilt")))
        rows = [stability_values(steady.verdict)]
        return [values, verdicts("", title, "motion", lambda row: f"tilt {tilt:.6g}°", rows)]

    def _laws(self) -> Table:
        columns = {
            "law": lambda row: row["law"],
            "power at first": lambda row: f"{row['power']:.4g} W",
            "share": lambda row: f"{row['share']:.4g}",
            "share when fitted": lambda row: "–" if row["share_late"] is None else f"{row['share_late']:.4g}",
            "its exponent n": lambda row: _word(row["exponent"]),
        }
        units = {
            "power": "W, at the start", "share": "of the power, at the start",
            "share_late": "of the power, in the half of the samples that is fitted",
        }  # fmt: skip
        return Table("laws", "Dissipation", columns, [law._asdict() for law in self.laws], units)

    def _exponents(self, spin_down: SpinDown) -> Table:
        law = "None" if self.dominant is None else self.dominant.law
        said = {
            "tilt_exponent": ("tilt ∝ (t0 − t)^n", f"{law}, of a thin disk" if self.table.thickness else law),
            "precession_exponent": ("Ω ∝ (t0 − t)^k", law),
            "precession_by_tilt_exponent": ("Ω ∝ tilt^k", "any law; not −1"),
            "unspun_by_tilt_exponent": ("Ω without the spin's part ∝ tilt^k", "any law and any disk; not −1"),
        }
        rows = [{"name": name, **values} for name, values in self._fits(spin_down).items()]
        columns = {
            "law": lambda row: said[row["name"]][0],
            "fitted": lambda row: uncertain(row["fitted"], row["uncertainty"]) + (
                ", too uncertain to compare"
                if row["uncertainty"] > LIMITS.relative_uncertainty * abs(row["fitted"]) else ""),
            "predicted": lambda row: (
                "–" if row["predicted"] is None else f"{_word(row['predicted'])} ({said[row['name']][1]})"
            ),
        }
        title = f"Exponents, fitted where |tilt rate|/(tilt·Ω) < {SPIN_DOWN.fitted_adiabaticity:g}"
        return Table("", title, columns, rows)

    def _fits(self, spin_down: SpinDown) -> dict[str, dict[str, float | None]]:
        """Return the exponents as fitted and as predicted by the dominant law."""
        law = None if self.dominant is None else self.disk.dissipation[self.laws.index(self.dominant)]
        wanted = (None, None, None) if law is None else predicted_exponents(law)
        tilt, precession, by_tilt = wanted
        if self.table.thickness:  # whose centre is not at rest
            precession = by_tilt = None
        return {
            "tilt_exponent": _exponent(spin_down.tilt, tilt),
            "precession_exponent": _exponent(spin_down.precession, precession),
            "precession_by_tilt_exponent": _exponent(spin_down.precession_by_tilt, by_tilt),
            "unspun_by_tilt_exponent": _exponent(spin_down.unspun_by_tilt, -0.5),
        }

    def _end(self, spin_down: SpinDown) -> Group:
        dominant, exact = self.dominant, spin_down.end
        t0 = None if exact is None else uncertain(exact, spin_down.end_uncertainty, "s")
        by_energy = None if self.end_by_energy is None else f"{self.end_by_energy:.6g} s"
        events = [
            Answer("", None, "", EVENTS.get(name, name), "",
                   f"{time:.10g} s{_before(exact, time, spin_down.end_uncertainty)}")
            for name, time in spin_down.events.items()
        ]
        return Group("End", [
            Answer("spin_down.end", exact, "s", "t0, by the power laws", "from the start", t0),
            Answer("spin_down.end_uncertainty", spin_down.end_uncertainty, "s"),
            Answer("spin_down.end_by_energy", self.end_by_energy, "s", "t0 by energy alone", "", by_energy),
            Answer("spin_down.first_event", spin_down.first_event),
            Answer("spin_down.events", spin_down.events, "s", "", "from the start"),
            *events,
            Answer("spin_down.dominant_law", None if dominant is None else dominant.law),
            *(Answer(f"spin_down.{name}", values) for name, values in self._fits(spin_down).items()),
            Answer("spin_down.energy_balance", spin_down.energy_balance),
        ])

    def _motion(self) -> Group:
        (first, last), lowest = self.energies, self.lowest_force
        of_weight = lowest / (self.table.mass * self.table.gravity)
        left = f" = {last / first:.4g} of the start's" if self.laws else ""
        return Group("Motion", [
            Answer("end_time", float(self.trajectory.times[-1]), "s"),
            *from_motion(self.trajectory, [
                Answer("turns", self.turns, "", "turns of the contact", "of the contact"),
                Answer("end_energy", last, "J", "energy at the end", "", f"{last:.8g} J{left}"),
                Answer("normal_force_minimum", lowest, "N", "lowest normal force", "",
                       f"{lowest:.6g} N = {of_weight:.4g} of the weight"),
                Answer("normal_force_minimum_of_weight", of_weight, "1"),
            ]),
            *accuracy(self.trajectory, "energy balance" if self.laws else "drift"),
        ])


def _exponent(fit: PowerLaw, predicted: float | None) -> dict[str, float | None]:
    return {"fitted": fit.exponent, "uncertainty": fit.uncertainty, "predicted": predicted}


def _before(end: float | None, time: float, uncertainty: float | None) -> str:
    """Return in words how long before t0 [s] an event happens; empty where t0 is less certain than that."""
    if end is None or uncertainty is None or not uncertainty < abs(time - end):
        return ""
    return f", t0 − {uncertain(end - time, uncertainty, 's')}" if time < end else ", after t0"


def _word(exponent: float) -> str:
    names = {1 / 3: "1/3", 4 / 9: "4/9", 1 / 2: "1/2", 2 / 3: "2/3", 2 / 9: "2/9", 1 / 6: "1/6", 1 / 4: "1/4"}
    word = names.get(abs(exponent), f"{abs(exponent):.4g}")
    return f"−{word}" if exponent < 0 else word


def law_names(table: EulerDiskTable) -> list[str]:
    """Return the names of the laws of a spec, numbered by place if they occur more than once."""
    names = [law.law for law in table.dissipation]
    assert all(name in LAWS for name in names)
    return [name if names.count(name) == 1 else f"{name} {k + 1}" for k, name in enumerate(names)]
