"""Catalogues of lines, ``.cat``: fixed columns, as SPCAT writes them and the JPL and Cologne catalogues have them.

Source: Pickett, Poynter, Cohen, Delitsky, Pearson & Müller, J. Quant. Spectrosc. Radiat. Transfer 60 (1998) 883.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import NamedTuple

import numpy as np

from polhode._base import check
from polhode.errors import InvalidInput, shown
from polhode.formats.opening import MB, read_text
from polhode.formats.paths import as_path, write_whole
from polhode.spectra import Lines
from polhode.spectra.formats.fixed_columns import Field, read_rows, write_rows
from polhode.types import Array, ArrayLike, Float64, Integer, Real

LARGEST_FILE = 512 * MB
REALS = (Field("frequency", 0, 13, 4), Field("error", 13, 8, 4), Field("lg intensity", 21, 8, 4))
ENERGY = Field("lower energy", 31, 10, 4)
DEGREES, DEGENERACY, TAG, FORM = Field("degrees of freedom", 29, 2), Field("upper degeneracy", 41, 3), Field(
    "tag", 44, 7), Field("quantum number format", 51, 4)  # fmt: skip
UPPER, LOWER = ([Field(f"{name} quantum number {k + 1}", begin + 2 * k, 2) for k in range(6)]
                for name, begin in (("upper", 55), ("lower", 67)))
ASYMMETRIC_TOP, LINEAR = 303, 101  # J, Ka, Kc; J alone


class CatalogueLimits(NamedTuple):
    """What the catalogue's columns hold.

    Attributes:
        max_error: MHz, where SPCAT ends too.
        min_brightness: lg of nm² MHz of the faintest line written.
        max_frequency: Hz: F13.4 of MHz.
    """

    max_error: float = 999.9999
    min_brightness: float = -99.0
    max_frequency: float = 1e14 - 1e2


LIMITS = CatalogueLimits()
HERTZ_OF_WAVE_NUMBER = 29979.2458e6


class _Row(NamedTuple):
    """A line: its numbers from left to right, and its levels' quantum numbers."""

    numbers: tuple[float, ...]
    upper: tuple[int, ...]
    lower: tuple[int, ...]


@dataclass(frozen=True, eq=False)
class Catalogue:
    """Lines of a catalogue; each array (n,) or (n, k), in the file's units.

    Attributes:
        frequency, error: [MHz], in some catalogues [cm⁻¹], which the file does not say.
        log_intensity: lg of the intensity at 300 K [nm² MHz].
        degrees: of freedom of rotation: 0 for atoms, 2 for linear molecules, 3 for others.
        lower_energy: [cm⁻¹].
        degeneracy: of the upper level, spins of nuclei included.
        tag: of the species; negative for frequencies that were measured.
        form: what the quantum numbers are: 303 for J, K_a, K_c, 101 for J; its last digit is how many there are.
        upper, lower: (n, k) quantum numbers; zero beyond those that a line has.
        text: the lines as they were read; ``write_cat`` keeps those whose values did not change.
    """

    frequency: Float64[Array, "n"]
    error: Float64[Array, "n"]
    log_intensity: Float64[Array, "n"]
    degrees: Integer[Array, "n"]
    lower_energy: Float64[Array, "n"]
    degeneracy: Integer[Array, "n"]
    tag: Integer[Array, "n"]
    form: Integer[Array, "n"]
    upper: Integer[Array, "n k"]
    lower: Integer[Array, "n k"]
    text: tuple[str, ...] | None = None


def read_cat(path: str | Path) -> Catalogue:
    """Return the lines of a ``.cat`` file, by fixed columns.

    Raises:
        InvalidInput: if it is missing.
        FormatError: with line and columns of a field that breaks the format.
    """
    path = as_path("path", path)
    text = read_text(path, "catalogue", LARGEST_FILE)
    remedy = "A catalogue has fixed columns: F13.4 F8.4 F8.4 I2 F10.4 I3 I7 I4 12I2."
    pairs = list(read_rows(path, text, _row, remedy))
    rows = [row for row, _ in pairs]
    kinds = (float, float, float, int, float, int, int, int)
    columns = zip(*(row.numbers for row in rows), strict=True)
    frequency, error, brightness, degrees, energy, degeneracy, tag, form = (
        np.array(column, kind) for column, kind in zip(columns, kinds, strict=True))
    upper, lower = _pad_numbers([row.upper for row in rows]), _pad_numbers([row.lower for row in rows])
    kept = tuple(line for _, line in pairs)
    return Catalogue(frequency, error, brightness, degrees, energy, degeneracy, tag, form, upper, lower, kept)


