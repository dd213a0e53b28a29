"""Spins: commutators, coherent states, evolution."""

import math
from fractions import Fraction

import numpy as np
import pytest
from scipy.linalg import expm

from polhode.errors import InvalidInput
from polhode.spectra import coherent_state, evolve, orbit_radius, spin_matrices

SPINS = [0.5, 1, 2.5, 20]
DIRECTIONS = np.array([[0.3, -0.5, 0.8], [0.0, 0.0, 1.0], [0.0, 0.0, -2.0], [1e-9, 0.0, -1.0], [1.0, 0.0, 0.0]])


def expectation(operator, state):
    return (state.conj() @ operator @ state).real


@pytest.mark.parametrize("s", [0, *SPINS])
def test_commutators_and_casimir(s):
    x, y, z = spin_matrices(s)
    for a, b, c in ((x, y, z), (y, z, x), (z, x, y)):
        assert np.abs(a @ b - b @ a - 1j * c).max() <= 1e-13 * max(s, 1)
    total = x @ x + y @ y + z @ z
    assert np.abs(total - s * (s + 1) * np.eye(len(x))).max() <= 1e-13 * max(s * s, 1)


@pytest.mark.parametrize("s", SPINS)
def test_coherent_states_point_where_they_are_told(s):
    S = spin_matrices(s)
    for direction in DIRECTIONS:
        n, state = direction / np.linalg.norm(direction), coherent_state(s, direction)
        assert np.array([expectation(one, state) for one in S]) == pytest.approx(s * n, abs=1e-13 * s)
        assert expectation(S[2] @ S[2], state) == pytest.approx(s * (s - 0.5) * n[2] ** 2 + s / 2.0, abs=1e-12 * s * s)


def test_overlaps_of_coherent_states():
    s, states = 7.5, coherent_state(7.5, DIRECTIONS)
    n = DIRECTIONS / np.linalg.norm(DIRECTIONS, axis=1, keepdims=True)
    assert np.abs(states.conj() @ states.T) ** 2 == pytest.approx(((1.0 + n @ n.T) / 2.0) ** (2 * s), abs=1e-13)


def test_a_coherent_state_is_the_turned_highest_one():
    """e^{−iφS_z} e^{−iθS_y}, by SciPy's exponential of matrices."""
    s, theta, phi = 3.5, 1.1, -2.3
    _, y, z = spin_matrices(s)
    rotated = expm(-1j * phi * z) @ expm(-1j * theta * y)[:, 0]
    direction = (np.sin(theta) * np.cos(phi), np.sin(theta) * np.sin(phi), np.cos(theta))
    assert np.abs(coherent_state(s, direction) - rotated).max() < 1e-14


def test_large_spins_are_normalised():
    assert np.linalg.norm(coherent_state(1000, (0.3, -0.5, 0.8))) == pytest.approx(1.0, abs=1e-12)


def test_evolution_in_a_field_is_precession_to_the_right():
    s, S = 2.5, spin_matrices(2.5)
    field, start = np.array([0.2, -0.4, 0.9]), np.array([1.0, 0.0, 0.0])
    states = evolve(np.einsum("k,kij", field, S), coherent_state(s, start), np.array([0.0, 1.3, 1000.0]))
    axis = field / np.linalg.norm(field)
    for state, time in zip(states, (0.0, 1.3, 1000.0), strict=True):
        angle = time * np.linalg.norm(field)
        n = start * np.cos(angle) + np.cross(axis, start) * np.sin(angle) + axis * (axis @ start) * (1 - np.cos(angle))
        assert np.array([expectation(one, state) for one in S]) == pytest.approx(s * n, abs=1e-11)
    backwards = evolve(-np.einsum("k,kij", field, S), coherent_state(s, start), np.array([1.3]))[0]
    assert abs(expectation(S[1], backwards) - expectation(S[1], states[1])) > 0.1


def test_radii_of_orbits():
    assert [orbit_radius(2, c) for c in ("prequantum", "casimir", "count")] == [2.0, 6.0**0.5, 2.5]


@pytest.mark.parametrize(
    "call",
    [lambda: spin_matrices(0.3), lambda: spin_matrices(-1), lambda: spin_matrices(1e5),
     lambda: coherent_state(1, (0.0, 0.0, 0.0)), lambda: coherent_state(1, (0.0, np.nan, 0.0)),
     lambda: evolve(np.array([[0, 1], [2, 0]]), np.ones(2), np.ones(1)), lambda: orbit_radius(1, "mean")],
)  # fmt: skip
def test_what_is_refused(call):
    with pytest.raises(InvalidInput):
        call()


@pytest.mark.parametrize("share", [Fraction(0), Fraction(1, 3), Fraction(1, 2), Fraction(3, 4), Fraction(1)])
def test_numbers_of_a_coherent_state_are_the_binomial_distribution(share):
    """Against whole numbers, at a spin whose powers leave doubles; n = (sin θ, 0, cos θ), cos²(θ/2) = share."""
    count = 3000
    cosine = float(2 * share - 1)
    found = np.abs(coherent_state(count / 2, (math.sqrt(1.0 - cosine**2), 0.0, cosine))) ** 2
    for up in (0, 1, 999, 1000, 1500, 1501, 2250, 2999, 3000):
        exact = math.comb(count, up) * share**up * (1 - share) ** (count - up)
        # roundings of cos θ grow by the number, and there are as many products
        assert found[count - up] == pytest.approx(float(exact), rel=2e-12, abs=1e-300)
    assert found.sum() == pytest.approx(1.0, abs=1e-14)
