"""The format ``par``: constants of molecules, as SPFIT reads them."""

from __future__ import annotations

from pathlib import Path

from polhode.formats.form import Content, Form


def write(content: Content, path: Path) -> Path:
    """Write a molecule's constants."""
    from polhode.spectra.formats.spfit_constants import constant_table, write_par
    from polhode.spectra.spec_rotors import molecule_to_write

    write_par(constant_table(molecule_to_write(content).rotor, title=content.name), path)
    return path


FORM = Form("par", "constants file", ".par", "rotational constants of a molecule; every digit", write, of_motion=False,
            sampled=False)
