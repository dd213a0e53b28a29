"""Motions on groups from their motions on the dual: conserved, of fourth order, and those that other programs find."""

import jax.numpy as jnp
import numpy as np
import pytest
from scipy.integrate import solve_ivp

import polhode as ph
from polhode import algebra as lie
from polhode.errors import InvalidInput
from polhode.poisson import reconstruct, reconstruct_group
from specimens import in_su3
from sweeping import first

END = 4.0
WEIGHTS = np.array([[1.0, 2.0], [0.5, 1.5]])


def run(system, start, count):
    return ph.simulate(system, start, np.linspace(0.0, END, count), order=8)


def path(system, start, count):
    found = run(system, start, count)
    return reconstruct_group(system.algebra, found.times, found.states, system.velocity, system.sign)


@pytest.mark.sweep
def test_the_attitude_of_a_body_comes_back():
    body = ph.systems.FreeRigidBody((1.0, 2.0, 3.0))
    start = np.array([0.3, 1.8, 1.5])
    exact = ph.FreeMotion((1.0, 2.0, 3.0), momentum=start).attitude(END)
    assert path(body, start, 401).elements[-1] == pytest.approx(exact, abs=1e-8)
    found = run(body, start, 101)
    other = reconstruct(found.times, found.states, body.velocity)
    assert path(body, start, 101).elements == pytest.approx(np.asarray(other.attitude), abs=1e-5)


MOTIONS = {
    "rigid motions": (ph.systems.Kirchhoff((1.0, 2.0, 3.0, 2.0, 3.0, 5.0)), np.array([0.3, 0.5, 0.2, 0.4, -0.3, 0.6])),
    "right-invariant, su(3)": (ph.systems.LiePoisson(lie.SU(3), in_su3, sign=1), None),
    "Lorentz": (ph.systems.LiePoisson(lie.SOpq(3, 1), lambda m: 0.1 * jnp.sum(m[1] ** 2)), None),
    "a power": (ph.systems.LiePoisson(lie.Power(lie.SO3(), 2), lambda m: m[0] @ m[1] + m[0, 0] ** 2), None),
}


@pytest.mark.sweep
@pytest.mark.parametrize("name", first(1, MOTIONS))
def test_the_momentum_in_space_stays_to_fourth_order(name):
    system, start = MOTIONS[name]
    if start is None:
        numbers = np.random.default_rng(3).normal(size=system.algebra.dim)
        start = np.asarray(system.algebra.from_dual_vector(jnp.asarray(numbers)))
    rough, fine = (float(jnp.max(path(system, start, n).misfit)) for n in (81, 161))
    assert rough < 1e-3
    assert np.log2(rough / fine) == pytest.approx(4.0, abs=0.4)


@pytest.mark.sweep
@pytest.mark.parametrize("sign", [-1, 1])
def test_the_equation_on_the_group_is_solved(sign):
    """ġ = g dH, or dH g, beside μ̇, by SciPy."""
    algebra = lie.SL(2)
    system = ph.systems.LiePoisson(algebra, lambda m: 0.5 * jnp.sum(WEIGHTS * m**2), sign=sign)
    start = np.array([[0.4, 0.2], [-0.5, -0.4]])

    def slope(t, y):
        g, mu = y[:4].reshape(2, 2), y[4:].reshape(2, 2)
        dH = np.asarray(system.velocity(jnp.asarray(mu)))
        rate = np.asarray(system.vector_field(0.0, jnp.asarray(mu)))
        return np.concatenate([(g @ dH if sign == -1 else dH @ g).ravel(), rate.ravel()])

    peer = solve_ivp(slope, (0.0, END), np.concatenate([np.eye(2).ravel(), start.ravel()]), "DOP853", rtol=1e-11,
                     atol=1e-12).y[:4, -1]  # fmt: skip
    found = path(system, start, 401)
    assert np.asarray(found.elements[-1]).ravel() == pytest.approx(peer, rel=1e-7, abs=1e-7)
    wrong = reconstruct_group(algebra, *_samples(system, start), system.velocity, -sign)
    assert float(wrong.misfit[-1]) > 1e-2


def _samples(system, start):
    found = run(system, start, 41)
    return found.times, found.states


def test_shapes_and_times_are_checked():
    algebra, still = lie.SE2(), np.ones((3, 3))
    for times, points, sign, said in [
        ([0.0], still[:1], -1, "T at least 2"), ([0.0, 1.0], still, -1, "must match"),
        ([0.0, 1.0, 1.0], still, -1, "advance"), ([0.0, 1.0, 2.0], still, 2, "`sign`"),
    ]:  # fmt: skip
        with pytest.raises(InvalidInput, match=said):
            reconstruct_group(algebra, times, points, lambda m: m, sign)
