"""Both sides of the thresholds of steps along the orbit."""

import jax.numpy as jnp
import numpy as np
import pytest

import polhode as ph
from polhode import systems
from polhode.errors import InvalidInput
from polhode.integrators import LieMidpoint, _equal_steps
from polhode.integrators._fixed_point import fixed_point


def test_a_run_of_too_many_equal_steps_is_refused(monkeypatch):
    monkeypatch.setattr(_equal_steps, "LIMITS", _equal_steps.LIMITS._replace(max_steps=20))
    body, start = systems.FreeRigidBody((1.0, 2.0, 3.0)), [0.3, 0.4, 0.5]
    run = lambda last: ph.simulate(body, start, [0.0, last], LieMidpoint, 0.1, estimate_error=False)  # noqa: E731
    assert np.isfinite(run(2.0).states).all()
    with pytest.raises(InvalidInput, match=r"would take 2\.1e\+01 steps of 0\.1 s, and at most 2e\+01 are taken"):
        run(2.1)


@pytest.mark.parametrize(("slope", "converges"), [(0.65, True), (0.75, False)])
def test_iterations_end_at_a_hundred(slope, converges):
    """Changes shrink by the slope, to 4e-16 of the unknown in 82 iterations or in 123."""
    found = fixed_point(lambda x: slope * x + 1.0, jnp.zeros(1), jnp.asarray(1.0 / (1.0 - slope)))
    assert bool(found.converged) == converges and (int(found.iterations) < 100) == converges


def test_changes_that_stall_are_rounding_below_a_size_only():
    """x → −x about a point: changes stay, as roundings of a large map do."""
    for size, converges in ((4e-12, True), (6e-12, False)):
        found = fixed_point(lambda x: 2.0 - x, jnp.asarray([1.0 + size]), jnp.asarray(1.0))
        assert bool(found.converged) == converges