def write_cat(catalogue: Catalogue, path: str | Path) -> None:
    """Write a ``.cat`` file.

    Unchanged lines from ``read_cat`` are written as they were, byte for byte.

    Raises:
        InvalidInput: for numbers that do not fit into their columns, or a place that cannot be written to.
    """
    columns = (catalogue.frequency, catalogue.error, catalogue.log_intensity, catalogue.degrees,
               catalogue.lower_energy, catalogue.degeneracy, catalogue.tag, catalogue.form)  # fmt: skip
    numbers = zip(*(np.asarray(column).tolist() for column in columns), strict=True)
    rows = []
    for first, upper, lower in zip(numbers, catalogue.upper.tolist(), catalogue.lower.tolist(), strict=True):
        count = first[-1] % 10
        rows.append(_Row(first, tuple(upper[:count]), tuple(lower[:count])))
    text = write_rows(rows, catalogue.text, _row, _line)
    with write_whole(path) as draft:
        draft.write_bytes(text.encode())


def catalogue_of(
    lines: Lines, error: Real[ArrayLike, "*n"] = 0.0, tag: int = 1, degrees: int = 3
) -> Catalogue:
    """Return computed lines as a catalogue.

    Invisible lines, of intensity zero or below 1e-99 nm² MHz, are left out, and so are those from 10⁸ MHz on, for which
    the columns have no room.

    Args:
        lines: of ``Rotor.lines`` at a temperature, by custom 300 K.
        error: of their frequencies [Hz], such as ``RotorFit.predict`` gives; written up to 999.9999 MHz.
        tag: of the species.
        degrees: of freedom of rotation, 2 for a linear molecule, whose levels the catalogue has by J alone, format 101.

    Raises:
        InvalidInput: for lines without intensities, or of levels that no linear molecule has.

    >>> from polhode.spectra import DEBYE, Rotor
    >>> catalogue = catalogue_of(Rotor((27e9, 14e9, 9e9), dipole=(0.0, DEBYE, 0.0)).lines(1, 300.0))
    >>> catalogue.frequency.round(4).tolist(), catalogue.upper.tolist(), catalogue.degeneracy.tolist()
    ([18000.0, 36000.0], [[1, 1, 0], [1, 1, 1]], [3, 3])
    """
    if np.isnan(lines.intensity).any():
        raise InvalidInput("`lines` must have intensities: compute them at a temperature, by custom 300 K.")
    errors = np.broadcast_to(check.array("error", error, None, "Hz", least=0), lines.frequency.shape) / 1e6
    with np.errstate(divide="ignore"):
        brightness = np.log10(lines.intensity * 1e12)
    kept = (brightness >= LIMITS.min_brightness) & (lines.frequency < LIMITS.max_frequency)
    weight = lines.weight * (2 * lines.upper[:, 0] + 1)
    if (weight % 1.0 != 0.0).any():
        raise InvalidInput(f"spin weights must be whole numbers in a catalogue; got {shown(lines.weight)}.")
    if degrees == 2 and (lines.upper[:, 1].any() or lines.lower[:, 1].any()):
        raise InvalidInput("`degrees` must be 3 for lines between levels of K_a above 0, which no linear molecule has.")
    form, quanta = (LINEAR, 1) if degrees == 2 else (ASYMMETRIC_TOP, 3)
    whole = np.ones(int(kept.sum()), int)
    return Catalogue(
        lines.frequency[kept] / 1e6, np.minimum(errors, LIMITS.max_error)[kept], brightness[kept],
        degrees * whole, lines.lower_energy[kept] / HERTZ_OF_WAVE_NUMBER, weight[kept].astype(int),
        tag * whole, form * whole, lines.upper[kept, :quanta], lines.lower[kept, :quanta],
    )


def _pad_numbers(numbers: list[tuple[int, ...]]) -> Array:
    """Return quantum numbers as an array, zero beyond those that a line has."""
    count = max(len(row) for row in numbers)
    return np.array([row + (0,) * (count - len(row)) for row in numbers])


def _row(line: str) -> _Row:
    """Return the numbers of a line.

    Raises:
        ValueError: naming columns.
    """
    form = FORM.whole(line)
    count = form % 10
    if form < 0 or not 1 <= count <= 6:
        raise ValueError(f"{FORM.place}: {FORM.name} must end in 1 to 6, how many numbers there are; got {form}")
    if line[LOWER[-1].begin + 2 :].strip():
        raise ValueError(f"columns 80 and on: must be empty; got {shown(line[79:].strip())}")
    frequency, error, brightness = (field.real(line) for field in REALS)
    upper, lower = (tuple(field.whole(line) for field in fields[:count]) for fields in (UPPER, LOWER))
    numbers = (frequency, error, brightness, DEGREES.whole(line), ENERGY.real(line), DEGENERACY.whole(line),
               TAG.whole(line), form)  # fmt: skip
    return _Row(numbers, upper, lower)


def _line(row: _Row) -> str:
    """Return a line of numbers.

    Raises:
        ValueError: naming columns that are too narrow.
    """
    fields = (*REALS, DEGREES, ENERGY, DEGENERACY, TAG, FORM)
    text = "".join(field.write_value(value) for field, value in zip(fields, row.numbers, strict=True))
    for own, values in ((UPPER, row.upper), (LOWER, row.lower)):
        text += "".join(field.write_value(value) for field, value in zip(own, values, strict=False)).ljust(12)
    return text.rstrip()
