"""Molecules from files, read by ASE."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

from polhode.bodies.atoms import ATOMIC_MASS_UNIT
from polhode.errors import FormatError, InvalidInput
from polhode.formats.opening import MB, check_is_file

Array = Any
ANGSTROM = 1e-10  # m
LARGEST_FILE = 64 * MB  # a million atoms


def read_molecule(path: str | Path) -> tuple[list[str], Array, Array | None]:
    """Return symbols, positions (n, 3) [m] and masses (n,) [kg] of a structure file (.xyz and what else ASE reads).

    Masses are None unless the file gives them, as an extended xyz with a ``masses`` column does for isotopes. Of
    several structures in one file the last is taken, as optimisers write the relaxed one last. The three are the
    arguments of ``from_atoms``.

    Raises:
        InvalidInput: if the file is missing, or ASE is.
        FormatError: if it cannot be read, holds no atoms, or is a periodic crystal.
    """
    path = Path(path)
    check_is_file(path, "molecule", LARGEST_FILE)
    try:
        import ase.io
    except ImportError:
        why = "reading a molecule needs ASE, which is not installed; `pip install polhode[molecules]`."
        raise InvalidInput(why) from None
    try:
        atoms: Any = ase.io.read(path, do_not_split_by_at_sign=True)
        symbols, positions = atoms.get_chemical_symbols(), atoms.get_positions() * ANGSTROM
    except KeyError as error:
        why = f"{path}: {error} is no chemical element. Isotopes go as masses into an extended xyz, not as symbols."
        raise FormatError(why) from None
    except Exception as error:  # ASE raises whatever its many readers raise
        counted = re.search(r"Frame has \d+ atoms, expected \d+", str(error))
        reason = f" ({counted[0][0].lower()}{counted[0][1:]})" if counted else ""
        why = f"{path}: cannot be read as a molecule{reason}: it is broken, cut short, or not what its ending says."
        raise FormatError(why) from None
    if not symbols:
        raise FormatError(f"{path}: holds no atoms.")
    if atoms.pbc.any():
        raise FormatError(f"{path}: is periodic; its cell may cut the molecule apart. Save it without a cell.")
    return symbols, positions, atoms.get_masses() * ATOMIC_MASS_UNIT if atoms.has("masses") else None
