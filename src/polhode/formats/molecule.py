"""Molecules from files: plain xyz directly, other formats by ASE after a check of their text."""

from __future__ import annotations

import io
import re
import warnings
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from polhode._base.extras import needing
from polhode.bodies.atoms import ANGSTROM, ATOMIC_MASS_UNIT, explain_symbol, is_element
from polhode.errors import FormatError, shown
from polhode.formats.numerals import is_misread
from polhode.formats.opening import MB, read_text
from polhode.formats.paths import as_path
from polhode.types import Array, Float64

FORMS = {"xyz": "extxyz", "extxyz": "extxyz", "pdb": "proteindatabank", "mol": "mol", "sdf": "sdf"}
"""ASE's names of the formats, by ending. ASE guesses among a hundred otherwise, some of which unpack or open others."""
_EXTENDED = re.compile(r"(Properties|Lattice|pbc)\s*=", re.IGNORECASE)
"""What the comment of an extended xyz holds; in a plain one each atom is a symbol and three numbers, in ångström."""
EXTENDED = "Properties=species:S:1:pos:R:3:masses:R:1"
_COLUMNS = re.compile(r"Properties\S*:\d{3}", re.IGNORECASE | re.ASCII)
LARGEST_FILE = 64 * MB  # a million atoms


class MoleculeLimits(NamedTuple):
    """A number beyond which the file of a molecule is refused."""

    max_extent: float = 1.0  # m, more than any molecule


LIMITS = MoleculeLimits()


def read_molecule(path: str | Path) -> tuple[list[str], Float64[Array, "n 3"], Float64[Array, "n"] | None]:
    """Return symbols, positions (n, 3) [m] and masses (n,) [kg] of a structure file, by its ending (see ``FORMS``).

    Masses are None unless the file gives them, as an extended xyz with a ``masses`` column does for isotopes. The three
    are the arguments of ``Body.from_atoms``.

    Raises:
        InvalidInput: if the file is missing, or ASE is, which all but plain .xyz needs.
        FormatError: if it cannot be read, holds no atoms or several structures, or is a periodic crystal.
    """
    path = as_path("path", path)
    form = FORMS.get(path.suffix.lower().lstrip("."))
    text = read_text(path, "molecule", LARGEST_FILE)
    if form is None:
        known = ", ".join(FORMS)
        why = f"a molecule file must end in one of {known}; got {shown(path.suffix)}"
        raise FormatError(f"{path}: {why}. Save it as .xyz.")
    if form == "extxyz":
        check_frame(path, text)
    elif (count := _structures(text, form)) > 1:
        raise FormatError(_several(path, count))
    _check_words(path, text, form)
    plain = path.suffix.lower() == ".xyz" and not _is_extended(text)
    symbols, positions, masses, periodic = _read_plain(path, text) if plain else _read_by_ase(path, text, form)
    if not symbols:
        raise FormatError(f"{path}: holds no atoms.")
    if periodic:
        raise FormatError(f"{path}: is periodic; its cell may cut the molecule apart. Save it without a cell.")
    if not (np.abs(positions) <= LIMITS.max_extent).all():
        k = int(np.argwhere(~(np.abs(positions) <= LIMITS.max_extent))[0, 0])
        raise FormatError(f"{path}: atom {k + 1} is not at a place within {LIMITS.max_extent:g} m. Check the file.")
    return symbols, positions, masses


def _is_extended(text: str) -> bool:
    lines = text.splitlines()
    return bool(_EXTENDED.search(lines[1])) or any(line.startswith("VEC") for line in lines)


def _read_plain(path: Path, text: str) -> tuple[list[str], Array, None, bool]:
    """Return symbols and positions (n, 3) [m], no masses, and that it is not periodic."""
    count, _, *lines = text.splitlines()
    symbols, positions = [], []
    for number, line in enumerate(lines[: int(count)], 3):
        symbol, *words = line.split() or [""]
        try:
            place = [float(word) for word in words[:3]]
        except ValueError:
            place = []
        if len(place) < 3:
            why = "cannot be read as a molecule: an atom is a symbol and three numbers in ångström"
            raise FormatError(f"{path}, line {number}: {why}; got {shown(line.strip())}.")
        if not is_element(symbol.capitalize()):
            raise FormatError(_not_an_element(path, shown(symbol)))
        symbols.append(symbol.capitalize())
        positions.append(place)
    return symbols, np.reshape(positions, (-1, 3)) * ANGSTROM, None, False


