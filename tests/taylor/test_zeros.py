"""Zeros of polynomials: the first sign change, also where one lies exactly between two intervals that are searched."""

import numpy as np
import pytest

from polhode.taylor.kernel_zeros import DEPTH, first_zero

ORDER = 24


def found(roots, high, falling, sign):
    """The first change by the search."""
    p = np.zeros(ORDER + 1)
    exact = np.polynomial.polynomial.polyfromroots(roots) * sign
    p[: len(exact)] = exact
    return first_zero(p, ORDER, 0.0, high, falling, np.zeros(ORDER + 1), np.zeros(2 * DEPTH + 4))


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
