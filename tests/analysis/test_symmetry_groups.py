"""Relative equilibria up to a group that does not commute: rings and solids of vortices on the sphere."""

import importlib

import jax.numpy as jnp
import numpy as np
import pytest

import polhode as ph
from polhode import algebra as lie
from polhode import analysis
from polhode.analysis import stability, stability_threshold
from polhode.errors import InvalidInput
from polhode.systems import LiePoisson

MOMENTUM = [lambda m, k=k: jnp.sum(m[:, k]) for k in range(3)]
TETRAHEDRON = np.array([[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]]) / np.sqrt(3.0)


def vortices(count):
    """Unit point vortices: H = −(1/4π) Σ ln(2 − 2 x_i·x_j)."""
    i, j = np.triu_indices(count, 1)
    energy = lambda m: -jnp.sum(jnp.log(2.0 - 2.0 * (m @ m.T)[i, j])) / (4.0 * np.pi)  # noqa: E731
    return LiePoisson(lie.Power(lie.SO3(), count), energy, sign=1)


def ring(count, colatitude):
    angles = 2.0 * np.pi * np.arange(count) / count
    flat = np.stack([np.cos(angles), np.sin(angles)], axis=-1) * np.sin(colatitude)
    return np.column_stack([flat, np.full(count, np.cos(colatitude))])


def growth(count, colatitude):
    """The largest λ_m of a ring: Boatto & Cabral, SIAM J. Appl. Math. 64 (2003) 216."""
    m = np.arange(1, count)
    q = m * (count - m)
    square = q * (q - (count - 1) * (1.0 + np.cos(colatitude) ** 2))
    return np.sqrt(np.max(np.maximum(square, 0.0))) / (4.0 * np.pi * np.sin(colatitude) ** 2)


def sparing(*counts):
    return [pytest.param(n, t, marks=[] if n == 4 else [pytest.mark.sweep]) for n, t in counts]


@pytest.mark.long
@pytest.mark.parametrize(("count", "colatitude"), sparing((3, 0.8), (4, 0.9), (5, 0.6), (6, 0.3)))
def test_rings_are_stable_up_to_turns_about_their_momentum(count, colatitude):
    found = stability(vortices(count), ring(count, colatitude), MOMENTUM)
    assert found.verdict == "stable"
    assert found.restriction == "up to the flow of J3"


@pytest.mark.long
@pytest.mark.parametrize(("count", "colatitude"), sparing((4, 1.2), (5, 1.0), (6, 0.9), (7, 0.3)))
def test_rings_beyond_grow_as_boatto_and_cabral_say(count, colatitude):
    found = stability(vortices(count), ring(count, colatitude), MOMENTUM)
    assert found.verdict == "unstable"
    assert found.rate == pytest.approx(growth(count, colatitude), rel=1e-9)


@pytest.mark.long
@pytest.mark.parametrize(("count", "bound"), sparing((4, 1.0 / 3.0), (5, 0.5), (6, 0.8)))
def test_thresholds_of_rings(count, bound):
    system = vortices(count)
    found = stability_threshold(lambda angle: stability(system, ring(count, angle), MOMENTUM), 0.2, 1.4, 1e-6)
    assert np.cos(found.value) ** 2 == pytest.approx(bound, abs=1e-5)
    assert (found.below.verdict, found.above.verdict) == ("stable", "unstable")


@pytest.mark.long
def test_without_momentum_all_turns_are_divided_out():
    found = stability(vortices(4), TETRAHEDRON, MOMENTUM)
    assert (found.verdict, found.restriction) == ("stable", "up to the flows of J1, J2, J3")
    assert stability(vortices(4), ring(4, np.pi / 2), MOMENTUM).rate == pytest.approx(0.5 / np.pi, rel=1e-9)


@pytest.mark.long
@pytest.mark.long
def test_a_tilted_ring_is_the_same():
    turn = np.asarray(ph.rotation.as_matrix(ph.rotation.normalize(np.array([1.0, 0.3, -0.4, 0.2]))))
    found = stability(vortices(4), ring(4, 0.9) @ turn.T, MOMENTUM)
    assert found.verdict == "stable" and found.restriction.startswith("up to the flow of ")
    assert stability(vortices(4), ring(4, 1.2) @ turn.T, MOMENTUM).rate == pytest.approx(growth(4, 1.2), rel=1e-9)


@pytest.mark.long
def test_with_the_whole_group_divided_out_a_ring_would_be_judged_wrongly(monkeypatch):
    module = importlib.import_module("polhode.analysis.stability")  # the package has the function by that name
    monkeypatch.setattr(module, "_of_isotropy", lambda p, weights: (p, weights))
    try:
        found = stability(vortices(4), ring(4, 1.2), MOMENTUM)
    except InvalidInput:
        return
    assert found.rate != pytest.approx(growth(4, 1.2), rel=1e-3)


def test_a_part_of_a_group_is_refused():
    with pytest.raises(InvalidInput, match=r"\{J1, J2\} must vanish or be a sum"):
        stability(vortices(4), ring(4, 0.9), MOMENTUM[:2])


@pytest.mark.parametrize(
    ("low", "high", "tolerance", "said"),
    [(1.0, 2.0, 1e-9, "must differ"), (6.0, 1.0, 1e-9, "number above 6"), (1.0, np.inf, 1e-9, "finite"),
     (1.0, 6.0, 0.0, "tolerance")],
)  # fmt: skip
def test_thresholds_that_are_none(low, high, tolerance, said):
    top = ph.systems.HeavyTop((1.0, 1.0, 0.5), 1.0)
    with pytest.raises(InvalidInput, match=said):
        analysis.stability_threshold(lambda spin: stability(top, top.upright(spin)), low, high, tolerance)
