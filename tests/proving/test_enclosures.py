"""Proved enclosures hold the truth: that of ball arithmetic by elliptic functions, and closed forms by mpmath."""

import jax.numpy as jnp
import mpmath
import numpy as np
import pytest
from flint import arb, ctx

import polhode as ph
from oracle.lagrange import reference_top
from oracle.reference import reference_state
from polhode.errors import InvalidInput, NotConverged
from polhode.proving.enclosures import enclosure as enclosures
from polhode.proving.enclosures._taylor_balls import BallSystem

MOMENTS = (1.0, 2.0, 3.0)


def holds(result, truth):
    """Return whether the radii hold numbers (n,) in balls at the last time; no radius is more than some roundings."""
    sizes = np.abs(result.states).max(axis=-1, keepdims=True)
    assert (result.radii <= 4e-16 * sizes).all()
    with ctx.workprec(300):
        return [bool(abs(arb(float(x)) - y) <= arb(float(r)))
                for x, y, r in zip(result.states[-1], truth, result.radii[-1], strict=True)]  # fmt: skip


@pytest.mark.parametrize("momentum", [(0.3, 1.8, 1.5), (1e-9, 2.0, 1e-9), (0.2, 0.1, 2.0)])
def test_a_free_body_is_where_elliptic_functions_say(momentum):
    """Next to the saddle too, where the bound grows as the motion does."""
    result = ph.certify(ph.systems.FreeRigidBody(MOMENTS), momentum, [0.0, 3.0, 7.0])
    with ctx.workprec(300):
        reference = reference_state(MOMENTS, momentum, 7.0, 200)
        norm = sum((arb(x) ** 2 for x in momentum), arb(0)).sqrt()
        truth = [norm * x for x in reference.direction]
    assert result.exact and all(holds(result, truth)), result


@pytest.mark.long
def test_a_top_is_where_elliptic_functions_say():
    moments, weight, momentum, t = (1.0, 1.0, 0.5), 0.75, (0.3, 0.2, 1.5), 4.0
    top = ph.systems.HeavyTop(moments, weight)
    start = top.pack((1.0, 0.0, 0.0, 0.0), momentum=momentum)
    result = ph.certify(top, start, [0.0, t])
    with ctx.workprec(300):
        reference = reference_top(moments, weight, momentum, (1.0, 0.0, 0.0, 0.0), t)
        truth = [*reference.quaternion, *reference.momentum]
    assert result.exact and all(holds(result, [*truth, *[arb(float(x)) for x in result.states[-1][7:]]])), result


class Scalar(ph.systems.AbstractSystem):
    """ẋ = f(t, x / scale)."""

    rate: object
    scale: object = 1.0

    def vector_field(self, t, state):
        return self.rate(t, state / self.scale)

    def invariants(self, state):
        return {}


CLOSED = {
    "exponential": (lambda t, x: jnp.exp(-x), lambda x, t: mpmath.log(mpmath.exp(x) + t)),
    "root": (lambda t, x: 1.0 / x, lambda x, t: mpmath.sqrt(x * x + 2 * t)),
    "power": (lambda t, x: x**1.5, lambda x, t: (x ** mpmath.mpf("-0.5") - t / 2) ** -2),
    "cube root": (lambda t, x: -jnp.cbrt(x), None),
    "logarithm": (lambda t, x: -x * jnp.log(x), lambda x, t: mpmath.exp(mpmath.log(x) * mpmath.exp(-t))),
    "sine": (lambda t, x: jnp.sin(x), lambda x, t: 2 * mpmath.atan(mpmath.exp(t) * mpmath.tan(x / 2))),
    "tanh": (lambda t, x: -jnp.tanh(x), lambda x, t: mpmath.asinh(mpmath.sinh(x) * mpmath.exp(-t))),
    "less one": (lambda t, x: jnp.expm1(-x), lambda x, t: mpmath.log1p(mpmath.expm1(x) * mpmath.exp(-t))),
    "driven": (lambda t, x: x * jnp.cos(t), lambda x, t: x * mpmath.exp(mpmath.sin(t))),
    "logistic": (lambda t, x: x * (1.0 - x), lambda x, t: x / (x + (1 - x) * mpmath.exp(-t))),
}


@pytest.mark.long_after(3)
@pytest.mark.parametrize("name", [name for name, (_, truth) in CLOSED.items() if truth])
def test_closed_forms_are_held(name):
    rate, truth = CLOSED[name]
    with mpmath.workprec(300):
        result = ph.certify(Scalar(rate), [0.75], [0.0, 0.5, 1.25])
        exact = truth(mpmath.mpf(0.75), mpmath.mpf(1.25))
        assert abs(mpmath.mpf(float(result.states[-1, 0])) - exact) <= mpmath.mpf(float(result.radii[-1, 0]))
    assert result.radii[-1, 0] < 4e-16 * abs(result.states[-1, 0])


