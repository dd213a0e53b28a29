"""The answers about a conducting fluid on a sphere."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from typing import Any, ClassVar, NamedTuple

import jax.numpy as jnp
import numpy as np

from polhode.errors import InvalidInput
from polhode.fields.sphere.mhd import SphereMHD
from polhode.fields.sphere.zonal_growth import zonal_growth
from polhode.fields.sphere_mhd.start import build_start, load_earlier_run, wave_speed
from polhode.fields.sphere_mhd.table import MagneticFluidTable
from polhode.integrators import IsospectralMidpoint
from polhode.integrators._choice import turning_rates
from polhode.kinds.base import Spec
from polhode.motion._trajectory import Trajectory
from polhode.reports.about import accuracy, from_motion, motion_error
from polhode.reports.answer import Answer, Group, Table
from polhode.reports.base import WITHOUT_MOTION, MotionReport
from polhode.reports.length import RUNS_BY_EQUAL_STEPS, Watch, check_length
from polhode.reports.wording import duration, in_its_unit, rate
from polhode.simulation import simulate
from polhode.types import Array, Float64


class MagneticReportLimits(NamedTuple):
    """What bounds a run, and what decides its answers.

    Attributes:
        max_state_bytes: bytes of states that a report keeps: of large matrices fewer samples.
        max_rate: rad/s, of vorticity or field at the start, and the inverse of the least: squares stay within the range
            of doubles.
        min_zonal_share: of the energy at the start, above which the flow is judged a zonal one with waves on it.
        max_linear_share: of the energy, up to which waves follow linear theory.
        min_wave_share: of the energy, below which waves are rounding.
        max_step_angle: rad that the field may turn in a step.
    """

    max_state_bytes: int = 2**27
    max_rate: float = 1e100
    min_zonal_share: float = 0.98
    max_linear_share: float = 1e-4
    min_wave_share: float = 1e-24
    max_step_angle: float = 0.9


LIMITS = MagneticReportLimits()
QUICKER = "A lower `resolution` is quicker."


@dataclass(frozen=True)
class MagneticReport(MotionReport):
    """A conducting fluid on a sphere and its field: conserved quantities, and the energy they exchange.

    Attributes:
        system: on the unit sphere.
        table: as the spec has it.
        start: state at the start.
        trajectory: samples of the motion.
        asked: number of samples that the spec asks for; fewer are kept of large matrices.
        how: the method in words, where it is not the default of ``simulate``.
    """

    kind: ClassVar[str] = "sphere-mhd"
    system: SphereMHD
    table: MagneticFluidTable
    start: Array
    trajectory: Trajectory
    asked: int
    how: str = ""

    @property
    def _ends(self) -> Array:
        return np.asarray(self.trajectory.states)[[0, -1]]

    @cached_property
    def energies(self) -> Float64[Array, "time 2 n"]:
        """(T, 2, N) kinetic and magnetic energies by degree [rad²/s²]."""
        return np.asarray(self.system.energy_spectrum(self.trajectory.states))

    @cached_property
    def energies_by_order(self) -> Float64[Array, "time n"]:
        """(T, N) kinetic and magnetic energy together, by order m."""
        f = np.abs(np.asarray(self.system.to_harmonics(self.trajectory.states))) ** 2
        degree = np.arange(1, self.system.size)
        weights = np.stack([degree * (degree + 1.0), 1.0 / (degree * (degree + 1.0))])
        energies = 0.5 * np.einsum("tplm,pl->tm", f[:, :, 1:], weights)
        return energies * np.where(np.arange(self.system.size) > 0, 2.0, 1.0)

    @cached_property
    def spectrum_change(self) -> float:
        """By how much an eigenvalue of −iΘ changed at most, relative to the largest; 0 without a field."""
        eigenvalues = np.asarray(self.system.sphere.spectrum(self._ends[:, 0]))
        return float(np.abs(eigenvalues[1] - eigenvalues[0]).max() / (np.abs(eigenvalues[0]).max() or 1.0))

    @cached_property
    def mixed_change(self) -> float:
        """The largest change of tr WΘ^k, k = 1, 2, 3, relative to the norms of its factors."""
        theta, w = self._ends[:, 0], self._ends[:, 1]
        power, worst = theta, 0.0
        for _ in range(3):
            sizes = np.linalg.norm(w[0]) * np.linalg.norm(power[0])
            traces = np.einsum("tij,tji->t", w, power)
            worst = max(worst, float(abs(traces[1] - traces[0]) / (sizes or 1.0)))
            power = power @ theta
        return worst

    @cached_property
    def is_zonal(self) -> bool:
        """Whether the start is a zonal flow and field with small waves on it."""
        first = self.energies_by_order[0]
        return bool(0.0 < first[1:].sum() < (1.0 - LIMITS.min_zonal_share) * first.sum())

    def growth(self, order: int) -> float | None:
        """Return the growth rate [rad/s] of an order in the run while it is small; None where it cannot be measured.

        It is fitted to the later half of that time, in which the fastest wave has outgrown the others.
        """
        times, energy = self.trajectory.times, self.energies_by_order[:, order]
        whole = float(self.energies_by_order[0].sum())
        small = energy < LIMITS.max_linear_share * whole
        count = len(times) if small.all() else int(np.argmin(small))
        later = slice(count // 2, count)
        if energy[0] < LIMITS.min_wave_share * whole or count - count // 2 < 3:
            return None
        return float(np.polynomial.polynomial.polyfit(times[later], 0.5 * np.log(energy[later]), 1)[1])

    @property
    def summary(self) -> str:
        (kinetic, magnetic), (now, field) = self.energies[[0, -1]].sum(axis=-1)
        whole = kinetic + magnetic
        if self.table.alfven_wave is not None:
            speed = wave_speed(self.system, self.table.alfven_wave)
            return f"The wave keeps its form and goes round at {speed:.9g} rad/s, at any height."
        if not magnetic:
            return "There is no magnetic field, and none arises; the fluid moves as one that does not conduct."
        moved = "gained energy from the flow" if field > magnetic + 0.01 * whole else (
            "lost energy to the flow" if field < magnetic - 0.01 * whole else "kept its energy")
        share = self.rounded(f"{field / (now + field):.3g}")
        return (
            f"The field {moved}: its share went from {magnetic / whole:.3g} to {share}. What the "
            f"fluid carries along stayed: the spectrum of the potential to {self.spectrum_change:.1e}, the mixed "
            f"Casimirs to {self.mixed_change:.1e}."
        )

    @property
    def notes(self) -> list[str]:
        notes = []
        count = len(self.trajectory.times)
        if count < self.asked:
            notes.append(
                f"{count} of {self.asked} samples are kept: more would take over {LIMITS.max_state_bytes >> 20} MiB."
            )
        last = self.energies[-1]
        if last[:, -self.system.size // 8 :].sum() > 1e-3 * last.sum():
            notes.append("the finest degrees have taken up energy: sheets of current have met the resolution.")
        return notes

    @property
    def answers(self) -> list[Group | Table]:
        groups: list[Group | Table] = [self.about_start(), self._spectrum()]
        if self.table.alfven_wave is not None:
            groups.append(self._wave())
        if self.is_zonal:
            groups.append(self._growth())
        return [*groups, self._motion()]

    def about_start(self) -> Group:
        """Return the answers about fluid and field at the start."""
        system, size = self.system, self.system.size
        start = np.asarray(self.start)
        theta, relative = start[0], start[1] - np.asarray(system.fluid.planetary)
        rotation = float(system.fluid.rotation)
        kinetic, magnetic = (float(x) for x in np.asarray(system.energy_spectrum(self.start)).sum(axis=-1))
        vorticity, current = (_mean_square(system, x) for x in (relative, system.current(start)))
        field = math.sqrt(2.0 * magnetic / (4.0 * math.pi))
        helicity = float(system.sphere.pairing(theta, relative))
        turnover = 2.0 * math.pi / vorticity if vorticity else None
        return Group("Fluid and field", [
            Answer("resolution", size, "", "resolution", "",
                   f"two {size} × {size} matrices, harmonics up to degree {size - 1}"),
            Answer("rotation", rotation, "rad/s", "rotation", "", rate(rotation)),
            Answer("vorticity", vorticity, "rad/s", "vorticity at the start", "root mean square, against the sphere",
                   f"{vorticity:.6g} rad/s, root mean square"),
            Answer("field", field, "rad/s", "field at the start", "Alfvén speed over the radius, root mean square",
                   f"{field:.6g} rad/s, root mean square Alfvén speed over the radius"),
            Answer("current", current, "rad/s", "current at the start", "root mean square",
                   f"{current:.6g} rad/s, root mean square"),
            Answer("turnover_time", turnover, "s", "turnover time", "2π over the vorticity",
                   None if turnover is None else duration(turnover)),
            Answer("kinetic_energy", kinetic, "rad²/s²", "kinetic energy", "at the start, of the unit sphere"),
            Answer("magnetic_energy", magnetic, "rad²/s²", "magnetic energy", "at the start"),
            Answer("cross_helicity", helicity, "rad²/s²", "cross-helicity", "∫ ω A, kept without rotation"),
        ])

    def _spectrum(self) -> Table:
        first, last = self.energies[[0, -1]]
        rows = [
            {"degree": k, "kinetic": [float(first[0, k]), float(last[0, k])],
             "magnetic": [float(first[1, k]), float(last[1, k])]}
            for k in range(1, self.system.size)
        ]
        columns = {"degree": lambda row: str(row["degree"])} | {
            f"{part}, {when}": lambda row, p=part, k=k: f"{row[p][k]:.4g}"
            for part in ("kinetic", "magnetic") for k, when in enumerate(("start", "end"))
        }  # fmt: skip
        units = {"kinetic": "rad²/s²", "magnetic": "rad²/s²"}
        errors = {head: motion_error(self.trajectory) for head in columns if head.endswith("end")}
        listed = 12  # degrees in the text
        return Table("spectrum", "Energies by degree", columns, rows, units, shown=lambda row: row["degree"] <= listed,
                     errors=errors)

    def _wave(self) -> Group:
        table: Any = self.table.alfven_wave
        speed, order = wave_speed(self.system, table), table.order
        fitted = None
        if order:
            values = np.asarray(self.system.to_harmonics(self.trajectory.states))[:, 1, table.degree, order]
            phases = -(np.unwrap(np.angle(values)) - np.angle(values[0])) / order
            fitted = float(np.polynomial.polynomial.polyfit(self.trajectory.times, phases, 1)[1])
        return Group("Wave", [
            Answer("wave_speed", speed, "rad/s", "speed", "eastward, exact", f"{speed:.10g} rad/s"),
            *from_motion(self.trajectory, [
                Answer("wave_speed_in_run", fitted, "rad/s", "speed in the run", "", None if fitted is None else
                       f"{fitted:.10g} rad/s"),
            ]),
        ])

    def _growth(self) -> Table:
        rows = []
        orders = 3
        for order in range(1, min(orders, self.system.size - 1) + 1):
            mode = zonal_growth(self.system, jnp.asarray(self._ends[0]), order)
            rows.append({"order": order, "linear": mode.rate, "frequency": mode.frequency, "run": self.growth(order)})
        columns = {
            "order": lambda row: str(row["order"]),
            "growth by linear theory": lambda row: f"{row['linear']:.6g} /s",
            "in the run, while small": lambda row: "-" if row["run"] is None else f"{row['run']:.4g} /s",
        }
        units = {"linear": "rad/s", "frequency": "rad/s", "run": "rad/s"}
        return Table("zonal_growth", "Waves on the zonal flow and field", columns, rows, units)

    def _motion(self) -> Group:
        statistics = self.trajectory.statistics
        count, iterations = statistics["steps"], statistics.get("iterations")
        steps = f"{count}" if iterations is None else f"{count}, {iterations / max(count, 1):.3g} iterations each"
        return Group("Motion", [
            *from_motion(self.trajectory, [
                Answer("energies_at_end", self.energies[-1].sum(axis=-1), "rad²/s²", "energies at the end",
                       "kinetic and magnetic"),
            ]),
            Answer("spectrum_change", self.spectrum_change, "", "change of the potential's spectrum",
                   "largest, of the largest eigenvalue", f"{self.spectrum_change:.1e}"),
            Answer("mixed_change", self.mixed_change, "", "change of the mixed Casimirs",
                   "tr WΘ^k, k = 1 to 3, of the norms of their factors", f"{self.mixed_change:.1e}"),
            Answer("steps", count, "", "steps", "", steps),
            Answer("method", self.how or None, "", "computed by"),
            *accuracy(self.trajectory),
        ])


def _mean_square(system: SphereMHD, matrix: Array) -> float:
    """Return the root mean square over the sphere of the function that a matrix represents."""
    return math.sqrt(float(system.sphere.pairing(matrix, matrix)) / (4.0 * math.pi))


def make_report(spec: Spec[MagneticFluidTable]) -> MagneticReport:
    """Return the report on a conducting fluid on a sphere.

    Raises:
        InvalidInput: for a fluid and field at rest or out of range, or a time that takes too many steps.
    """
    table = spec.system
    system, state, earlier = _start(spec, table)
    size = _size(system, state)
    turnovers = 15.0  # of eddies
    until = turnovers * 2.0 * math.pi / size if spec.until is None else spec.until
    samples = max(2, min(spec.samples, LIMITS.max_state_bytes // (32 * system.size**2)))
    times = np.linspace(0.0, until, samples)
    memory = None if earlier is None else earlier.memory
    kept = {"resumable": True, "memory": memory}
    if system.series_of_arrays:
        trajectory = simulate(system, state, times, progress=Watch(spec.until, times, QUICKER), **kept)
        return MagneticReport(system, table, state, trajectory, spec.samples)
    # eddies, waves along the field, and the fastest planetary wave, which goes round at Ω however slow the flow is
    rates = [float(system.sphere.rate(x)) for x in (system.stream_function(state), state[0])]
    fastest = max(*rates, abs(table.rotation))
    shear = float(turning_rates(system, state, times))  # of the current, which only limits the step
    angle = 0.25  # rad that the fastest rotation, or the fastest wave along the field, turns in a step
    step = min(angle / fastest if fastest else until, LIMITS.max_step_angle / shear if shear else until)
    if earlier is not None and memory is not None and earlier.statistics.get("steps"):
        # steps of the earlier run give the bits of one long run
        step = float(np.ptp(earlier.times)) / earlier.statistics["steps"]
    products = 3.0  # of matrices, for each one of a fluid without a field
    each = RUNS_BY_EQUAL_STEPS * products * system.fluid.cost().seconds
    shown = check_length(spec.until, times, until / step, each, QUICKER)
    trajectory = simulate(system, state, times, IsospectralMidpoint, step=step, order=2, progress=shown, **kept)
    how = f"isospectral midpoints, order 2, steps of {in_its_unit(step)}: at this resolution series take too long"
    return MagneticReport(system, table, state, trajectory, spec.samples, how)


def answers_without_motion(spec: Spec[MagneticFluidTable]) -> Iterator[Group | Table]:
    """Yield the answers of the report that need no trajectory.

    Raises:
        InvalidInput: for a fluid and field at rest or out of range.
    """
    table = spec.system
    system, state, _ = _start(spec, table)
    yield MagneticReport(system, table, state, WITHOUT_MOTION, spec.samples).about_start()


def _size(system: SphereMHD, state: Array) -> float:
    """Return the root mean square over the sphere of vorticity or potential, whichever is larger [rad/s]."""
    return max(_mean_square(system, state[1] - system.fluid.planetary), _mean_square(system, state[0]))


def _start(spec: Spec[MagneticFluidTable], table: MagneticFluidTable) -> tuple[SphereMHD, Array, Trajectory | None]:
    """Return the system, its first state, and the earlier run that it continues, if any."""
    system = SphereMHD(table.resolution, table.rotation)
    earlier = None if table.start_from is None else load_earlier_run(spec.folder / table.start_from, system)
    state = jnp.asarray(build_start(system, table) if earlier is None else earlier.states[-1])
    size = _size(system, state)
    if not 1.0 / LIMITS.max_rate <= size <= LIMITS.max_rate:
        raise InvalidInput(
            f"vorticity or field at the start must be within {1.0 / LIMITS.max_rate:g} to {LIMITS.max_rate:g} "
            f"rad/s, root mean square; they are {size:.3g} rad/s. Give larger or smaller ones, and check what "
            "they are the sum of, which may cancel."
        )
    return system, state, earlier
