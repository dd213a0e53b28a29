"""Functions that are compiled for a few calls: what they give, and which compiler's options they take."""

import jax
import jax.numpy as jnp
import numpy as np
import pytest

import polhode.systems  # noqa: F401, switches JAX to 64 bits
from polhode._base.arrays import compiled_for_few_calls, few_calls
from polhode._base.arrays.gathering import gather

X = np.linspace(0.3, 1.7, 5)


def norms(x, power):
    return {"sum": jnp.sum(jnp.sin(x) ** power), "all": jnp.cumsum(x), "none": None}


@pytest.fixture
def compiled_with(monkeypatch):
    """Record the options with which XLA compiles."""
    from jax._src import compiler

    options, compile_one = [], compiler.backend_compile_and_load

    def recorded(backend, module, devices, given, *args, **kwargs):
        options.append(given.env_option_overrides)
        return compile_one(backend, module, devices, given, *args, **kwargs)

    monkeypatch.setattr(compiler, "backend_compile_and_load", recorded)
    return options


def test_values_are_those_of_the_function():
    values, wanted = compiled_for_few_calls(norms)(X, 3), norms(jnp.asarray(X), 3)
    assert values["none"] is None
    for name in ("sum", "all"):
        np.testing.assert_allclose(values[name], wanted[name], rtol=1e-14)


@pytest.mark.parametrize("size, quickly", [(5, True), (few_calls.LIMITS.max_numbers + 1, False)])
def test_options_are_taken_for_few_numbers(compiled_with, size, quickly):
    compiled_for_few_calls(lambda x: jnp.sort(x) * 3.25)(np.ones(size))
    taken = dict(compiled_with[-1])
    assert taken == (few_calls.quick_options() if quickly else {})


def test_options_that_a_release_of_xla_does_not_know_are_left_out(compiled_with, monkeypatch):
    known = next(iter(few_calls.quick_options()), None)
    if known is None:
        pytest.skip("on a GPU nothing is compiled quickly")
    monkeypatch.setattr(few_calls, "QUICKLY", {"xla_of_another_release": True, known: few_calls.QUICKLY[known]})
    few_calls.quick_options.cache_clear()
    try:
        compiled_for_few_calls(lambda x: jnp.sort(x) * 4.25)(X)
    finally:
        few_calls.quick_options.cache_clear()
    assert dict(compiled_with[-1]) == {known: few_calls.QUICKLY[known]}


def test_what_numpy_has_is_not_compiled(compiled_with):
    function = compiled_for_few_calls(lambda x, k, name: {"y": jnp.tanh(x) * k, name: None})
    for k in (5.25, 3, True, 1):  # the last two are equal, and are not the same
        found = function(X, k, "none")
        np.testing.assert_allclose(found["y"], np.tanh(X) * k, rtol=1e-15)
        assert isinstance(found["y"], jax.Array) and found["none"] is None
    assert not compiled_with
    many = function(np.ones(few_calls.LIMITS.max_numbers + 1), 2.0, "none")["y"]
    np.testing.assert_allclose(many, np.tanh(1.0) * 2.0, rtol=1e-15)
    assert compiled_with


def test_it_is_a_part_of_what_is_traced():
    function = compiled_for_few_calls(lambda x: jnp.sum(x**3))
    np.testing.assert_allclose(jax.jit(jax.grad(function))(X), 3.0 * X**2, rtol=1e-14)
    np.testing.assert_allclose(jax.vmap(function)(X[:, None]), X**3, rtol=1e-14)


def test_derivatives_and_batches_go_through_it():
    """JAX refuses options of the compiler where it differentiates, outside of any compiled function too."""
    total = compiled_for_few_calls(lambda x: jnp.sum(jnp.sin(x) ** 2))
    x = jnp.asarray(X)
    assert np.asarray(jax.grad(total)(x)) == pytest.approx(np.sin(2.0 * X), abs=1e-15)
    assert float(jax.jvp(total, (x,), (x,))[1]) == pytest.approx(float(X @ np.sin(2.0 * X)), rel=1e-14)
    assert jax.vmap(total)(jnp.stack([x, x])).shape == (2,)


def test_a_result_is_no_view_of_an_argument():
    x = np.ones(1000)
    (same,) = compiled_for_few_calls(lambda x: (jax.lax.stop_gradient(x),))(x)
    x[:] = 2.0
    assert float(same[0]) == 1.0


def test_constants_that_are_not_finite_are_taken_quietly():
    found = compiled_for_few_calls(lambda x: x + jnp.log(jnp.zeros(())) / jnp.ones(()))(X)
    assert np.isneginf(found).all()


def test_a_single_number_of_any_type_is_gathered_as_an_array():
    """Of older JAX, which writes an index as this; an array of objects gave the object itself."""
    numbers = jax.lax.GatherDimensionNumbers((), (0, 1), (0, 1))
    array, mode = np.array([[None, "here"]], object), jax.lax.GatherScatterMode.PROMISE_IN_BOUNDS
    parameters = {"dimension_numbers": numbers, "slice_sizes": (1, 1), "mode": mode, "fill_value": None}
    found = gather([array, np.array([0, 1], np.int32)], parameters)
    assert found.shape == () and found[()] == "here"
