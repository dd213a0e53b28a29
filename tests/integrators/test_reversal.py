"""Reverse mode of equal steps: gradients equal those of forward mode, by memory that does not grow with the steps."""

from dataclasses import dataclass
from typing import Any, ClassVar

import equinox as eqx
import jax
import jax.numpy as jnp
import mpmath
import numpy as np
import pytest
from jax.flatten_util import ravel_pytree

import polhode as ph
from polhode import algebra as lie
from polhode import systems
from polhode.integrators import LieMidpoint, MuntheKaas, SphericalMidpoint, Splitting, _reversal
from polhode.motion import Status
from sweeping import first

EQUAL = 1e-12  # relative: two orders in which the same factors are multiplied
RNG = np.random.default_rng(7)
MOMENTS, L = (1.0, 2.0, 3.0), np.array([0.3, 1.8, 1.5])
BODY = systems.FreeRigidBody(MOMENTS)
SU3 = lie.SU(3)


class Quadratic(eqx.Module):
    """½ Σ w x², and what spins do to their neighbours."""

    weights: Any
    neighbours: bool = eqx.field(static=True, default=False)

    def __call__(self, point):
        vector = point if self.neighbours else SU3.to_dual_vector(point)
        coupled = -jnp.sum(point[:-1] * point[1:]) if self.neighbours else 0.0
        return coupled + 0.5 * jnp.sum(self.weights * vector**2)


@dataclass(frozen=True, eq=False)
class Case:
    name: str
    system: Any
    state: Any
    method: Any
    order: int
    step: float
    steps: int


SPINS = systems.LiePoisson(lie.Power(lie.SO3(), 4), Quadratic(jnp.array([0.0, 0.3, -0.6]), neighbours=True))
MATRIX = systems.LiePoisson(SU3, Quadratic(jnp.arange(1.0, 9.0)))
UP = np.array([0.1, 0.0, np.sqrt(0.99)])
ATTITUDE = np.array([0.5, 0.5, -0.5, 0.5])
CASES = [
    Case("a body with attitude", BODY, np.concatenate([ATTITUDE, L]), LieMidpoint, 2, 0.05, 300),
    Case("four spins, chaotic", SPINS, RNG.normal(size=(4, 3)), SphericalMidpoint, 2, 0.05, 300),
    Case("a heavy top", systems.HeavyTop((1.0, 1.5, 2.0), 1.0), np.concatenate([L, UP]), LieMidpoint, 2, 0.05, 300),
    Case("a free body", BODY, L, Splitting, 2, 0.05, 300),
    Case("a damped body", systems.DoubleBracket(MOMENTS, 0.3), L, LieMidpoint, 2, 0.05, 300),
    Case("a free body, order 8", BODY, L, Splitting, 8, 0.1, 1000),
    Case("a body with attitude, order 8", BODY, np.concatenate([ATTITUDE, L]), LieMidpoint, 8, 0.1, 1000),
    Case("su(3)", MATRIX, SU3.from_dual_vector(RNG.normal(size=8)), LieMidpoint, 2, 0.02, 200),
    Case("an explicit method", BODY, L, MuntheKaas, 4, 0.05, 300),
]


def real(state):
    return jnp.concatenate([jnp.ravel(jnp.real(state)), jnp.ravel(jnp.imag(state))])


def weighed(case):
    """Return a function of one vector (of a system's arrays, the state and the times) and that vector.

    It weighs states at three times, of which the last comes most of the steps after the one before.
    """
    span = case.step * case.steps
    times = np.array([0.0, 0.13 * span, 0.2 * span, span])
    arrays, rest = eqx.partition(case.system, eqx.is_inexact_array)
    numbers, unravel = ravel_pytree((arrays, jnp.asarray(case.state), jnp.asarray(times)))
    numbers, parts = ravel_pytree((jnp.real(numbers), jnp.imag(numbers)))
    complex_numbers = jnp.iscomplexobj(jnp.asarray(case.state))
    weights = RNG.normal(size=(len(times), real(case.state).size))

    def function(numbers):
        one, other = parts(numbers)
        arrays, state, times = unravel(one + 1j * other if complex_numbers else one)
        system = eqx.combine(arrays, rest)
        found = ph.solve(system, state, jnp.real(times), case.method, step=case.step, order=case.order).saved
        return jnp.sum(jax.vmap(real)(found) * weights)

    return function, numbers


@pytest.mark.sweep
@pytest.mark.parametrize("case", first(1, CASES), ids=lambda case: case.name.replace(" ", "-"))
def test_gradients_are_those_of_forward_mode(case):
    """By the state, by the times and by the arrays in the system."""
    function, numbers = weighed(case)
    back, ahead = jax.jit(jax.grad(function))(numbers), jax.jit(jax.jacfwd(function))(numbers)
    assert np.abs(ahead).max() > 1.0
    assert np.abs(back - ahead).max() < EQUAL * np.abs(ahead).max()


def midpoint_rule(momentum, moments, h, steps):
    """Return the momentum after steps of the implicit midpoint rule for L × L/I, to forty digits."""
    now = list(momentum)
    for _ in range(steps):
        change = [mpmath.mpf(0)] * 3
        for _ in range(200):
            x = [a + d / 2 for a, d in zip(now, change, strict=True)]
            w = [a / m for a, m in zip(x, moments, strict=True)]
            better = [h * (x[(k + 1) % 3] * w[(k + 2) % 3] - x[(k + 2) % 3] * w[(k + 1) % 3]) for k in range(3)]
            settled = max(abs(a - b) for a, b in zip(better, change, strict=True)) < mpmath.mpf(10) ** -38
            change = better
            if settled:
                break
        now = [a + d for a, d in zip(now, change, strict=True)]
    return now