def test_parameters_are_exact():
    """After so long, the rounding of one third would show."""
    result = ph.certify(Scalar(lambda t, x: x, jnp.asarray(3.0)), [1.0], [0.0, 60.0], radius=1e-16)
    with mpmath.workprec(200):
        exact, rounded = mpmath.exp(20), mpmath.exp(60 * mpmath.mpf(1.0 / 3.0))
        at, radius = mpmath.mpf(float(result.states[-1, 0])), mpmath.mpf(float(result.radii[-1, 0]))
        assert result.exact and abs(at - exact) <= radius < abs(exact - rounded)


OF_NUMBERS = {  # ẋ of one number, with numbers whose quotients and products are no doubles, and its motion from 0.75
    "a quotient": (lambda t, x: x / 0.3, lambda t: 0.75 * mpmath.exp(t / mpmath.mpf(0.3))),
    "quotients of arrays": (lambda t, x: x * jnp.sum(1.0 / jnp.array([0.7, 1.1])),
                            lambda t: 0.75 * mpmath.exp(t * (1 / mpmath.mpf(0.7) + 1 / mpmath.mpf(1.1)))),
    "a product": (lambda t, x: 0.1 * (0.7 * x), lambda t: 0.75 * mpmath.exp(t * mpmath.mpf(0.1) * mpmath.mpf(0.7))),
    "a whole number": (lambda t, x: x / 3, lambda t: 0.75 * mpmath.exp(t / 3)),
    "a function": (lambda t, x: jnp.exp(0.3) * x, lambda t: 0.75 * mpmath.exp(t * mpmath.exp(mpmath.mpf(0.3)))),
    "a sum": (lambda t, x: (0.1 + jnp.sqrt(0.2)) * x,
              lambda t: 0.75 * mpmath.exp(t * (mpmath.mpf(0.1) + mpmath.sqrt(mpmath.mpf(0.2))))),
}


@pytest.mark.parametrize("name", OF_NUMBERS)
def test_numbers_in_formulas_are_exact(name):
    """What is computed of them is a ball: rounded to a double it would be another motion."""
    rate, motion = OF_NUMBERS[name]
    result = ph.certify(Scalar(rate), [0.75], [0.0, 1.25], radius=1e-25)
    with mpmath.workdps(50):
        off = abs(motion(mpmath.mpf(1.25)) - mpmath.mpf(float(result.states[-1, 0])))
        assert result.exact and off <= mpmath.mpf(float(result.radii[-1, 0])), float(off)


def test_what_is_rounded_is_said():
    """By operations without a recurrence, by an exponent that is no double, or by JAX's own 1/ln 10."""
    assert not ph.certify(Scalar(lambda t, x: jnp.log10(x)), [2.0], [0.0, 1.0]).exact
    assert not ph.certify(Scalar(lambda t, x: x * jnp.linalg.det(jnp.array([[0.1]]))), [1.0], [0.0, 1.0]).exact
    assert not ph.certify(Scalar(lambda t, x: jnp.cbrt(x)), [1.0], [0.0, 1.0]).exact


def test_a_coarse_proof_holds_too():
    result = ph.certify(Scalar(lambda t, x: x * jnp.cos(t)), [0.75], [0.0, 20.0], radius=0.5)
    with mpmath.workprec(200):
        exact = mpmath.mpf(0.75) * mpmath.exp(mpmath.sin(20))
        assert abs(mpmath.mpf(float(result.states[-1, 0])) - exact) <= mpmath.mpf(float(result.radii[-1, 0]))


def test_what_rests_is_where_it_was():
    result = ph.certify(ph.systems.FreeRigidBody(MOMENTS), [0.0, 0.0, 0.0], [0.0, 1.0])
    assert (result.states == 0.0).all() and result.radii.max() < 1e-15


@pytest.mark.long
def test_complex_states_and_other_directions_of_time():
    system = ph.systems.LiePoisson(ph.algebra.SU(2), lambda m: jnp.real(1j * (m[..., 0, 0] - m[..., 1, 1])))
    start = np.asarray(ph.algebra.SU(2).from_dual_vector(np.array([0.3, 0.4, 0.5])))
    result = ph.certify(system, start, [0.0, -2.0])
    other = ph.simulate(system, start, [0.0, -2.0])
    assert result.states.shape == other.states.shape and result.radii.shape == (2, 2, 2)
    assert np.abs(result.states - other.states).max() < 1e-14 and result.radii.max() < 1e-15


