"""Users' functions that call NumPy on what JAX traces end in one message that says to use jax.numpy."""

from types import FunctionType
from typing import Any

import jax.numpy as jnp
import numpy as np
import pytest

import polhode as ph
from polhode import algebra as lie
from polhode import spacecraft, systems
from polhode.errors import InvalidInput
from polhode.spacecraft.torques import AbstractTorque

SO3 = ph.algebra.SO3()


class Torque(AbstractTorque):
    def torque(self, t: Any, attitude: Any, angular_velocity: Any, actuator: Any = None) -> Any:
        return -0.1 * np.asarray(angular_velocity)


class Branching(AbstractTorque):
    def torque(self, t: Any, attitude: Any, angular_velocity: Any, actuator: Any = None) -> Any:
        return -angular_velocity if angular_velocity[2] > 1.0 else angular_velocity


class Field(systems.AbstractSystem):
    def vector_field(self, t: Any, state: Any) -> Any:
        return np.sin(state)

    def invariants(self, state: Any) -> dict[str, Any]:
        return {}


class Invariants(Field):
    def vector_field(self, t: Any, state: Any) -> Any:
        return -state

    def invariants(self, state: Any) -> dict[str, Any]:
        return {"first": np.asarray(state)[..., 0]}


class Energy(systems.FreeRigidBody):
    def energy(self, point: Any) -> Any:
        return 0.5 * np.sum(np.asarray(point) ** 2, axis=-1)


def square(x):
    return 0.5 * np.sum(np.asarray(x) ** 2)


MOMENTS, LAST = (1.0, 2.0, 3.0), [0.0, 1.0]
WITH_ENERGY: Any = Energy
CALLS = {
    "a Hamiltonian": lambda: systems.LiePoisson(SO3, square),
    "a Hamiltonian with float": lambda: systems.LiePoisson(SO3, lambda L: float(L[0])),
    "a Hamiltonian with if": lambda: systems.LiePoisson(SO3, lambda L: L[0] if L[0] > 0 else -L[0]),
    "an integral": lambda: ph.stability(systems.FreeRigidBody(MOMENTS), (0, 0, 1), integrals=[square]),
    "a Casimir": lambda: ph.stability(systems.FreeRigidBody(MOMENTS), (0, 0, 1), casimirs=[square]),
    "a potential": lambda: systems.BodyInPotential(MOMENTS, square),
    "a torque": lambda: ph.simulate(spacecraft.TorquedBody(MOMENTS, [Torque()]), (0, 0, 1.0), LAST),
    "a torque with if": lambda: ph.simulate(spacecraft.TorquedBody(MOMENTS, [Branching()]), (0, 0, 1.0), LAST),
    "a field": lambda: ph.simulate(Field(), (0.3, 1.0), LAST),
    "an invariant": lambda: ph.simulate(Invariants(), (0.3, 1.0), LAST),
    "an energy": lambda: ph.simulate(WITH_ENERGY(MOMENTS), (0.3, 1.0, 1.0), LAST),
    "an energy judged": lambda: ph.stability(WITH_ENERGY(MOMENTS), (0, 0, 1.0)),
    "a bracket": lambda: ph.poisson.bracket(SO3, square, lambda x: x[0])(np.ones(3)),
    "a Hamiltonian field": lambda: ph.poisson.hamiltonian_field(SO3, square)(np.ones(3)),
}


@pytest.mark.parametrize("name", CALLS)
@pytest.mark.usefixtures("any_type")
def test_the_message_says_to_use_jax_numpy(name):
    with pytest.raises(InvalidInput, match=r"must be written with jax\.numpy") as caught:
        CALLS[name]()
    assert "Tracer" not in str(caught.value) and "docs.jax.dev" not in str(caught.value)


class Careless(lie.AbstractLieAlgebra):
    """An algebra of polhode's own, to JAX: its code is this package's, and calls NumPy on what is traced."""

    table: Any

    @property
    def dim(self):
        return 3

    def bracket(self, x: Any, y: Any) -> Any:
        return jnp.cross(x, y)

    def coadjoint(self, x: Any, mu: Any) -> Any:
        return jnp.cross(mu, x)

    rate = FunctionType(
        compile("lambda self, x: np.abs(self.table).max()", "polhode/algebra/careless.py", "eval").co_consts[0],
        {"np": np, "__name__": "polhode.algebra.careless"},
    )


def test_a_fault_of_ours_is_not_blamed_on_a_right_hamiltonian():
    """So were algebras of one's own refused: "must be written with jax.numpy", which the Hamiltonian was."""
    system = systems.LiePoisson(Careless(np.ones(3)), lambda m: 0.5 * jnp.sum(m**2 / jnp.arange(1.0, 4.0)))
    with pytest.raises(InvalidInput, match=r"at polhode/algebra/careless\.py, line 1.*please report it") as caught:
        ph.simulate(system, (0.3, 1.8, 1.5), LAST, ph.integrators.LieMidpoint)
    assert "must be written" not in str(caught.value)
