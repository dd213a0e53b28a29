"""A Hamiltonian as data: what is compiled serves again, and methods can be jitted."""

import re
from typing import Any

import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np
import pytest

import polhode as ph
from polhode import algebra as lie
from polhode import fields, systems
from polhode.errors import InvalidInput
from polhode.integrators import LieMidpoint
from polhode.integrators import _equal_steps as equal_steps
from polhode.systems import LiePoisson
from specimens import ALGEBRAS, SYSTEMS, named

MOMENTUM = np.array([0.3, 1.8, 1.5])
TIMES = [0.0, 1.0]


def kinetic(moments, L):
    return 0.5 * jnp.sum(L**2 / moments)


def as_bound(moments):
    return jax.tree_util.Partial(kinetic, jnp.asarray(moments))


class Kinetic(eqx.Module):
    moments: jax.Array

    def __call__(self, L):
        return kinetic(self.moments, L)


def as_module(moments):
    return Kinetic(jnp.asarray(moments))


def as_closure(moments):
    return lambda L: kinetic(jnp.asarray(moments), L)


def compiled() -> int:
    run: Any = equal_steps._go_one
    return run._cached._cache_size()


def move(hamiltonian):
    return ph.simulate(LiePoisson(lie.SO3(), hamiltonian), MOMENTUM, TIMES, order=2, step=0.01).states[-1]


@pytest.mark.long_cases("as_bound", "as_module")
@pytest.mark.parametrize("made", [as_bound, as_module, as_closure])
def test_parameters_are_data(made):
    ends, counts = [], []
    for moments in ((1.0, 2.0, 3.0), (1.0, 2.0, 2.5)):
        before = compiled()
        ends.append(move(made(moments)))
        counts.append(compiled() - before)
        exact = ph.FreeMotion(moments, momentum=MOMENTUM).momentum(1.0)
        assert np.abs(ends[-1] - exact).max() < 1e-4
    assert counts == [1, 0]


def test_methods_can_be_jitted():
    body = LiePoisson(lie.SO3(), as_closure((1.0, 2.0, 3.0)), {"same": as_closure((1.0, 2.0, 3.0))})
    want = np.cross(MOMENTUM, MOMENTUM / np.array([1.0, 2.0, 3.0]))
    assert np.abs(jax.jit(body.vector_field)(0.0, jnp.asarray(MOMENTUM)) - want).max() < 1e-15
    free = ph.systems.FreeRigidBody((1.0, 2.0, 3.0))
    assert np.abs(jax.jit(free.vector_field)(0.0, jnp.asarray(MOMENTUM)) - want).max() < 1e-15
    own = lie.from_structure_constants(lie.SO3().structure_constants())
    x, y = jnp.array([1.0, 0.0, 0.0]), jnp.array([0.0, 1.0, 0.0])
    assert jax.jit(own.bracket)(x, y).tolist() == [0.0, 0.0, 1.0]


@pytest.mark.parametrize("specimen", [*SYSTEMS, *ALGEBRAS], ids=named)
def test_every_system_and_algebra_has_the_hash_of_its_contents(specimen):
    leaves, structure = jax.tree.flatten(specimen)
    again = jax.tree.unflatten(structure, [jnp.array(x) if eqx.is_array(x) else x for x in leaves])
    assert hash(again) == hash(specimen)


def test_other_moments_have_another_hash():
    assert hash(ph.systems.FreeRigidBody((1.0, 2.0, 3.0))) != hash(ph.systems.FreeRigidBody((1.0, 2.0, 2.5)))


def test_systems_are_equal_where_their_numbers_have_the_same_bits():
    with_zero, with_minus, unknown, too = (LiePoisson(lie.SO3(), as_bound(x)) for x in (0.0, -0.0, np.nan, np.nan))
    assert with_zero != with_minus and hash(with_zero) != hash(with_minus)
    assert unknown == unknown and unknown == too and hash(unknown) == hash(too)
    assert with_zero == LiePoisson(lie.SO3(), as_bound(0.0)) != with_minus
    assert with_zero != unknown and with_zero != LiePoisson(lie.SO3(), as_bound([0.0]))


def test_traced_systems_are_compared_by_jax():
    def compare(value):
        return LiePoisson(lie.SO3(), as_bound(value)) == LiePoisson(lie.SO3(), as_bound(2.0))

    assert [bool(jax.jit(compare)(value)) for value in (2.0, 3.0)] == [True, False]


@pytest.mark.parametrize("method", [None, LieMidpoint])
def test_a_gradient_that_is_no_number_at_the_start_is_named(method):
    system = LiePoisson(lie.SO3(), lambda L: jnp.sqrt(L[0] - 1.0))
    words = r"`velocity`, the gradient of the energy, of LiePoisson must be finite at the start; got \[nan, 0.0, 0.0\]"
    with pytest.raises(InvalidInput, match=words):
        ph.simulate(system, MOMENTUM, TIMES, method)


@pytest.mark.parametrize("algebra", [each for each in ALGEBRAS if each.element_rule], ids=lambda each: each.name)
def test_states_off_the_dual_are_refused(algebra):
    """Alone and in a batch; what is rounded to single precision, or to eight digits, passes."""
    rng = np.random.default_rng(3)
    system = LiePoisson(algebra, lambda mu: jnp.sum(jnp.abs(mu) ** 2))
    states = np.asarray(algebra.from_dual_vector(jnp.asarray(rng.normal(size=(2, algebra.dim)))))
    single = states.astype("complex64" if np.iscomplexobj(states) else "float32").astype(states.dtype)
    for fine in (states, single, np.round(states, 8), 1e300 * states, 1e-300 * states, 0.0 * states):
        np.testing.assert_array_equal(system.check_state(fine), fine)
    wrong = rng.normal(size=states.shape) + (1j * rng.normal(size=states.shape) if np.iscomplexobj(states) else 0.0)
    np.testing.assert_allclose(system.check_state(algebra.project(jnp.asarray(wrong))), algebra.project(wrong))
    for off in (wrong[0], np.stack([states[0], wrong[1]]), states[0] + 1e-4 * wrong[0]):
        with pytest.raises(InvalidInput, match=r"off by [\d.e-]+ of the largest. Take the part there by") as found:
            system.check_state(off)
        assert algebra.element_rule in str(found.value) and algebra.name in str(found.value)


@pytest.mark.parametrize(
    ("system", "shape"), [(systems.Manakov((1.0, 2.0, 3.0, 4.0)), (4, 4)), (fields.SphereFluid(5), (5, 5))]
)
def test_motions_of_matrices_start_on_the_dual(system, shape):
    with pytest.raises(InvalidInput, match=f"must lie on the dual of {re.escape(system.algebra.name)}"):
        ph.simulate(system, np.random.default_rng(0).normal(size=shape), [0.0, 3.0])
