"""An index beyond its axis, which JAX takes for the nearest one in silence, is refused at every door."""

import diffrax
import jax
import jax.numpy as jnp
import numpy as np
import pytest
from tests.specimens import SYSTEMS, named

import polhode as ph
from polhode import spacecraft, systems
from polhode._base.arrays.traced_checks import check_function
from polhode.errors import InvalidInput
from polhode.spacecraft.systems.control_laws import UserLaw
from polhode.spacecraft.systems.controlled_wheels import ControlTorque
from polhode.spacecraft.torques.lagged import LaggedTorque
from polhode.systems.base import AbstractLiePoissonSystem, AbstractSystem

SE3 = ph.algebra.SE3()
POINT = jnp.arange(1.0, 7.0)
TABLE = jnp.asarray([3, 9, 1])


def energy(m):
    return 0.5 * jnp.sum(m**2)


BEYOND = {
    "m[7]": (lambda m: m[7], 7),
    "m[..., 6]": (lambda m: m[..., 6], 6),
    "m[-7]": (lambda m: m[-7], -7),
    "m[[1, 9]]": (lambda m: m[jnp.array([1, 9])].sum(), 9),
    "a table's entry": (lambda m: m[TABLE[1]], 9),
    "take": (lambda m: jnp.take(m, 7), 7),
    "a number of NumPy": (lambda m: m[np.int64(8)], 8),
    "set": (lambda m: m.at[7].set(1.0), 7),
    "add": (lambda m: m.at[jnp.array([8, 7])].add(1.0), 8),
    "within jit": (lambda m: jax.jit(lambda x, k: x[k])(m, 7), 7),
    "within a loop": (lambda m: jax.lax.fori_loop(0, 3, lambda k, total: total + m[6], 0.0), 6),
    "counted by a loop": (lambda m: jax.lax.fori_loop(0, 8, lambda k, total: total + m[k], 0.0), 6),
    "counted down": (lambda m: jax.lax.fori_loop(0, 8, lambda k, total: total + m[7 - k], 0.0), 7),
    "counted twice": (lambda m: jax.lax.fori_loop(0, 3, lambda j, total: total + jax.lax.fori_loop(
        0, 3, lambda k, part: part + m[j + k + 2], 0.0), 0.0), 6),
    "scanned": (lambda m: jax.lax.scan(lambda total, k: (total + m[k], m[k]), 0.0, jnp.asarray([0, 5, 9]))[0], 9),
    "mapped": (lambda m: jax.vmap(lambda k: m[k])(jnp.arange(8)).sum(), 6),
    "within a branch": (lambda m: jax.lax.cond(m[0] > 0, lambda x: x[9], lambda x: x[0], m), 9),
    "within a derivative": (lambda m: jax.grad(lambda x: x[8] ** 2)(m), 8),
    "a slice that is moved": (lambda m: jax.lax.dynamic_slice(m, (4,), (3,)), 4),
}
WITHIN = {
    "first and last": lambda m: m[0] + m[5] + m[-6] + m[-1],
    "said to be clipped": lambda m: jnp.take(m, 7, mode="clip"),
    "said to be filled": lambda m: m.at[jnp.array([0, 7])].get(mode="fill", fill_value=0.0),
    "some dropped": lambda m: m.at[jnp.array([0, 7])].add(1.0, mode="drop"),
    "Python's slices": lambda m: m[4:9],
    "of the state": lambda m: m[jnp.argmax(m)],
    "carried": lambda m: jax.lax.fori_loop(
        0, 9, lambda k, pair: (pair[0] + m[pair[1]], (pair[1] + 1) % 6), (0.0, 0))[0],
    "mapped": lambda m: jax.vmap(lambda k: m[k])(jnp.arange(6)).sum(),
    "mapped and clipped": lambda m: jax.vmap(lambda k: jnp.take(m, k, mode="clip"))(jnp.arange(8)).sum(),
    "a long loop": lambda m: jax.lax.fori_loop(0, 10**6, lambda k, total: total + m[k % 6], 0.0),
    "counted by a loop": lambda m: jax.lax.fori_loop(0, 6, lambda k, total: total + m[k], 0.0),
    "rolled": lambda m: jnp.roll(m, 2)[::-1],
    "a mask": lambda m: m[np.array([True, False] * 3)],
    "a determinant": lambda m: jnp.linalg.det(jnp.outer(m, m) + jnp.eye(6)),
    "interpolated": lambda m: jnp.interp(m, jnp.arange(3.0), jnp.arange(3.0)),
}


