"""u(n), so(p, q) and se(2) are the algebras that they are called."""

import jax.numpy as jnp
import numpy as np
import pytest
from scipy.special import ellipk

import polhode as ph
from polhode import algebra as lie
from polhode.errors import InvalidInput


@pytest.mark.parametrize(("p", "q"), [(3, 0), (2, 1), (3, 1), (2, 2)])
def test_boosts_and_turns_have_other_signs_in_the_killing_form(p, q):
    forms = np.linalg.eigvalsh(lie.killing_form(lie.SOpq(p, q)))
    turns = p * (p - 1) // 2 + q * (q - 1) // 2
    assert ((forms < -1e-9).sum(), (forms > 1e-9).sum()) == (turns, p * q)


def test_a_boost_is_hyperbolic():
    boost = lie.SOpq(1, 1).exp(lie.SOpq(1, 1).from_vector(jnp.array([0.7])))
    assert np.asarray(boost) == pytest.approx(
        np.array([[np.cosh(0.7), np.sinh(0.7)], [np.sinh(0.7), np.cosh(0.7)]]), abs=1e-15
    )


def test_so_of_n_and_zero_is_so_of_n():
    assert lie.SOpq(4, 0).structure_constants() == pytest.approx(lie.SO(4).structure_constants(), abs=1e-15)


def test_unitary_algebras_are_special_ones_and_their_centre():
    assert np.abs(lie.centre(lie.U(3))) == pytest.approx(np.eye(9)[8:])
    constants = lie.U(3).structure_constants()
    assert constants[:8, :8, :8] == pytest.approx(lie.SU(3).structure_constants(), abs=1e-15)


@pytest.mark.long
def test_the_pendulum_lives_on_the_dual_of_se2():
    """θ̈ = −sin θ with P = (cos θ, sin θ): its period is 4 K(sin(θ₀/2))."""
    pendulum = ph.systems.LiePoisson(lie.SE2(), lambda m: 0.5 * m[0] ** 2 - m[1])
    widest = 2.0
    period = 4.0 * ellipk(np.sin(widest / 2.0) ** 2)
    start = [0.0, np.cos(widest), np.sin(widest)]
    run = ph.simulate(pendulum, start, np.linspace(0.0, period, 5), step=0.01, order=8)
    assert run.states[-1] == pytest.approx(np.array(start), abs=1e-11)
    assert run.states[2, 2] == pytest.approx(-np.sin(widest), abs=1e-11)
    assert run.drift["|P|²"] < 2e-15


@pytest.mark.parametrize("make", [lambda: lie.SOpq(1, 0), lambda: lie.SOpq(-1, 4), lambda: lie.U(0)])
def test_sizes_that_are_none(make):
    with pytest.raises(InvalidInput, match="whole number"):
        make()