def proved(order, off):
    """Return error and radius of ẋ = x at t = 12 by series of an order, from a start that is known to a bound."""
    import flint

    balls = BallSystem(Scalar(lambda t, x: x), np.array([1.0]))
    with ctx.workprec(120):
        start, numbers = (np.array([1.0]), np.array([off])), (np.zeros(0), np.zeros(0))
        proof = enclosures._Proof(flint, balls, start, numbers, np.array([0.0, 12.0]), np.ones(1), order, 120)
        result = proof.run()
        return abs(arb(float(result.states[-1, 0])) - (1 - arb(off)) * arb(12).exp()), arb(float(result.radii[-1, 0]))


@pytest.mark.parametrize("broken", [False, True])
def test_without_the_growth_of_errors_a_proof_does_not_hold(monkeypatch, broken):
    if broken:
        monkeypatch.setattr(BallSystem, "slopes", lambda self, y, p: [[y[0] * 0]])
    error, radius = proved(40, 1e-6)
    assert bool(error <= radius) == (not broken)


@pytest.mark.parametrize("broken", [False, True])
def test_without_the_terms_it_bounds_the_rest_of_a_proof_does_not_hold(monkeypatch, broken):
    whole = BallSystem.coefficients
    if broken:
        monkeypatch.setattr(BallSystem, "coefficients", lambda self, y, p, order: [
            [x * (k < order // 2) for k, x in enumerate(row)] for row in whole(self, y, p, order)])  # fmt: skip
    error, radius = proved(12, 0.0)
    assert bool(error <= radius) == (not broken)


@pytest.mark.parametrize(
    ("call", "error", "words"),
    [
        (lambda: ph.certify(Scalar(lambda t, x: x), [[1.0]], [0.0, 1.0]), InvalidInput, "one state, no batch"),
        (lambda: ph.certify(Scalar(lambda t, x: x), [1.0], [0.0, 1.0], radius=2.0), InvalidInput, "`radius` must be"),
        (lambda: ph.certify(Scalar(lambda t, x: x), [1.0], [1.0, 0.0, 2.0]), InvalidInput, "in one direction"),
        (lambda: ph.certify(Scalar(lambda t, x: x), [1.0], 2.0), InvalidInput, "at least two finite times .* got 2.0"),
        (lambda: ph.certify(Scalar(lambda t, x: x), [1.0], [[0.0, 1.0]]), InvalidInput, "at least two finite times"),
        (lambda: ph.certify(Scalar(lambda t, x: jnp.abs(x)), [1.0], [0.0, 1.0]), InvalidInput, "no Taylor series"),
        (lambda: ph.certify(Scalar(lambda t, x: x * x), [1.0], [0.0, 1.5]), NotConverged, "singularity"),
        (lambda: ph.certify(Scalar(lambda t, x: -jnp.sqrt(x)), [1.0], [0.0, 3.0]), NotConverged, "singularity"),
        (lambda: ph.certify(Scalar(lambda t, x: 99.0 * x), [1.0], [0.0, 99.0]), NotConverged, "be needed|singularity"),
    ],
)
def test_what_cannot_be_proved_is_refused(call, error, words):
    with pytest.raises(error, match=words):
        call()


class Spring(ph.systems.AbstractSystem):
    """ẍ = −k x, with its number as Python has it."""

    k: float

    def vector_field(self, t, state):
        return jnp.stack([state[1], -self.k * state[0]])

    def invariants(self, state):
        return {}


@pytest.mark.parametrize(("other", "span"), [(1.01, 5.0), (1.0 + 1e-9, 5.0), (0.99, 2.0)])
def test_plain_numbers_of_another_system_count_and_zeros_are_passed(other, span):
    """They were left out, and the ball held neither system's neighbours; where x came to zero there was no bound."""
    result = ph.certify(Spring(1.0), [1.0, 0.0], [0.0, span], other=Spring(other))
    with mpmath.workprec(200):
        for k in (1.0, other, 0.5 * (1.0 + other)):
            w = mpmath.sqrt(mpmath.mpf(k))
            exact = [mpmath.cos(w * span), -w * mpmath.sin(w * span)]
            off = [abs(mpmath.mpf(float(x)) - y) for x, y in zip(result.states[-1], exact, strict=True)]
            assert all(x <= mpmath.mpf(float(r)) for x, r in zip(off, result.radii[-1], strict=True))
    assert result.radii[-1].max() < 20.0 * abs(other - 1.0) * span


@pytest.mark.parametrize("other", [Spring(2), Scalar(lambda t, x: -2.0 * x)], ids=["a whole number", "a function"])
def test_other_functions_and_whole_numbers_are_refused(other):
    system = Spring(1.0) if isinstance(other, Spring) else Scalar(lambda t, x: -x)
    with pytest.raises(InvalidInput, match=r"`other` must be a .* of which only real numbers in its fields differ"):
        ph.certify(system, [1.0, 0.0], [0.0, 1.0], other=other)
