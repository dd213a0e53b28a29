"""Point masses against rational arithmetic."""

from fractions import Fraction

import numpy as np
import pytest

import polhode as ph
from polhode.errors import InvalidInput

EXACT = 1e-14
"""A few roundings on sums of some terms, relative."""


def exact_inertia(masses, positions):
    """Return mass, centre of mass and inertia about it in rational arithmetic."""
    m = [Fraction(float(x)) for x in masses]
    r = [[Fraction(float(x)) for x in point] for point in positions]
    center = [sum(mk * rk[i] for mk, rk in zip(m, r, strict=True)) / sum(m) for i in range(3)]
    inertia = [[Fraction(0)] * 3 for _ in range(3)]
    for mk, rk in zip(m, r, strict=True):
        d = [rk[i] - center[i] for i in range(3)]
        for i in range(3):
            for j in range(3):
                inertia[i][j] += mk * ((sum(x * x for x in d) if i == j else 0) - d[i] * d[j])
    return float(sum(m)), np.array(center, dtype=float), np.array(inertia, dtype=float)


@pytest.mark.parametrize("far", [0.0, 1e3, 1e8])
def test_against_rational_arithmetic_wherever_they_lie(far):
    rng = np.random.default_rng(3)
    masses, positions = rng.uniform(0.1, 5.0, 9), rng.normal(size=(9, 3)) + far
    mass, center, inertia = exact_inertia(masses, positions)
    body = ph.Body.from_points(masses, positions)
    assert body.mass == pytest.approx(mass, rel=EXACT)
    assert body.center_of_mass == pytest.approx(center, rel=EXACT, abs=EXACT)
    assert np.abs(body.inertia - inertia).max() < EXACT * np.abs(inertia).max()


def test_moments_from_the_origin_would_lose_digits_far_away():
    rng = np.random.default_rng(3)
    masses, positions = rng.uniform(0.1, 5.0, 9), rng.normal(size=(9, 3)) + 1e8
    _, center, inertia = exact_inertia(masses, positions)
    squares = np.einsum("n,ni,nj->ij", masses, positions, positions) - masses.sum() * np.outer(center, center)
    naive = np.trace(squares) * np.eye(3) - squares
    assert np.abs(naive - inertia).max() > 1e-3 * np.abs(inertia).max()


def test_points_are_the_parts_they_are_made_of():
    rng = np.random.default_rng(4)
    masses, positions = rng.uniform(0.1, 5.0, 8), rng.normal(size=(8, 3))
    whole = ph.Body.from_points(masses, positions)
    halves = [ph.Body.from_points(masses[k : k + 4], positions[k : k + 4]) for k in (0, 4)]
    together = ph.combine(halves)
    assert together.inertia == pytest.approx(whole.inertia, abs=EXACT * np.abs(whole.inertia).max())
    assert together.center_of_mass == pytest.approx(whole.center_of_mass, abs=EXACT * 3)


def test_points_on_a_line_are_a_rod_and_in_a_plane_a_flat_body():
    direction = np.array([1.0, 2.0, -3.0])
    line = ph.Body.from_points([1.0, 2.0, 3.0], np.outer([0.0, 0.7, 1.9], direction)).principal_moments
    assert line[0] == 0.0
    assert line[1] == line[2]
    flat = ph.Body.from_points([1.0, 2.0, 3.0], [[0.0, 0, 0], [1, 0.3, 0.2], [0.4, 2, 1]]).principal_moments
    assert flat[0] + flat[1] == pytest.approx(flat[2], rel=EXACT)


@pytest.mark.parametrize(
    ("masses", "positions", "words"),
    [
        ([1.0], [[0.0, 0, 0]], "coincide"),
        ([1.0, 2.0], [[1.0, 2, 3], [1.0, 2, 3]], "coincide"),
        ([1.0, -1.0], [[0.0, 0, 0], [1, 0, 0]], "positive; got -1 kg"),
        ([1.0, 0.0], [[0.0, 0, 0], [1, 0, 0]], "positive"),
        ([1.0, np.nan], [[0.0, 0, 0], [1, 0, 0]], "finite"),
        ([1.0, 1.0], [[0.0, 0, 0], [np.inf, 0, 0]], "finite"),
        ([1.0, 1.0], [[0.0, 0, 0]], "match"),
        ([], np.zeros((0, 3)), "match"),
        ([1.0, "heavy"], [[0.0, 0, 0], [1, 0, 0]], "numbers"),
        ([1.0, 1j], [[0.0, 0, 0], [1, 0, 0]], "real"),
    ],
)
def test_bad_input(masses, positions, words):
    with pytest.raises(InvalidInput, match=words):
        ph.Body.from_points(masses, positions)
