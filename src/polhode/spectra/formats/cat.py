"""The format ``cat``: catalogues of molecular lines, as SPCAT writes them."""

from __future__ import annotations

from pathlib import Path

from polhode.errors import InvalidInput
from polhode.formats.form import Content, Form


def write(content: Content, path: Path) -> Path:
    """Write a molecule's lines."""
    from polhode.spectra.formats.spcat import catalogue_of, write_cat
    from polhode.spectra.spec_rotors import molecule_to_write

    molecule = molecule_to_write(content)
    lines = molecule.lines()
    if lines is None:
        raise InvalidInput("a molecule without a dipole has no lines. Give one, like "
                           'dipole = ["0 D", "1.857 D", "0 D"].')
    write_cat(catalogue_of(lines, degrees=2 if molecule.rotor.is_linear else 3), path)
    return path


FORM = Form("cat", "line catalogue", ".cat", "rotational lines of a molecule; frequencies to 100 Hz", write,
            of_motion=False, sampled=False)
