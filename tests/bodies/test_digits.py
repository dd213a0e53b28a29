"""Molecules as programs print them: straight, symmetric and spherical ones in any orientation, to 3 to 8 decimals."""

import re
from pathlib import Path

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import polhode as ph
from polhode.bodies._digits import last_digit
from polhode.bodies.atoms import isotopic_masses
from polhode.spectra import Rotor
from polhode.spectra._level_polhodes import level_polhodes

ANGSTROM = 1e-10


def line(*places):
    return [(0.0, 0.0, z) for z in places]


def ring(radius, height, count, start=0.0):
    angles = start + 2.0 * np.pi * np.arange(count) / count
    return [(radius * np.cos(x), radius * np.sin(x), height) for x in angles]



TETRAHEDRON = np.array([(1, 1, 1), (1, -1, -1), (-1, 1, -1), (-1, -1, 1)]) / np.sqrt(3.0)
MOLECULES = {
    "HCN": ("linear", line(-1.0655, 0.0, 1.1532)), "OCO": ("linear", line(-1.16, 0.0, 1.16)),
    "OCS": ("linear", line(-1.6797, -0.5217, 1.0391)), "HCCH": ("linear", line(-1.6615, -0.6013, 0.6013, 1.6615)),
    "CO": ("linear", line(0.0, 1.1282)), "HCCCN": ("linear", line(0.0, 1.058, 2.263, 3.641, 4.8)),
    "OCCCO": ("linear", line(-2.437, -1.274, 0.0, 1.274, 2.437)), "HBeH": ("linear", line(-1.3264, 0.0, 1.3264)),
    "HCCCCCCCN": ("linear", line(0.0, 1.06, 2.27, 3.64, 4.86, 6.22, 7.45, 8.81, 9.97)),
    "CHHHH": ("spherical", [(0, 0, 0), *(1.087 * TETRAHEDRON)]),
    "SFFFFFF": ("spherical", [(0, 0, 0), *(1.56 * np.vstack([np.eye(3), -np.eye(3)]))]),
    "CClHHH": ("prolate", [*line(0.0, 1.785), *ring(1.034, -0.336, 3)]),
    "CCHHHHHH": ("prolate", [*line(-0.7645, 0.7645), *ring(1.0164, -1.1604, 3), *ring(1.0164, 1.1604, 3, np.pi / 3)]),
    "NHHH": ("oblate", [(0, 0, 0), *ring(0.94, 0.38, 3)]), "BFFF": ("oblate", [(0, 0, 0), *ring(1.313, 0.0, 3)]),
    "CCCCCCHHHHHH": ("oblate", [*ring(1.397, 0.0, 6), *ring(2.481, 0.0, 6)]),
}


def atoms(name):
    return re.findall("[A-Z][a-z]?", name)


def rotor_of(name, places):
    return Rotor.from_body(ph.Body.from_atoms(atoms(name), places, isotopic_masses(atoms(name))))


def shape_of(rotor):
    A, B, C = rotor.constants
    if rotor.is_linear:
        return "linear"
    if A == C:
        return "spherical"
    return "prolate" if B == C else "oblate" if A == B else "asymmetric"


@pytest.mark.parametrize("name", MOLECULES)
def test_molecules_keep_their_shape_in_any_orientation(name):
    """40 of 45 straight ones were refused, and of 75 symmetric ones none was symmetric."""
    shape, places = MOLECULES[name]
    rng = np.random.default_rng(sum(map(ord, name)))
    exact = rotor_of(name, ANGSTROM * np.array(places, float))
    assert shape_of(exact) == shape
    for decimals in (3, 4, 5, 6, 8):
        for turn in Rotation.random(6, rng=rng):
            turned = np.round(turn.apply(np.array(places, float)), decimals) * ANGSTROM
            found = rotor_of(name, turned)
            assert shape_of(found) == shape, (name, decimals)
            finite = 1 if shape == "linear" else 0
            assert found.constants[finite:] == pytest.approx(exact.constants[finite:], rel=3.0 * 10.0**-decimals)
    assert level_polhodes(found.constants, 3) is None and np.isfinite(found.levels(2).energy).all()


