"""Verdicts on random systems of five algebras, against independent exponents and motions of perturbed starts."""

from collections import Counter

import numpy as np
import pytest

import polhode as ph
from analysis.random_systems import ALGEBRAS, OFF, departures, judge, judge_motion, random_specimen
from polhode.analysis import _equilibrium_data as equilibrium_data
from polhode.analysis import _exact_functions as exact_functions

SWEEP = 60  # systems of each algebra
JUDGED = 3  # equilibria of each: of lowest and highest energy, and one between
STARTS = 8  # of the search for equilibria
FIELD = 1e-8  # of its terms, at what is found


def verdicts_of(specimen, seed):
    """Return equilibria of one system (m, n), and the verdicts on them."""
    algebra = specimen.system.algebra
    found = ph.find_equilibria(specimen.system, specimen.point, starts=STARTS, seed=seed)
    if len(found) > JUDGED:
        found = found[[0, len(found) // 2, -1]]
    points = np.asarray(algebra.to_dual_vector(found)).reshape(len(found), algebra.dim)
    return points, [ph.stability(specimen.system, point) for point in found]


def false_verdicts(name, seeds, moving=True):
    """Return the verdicts on some systems of one algebra, and what is false about them."""
    specimens, points, verdicts = [], [], []
    for seed in seeds:
        specimen = random_specimen(name, seed)
        own, found = verdicts_of(specimen, seed)
        specimens += [specimen] * len(found)
        points += list(own)
        verdicts += found
    wrong, rates = [], []
    for specimen, x, verdict in zip(specimens, points, verdicts, strict=True):
        assert np.linalg.norm(specimen.field(x)) < FIELD * np.linalg.norm(x) * np.linalg.norm(specimen.slope(x))
        wrong.append(judge(verdict, specimen, x))
        rates.append(np.abs(np.linalg.eigvals(specimen.jacobian(x))).max())
    for kick in kicks(np.array(points)) if moving else ():
        distances = departures(specimens, np.array(points), points + kick, np.array(rates))
        wrong += [judge_motion(v, d, r) for v, d, r in zip(verdicts, distances.T, rates, strict=True)]
    return verdicts, [text for text in wrong if text]


def kicks(points):
    """Return two small random displacements of each point."""
    ways = np.random.default_rng(0).normal(size=(2, *points.shape))
    return OFF * np.linalg.norm(points, axis=1)[:, None] * ways / np.linalg.norm(ways, axis=2, keepdims=True)


@pytest.mark.sweep
def test_a_few_random_systems():
    verdicts, wrong = false_verdicts("so(3)", range(3))
    assert wrong == []
    assert {v.verdict for v in verdicts} >= {"stable", "unstable"}


@pytest.mark.sweep
@pytest.mark.parametrize("name", ALGEBRAS)
def test_many_random_systems(name):
    verdicts, wrong = false_verdicts(name, range(SWEEP))
    assert wrong == []
    counts = Counter(v.verdict for v in verdicts)
    assert min(counts["stable"], counts["unstable"]) > SWEEP // 4, counts
    assert counts["undecided"] < 0.4 * counts.total(), counts


@pytest.mark.long
def test_false_verdicts_are_seen(monkeypatch):
    """With the energy's curvature of the wrong sign, independent exponents contradict the verdicts."""
    right = equilibrium_data.derivatives

    def wrong(source, *args):
        found = right(source, *args)
        return found._replace(hessians=-found.hessians) if isinstance(source, equilibrium_data.Energy) else found

    monkeypatch.setattr(equilibrium_data, "derivatives", wrong)
    by_doubles = exact_functions.LIMITS._replace(max_coordinates=0)  # whose derivatives are others
    monkeypatch.setattr(exact_functions, "LIMITS", by_doubles)
    assert false_verdicts("so(3)", range(4), moving=False)[1]


@pytest.mark.long
def test_motions_show_false_verdicts():
    """The same verdicts, exchanged between an unstable and a stable equilibrium, do not pass for motions either."""
    specimen = random_specimen("so(3)", 1)
    points, verdicts = verdicts_of(specimen, 1)
    kinds = [v.verdict for v in verdicts]
    stable, unstable = kinds.index("stable"), kinds.index("unstable")
    x = points[[stable, unstable]]
    rates = np.array([np.abs(np.linalg.eigvals(specimen.jacobian(point))).max() for point in x])
    distances = departures([specimen] * 2, x, x + kicks(x)[0], rates).T
    assert judge_motion(verdicts[stable], distances[0], rates[0]) is None
    assert judge_motion(verdicts[unstable], distances[1], rates[1]) is None
    assert judge_motion(verdicts[stable], distances[1], rates[1])
    assert judge_motion(verdicts[unstable], distances[0], rates[0])
