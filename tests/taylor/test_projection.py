"""A state is put back onto what is conserved by the shortest move, as least squares have it."""

import jax.numpy as jnp
import numpy as np
import pytest

from polhode import systems
from polhode.taylor.advancing import _evaluate_conserved
from polhode.taylor.kernel_space import exact_for, lanes_for, series_for
from polhode.taylor.kernels import python_kernel
from polhode.taylor.machine import build_machine


class Conserving(systems.AbstractSystem):
    """Numbers that do not move, of which some functions are kept."""

    kept: tuple

    def vector_field(self, t, state):
        return 0.0 * state

    def invariants(self, state):
        return {f"{k}": of(state) for k, of in enumerate(self.kept)}


def put_back(system, wanted_at, y, scale):
    """Return a state after it has been put back onto values at another one, and the gradients of these there."""
    with np.errstate(all="ignore"):
        machine, n = build_machine(system, wanted_at, (0.0, 1.0)), len(y)
        wanted, slack = _evaluate_conserved(machine, wanted_at[None], scale[None])
        count = wanted.shape[1]
        lanes = lanes_for(machine.program, exact_for(None, np.zeros(0), 1), 3, 1, 0, count, 0)
        lanes.which[0], lanes.states[:n], lanes.scales[:n] = 0, y, scale
        lanes.wanted[:count], lanes.slack[:count] = wanted[0], slack[0]
        back_onto = python_kernel(1).advance.__globals__["back_onto"]
        back_onto(series_for(machine.integrals, 1, 1), lanes, count)
    return np.array(lanes.states[:n])


QUADRATIC = (lambda y: jnp.sum(y**2), lambda y: y[0] * y[1] + 0.3 * y[2], lambda y: y[3] ** 2 - y[0])
GRADIENTS = (lambda y: 2.0 * y, lambda y: np.array([y[1], y[0], 0.3, 0.0]), lambda y: np.array([-1.0, 0, 0, 2 * y[3]]))


@pytest.mark.parametrize(("scale", "count"), [
    (np.ones(4), 3), (np.array([1.0, 0.5, 3.0, 0.2]), 3), (np.array([1.0, np.inf, 1.0, 1.0]), 2),
])  # fmt: skip
@pytest.mark.parametrize("seed", range(4))
def test_the_move_is_the_shortest_by_scale(seed, scale, count):
    drawn = np.random.default_rng(seed)
    there, kick = np.array([0.3, 1.0, 2.0, 3.0]) + 0.1 * drawn.normal(size=4), 1e-7 * drawn.normal(size=4)
    found = put_back(Conserving(QUADRATIC[:count]), there, there + kick, scale)
    values = [np.array([float(of(y)) for of in QUADRATIC[:count]]) for y in (there, there + kick)]
    units = np.where(np.isinf(scale), 0.0, scale)
    rows = np.array([of(there + kick) for of in GRADIENTS[:count]]) * units
    wanted = np.linalg.lstsq(rows, values[0] - values[1], rcond=None)[0] * units
    np.testing.assert_allclose(found - (there + kick), wanted, rtol=0.0, atol=1e-14)
    assert np.abs(found - (there + kick)).max() > 1e-9


@pytest.mark.parametrize(("angle", "moves"), [(0.09, False), (0.12, True)])
def test_a_gradient_that_nearly_depends_on_others_is_left_out(angle, moves):
    """A hundredth of the squared gradient must be left beside the others: an angle of 0.1."""
    kept = (lambda y: y[0], lambda y: np.cos(angle) * y[0] + np.sin(angle) * y[1])
    found = put_back(Conserving(kept), np.zeros(3), np.array([0.0, 1e-5, 0.0]), np.ones(3))
    assert (abs(found[1]) < 1e-15) == moves


@pytest.mark.parametrize(("off", "moves"), [(0.9e-3, True), (1.1e-3, False)])
def test_a_state_that_is_far_off_is_left(off, moves):
    found = put_back(Conserving((lambda y: 2.0 * y[0],)), np.zeros(2), np.array([off, 0.3]), np.ones(2))
    assert found[1] == 0.3 and (found[0] == 0.0) == moves and (found[0] == off) != moves


@pytest.mark.parametrize("number", [np.inf, np.nan, 1e141])
def test_a_gradient_without_size_moves_nothing_and_the_others_do(number):
    kept = (lambda y: number * y[2], lambda y: y[0])
    found = put_back(Conserving(kept), np.zeros(3), np.array([1e-6, 0.5, 1e-300]), np.ones(3))
    assert found[0] == 0.0 and found[1] == 0.5 and found[2] == 1e-300
    large = put_back(Conserving((lambda y: 1e139 * y[2],)), np.zeros(3), np.array([0.0, 0.5, 1e-6]), np.ones(3))
    assert large[2] == 0.0
