"""Rotations in planes of four and five dimensions: closed forms, published numbers, the general verdict."""

import jax
import jax.numpy as jnp
import numpy as np
import pytest

from polhode.analysis import plane_rotation_exponents, stability, stability_threshold
from polhode.errors import InvalidInput
from polhode.systems import Manakov
from sweeping import first

MASSES = np.array([1.0, 2.0, 3.0, 4.0])
BODY = Manakov(MASSES)


def rotations(size, **planes):
    """Return M with the entries of planes called by axes from 1, as p14=1.0."""
    M = np.zeros((size, size))
    for name, value in planes.items():
        i, j = (int(c) - 1 for c in name[1:])
        M[i, j], M[j, i] = value, -value
    return M


def growth(found):
    return max(float(x.real.max()) for x in found.values())


@pytest.mark.parametrize(
    ("plane", "wanted"),
    [("p12", 0.0), ("p34", 0.0), ("p23", 0.0), ("p13", 0.0645497224), ("p14", 1.0 / 15.0), ("p24", 0.0281718085)],
)
def test_growth_in_each_plane(plane, wanted):
    assert abs(growth(plane_rotation_exponents(BODY, rotations(4, **{plane: 1.0}))) - wanted) < 1e-10


def test_closed_form_of_one_plane():
    found = plane_rotation_exponents(BODY, rotations(4, p13=0.7))
    for k in (1, 3):
        square = (0.7**2 * (MASSES[k] - 1.0) * (3.0 - MASSES[k]) / (16.0 * (1.0 + MASSES[k]) * (3.0 + MASSES[k])))
        np.testing.assert_allclose(np.sort_complex(found[0, 2, k] ** 2), [square, square], atol=1e-15)


@pytest.mark.sweep
@pytest.mark.parametrize(("size", "planes"), first(1, [(4, {"p14": 1.0, "p23": 0.4}), (5, {"p15": 1.0, "p24": -0.8})]))
def test_all_exponents_are_those_of_the_linearised_motion(size, planes):
    body = Manakov(np.linspace(1.0, 4.0, size) ** 1.2)
    M = rotations(size, **planes)
    upper = np.triu_indices(size, 1)

    def field(x):
        matrix = jnp.zeros((size, size)).at[upper].set(x)
        return body.vector_field(0.0, matrix - matrix.T)[upper]

    whole = np.linalg.eigvals(np.asarray(jax.jacobian(field)(jnp.asarray(M[upper]))))
    own = np.concatenate(list(plane_rotation_exponents(body, M).values()))
    assert len(own) + len(planes) == len(whole)  # the planes' own entries are at rest
    for value in own:
        assert np.abs(whole - value).min() < 1e-8


@pytest.mark.long_cases("0.96-stable")
@pytest.mark.parametrize(("ratio", "verdict"), [(0.96, "stable"), (0.95, "unstable")])
def test_a_rotation_in_the_inner_plane_holds_the_outer(ratio, verdict):
    M = rotations(4, p14=1.0, p23=ratio)
    assert stability(BODY, M).verdict == verdict
    assert (growth(plane_rotation_exponents(BODY, M)) > 1e-6) == (verdict == "unstable")


@pytest.mark.sweep
def test_proved_threshold_of_the_double_rotation():
    found = stability_threshold(lambda q: stability(BODY, rotations(4, p14=1.0, p23=q)), 0.9, 1.0, 1e-8)
    assert abs(found.value - 0.95870231) < 1e-7
    assert (found.below.verdict, found.above.verdict) == ("unstable", "stable")


def test_bad_input():
    with pytest.raises(InvalidInput, match="disjoint"):
        plane_rotation_exponents(BODY, rotations(4, p12=1.0, p13=1.0))
    with pytest.raises(InvalidInput, match="antisymmetric"):
        plane_rotation_exponents(BODY, np.ones((4, 4)))
