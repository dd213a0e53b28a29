"""The answers about a molecule: constants, levels, lines, and the polhodes of the levels."""

from __future__ import annotations

import math
import warnings
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any, ClassVar, NamedTuple

import numpy as np

from polhode.bodies.atoms import ATOMIC_MASS_UNIT
from polhode.kinds.base import Spec
from polhode.motion.frame import BodyFrame
from polhode.reports.answer import Answer, Group, Table
from polhode.reports.base import SystemReport
from polhode.spectra._level_polhodes import LevelPolhodes, level_polhodes
from polhode.spectra._partition import THERMAL
from polhode.spectra._strengths import DEBYE, Lines
from polhode.spectra.quantum_rotor.build import build
from polhode.spectra.quantum_rotor.flip import about_flip
from polhode.spectra.quantum_rotor.table import QuantumRotorTable
from polhode.spectra.racket import Racket
from polhode.spectra.reports import WAVE_NUMBER, frequency, label, level_table, line_table, wave_number
from polhode.spectra.rotor import PLANCK_OVER_8_PI_SQUARED, Levels, Rotor, find_fallen, warn_of_fallen
from polhode.spectra.spec_rotors import SpecRotor, check_summable


class QuantumRotorLimits(NamedTuple):
    """What decides how levels and molecules are described.

    Attributes:
        max_pair_splitting: of a doublet that tunnelling splits, over the classical step.
        max_prolate_kappa: Ray's κ up to which a molecule is called nearly prolate.
        min_oblate_kappa: κ from which it is called nearly oblate.
    """

    max_pair_splitting: float = 0.1
    max_prolate_kappa: float = -0.9
    min_oblate_kappa: float = 0.9


LIMITS = QuantumRotorLimits()
U_ANGSTROM_SQUARED = ATOMIC_MASS_UNIT * 1e-20  # kg m²


