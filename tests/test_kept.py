"""What is kept of an object: once for each that cannot change, as long as it lives, and not more than there is room."""

import copy
import gc

import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np
import pytest

import polhode as ph
from polhode._base import kept
from polhode._base.kept import is_kept, kept_of_object

asked: list[int] = []


class Disk(eqx.Module):
    moments: jax.Array | np.ndarray
    marks: dict[str, float] = eqx.field(default_factory=dict)


@kept_of_object
def total(disk, factor):
    asked.append(factor)
    return factor * sum(disk.moments)


@pytest.fixture(autouse=True)
def nothing_asked():
    asked.clear()


def asks(disk, factors=(1, 1)):
    """Return how many times a function ran."""
    for factor in factors:
        assert total(disk, factor) == factor * 3.0
    return len(asked)


def test_each_question_is_asked_once():
    assert asks(Disk(jnp.array([1.0, 2.0])), (1, 1, 2, 1, 2)) == 2


def test_another_object_is_asked_again():
    asks(Disk(jnp.array([1.0, 2.0])))
    assert asks(Disk(jnp.array([1.0, 2.0]))) == 2


@pytest.mark.parametrize("writeable, times", [(False, 1), (True, 2)])
def test_numbers_that_can_be_written_to_are_looked_at_each_time(writeable, times):
    moments = np.array([1.0, 2.0])
    moments.flags.writeable = writeable
    assert asks(Disk(moments)) == times


@pytest.mark.parametrize("marks, times", [({}, 1), ({"a": 1.0}, 2)])
def test_a_dictionary_may_change(marks, times):
    assert asks(Disk(jnp.array([1.0, 2.0]), marks)) == times


def test_traced_numbers_are_not_kept():
    def function(x):
        disk = Disk(x)
        value = total(disk, 1)
        assert not is_kept(disk)
        return value

    assert float(jax.jit(function)(jnp.array([1.0, 2.0]))) == 3.0
    assert jax.grad(function)(jnp.array([1.0, 2.0])).tolist() == [1.0, 1.0]


def test_nothing_is_kept_of_what_is_gone():
    gc.collect()  # what other tests have left
    disk, before = Disk(jnp.array([1.0, 2.0])), len(kept._kept)
    asks(disk)
    assert is_kept(disk) and len(kept._kept) == before + 1
    del disk
    gc.collect()
    assert len(kept._kept) == before


def test_objects_and_answers_have_a_limit(monkeypatch):
    monkeypatch.setattr(kept, "LIMITS", kept.KeptLimits(max_objects=2, max_answers=2))
    disks = [Disk(jnp.array([1.0, 2.0])) for _ in range(3)]
    for disk in disks:
        asks(disk)
    assert [is_kept(disk) for disk in disks] == [False, True, True]
    asked.clear()
    assert asks(disks[2], (1, 2, 1)) == 1
    assert asks(disks[2], (3, 1)) == 3  # a third answer drops the others


def test_a_copy_of_a_system_is_a_system_of_its_own():
    top = ph.systems.HeavyTop((1.0, 2.0, 3.5), 1.3, (0.6, 0.0, 0.8))
    state = top.pack((1.0, 0.0, 0.0, 0.0), (0.3, 1.0, 0.1))
    one = ph.simulate(top, state, [0.0, 1.0], estimate_error=False)
    heavier = eqx.tree_at(lambda each: each.mgl, copy.deepcopy(top), jnp.asarray(2.6))
    other = ph.simulate(heavier, state, [0.0, 1.0], estimate_error=False)
    assert np.abs(one.states[-1] - other.states[-1]).max() > 0.1
    assert float(other.invariants["energy"][0] - one.invariants["energy"][0]) == pytest.approx(1.3 * 0.8)