@pytest.mark.parametrize("name", BEYOND)
def test_indices_beyond_are_named(name):
    function, index = BEYOND[name]
    with pytest.raises(InvalidInput, match=rf"element {index} of an axis with 6, which are -6 to 5"):
        check_function("`f`", function, POINT)


@pytest.mark.parametrize("name", WITHIN)
def test_others_pass(name):
    check_function("`f`", WITHIN[name], POINT)


@pytest.mark.parametrize("system", SYSTEMS, ids=named)
def test_systems_of_the_package_pass(system):
    point = jnp.ones(system.algebra.element_shape, system.algebra.dtype)
    check_function("`vector_field`", system.vector_field, 0.0, point)
    check_function("`invariants`", system.invariants, point)


class Own(AbstractSystem):
    def vector_field(self, t, state):
        return state.at[0].set(state[3]) * 1.0

    def invariants(self, state):
        return {}


class OwnLiePoisson(AbstractLiePoissonSystem):
    algebra: ph.algebra.SO3 = ph.algebra.SO3()

    def energy(self, point):
        return 0.5 * jnp.sum(point**2, axis=-1)

    def velocity(self, point):
        return point.at[..., 2].set(point[..., 3])


def wrong(m):
    return energy(m) + m[7]


def good():
    return systems.LiePoisson(SE3, energy)


def in_brackets(t, attitude, velocity, *own):
    return velocity * velocity[..., 3:4].sum() + velocity[..., 3, None]


DOORS = {
    "LiePoisson": lambda: systems.LiePoisson(SE3, wrong),
    "conserved": lambda: systems.LiePoisson(SE3, energy, {"mine": wrong}),
    "BodyInPotential": lambda: systems.BodyInPotential((1.0, 2.0, 3.0), lambda up: up[3]),
    "casimirs of an algebra": lambda: ph.algebra.from_structure_constants(SE3.structure_constants(), casimirs=[wrong]),
    "casimirs of stability": lambda: ph.stability(good(), POINT, casimirs=[wrong]),
    "integrals of stability": lambda: ph.stability(good(), POINT, integrals=[wrong]),
    "bracket": lambda: ph.poisson.bracket(SE3, wrong, energy)(POINT),
    "bracket's second": lambda: ph.poisson.bracket(SE3, energy, wrong)(jnp.ones((2, 6))),
    "hamiltonian_field": lambda: ph.poisson.hamiltonian_field(SE3, wrong)(POINT),
    "torque": lambda: spacecraft.RigidBody((1.0, 2.0, 3.0), torques=[LaggedTorque(in_brackets, 1.0)]),
    "control law": lambda: spacecraft.RigidBody((1.0, 2.0, 3.0), torques=[ControlTorque(UserLaw(in_brackets))]),
    "simulate": lambda: ph.simulate(Own(), np.ones(3), [0.0, 1.0]),
    "simulate by diffrax": lambda: ph.simulate(Own(), np.ones(3), [0.0, 1.0], diffrax.Dopri8()),
    "simulate a subclass": lambda: ph.simulate(OwnLiePoisson(), np.ones(3), [0.0, 1.0]),
    "simulate a damped one": lambda: ph.simulate(systems.DoubleBracketDamping(OwnLiePoisson(), 0.1), np.ones(3),
                                                 [0.0, 1.0]),
    "solve": lambda: ph.solve(Own(), jnp.ones(3), jnp.array([0.0, 1.0])),
    "section": lambda: ph.section(good(), POINT, lambda t, m: m[6], (0.0, 1.0)),
    "check_system": lambda: ph.testing.check_system(OwnLiePoisson()),
    "check_system with states": lambda: ph.testing.check_system(Own(), states=np.ones((2, 3))),
}  # fmt: skip


@pytest.mark.parametrize("door", DOORS)
def test_every_door_refuses_them(door):
    with pytest.raises(InvalidInput, match=r"takes element \d of an axis with [36]"):
        DOORS[door]()


def test_a_function_is_traced_once_for_its_bracket():
    calls = []

    def counted(m):
        calls.append(1)
        return energy(m)

    field = ph.poisson.hamiltonian_field(SE3, counted)
    field(POINT)
    first = len(calls)
    field(POINT)
    assert len(calls) - first == first - 1  # all but the look at its indices
