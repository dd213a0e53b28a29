"""Thresholds of systems, orbits, algebras and clocks, each on either side."""

import numpy as np
import pytest

import polhode as ph
from polhode.algebra.casimirs import check_monomials
from polhode.errors import InvalidInput
from polhode.estimation._coarse_clock import is_coarse, spread_evenly
from polhode.poisson.orbits import orbit_dimension


def accepted(call):
    """Whether a call is not refused."""
    try:
        call()
    except InvalidInput:
        return False
    return True


def tilted(angle):
    """Return a top whose centre of mass is off an axis by an angle, and then its momentum by ⅔ of that."""
    return ph.systems.HeavyTop((1.0, 2.0, 3.0), 1.0, (np.sin(angle), 0.0, np.cos(angle)))


def upright(off):
    """Return a top's state whose Γ misses its attitude."""
    return np.array([1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, off, 0.0, 1.0])


def bracket(error):
    """Return so(3)'s structure constants, one with an error."""
    c = np.zeros((3, 3, 3))
    for i, j, k in ((0, 1, 2), (1, 2, 0), (2, 0, 1)):
        c[i, j, k], c[j, i, k] = 1.0, -1.0
    c[0, 1, 2] += error
    return c


def acting(error):
    """Return so(3)'s action on space, one entry with an error."""
    rho = np.cross(np.eye(3)[:, None], np.eye(3)[None]).swapaxes(1, 2)
    rho[0, 2, 1] += error
    return rho


BODY, SO3 = ph.systems.FreeRigidBody((1.0, 2.0, 3.0)), ph.algebra.SO3()
TOP = ph.systems.HeavyTop((1.0, 2.0, 3.0), 1.0)
MANAKOV = ph.systems.Manakov((1.0, 2.0, 3.0))


@pytest.mark.parametrize(("inside", "outside"), [
    (lambda: tilted(1.4e-9).upright(1.0), lambda: tilted(1.6e-9).upright(1.0)),
    (lambda: TOP.check_state(upright(0.9e-6)), lambda: TOP.check_state(upright(1.1e-6))),
    (lambda: BODY.check_state(np.array([1.0 + 0.9e-6, 0, 0, 0, 1, 0, 0])),
     lambda: BODY.check_state(np.array([1.0 + 1.1e-6, 0, 0, 0, 1, 0, 0]))),
    (lambda: MANAKOV.check_state(np.array([[0, 1, 0], [-1 + 1.7e-6, 0, 0], [0, 0, 0]])),
     lambda: MANAKOV.check_state(np.array([[0, 1, 0], [-1 + 2.3e-6, 0, 0], [0, 0, 0]]))),
    (lambda: ph.algebra.from_structure_constants(bracket(0.9e-12)),
     lambda: ph.algebra.from_structure_constants(bracket(1.1e-12))),
    (lambda: ph.algebra.Semidirect(SO3, acting(0.9e-12)), lambda: ph.algebra.Semidirect(SO3, acting(1.1e-12))),
    (lambda: check_monomials(198, 20_000, 3), lambda: check_monomials(199, 20_001, 3)),
])  # fmt: skip
def test_what_is_off_by_more_than_rounding_is_refused(inside, outside):
    assert accepted(inside) and not accepted(outside)


@pytest.mark.long
def test_a_third_integral_holds_on_its_leaf_alone():
    """Goryachev and Chaplygin's, where Π·Γ = 0 up to rounding."""
    top = ph.systems.HeavyTop((4.0, 4.0, 1.0), 1.0, (1.0, 0.0, 0.0))
    for off, known in ((0.9e-12, True), (1.1e-12, False)):
        values = top.invariants(np.array([0.0, 0.0, 1.0, 1.0, 0.0, off]))
        assert np.isfinite(values["Goryachev and Chaplygin's integral"]) == known


@pytest.mark.long
def test_a_small_second_momentum_has_an_orbit_of_its_own():
    both = ph.algebra.Product(SO3, SO3)
    for size, dimension in ((1.1e-10, 4), (0.9e-10, 2)):
        assert orbit_dimension(both, np.array([0.0, 0.0, 1.0, 0.0, 0.0, size])) == dimension


@pytest.mark.parametrize(("repeated", "samples", "coarse"), [(3, 100, True), (2, 100, False), (20, 1000, True),
                                                             (19, 1000, False)])  # fmt: skip
def test_a_clock_is_coarse_from_a_share_of_repeated_times(repeated, samples, coarse):
    assert is_coarse(repeated, samples) == coarse


@pytest.mark.parametrize(("late", "even"), [(0.0, True), (1.5, False)])
def test_times_of_a_coarse_clock_are_even_within_its_step(late, even):
    times = np.floor(np.arange(40) / 2.0)
    times[20:] += late
    assert np.allclose(np.diff(spread_evenly(times)), np.diff(spread_evenly(times))[0], rtol=1e-9) == even
