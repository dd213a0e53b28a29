"""The answers about an ideal fluid on a sphere."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from typing import ClassVar, NamedTuple

import numpy as np

from polhode.errors import InvalidInput
from polhode.fields.sphere.fluid import SphereFluid
from polhode.fields.sphere_fluid.start import build_start, load_earlier_run
from polhode.fields.sphere_fluid.table import FluidTable
from polhode.integrators import IsospectralMidpoint
from polhode.integrators._choice import turning_rates
from polhode.kinds.base import Spec
from polhode.motion._trajectory import Trajectory
from polhode.reports.about import accuracy, motion_error
from polhode.reports.answer import Answer, Group, Table
from polhode.reports.base import WITHOUT_MOTION, MotionReport
from polhode.reports.length import RUNS_BY_EQUAL_STEPS, Watch, check_length
from polhode.reports.wording import duration, in_its_unit, number, rate, vector
from polhode.simulation import simulate
from polhode.types import Array, Float64


class FluidReportLimits(NamedTuple):
    """What bounds a run and its start.

    Attributes:
        max_state_bytes: bytes of states that a report keeps: of large matrices fewer samples.
        max_rate: rad/s, of vorticity at the start, and the inverse of the least: squares stay within the range of
            doubles.
    """

    max_state_bytes: int = 2**27
    max_rate: float = 1e100


LIMITS = FluidReportLimits()
QUICKER = "A lower `resolution` is quicker."


@dataclass(frozen=True)
class FluidReport(MotionReport):
    """A fluid on a sphere: conserved quantities, and the spectrum of its energy.

    Attributes:
        system: on the unit sphere, with the vorticities and times of the fluid.
        table: as the spec has it.
        start: state at the start.
        trajectory: samples of the motion.
        asked: number of samples that the spec asks for; fewer are kept of large matrices.
        how: the method in words, where it is not the default of ``simulate``.
    """

    kind: ClassVar[str] = "sphere-fluid"
    system: SphereFluid
    table: FluidTable
    start: Array
    trajectory: Trajectory
    asked: int
    how: str = ""

    @cached_property
    def energies(self) -> Float64[Array, "2 n"]:
        """(2, N) energies by degree at start and end, of the unit sphere [rad²/s²]."""
        return np.asarray(self.system.energy_spectrum(self._ends))

    @property
    def _ends(self) -> Array:
        return np.asarray(self.trajectory.states)[[0, -1]]

    @cached_property
    def spectrum_change(self) -> float:
        """By how much an eigenvalue of −iW changed at most, relative to the largest."""
        eigenvalues = np.asarray(self.system.algebra.spectrum(self._ends))
        return float(np.abs(eigenvalues[1] - eigenvalues[0]).max() / np.abs(eigenvalues[0]).max())

    @cached_property
    def relative_vorticity(self) -> float:
        """Root mean square over the sphere at the start [rad/s]."""
        return _vorticity(self.system, self.start)

    @property
    def mean_degrees(self) -> Float64[Array, "2"]:
        """(2,) mean degree of the energy, at start and end."""
        return (self.energies @ np.arange(self.system.size)) / self.energies.sum(axis=1)

    @property
    def mean_degrees_of_enstrophy(self) -> Float64[Array, "2"]:
        """(2,) mean degree of the squared vorticity."""
        degree = np.arange(self.system.size)
        enstrophy = self.energies * degree * (degree + 1.0)
        return (enstrophy @ degree) / enstrophy.sum(axis=1)

    @property
    def summary(self) -> str:
        (first, last), (begin, end) = self.mean_degrees, self.mean_degrees_of_enstrophy
        energy = "towards larger eddies" if last < 0.98 * first else (
            "towards smaller eddies" if last > 1.02 * first else "hardly at all")
        last, end = (self.rounded(f"{degree:.4g}") for degree in (last, end))
        return (
            f"The energy moved {energy}, from degree {first:.4g} to {last} on average, the squared vorticity from "
            f"{begin:.4g} to {end}; the spectrum of the vorticity changed by {self.spectrum_change:.1e}."
        )

    @property
    def notes(self) -> list[str]:
        notes = []
        count = len(self.trajectory.times)
        if count < self.asked:
            notes.append(
                f"{count} of {self.asked} samples are kept: more would take over {LIMITS.max_state_bytes >> 20} MiB."
            )
        if self.energies[-1][-self.system.size // 8 :].sum() > 1e-3 * self.energies[-1].sum():
            notes.append("the finest degrees have taken up energy: more resolution would show more detail.")
        return notes

    @property
    def answers(self) -> list[Group | Table]:
        return [self.about_fluid(), self._spectrum(), self._motion()]

    def about_fluid(self) -> Group:
        """Return the answers about the fluid at the start."""
        system, size = self.system, self.system.size
        energy = float(np.asarray(system.energy_spectrum(self.start)).sum())
        speed = self.table.radius * math.sqrt(2.0 * energy / (4.0 * math.pi))
        planetary = 2.0 * abs(float(system.rotation))
        rossby = self.relative_vorticity / planetary if planetary else None
        axes = np.asarray(system.algebra.coordinates)
        relative = np.asarray(self.start) - np.asarray(system.planetary)
        momentum = np.array([float(system.algebra.pairing(relative, axis)) for axis in axes])
        words = f"{size} × {size} matrices, harmonics up to degree {size - 1}"
        turnover = 2.0 * math.pi / self.relative_vorticity
        return Group("Fluid", [
            Answer("resolution", size, "", "resolution", "", words),
            Answer("radius", self.table.radius, "m", "radius"),
            Answer("rotation", float(system.rotation), "rad/s", "rotation", "", rate(float(system.rotation))),
            Answer("vorticity", self.relative_vorticity, "rad/s", "vorticity at the start",
                   "root mean square, relative to the sphere",
                   f"{self.relative_vorticity:.6g} rad/s, root mean square"),
            Answer("speed", speed, "m/s", "speed at the start", "root mean square", number(speed, "m/s")),
            Answer("turnover_time", turnover, "s", "turnover time", "2π over the vorticity", duration(turnover)),
            Answer("rossby_number", rossby, "", "Rossby number", "vorticity over 2Ω"),
            Answer("energy", energy, "rad²/s²", "", "of the unit sphere, ½∫v²"),
            Answer("angular_momentum", momentum, "rad/s", "angular momentum", "∫ x ω of the unit sphere",
                   vector(momentum, "rad/s")),
        ])

    def _spectrum(self) -> Table:
        flux = -np.cumsum(np.asarray(self.system.energy_transfer(self._ends[1])))
        rows = [
            {"degree": k, "start": float(self.energies[0, k]), "end": float(self.energies[1, k]),
             "flux": float(flux[k])}
            for k in range(1, self.system.size)
        ]
        columns = {
            "degree": lambda row: str(row["degree"]),
            "energy at the start": lambda row: f"{row['start']:.4g}",
            "at the end": lambda row: f"{row['end']:.4g}",
            "flux beyond it, at the end": lambda row: f"{row['flux']:.3g} /s",
        }
        units = {"start": "rad²/s²", "end": "rad²/s²", "flux": "rad²/s³"}
        listed = 12  # degrees in the text
        return Table("spectrum", "Energy by degree", columns, rows, units, shown=lambda row: row["degree"] <= listed,
                     errors={head: motion_error(self.trajectory) for head in list(columns)[2:]})

    def _motion(self) -> Group:
        statistics = self.trajectory.statistics
        count, iterations = statistics["steps"], statistics.get("iterations")
        steps = f"{count}" if iterations is None else f"{count}, {iterations / max(count, 1):.3g} iterations each"
        return Group("Motion", [
            Answer("mean_degree", self.mean_degrees, "", "", "of the energy, at start and end"),
            Answer("mean_degree_of_enstrophy", self.mean_degrees_of_enstrophy, "", "", "at start and end"),
            Answer("spectrum_change", self.spectrum_change, "", "change of the spectrum",
                   "largest, of the largest eigenvalue", f"{self.spectrum_change:.1e}"),
            Answer("steps", count, "", "steps", "", steps),
            Answer("method", self.how or None, "", "computed by"),
            *accuracy(self.trajectory),
        ])


def make_report(spec: Spec[FluidTable]) -> FluidReport:
    """Return the report on a fluid on a sphere.

    Raises:
        InvalidInput: for a fluid at rest or a vorticity out of range, or a time that takes too many steps.
    """
    table = spec.system
    fluid, state, earlier = _start(spec, table)
    vorticity = _vorticity(fluid, state)
    turnovers = 15.0  # of eddies
    until = turnovers * 2.0 * math.pi / vorticity if spec.until is None else spec.until
    samples = max(2, min(spec.samples, LIMITS.max_state_bytes // (16 * fluid.size**2)))
    times = np.linspace(0.0, until, samples)
    memory = None if earlier is None else earlier.memory
    kept = {"resumable": True, "memory": memory}
    if fluid.series_of_arrays:
        trajectory = simulate(fluid, state, times, progress=Watch(spec.until, times, QUICKER), **kept)
        return FluidReport(fluid, table, state, trajectory, spec.samples)
    # the fastest planetary wave goes round at Ω, however slow the flow is
    fastest = max(float(turning_rates(fluid, state, times)), abs(table.rotation))
    # rad that the fastest rotation turns in a step: shorter steps cost more iterations in all than they save
    angle = 0.25
    step = angle / fastest if fastest else until
    if earlier is not None and memory is not None and earlier.statistics.get("steps"):
        # steps of the earlier run give the bits of one long run
        step = float(np.ptp(earlier.times)) / earlier.statistics["steps"]
    each = RUNS_BY_EQUAL_STEPS * fluid.cost().seconds
    shown = check_length(spec.until, times, until / step, each, QUICKER)
    trajectory = simulate(fluid, state, times, IsospectralMidpoint, step=step, order=2, progress=shown, **kept)
    how = f"isospectral midpoints, order 2, steps of {in_its_unit(step)}: at this resolution series take too long"
    return FluidReport(fluid, table, state, trajectory, spec.samples, how)


def answers_without_motion(spec: Spec[FluidTable]) -> Iterator[Group | Table]:
    """Yield the answers of the report that need no trajectory.

    Raises:
        InvalidInput: for a fluid at rest or a vorticity out of range.
    """
    table = spec.system
    fluid, state, _ = _start(spec, table)
    yield FluidReport(fluid, table, state, WITHOUT_MOTION, spec.samples).about_fluid()


def _vorticity(fluid: SphereFluid, state: Array) -> float:
    """Return the root mean square over the sphere of the vorticity relative to it [rad/s]."""
    relative = np.asarray(state) - np.asarray(fluid.planetary)
    return math.sqrt(float(fluid.algebra.pairing(relative, relative)) / (4.0 * math.pi))


def _start(spec: Spec[FluidTable], table: FluidTable) -> tuple[SphereFluid, Array, Trajectory | None]:
    """Return the fluid, its first state, and the earlier run that it continues, if any."""
    fluid = SphereFluid(table.resolution, table.rotation)
    earlier = None if table.start_from is None else load_earlier_run(spec.folder / table.start_from, fluid)
    state = build_start(fluid, table) if earlier is None else earlier.states[-1]
    vorticity = _vorticity(fluid, state)
    if not 1.0 / LIMITS.max_rate <= vorticity <= LIMITS.max_rate:
        raise InvalidInput(
            f"the vorticity at the start must be within {1.0 / LIMITS.max_rate:g} to {LIMITS.max_rate:g} rad/s, root "
            f"mean square; it is {vorticity:.3g} rad/s. Check `random`, `vortices` and `waves`, which may "
            "cancel each other."
        )
    return fluid, state, earlier
