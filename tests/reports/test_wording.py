"""Numbers in words: no digits finer than the uncertainty beside them."""

import re
from dataclasses import replace
from decimal import Decimal

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from polhode.reports.answer import collect_values
from polhode.reports.wording import count_known_digits, uncertain
from polhode.spacecraft.comparing.comparison import AttitudeHistory, compare
from polhode.spacecraft.comparing.report import ComparisonReport

NUMBER = r"[-+]?\d+(?:\.\d+)?(?:e[-+]\d+)?"
PAIR = re.compile(rf"({NUMBER}) ± ({NUMBER})")
SIZES = st.floats(-300.0, 300.0)


def last_power(said):
    """Return the power of ten of the last digit that an uncertainty has: its first, or of a 1 the next."""
    return Decimal(said).adjusted() - (said.lstrip("0.").startswith("1"))


@settings(max_examples=200, deadline=None, database=None)
@given(st.floats(-1e9, 1e9), SIZES, st.floats(-12.0, 3.0))
def test_what_is_written_is_rounded_where_the_uncertainty_ends(mantissa, power, relative):
    value = mantissa * 10.0 ** (power - 9.0)
    error = 10.0 ** (power + relative)
    if not (1e-300 < error < 1e300):
        return
    words, said = PAIR.fullmatch(uncertain(value, error)).groups()
    assert abs(float(said) - error) <= 0.5 * error and len(re.sub(r"e.*|[.0]", "", said)) <= 2
    unit = Decimal(1).scaleb(last_power(said))
    assert abs(Decimal(words) - Decimal(value)) <= unit / 2 + abs(Decimal(value)) * Decimal("1e-15")
    assert Decimal(words) % unit == 0


@pytest.mark.parametrize(
    ("value", "error", "words"),
    [
        (81.39190987, 9.1, "81 ± 9"), (-0.41429, 0.003, "-0.414 ± 0.003"), (1.0, 0.5, "1.0 ± 0.5"),
        (-0.3, 9.0, "0 ± 9"), (0.0, 0.02, "0.00 ± 0.02"), (12345.0, 99.0, "12340 ± 100"),
        (3e-12, 2e-14, "3.00e-12 ± 2e-14"),
        (2.0, 0.0, "2"), (2.0, np.inf, "2"), (np.inf, 1.0, "inf"),
    ],
)  # fmt: skip
def test_some_by_hand(value, error, words):
    assert uncertain(value, error) == words


def test_known_digits_end_with_those_of_the_uncertainty():
    assert [count_known_digits(123.456, error) for error in (1e3, 99.0, 10.0, 1.0, 0.02, 1e-9)] == [1, 2, 2, 3, 5, 8]


def test_a_comparison_has_no_digits_finer_than_what_interpolation_misses():
    """Two histories some 0.1 rad apart, of which interpolation may miss 2e-3 rad."""
    times, half = np.arange(12.0), 0.05 * (1.0 + 0.1 * np.arange(12.0))
    still = AttitudeHistory("still", times, np.tile([1.0, 0.0, 0.0, 0.0], (12, 1)))
    turning = AttitudeHistory("turning", times, np.stack([np.cos(half), 0 * half, 0 * half, np.sin(half)], axis=-1))
    report = ComparisonReport(replace(compare(turning, still), interpolation_error=2e-3), "")
    lines = {label: words for group in report.answers for label, words in getattr(group, "lines", ())}
    assert lines["largest"] == "0.21 rad = 12°"
    said = [report.summary, lines["rms"], lines["body axes misaligned by"]]
    numbers = re.findall(NUMBER, " ".join(said))
    assert all(len(re.sub(r"e.*|\D|^0+", "", number.lstrip("-0."))) <= 3 for number in numbers), numbers
    assert collect_values(report.answers)["angle"]["largest"] == pytest.approx(0.21, rel=1e-12)
