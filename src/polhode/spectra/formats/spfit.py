"""Lists of measured lines, ``.lin``, as SPFIT takes them: twelve fields of three columns, then free numbers.

Source: Pickett, J. Mol. Spectrosc. 148 (1991) 371.
"""

from __future__ import annotations

import re
import warnings
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from polhode.errors import FormatError, InvalidInput, shown
from polhode.formats.numerals import read_fortran
from polhode.formats.opening import MB, read_text
from polhode.formats.paths import as_path, write_whole
from polhode.spectra import MeasuredLines
from polhode.spectra.formats.fixed_columns import Field, read_coded, read_rows, write_rows
from polhode.spectra.formats.spcat import HERTZ_OF_WAVE_NUMBER
from polhode.types import Array, Float64, Integer

LARGEST_FILE = 128 * MB
NUMBERS = [Field(f"quantum number {k + 1}", 3 * k, 3) for k in range(12)]
FIXED_WIDTH = 36  # columns of the quantum numbers
HERTZ_OF_MEGAHERTZ = 1e6
Row = tuple[tuple[int, ...], tuple[int, ...], float, float, float]


@dataclass(frozen=True, eq=False)
class LineList:
    """Measured lines as a ``.lin`` file has them.

    Attributes:
        upper, lower: (n, k) quantum numbers, such as J, K_a, K_c.
        value, error: (n,) frequencies and their errors [MHz]; both [cm⁻¹] where the error is negative.
        weight: (n,) of the member of a blend. Neighbours of equal value and error are one.
        text: the lines as they were read; ``write_lin`` keeps those whose values did not change.
        left_out: how many lines follow the first blank one, where SPFIT ends reading, and so does ``read_lin``.
    """

    upper: Integer[Array, "n k"]
    lower: Integer[Array, "n k"]
    value: Float64[Array, "n"]
    error: Float64[Array, "n"]
    weight: Float64[Array, "n"]
    text: tuple[str, ...] | None = None
    left_out: int = 0

    def measured(self) -> MeasuredLines:
        """Return the lines of an asymmetric top in Hz, for ``fit_rotor``.

        Six quantum numbers that were filled up by zeros to twelve are taken as six. A warning says if lines were left
        out behind a blank one.

        Raises:
            InvalidInput: for levels that are not J, K_a, K_c, or a line that to SPFIT is the width of the blend before.
        """
        upper, lower = self.upper, self.lower
        if upper.shape[1] == 6 and not lower.any():
            upper, lower = upper[:, :3], upper[:, 3:]
        if upper.shape[1] != 3:
            raise InvalidInput(
                f"the lines must have three quantum numbers for each level, J, Ka, Kc; these have "
                f"{self.upper.shape[1]}. Only rotors without vibration and spins are fitted."
            )
        again, error = np.diff(self.value) == 0.0, np.abs(self.error)
        blended = again[:-1] & (np.diff(self.error)[:-1] == 0.0)
        widths = np.flatnonzero(blended & again[1:] & (error[2:] >= 2.0 * error[1:-1]))
        if len(widths):
            raise InvalidInput(
                f"line {int(widths[0]) + 3} has the frequency of the blend before it and at least twice its error: to "
                "SPFIT this is the width of the blend, which is not fitted here. Leave the line out."
            )
        if self.left_out:
            warnings.warn("behind the first blank line, where SPFIT ends reading, there are more lines, left out: "
                          f"{self.left_out}.", stacklevel=2)
        unit = np.where(self.error < 0.0, HERTZ_OF_WAVE_NUMBER, HERTZ_OF_MEGAHERTZ)
        return MeasuredLines(upper, lower, self.value * unit, np.abs(self.error) * unit, self.weight)


