"""The Pfaffian against its expansion in exact fractions, and how it grows."""

from fractions import Fraction

import jax
import numpy as np
import pytest

import polhode as ph
from polhode import systems
from polhode.algebra import _pfaffian
from polhode.taylor.machine import build_machine


def by_expansion(entries):
    """Return Σ_j (−1)^(j−1) a_0j Pf(A without 0 and j)."""
    size = len(entries)
    if size == 0:
        return 1
    total = 0
    for j in range(1, size):
        rest = [k for k in range(1, size) if k != j]
        total += (-1) ** (j - 1) * entries[0][j] * by_expansion([[entries[a][b] for b in rest] for a in rest])
    return total


def antisymmetric(size, seed=0):
    upper = np.triu(np.random.default_rng(seed).integers(-9, 10, size=(5, size, size)), 1).astype(float)
    return upper - np.swapaxes(upper, -1, -2)


def deviation(size):
    whole = antisymmetric(size)
    exact = [by_expansion([[Fraction(x) for x in row] for row in one]) for one in whole]
    return max(abs(Fraction(float(x)) - y) for x, y in zip(_pfaffian.pfaffian(whole), exact, strict=True))


@pytest.mark.parametrize("size", [2, 4, 6, 8])
def test_whole_numbers_are_exact(size):
    assert deviation(size) == 0


def test_a_wrong_block_is_noticed(monkeypatch):
    right = _pfaffian._times_blocks
    monkeypatch.setattr(_pfaffian, "_times_blocks", lambda v: -right(v))
    assert deviation(6) > 1


def test_steps_grow_like_the_square():
    """As those of arrays, of which each level has one for each power of a block, and some that do not depend on n."""
    counts = [len(jax.make_jaxpr(_pfaffian.pfaffian)(np.zeros((n, n))).eqns) for n in (8, 16, 32)]
    assert counts[1] < 2**2 * counts[0] and counts[2] < 2**2 * counts[1]
    assert counts[2] < 900  # of products of coefficients one by one there were 4,000


def test_bodies_in_twelve_dimensions_move_by_series():
    """Energy and the first Casimirs are put back; there is no room for the others, and they are kept all the same."""
    system = systems.Manakov(1.0 + np.arange(12) / 12)
    start = antisymmetric(12)[0] / 9.0
    assert build_machine(system, start, None).names[:2] == ("energy", "tr μ^4")
    motion = ph.simulate(system, start, np.array([0.0, 0.1]))
    assert "Taylor" in str(motion.plan) and max(motion.drift.values()) < 1e-13
