"""Structure factor of waves over their dispersion, skyrmions, and the switching fields of Stoner and Wohlfarth."""

import numpy as np
import pytest

import polhode as ph
from polhode.errors import InvalidInput
from polhode.fields import (
    Bond,
    Lattice,
    SpinLattice,
    exchange_matrix,
    hysteresis_loop,
    skyrmion_number,
    spin_waves,
    structure_factor,
)


@pytest.mark.long
def test_lines_lie_on_the_dispersion_and_the_sum_rule_holds():
    """With chirality, so that a wrong sign of q or ω would show."""
    count = 16
    lattice = Lattice([[1.0]], shape=(count,))
    system = SpinLattice(lattice, 1.0, [Bond(0, 0, (1,), exchange_matrix(1.0, (0, 0, 0.4)))], field=(0, 0, 0.8))
    rng = np.random.default_rng(0)
    start = system.aligned([0.0, 0.0, 1.0] + 0.01 * rng.normal(size=(count, 1, 1, 1, 3)))
    times = np.arange(0.0, 80.0, 0.25)
    states = ph.solve(system, start, times, ph.integrators.Splitting, 0.05, order=2).saved
    q = 2 * np.pi * np.arange(-6, 7)[:, None] / count
    q = q[np.abs(q[:, 0]) > 0.1]
    frequencies, power = structure_factor(lattice, times, states, q)
    above = frequencies > 0
    peaks = frequencies[above][power[:, above].argmax(axis=1)]
    exact = spin_waves(system, [[0.0, 0.0, 1.0]], q)[:, 0]
    assert np.abs(peaks - exact).max() < 2 * np.pi / 80
    assert np.abs(exact - exact[::-1]).max() > 0.5
    spread = np.einsum("tni,nq->tqi", np.asarray(states).reshape(len(times), count, 3),
                       np.exp(-1j * np.arange(count)[:, None] * q.T))  # fmt: skip
    window = np.sin(np.pi * (np.arange(len(times)) + 0.5) / len(times)) ** 4
    mean = np.einsum("t,tqi->q", window / window.sum(), np.abs(spread) ** 2) / count
    assert np.allclose(power.sum(axis=1) * (frequencies[1] - frequencies[0]), mean, rtol=1e-12)


def skyrmion(size=24, winding=1):
    x, y = np.meshgrid(*(np.arange(size) - (size - 1) / 2,) * 2, indexing="ij")
    radius, azimuth = np.hypot(x, y), winding * np.arctan2(y, x)
    polar = np.pi * np.clip(1 - radius / (size / 2 - 1), 0, 1)
    return np.stack([np.sin(polar) * np.cos(azimuth), np.sin(polar) * np.sin(azimuth), np.cos(polar)], axis=-1)


@pytest.mark.parametrize("winding", [1, -1, 2])
def test_skyrmion_number(winding):
    """The centre points down: outward azimuth with growing height is the other orientation than the sphere's."""
    assert abs(float(skyrmion_number(skyrmion(winding=winding))) + winding) < 1e-12
    rng = np.random.default_rng(0)
    whole = skyrmion_number(rng.normal(size=(5, 8, 8, 3)))
    assert np.abs(whole - np.round(whole)).max() < 1e-12


@pytest.mark.long_after(1)
@pytest.mark.parametrize(("angle", "switch"), [(45, 0.5), (30, 0.5240164647), (10, 0.6738054181)])
def test_stoner_wohlfarth_switches(angle, switch):
    """H = −K(S·z)² − B·S, h = B/2K: it stays up to just below h_sw, and is over just beyond."""
    direction = -np.array([np.sin(np.radians(angle)), 0.0, np.cos(np.radians(angle))])
    one = SpinLattice(Lattice([[1.0]], shape=(1,)), onsite=np.diag([0, 0, 0.5]), field=direction, damping=0.8)
    fields = np.array([0.9, 0.995, 1.005])[:, None] * switch * direction
    loop = hysteresis_loop(one, one.aligned((0.0, 0.0, 1.0)), fields, 150.0, 0.25)
    along = loop.states[:, 0, 0, 0, 0, 2]
    assert along[0] > 0 and along[1] > 0 and along[2] < 0
    assert loop.torque[0] < 1e-8


def test_what_is_refused():
    lattice = Lattice([[1.0]], shape=(2,))
    with pytest.raises(InvalidInput, match="damping"):
        hysteresis_loop(SpinLattice(lattice), np.zeros((2, 1, 1, 1, 3)), [[0, 0, 1.0]], 1.0, 0.1)
    with pytest.raises(InvalidInput, match="equally spaced"):
        structure_factor(lattice, [0.0, 1.0, 3.0, 4.0], np.zeros((4, 2, 1, 1, 1, 3)), [[1.0]])
    with pytest.raises(InvalidInput, match="states"):
        structure_factor(lattice, np.arange(4.0), np.zeros((4, 3, 1, 1, 1, 3)), [[1.0]])
    with pytest.raises(InvalidInput, match="not zero"):
        skyrmion_number(np.zeros((3, 3, 3)))
