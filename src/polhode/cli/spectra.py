"""``polhode levels FILE`` and ``polhode lines FILE``: the spectrum of a molecule."""

from __future__ import annotations

import math
import warnings
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from polhode.cli.destinations import check_spares
from polhode.cli.publish import publish
from polhode.errors import InvalidInput, shown
from polhode.formats.rotor_dataset import rotor_attributes, write_spectrum
from polhode.kinds.reading import read_spec_or_molecule
from polhode.quantum.rotor import Rotor, below_ground
from polhode.quantum.strengths import DEBYE, Lines
from polhode.reports.answer import Answer, Group
from polhode.reports.report import Report
from polhode.reports.spectra import AREA, frequency, level_table, line_table
from polhode.spec.reach import check_reach
from polhode.spec.rotors import SpecRotor, asked_of, check_summable, doubts_of_weights
from polhode.spec.units import parse_quantity, parse_spectroscopic


class LineOptions(NamedTuple):
    """Options of ``polhode lines``, as they are given; see there."""

    j_max: int | None
    temperature: str | None
    lowest: str | None
    highest: str | None
    min_intensity: float | None
    most: int
    dipole: str | None


def run_levels(path: Path, j_max: int | None, json: bool, out: Path | None = None) -> None:
    """Print the levels of a molecule."""
    _check_out(out, path)
    with told_of(path) as notes:
        spec = read_spec_or_molecule(path)
        rotor, _, usual, doubts = spec.kind.rotor(spec)
        last = usual if j_max is None else j_max
        found = rotor.levels(last)
        told = (*doubts, below_ground(found.J, found.energy))
        table = level_table(found, last, last)
    notes += [word for word in told if word]
    said = f"Constants {_constants(rotor)}; {len(table.rows)} levels to J = {last}."
    asked = [Answer("constants", rotor.constants, "Hz"), Answer("j_max", last)]
    report = Report(spec.name, "levels", said, [Group("", asked), table], notes, data=lambda path: _write(
        path, levels=found, attributes=rotor_attributes(rotor, spec.name)))  # fmt: skip
    publish(report, json, out)


def run_lines(path: Path, options: LineOptions, json: bool, out: Path | None = None) -> None:
    """Print the strongest lines of a molecule within bounds, by frequency."""
    _check_out(out, path)
    temperature = _read("--temperature", options.temperature, lambda text: parse_quantity(text, "K"))
    lowest = _read("--from", options.lowest, parse_spectroscopic)
    highest = _read("--to", options.highest, parse_spectroscopic)
    bounds = (0.0 if lowest is None else lowest, math.inf if highest is None else highest)
    if bounds[0] > bounds[1]:
        raise InvalidInput(f"--from must not be above --to; got {options.lowest} and {options.highest}.")
    weakest = 0.0 if options.min_intensity is None else options.min_intensity
    if not 0.0 <= weakest < math.inf:
        raise InvalidInput(f"--min-intensity must be a number of nm² MHz, not negative; got {shown(weakest)}.")
    dipole = None if options.dipole is None else _dipole(options.dipole)
    with told_of(path) as notes:
        spec = read_spec_or_molecule(path)
        asked = _asked(spec.kind.rotor(spec), temperature, options.j_max, dipole)
        if not asked.rotor.dipole.any():
            raise InvalidInput('there is no dipole, and no lines without one. Give it, like --dipole "0,1.857,0".')
        check_summable(asked)
        found = asked.rotor.lines(asked.j_max, asked.temperature)
        partition = float(asked.rotor.partition_function(asked.temperature))
    notes += asked.notes
    if asked.rotor.spin_weights == (1.0, 1.0):
        notes.append("nuclear spins are left out: all levels weigh the same.")
    within = (found.frequency >= bounds[0]) & (found.frequency <= bounds[1])
    within &= found.intensity >= AREA * weakest
    inside = np.flatnonzero(within)
    strongest = inside[np.argsort(-found.intensity[inside], kind="stable")[: options.most]]
    chosen = Lines(*(column[np.sort(strongest)] for column in found))
    of_all = f"the {len(strongest)} strongest of {len(inside)}" if len(strongest) < len(inside) else f"{len(inside)}"
    said = f"{of_all} lines at {asked.temperature:g} K, to J = {asked.j_max}."
    told = [
        Answer("constants", asked.rotor.constants, "Hz"), Answer("temperature", asked.temperature, "K"),
        Answer("j_max", asked.j_max), Answer("partition_function", partition), Answer("lines_within", len(inside)),
    ]  # fmt: skip
    groups = [Group("", told), line_table(chosen, "")]
    report = Report(spec.name, "lines", said[0].upper() + said[1:], groups, notes, data=lambda path: _write(
        path, lines=chosen, attributes=rotor_attributes(asked.rotor, spec.name, asked.temperature)))  # fmt: skip
    publish(report, json, out)


def _write(path: Path, **what: Any) -> Path:
    write_spectrum(path, **what)
    return path


def _asked(
    found: SpecRotor, temperature: float | None, j_max: int | None, dipole: tuple[float, ...] | None
) -> SpecRotor:
    """Return what a spec asks for, with what the options say in place of it."""
    rotor, notes = found.rotor, found.notes
    if dipole is not None:
        reduction, representation = (None if x is None else x.name for x in (rotor.reduction, rotor.representation))
        rotor = Rotor(
            rotor.constants, rotor.distortion, reduction, representation, dipole, rotor.spin_weights, rotor.spin_axis
        )
        notes = notes or doubts_of_weights(rotor, None)
    if temperature is None:
        return SpecRotor(rotor, found.temperature, found.j_max if j_max is None else j_max, notes)
    return asked_of(rotor, temperature, j_max, notes)


@contextmanager
def told_of(path: Path) -> Iterator[list[str]]:
    """Name the file in what is refused, and take warnings as notes."""
    notes: list[str] = []
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always", UserWarning)
        try:
            yield notes
        except InvalidInput as error:
            raise error if str(error).startswith(str(path)) else InvalidInput(f"{path}: {error}") from None
    notes += dict.fromkeys(str(warning.message) for warning in caught)


def _check_out(out: Path | None, path: Path) -> None:
    if out is not None:
        check_spares(out, path)


def _constants(rotor: Rotor) -> str:
    return ", ".join("infinite" if math.isinf(x) else frequency(x) for x in rotor.constants)


def _read(option: str, text: str | None, read: Callable[[str], float]) -> float | None:
    if text is None:
        return None
    try:
        found = read(text)
    except ValueError as error:
        raise InvalidInput(f"{option} {error}.") from None
    if found < 0.0:
        raise InvalidInput(f"{option} must not be negative; got {shown(text)}.")
    check_reach(option, found)
    return found


def _dipole(text: str) -> tuple[float, ...]:
    """Return a dipole (3,) [C m] of three numbers in debye with commas between."""
    try:
        values = tuple(float(word) * DEBYE for word in text.split(","))
    except ValueError:
        values = ()
    if len(values) != 3 or not all(map(math.isfinite, values)):
        raise InvalidInput(f"--dipole must be three numbers in debye with commas, like 0,1.857,0; got {shown(text)}.")
    check_reach("--dipole", *values)
    return values
