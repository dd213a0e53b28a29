"""The plain answers about a disk that rolls on a plane, until it lies flat or for as long as it is watched."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import Any, ClassVar, NamedTuple

import numpy as np

from polhode.analysis.energy_casimir import Stability
from polhode.analysis.power_law import PowerLaw
from polhode.analysis.spin_down import ASYMPTOTIC_FIT, SpinDown
from polhode.bodies.frame import BodyFrame
from polhode.kinds.euler_disk.laws import LAWS
from polhode.kinds.euler_disk.table import EulerDiskTable
from polhode.motion.outcome import Outcome
from polhode.motion.trajectory import Trajectory
from polhode.reports.base import AbstractReport, Listing, Section
from polhode.reports.wording import accuracy_lines, angle, number, rate, stability_values, verdicts
from polhode.systems.euler_disk import LAYOUT, EulerDisk

Array = Any
PURE = 0.9  # of the power, from which on one law is said to dominate

UNITS = {
    "mass": "kg", "radius": "m", "thickness": "m", "axial_moment": "kg m²", "diametral_moment": "kg m²",
    "gravity": "m/s²", "start.tilt": "rad", "start.heading": "rad", "start.precession": "rad/s", "start.spin": "rad/s",
    "start.tilt_rate": "rad/s", "start.energy": "J", "start.angular_velocity": "rad/s, magnitude",
    "start.face_rate": "rad/s", "start.normal_force": "N", "steady.precession": "rad/s", "steady.spin": "rad/s",
    "steady.nutation": "rad/s", "steady.stability.rate": "1/s", "critical_rolling_speed": "m/s",
    "critical_spin_rate": "rad/s", "laws.power": "W, at the start", "laws.share": "of the power, at the start",
    "laws.share_late": "of the power, in the half of the samples that is fitted", "spin_down.end": "s from the start",
    "spin_down.end_uncertainty": "s", "spin_down.end_by_energy": "s", "spin_down.events": "s from the start",
    "end_time": "s", "end_energy": "J", "turns": "of the contact", "normal_force_minimum": "N",
    "normal_force_minimum_of_weight": "1",
}  # fmt: skip


class Steady(NamedTuple):
    """The steady motion of the disk without dissipation, at the tilt it starts with.

    Attributes:
        state: (8,).
        verdict: on it.
        nutation: frequency of small nutation [rad/s], None where unstable.
    """

    state: Array
    verdict: Stability
    nutation: float | None


class LawShare(NamedTuple):
    """What a law takes.

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


class Path(NamedTuple):
    """Part of a motion, sampled densely.

    Attributes:
        times: (T,) [s].
        states: (T, 8).
        outcome: how it ends.
    """

    times: Array
    states: Array
    outcome: Outcome

    def part(self, name: str) -> Array:
        """Return a part of the states by name (T,)."""
        return LAYOUT.part(self.states, name)

    @property
    def contact(self) -> Array:
        """The point of contact (T, 2) [m]."""
        return np.stack([self.part("contact_x"), self.part("contact_y")], axis=-1)


