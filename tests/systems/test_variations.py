"""A system together with small changes of its state."""

import jax
import jax.numpy as jnp
import numpy as np
import pytest

import polhode as ph
from polhode.errors import InvalidInput
from polhode.integrators import Taylor
from polhode.systems import Variations

TOP = ph.systems.HeavyTop((1.0, 2.0, 3.0), 1.0, (0.0, 0.6, 0.8))
START = np.array([0.5, 1.0, 2.0, 0.0, 0.6, 0.8])


def test_changes_are_the_derivative_of_the_motion():
    """Against derivatives of another method, which JAX takes through its steps."""
    varied = np.concatenate([START[None], np.eye(6)])
    found = ph.simulate(Variations(TOP, 6), varied, [0.0, 3.0])
    by_steps = jax.jacfwd(lambda x: ph.solve(TOP, x, jnp.array([0.0, 3.0]), ph.integrators.LieMidpoint).end_state)
    assert np.abs(found.states[-1, 1:].T - np.asarray(by_steps(jnp.asarray(START)))).max() < 1e-10
    assert found.error_estimate < 1e-12 and found.invariants["energy"].shape == (2,)


def test_the_motion_itself_keeps_what_it_conserves_and_its_steps():
    """Changes had no size, and with them the way back onto energy and Casimirs was lost."""
    times = np.linspace(0.0, 3e3, 11)
    alone = ph.simulate(TOP, START, times, Taylor, estimate_error=False)
    changed = np.stack([START, [1e-9, 0.0, 0.0, 0.0, 0.0, 0.0]])
    found = ph.simulate(Variations(TOP, 1), changed, times, Taylor, estimate_error=False)
    assert max(found.drift.values()) < 2e-15 and found.statistics["steps"] == alone.statistics["steps"]


def test_steps_of_other_methods_do_not_see_the_changes_either():
    import diffrax

    changed = np.stack([START, [1e9, 0.0, 0.0, 0.0, 0.0, 0.0]])
    found = ph.simulate(Variations(TOP, 1), changed, [0.0, 3.0], diffrax.Dopri8(), estimate_error=False)
    alone = ph.simulate(TOP, START, [0.0, 3.0], diffrax.Dopri8(), estimate_error=False)
    assert found.statistics["steps"] == alone.statistics["steps"]


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda: Variations(TOP, 0), "`count` of changes must be a positive whole number; got 0"),
        (lambda: Variations(TOP, 2).check_state(np.stack([START, START])), "and 2 changes of it, stacked"),
        (lambda: Variations(TOP, 1).check_state(np.stack([START, np.full(6, np.inf)])), "changes that are not finite"),
    ],
)
def test_bad_input(call, words):
    with pytest.raises(InvalidInput, match=words):
        call()