@dataclass(frozen=True)
class QuantumRotorReport(SystemReport):
    """A molecule's levels and lines.

    Attributes:
        asked: rotor, temperature, largest J.
        levels: up to the largest J.
        lines: up to the largest J, at the temperature; None without a dipole.
        partition: function at the temperature.
        polhodes: of the levels of one J; None of a symmetric molecule.
        J: of these.
        racket: the flip that the spec asks for.
        frame: principal axes of the molecule in its given ones; None of constants alone.
        warned: warnings of the computation.
    """

    kind: ClassVar[str] = "quantum-rotor"
    trajectory: ClassVar[None] = None
    asked: SpecRotor
    levels: Levels
    lines: Lines | None
    partition: float
    polhodes: LevelPolhodes | None
    J: int
    racket: Racket | None
    frame: BodyFrame | None
    warned: tuple[str, ...] = ()

    @property
    def rotor(self) -> Rotor:
        """Its constants."""
        return self.asked.rotor

    @property
    def summary(self) -> str:
        if self.rotor.is_linear:
            return f"A linear molecule, B = {frequency(self.rotor.constants[1])}: levels B J(J + 1)."
        if equal := self.rotor.equal:
            if equal == "ABC":
                return "A spherical top: every level of a J has the same energy."
            shape = "A prolate" if equal == "BC" else "An oblate"
            return f"{shape} symmetric top: levels of a J go by |K|, and every polhode is a circle."
        if self.polhodes is None:
            return f"{_shape(self.rotor.kappa)} (κ = {self.rotor.kappa:.4f})."
        above = int(self.polhodes.above.sum())
        below = len(self.polhodes.above) - above
        return (
            f"{_shape(self.rotor.kappa)} (κ = {self.rotor.kappa:.4f}): of the {below + above} levels of J = {self.J}, "
            f"{below} go round the c axis, below the saddle, and {above} round the a axis."
        )

    @property
    def notes(self) -> list[str]:
        notes = list(self.warned)
        if self.rotor.distortion:
            notes.append(
                f"distortion is a series in J: levels beyond the J of the lines that {len(self.rotor.distortion)} "
                "constants were fitted to run away."
            )
        constants = "give the constants as rotational_constants under [body]"
        how = constants if self.frame is None else "leave [system] out"
        notes.append(
            f"for the classical motion of the same molecule {how} and add a spin, like "
            'temperature = "300 K" under [spin].'
        )
        return notes

    @property
    def answers(self) -> list[Group | Table]:
        groups: list[Group | Table] = [self._molecule(), self._distortion(), *self._levels()]
        if self.lines is not None:
            groups.append(self._strongest(self.lines))
        return [*groups, *self._as_polhodes(), *([] if self.racket is None else [about_flip(self.racket)])]

    def _write_data(self, path: Path) -> Path:
        from polhode.spectra.formats.rotor_dataset import rotor_attributes, write_spectrum

        if self.lines is not None:
            for said in self.warned:  # for readers of the file, who do not have the notes
                if said not in self.asked.notes:
                    warnings.warn(said, stacklevel=2)
        attributes = rotor_attributes(self.rotor, self.name, self.asked.temperature)
        return write_spectrum(path, levels=self.levels, lines=self.lines, attributes=attributes)

    def _molecule(self) -> Group:
        rotor = self.rotor
        constants = np.array(rotor.constants)
        with np.errstate(divide="ignore"):
            moments = PLANCK_OVER_8_PI_SQUARED / constants
        defect = moments[2] - moments[1] - moments[0]
        units = "(" + ", ".join(f"{x:.8g}" for x in moments / U_ANGSTROM_SQUARED) + ") u Å²"
        size = float(np.linalg.norm(rotor.dipole))
        debyes = "(" + ", ".join(f"{x:.6g}" for x in rotor.dipole / DEBYE) + ") D  (along a, b, c)"
        return Group("Molecule", [
            *(Answer(f"constants.{name}", value, "Hz", name, "", _both(value))
              for name, value in zip("ABC", rotor.constants, strict=True)),
            Answer("kappa", rotor.kappa, "", "asymmetry κ", "Ray's: −1 prolate, +1 oblate"),
            Answer("moments", moments, "kg m²", "moments", "about a, b, c", units),
            Answer("inertial_defect", defect, "kg m²", "inertial defect", "I_c − I_b − I_a",
                   f"{defect / U_ANGSTROM_SQUARED:.5g} u Å²"),
            Answer("dipole", rotor.dipole, "C m", "dipole" if size else "", "along a, b, c", debyes),
            Answer("spin_weights", rotor.spin_weights, "", "weights of nuclear spins",
                   f"of levels even and odd under a half turn about {rotor.spin_axis}",
                   f"{rotor.spin_weights[0]:g} and {rotor.spin_weights[1]:g}, even and odd about {rotor.spin_axis}"),
        ])

    def _distortion(self) -> Group:
        rotor = self.rotor
        if rotor.reduction is None or rotor.representation is None:
            return Group("Centrifugal distortion", [])
        said = f"{rotor.reduction.value} reduction, representation {rotor.representation.name}"
        return Group(f"Centrifugal distortion, {said}", [
            Answer("reduction", rotor.reduction.value), Answer("representation", rotor.representation.name),
            *(Answer(f"distortion.{name}", value, "Hz", name, "", f"{value / 1e6:.10g} MHz")
              for name, value in rotor.distortion.items()),
        ])

    def _levels(self) -> Iterator[Group | Table]:
        levels, T = self.levels, self.asked.temperature
        boltzmann = np.exp(-np.maximum(levels.energy, 0.0) / (T * THERMAL)) * ~find_fallen(levels.J, levels.energy)
        populated = (2 * levels.J + 1) * levels.weight * boltzmann
        most = int(np.argmax(populated))
        numbers = (int(levels.J[most]), int(levels.Ka[most]), int(levels.Kc[most]))
        last, shown_j = min(self.asked.j_max, 10), 3  # in the JSON and in the text; `polhode levels` has all
        yield level_table(levels, last, shown_j)
        yield Group(f"At {T:g} K", [
            Answer("temperature", T, "K"),
            Answer("partition_function", self.partition, "", "partition function"),
            Answer("most_populated", label(*numbers), "", "most populated level"),
            Answer("share_of_most_populated", populated[most] / self.partition, "", "", "of all molecules"),
            Answer("j_max", self.asked.j_max, "", "largest J of lines" if self.lines is not None else ""),
        ])

    def _strongest(self, lines: Lines) -> Table:
        listed = 10
        strongest = np.argsort(lines.intensity)[::-1][:listed]
        chosen = Lines(*(column[np.sort(strongest)] for column in lines))
        return line_table(chosen, f"Strongest lines at {self.asked.temperature:g} K")

    def _as_polhodes(self) -> Iterator[Group | Table]:
        polhodes = self.polhodes
        if polhodes is None:
            return
        yield Group(f"Levels of J = {self.J} as polhodes, |L| = J + ½, rigid rotor", [
            Answer("polhodes_J", self.J, "ħ"),
            Answer("saddle", polhodes.saddle, "Hz", "energy of the saddle", "E/h", wave_number(polhodes.saddle)),
            Answer("levels_below_saddle", int((~polhodes.above).sum()), "", "levels below, round c"),
            Answer("levels_above_saddle", int(polhodes.above.sum()), "", "levels above, round a"),
            Answer("semiclassical_error", float(np.abs(polhodes.semiclassical - polhodes.energy).max()), "Hz",
                   "quantised polhodes err by at most", "E/h",
                   frequency(float(np.abs(polhodes.semiclassical - polhodes.energy).max()))),
        ])
        title = "Steps to the next level but one, and turns of L round the polhode between the two"
        yield Table("polhodes", title, _COLUMNS, _rows(polhodes), {
            "energy": "Hz, E/h", "semiclassical": "Hz, E/h, by quantised polhodes",
            "step": "Hz, to the next level but one, of the same ladder",
            "classical_step": "Hz, turns of L a second round the polhode between the two",
            "splitting": "Hz, of the pair that tunnelling splits",
        })


