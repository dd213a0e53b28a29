"""Dispersions of spin waves against closed forms; states that are refused."""

import numpy as np
import pytest

from polhode.errors import InvalidInput
from polhode.fields import Bond, Lattice, SpinLattice, exchange_matrix, spin_waves

K = np.linspace(0.05, np.pi, 23)
UP = (0.0, 0.0, 1.0)


def chain(matrix, spin=1.0, **more):
    return SpinLattice(Lattice([[1.0]], shape=(6,)), spin, [Bond(0, 0, (1,), matrix)], **more)


def easy(k):
    return np.diag([0.0, 0.0, k])


def test_ferromagnet_with_field_anisotropy_and_chirality():
    spin, j, d, k, b = 1.5, 1.0, 0.3, 0.4, 0.7
    system = chain(exchange_matrix(j, (0.0, 0.0, d)), spin, onsite=easy(k), field=(0.0, 0.0, b))
    result = spin_waves(system, spin * np.array([UP]), np.concatenate([K, -K])[:, None])[:, 0]
    sides = [b + 2 * k * spin + 2 * spin * (j * (1 - np.cos(K)) + s * d * np.sin(K)) for s in (1, -1)]
    either = [np.abs(result - np.concatenate(s)).max() for s in (sides, sides[::-1])]
    assert min(either) < 1e-12 and max(either) > 0.1


def test_antiferromagnet_with_anisotropy():
    spin, j, k = 1.5, -0.8, 0.2
    state = spin * np.array([[UP], [(0.0, 0.0, -1.0)]])[:, None, None]
    result = spin_waves(chain(j, spin, onsite=easy(k)), state, K[:, None])
    expected = 2 * spin * np.sqrt((abs(j) + k) ** 2 - (j * np.cos(K)) ** 2)
    assert np.abs(result - expected[:, None]).max() < 1e-12


def spiral(count=6):
    """Spins of one length, turned about z by 2π/count from cell to cell."""
    angle = 2 * np.pi / count * np.arange(count)
    return np.stack([np.cos(angle), np.sin(angle), 0 * angle], axis=-1)[:, None, None, None]


@pytest.mark.long
def test_chiral_spiral():
    """tan(pitch) = D/J; the three modes of a cell of six are those of the turning frame at k + n·60°."""
    d = np.tan(np.pi / 3)
    whole = np.hypot(1.0, d)
    system = chain(exchange_matrix(1.0, (0.0, 0.0, d)))
    state = spiral()
    energy = float(system.energy(state)) / 6
    assert abs(energy + whole) < 1e-14
    for k in (0.1, 0.31):
        at = k + np.pi / 3 * np.arange(6)
        expected = np.sort(2 * np.sqrt(whole * (1 - np.cos(at)) * (whole - np.cos(at))))
        assert np.abs(spin_waves(system, state, [k]) - expected).max() < 1e-12


def honeycomb(j=1.0, b=0.3):
    lattice = Lattice([[1.0, 0.0], [0.5, 0.75**0.5]], [[0.0, 0.0], [0.5, 0.5 / 3**0.5]], shape=(2, 2))
    bonds = [Bond(0, 1, cell, j) for cell in ((0, 0), (-1, 0), (0, -1))]
    return SpinLattice(lattice, 1.5, bonds, field=(0.0, 0.0, b))


def test_honeycomb():
    q = np.random.default_rng(0).normal(size=(9, 2))
    a, b = (q @ np.array(v)[:2] for v in honeycomb().lattice.vectors)
    split = np.abs(1 + np.exp(1j * a) + np.exp(1j * b))
    expected = 0.3 + 1.5 * (3 + np.multiply.outer(split, (-1, 1)))
    assert np.abs(spin_waves(honeycomb(), 1.5 * np.array([UP, UP]), q) - expected).max() < 1e-12


def test_states_that_are_refused():
    with pytest.raises(InvalidInput, match="rest"):
        spin_waves(chain(1.0, field=(1.0, 0.0, 0.0)), [UP], [0.5])
    with pytest.raises(InvalidInput, match="minimum"):
        spin_waves(chain(-1.0), [UP], [0.5])