@pytest.mark.parametrize("decimals", [4, 6])
def test_what_is_bent_or_nearly_symmetric_stays_so(decimals):
    """A chain whose last atom is bent by 1°, and HNCO, of B − C = .015 B.

    Of the chain, I3 − I2 = I1 is 3e-6 of I3, which six decimals show and four do not.
    """
    turn = Rotation.from_rotvec([0.3, -0.4, 0.5])
    chain = np.array(line(0.0, 1.058, 2.263, 3.641, 4.8))
    chain[0] = (1.058 * np.sin(np.radians(1.0)), 0.0, 1.058 * (1.0 - np.cos(np.radians(1.0))))
    cyanate = np.array([(-1.61, 0.94, 0.0), (-1.19, 0.02, 0.0), (0.02, 0.0, 0.0), (1.19, 0.0, 0.0)])
    found = rotor_of("HCCCN", np.round(turn.apply(chain), decimals) * ANGSTROM)
    assert shape_of(found) == ("asymmetric" if decimals == 6 else "prolate")
    assert found.constants[0] == pytest.approx(rotor_of("HCCCN", chain * ANGSTROM).constants[0], rel=0.02)
    found = rotor_of("HNCO", np.round(turn.apply(cyanate), decimals) * ANGSTROM)
    assert shape_of(found) == "asymmetric"
    assert found.constants[2] / found.constants[1] < 0.99


def test_the_last_digit_is_that_of_all_positions():
    assert last_digit(ANGSTROM * np.array([[1.0, 0.5, 0.0], [0.0, 0.0, -2.12345]]), ANGSTROM) == pytest.approx(1e-15)
    assert last_digit(ANGSTROM * np.array([[1.0, 0.5, 0.0]]), ANGSTROM) == pytest.approx(1e-13)
    assert last_digit(ANGSTROM * np.random.default_rng(0).normal(size=(4, 3)), ANGSTROM) == 0.0
    turned = Rotation.from_rotvec([0.3, -0.4, 0.5]).apply(ANGSTROM * np.array(MOLECULES["NHHH"][1]))
    assert shape_of(rotor_of("NHHH", turned)) == "oblate"  # all digits: to rounding


def test_a_thin_body_of_two_moments_is_a_line_whatever_rounding_leaves():
    """I1 + I2 ≥ I3 was asked of moments one of which had just been rounded to zero: got (0, 1.8853e-46, 1.8853e-46)."""
    rng = np.random.default_rng(3)
    for turn in Rotation.random(200, rng=rng).as_matrix():
        body = ph.Body.from_points(rng.uniform(1.0, 9.0, 5), np.outer(rng.normal(size=5), turn[0]))
        assert body.principal_moments[0] == 0.0 and body.principal_moments[1] == body.principal_moments[2]
    thin = Rotor.from_body(ph.Body.from_moments((1e-56, 1e-46, 1.0000000001e-46)))
    assert thin.is_linear and thin.constants[1] == thin.constants[2]


def test_a_straight_molecule_of_a_file_is_linear(tmp_path: Path):
    """One atom is a millionth of an ångström beside the line."""
    (tmp_path / "ocs.xyz").write_text("3\nocs\nO 0 1e-6 -1.6797\nC 0 0 -0.5217\nS 0 0 1.0391\n")
    symbols, positions, _ = ph.formats.read_molecule(tmp_path / "ocs.xyz")
    rotor = Rotor.from_body(ph.Body.from_atoms(symbols, positions, isotopic_masses(symbols)))
    assert rotor.is_linear and rotor.constants[1] == pytest.approx(6.0951e9, rel=1e-4)
