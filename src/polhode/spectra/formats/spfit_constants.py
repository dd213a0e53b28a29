"""Constants of molecules, ``.par`` and ``.var``, as SPFIT and SPCAT take them: codes of operators and their numbers.

Codes: 10000, 20000, 30000 A, B, C; 1000 n + 100 m times J^{2m} J_z^{2n}; 10000 (q + 3) more times J₊^{2q} + J₋^{2q}.
The numbers are those of the operators, so that 200 is −D_J. There are two bases, I^r and, for a negative number of
states, III^l, in which J_z is J_c. Source: Pickett, J. Mol. Spectrosc. 148 (1991) 371.
"""

from __future__ import annotations

import math
import re
import warnings
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from polhode.errors import FormatError, InvalidInput, shown
from polhode.formats.numerals import read_fortran, read_number
from polhode.formats.opening import MB, read_text
from polhode.formats.paths import as_path, write_whole
from polhode.spectra import Reduction, Representation, Rotor
from polhode.spectra._derivatives import find_tied
from polhode.spectra._operators import TERMS, Term
from polhode.types import Array, Float64, Integer, Real

LARGEST_FILE = 16 * MB
WIDTH, IN_A_ROW = 10, 8  # of the factor of the correlations
UNLIMITED_K = 99.0  # from here on a file means no limit
FREE = 1e37  # MHz; the error of a constant that is free
FIXED = 1e-37  # MHz; an error by which SPFIT leaves a constant as it is
AXES = {10000: (1.0, 0.0, 0.0), 20000: (0.0, 1.0, 0.0), 30000: (0.0, 0.0, 1.0), 100: (1.0, 1.0, 1.0)}
"""What codes add to A, B, C."""
BASES = {
    Representation.Ir: {1000: (1.0, 0.0, 0.0), 40000: (0.0, 2.0, -2.0)},
    Representation.IIIl: {1000: (0.0, 0.0, 1.0), 40000: (-2.0, 2.0, 0.0)},
}
"""The bases of these files, with what the codes of J_z² and J₊² + J₋² add to A, B, C."""


