"""Every system obeys its laws, and broken ones are caught."""

import jax.numpy as jnp
import pytest

from polhode.systems import DoubleBracket, FreeRigidBody, Gyrostat, LiePoisson, Manakov
from polhode.testing import LawBroken, check_system
from specimens import SYSTEMS, named


def some_at_once(systems):
    """A body with a rotor, one with losses, matrices, and a user's own; others, compiled for longer, in the sweep."""
    chosen = [next(s for s in systems if type(s) is kind) for kind in (Gyrostat, DoubleBracket, Manakov, LiePoisson)]
    return [pytest.param(system, marks=[] if any(system is s for s in chosen) else [pytest.mark.sweep])
            for system in systems]  # fmt: skip


@pytest.mark.parametrize("system", some_at_once(SYSTEMS), ids=named)
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
