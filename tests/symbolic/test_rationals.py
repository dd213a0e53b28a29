"""Which fraction a double stands for."""

import math
from fractions import Fraction

import numpy as np
import pytest
import sympy

from polhode.errors import InvalidInput
from polhode.rational import exact_number, exact_numbers


@pytest.mark.parametrize(("value", "wanted"), [
    (1 / 3, Fraction(1, 3)),
    (2 / 7, Fraction(2, 7)),
    (0.1 + 0.2, Fraction(3, 10)),
    (0.54167, Fraction(54167, 100000)),
    (0.123456789, Fraction(123456789, 10**9)),
    (6.02214076e23, Fraction(602214076 * 10**15)),
    (6.62607015e-34, Fraction(662607015, 10**42)),
    (-2.5, Fraction(-5, 2)),
    (0.0, Fraction(0)),
    (3, Fraction(3)),
    (np.float64(1.5), Fraction(3, 2)),
    ("5/2", Fraction(5, 2)),
    ("0.1", Fraction(1, 10)),
    (sympy.Rational(2, 3), Fraction(2, 3)),
    (Fraction(10**20 + 1, 10**20), Fraction(10**20 + 1, 10**20)),
])  # fmt: skip
def test_meant_numbers(value, wanted):
    assert exact_number(value) == wanted


def test_every_double_is_met_to_its_last_places():
    rng = np.random.default_rng(0)
    for value in rng.normal(size=300) * 10.0 ** rng.integers(-30, 30, size=300):
        assert abs(float(exact_number(value)) / value - 1.0) <= 5 * 2.0**-52


def test_ratios_are_kept():
    """π has no fraction; what is half of it, a third, or the same computed otherwise, keeps the ratio."""
    numbers = exact_numbers([math.pi, 2 * math.pi, math.pi / 3, math.sqrt(2), 0.5, math.pi / 7 * 7])
    assert [n / numbers[0] for n in (numbers[1], numbers[2], numbers[5])] == [2, Fraction(1, 3), 1]
    assert numbers[4] == Fraction(1, 2)


@pytest.mark.parametrize("value", [math.nan, math.inf, "two", "1/0", None, 1j])
def test_what_is_no_number_is_refused(value):
    with pytest.raises(InvalidInput):
        exact_number(value)
