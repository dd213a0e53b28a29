"""The table of corrections is what the derivation gives, and no wrong one would pass."""

from fractions import Fraction

import pytest

from oracle.moser_veselov import derived, first_difference
from polhode.systems.moser_veselov_table import SHIFT, TIME_SCALE


def as_dictionaries(table):
    return [{row[:5]: Fraction(row[5], row[6]) for row in rows} for rows in table]


def test_table_is_derived():
    found = derived(2)
    assert found[0] == as_dictionaries(TIME_SCALE)[:2]
    assert found[1] == as_dictionaries(SHIFT)[:2]


@pytest.mark.sweep
def test_whole_table_is_derived():
    assert list(derived(4)) == [as_dictionaries(TIME_SCALE), as_dictionaries(SHIFT)]


def test_a_wrong_coefficient_is_caught():
    s, d = as_dictionaries(TIME_SCALE)[:1], as_dictionaries(SHIFT)[:1]
    s[0][1, 0, 1, 0, 0] += Fraction(1, 1000)
    with pytest.raises(AssertionError):
        first_difference([Fraction(1), Fraction(2), Fraction(5)], [Fraction(1), Fraction(1), Fraction(2)], s, d)
