"""A user's function that computes in single precision within is refused, though what it returns is float64.

A torque of float32 numbers gave a motion of seven digits that was called successful; a Hamiltonian was refused.
"""

import jax.numpy as jnp
import numpy as np
import pytest

import polhode as ph
from polhode import spacecraft, systems
from polhode.errors import InvalidInput
from polhode.systems.base import AbstractSystem

SO3, BODY = ph.algebra.SO3(), systems.FreeRigidBody((1.0, 2.0, 3.0))
POINT = (0.3, 0.4, 0.5)


def energy(m):
    return 0.5 * jnp.sum(m**2)


def rounded(x):
    """Return numbers as float64, after they were float32."""
    return jnp.asarray(jnp.asarray(x, jnp.float32), float)


class Drag(spacecraft.AbstractTorque):
    """A torque that rounds the rate of turning."""

    def torque(self, t, attitude, angular_velocity, actuator=None):
        return -0.1 * rounded(angular_velocity)


class Own(AbstractSystem):
    """A system of one's own whose rates are rounded."""

    def vector_field(self, t, state):
        return -rounded(state)

    def invariants(self, state):
        return {}


DOORS = {
    "Hamiltonian": lambda: systems.LiePoisson(SO3, lambda m: energy(rounded(m))),
    "potential": lambda: systems.BodyInPotential((1.0, 2.0, 3.0), lambda up: rounded(up)[2]),
    "integral": lambda: ph.stability(BODY, (0.0, 0.0, 1.0), integrals=[lambda m: energy(rounded(m))]),
    "torque": lambda: spacecraft.RigidBody((1.0, 2.0, 2.5), [], [Drag()]),
    "motor": lambda: spacecraft.RigidBody(
        (1.0, 2.0, 2.5), [spacecraft.Wheel((1, 0, 0), 0.1, lambda t, *_: rounded(t))]),
    "bracket": lambda: ph.poisson.bracket(SO3, energy, lambda m: energy(rounded(m)))(jnp.asarray(POINT)),
    "simulate": lambda: ph.simulate(Own(), np.ones(3), [0.0, 1.0]),
    "solve": lambda: ph.solve(Own(), jnp.ones(3), jnp.array([0.0, 1.0])),
    "section": lambda: ph.section(BODY, POINT, lambda t, m: rounded(m)[1], (0.0, 1.0)),
}


@pytest.mark.usefixtures("any_type")
@pytest.mark.parametrize("door", DOORS)
def test_it_is_refused(door):
    with pytest.raises(InvalidInput, match="computes in single precision"):
        DOORS[door]()


def test_numbers_of_other_types_are_no_digits_lost():
    """Whole numbers and truth values are exact."""
    system = systems.LiePoisson(SO3, lambda m: energy(m) + jnp.sum(jnp.arange(3) * m) + jnp.where(m[0] > 0, 1, 0))
    assert np.isfinite(system.energy(jnp.asarray(POINT)))
