"""Zeros of polynomials: the first sign change, also where one lies exactly between two intervals that are searched."""

import jax.numpy as jnp
import numpy as np
import pytest

import polhode as ph
from polhode.taylor.kernel_zeros import MAX_WAITING, first_zero
from taylor.test_coefficients import OwnField

ORDER = 24


def found(roots, high, falling, sign):
    """The first change by the search."""
    p = np.zeros(ORDER + 1)
    exact = np.polynomial.polynomial.polyfromroots(roots) * sign
    p[: len(exact)] = exact
    return first_zero(p, ORDER, 0.0, high, falling, np.zeros(ORDER + 1), np.zeros(2 * MAX_WAITING + 4))


def first_change(roots, high, falling, sign):
    at_zero = sign * (-1.0) ** len(roots)
    # the sign changes at each root in turn, from that before all of them
    for k, root in enumerate(sorted(roots)):
        if 0.0 < root <= high and (not falling or at_zero * (-1.0) ** k > 0.0):
            return root
    return np.nan


@pytest.mark.parametrize("falling", [True, False])
@pytest.mark.parametrize("grid", [8, 3], ids=["where intervals end", "elsewhere"])
def test_the_first_change_is_found_wherever_it_is(falling, grid):
    """With eighths products are exact, and a search that halves meets the zeros at ends of its intervals."""
    random = np.random.default_rng(4)
    for _ in range(300):
        roots = random.choice(np.arange(1, 40), random.integers(1, 5), replace=False) / grid
        high = random.choice([1.0, 2.0, 2.5, 4.0]) if grid == 8 else random.uniform(1.0, 5.0)
        sign = random.choice([-1.0, 1.0])
        wanted = first_change(roots, high, falling, sign)
        assert found(roots, high, falling, sign) == pytest.approx(wanted, rel=1e-10, nan_ok=True)


def turning(t, y):
    return jnp.stack([y[1], -y[0]])


@pytest.mark.parametrize("depth", [1e-6, 1e-12])
def test_close_crossings_count_once_each(depth):
    """sin t comes above 1 − d for a while in each of 16 turns; some crossings were counted twice."""
    section = ph.section(OwnField(turning), [0.0, 1.0], lambda t, y: y[0] - (1.0 - depth), (0.0, 100.0), "either")
    assert len(section.times) == 32
    assert np.diff(section.times)[::2] == pytest.approx(2.0 * np.arccos(1.0 - depth), rel=1e-3)


def test_zeros_of_order_three_are_found_in_time():
    section = ph.section(OwnField(turning), [0.0, 1.0], lambda t, y: y[0] ** 3, (0.0, 10.0), "either")
    assert section.times == pytest.approx(np.pi * np.arange(1, 4), abs=1e-4)


def test_a_surface_on_which_a_motion_stays_is_not_crossed():
    surface = lambda t, y: y[0] ** 2 + y[1] ** 2 - 1.0  # noqa: E731
    assert not len(ph.section(OwnField(turning), [0.0, 1.0], surface, (0.0, 10.0), "either").times)
