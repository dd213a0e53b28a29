"""The answers about spins on a lattice."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any, ClassVar, NamedTuple

import numpy as np
from scipy.constants import e, hbar
from scipy.constants import k as boltzmann

from polhode.errors import InvalidInput
from polhode.fields import Bath, NoiseDriftNoise
from polhode.fields.spin_lattice.build import build_lattice, build_start, wave_path
from polhode.fields.spin_lattice.system import SpinLattice
from polhode.fields.spin_lattice.table import SpinLatticeTable
from polhode.fields.spin_lattice.texture import skyrmion_number
from polhode.fields.spin_lattice.wave_theory import spin_waves
from polhode.integrators import SphericalMidpoint, Splitting
from polhode.integrators._choice import turning_rates
from polhode.integrators._series import has_short_series
from polhode.kinds.base import Spec
from polhode.motion._layout import ENERGY
from polhode.motion._trajectory import Trajectory
from polhode.reports.about import accuracy, from_motion
from polhode.reports.answer import Answer, Group, Table
from polhode.reports.base import WITHOUT_MOTION, MotionReport
from polhode.reports.length import RUNS_BY_EQUAL_STEPS, Watch, check_length
from polhode.reports.wording import in_its_unit, number, uncertain, vector, write_count
from polhode.simulation import simulate
from polhode.types import Array, Float64

MILLI = 1e-3 * e  # J in a meV


class SpinLatticeReportLimits(NamedTuple):
    """What bounds the states of a run.

    Attributes:
        max_state_bytes: bytes of states that a report keeps: of large lattices fewer samples.
    """

    max_state_bytes: int = 2**25


LIMITS = SpinLatticeReportLimits()
QUICKER = "Fewer `cells` are quicker."


@dataclass(frozen=True)
class SpinLatticeReport(MotionReport):
    """Spins on a lattice: their energy, order and waves.

    Attributes:
        system: the spins, energies over ħ [rad/s].
        table: as the spec has it.
        trajectory: samples of the motion.
        asked: number of samples that the spec asks for.
        how: the method in words, where it is not the default of ``simulate``.
    """

    kind: ClassVar[str] = "spin-lattice"
    system: SpinLattice
    table: SpinLatticeTable
    trajectory: Trajectory
    asked: int
    how: str = ""

    @property
    def count(self) -> int:
        """How many spins there are."""
        return self.system.algebra.copies

    @cached_property
    def energies(self) -> Float64[Array, "time"]:
        """(T,) energy per spin [J]."""
        return hbar * np.asarray(self.system.energy(self.trajectory.states)) / self.count

    @cached_property
    def magnetizations(self) -> Float64[Array, "time 3"]:
        """(T, 3) mean spin over its length."""
        states = np.asarray(self.trajectory.states)
        return states.mean(axis=(1, 2, 3, 4)) / float(np.mean(self.system.spin))

    @cached_property
    def gap(self) -> tuple[float, float] | None:
        """Least and largest energy of spin waves along the first direction [J]; None where the start is no minimum."""
        waves = self.waves
        return None if waves is None else (hbar * float(waves.min()), hbar * float(waves.max()))

    @cached_property
    def waves(self) -> Float64[Array, "points modes"] | None:
        """(points, modes) linear spin waves about the directions of the start [rad/s], along ``wave_path``."""
        if self.table.random:
            return None
        directions = np.asarray(self.table.directions or [(0.0, 0.0, 1.0)])
        sites = self.system.lattice.sites
        ground = np.asarray(self.system.aligned(np.broadcast_to(directions, (sites, 3))))[0, 0, 0]
        try:
            return np.asarray(spin_waves(self.system, ground, wave_path(self.system)[0]))
        except InvalidInput:  # the state does not rest, is no minimum, or has dipoles
            return None

    @property
    def skyrmions(self) -> Float64[np.ndarray, "2"] | None:
        """(2,) how often the spins of a plane cover the sphere, at start and end; None for other lattices."""
        lattice = self.system.lattice
        if lattice.dimension != 2 or lattice.sites != 1 or min(lattice.shape[:2]) < 2:
            return None
        states = np.asarray(self.trajectory.states)[[0, -1], :, :, 0, 0]
        return skyrmion_number(states, self.table.periodic)

    @property
    def thermal(self) -> tuple[float, float] | None:
        """Mean energy per spin in the later part [J] and its standard error; None without a bath."""
        if self.table.temperature is None:
            return None
        late_from = 0.5  # of the run, after which the average is taken
        late = self.energies[int(late_from * len(self.energies)) :]
        most_blocks = 10  # whose scatter is the error of the average
        blocks = np.array([block.mean() for block in np.array_split(late, min(most_blocks, len(late)))])
        return float(late.mean()), float(blocks.std(ddof=1) / math.sqrt(len(blocks))) if len(blocks) > 1 else math.nan

    @property
    def summary(self) -> str:
        order = float(np.linalg.norm(self.magnetizations[-1]))
        said = f"{write_count(self.count, 'spin')} end{'s' * (self.count == 1)} with"
        said = f"{said} {100.0 * order:.4g} % of the largest magnetisation"
        change = (self.energies[-1] - self.energies[0]) / MILLI
        if self.table.temperature is not None:
            mean, error = self.thermal or (math.nan, math.nan)
            heat = f"{self.table.temperature:g} K"
            energy = uncertain(mean / MILLI, error / MILLI, "meV")
            return f"{self.rounded(said)}; in a bath of {heat} the energy is {energy} per spin."
        if self.system.is_damped:
            return f"{self.rounded(said)}; damping took {self.rounded(f'{-change:.5g} meV')} per spin."
        if self.gap is not None:
            low, high = (f"{energy / MILLI:.5g}" for energy in self.gap)
            return f"{self.rounded(said)}; spin waves have {low if low == high else f'{low} to {high}'} meV."
        return self.rounded(f"{said}, at {self.energies[-1] / MILLI:.6g} meV per spin.")

    @property
    def notes(self) -> list[str]:
        notes = []
        if self.skyrmions is not None and self.table.periodic and abs(self.skyrmions[1]) > 0.5:
            notes.append(f"the spins cover the sphere {self.skyrmions[1]:.0f} times: skyrmions.")
        if len(self.trajectory.times) < self.asked:
            notes.append(f"{len(self.trajectory.times)} of {self.asked} samples are kept: more would take over "
                         f"{LIMITS.max_state_bytes >> 20} MiB.")
        if self.table.temperature is not None:
            notes.append("without an error estimate: other steps would meet another draw of the noise. The ± of the "
                         "mean energy is its scatter.")
        return notes

    def without_motion(self) -> list[Group | Table]:
        """Return the answers that need no trajectory."""
        return [self._about_lattice(), self._bonds(), self._about_waves()]

    @property
    def answers(self) -> list[Group | Table]:
        return [*self.without_motion(), self._motion()]

    def _about_lattice(self) -> Group:
        lattice, table = self.system.lattice, self.table
        cells = " × ".join(str(n) for n in lattice.shape[: lattice.dimension])
        whole = f"{cells} {'cells' if self.count > lattice.sites else 'cell'}"
        words = f"{self.count}, {whole} of {lattice.sites}" + (", closed" if table.periodic else ", open")
        return Group("Lattice", [
            Answer("spins", self.count, "", "spins", "", words),
            Answer("spin", table.spin, "ħ", "length of a spin"),
            Answer("damping", table.damping, "", "damping"),
            Answer("temperature", table.temperature, "K", "temperature", "",
                   None if table.temperature is None else number(table.temperature, "K")),
            Answer("thermal_energy", None if table.temperature is None else boltzmann * table.temperature, "J"),
            Answer("field", None if table.field is None else np.asarray(table.field), "T", "field", "",
                   None if table.field is None else vector(table.field, "T")),
        ])

    def _bonds(self) -> Table:
        rows = [
            {"sites": [bond.i + 1, bond.j + 1], "cell": list(bond.cell),
             "matrix": (hbar * np.array(bond.matrix)).tolist()}
            for bond in self.system.bonds
        ]
        columns = {
            "sites": lambda row: f"{row['sites'][0]}–{row['sites'][1]}",
            "cell": lambda row: str(tuple(row["cell"][: self.system.lattice.dimension])).replace(",)", ")"),
            "J": lambda row: f"{np.trace(row['matrix']) / 3.0 / MILLI:.5g} meV",
            "D": lambda row: vector(_chirality(row["matrix"]) / MILLI, "meV") or "",
        }
        return Table("bonds", "Bonds", columns, rows, {"matrix": "J"})

    def _about_waves(self) -> Group:
        if self.waves is None or self.gap is None:
            words = "the start is random" if self.table.random else "it is not of least energy, or there are dipoles"
            return Group("Spin waves", [Answer("waves", None, "", "about the start", "", f"none: {words}")])
        low, high = self.gap
        period = 2.0 * math.pi * hbar / high if high else None  # without a field nothing precesses
        return Group("Spin waves", [
            Answer("waves.lowest", low, "J", "lowest", "along the first reciprocal vector", f"{low / MILLI:.6g} meV"),
            Answer("waves.highest", high, "J", "highest", "", f"{high / MILLI:.6g} meV"),
            Answer("waves.period", period, "s", "its period"),
        ])

    def _motion(self) -> Group:
        start, end = self.magnetizations[[0, -1]]
        first, last = self.energies[[0, -1]] / MILLI + 0.0  # so that −0 is not printed as a negative number
        thermal, covered = self.thermal, self.skyrmions
        return Group("Motion", [
            Answer("energy.start", float(self.energies[0]), "J", "energy at the start", "per spin", f"{first:.8g} meV"),
            *from_motion(self.trajectory, [
                Answer("energy.end", float(self.energies[-1]), "J", "at the end", "per spin", f"{last:.8g} meV")]),
            Answer("energy.mean", None if thermal is None else thermal[0], "J", "mean, later half", "per spin",
                   None if thermal is None else uncertain(thermal[0] / MILLI, thermal[1] / MILLI, "meV")),
            Answer("energy.mean_error", None if thermal is None else thermal[1], "J"),
            Answer("magnetization.start", start, "", "magnetisation at the start", "of the largest", vector(start)),
            *from_motion(self.trajectory, [
                Answer("magnetization.end", end, "", "at the end", "of the largest", vector(end))]),
            Answer("skyrmion_number", covered, "", "skyrmion number", "at start and end",
                   None if covered is None else f"{_whole(covered[0])} to {_whole(covered[1])}"),
            Answer("method", self.how or None, "", "computed by"),
            *accuracy(self.trajectory),
        ])


def _chirality(matrix: list[list[float]]) -> Array:
    """Return D (3,) of D·(S × S′)."""
    m = np.asarray(matrix)
    return 0.5 * np.array([m[1, 2] - m[2, 1], m[2, 0] - m[0, 2], m[0, 1] - m[1, 0]])


def _whole(value: float) -> str:
    return f"{value:.0f}" if abs(value - round(value)) < 1e-6 else f"{value:.3f}"


def make_report(spec: Spec[SpinLatticeTable]) -> SpinLatticeReport:
    """Return the report on spins on a lattice.

    Raises:
        InvalidInput: for bonds and places that make no lattice, or a time that takes too many steps.
    """
    table = spec.system
    system = build_lattice(table)
    state = build_start(system, table)
    fastest = _fastest(system)
    until = spec.until
    periods = 60.0  # of the fastest spin
    if until is None:
        until = periods * 2.0 * math.pi / fastest if fastest else 1.0
    kept = max(2, min(spec.samples, LIMITS.max_state_bytes // (24 * system.algebra.copies)))
    times = np.linspace(0.0, until, kept)
    trajectory, how = _simulate(spec, system, state, times, fastest)
    return SpinLatticeReport(system, table, _in_joules(trajectory), spec.samples, how)


def _simulate(
    spec: Spec[SpinLatticeTable], system: SpinLattice, state: Array, times: Float64[Array, "time"], fastest: float
) -> tuple[Trajectory, str]:
    """Return the trajectory, and its method in words where it is not the default of ``simulate``."""
    table = spec.system
    if table.temperature is None and has_short_series(system, state):
        return simulate(system, state, times, progress=Watch(spec.until, times, QUICKER)), ""
    count, between = system.algebra.copies, float(times[1] - times[0])
    fastest = max(fastest, float(turning_rates(system, state, times)))
    by_flows = bool(system.flows) and table.temperature is None
    angle = 0.2 if system.is_damped else 0.1  # rad that the fastest spin turns in a step
    step = min(angle / fastest, between) if fastest else between
    of_step, of_spin = 2e-5, 4e-7 if by_flows else 1.5e-6  # s per step, and per spin in it
    each, runs = of_step + of_spin * count, 1.0 if table.temperature is not None else RUNS_BY_EQUAL_STEPS
    shown = check_length(spec.until, times, float(times[-1]) / step, runs * each, QUICKER)
    if table.temperature is not None:
        even = between / math.ceil(between / step - 1e-9)  # noise is keyed by whole steps
        bath = Bath(boltzmann * table.temperature / hbar, table.damping, table.seed)
        solver = NoiseDriftNoise(system, even, bath)
        trajectory = simulate(system, state, times, solver, progress=shown, estimate_error=False)
        # a bath keeps the lengths alone
        drift = {name: value for name, value in trajectory.drift.items() if np.ndim(value)}
        invariants = {name: trajectory.invariants[name] for name in drift}
        words = f"drift between kicks of noise, steps of {in_its_unit(even)}; one draw of the noise out of many"
        return replace(trajectory, drift=drift, invariants=invariants), words
    method, order = (Splitting, 4) if by_flows else (SphericalMidpoint, 2)
    trajectory = simulate(system, state, times, method, step=step, order=order, progress=shown)
    which = "exact turns of bonds" if by_flows else "spherical midpoints"
    words = f"{which}, order {order}, steps of {in_its_unit(step)}: these are too many spins for Taylor series"
    return trajectory, words


def _in_joules(trajectory: Trajectory) -> Trajectory:
    """Return the trajectory with its energy in J; the system's is over ħ, as its spins are."""
    def scale_energies(values: Mapping[str, Any]) -> dict[str, Any]:
        return {name: hbar * value if name == "energy" else value for name, value in values.items()}

    return replace(
        trajectory, invariants=scale_energies(trajectory.invariants), balances=scale_energies(trajectory.balances),
        received=scale_energies(trajectory.received),
        quantities=trajectory.quantities | {"energy": ENERGY},
    )


def answers_without_motion(spec: Spec[SpinLatticeTable]) -> Iterator[Group | Table]:
    """Yield the answers of the report that need no trajectory.

    Raises:
        InvalidInput: for bonds and places that make no lattice.
    """
    yield from SpinLatticeReport(build_lattice(spec.system), spec.system, WITHOUT_MOTION, spec.samples).without_motion()


def _fastest(system: SpinLattice) -> float:
    """Return the largest rate at which a field of these bonds can turn a spin [rad/s], whatever the others do."""
    spin = max(system.spin)
    total = np.zeros(system.lattice.sites)
    for bond in system.bonds:
        strength = spin * float(np.linalg.norm(np.array(bond.matrix), 2))
        total[bond.i] += strength
        total[bond.j] += strength
    if system.onsite is not None:
        total += 2.0 * spin * max(float(np.linalg.norm(np.array(one), 2)) for one in system.onsite)
    field = 0.0 if system.field is None else float(np.linalg.norm(np.asarray(system.field)))
    return float(total.max()) + field

