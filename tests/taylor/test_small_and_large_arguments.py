"""Functions that vanish with their argument keep its digits, and those that end at one survive any size of it."""

import jax.numpy as jnp
import mpmath
import numpy as np
import pytest

import polhode as ph
from polhode.integrators import Taylor
from polhode.taylor import tracing
from polhode.taylor.elementary import exponential, logarithm


class Scalar(ph.systems.AbstractSystem):
    rate: object

    def vector_field(self, t, state):
        return self.rate(state)

    def invariants(self, state):
        return {}


# ẋ = −f(x), and x(t) of x(0)
DECAYS = {
    "tanh": (jnp.tanh, lambda x, t: mpmath.asinh(mpmath.sinh(x) * mpmath.exp(-t))),
    "sinh": (jnp.sinh, lambda x, t: 2 * mpmath.atanh(mpmath.tanh(x / 2) * mpmath.exp(-t))),
    "expm1": (jnp.expm1, lambda x, t: -mpmath.log1p(mpmath.expm1(-x) * mpmath.exp(-t))),
    "log1p": (jnp.log1p, lambda x, t: mpmath.findroot(
        lambda y: mpmath.li(1 + x) - mpmath.li(1 + y) - t, (x / 9, x), solver="anderson", tol=1e-50)),
}


def miss(name, start):
    """Return the relative error at t = 2, and what is said of it."""
    rate, truth = DECAYS[name]
    found = ph.simulate(Scalar(lambda x: -rate(x)), np.array([start]), np.array([0.0, 2.0]), method=Taylor())
    with mpmath.workdps(60):
        exact = truth(mpmath.mpf(start), mpmath.mpf(2))
        return float(abs(mpmath.mpf(float(found.states[-1, 0])) / exact - 1)), found.error_estimate


@pytest.mark.parametrize("name", DECAYS)
@pytest.mark.parametrize("start", [1e-3, 1e-9, 1e-20])
def test_small_states_keep_their_digits(start, name):
    error, said = miss(name, start)
    assert error < 1e-15 and said < 1e-14


@pytest.mark.parametrize(("name", "rule"), [
    ("tanh", lambda a: 1.0 - 2.0 / (exponential(a * 2.0) + 1.0)),
    ("log1p", lambda a: logarithm(a + 1.0)),
])  # fmt: skip
def test_sums_with_one_lose_them_and_say_nothing(monkeypatch, name, rule):
    monkeypatch.setitem(tracing.RULES, name, tracing._elementary(rule))
    error, said = miss(name, 1e-20)
    assert error > 1.0 and said < 1e-14


@pytest.mark.parametrize("start", [5.0, -400.0, 3000.0, -1e6])
def test_tanh_of_any_size(start):
    error, said = miss("tanh", start)
    assert error < 1e-15 and said < 1e-14


@pytest.mark.parametrize("width", [0.3, 0.01, 1e-4])
def test_a_gate_opens_wherever_it_is(width):
    """ẋ = (1 + tanh((t − 5)/w))/2, whose exponentials leave double precision long before and after."""
    gate = Scalar(lambda x: jnp.stack([1.0 + 0.0 * x[0], 0.5 + 0.5 * jnp.tanh((x[0] - 5.0) / width)]))
    found = ph.simulate(gate, np.zeros(2), np.array([0.0, 4.9, 20.0]), method=Taylor())
    with mpmath.workdps(40):
        w = mpmath.mpf(width)
        for t, value in zip(found.times, np.asarray(found.states)[:, 1], strict=True):
            # ∫(1 + tanh(s/w))/2 ds = w/2 ln(1 + exp(2s/w))
            wanted = w / 2 * (mpmath.log1p(mpmath.exp(2 * (mpmath.mpf(t) - 5) / w)) - mpmath.log1p(mpmath.exp(-10 / w)))
            assert abs(value - wanted) < 3e-14 * 15.0