def read_lin(path: str | Path) -> LineList:
    """Return the lines of a ``.lin`` file, to its first blank line, as SPFIT reads it.

    Words behind the quantum numbers, in columns that these leave free, are notes.

    Raises:
        InvalidInput: if it is missing.
        FormatError: with line and columns of a field that breaks the format.
    """
    path = as_path("path", path)
    remedy = "A list of lines has twelve fields of three columns, then frequency, error and perhaps a weight."
    pairs = list(read_rows(path, read_text(path, "line list", LARGEST_FILE), _row, remedy, True))
    rows = [row for row, _ in pairs]
    for k, row in enumerate(rows):
        if len(row[0]) != len(rows[0][0]):
            raise FormatError(f"{path}, entry {k + 1}: has {len(row[0])} quantum numbers for each level, and the first "
                              f"has {len(rows[0][0])}. Write as many in every line.")
    upper, lower, value, error, weight = (np.array(column) for column in zip(*rows, strict=True))
    texts = tuple(text for _, text in pairs)
    left_out = sum(bool(line.strip()) for line in texts[-1].split("\n")) - 1  # the last includes the text behind it
    return LineList(upper, lower, value, error, weight, texts, left_out)


def write_lin(lines: LineList, path: str | Path) -> None:
    """Write a ``.lin`` file; numbers have as many digits as they need to be read back as they are.

    Unchanged lines from ``read_lin`` are written as they were, byte for byte, comments included.

    Raises:
        InvalidInput: for quantum numbers that do not fit into their columns, or a place that cannot be written to.
    """
    ends = ([tuple(row) for row in np.asarray(part).tolist()] for part in (lines.upper, lines.lower))
    numbers = (np.asarray(part, float).tolist() for part in (lines.value, lines.error, lines.weight))
    rows: list[Row] = list(zip(*ends, *numbers, strict=True))
    text = write_rows(rows, lines.text, _row, _line)
    with write_whole(path) as draft:
        draft.write_bytes(text.encode())


def line_list(lines: MeasuredLines) -> LineList:
    """Return measured lines as a ``.lin`` file has them, in MHz."""
    weight = np.ones(len(lines.frequency)) if lines.weight is None else lines.weight
    return LineList(lines.upper, lines.lower, lines.frequency / HERTZ_OF_MEGAHERTZ, lines.error / HERTZ_OF_MEGAHERTZ,
                    weight)


def _row(line: str) -> Row:
    """Return the numbers of a line.

    Raises:
        ValueError: naming columns.
    """
    words = [line[field.begin : field.begin + 3].strip() for field in NUMBERS]
    note = next((k for k in range(2, len(words)) if words[k] and not _is_number(words[k])), len(words))
    filled = [k for k, word in enumerate(words[:note]) if word]
    count = len(filled)
    if not count or count % 2 or filled != list(range(count)):
        raise ValueError(f"columns 1 to 36: must hold as many upper as lower quantum numbers, one after the other; got "
                         f"{shown(line[:FIXED_WIDTH].rstrip())}")
    numbers = [field.whole(line) for field in NUMBERS[:count]]
    free = [word for word in re.split(r"[\s,]+", line[FIXED_WIDTH:].split("/")[0]) if word]
    try:
        value, error = (read_fortran(word) for word in free[:2])
    except ValueError as problem:
        why = f"must be a frequency and its error; got {shown(line[FIXED_WIDTH:].strip())}"
        raise ValueError(f"columns {FIXED_WIDTH + 1} and on: {why}: each {problem}" if len(free) > 1 else
                         f"columns {FIXED_WIDTH + 1} and on: {why}") from None
    try:
        weight = read_fortran(free[2]) if len(free) > 2 else 1.0
    except ValueError:
        weight = 1.0  # a comment
    return tuple(numbers[: count // 2]), tuple(numbers[count // 2 :]), value, error, weight


def _is_number(word: str) -> bool:
    try:
        read_coded(word, NUMBERS[0].width)
    except ValueError:
        return False
    return True


def _line(row: Row) -> str:
    """Return a line of numbers.

    Raises:
        ValueError: naming columns that are too narrow.
    """
    upper, lower, *numbers = row
    fixed = "".join(field.write_value(value) for field, value in zip(NUMBERS, (*upper, *lower), strict=False))
    value, error, weight = (repr(number) for number in numbers)
    return f"{fixed.ljust(FIXED_WIDTH)} {value:>18} {error:>12} {weight:>6}"
