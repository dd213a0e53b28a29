"""Reading molecules: units, isotopes, and files that are none."""

import io
import sys

import ase
import ase.io
import numpy as np
import pytest

import polhode as ph
from polhode.bodies.atoms import ATOMIC_MASS_UNIT
from polhode.errors import FormatError, InvalidInput
from polhode.formats.molecule import FORMS, read_molecule

PLAIN = "3\nwater\nO 0 0 0\nH 0.757 0.586 0\nH -0.757 0.586 0\n"
ISOTOPES = "2\nProperties=species:S:1:pos:R:3:masses:R:1\nH 0 0 0 2.014\nH 0 0 0.74 1.008\n"
CRYSTAL = '2\nLattice="5 0 0 0 5 0 0 0 5" Properties=species:S:1:pos:R:3 pbc="T T T"\nH 0 0 0\nH 0 0 1\n'


def written(folder, text, name="molecule.xyz"):
    path = folder / name
    path.write_text(text)
    return path


@pytest.mark.parametrize("name", ["water.xyz", "water@2.xyz"])
def test_positions_come_in_metres(tmp_path, name):
    symbols, positions, masses = read_molecule(written(tmp_path, PLAIN, name))
    assert symbols == ["O", "H", "H"]
    assert positions == pytest.approx(1e-10 * np.array([[0, 0, 0], [0.757, 0.586, 0], [-0.757, 0.586, 0]]), abs=1e-25)
    assert masses is None


def test_masses_of_isotopes_are_kept(tmp_path):
    path = written(tmp_path, ISOTOPES)
    assert read_molecule(path)[2] == pytest.approx(np.array([2.014, 1.008]) * ATOMIC_MASS_UNIT, rel=1e-14, abs=0.0)
    assert ph.Body.from_atoms(*read_molecule(path)).mass == pytest.approx(3.022 * ATOMIC_MASS_UNIT, rel=1e-14, abs=0.0)


@pytest.mark.parametrize("name", ["a.xyz", "a.extxyz", "a.pdb", "a.sdf"])
def test_several_structures_are_refused(tmp_path, name):
    """Of an xyz or pdb file the last was taken, of an sdf file the first, and nothing said so."""
    water = ase.Atoms("OHH", [[0, 0, 0.1], [0, 0.7, -0.4], [0, -0.7, -0.4]])
    form, one = FORMS[name.partition(".")[2]], io.StringIO()
    ase.io.write(one, water, format=form)
    path = written(tmp_path, one.getvalue(), name)
    assert read_molecule(path)[0] == ["O", "H", "H"]
    text = one.getvalue() * 2
    if name.endswith("pdb"):
        text = text.replace("MODEL     1", "MODEL     2").replace("MODEL     2", "MODEL     1", 1)
    with pytest.raises(FormatError, match=r"holds 2 structures, and a body is one\. Save the one"):
        read_molecule(written(tmp_path, text, name))


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("hello\n", "cannot be read as a molecule"),
        ("", "cannot be read as a molecule"),
        ("3\n\nO 0 0 0\n", "cannot be read as a molecule"),
        ("0\n\n", "holds no atoms"),
        ("2\n\nD 0 0 0\nH 0 0 1\n", "'D' is not a chemical element. D is hydrogen"),
        (CRYSTAL, "periodic"),
    ],
)
def test_files_that_are_no_molecules(tmp_path, text, words):
    with pytest.raises(FormatError, match=rf"(?s)molecule\.xyz.*{words}"):
        read_molecule(written(tmp_path, text))


def test_missing_file(tmp_path):
    with pytest.raises(InvalidInput, match="no such molecule file"):
        read_molecule(tmp_path / "none.xyz")


def test_plain_xyz_and_masses_need_no_ase_and_are_as_with_it(tmp_path, monkeypatch):
    from ase.data import atomic_masses, chemical_symbols

    symbols, positions, _ = read_molecule(written(tmp_path, PLAIN))
    read = ase.io.read(io.StringIO(PLAIN), format="extxyz")
    assert symbols == read.get_chemical_symbols() and np.array_equal(positions, 1e-10 * read.get_positions())
    for name in ("ase", "ase.io", "ase.data"):
        monkeypatch.setitem(sys.modules, name, None)
    lower = written(tmp_path, PLAIN.replace("O 0", "o 0").replace("0.586 0", "0.586 0 0.41 charge"))
    body = ph.Body.from_atoms(*read_molecule(lower))
    assert body.mass == pytest.approx((15.999 + 2 * 1.008) * ATOMIC_MASS_UNIT, rel=1e-14, abs=0.0)
    for symbol, weight in list(zip(chemical_symbols, atomic_masses, strict=True))[1:]:
        two = ph.Body.from_atoms([symbol, symbol], [(0.0, 0.0, 0.0), (0.0, 0.0, 1e-10)])
        assert two.mass == 2.0 * (weight * ATOMIC_MASS_UNIT)
    with pytest.raises(FormatError, match=r"line 4: .*a symbol and three numbers in ångström; got 'H 0\.757 0\.586'"):
        read_molecule(written(tmp_path, PLAIN.replace("H 0.757 0.586 0", "H 0.757 0.586")))


def test_without_ase_the_remedy_is_said(tmp_path, monkeypatch):
    path = written(tmp_path, ISOTOPES)
    monkeypatch.setitem(sys.modules, "ase.io", None)
    remedy = r'Run `.* -m pip install "(polhode\[molecules\]|ase>=3)'
    with pytest.raises(InvalidInput, match=rf"which is not installed\. {remedy}"):
        read_molecule(path)
