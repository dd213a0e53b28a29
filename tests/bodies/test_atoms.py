"""Molecules against the textbook's formula for a bent triatomic and published constants."""


import mpmath
import numpy as np
import pytest

import polhode as ph
from polhode.bodies.atoms import ATOMIC_MASS_UNIT
from polhode.errors import InvalidInput

EXACT = 1e-14
"""A few roundings on sums of some terms, relative."""
PLANCK = 6.62607015e-34  # J s, exact by definition of the SI
BOND, ANGLE = 0.9572e-10, np.deg2rad(104.52)  # water at equilibrium: Benedict, Gailar & Plyler 1956
GROUND_STATE = (835.840, 435.352, 278.139)  # GHz, rotational constants A0, B0, C0 of H2(16)O
VIBRATION = 0.04
"""Relative distance of the constants of an equilibrium geometry from those of the vibrating ground state."""


def water(**options):
    half = 0.5 * ANGLE
    x, y = BOND * np.sin(half), BOND * np.cos(half)
    return ph.Body.from_atoms(["O", "H", "H"], [[0, 0, 0], [x, y, 0], [-x, y, 0]], **options)


def bent_triatomic(middle, end, bond, angle):
    """Return the moments of Y–X–Y: about the symmetry axis, about the in-plane one across it, and their sum."""
    with mpmath.workdps(40):
        half = mpmath.mpf(float(angle)) / 2
        along = 2 * end * (bond * mpmath.sin(half)) ** 2
        across = 2 * end * middle / (2 * end + middle) * (bond * mpmath.cos(half)) ** 2
        return sorted(float(x) for x in (along, across, along + across))


def test_water_against_the_formula_of_a_bent_triatomic():
    masses = np.array([15.99491461957, 1.00782503223, 1.00782503223]) * ATOMIC_MASS_UNIT
    body = water(masses=masses)
    assert body.principal_moments == pytest.approx(
        bent_triatomic(mpmath.mpf(masses[0]), mpmath.mpf(masses[1]), mpmath.mpf(BOND), ANGLE), rel=EXACT, abs=0.0
    )


def test_water_turns_as_published():
    constants = PLANCK / (8 * np.pi**2 * water().principal_moments) / 1e9
    assert constants == pytest.approx(GROUND_STATE, rel=VIBRATION)
    heavy = (
        PLANCK / (8 * np.pi**2 * water(masses=np.array([16.0, 2.0, 2.0]) * ATOMIC_MASS_UNIT).principal_moments) / 1e9
    )
    assert (np.abs(heavy / GROUND_STATE - 1) > VIBRATION).all()


def test_masses_are_the_standard_weights():
    assert water().mass == pytest.approx((15.999 + 2 * 1.008) * 1.66053906892e-27, rel=1e-6)


def test_the_axes_of_water_lie_in_its_symmetry():
    axes = np.abs(water().principal_axes)
    assert axes.tolist() == [[1, 0, 0], [0, 1, 0], [0, 0, 1]]


@pytest.mark.parametrize(
    ("make", "words"),
    [
        (lambda: ph.Body.from_atoms(["Xx"], [[0.0, 0, 0]]), "chemical elements; got 'Xx'"),
        (lambda: ph.Body.from_atoms(["X"], [[0.0, 0, 0]]), "chemical elements; got 'X'"),
        (lambda: ph.Body.from_atoms([1, 8], [[0.0, 0, 0], [1.0, 0, 0]]), "chemical elements"),
        (lambda: ph.Body.from_atoms(["H", "H"], [[0.0, 0, 0]]), "match"),
        (lambda: ph.Body.from_atoms(["H", "H"], [[0.0, 0, 0], [np.nan, 0, 0]]), "finite"),
        (lambda: ph.Body.from_atoms(["H"], [[0.0, 0, 0]]), "coincide"),
    ],
)
@pytest.mark.usefixtures("any_type")
def test_bad_input(make, words):
    with pytest.raises(InvalidInput, match=words):
        make()
