"""A system together with small changes of its state."""

import diffrax
import jax
import jax.numpy as jnp
import numpy as np
import pytest

import polhode as ph
from polhode.errors import InvalidInput
from polhode.integrators import Taylor
from polhode.systems import Variations
from sweeping import first

TOP = ph.systems.HeavyTop((1.0, 2.0, 3.0), 1.0, (0.0, 0.6, 0.8))
START = np.array([0.5, 1.0, 2.0, 0.0, 0.6, 0.8])


@pytest.mark.sweep
def test_changes_are_the_derivative_of_the_motion():
    """Against derivatives of another method, which JAX takes through its steps."""
    varied = np.concatenate([START[None], np.eye(6)])
    found = ph.simulate(Variations(TOP, 6), varied, [0.0, 3.0])
    by_steps = jax.jacfwd(lambda x: ph.solve(TOP, x, jnp.array([0.0, 3.0]), ph.integrators.LieMidpoint).end_state)
    assert np.abs(found.states[-1, 1:].T - np.asarray(by_steps(jnp.asarray(START)))).max() < 1e-10
    assert found.error_estimate < 1e-12 and found.invariants["energy"].shape == (2,)


@pytest.mark.long
def test_the_motion_itself_keeps_what_it_conserves_and_nearly_its_steps():
    """Changes had no size, and with them the way back onto energy and Casimirs was lost."""
    times = np.linspace(0.0, 3e3, 11)
    alone = ph.simulate(TOP, START, times, Taylor, estimate_error=False)
    changed = np.stack([START, [1e-9, 0.0, 0.0, 0.0, 0.0, 0.0]])
    found = ph.simulate(Variations(TOP, 1), changed, times, Taylor, estimate_error=False)
    steps, steps_alone = found.statistics["steps"], alone.statistics["steps"]
    assert max(found.drift.values()) < 2e-15 and steps_alone <= steps < 1.3 * steps_alone


@pytest.mark.long
@pytest.mark.parametrize("method", [Taylor, diffrax.Dopri8()], ids=["series", "Dopri8"])
@pytest.mark.parametrize("momentum", first(1, [[0.0, 2.0, 0.0], [0.0, 0.0, 3.0]]), ids=["unstable", "stable"])
def test_changes_move_where_the_motion_stands_still(method, momentum):
    """The motion alone chose the steps: one over all of the time, and changes were off by 27 million, of any size."""
    body, start = ph.systems.FreeRigidBody((1.0, 2.0, 3.0)), np.array(momentum)
    found = ph.simulate(Variations(body, 3), np.concatenate([start[None], 1e9 * np.eye(3)]), [0.0, 20.0], method)
    by_start = jax.jacfwd(lambda L: ph.FreeMotion((1.0, 2.0, 3.0), momentum=L).momentum(20.0))(jnp.asarray(start))
    off = np.abs(found.states[-1, 1:].T / 1e9 - by_start).max() / np.abs(by_start).max()
    assert off < (1e-14 if method is Taylor else 1e-10) and off < 3.0 * found.error_estimate


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda: Variations(TOP, 0), "`count` must be a whole number of changes, at least 1; got 0"),
        (lambda: Variations(TOP, 2).check_state(np.stack([START, START])), "and 2 changes of it, stacked"),
        (lambda: Variations(TOP, 1).check_state(np.stack([START, np.full(6, np.inf)])), "changes that are not finite"),
    ],
)
def test_bad_input(call, words):
    with pytest.raises(InvalidInput, match=words):
        call()
