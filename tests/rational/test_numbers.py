"""The one reader of numbers from outside: what a double is, what is written, and numbers that would take minutes."""

import math
import struct
from decimal import Decimal
from fractions import Fraction

import mpmath
import numpy as np
import pytest
import sympy

from polhode._base.rational import read_number
from polhode._base.rational.numbers import LIMITS
from polhode.errors import InvalidInput


def by_bits(value):
    """The number of IEEE 754's fields: an independent reading of a double."""
    (bits,) = struct.unpack(">Q", struct.pack(">d", value))
    sign, exponent, mantissa = bits >> 63, bits >> 52 & 0x7FF, bits & (1 << 52) - 1
    whole = mantissa + ((1 << 52) if exponent else 0)
    return Fraction(-whole if sign else whole) * Fraction(2) ** (max(exponent, 1) - 1075)


DOUBLES = [0.1, 0.1 + 0.2, 0.3, 1 / 3, math.pi, 1e-290, 1e290, -2.5, 0.0, 0.12345, 1.0 - 2**-53]


@pytest.mark.parametrize("value", DOUBLES)
def test_a_double_is_the_binary_fraction_that_it_is(value):
    assert read_number(value) == read_number(np.float64(value)) == read_number(np.array(value)) == by_bits(value)
    assert read_number(sympy.Float(value, precision=53)) == by_bits(value)


def test_a_number_of_more_bits_is_what_it_is_in_both_readings():
    for read_as in ("exact", "decimal"):
        assert read_number(mpmath.mpf(0.1), read_as) == read_number(0.1, read_as)
        with mpmath.workdps(40):
            assert 0 < abs(read_number(mpmath.mpf("0.1"), read_as) - Fraction(1, 10)) < Fraction(1, 10**40)


@pytest.mark.parametrize(("value", "digits"), [
    (0.1, "1/10"), (0.1 + 0.2, "30000000000000004/100000000000000000"), (1e23, str(10**23)), (5e-324, f"5/{10**324}"),
    (0.12345, "2469/20000"), (2.0**0.5, "14142135623730951/10000000000000000"), (-3e-5, "-3/100000"),
])  # fmt: skip
def test_or_the_decimal_that_was_meant_where_somebody_says_so(value, digits):
    assert read_number(value, "decimal") == Fraction(digits)
    assert float(read_number(value, "decimal")) == value


@pytest.mark.parametrize("read_as", ["exact", "decimal"])
def test_readings_are_one_to_one_and_keep_order(read_as):
    """What is equal, or larger, among doubles is so among the numbers: 0.1 + 0.2 and 0.3 are two in both."""
    rng = np.random.default_rng(2)
    for x in rng.normal(size=200) * 10.0 ** rng.integers(-300, 300, size=200):
        up = math.nextafter(x, math.inf)
        assert read_number(x, read_as) < read_number(up, read_as)


def test_what_is_written_is_what_it_says():
    for value in ("3/10", "0.3", ".3", " 3e-1 ", "+30E-2", Fraction(3, 10), Decimal("0.3"), sympy.Rational(3, 10)):
        assert read_number(value) == read_number(value, "decimal") == Fraction(3, 10)
    for value in (5e-324, 1.7976931348623157e308):
        assert read_number(value) == by_bits(value)
    assert read_number(7) == read_number(np.int64(7)) == read_number("7.") == read_number(sympy.Integer(7)) == 7
    assert read_number(sympy.Float("0.1", 40)) != Fraction(1, 10)
    assert abs(read_number(sympy.Float("0.1", 40)) - Fraction(1, 10)) < Fraction(1, 10**40)


HOSTILE = [
    "1e99999999", "1e-99999999", "1e99999999999999999999", "1e9_999_999", "1E٩٩٩٩٩٩٩٩", "9" * 10**6, "0." + "9" * 10**6,
    "1/0", "1e5001", "1e-5001", "nan", "inf", "", "two", "1_000", "0x10", "1 2", "1/3e9", Decimal("1e99999999"),
    Decimal("0e99999999"), Decimal("nan"), Decimal("-inf"), math.nan, math.inf, np.float64("nan"), np.float32(0.1),
    np.longdouble(0.1), True, np.True_, None, 1j, [1.0], sympy.Symbol("x"), sympy.pi, b"1",
    sympy.Float("1e9999"), sympy.Float("-inf"), sympy.nan, mpmath.mpf("1e-99999999"), mpmath.inf,
]  # fmt: skip


@pytest.mark.parametrize("value", HOSTILE, ids=lambda x: repr(x)[:30])
def test_what_is_no_number_or_would_take_minutes_is_refused_at_once(value):
    with pytest.raises(InvalidInput, match=r"^`I1` must be .*; got .*\.") as told:
        read_number(value, name="I1")
    assert len(str(told.value)) < 400


def test_the_bounds_lie_where_they_are_said_to():
    assert read_number(f"1e{LIMITS.max_exponent}") == 10**LIMITS.max_exponent
    assert read_number(Decimal(f"1e-{LIMITS.max_exponent}")) == Fraction(1, 10**LIMITS.max_exponent)
    assert read_number("1" * LIMITS.max_digits) % 10 == 1
    with pytest.raises(InvalidInput, match="must be decimals"):
        read_number("1" * (LIMITS.max_digits + 1))


def test_another_reading_is_refused():
    with pytest.raises(InvalidInput, match='`read_as` must be "exact" or "decimal"; got \'short\''):
        read_number(0.1, "short")
