"""Invariants and vectors by written lines: those that the system gives, of one state and of many, and who has none."""

from __future__ import annotations

import equinox as eqx
import jax.numpy as jnp
import numpy as np
import pytest

import polhode as ph
from polhode.systems.trajectories import _all_said, _terms
from polhode.taylor import written_values
from polhode.taylor.written_values import WrittenLimits, tell

EPS = float(np.finfo(float).eps)
ROUNDINGS = 16.0  # of the largest term of a sum of ten, whose order differs
MOMENTS = (1.0, 2.0, 3.5)
TOP = ph.systems.HeavyTop(MOMENTS, 1.3, (0.6, 0.0, 0.8))
KOVALEVSKAYA = ph.systems.HeavyTop((2.0, 2.0, 1.0), 1.3, (1.0, 0.0, 0.0))
GORYACHEV_CHAPLYGIN = ph.systems.HeavyTop((4.0, 4.0, 1.0), 1.3, (1.0, 0.0, 0.0))
FREE = ph.systems.FreeRigidBody(MOMENTS)
QUARTIC = ph.systems.LiePoisson(ph.algebra.SO3(), lambda L: jnp.sum(L**4) / 3.0 + jnp.sqrt(1.0 + L[0] ** 2))
INVERSE = ph.systems.LiePoisson(ph.algebra.SO3(), lambda L: 1.0 / L[0])


class Decaying(ph.systems.FreeRigidBody):
    def balances(self, t, state):
        return {"spent": ph.systems.Balance(jnp.sum(state**2, axis=-1), jnp.sum(state, axis=-1))}


DECAYING = Decaying(moments=MOMENTS)  # type: ignore[call-arg]


def make_states(system, count, seed=0):
    """Return motions (2, count, n) of two copies; each state is one that may be."""
    rng = np.random.default_rng(seed)
    if isinstance(system, ph.systems.HeavyTop):
        attitude = rng.normal(size=(2 * count, 4))
        attitude /= np.linalg.norm(attitude, axis=-1, keepdims=True)
        states = np.asarray(system.pack(attitude, rng.normal(size=(2 * count, 3))))
    else:
        states = rng.normal(size=(2 * count, 3))
    return states.reshape(2, count, -1)


@pytest.mark.parametrize("count", [1, 30], ids=["single", "arrays"])
@pytest.mark.parametrize("system", [TOP, KOVALEVSKAYA, FREE, QUARTIC], ids=["top", "Kovalevskaya", "free", "quartic"])
def test_they_are_those_of_the_system(system, count):
    states = make_states(system, count)
    told, said, sizes = tell(system, states), _all_said(system, np.zeros(count), states), _terms(system, states[:, 0])
    assert told is not None and list(told.invariants) == list(said.invariants)
    for name, value in said.invariants.items():
        size = 1.0 + np.abs(value).max()
        np.testing.assert_allclose(told.invariants[name], value, rtol=0.0, atol=ROUNDINGS * EPS * size, err_msg=name)
    assert list(told.sizes) == list(sizes)
    for name, value in sizes.items():
        np.testing.assert_allclose(told.sizes[name], value, rtol=ROUNDINGS * EPS, err_msg=name)
    for one, other in zip(told.vectors, said.vectors, strict=True):
        if other is None:
            assert one is None
        else:
            size = 1.0 + np.abs(other).max()
            np.testing.assert_allclose(np.asarray(one), other, rtol=0.0, atol=ROUNDINGS * EPS * size)


def test_one_state_and_many_have_the_same_bits():
    limits = written_values.LIMITS
    states = make_states(TOP, limits.together // 2 + 300)  # which are taken in two parts
    told = tell(TOP, states)
    assert told is not None
    for k in (0, 1, limits.together // 2 + 299):
        one = tell(TOP, states[:, k : k + 1])
        assert one is not None
        for name, value in told.invariants.items():
            assert np.array_equal(one.invariants[name][:, 0], value[:, k]), name


@pytest.mark.parametrize("more", [0, 1])
def test_the_bits_do_not_depend_on_how_states_are_taken(more):
    count = written_values.LIMITS.max_single + more
    states = make_states(TOP, count)[0]
    told, first = tell(TOP, states), tell(TOP, states[:1])
    assert told is not None and first is not None
    assert told.invariants["energy"][0] == first.invariants["energy"][0]


def test_tops_of_other_numbers_share_the_lines():
    written_values._write.cache_clear()
    for last in (3.5, 3.6, 3.7):
        assert tell(ph.systems.HeavyTop((1.0, 2.0, last), 1.3, (0.6, 0.0, 0.8)), make_states(TOP, 2)) is not None
    assert written_values._write.cache_info().misses == 1


@pytest.mark.parametrize("system", [GORYACHEV_CHAPLYGIN, DECAYING], ids=["a branch", "a balance"])
def test_others_are_left_to_their_own_functions(system):
    assert tell(system, make_states(system, 2)) is None


def test_complex_states_are_left_to_their_own_functions():
    assert tell(FREE, make_states(FREE, 2).astype(complex)) is None


def test_a_division_by_zero_is_left_to_numpy():
    states = make_states(INVERSE, 2)
    assert tell(INVERSE, states) is not None
    states[0, 1, 0] = 0.0
    assert tell(INVERSE, states) is None


@pytest.mark.parametrize("fewer, is_written", [(0, True), (1, False)])
@pytest.mark.parametrize("limit", ["max_numbers", "max_nodes"])
def test_what_is_too_long_is_not_written(monkeypatch, limit, fewer, is_written):
    own = {"max_numbers": 6, "max_nodes": count_nodes(FREE)}[limit]  # two gradients of three numbers
    monkeypatch.setattr(written_values, "LIMITS", WrittenLimits()._replace(**{limit: own - fewer}))
    written_values._write.cache_clear()
    another = eqx.tree_at(lambda body: body.moments, FREE, jnp.array([1.1, 2.0, 3.0]))
    assert (tell(another, make_states(FREE, 2)) is not None) is is_written
    written_values._write.cache_clear()


def count_nodes(system):
    """Return the fewest operations with which the lines of a system are written."""
    fewest = next(count for count in range(1000) if is_written_with(system, count))
    written_values._write.cache_clear()
    return fewest


def is_written_with(system, nodes):
    before = written_values.LIMITS
    written_values._write.cache_clear()
    try:
        written_values.LIMITS = WrittenLimits(max_nodes=nodes)
        another = eqx.tree_at(lambda body: body.moments, system, jnp.array(MOMENTS))
        return tell(another, make_states(system, 2)) is not None
    finally:
        written_values.LIMITS = before


def test_a_trajectory_has_them():
    states = make_states(TOP, 1)[0, 0]
    moved = ph.simulate(TOP, states, np.linspace(0.0, 3.0, 5), estimate_error=False)
    np.testing.assert_allclose(moved.invariants["energy"], TOP.energy(moved.states[:, 4:]), rtol=ROUNDINGS * EPS)
    turning = np.asarray(moved.momentum) / np.array(MOMENTS)
    np.testing.assert_allclose(np.asarray(moved.angular_velocity), turning, rtol=ROUNDINGS * EPS)
    assert 0.0 < moved.drift["energy"] < 1e-14 and moved.drift["linear_space"] < 1e-14