def _read_by_ase(path: Path, text: str, form: str) -> tuple[list[str], Array, Array | None, bool]:
    """Return symbols, positions (n, 3) [m], masses (n,) [kg] or None, and whether it is periodic."""
    otherwise = "Or save it as plain .xyz: a symbol and three numbers in ångström for each atom."
    with needing(f"molecule files like {path.name} need", otherwise):
        import ase.io
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            atoms: Any = ase.io.read(io.StringIO(text), format=form)
        masses = atoms.get_masses() * ATOMIC_MASS_UNIT if atoms.has("masses") else None
        return atoms.get_chemical_symbols(), atoms.get_positions() * ANGSTROM, masses, bool(atoms.pbc.any())
    except KeyError as error:
        raise FormatError(_not_an_element(path, str(error))) from None
    except Exception:  # ASE raises whatever its many readers raise
        why = f"{path}: cannot be read as a molecule: it is broken, cut short, or not what its ending says."
        raise FormatError(why) from None


def _not_an_element(path: Path, symbol: str) -> str:
    said = explain_symbol(symbol) or "Write symbols like C, and leave out what is no atom. "
    masses = f"Masses are a column of an extended xyz, in u, which its second line names: {EXTENDED}."
    return f"{path}: {symbol} is not a chemical element. {said}{masses if 'mass' in said else ''}".rstrip()


def check_frame(path: Path, text: str) -> None:
    """Refuse an xyz file that is not one structure with as many lines as it says.

    Raises:
        FormatError: naming the line, if a structure has fewer atoms than it says, or claims more columns than a line
            holds; and for several structures, of which only the user knows the right one.
    """
    lines, begin, count = text.splitlines(), 0, 0
    while begin < len(lines):
        said = lines[begin].strip()
        if not said and count:
            break  # blank lines at the end
        if not (said.isascii() and said.isdigit() and len(said) < 20):
            why = f"cannot be read as a molecule: must be the number of atoms; got {shown(lines[begin])}"
            raise FormatError(f"{path}, line {begin + 1}: {why}.")
        if begin + 2 + int(said) > len(lines):
            held = max(0, len(lines) - begin - 2)
            why = f"cannot be read as a molecule (frame has {held} atoms, expected {int(said)}): it is cut short"
            raise FormatError(f"{path}, line {begin + 1}: {why}.")
        if _COLUMNS.search(lines[begin + 1]):
            raise FormatError(f"{path}, line {begin + 2}: names more columns than a line holds.")
        count, begin = count + 1, begin + 2 + int(said)
        while begin < len(lines) and lines[begin].startswith("VEC"):
            begin += 1
    if not count:
        raise FormatError(f"{path}: cannot be read as a molecule: it is empty.")
    if count > 1:
        raise FormatError(_several(path, count))


def _structures(text: str, form: str) -> int:
    """Return the number of structures in a file, by the lines that end or begin one."""
    if form == "proteindatabank":
        return len(re.findall(r"^MODEL\b", text, re.MULTILINE))
    return sum(bool(part.strip()) for part in re.split(r"^\$\$\$\$.*$", text, flags=re.MULTILINE))


def _several(path: Path, count: int) -> str:
    return f"{path}: holds {count} structures, and a body is one. Save the one that is meant in a file of its own."


def _check_words(path: Path, text: str, form: str) -> None:
    """Refuse words that Python takes for numbers and other programs do not; titles and comments are not checked."""
    title_lines = {"extxyz": 2, "mol": 3, "sdf": 3}
    for number, line in enumerate(text.splitlines(), 1):
        of_atoms = form != "proteindatabank" or line.startswith(("ATOM", "HETATM"))
        if number <= title_lines.get(form, 0) or not of_atoms:
            continue
        for word in line.split():
            if is_misread(word):
                why = f"{shown(word)} is not a number that other programs would read"
                raise FormatError(f"{path}: {why}, in the line {shown(line.strip())}.")
