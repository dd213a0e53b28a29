"""The units that times and rates are printed in change at the limits of ``UnitLimits``."""

import pytest

from polhode.reports import wording

LIMITS = wording.LIMITS


@pytest.mark.parametrize("factor, unit", [(0.99, "ms"), (1.0, "s")])
def test_short_times_are_read_in_milliseconds(factor, unit):
    assert wording.in_its_unit(factor * LIMITS.short).split()[1] == unit


@pytest.mark.parametrize("rate, unit", [
    (0.99 * LIMITS.slow, "°/d"), (1.01 * LIMITS.slow, " rpm"),
    (0.99 * LIMITS.fast, " rpm"), (1.01 * LIMITS.fast, " kHz"),
])  # fmt: skip
def test_slow_rates_are_read_in_degrees_a_day_and_fast_ones_in_turns_a_second(rate, unit):
    assert wording.write_rate(rate).endswith(unit)
