"""One rule for numbers in files."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from polhode.formats.numerals import is_misread, read_number


@pytest.mark.parametrize("text", [
    "2_5", "1_0e3", "nan", "inf", "-Infinity", "1e400", "-1e309", "1e-400", "0x10", "1e", "", ".", "+", "1,5", " 1",
    "1 ", "１", "٣", "1d5", "1e1_0",
    "--1", "1\0", "1\n", "9" * 401, "1e" + "9" * 30, "0." + "0" * 330 + "1", "½", "1e٣",
])  # fmt: skip
def test_what_is_no_number(text):
    with pytest.raises(ValueError):
        read_number(text)
    assert "\n" in text or is_misread(text) == (text not in NO_FLOATS)


NO_FLOATS = ("0x10", "1e", "", ".", "+", "1,5", "1d5", "--1", "1\0", "½")


@pytest.mark.parametrize(("text", "value"), [
    ("1", 1.0), ("-1.", -1.0), ("+.5", 0.5), ("1E+2", 100.0), ("-0.0", 0.0), ("0e-999", 0.0), ("5e-324", 5e-324),
    ("007", 7.0),
])  # fmt: skip
def test_numbers(text, value):
    assert read_number(text) == value and not is_misread(text)


@given(st.floats(allow_nan=False, allow_infinity=False))
def test_what_python_writes_is_read_back(value):
    assert read_number(repr(value)) == value and read_number(f"{value:.17e}") == value