@dataclass(frozen=True, eq=False)
class ConstantTable:
    """Constants as a ``.par`` or ``.var`` file has them.

    Attributes:
        title: the first line.
        reduction: "A" or "S", whose operators the file has; where both have, by the letter, which to the program
            is only a label.
        options: those of the third line after the letter, None for the program's own default: degeneracy of
            spins, states of vibration (negative for an oblate basis), least and largest K (0 and 0: a linear molecule),
            interactions left out, axis and weights of even and odd levels, symmetry, …
        code: (n,) of operators; negative ones keep their ratio to the one before.
        value, error: (n,) [MHz].
        label: (n,) names in the file.
        correlation: (n, n) of the errors; None where the file does not have it.
        more_options: those of further lines, one for each state of vibration that differs.
    """

    title: str
    reduction: str
    options: tuple[float | None, ...]
    code: Integer[Array, "n"]
    value: Float64[Array, "n"]
    error: Float64[Array, "n"]
    label: tuple[str, ...]
    correlation: Float64[Array, "n n"] | None = None
    more_options: tuple[tuple[float | None, ...], ...] = ()

    def rotor(self, dipole: Real[Array, "3"] | tuple[float, float, float] = (0.0, 0.0, 0.0)) -> Rotor:
        """Return the rotor with these constants, in I^r, or III^l where the number of states is negative.

        A file whose least and largest K are 0 is one of a linear molecule. Any other largest K is a limit of the
        program's basis, not of the molecule: this rotor has all levels, and a warning says where they differ.

        Raises:
            InvalidInput: for spins, several states of vibration, a least K, weights about axes of higher order, or
                operators that Watson's reduction does not have.
        """
        spins, states, least, largest, _, axis, even, odd, symmetry, l_doubling = (*self.options, *[None] * 10)[:10]
        if abs(1.0 if spins is None else spins) != 1.0 or abs(1.0 if states is None else states) != 1.0:
            raise InvalidInput("the constants must be of one state without spins: the first two options must be 1; got "
                               f"{shown(spins)} and {shown(states)}.")
        if self.more_options:
            raise InvalidInput("the constants must be of one state, with one line of options; the ninth option is "
                               f"negative, and {len(self.more_options)} more lines of options follow.")
        if least:
            raise InvalidInput(f"the least K (third option) must be 0; got {least:g}. A rotor has levels of all K.")
        if l_doubling is not None and abs(l_doubling) >= 100.0:
            raise InvalidInput(f"the tenth option must be below 100: l-doubled states are none of a plain rotor; got "
                               f"{l_doubling:g}.")
        about = "a" if axis is None or axis == 0.0 else "abc"[int(abs(axis)) - 1] if abs(axis) in (1, 2, 3) else None
        if about is None:
            raise InvalidInput(f"the axis of spin weights (sixth option) must be 1, 2 or 3; got {shown(axis)}. Weights "
                               "of symmetric tops are not supported: write 1 and equal weights.")
        weights = (1.0 if even is None else even, 1.0 if odd is None else odd)
        if symmetry is not None and symmetry > 0.0 and symmetry % 2.0 == 1.0:  # an odd last digit
            weights = (weights[1], weights[0])
        basis = Representation.IIIl if states is not None and states < 0.0 else Representation.Ir
        if largest == 0.0:
            return self._linear(basis, dipole, weights, about)
        if largest is not None and largest < UNLIMITED_K:
            warnings.warn(
                f"the file leaves out states of K above {largest:g} (fourth option); this rotor has them all, so that "
                f"levels of J above {largest:g} differ from its program's.", stacklevel=2,
            )
        rigid, distortion = self._constants(basis)
        return Rotor(rigid, distortion, self.reduction, basis.name, dipole, weights, about)

    def _constants(self, basis: Representation) -> tuple[Float64[Array, "3"], dict[str, float]]:
        """Return A, B, C and distortion [Hz].

        Raises:
            InvalidInput: for operators that the reduction does not have.
        """
        axes = AXES | BASES[basis]
        names = {encode(term): (name, term.sign) for name, term in TERMS[Reduction[self.reduction]].items()}
        rigid, distortion = np.zeros(3), {}
        for code, value, label in zip(np.abs(self.code).tolist(), self.value.tolist(), self.label, strict=True):
            bare = _bare(code)
            if bare in axes:
                rigid += value * 1e6 * np.array(axes[bare])
            elif bare in names:
                name, sign = names[bare]
                distortion[name] = distortion.get(name, 0.0) + sign * value * 1e6
            else:
                raise InvalidInput(
                    f"the {self.reduction} reduction to the eighth power of J has no operator {code} ({label}). Levels "
                    "without it are others; leave it out only where it is negligible."
                )
        return rigid, distortion

    def _linear(self, basis: Representation, dipole: Any, weights: tuple[float, float], about: str) -> Rotor:
        """Return the linear rotor: at K = 0 operators with J_z or J± do nothing."""
        rigid, distortion = self._constants(basis)
        terms = TERMS[Reduction[self.reduction]]
        kept = {name: value for name, value in distortion.items() if not (terms[name].of_Jz or terms[name].of_ladder)}
        B = float(np.delete(rigid, "abc".index(basis.value[2])).mean())
        return Rotor((math.inf, B, B), kept, self.reduction, basis.name, dipole, weights, about)


def _bare(code: int) -> int:
    return code - 99 if code % 100 == 99 else code  # 99: in all states of vibration


def encode(term: Term) -> int:
    """Return the code of an operator.

    >>> encode(TERMS[Reduction.S]["D_J"]), encode(TERMS[Reduction.S]["d2"]), encode(TERMS[Reduction.A]["delta_K"])
    (200, 50000, 41000)
    """
    return (10000 * (term.of_ladder + 3) if term.of_ladder else 0) + 1000 * term.of_Jz + 100 * term.of_J


