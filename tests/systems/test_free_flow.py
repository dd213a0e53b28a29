"""The free body's flow over a step, against the Taylor series of q' = ½ q Ω, L' = L × Ω in forty digits."""

import itertools

import jax.numpy as jnp
import mpmath
import numpy as np
import pytest

from polhode.systems import free_flow, moser_veselov_table

MOMENTS = [(2.0, 1.5, 1.0), (1.0, 1.01, 1.99), (1.0, 1.0, 2.0), (1.0, 1.0, 1.0), (5.2, 0.3, 5.0), (1.0, 100.0, 100.9),
           (3e-30, 2e-30, 4e-30)]  # fmt: skip
DIRECTIONS = [(0.6, 0.4, 0.7), (0.1, 1.0, -0.1), (0.0, 0.0, 1.0), (1.0, 1e-9, 0.0)]
ANGLES = [1e-9, 0.03, 0.19, -0.2, 1.0]
ROUNDING = 2e-15  # of the angle: a few roundings of each piece


def taylor(moments, time, momentum, terms=45):
    def cross(a, b):
        return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]

    def product(p, v):
        scalar = -sum(a * b for a, b in zip(p[1:], v, strict=True))
        return [scalar, *(p[0] * a + b for a, b in zip(v, cross(p[1:], v), strict=True))]

    L, q = [momentum], [[mpmath.mpf(1), *[mpmath.mpf(0)] * 3]]
    velocity = [[time * x / i for x, i in zip(momentum, moments, strict=True)]]
    for k in range(terms):
        terms_L = [cross(L[j], velocity[k - j]) for j in range(k + 1)]
        terms_q = [product(q[j], velocity[k - j]) for j in range(k + 1)]
        L.append([sum(t[n] for t in terms_L) / (k + 1) for n in range(3)])
        q.append([sum(t[n] for t in terms_q) / (2 * (k + 1)) for n in range(4)])
        velocity.append([time * x / i for x, i in zip(L[-1], moments, strict=True)])
    return [sum(t[n] for t in q) for n in range(4)]


def worst_error(moments, direction, angle):
    """The largest error of the turn, relative to its angle."""
    fastest = np.linalg.norm(direction) / min(moments)
    time = angle / fastest
    with mpmath.workdps(40):
        exact = taylor(*([mpmath.mpf(x) for x in moments], mpmath.mpf(time), [mpmath.mpf(x) for x in direction]))
        exact[0] -= 1
        found = free_flow.free_turn(jnp.array(moments), jnp.asarray(time), tuple(jnp.asarray(x) for x in direction))
        return float(max(abs(a - mpmath.mpf(float(b))) for a, b in zip(exact, found, strict=True)) / abs(angle))


SWEPT = [pytest.param(moments, marks=pytest.mark.sweep) for moments in MOMENTS[2:]]


@pytest.mark.parametrize("moments", [*MOMENTS[:2], *SWEPT])
def test_the_flow_is_exact_to_rounding(moments):
    for direction, angle in itertools.product(DIRECTIONS, ANGLES):
        assert worst_error(moments, direction, angle) < ROUNDING, (direction, angle)


def test_moments_that_no_body_has_do_not_break_it():
    for direction, angle in itertools.product(DIRECTIONS, ANGLES):
        assert worst_error((1.0, 1.0, 1e4), direction, angle) < 50 * ROUNDING, (direction, angle)


def test_a_wrong_coefficient_is_seen(monkeypatch):
    first, second, *others = moser_veselov_table.SHIFT
    *powers, numerator, denominator = second[0]
    wrong = ((*powers, numerator + 1, denominator), *second[1:])
    monkeypatch.setattr(moser_veselov_table, "SHIFT", (first, wrong, *others))
    assert worst_error(MOMENTS[0], DIRECTIONS[0], 0.19) > 100 * ROUNDING


def test_too_few_iterations_are_seen(monkeypatch):
    monkeypatch.setattr(free_flow, "ITERATIONS", 5)
    assert worst_error(MOMENTS[0], DIRECTIONS[0], 0.19) > 2 * ROUNDING


def test_momenta_and_moments_of_any_size():
    for size in (1e-150, 1e150):
        moments, momentum = size * np.array([1.0, 2.0, 2.5]), size * np.array([0.6, 0.4, 0.7])
        found = free_flow.free_turn(jnp.asarray(moments), jnp.asarray(0.3), tuple(jnp.asarray(momentum)))
        same = free_flow.free_turn(jnp.asarray(moments / size), jnp.asarray(0.3), tuple(jnp.asarray(momentum / size)))
        assert np.abs(np.array(found) - np.array(same)).max() < 1e-15
