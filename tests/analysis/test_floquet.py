"""Periodic motions and Floquet multipliers, against published ones and those of Mathieu's equation."""

import jax.numpy as jnp
import numpy as np
import pytest
from scipy.special import mathieu_a, mathieu_b

import polhode as ph
from analysis.test_lyapunov_exponents import Lorenz
from polhode.analysis.floquet import monodromy, periodic_motion
from polhode.errors import InvalidInput, NotConverged


class Mathieu(ph.systems.AbstractSystem):
    """ẍ + (a − 2q cos 2t) x = 0."""

    a: float
    q: float

    def vector_field(self, t, state):
        return jnp.stack([state[..., 1], -(self.a - 2.0 * self.q * jnp.cos(2.0 * t)) * state[..., 0]], -1)

    def invariants(self, state):
        return {}


class Driven(ph.systems.AbstractSystem):
    """ẍ + .2 ẋ + x³ = .3 cos t, after Duffing and Ueda."""

    def vector_field(self, t, state):
        return jnp.stack([state[..., 1], 0.3 * jnp.cos(t) - 0.2 * state[..., 1] - state[..., 0] ** 3], -1)

    def invariants(self, state):
        return {}


def test_a_published_orbit_of_lorenz():
    """Viswanath, Nonlinearity 16 (2003) 1035, table 2: period and exponent of the orbit AB."""
    found = periodic_motion(Lorenz(), [-13.7, -19.5, 27.0], 1.55)
    assert abs(found.period - 1.558652210716175) < 1e-14
    assert abs(np.log(abs(found.multipliers[0])) / found.period - 0.99465) < 1e-5
    assert found.verdict == "unstable" and abs(found.growth - 0.99465) < 1e-5
    assert np.abs(found.multipliers[1] - 1.0) < found.errors[1] < 1e-9
    assert abs(np.prod(found.multipliers) / np.exp(-41.0 / 3.0 * found.period) - 1.0) < 1e-5


BORDERS = [(mathieu_a, 0, 0.4), (mathieu_a, 1, 0.7), (mathieu_b, 2, 1.3), (mathieu_b, 3, 5.0)]


@pytest.mark.parametrize(("border", "m", "q"), BORDERS)
def test_on_mathieus_borders_both_multipliers_are_one_or_minus_one(border, m, q):
    M = monodromy(Mathieu(float(border(m, q)), q), [1.0, 0.0], (0.0, np.pi))
    assert abs(np.trace(M) - 2.0 * (-1.0) ** m) < 1e-12 and abs(np.linalg.det(M) - 1.0) < 1e-12


def test_a_driven_motion_has_the_period_of_its_drive():
    found = periodic_motion(Driven(), [0.3, 0.0], 2.0 * np.pi, fixed=True)
    assert found.period == 2.0 * np.pi and found.gap < 1e-13
    assert abs(np.prod(found.multipliers) - np.exp(-0.2 * found.period)) < 1e-13  # Liouville
    assert found.verdict == "spectrally stable"


def test_the_period_of_a_free_body_is_that_of_its_closed_form():
    found = periodic_motion(ph.systems.FreeRigidBody((1.0, 2.0, 3.0)), [0.3, 0.1, 2.0], 9.5)
    exact = ph.FreeMotion((1.0, 2.0, 3.0), momentum=found.state).period
    assert abs(found.period - exact) < 1e-13 * exact and np.abs(found.multipliers - 1.0).max() < found.errors.max()


def test_changes_about_the_middle_axis_grow_at_the_known_rate():
    body, T = ph.systems.FreeRigidBody((1.0, 2.0, 3.0)), 4.0
    M = monodromy(body, [0.0, 2.0, 0.0], (0.0, T))
    assert abs(np.abs(np.linalg.eigvals(M)).max() - np.exp(3.0**-0.5 * T)) < 1e-12


@pytest.mark.long
def test_derivatives_of_complex_states():
    """A spin of su(2) in matrices, whose precession about z turns changes as it turns the spin."""
    system = ph.systems.LiePoisson(ph.algebra.SU(2), lambda m: jnp.real(1j * (m[..., 0, 0] - m[..., 1, 1])))
    of = ph.algebra.SU(2).from_dual_vector
    start, way = (np.asarray(of(np.array(x))) for x in ([0.3, 0.4, 0.5], [0.2, -0.1, 0.6]))
    M, h = monodromy(system, start, (0.0, 1.0)), 1e-6
    ends = [np.asarray(ph.simulate(system, start + s * h * way, [0.0, 1.0], estimate_error=False).states[-1])
            for s in (1.0, -1.0)]  # fmt: skip
    slope = ((ends[0] - ends[1]) / (2.0 * h)).reshape(-1).view(float)
    assert np.abs(M @ way.reshape(-1).view(float) - slope).max() < 1e-9


@pytest.mark.parametrize(
    ("state", "period", "error", "words"),
    [
        ([1.0, 1.0, 1.0], -1.0, InvalidInput, "`period` must be positive and finite"),
        ([8.485, 8.485, 27.0], 0.6, NotConverged, "is an equilibrium of Lorenz"),
        ([1.0, 1.0, 200.0], 0.01, NotConverged, "no periodic motion of Lorenz|is an equilibrium"),
    ],
)
def test_what_is_no_period_is_refused(state, period, error, words):
    with pytest.raises(error, match=words):
        periodic_motion(Lorenz(), state, period)