_COLUMNS = {
    "level": lambda row: row["level"],
    "cm⁻¹": lambda row: f"{row['energy'] / WAVE_NUMBER:.4f}",
    "round": lambda row: row["round"],
    "step/h": lambda row: frequency(row["step"]) if math.isfinite(row["step"]) else "–",
    "L goes round": lambda row: frequency(row["classical_step"]) if math.isfinite(row["classical_step"]) else "–",
    "split by": lambda row: (
        frequency(row["splitting"], 6) if is_split(row["splitting"], row["classical_step"]) else "–"
    ),
}


def _rows(polhodes: LevelPolhodes) -> list[dict[str, Any]]:
    J = int(polhodes.Kc[0])
    columns = zip(*(column.tolist() for column in polhodes[:-1]), strict=True)
    return [
        {"level": label(J, Ka, Kc), "energy": energy, "semiclassical": semiclassical, "round": "a" if above else "c",
         "step": step, "classical_step": classical, "splitting": splitting}
        for Ka, Kc, energy, semiclassical, above, step, classical, splitting in columns
    ]


def is_split(splitting: float, classical_step: float) -> bool:
    """Whether two levels form a pair; near the saddle all steps are similar."""
    return not splitting > LIMITS.max_pair_splitting * classical_step  # of the highest pair there is no step


def _both(value: float) -> str:
    if math.isinf(value):
        return "infinite"
    return f"{frequency(value)} = {wave_number(value)}"


def _shape(kappa: float | None) -> str:
    if kappa is None:
        return "A spherical top"
    if kappa < LIMITS.max_prolate_kappa:
        return "A nearly prolate molecule"
    return "A nearly oblate molecule" if kappa > LIMITS.min_oblate_kappa else "An asymmetric molecule"


def make_report(spec: Spec[QuantumRotorTable]) -> QuantumRotorReport:
    """Return the report on a molecule.

    Raises:
        InvalidInput: for constants that no rotor has.
    """
    table = spec.system
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always", UserWarning)
        asked = build(spec)
        check_summable(asked)
        rotor, temperature, j_max, _ = asked
        levels = rotor.levels(j_max)
        lines = rotor.lines(j_max, temperature) if rotor.dipole.any() else None
        partition = float(rotor.partition_function(temperature))
        polhodes = level_polhodes(rotor.constants, table.j)
        wanted = table.racket
        racket = None if wanted is None else Racket(rotor.constants, table.j, wanted.tilt, wanted.towards)
    remarks = (*asked.notes, warn_of_fallen(levels.J, levels.energy), *(str(warning.message) for warning in caught))
    said = tuple(dict.fromkeys(word for word in remarks if word))
    return QuantumRotorReport(
        asked, levels, lines, partition, polhodes, table.j, racket,
        None if spec.body is None else spec.body.frame, said,
    )
