"""The answers about a plasma wave."""

from __future__ import annotations

import math
import warnings
from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import cached_property
from typing import ClassVar, NamedTuple

import numpy as np

from polhode.fields.vlasov_poisson.growth import GrowthFit, fit_growth
from polhode.fields.vlasov_poisson.system import VlasovPoisson, quiet_start
from polhode.fields.vlasov_poisson.table import PlasmaTable
from polhode.fields.vlasov_poisson.waves import Beam, PlasmaWave, fastest_growing_wave, velocity_distribution
from polhode.integrators import Splitting
from polhode.kinds.base import Spec
from polhode.motion._trajectory import Trajectory
from polhode.reports.about import accuracy, from_motion
from polhode.reports.answer import Answer, Group, Table
from polhode.reports.base import WITHOUT_MOTION, MotionReport
from polhode.reports.length import RUNS_BY_EQUAL_STEPS, check_length
from polhode.reports.wording import number, uncertain
from polhode.simulation import simulate
from polhode.types import Array, Float64


class PlasmaReportLimits(NamedTuple):
    """What bounds the states of a run.

    Attributes:
        max_state_bytes: bytes of states that a report keeps: of many particles fewer samples.
    """

    max_state_bytes: int = 2**25


LIMITS = PlasmaReportLimits()
ORDER = 4
METHOD = (
    f"kicks and drifts, order {ORDER}, steps of {{step:g}}, as `step` says: of thousands of particles that all act on "
    "each other, series would take too long"
)


@dataclass(frozen=True)
class PlasmaReport(MotionReport):
    """A wave in a plasma: linear theory, the simulation, and how long the two can agree.

    Attributes:
        system: the plasma.
        table: as the spec has it.
        beams: of the electrons.
        fastest: speed up to which there are particles.
        trajectory: samples of the motion, in inverse plasma frequencies.
        wave: the mode that grows fastest or is damped least; None without one.
        asked: number of samples that the spec asks for.
    """

    kind: ClassVar[str] = "vlasov-poisson"
    system: VlasovPoisson
    table: PlasmaTable
    beams: tuple[Beam, ...]
    fastest: float
    trajectory: Trajectory
    wave: PlasmaWave | None
    asked: int

    @cached_property
    def field(self) -> Float64[Array, "time"]:
        """(T,) amplitude of the longest wave of the field."""
        return np.asarray(self.system.field_amplitudes(self.trajectory.states))[:, 0]

    @property
    def recurrence_time(self) -> float:
        """Recurrence time: equally spaced velocities are in phase again, and the field of a damped wave comes back."""
        return 2.0 * math.pi / (self.table.wavenumber * 2.0 * self.fastest / self.table.velocities)

    @cached_property
    def fit(self) -> GrowthFit | None:
        """Growth of the field in the run; None where too little of it is linear."""
        if self.wave is None:
            return None
        end = 0.6 * self.recurrence_time
        return fit_growth(np.asarray(self.trajectory.times), self.field, self.table.wavenumber, self.wave, end)

    @property
    def bounce_rate(self) -> float:
        """√(kE) of electrons that the largest field of the run traps."""
        return math.sqrt(self.table.wavenumber * float(self.field.max()))

    @property
    def summary(self) -> str:
        if self.wave is None:
            return "Linear theory finds no wave of this length in this plasma."
        what = "grows" if self.wave.growth > 0.0 else "is damped"
        said = f"The wave {what} at {abs(self.wave.growth):.6g} by linear theory"
        if self.fit is None:
            return f"{said}; too little of the run is linear to measure that."
        return f"{said}, and at {uncertain(abs(self.fit.growth), self.fit.error)} in the run."

    @property
    def notes(self) -> list[str]:
        notes = ["times are in inverse plasma frequencies, as if that were 1 rad/s; lengths in Debye lengths."]
        times = np.asarray(self.trajectory.times)
        if times[-1] > self.recurrence_time and (self.wave is None or self.wave.growth < 0.0):
            notes.append(
                f"from t = {self.recurrence_time:.4g} on the field of a damped wave comes back, as velocities are "
                "equally spaced: more velocities put that off."
            )
        if self.wave is not None and self.wave.growth < 0.0 and self.bounce_rate > abs(self.wave.growth):
            notes.append("the field traps electrons before it is damped: linear theory holds at first only.")
        if len(times) < self.asked:
            notes.append(
                f"{len(times)} of {self.asked} samples are kept: more would take over "
                f"{LIMITS.max_state_bytes >> 20} MiB."
            )
        return notes

    def distribution(self, states: Float64[Array, "n 3"]) -> Float64[Array, "n"]:
        """Return f at the particles (n,), which each particle conserves."""
        v, x = np.asarray(states)[:, 0], np.asarray(states)[:, 1]
        return velocity_distribution(self.beams, v) * (1.0 + self.table.amplitude * np.cos(self.table.wavenumber * x))

    def without_motion(self) -> list[Group | Table]:
        """Return the answers that need no trajectory."""
        return [self._about_plasma(), self._beams(), self._about_wave()]

    @property
    def answers(self) -> list[Group | Table]:
        return [*self.without_motion(), self._motion()]

    def _about_plasma(self) -> Group:
        count = self.table.velocities * self.table.particles_per_velocity
        words = f"{count}, {self.table.particles_per_velocity} at each of {self.table.velocities} velocities"
        return Group("Plasma", [
            Answer("wavenumber", self.table.wavenumber, "1/λ_D", "wavenumber"),
            Answer("length", float(self.system.length), "λ_D", "box"),
            Answer("amplitude", self.table.amplitude, "", "disturbance"),
            Answer("particles", count, "", "particles", "", words),
            Answer("modes", self.table.modes, "", "waves of the field"),
            Answer("recurrence_time", self.recurrence_time, "1/ω_p", "velocities in step again at"),
        ])

    def _beams(self) -> Table:
        columns = {
            "share": lambda row: f"{row['share']:g}",
            "drift": lambda row: f"{row['drift']:g}",
            "spread": lambda row: f"{row['spread']:g}",
        }
        units = {"drift": "v_th", "spread": "v_th"}
        return Table("beams", "Electrons", columns, [beam._asdict() for beam in self.beams], units)

    def _about_wave(self) -> Group:
        wave = self.wave
        if wave is None:
            return Group("Linear theory", [Answer("wave", None, "", "wave", "", "none found")])
        return Group("Linear theory", [
            Answer("wave.frequency", wave.frequency, "ω_p", "frequency", "", number(wave.frequency, "ω_p")),
            Answer("wave.growth", wave.growth, "ω_p", "growth", "", number(wave.growth, "ω_p")),
            Answer("wave.response", wave.response, "", "response", "field at first, for a disturbance of one"),
            Answer("wave.phase", wave.phase, "rad"),
        ])

    def _motion(self) -> Group:
        fit = self.fit
        grown = [] if fit is None else [
            Answer("measured.growth", fit.growth, "ω_p", "growth in the run", "",
                   f"{uncertain(fit.growth, fit.error, 'ω_p')}, from t = {fit.begin:.4g} to {fit.end:.4g}"),
            Answer("measured.growth_error", fit.error, "ω_p"),
            Answer("measured.window", [fit.begin, fit.end], "1/ω_p"),
        ]
        return Group("Motion", [
            *grown,
            Answer("field.start", float(self.field[0]), "", "field at the start"),
            *from_motion(self.trajectory, [
                Answer("field.largest", float(self.field.max()), "", "largest"),
                Answer("field.end", float(self.field[-1]), "", "at the end"),
                Answer("bounce_rate", self.bounce_rate, "ω_p", "trapped electrons bounce at",
                       "√(kE) of the largest field", number(self.bounce_rate, "ω_p")),
            ]),
            Answer("method", METHOD.format(step=self.table.step), "", "computed by"),
            *accuracy(self.trajectory),
        ])