def constant_table(
    rotor: Rotor, sigma: Mapping[str, float] | None = None, title: str = "",
    correlation: Real[Array, "k k"] | None = None,
) -> ConstantTable:
    """Return a rotor's constants as a ``.par`` file has them.

    Args:
        rotor: in I^r or III^l.
        sigma: errors by name [Hz], such as ``dict(zip(fit.names, fit.sigma))``; other constants are fixed, but those of
            a symmetric top that are equal to one of these, which go with it. NaN, no error, is written as the huge
            error of a free constant.
        title: one line.
        correlation: (k, k) of the k errors in the order of ``sigma``, such as ``fit.correlation``.

    Raises:
        InvalidInput: for a correlation that does not go with ``sigma``, linear molecules, other
            representations, and spin weights that are not whole numbers.
    """
    if rotor.is_linear:
        raise InvalidInput("`rotor` must not be linear: these files would need other codes.")
    if rotor.representation is not None and rotor.representation not in BASES:
        raise InvalidInput(f"`rotor` must be in the representation Ir or IIIl, which these files have; got "
                           f"{rotor.representation.name}. Fit its lines in one of these.")
    if any(weight % 1.0 for weight in rotor.spin_weights):
        raise InvalidInput(f"`spin_weights` must be whole numbers in a file; got {shown(rotor.spin_weights)}.")
    names = list(sigma or {})
    if correlation is not None and np.shape(correlation) != (len(names), len(names)):
        raise InvalidInput(f"`correlation` must be square, with a row for each of the {len(names)} errors of `sigma`; "
                           f"got the shape {shown(np.shape(correlation))}.")
    reduction = rotor.reduction or Reduction.S
    names = [_first_equal(rotor, name, names) for name in names]
    sigma = dict(zip(names, (sigma or {}).values(), strict=True))
    rows = [(_code_of_axis(rotor, "ABC"[k], names), value, "ABC"[k]) for k, value in enumerate(rotor.constants)]
    for name, value in rotor.distortion.items():
        term = TERMS[reduction][name]
        rows.append((encode(term), term.sign * value, name))
    of_row = [sigma.get(name, sigma.get(_first_equal(rotor, name, [name]), 0.0) if code < 0 else 0.0)
              for code, _, name in rows]
    error = [FREE if np.isnan(one) else max(one / 1e6, FIXED) for one in of_row]
    axis = float("abc".index(rotor.spin_axis) + 1)
    states = -1.0 if rotor.representation is Representation.IIIl else 1.0
    options = (1.0, states, 0.0, 99.0, 0.0, axis, *rotor.spin_weights, 0.0, 0.0, 0.0, 0.0)
    code, value, label = zip(*rows, strict=True)
    together = None
    if correlation is not None and not np.isnan(np.asarray(correlation)).any():
        signs = {name: TERMS[reduction][name].sign for name in rotor.distortion}
        together = np.eye(len(rows))
        fitted = [k for k, name in enumerate(label) if name in names]
        there = [names.index(label[k]) for k in fitted]
        sign = np.array([signs.get(label[k], 1) for k in fitted])
        together[np.ix_(fitted, fitted)] = np.asarray(correlation)[np.ix_(there, there)] * np.outer(sign, sign)
    return ConstantTable(title, reduction.name, options, np.array(code), np.array(value) / 1e6, np.array(error), label,
                         together)


def _first_equal(rotor: Rotor, name: str, free: Sequence[str]) -> str:
    """Return the name of a rotational constant, or of the first that it is equal to and goes with."""
    return min(find_tied(rotor, name, free)) if name in rotor.equal else name


