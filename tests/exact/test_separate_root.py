"""The root of a top's cubic that stands apart, by rational numbers: found to all digits, in few steps."""

from fractions import Fraction
from math import nextafter

import numpy as np
import pytest

from polhode.exact.lagrange_top import _formulas_roots as formulas
from polhode.exact.lagrange_top._formulas_reduction import reduction
from polhode.exact.lagrange_top._preparation import FORMULAS
from twins.families_of_tops import draw_tops

SHARP = 2.0**-97
"""Of the root, what Newton's method would still change: some roundings of double-double numbers."""


def cubics():
    """Yield the cubics of tops of all families, and where their roots are searched."""
    for case in draw_tops(12, 3):
        lone = formulas.apart(reduction(*case[1:5]))
        if lone.start > 0.0 and lone.cubic[1][0] - lone.cubic[1][0] == 0.0:
            yield lone


def left_to_change(root):
    """Return f/f'x, exactly."""
    x, _, cubic = root
    x, b, c, d = (Fraction(high) + Fraction(low) for high, low in (x, *cubic))
    return abs((((x + b) * x + c) * x + d) / ((3 * x + 2 * b) * x + c) / x)


def steps_of(lone, start=None):
    """Return the roots after each step."""
    root = formulas.begun(lone if start is None else lone._replace(start=start))
    found = []
    for k in range(formulas.MOST):
        if k >= formulas.AT_ONCE and formulas.is_found(root):
            break
        root = formulas.nearer(root)
        found.append(root)
    return found


def test_it_has_all_digits_after_few_steps():
    taken = [steps_of(lone) for lone in cubics()]
    assert len(taken) > 300
    assert all(formulas.is_found(roots[-1]) and left_to_change(roots[-1]) < SHARP for roots in taken)
    assert sum(len(roots) == formulas.AT_ONCE for roots in taken) > 0.97 * len(taken)


def test_a_poor_start_takes_more_steps_and_one_step_is_too_few():
    for lone in list(cubics())[::20]:
        roots = steps_of(lone, start=lone.start * (1.0 + 1e-6))
        assert formulas.AT_ONCE < len(roots) < formulas.MOST
        assert formulas.is_found(roots[-1]) and left_to_change(roots[-1]) < SHARP
        assert not formulas.is_found(roots[0]) and left_to_change(roots[0]) > SHARP


@pytest.mark.parametrize(("change", "found"), [
    (formulas.CONVERGED, True), (nextafter(formulas.CONVERGED, 1.0), False), (-formulas.CONVERGED, True), (0.0, True),
])  # fmt: skip
def test_a_root_is_found_when_it_hardly_changes(change, found):
    one = (1.0, 0.0)
    cubic = one, one, one
    assert formulas.is_found(((3.0, 0.0), 3.0 * change, cubic)) == found
    assert not formulas.is_found(((-3.0, 0.0), 0.0, cubic))


def test_what_has_no_slope_stays():
    """A top at rest without weight has no root but zero, and a step of Newton's is 0/0: arrays stay finite."""
    zero = (0.0, 0.0)
    cubic = (zero, zero, zero)
    with pytest.raises(ZeroDivisionError):
        formulas.nearer((zero, 0.0, cubic))
    zeros = np.zeros(1), np.zeros(1)
    with np.errstate(all="ignore"):
        x, change, _ = FORMULAS.nearer((zeros, zeros[0], (zeros,) * 3))
    assert x[0][0] == x[1][0] == change[0] == 0.0