@dataclass(frozen=True)
class EulerDiskReport(AbstractReport):
    """What is said of one motion of a disk.

    Attributes:
        table: what the spec asks for.
        disk: what moves.
        steady: None where no steady motion is near the start.
        laws: of dissipation.
        spin_down: how it ends; None without dissipation, or where it is only watched for a time.
        end_by_energy: t0 by energy alone [s], None where it diverges or the motion does not end.
        path: the last turns of the contact of a motion that is followed to its end, else the first ones.
        opening: of a motion that is followed to its end, the first turn.
        thresholds: speed [m/s] and rate [rad/s] above which upright rolling and spinning are stable; None elsewhere.
    """

    kind: ClassVar[str] = "euler-disk"
    table: EulerDiskTable
    disk: EulerDisk
    trajectory: Trajectory
    steady: Steady | None
    laws: list[LawShare]
    spin_down: SpinDown | None
    end_by_energy: float | None
    path: Path
    opening: Path | None
    thresholds: tuple[float, float] | None

    @property
    def shown(self) -> Trajectory:
        states = np.asarray(self.path.states)
        found, energy = self.disk.vectors(states), np.asarray(self.disk.energy(states))
        return replace(
            self.trajectory, times=np.asarray(self.path.times), states=states, attitude=np.asarray(found.attitude),
            momentum=np.asarray(found.momentum), angular_velocity=np.asarray(found.angular_velocity), invariants={},
            balances={"energy": energy}, received={}, outcome=self.path.outcome,
        )  # fmt: skip

    @property
    def frame(self) -> BodyFrame:
        A, C = (float(x) for x in (self.disk.mechanics.diametral_moment, self.disk.mechanics.axial_moment))
        return BodyFrame(np.array([A, A, C]), np.eye(3), np.zeros(3), self.table.mass)

    @property
    def dominant(self) -> LawShare | None:
        """The law that takes most of the power where exponents are fitted."""
        found = [law for law in self.laws if law.share_late is not None]
        return max(found, key=lambda law: law.share_late or 0.0, default=None)

    @property
    def turns(self) -> float:
        """How often the contact goes round."""
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
        found, end = self.spin_down, float(self.trajectory.times[-1])
        if found is None:
            event = self.trajectory.outcome.event
            how = "rolls on" if event is None else f"ends: {event}"
            return f"The disk {how} after {end:.6g} s and {self.turns:.4g} turns of its contact."
        if found.first_event is None:
            return f"In {end:.6g} s the disk goes round {self.turns:.4g} times, and its end is not reached."
        events = ", then ".join(f"{name} at {time:.8g} s" for name, time in found.events.items())
        t0 = "" if found.end is None else f" The tilt would vanish at t0 = {found.end:.8g} s."
        return f"The disk goes round {self.turns:.4g} times and ends: {events}.{t0}"

    @property
    def notes(self) -> list[str]:
        found, dominant, notes = self.spin_down, self.dominant, []
        if found is not None and dominant is not None and (dominant.share_late or 0.0) < PURE:
            notes.append("no law takes nearly all of the power where exponents are fitted: they lie between the laws', "
                         "and their uncertainty is that of the fit alone.")  # fmt: skip
        if found is not None and self.table.thickness:
            notes.append("laws are predicted for a thin disk. A thick one does not keep its centre at rest and bends "
                         "them: exponents then differ by more than their uncertainty.")  # fmt: skip
        if found is not None and found.first_event is None:
            notes.append("followed through four decades of tilt or a million steps without an event.")
        return notes

    def values(self) -> dict[str, Any]:
        table, disk, state = self.table, self.disk, self.trajectory.states[0]
        tilt, heading, _, _, _, *rates = (float(x) for x in state)
        first, last = self.energies
        precession = float(disk.precession(state))
        return {
            "mass": table.mass,
            "radius": table.radius,
            "thickness": table.thickness,
            "axial_moment": float(disk.mechanics.axial_moment),
            "diametral_moment": float(disk.mechanics.diametral_moment),
            "gravity": table.gravity,
            "start": {
                "tilt": tilt,
                "heading": heading,
                "tilt_rate": rates[0],
                "precession": precession,
                "spin": rates[2],
                "face_rate": rates[2] + 2.0 * precession * math.sin(0.5 * tilt) ** 2,
                "angular_velocity": math.hypot(*rates),
                "normal_force": float(disk.normal_force(state)),
                "energy": first,
            },
            "steady": None if self.steady is None else {
                "precession": float(disk.precession(self.steady.state)),
                "spin": float(self.steady.state[7]),
                "nutation": self.steady.nutation,
                "stability": stability_values(self.steady.verdict),
            },
            "critical_rolling_speed": None if self.thresholds is None else self.thresholds[0],
            "critical_spin_rate": None if self.thresholds is None else self.thresholds[1],
            "laws": [law._asdict() for law in self.laws],
            "spin_down": self._spin_down_values(),
            "turns": self.turns,
            "end_time": float(self.trajectory.times[-1]),
            "end_energy": last,
            "normal_force_minimum": self.lowest_force,
            "normal_force_minimum_of_weight": self.lowest_force / (table.mass * table.gravity),
            "status": str(self.trajectory.outcome),
            "units": UNITS,
        }  # fmt: skip

    def _spin_down_values(self) -> dict[str, Any] | None:
        found, dominant = self.spin_down, self.dominant
        if found is None:
            return None
        n = None if dominant is None else dominant.exponent
        return {
            "end": found.end,
            "end_uncertainty": found.end_uncertainty,
            "end_by_energy": self.end_by_energy,
            "first_event": found.first_event,
            "events": found.events,
            "dominant_law": None if dominant is None else dominant.law,
            "tilt_exponent": _exponent(found.tilt, n),
            "precession_exponent": _exponent(found.precession, None if n is None else -0.5 * n),
            "precession_by_tilt_exponent": _exponent(found.precession_by_tilt, -0.5),
            "energy_balance": found.energy_balance,
        }

    def sections(self) -> list[Section | Listing]:
        steady = self.steady
        rest = [] if steady is None else [
            verdicts("Steady rolling at this tilt and precession without dissipation, in tilt and rates", "motion", {
                f"tilt {math.degrees(float(steady.state[0])):.6g}°": steady.verdict,
            })
        ]  # fmt: skip
        end = [] if self.spin_down is None else [self._exponents(), self._end(self.spin_down)]
        return [*self._start(), *rest, *([self._laws()] if self.laws else []), *end, self._motion()]

    def _start(self) -> list[Section]:
        values = self.values()
        start, steady = values["start"], values["steady"] or {}
        ratio = steady.get("nutation") and steady["nutation"] / abs(start["precession"] or math.inf)
        of_precession = f" = {ratio:.6g} of the precession" if ratio else ""
        disk = Section("Disk", [
            ("mass", number(values["mass"], "kg")),
            ("radius", number(values["radius"], "m")),
            ("thickness", number(values["thickness"], "m") if values["thickness"] else "none (thin)"),
            ("moments, axial and diametral", f"{values['axial_moment']:.8g}, {values['diametral_moment']:.8g} kg m²"),
        ])  # fmt: skip
        return [disk, Section("Start", [
            ("tilt from the plane", angle(start["tilt"])),
            ("precession Ω of the contact", rate(start["precession"])),
            ("turning of what is printed on it", rate(start["face_rate"])),
            ("spin about the axis", rate(start["spin"])),
            ("rate of the tilt", rate(start["tilt_rate"])),
            ("small nutation", None if not ratio else (rate(steady["nutation"]) or "") + of_precession),
            ("rolls stably upright from", number(values["critical_rolling_speed"], "m/s")),
            ("spins stably upright from", rate(values["critical_spin_rate"])),
            ("energy", number(start["energy"], "J")),
            ("normal force", number(start["normal_force"], "N")),
        ])]  # fmt: skip

    def _laws(self) -> Listing:
        rows = []
        for law in self.laws:
            late = "–" if law.share_late is None else f"{law.share_late:.4g}"
            rows.append((law.law, f"{law.power:.4g} W", f"{law.share:.4g}", late, _predicted(law.exponent)))
        return Listing("Dissipation", ("law", "power at first", "share", "share late", "its exponent n"), rows)

    def _exponents(self) -> Listing:
        values = self._spin_down_values() or {}
        law = values["dominant_law"]
        rows = []
        for what, key in (("tilt ∝ (t0 − t)^n", "tilt_exponent"), ("Ω ∝ (t0 − t)^k", "precession_exponent"),
                          ("Ω ∝ tilt^k", "precession_by_tilt_exponent")):  # fmt: skip
            fit = values[key]
            of = "any law; not −1" if key == "precession_by_tilt_exponent" else str(law)
            wanted = "–" if fit["predicted"] is None else f"{_predicted(fit['predicted'])} ({of})"
            rows.append((what, f"{fit['fitted']:.5f} ± {fit['uncertainty']:.1g}", wanted))
        title = f"Exponents, fitted where |tilt rate|/(tilt·Ω) < {ASYMPTOTIC_FIT:g}"
        return Listing(title, ("law", "fitted", "predicted"), rows)

    def _end(self, found: SpinDown) -> Section:
        t0 = None if found.end is None else f"{found.end:.10g} ± {found.end_uncertainty:.1g} s"
        events = [(name, f"{time:.10g} s" + ("" if found.end is None else f", t0 {time - found.end:+.3g} s"))
                  for name, time in found.events.items()]  # fmt: skip
        by_energy = None if self.end_by_energy is None else f"{self.end_by_energy:.6g} s"
        return Section("End", [("asymptotic t0", t0), ("t0 by energy alone", by_energy), *events])

    def _motion(self) -> Section:
        first, last = self.energies
        lowest = self.lowest_force
        force = f"{lowest:.6g} N = {lowest / (self.table.mass * self.table.gravity):.4g} of the weight"
        kept = "energy balance" if self.laws else "drift"
        return Section("Motion", [
            ("turns of the contact", number(self.turns)),
            ("energy at the end", f"{last:.8g} J" + (f" = {last / first:.4g} of the start's" if self.laws else "")),
            ("lowest normal force", force),
            *accuracy_lines(self.trajectory, kept),
        ])  # fmt: skip


def _exponent(fit: PowerLaw, predicted: float | None) -> dict[str, float | None]:
    return {"fitted": fit.exponent, "uncertainty": fit.uncertainty, "predicted": predicted}


def _predicted(exponent: float) -> str:
    names = {1 / 3: "1/3", 4 / 9: "4/9", 1 / 2: "1/2", 2 / 3: "2/3", 2 / 9: "2/9", 1 / 6: "1/6", 1 / 4: "1/4"}
    word = names.get(abs(exponent), f"{abs(exponent):.4g}")
    return f"−{word}" if exponent < 0 else word


def law_names(table: EulerDiskTable) -> list[str]:
    """Return the laws of a spec by name, numbered where one stands there twice."""
    names = [law.law for law in table.dissipation]
    assert all(name in LAWS for name in names)
    return [name if names.count(name) == 1 else f"{name} {k + 1}" for k, name in enumerate(names)]