@pytest.mark.long
def test_a_gradient_is_that_of_differences_in_forty_digits():
    """By momentum and moments, of Lie's midpoint rule of order 2, which on so(3) is the implicit midpoint rule."""
    h, steps, weights = 0.125, 24, RNG.normal(size=3)

    def function(numbers):
        body = eqx.tree_at(lambda s: s.moments, BODY, numbers[3:])
        found = ph.solve(body, numbers[:3], [0.0, h * steps], LieMidpoint, step=h, order=2)
        return found.end_state @ weights

    numbers = np.concatenate([L, MOMENTS])
    found = jax.grad(function)(jnp.asarray(numbers))
    with mpmath.workdps(40):
        tiny, wanted = mpmath.mpf(10) ** -12, []
        for k in range(6):
            values = []
            for sign in (1, -1):
                moved = [mpmath.mpf(x) + (sign * tiny if n == k else 0) for n, x in enumerate(numbers.tolist())]
                end = midpoint_rule(moved[:3], moved[3:], mpmath.mpf(h), steps)
                values.append(sum(a * b for a, b in zip(end, map(mpmath.mpf, weights.tolist()), strict=True)))
            wanted.append(float((values[0] - values[1]) / (2 * tiny)))
    assert np.abs(found - np.array(wanted)).max() < EQUAL * np.abs(wanted).max()


@pytest.mark.long
def test_memory_does_not_know_the_number_of_steps():
    """One compiled gradient serves a hundred steps and ten thousand: their number is a value, the memory fixed."""
    last = lambda s, step: ph.solve(BODY, s, [0.0, 1.0], LieMidpoint, step=step, order=2).end_state[0]  # noqa: E731
    compiled = jax.jit(jax.grad(last)).lower(jnp.asarray(L), 0.1).compile()
    assert compiled.memory_analysis().temp_size_in_bytes < 20_000
    ahead = jax.jit(jax.jacfwd(last))
    for step in (1e-2, 1e-4):
        assert np.abs(compiled(jnp.asarray(L), step) - ahead(jnp.asarray(L), step)).max() < EQUAL


class Lopsided(MuntheKaas):
    """A method that says that it undoes its steps, and does not."""

    symmetric: ClassVar[bool] = True


class LopsidedUnchecked(Lopsided):
    pass


def last_by(method, step, order):
    return lambda s: ph.solve(BODY, s, [0.0, 40 * step], method, step=step, order=order).end_state[0]


@pytest.mark.sweep
def test_what_is_not_regained_is_computed_anew(monkeypatch):
    """Without the check the gradient is wrong by far more than the tests above allow, so that they would say so."""
    start = jnp.asarray(L)
    wanted = jax.jacfwd(last_by(Lopsided, 0.25, 2))(start)
    assert np.abs(jax.grad(last_by(Lopsided, 0.25, 2))(start) - wanted).max() < EQUAL * np.abs(wanted).max()
    monkeypatch.setattr(_reversal, "LIMITS", _reversal.LIMITS._replace(tolerance=np.inf))
    assert np.abs(jax.grad(last_by(LopsidedUnchecked, 0.25, 2))(start) - wanted).max() > 1e-6 * np.abs(wanted).max()


@pytest.mark.sweep
def test_copies_go_back_by_their_own_steps():
    states = jnp.asarray(np.stack([L, 30.0 * L]))
    total = lambda s: jnp.sum(ph.solve(BODY, s, [0.0, 1.0], LieMidpoint, order=2).end_state[..., 0])  # noqa: E731
    alone = np.stack([jax.grad(total)(state) for state in states])
    assert np.abs(jax.grad(total)(states) - alone).max() < EQUAL * np.abs(alone).max()


@pytest.mark.sweep
def test_a_copy_that_fails_spoils_no_other():
    def sound(s):
        found = ph.solve(BODY, s, [0.0, 1.0], MuntheKaas, step=0.1, order=2)
        return jnp.sum(jnp.where(found.status == Status.COMPLETED, found.end_state[..., 0], 0.0))

    broken, start = jnp.full(3, jnp.nan), jnp.asarray(L)
    slopes = jax.grad(sound)(jnp.stack([start, broken]))
    assert (slopes[1] == 0.0).all()
    assert np.abs(slopes[0] - jax.jacfwd(sound)(start)).max() < EQUAL


@pytest.mark.sweep
def test_second_derivatives_are_forward_ones():
    function = last_by(LieMidpoint, 0.05, 2)
    found, tiny = jax.jit(jax.hessian(function))(jnp.asarray(L)), 1e-5
    slopes = jax.jit(jax.grad(function))
    wanted = np.stack([(slopes(L + tiny * e) - slopes(L - tiny * e)) / (2 * tiny) for e in np.eye(3)])
    assert np.abs(found - wanted).max() < 1e-8
    with pytest.raises(ph.errors.InvalidInput, match="forward derivatives only"):
        jax.jacrev(jax.jacfwd(function))(jnp.asarray(L))
