"""Molecules from files, read by ASE."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from polhode.errors import FormatError, InvalidInput

Array = Any
ANGSTROM = 1e-10  # m


def read_molecule(path: str | Path) -> tuple[list[str], Array]:
    """Return the chemical symbols and positions (n, 3) [m] of a structure file (.xyz and what else ASE reads).

    Raises:
        InvalidInput: if the file is missing, or ASE is.
        FormatError: if it cannot be read.
    """
    path = Path(path)
    if not path.is_file():
        raise InvalidInput(f"{path}: no such molecule file. Check the path; it counts from the spec's own folder.")
    try:
        import ase.io
    except ImportError:
        why = "reading a molecule needs ASE, which is not installed; `pip install polhode[molecules]`."
        raise InvalidInput(why) from None
    try:
        atoms = ase.io.read(path)
    except Exception as error:  # ASE raises whatever its many readers raise
        why = f"{path}: cannot be read as a molecule ({error}). Is it in the form its ending says?"
        raise FormatError(why) from None
    return atoms.get_chemical_symbols(), atoms.get_positions() * ANGSTROM  # type: ignore[union-attr]