def _code_of_axis(rotor: Rotor, axis: str, free: Sequence[str]) -> int:
    """Return the code of A, B or C, below zero of one that goes with the one before as they are equal."""
    code = 10000 * ("ABC".index(axis) + 1)
    follows = axis in rotor.equal[1:] and axis not in free and any(name in rotor.equal for name in free)
    return -code if follows else code


def read_par(path: str | Path) -> ConstantTable:
    """Return the constants of a ``.par`` or ``.var`` file, with the correlations that the latter ends with.

    The file has them as an upper triangular factor U of their matrix, U Uᵀ, with rows of length 1, packed by columns in
    8F10.6; the program's documentation calls it the Cholesky factor, which is another matrix. Codes below zero, which
    keep their ratio to the one before, have none of their own. As SPFIT does, an incomplete U is left out. An error
    that is left out is huge in a ``.par``, whose constant is free, and 0 in a ``.var``.

    Raises:
        InvalidInput: if it is missing.
        FormatError: naming the line that is not as it must be.
    """
    path = as_path("path", path)
    lines = read_text(path, "constants", LARGEST_FILE).split("\n")
    if len(lines) < 4:
        raise FormatError(f"{path}: must have a title, two lines of options, and a line for each constant; it has "
                          f"{len(lines)}. Check the path.")
    count = _options(path, 2, lines[1])[0]
    letter = re.match(r"\s*([A-Za-z])\s*,?", lines[2])
    options = _options(path, 3, lines[2][letter.end() :] if letter else lines[2])
    if count is None or not 1 <= count <= 1e6 or count % 1.0:
        raise FormatError(f"{path}, line 2: must begin with the number of constants; got {shown(lines[1].strip())}.")
    begin, more, last = 3, [], options
    while len(last) > 8 and (last[8] or 0.0) < 0.0 and begin < len(lines):  # says that one more line of options follows
        last = _options(path, begin + 1, re.sub(r"^\s*[A-Za-z]", " ", lines[begin]))
        more.append(tuple(last))
        begin += 1
    rows = []
    left_out = 0.0 if path.suffix.lower() == ".var" else FREE
    for number, line in enumerate(lines[begin:], begin + 1):
        if len(rows) == count or not line.strip():
            break
        rows.append(_constant(path, number, line, left_out))
    if not rows:
        raise FormatError(f"{path}, line {begin + 1}: must be a constant: code, value, error. It is empty.")
    code, value, error, label = zip(*rows, strict=True)
    codes = np.array(code)
    end = begin + len(rows)
    return ConstantTable(lines[0].rstrip(), _reduction(letter[1].upper() if letter else "", codes), tuple(options),
                         codes, np.array(value), np.array(error), tuple(label),
                         _correlation(path, end + 1, lines[end:], codes), tuple(more))


def write_par(table: ConstantTable, path: str | Path) -> None:
    """Write a ``.par`` file, or with the ending ``.var`` one that ends with the correlations, if there are any.

    Raises:
        InvalidInput: for a place that cannot be written to, or a title of several lines.
    """
    if "\n" in table.title or "\r" in table.title:
        raise InvalidInput(f"`title` must be one line; got {shown(table.title)}.")
    lines = [table.title, f"{len(table.code):5d}{99999:6d}{20:5d}{0:5d}    0.0000E+00    1.0000E+06    1.0000E+00 1.0"]
    lines += [f"{table.reduction.lower()} {_numbers(each)}" for each in (table.options, *table.more_options)]
    for code, value, error, label in zip(table.code, table.value, table.error, table.label, strict=True):
        lines.append(f"{code:13d} {value: .15E} {error:.8E} /{label}")
    rounding = 1e-12  # added to correlations, which may be singular within rounding
    if table.correlation is not None and Path(path).suffix.lower() == ".var":
        own = table.code >= 0
        matrix = table.correlation[np.ix_(own, own)] + rounding * np.eye(int(own.sum()))
        factor = np.linalg.cholesky(matrix[::-1, ::-1])[::-1, ::-1]  # upper triangular
        packed = [f"{x:10.7f}" for x in factor.T[np.tril_indices(len(factor))].tolist()]
        lines += ["".join(packed[k : k + IN_A_ROW]) for k in range(0, len(packed), IN_A_ROW)]
    with write_whole(path) as draft:
        draft.write_bytes(("\n".join(lines) + "\n").encode())


