"""Verdicts at regular, singular and nearly singular points of algebras of every kind, against spectra and motions."""

from collections import Counter
from dataclasses import replace

import jax.numpy as jnp
import numpy as np
import pytest

import polhode as ph
from analysis.random_systems import CONFINED, departures, judge, judge_motion
from analysis.settled_systems import PLACES, SETTLED, settled_specimen
from polhode.algebra import SE2, SO3, AffineLine, Heisenberg, from_structure_constants
from polhode.analysis import _exact_functions as exact_functions
from polhode.analysis._reasons import LeafIsPoint

SWEEP = 24  # systems of each place: 1,008 on all algebras
OFF = 1e-5  # of the point's distance from singular ones, at which neighbours start
SURE = 1e-4  # of the largest exponent, a growth that spectra show beyond doubt
SLOW = 1e-12  # exponents below it are rounding errors of zero


def false_verdicts(name, seeds, places=PLACES):
    """Return how often each verdict is reached at each place, and what is false about them."""
    algebra, constants, _ = SETTLED[name]
    assert np.asarray(algebra.structure_constants()) == pytest.approx(constants, abs=1e-14)
    drawn = [(place, *settled_specimen(name, seed, place)) for place in places for seed in seeds]
    found = [ph.stability(specimen.system, specimen.point) for _, specimen, _, _ in drawn]
    rates = np.array([np.abs(np.linalg.eigvals(specimen.jacobian(x))).max() for _, specimen, x, _ in drawn])
    wrong = []
    for (_, specimen, x, _), verdict, rate in zip(drawn, found, rates, strict=True):
        if rate > SLOW:
            wrong.append(judge(verdict, specimen, x))
        if verdict.growth == "exponential" and verdict.rate > SURE * rate:
            seen = judge(replace(verdict, verdict="stable"), specimen, x)
            wrong.append(None if seen else "an unstable equilibrium called stable passes")
    points = np.array([x for _, _, x, _ in drawn])
    distances = np.array([distance or 1.0 for *_, distance in drawn])
    sizes = np.linalg.norm(points, axis=1)
    ways = np.random.default_rng(0).normal(size=points.shape)
    # of those that leave, the neighbours that are said to
    ways = np.array([w if v.direction is None else v.direction for w, v in zip(ways, found, strict=True)])
    starts = OFF * distances * np.where(sizes > 0.0, sizes, 1.0) / np.linalg.norm(ways, axis=1)
    rates = np.where(rates > SLOW, rates, 1.0)
    moved = departures([s for _, s, _, _ in drawn], points, points + starts[:, None] * ways, rates)
    for verdict, motion, rate, distance in zip(found, moved.T, rates, distances, strict=True):
        # near a singular point curvatures across leaves and along them are as far apart as that is near
        wrong.append(judge_motion(verdict, motion, rate, OFF, CONFINED / np.sqrt(distance)))
    counts = Counter((place, verdict.verdict) for (place, *_), verdict in zip(drawn, found, strict=True))
    return counts, [text for text in wrong if text]


@pytest.mark.long
def test_a_few_where_nothing_moves_on_the_leaf():
    """Each of these ended in "cannot reshape array of size 0 into shape (0)"."""
    counts, wrong = false_verdicts("Heisenberg", range(1, 4))
    assert wrong == [] and counts["singular", "undecided"] and counts["regular", "stable"]


@pytest.mark.sweep
@pytest.mark.parametrize("name", SETTLED)
def test_many_points_of_every_kind(name):
    counts, wrong = false_verdicts(name, range(SWEEP))
    assert wrong == []
    assert counts["regular", "stable"] and counts["regular", "unstable"]
    # at singular points of groups that are not compact the Casimirs' levels say little
    assert sum(n for (place, verdict), n in counts.items() if verdict == "undecided") < 0.6 * 3 * SWEEP


@pytest.mark.long
def test_a_leaf_of_one_point_says_so(monkeypatch):
    """Lyapunov's stability is proved on the leaf, and for all neighbours where the group is compact."""
    weights = jnp.arange(1.0, 4.0)
    energy = lambda m: 0.5 * jnp.sum(weights * m**2)  # noqa: E731
    found = ph.stability(ph.systems.LiePoisson(Heisenberg(1), energy), [1.0, 1.0, 0.0])
    assert found.verdict == "undecided" and isinstance(found.reason, LeafIsPoint)
    assert "leaves nearby are larger" in found.certificate and "not held by it" in found.words
    # |P|² is zero at this point alone of its level of the energy: neighbours cannot leave, as motions show
    system = ph.systems.LiePoisson(SE2(), energy)
    assert ph.stability(system, [1.0, 0.0, 0.0]).verdict == "stable"
    run = ph.simulate(system, [1.0, 1e-3, 0.0], np.linspace(0.0, 50.0, 101))
    assert np.abs(run.states - [1.0, 0.0, 0.0]).max() < 2e-3
    # L turns about dH with |L| kept
    found = ph.stability(ph.systems.LiePoisson(SO3(), lambda m: m @ weights), np.zeros(3))
    assert found.verdict == "stable" and "second variation of |L|² is positive definite" in found.certificate
    by_doubles = exact_functions.LIMITS._replace(max_coordinates=0)  # by doubles the leaf alone decides
    monkeypatch.setattr(exact_functions, "LIMITS", by_doubles)
    found = ph.stability(ph.systems.LiePoisson(SO3(), lambda m: m @ weights), np.zeros(3))
    assert found.verdict == "stable" and "the group is compact" in found.certificate
    constants = np.zeros((2, 2, 2))
    constants[0, 1, 1], constants[1, 0, 1] = 1.0, -1.0
    for algebra in (AffineLine(), from_structure_constants(constants)):
        found = ph.stability(ph.systems.LiePoisson(algebra, lambda m: 0.5 * jnp.sum(m**2)), np.zeros(2))
        assert found.verdict == "stable" and found.words == "the energy is at its least: neighbours cannot leave"


def test_a_neighbour_of_such_a_point_may_leave():
    """H = (q² + p²)/2 on Heisenberg's dual: beside (1, 1, 0) those with γ go round the whole circle, in a time 2π/γ."""
    system = ph.systems.LiePoisson(Heisenberg(1), lambda m: 0.5 * (m[0] ** 2 + m[1] ** 2))
    run = ph.simulate(system, [1.0, 1.0, 1e-3], [0.0, np.pi * 1e3])
    assert np.asarray(run.states[-1]) == pytest.approx([-1.0, -1.0, 1e-3], abs=1e-6)
    assert ph.stability(system, [1.0, 1.0, 0.0]).verdict != "stable"
