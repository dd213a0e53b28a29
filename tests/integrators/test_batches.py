"""A copy in a batch moves as it does alone: nothing that its neighbours need sets its steps or its end.

Equal but for rounding: XLA adds and multiplies in another order when it works on vectors of copies.
"""

from typing import Any

import diffrax
import jax.numpy as jnp
import numpy as np
import pytest

import polhode as ph
from polhode import algebra as lie
from polhode import systems
from polhode.errors import NotConverged
from polhode.integrators import LieMidpoint, MuntheKaas, SphericalMidpoint
from polhode.integrators._equal_steps import LIMITS
from specimens import spins
from sweeping import first

SAME = 1e-12  # a few roundings, grown by the motion
MOMENTS = (1.0, 2.0, 3.0)
TIMES = np.linspace(0.0, 3.0, 4)
SLOW = np.array([0.3, 1.8, 1.5])
body = systems.FreeRigidBody(MOMENTS)
# one much faster, one at rest, one on an axis
MIXED = np.array([0.1 * SLOW, 30.0 * SLOW, SLOW, 0.0 * SLOW, [0.0, 0.0, 2.0]])


def check_copies(system, states, method=None, **more):
    both: Any = ph.simulate(system, states, TIMES, method, **more)
    for k, state in enumerate(states):
        alone: Any = ph.simulate(system, state, TIMES, method, **more)
        size = np.abs(alone.states).max() or 1.0
        assert np.abs(both.states[k] - alone.states).max() <= SAME * size, k
        said = float(alone.error_estimate)  # one of the others takes other steps, whose roundings grow to other errors
        assert said / 3.0 - 1e-12 <= both.error_estimate[k] <= 3.0 * said + 1e-12
    return both


@pytest.mark.parametrize(
    "method", first(1, [None, LieMidpoint, MuntheKaas, diffrax.Dopri8()])
)
def test_copies_move_as_alone(method):
    check_copies(body, MIXED, method)


@pytest.mark.sweep
def test_spins_and_tops_move_as_alone():
    pair = systems.LiePoisson(lie.Power(lie.SO3(), 2), spins)
    rng = np.random.default_rng(0)
    check_copies(pair, rng.normal(size=(3, 2, 3)) * np.array([0.1, 1.0, 10.0])[:, None, None], SphericalMidpoint)
    top = systems.HeavyTop(MOMENTS, 0.7)
    states = np.asarray(top.pack(angular_velocity=np.array([[0.1, 0.2, 30.0], [0.1, 0.2, 0.5]])))
    check_copies(top, states, step=0.05)


@pytest.mark.long
def test_a_copy_that_fails_leaves_the_others():
    states, times = np.array([0.1 * SLOW, 20.0 * SLOW]), [0.0, 10.0, 20.0]
    with pytest.raises(NotConverged, match="in 1 of 2 copies, first 1"), pytest.warns(UserWarning, match="a step of"):
        ph.simulate(body, states, times, LieMidpoint, step=2.5)
    with pytest.warns(UserWarning, match="a step of"):
        found: Any = ph.simulate(body, states, times, LieMidpoint, step=2.5, throw=False)
    assert "1 of 2 copies" in found.outcome.message
    alone = ph.simulate(body, states[0], times, LieMidpoint, step=2.5)
    assert np.abs(found.states[0] - alone.states).max() < SAME
    assert not np.isfinite(found.states[1, -1]).any()
    assert np.isinf(found.error_estimate[1]) and np.isfinite(found.error_estimate[0])


@pytest.mark.sweep
def test_more_copies_than_a_block():
    count = 2 * LIMITS.copies_in_block + 3
    states = np.linspace(0.5, 2.0, count)[:, None] * SLOW
    found = ph.simulate(body, states.reshape(1, count, 3), TIMES)
    exact = ph.FreeMotion(MOMENTS, momentum=states.reshape(1, count, 1, 3)).momentum(TIMES)
    assert found.states.shape == (1, count, 4, 3)
    assert np.abs(found.states - exact).max() < 1e-9
    more = ph.simulate(body, states[:LIMITS.copies_in_block], TIMES)
    assert (more.states == found.states[0, :LIMITS.copies_in_block]).all(), "blocks are one compiled function"


@pytest.mark.long
def test_the_exponential_of_a_copy_is_its_own():
    line = lie.SL(2)
    x = line.from_vector(jnp.array([[0.1, 0.2, 0.3], [40.0, 50.0, 60.0]]))
    mu = line.from_dual_vector(jnp.array([[1.0, 2.0, 3.0], [1.0, 2.0, 3.0]]))
    together = line.exp_change(x, mu)
    assert np.isnan(together[1]).all()
    assert (together[0] == line.exp_change(x[0], mu[0])).all()
