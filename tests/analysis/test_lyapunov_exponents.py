"""Lyapunov exponents: published ones, sums and pairs that are exact, and errors that hold."""

import jax.numpy as jnp
import numpy as np
import pytest

import polhode as ph
from polhode.analysis.lyapunov_exponents import lyapunov
from polhode.errors import InvalidInput
from sweeping import first


class Lorenz(ph.systems.AbstractSystem):
    branched: bool = False

    def vector_field(self, t, state):
        x, y, z = state[..., 0], state[..., 1], state[..., 2]
        x = jnp.where(z > -1e6, x, 0.0) if self.branched else x  # which has no Taylor series
        return jnp.stack([10.0 * (y - x), x * (28.0 - z) - y, x * y - 8.0 / 3.0 * z], -1)

    def invariants(self, state):
        return {}


class Sink(ph.systems.AbstractSystem):
    """ẋ = A x, whose exponents are the real parts of the eigenvalues of A."""

    def vector_field(self, t, state):
        return state @ jnp.array([[-1.0, 0.5, 0.0], [0.0, -0.3, 2.0], [0.0, -2.0, -0.3]]).T

    def invariants(self, state):
        return {}


PUBLISHED = (0.905630, 0.0, -14.572297)
"""Sprott, *Chaos and Time-Series Analysis* (2003), appendix A.5.1."""


@pytest.mark.long
@pytest.mark.parametrize("branched", first(1, [False, True]))
def test_published_exponents(branched):
    """Also of one that is moved by steps of diffrax; the sum is the divergence, the same everywhere."""
    found = lyapunov(Lorenz(branched), [1.0, 1.0, 20.0], (0.0, 500.0))
    assert (np.abs(found.exponents - PUBLISHED) < found.errors).all() and (found.errors < 0.06).all()
    assert abs(found.exponents.sum() + 41.0 / 3.0) < (1e-9 if branched else 1e-12) and found.is_chaotic
    assert found.growth.shape == (len(found.times), 3) and (found.growth[-1] == found.exponents).all()


@pytest.mark.long
def test_of_linear_rates_they_are_the_real_parts_of_eigenvalues():
    found = lyapunov(Sink(), [1.0, 1.0, 1.0], (0.0, 200.0))
    assert np.abs(found.exponents - (-0.3, -0.3, -1.0)).max() < 0.01 and not found.is_chaotic
    backwards = lyapunov(Sink(), [1e-9, 1e-9, 1e-9], (0.0, -20.0), count=1)
    assert abs(backwards.exponents[0] - 1.0) < 0.1


@pytest.mark.long
def test_of_a_hamiltonian_system_they_come_in_pairs():
    top = ph.systems.HeavyTop((1.0, 2.0, 3.0), 1.0, (0.0, 0.6, 0.8))
    found = lyapunov(top, [0.5, 1.0, 2.0, 0.0, 0.0, 1.0], (0.0, 3000.0))
    assert found.is_chaotic and 0.01 < found.exponents[0] < 0.1
    assert (np.abs(found.exponents + found.exponents[::-1]) < found.errors).all()
    assert (np.abs(found.exponents[1:-1]) < found.errors[1:-1]).all()


@pytest.mark.long
@pytest.mark.parametrize(
    ("system", "state"),
    [
        (ph.systems.FreeRigidBody((1.0, 2.0, 3.0)), [0.3, 1.9, 0.1]),
        (ph.systems.HeavyTop((1.0, 1.0, 0.5), 1.0, (0.0, 0.0, 1.0)), [0.3, 0.1, 2.0, 0.6, 0.0, 0.8]),  # Lagrange's
    ],
)
def test_regular_motion_is_not_told_from_zero(system, state):
    for end in (300.0, 3000.0):
        found = lyapunov(system, state, (0.0, end))
        assert not found.is_chaotic and (np.abs(found.exponents) < found.errors).all()


@pytest.mark.long
def test_a_chain_whose_ends_are_free_comes_to_rest_by_the_gaps_of_its_spectrum():
    """Particles of Toda's chain fly apart with the eigenvalues of L (Moser 1975); couplings vanish as e^−gap t."""
    system, start = ph.fields.Toda(3), np.array([0.5, -0.2, 0.3, 0.8, 1.2])
    found = lyapunov(system, start, (0.0, 100.0))
    values = np.linalg.eigvalsh(np.diag(start[:3]) + np.diag(start[3:], 1) + np.diag(start[3:], -1))
    gaps = np.sort(np.diff(values))
    assert np.abs(found.exponents[:3]).max() < 1e-9 and np.abs(found.exponents[3:] + gaps).max() < found.errors.max()


@pytest.mark.sweep
def test_errors_hold_in_most_runs():
    rng = np.random.default_rng(3)
    found = [lyapunov(Lorenz(), np.array([1.0, 1.0, 20.0]) + rng.normal(size=3), (0.0, 200.0)) for _ in range(60)]
    held = np.array([np.abs(one.exponents - PUBLISHED) < one.errors for one in found])
    assert (held.mean(axis=0) >= 0.9).all()


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (([[1.0, 1.0, 1.0]], (0.0, 1.0)), r"one state, no batch; got shape \(1, 3\)"),
        (([1.0, 1.0, 1.0], (0.0, 0.0)), "a first and another last time"),
        (([1.0, 1.0, 1.0], (0.0, 1.0), 4), "`count` must be a whole number from 1 to 3"),
    ],
)
def test_wrong_arguments_are_refused(arguments, words):
    with pytest.raises(InvalidInput, match=words):
        lyapunov(Lorenz(), *arguments)


def test_a_motion_that_ends_before_is_refused():
    class Falling(Lorenz):
        @property
        def events(self):
            return {"ground": lambda t, state: state[2] - 10.0}

    with pytest.raises(InvalidInput, match=r"ends at .* by the event ground"):
        lyapunov(Falling(), [1.0, 1.0, 20.0], (0.0, 100.0))
