"""``polhode.levels`` and ``polhode.spectrum``: the levels and lines of a molecule."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any, ClassVar

import numpy as np

from polhode._base import check
from polhode.errors import InvalidInput, shown
from polhode.formats.paths import as_path
from polhode.kinds.base import Spec
from polhode.kinds.reading import read_spec_or_molecule
from polhode.reports.answer import Answer, Group, Table
from polhode.reports.report import StudyReport, with_inputs
from polhode.spec.reach import check_reach
from polhode.spec.units import parse_quantity, parse_spectroscopic
from polhode.spectra._strengths import DEBYE, Lines
from polhode.spectra.formats.rotor_dataset import rotor_attributes, write_spectrum
from polhode.spectra.reports import AREA, frequency, level_table, line_table
from polhode.spectra.rotor import Levels, Rotor, warn_of_fallen
from polhode.spectra.spec_rotors import SpecRotor, check_summable, complete_rotor, doubts_of_weights, rotor_of_spec
from polhode.studies.naming import warnings_as_notes

if TYPE_CHECKING:
    from matplotlib.figure import Figure


@dataclass(frozen=True)
class LevelsReport(StudyReport):
    """A molecule's rotational levels.

    Attributes:
        name: of the molecule.
        rotor: its constants.
        levels: to ``j_max``.
        j_max: the largest J.
        warned: caveats.
    """

    kind: ClassVar[str] = "levels"
    data_file: ClassVar[str] = "levels.nc"
    data_endings: ClassVar[tuple[str, ...]] = (".nc",)
    name: str
    rotor: Rotor
    levels: Levels
    j_max: int
    warned: Sequence[str]

    @property
    def summary(self) -> str:
        constants = ", ".join("infinite" if math.isinf(x) else frequency(x) for x in self.rotor.constants)
        return f"Constants {constants}; {len(self._table.rows)} levels to J = {self.j_max}."

    @property
    def answers(self) -> list[Group | Table]:
        asked = [Answer("constants", self.rotor.constants, "Hz"), Answer("j_max", self.j_max)]
        return [Group("", asked), self._table]

    @property
    def notes(self) -> list[str]:
        return [*self.warned, *filter(None, [warn_of_fallen(self.levels.J, self.levels.energy)])]

    @property
    def _table(self) -> Table:
        return level_table(self.levels, self.j_max, self.j_max)

    def figures(self) -> Mapping[str, Callable[[], Figure | None]]:
        from polhode.spectra.figures.level_diagram_figure import level_diagram

        return {"level_diagram": partial(level_diagram, self.rotor, self.j_max)}

    def _write_data(self, path: Path) -> Path:
        return write_spectrum(path, levels=self.levels, attributes=rotor_attributes(self.rotor, self.name))


@dataclass(frozen=True)
class SpectrumReport(StudyReport):
    """A molecule's rotational lines.

    Attributes:
        name: of the molecule.
        asked: its rotor, the temperature and the largest J.
        lines: the strongest within the bounds, by frequency.
        within: how many lines there are within the bounds.
        partition: the partition function.
        warned: warnings of the reader and the rotor.
    """

    kind: ClassVar[str] = "lines"
    data_file: ClassVar[str] = "lines.nc"
    data_endings: ClassVar[tuple[str, ...]] = (".nc",)
    name: str
    asked: SpecRotor
    lines: Lines
    within: int
    partition: float
    warned: Sequence[str]

    @property
    def summary(self) -> str:
        count = len(self.lines.frequency)
        of_all = f"The {count} strongest of {self.within}" if count < self.within else f"{self.within}"
        return f"{of_all} lines at {self.asked.temperature:g} K, to J = {self.asked.j_max}."

    @property
    def answers(self) -> list[Group | Table]:
        asked = self.asked
        return [Group("", [
            Answer("constants", asked.rotor.constants, "Hz"), Answer("temperature", asked.temperature, "K"),
            Answer("j_max", asked.j_max), Answer("partition_function", self.partition),
            Answer("lines_within", self.within),
        ]), line_table(self.lines, "")]  # fmt: skip

    @property
    def notes(self) -> list[str]:
        unweighted = self.asked.rotor.spin_weights == (1.0, 1.0)
        left_out = ["nuclear spins are left out: all levels weigh the same."] if unweighted else []
        return [*self.warned, *self.asked.notes, *left_out]

    def figures(self) -> Mapping[str, Callable[[], Figure | None]]:
        from polhode.spectra.figures.spectrum_figure import spectrum

        return {"spectrum": partial(spectrum, self.lines)}

    def _write_data(self, path: Path) -> Path:
        attributes = rotor_attributes(self.asked.rotor, self.name, self.asked.temperature)
        return write_spectrum(path, lines=self.lines, attributes=attributes)


def levels(molecule: Path | str | Spec[Any], *, j_max: int | None = None) -> LevelsReport:
    """Return the rotational levels of a molecule.

    Args:
        molecule: a spec, its file, or a file of atoms, such as an .xyz.
        j_max: the largest J; the spec's own if left out.

    Raises:
        InvalidInput: for a file that cannot be read, or a J that is not a whole number from 0 to 10,000.

    >>> import polhode as ph
    >>> ph.levels("examples/water_spectrum.toml", j_max=2).summary  # doctest: +SKIP
    'Constants 835.840288 GHz, 435.351717 GHz, 278.1387 GHz; 9 levels to J = 2.'
    """
    return with_inputs(lambda: _levels(molecule, j_max))


def _levels(molecule: Path | str | Spec[Any], j_max: int | None) -> LevelsReport:
    with warnings_as_notes(_place(molecule)) as notes:
        spec = _spec(molecule)
        rotor, _, usual, doubts = rotor_of_spec(spec)
        last = usual if j_max is None else j_max
        rotor_levels = rotor.levels(last)
    return LevelsReport(spec.name, rotor, rotor_levels, last, [*notes, *doubts])


def spectrum(
    molecule: Path | str | Spec[Any], *, j_max: int | None = None, temperature: float | str | None = None,
    lowest: float | str | None = None, highest: float | str | None = None, min_intensity: float = 0.0, most: int = 50,
    dipole: Sequence[float] | None = None,
) -> SpectrumReport:
    """Return the rotational lines of a molecule, the strongest of those within the bounds.

    Args:
        molecule: a spec, its file, or a file of atoms, such as an .xyz.
        j_max: the largest J; the spec's own if left out.
        temperature: [K], or a text like "50 K"; the spec's own, or 300 K, if left out.
        lowest, highest: bounds of the frequency [Hz], or texts like "80 GHz" or "10 cm^-1".
        min_intensity: of the lines [nm² MHz].
        most: how many lines, the strongest of them.
        dipole: (3,) along a, b, c [debye] in place of the spec's.

    Raises:
        InvalidInput: for a file or value that cannot be taken, and for a molecule without a dipole.

    Source: Pickett, Poynter, Cohen et al., J. Quant. Spectrosc. Radiat. Transfer 60 (1998) 883, for the intensities.

    >>> import polhode as ph
    >>> ph.spectrum("examples/water_spectrum.toml", highest="1 THz").plot()  # doctest: +SKIP
    """
    bounds = {"lowest": lowest, "highest": highest}
    return with_inputs(lambda: spectrum_within(molecule, j_max, temperature, bounds, min_intensity, most, dipole))


def spectrum_within(
    molecule: Path | str | Spec[Any], j_max: int | None, temperature: float | str | None,
    bounds: Mapping[str, float | str | None], min_intensity: float, most: int, dipole: Sequence[float] | None,
) -> SpectrumReport:
    """Return the report of ``spectrum``."""
    kelvin = _read_option("`temperature`", temperature, lambda text: parse_quantity(text, "K"))
    low, high = (_read_option(f"`{name}`", bound, parse_spectroscopic) for name, bound in bounds.items())
    low, high = 0.0 if low is None else low, math.inf if high is None else high
    if low > high:
        ends = " and ".join(map(str, bounds.values()))
        raise InvalidInput(f"`lowest` must not be above `highest`; got {ends}.")
    most = check.whole("most", most, 1, what="lines")
    min_intensity = check.number("min_intensity", min_intensity, "nm² MHz", least=0)
    moment = None if dipole is None else _dipole(dipole, "`dipole`")
    with warnings_as_notes(_place(molecule)) as notes:
        spec = _spec(molecule)
        asked = _apply_options(rotor_of_spec(spec), kelvin, j_max, moment)
        if not asked.rotor.dipole.any():
            raise InvalidInput("a molecule without a dipole has no lines. Give one, like `dipole=(0, 1.857, 0)`.")
        check_summable(asked)
        lines = asked.rotor.lines(asked.j_max, asked.temperature)
        partition = float(asked.rotor.partition_function(asked.temperature))
    within = (lines.frequency >= low) & (lines.frequency <= high) & (lines.intensity >= AREA * min_intensity)
    inside = np.flatnonzero(within)
    strongest = inside[np.argsort(-lines.intensity[inside], kind="stable")[:most]]
    chosen = Lines(*(column[np.sort(strongest)] for column in lines))
    return SpectrumReport(spec.name, asked, chosen, len(inside), partition, notes)


def _spec(molecule: Path | str | Spec[Any]) -> Spec:
    return molecule if isinstance(molecule, Spec) else read_spec_or_molecule(as_path("molecule", molecule))


def _place(molecule: Path | str | Spec[Any]) -> str:
    return molecule.name if isinstance(molecule, Spec) else str(molecule)


def _apply_options(
    request: SpecRotor, temperature: float | None, j_max: int | None, dipole: tuple[float, ...] | None
) -> SpecRotor:
    """Return the request of a spec, with the given options in place of its own."""
    rotor, notes = request.rotor, request.notes
    if dipole is not None:
        reduction, representation = (None if x is None else x.name for x in (rotor.reduction, rotor.representation))
        rotor = Rotor(
            rotor.constants, rotor.distortion, reduction, representation, dipole, rotor.spin_weights, rotor.spin_axis
        )
        notes = notes or doubts_of_weights(rotor, None)
    if temperature is None or temperature == request.temperature:
        return SpecRotor(rotor, request.temperature, request.j_max if j_max is None else j_max, notes)
    return complete_rotor(rotor, temperature, j_max, notes)


def _read_option(name: str, value: float | str | None, read: Callable[[str], float]) -> float | None:
    if value is None:
        return None
    try:
        number = read(value) if isinstance(value, str) else float(value)
    except TypeError:
        raise InvalidInput(f"{name} must be a number, or a text with its unit; got {shown(value)}.") from None
    except ValueError as error:
        raise InvalidInput(f"{name} {error}.") from None
    if math.isnan(number):
        raise InvalidInput(f"{name} must be a number; got {shown(value)}.")
    if number < 0.0:
        raise InvalidInput(f"{name} must not be negative; got {shown(value)}.")
    check_reach(name, number)
    return number


def _dipole(dipole: Sequence[float], name: str) -> tuple[float, ...]:
    """Return a dipole (3,) [C m] of three numbers in debye."""
    try:
        values = tuple(float(value) * DEBYE for value in dipole)
    except (TypeError, ValueError):
        raise InvalidInput(f"{name} must be three numbers in debye, along a, b and c; got {shown(dipole)}.") from None
    if len(values) != 3 or not all(map(math.isfinite, values)):
        raise InvalidInput(f"{name} must be three numbers in debye, along a, b and c; got {shown(list(dipole))}.")
    check_reach(name, *values)
    return values
