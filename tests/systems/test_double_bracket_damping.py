"""Any system damped along its orbit: the body's double bracket, energies that fall as told, and where they end."""

import jax
import jax.numpy as jnp
import numpy as np
import pytest

import polhode as ph
from polhode import algebra as lie
from polhode.errors import InvalidInput
from polhode.systems import DoubleBracket, DoubleBracketDamping, FreeRigidBody, HeavyTop, LiePoisson, Manakov
from specimens import in_su3
from sweeping import first

MOMENTS = (1.0, 2.0, 3.0)
SYSTEMS = {
    "so(4)": Manakov((1.0, 2.0, 3.0, 4.0)),
    "se(3)": HeavyTop(MOMENTS, 0.7, (1.0, 2.0, 0.5)),
    "su(3), right-invariant": LiePoisson(lie.SU(3), in_su3, sign=1),
    "two spins": LiePoisson(lie.Power(lie.SO3(), 2), lambda m: -(m[0] @ m[1]) - 0.3 * m[0, 2] ** 2),
    "so(3, 1)": LiePoisson(lie.SOpq(3, 1), lambda m: 0.1 * jnp.sum(m**2)),
}


def start_of(system):
    numbers = np.random.default_rng(5).normal(size=system.algebra.dim)
    return system.algebra.from_dual_vector(jnp.asarray(numbers))


def test_of_a_body_it_is_the_double_bracket():
    point = jnp.array([0.3, 1.8, 1.5])
    ours, body = DoubleBracketDamping(FreeRigidBody(MOMENTS), 0.3), DoubleBracket(MOMENTS, 0.3)
    assert ours.generator(0.0, point) == pytest.approx(np.asarray(body.generator(0.0, point)), abs=1e-15)


@pytest.mark.long
@pytest.mark.parametrize("name", first(2, SYSTEMS))
def test_the_energy_falls_as_told_and_the_orbit_stays(name):
    metric = None if name != "so(4)" else np.diag(np.arange(1.0, 7.0)) + 0.1
    system = DoubleBracketDamping(SYSTEMS[name], 0.2, metric)
    point = start_of(system)
    field = system.vector_field(0.0, point)
    told = system.balances(0.0, point)["energy"].rate
    assert jax.jvp(system.energy, (point,), (field,))[1] == pytest.approx(float(told), rel=1e-12)
    assert float(told) < 0.0
    run = ph.simulate(system, point, np.linspace(0.0, 5.0, 51), step=0.01, order=2, estimate_error=False)
    assert np.all(np.diff(np.asarray(system.energy(run.states))) < 0.0)
    assert all(np.max(drift) < 1e-14 for drift in run.drift.values()), run.drift


def test_a_damping_of_the_wrong_sign_is_seen():
    class Fed(DoubleBracketDamping):
        def _raise_index(self, dual):
            return -super()._raise_index(dual)

    system = Fed(SYSTEMS["so(4)"], 0.2)
    assert float(system.balances(0.0, start_of(system))["energy"].rate) > 0.0


@pytest.mark.long
def test_most_starts_end_where_the_energy_is_least():
    """A body about its axis of largest moment; two ferromagnetic spins parallel along the easy axis."""
    body = DoubleBracketDamping(FreeRigidBody(MOMENTS), 0.5)
    end = ph.solve(body, [0.3, 1.8, 1.5], [0.0, 60.0], save=1).end_state
    assert np.abs(np.asarray(end)[:2]).max() < 1e-6
    spins = DoubleBracketDamping(SYSTEMS["two spins"], 0.5)
    start = np.array([[0.6, 0.0, 0.8], [-0.8, 0.6, 0.0]])
    end = np.asarray(ph.solve(spins, start, [0.0, 120.0], save=1).end_state)
    assert np.abs(end) == pytest.approx(np.array([[0.0, 0.0, 1.0]] * 2), abs=1e-5)


@pytest.mark.parametrize(
    ("system", "rate", "metric", "said"),
    [
        (DoubleBracket(MOMENTS, 0.3), 0.1, None, "keeps its energy"), (FreeRigidBody(MOMENTS), -0.1, None, "`rate`"),
        (FreeRigidBody(MOMENTS), np.nan, None, "`rate`"), (FreeRigidBody(MOMENTS), 0.1, np.eye(2), "shape"),
        (FreeRigidBody(MOMENTS), 0.1, np.diag([1.0, 1.0, -1.0]), "positive definite"),
    ],
)  # fmt: skip
def test_what_is_refused(system, rate, metric, said):
    with pytest.raises(InvalidInput, match=said):
        DoubleBracketDamping(system, rate, metric)
