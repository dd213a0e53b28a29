"""Every system obeys its laws, and broken ones are caught."""

import jax.numpy as jnp
import pytest

from polhode.systems import BodyInPotential, BrunBody, FreeRigidBody, Kirchhoff
from polhode.testing import LawBroken, check_system
from specimens import SYSTEMS, named


def one_of_each(systems):
    """The first of each class that is compiled in a few seconds; the others in the sweep."""
    classes = [BodyInPotential, BrunBody, Kirchhoff, *map(type, systems)]
    return [pytest.param(system, marks=[pytest.mark.sweep] if type(system) in classes[: k + 3] else [])
            for k, system in enumerate(systems)]  # fmt: skip


@pytest.mark.parametrize("system", one_of_each(SYSTEMS), ids=named)
def test_laws(system):
    check_system(system)


class WrongVelocity(FreeRigidBody):
    def velocity(self, point):
        return point / self.moments * (1.0 + 1e-9)


class WrongFlow(FreeRigidBody):
    @property
    def flows(self):
        flows = super().flows
        name, first = next(iter(flows.items()))
        return flows | {name: lambda t, s: first(-t, s)}


class WrongInvariant(FreeRigidBody):
    @property
    def extra_invariants(self):
        return {"L1": lambda point: point[..., 0]}


class NotAFlow(FreeRigidBody):
    @property
    def flows(self):
        parts = super().flows
        return {"all": lambda t, s: tuple(map(sum, zip(*(f(t, s) for f in parts.values()), strict=True)))}


@pytest.mark.parametrize(
    ("broken", "law"),
    [(WrongVelocity, "velocity"), (WrongFlow, "add up"), (WrongInvariant, "L1"), (NotAFlow, "two halves")],
)
def test_broken_specimens_are_caught(broken, law):
    with pytest.raises(LawBroken, match=law):
        check_system(broken((1.0, 2.0, 3.0)))


def test_batches_do_not_mix():
    body = FreeRigidBody((1.0, 2.0, 3.0))
    states = jnp.array([[1.0, 2.0, 3.0], [jnp.nan, 0.0, 0.0]])
    assert jnp.isfinite(body.vector_field(0.0, states)[0]).all()
