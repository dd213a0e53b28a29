"""Every system obeys its laws, and broken ones are caught."""

import jax.numpy as jnp
import numpy as np
import pytest

from polhode.celestial import SpinOrbit
from polhode.errors import InvalidInput
from polhode.rolling import EulerDisk
from polhode.spacecraft import EnergySink, RigidBody, TorquedBody
from polhode.spacecraft.torques import LinearDrag
from polhode.systems import DoubleBracket, FreeRigidBody, LiePoisson, Manakov
from polhode.systems.base import Balance
from polhode.testing import LawBroken, check_system
from specimens import SYSTEMS, named
from sweeping import first


def some_at_once(systems):
    """A body with losses, matrices, and a user's own; others, compiled for longer, in the sweep."""
    chosen = [next(s for s in systems if type(s) is kind) for kind in (DoubleBracket, Manakov, LiePoisson)]
    return [pytest.param(system, marks=[] if any(system is s for s in chosen) else [pytest.mark.sweep])
            for system in systems]  # fmt: skip


@pytest.mark.long_after(1)
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


SLEWED = np.array([[1.0, 0.0, 0.0, 0.0, 0.3, 1.8, 1.5], [0.0, 0.6, 0.8, 0.0, 1.0, -0.2, 0.4]])
OTHERS = [
    (SpinOrbit(0.89, 0.4), [[0.3, 1.0], [1.0, -0.5]]),
    (TorquedBody((1.0, 2.0, 2.5), [LinearDrag((0.1, 0.2, 0.3))]), SLEWED),
    (RigidBody((1.0, 2.0, 2.5), [EnergySink(0.1)]), SLEWED),
    (EulerDisk(0.4, 0.04, 0.01), [[0.4, 0.3, 0.2, 0.01, 0.02, 0.1, 6.0, 1.0]]),
]


@pytest.mark.long
@pytest.mark.parametrize(("system", "states"), first(2, OTHERS), ids=lambda x: type(x).__name__)
def test_what_is_no_lie_poisson_system_is_checked_at_states_that_are_given(system, states):
    check_system(system, states=states)
    with pytest.raises(InvalidInput, match=f"`states` must be given for {type(system).__name__}"):
        check_system(system)


class WrongGrowth(SpinOrbit):
    def balances(self, t, state):
        found = super().balances(t, state)["energy_per_moment"]
        return {"energy_per_moment": Balance(found.value, found.rate * (1.0 + 1e-9))}


class Unbatched(SpinOrbit):
    def vector_field(self, t, state):
        return super().vector_field(t, state) * jnp.sum(state)


@pytest.mark.long_cases("WrongGrowth-balance tells")
@pytest.mark.parametrize(("broken", "law"), [(WrongGrowth, "balance tells"), (Unbatched, "batch = loop")])
def test_broken_specimens_of_other_systems_are_caught(broken, law):
    with pytest.raises(LawBroken, match=law):
        check_system(broken(0.89, 0.4), states=OTHERS[0][1])


@pytest.mark.usefixtures("any_type")
def test_what_check_system_cannot_take_is_refused_in_words():
    body = FreeRigidBody((1.0, 2.0, 3.0))
    for call, words in (
        (lambda: check_system(3), "`system` must be"),
        (lambda: check_system(body, np.ones(3)), "`seed` must be"),
        (lambda: check_system(body, states=[1.0, 2.0, 3.0]), "several states"),
        (lambda: check_system(SpinOrbit(0.89, 0.4), states=[[1.0, 2.0, 3.0]]), r"shape \(…, 2\)"),
    ):
        with pytest.raises(InvalidInput, match=words):
            call()
