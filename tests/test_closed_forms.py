"""Closed forms as single operations of JAX: batches, loops, both ways of evaluation, and what is refused."""

import jax
import jax.numpy as jnp
import numpy as np
import pytest

import polhode as ph
from polhode._base.arrays import Elementwise
from polhode._base.arrays.few_calls import quick_options
from polhode.errors import InvalidInput

MOMENTS, MOMENTUM = np.array([1.0, 2.0, 3.0]), np.array([0.3, 1.8, 1.5])
SAME = 1e-14


def momentum_at(moments, momentum, t):
    return ph.FreeMotion(moments, momentum=momentum).momentum(t)


@pytest.mark.long_cases("axes0", "axes1")
@pytest.mark.parametrize("axes", [(0, None, None), (None, 1, None), (None, None, 0), (0, 1, None), (0, 1, 0)])
def test_vmap_over_any_axis_is_a_batch(axes):
    moments = MOMENTS + np.arange(4)[:, None] if axes[0] == 0 else MOMENTS
    momentum = MOMENTUM[:, None] * (1.0 + np.arange(4)) if axes[1] == 1 else MOMENTUM
    t = np.arange(4.0) if axes[2] == 0 else 2.0
    with jax.enable_x64(True):
        found = jax.jit(jax.vmap(momentum_at, in_axes=axes))(*map(jnp.asarray, (moments, momentum, t)))
    taken = momentum.T if axes[1] == 1 else momentum
    assert np.abs(np.asarray(found) - momentum_at(moments, taken, t)).max() < SAME


def test_a_batch_of_times_and_of_bodies_under_two_vmaps():
    momentum, times = MOMENTUM * (1.0 + np.arange(3.0))[:, None], np.linspace(0.0, 9.0, 5)
    inner = jax.vmap(momentum_at, in_axes=(None, None, 0))
    with jax.enable_x64(True):
        found = jax.vmap(inner, in_axes=(None, 0, None))(*map(jnp.asarray, (MOMENTS, momentum, times)))
    assert np.abs(np.asarray(found) - momentum_at(MOMENTS, momentum[:, None], times)).max() < SAME


def test_a_compiled_loop_calls_it_at_every_turn():
    def turn(total, t):
        return total + momentum_at(MOMENTS, jnp.asarray(MOMENTUM), t), total

    times = np.linspace(0.0, 100.0, 300)
    with jax.enable_x64(True):
        total, _ = jax.jit(lambda t: jax.lax.scan(turn, jnp.zeros(3), t))(jnp.asarray(times))
    assert np.abs(np.asarray(total) - momentum_at(MOMENTS, MOMENTUM, times).sum(axis=0)).max() < 300 * SAME


@pytest.mark.long
def test_large_batches_in_flight_at_once():
    """JAX dispatches asynchronously; a callback that waited for JAX itself would stand still."""
    momentum = MOMENTUM * np.linspace(0.9, 1.1, 100_000)[:, None]
    with jax.enable_x64(True):
        run = jax.jit(lambda x: momentum_at(MOMENTS, x, 5.0) + momentum_at(MOMENTS, 2.0 * x, 3.0))
        found = [run(jnp.asarray(momentum) * s) for s in (1.0, 1.5, 2.0)]
        found = [np.asarray(x) for x in found]
    wanted = momentum_at(MOMENTS, momentum, 5.0) + momentum_at(MOMENTS, 2.0 * momentum, 3.0)
    assert np.abs(found[0] - wanted).max() < 10 * SAME


@pytest.mark.sweep
def test_both_ways_agree_on_one_component():
    """The smallest thing that can be compiled alone, with its derivative by time."""
    rate = lambda t: jax.value_and_grad(lambda t: momentum_at(MOMENTS, jnp.asarray(MOMENTUM), t)[0])(t)  # noqa: E731
    with jax.enable_x64(True):
        at_once = rate(jnp.asarray(7.0))
        with ph.closed_forms("compiled"):
            at = jax.jit(lambda t: momentum_at(MOMENTS, jnp.asarray(MOMENTUM), t)[0], compiler_options=quick_options())
            compiled = at(7.0)
    assert float(compiled) == pytest.approx(float(at_once[0]), abs=SAME)
    L = momentum_at(MOMENTS, MOMENTUM, 7.0)
    assert float(at_once[1]) == pytest.approx(np.cross(L, L / MOMENTS)[0], abs=SAME)


@pytest.mark.parametrize("small", [1e-160, 1e-300])
def test_compiled_functions_take_subnormal_numbers_as_numpy_does(small):
    """XLA's threads round 1e-315 to zero."""
    product = Elementwise("product", lambda x, y: (x * y,), ((), ()), (((), float),))
    with jax.enable_x64(True):
        arguments = jnp.asarray(small), jnp.asarray(1e-315 / small)
        assert float(jax.jit(product)(*arguments)[0]) == small * (1e-315 / small) > 0.0


@pytest.mark.long
def test_the_way_is_chosen_when_a_function_is_traced():
    text = lambda: jax.jit(lambda t: momentum_at(MOMENTS, jnp.asarray(MOMENTUM), t)).lower(1.0).as_text()  # noqa: E731
    with jax.enable_x64(True):
        at_once = text()
        with ph.closed_forms("compiled"):
            compiled = text()
    assert "callback" in at_once and len(at_once.splitlines()) < 100
    assert "callback" not in compiled and len(compiled.splitlines()) > 1000


def test_another_way_is_refused():
    with pytest.raises(InvalidInput, match="`where` must be one of 'host', 'compiled'; got 'gpu'"):
        with ph.closed_forms("gpu"):
            pass


def test_bad_numbers_give_nan_within_compiled_functions():
    with jax.enable_x64(True):
        found = jax.jit(lambda x: momentum_at(MOMENTS, x, 1.0))(jnp.array([np.nan, 1.0, 1.0]))
        negative = jax.jit(lambda x: momentum_at(x, MOMENTUM, 1.0))(jnp.array([-1.0, 1.0, 1.0]))
    assert np.isnan(np.asarray(found)).all() and np.isnan(np.asarray(negative)).all()