def _correlation(path: Path, number: int, lines: list[str], code: Array) -> Array | None:
    """Return the matrix that a ``.var`` ends with; None where there is none, or not all of it.

    Raises:
        FormatError: for a matrix that is not of correlations.
    """
    lower: list[float] = []
    for line in lines:
        for at in range(0, len(line.rstrip()), WIDTH):
            try:
                lower.append(read_number(line[at : at + WIDTH].strip()))
            except ValueError:
                return None  # as SPFIT does; it may be a comment
    own = np.flatnonzero(code >= 0)
    which = next((each for each in (np.arange(len(code)), own) if len(lower) == len(each) * (len(each) + 1) // 2), None)
    if which is None or not lower:
        return None
    factor = np.zeros((len(which), len(which)))
    factor.T[np.tril_indices(len(which))] = lower  # column by column
    matrix = factor @ factor.T
    if np.abs(np.diagonal(matrix) - 1.0).max() > 1e-3:
        raise FormatError(f"{path}, line {number}: the rows of the correlations' factor must have length 1; got "
                          f"{np.sqrt(np.diagonal(matrix)).max():g}. Early files of polhode were like this; write it "
                          "again, by SPFIT or from the fit.")
    full = np.eye(len(code))
    full[np.ix_(which, which)] = matrix / np.sqrt(np.outer(np.diagonal(matrix), np.diagonal(matrix)))
    return full


def _options(path: Path, number: int, line: str) -> list[float | None]:
    """Return the numbers of a line, None between commas that have nothing between them.

    Raises:
        FormatError: for other words.
    """
    options: list[float | None] = []
    waits = True  # for a number, so that a comma leaves one out
    for word in re.findall(r",|[^\s,]+", line):
        if word == ",":
            if waits:
                options.append(None)
            waits = True
            continue
        try:
            options.append(read_fortran(word))
        except ValueError as error:
            raise FormatError(f"{path}, line {number}: each option {error}; got {shown(word)}.") from None
        waits = False
    return options or [None]


def _constant(path: Path, number: int, line: str, left_out: float) -> tuple[int, float, float, str]:
    """Return code, value, error [MHz] and label of a line.

    Raises:
        FormatError: for others.
    """
    numbers, _, label = line.partition("/")
    words = re.split(r"[\s,]+", numbers.strip())
    try:
        if len(words) < 2 or not re.fullmatch(r"-?\d{1,15}(\.0*)?", words[0], re.ASCII):
            raise ValueError("must begin with a whole code and a value")
        value, error = read_fortran(words[1]), read_fortran(words[2]) if len(words) > 2 else left_out
    except ValueError as problem:
        raise FormatError(f"{path}, line {number}: {problem}; got {shown(line.strip())}. A constant is a code, a "
                          "value and an error.") from None
    return int(words[0].partition(".")[0]), value, error, label.strip()


def _reduction(letter: str, codes: Integer[Array, "n"]) -> str:
    """Return the reduction that has all operators of a file; where both have, that of the letter."""
    shared = {*AXES, *(code for basis in BASES.values() for code in basis)}
    own = {_bare(code) for code in np.abs(codes).tolist()} - shared
    first = "S" if letter == "S" else "A"
    other = "A" if first == "S" else "S"
    missing = {name: own - {encode(term) for term in TERMS[Reduction[name]].values()} for name in (first, other)}
    return other if missing[first] and not missing[other] else first


def _numbers(options: tuple[float | None, ...]) -> str:
    words = ["" if option is None else f"{option:g}" for option in options]
    return " ".join(words) if all(words) else ",".join(words)  # only commas can leave one out