def make_report(spec: Spec[PlasmaTable]) -> PlasmaReport:
    """Return the report on a plasma.

    Raises:
        InvalidInput: for a distribution that is zero at some particles, or a time that takes too many steps.
    """
    about = _without_motion(spec)
    system, table, beams, fastest = about.system, about.table, about.beams, about.fastest
    count = table.velocities * table.particles_per_velocity
    state = quiet_start(
        system, lambda v: velocity_distribution(beams, v), table.velocities, table.amplitude, fastest=fastest
    )
    usual = 40.0  # inverse plasma frequencies
    until = usual if spec.until is None else spec.until
    kept = max(2, min(spec.samples, LIMITS.max_state_bytes // (24 * count)))
    times = np.linspace(0.0, until, kept)
    steps = max(until / table.step, kept)
    of_step, of_particle = 1e-5, 6e-8  # s per step, and per particle and mode in it, measured at order 4
    each = RUNS_BY_EQUAL_STEPS * (of_step + of_particle * count * table.modes)
    shown = check_length(spec.until, times, steps, each, "Fewer particles or modes are quicker.")
    with warnings.catch_warnings():
        # drifts are exact however far they go, and the field turns no faster than the plasma's frequency
        warnings.filterwarnings("ignore", message="a step of")
        trajectory = simulate(system, state, times, Splitting, step=table.step, order=ORDER, progress=shown)
    return replace(about, trajectory=trajectory)


def answers_without_motion(spec: Spec[PlasmaTable]) -> Iterator[Group | Table]:
    """Yield the answers of the report that need no trajectory."""
    yield from _without_motion(spec).without_motion()


def _without_motion(spec: Spec[PlasmaTable]) -> PlasmaReport:
    table = spec.system
    beams = tuple(Beam(b.share, b.drift, b.spread) for b in table.beams) if table.beams else (Beam(),)
    reach = 6.0  # thermal speeds up to which a beam has electrons
    fastest = table.fastest or max(abs(beam.drift) + reach * beam.spread for beam in beams)
    count = table.velocities * table.particles_per_velocity
    system = VlasovPoisson(2.0 * math.pi / table.wavenumber, table.modes, count)
    wave = fastest_growing_wave(beams, table.wavenumber)
    return PlasmaReport(system, table, beams, fastest, WITHOUT_MOTION, wave, spec.samples)
