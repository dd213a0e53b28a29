"""Logs as clean arrays: clocks that are rounded, lines that come twice, and hiccups."""

import numpy as np
import pytest

from polhode.errors import InvalidInput
from polhode.measuring import clean_log

TRUE = np.arange(1000) / 50
RATES = np.stack([np.sin(TRUE), np.cos(2 * TRUE), 0.1 * TRUE], axis=1)


@pytest.mark.parametrize("rounded", [np.floor, np.round])
@pytest.mark.parametrize("step", [0.021, 0.03, 0.1, 1.0])
def test_a_clock_coarser_than_the_samples_loses_none(rounded, step):
    """With a clock of .03 s a third of the samples was thrown away, the others late or early by up to .02 s."""
    log = clean_log(step * rounded(TRUE / step), RATES)
    assert len(log.times) == 1000 and log.repeats == 0 and log.spread > 20
    np.testing.assert_array_equal(log.rates, RATES)
    assert np.ptp(log.times - TRUE) < 0.06 * step  # but for where it begins, which a rounded clock does not tell


def test_a_coarse_clock_with_gaps_is_spread_between_its_own_times():
    kept = np.ones(1000, dtype=bool)
    kept[300:700] = False
    log = clean_log(0.1 * np.floor(TRUE[kept] / 0.1 + 1e-9), RATES[kept])
    assert len(log.times) == 600 and (np.diff(log.times) > 0).all()
    assert np.abs(log.times - TRUE[kept]).max() < 0.1


def test_lines_that_come_twice_and_hiccups_are_left_out():
    twice = np.repeat(np.arange(1000), 2)
    log = clean_log(TRUE[twice], RATES[twice])
    assert (len(log.times), log.repeats, log.spread) == (1000, 1000, 0)
    times = TRUE.copy()
    times[500] = times[499]
    log = clean_log(times, RATES)
    assert (len(log.times), log.repeats, log.spread) == (999, 1, 0)


def test_a_log_does_not_share_memory_with_what_it_is_made_of():
    times, rates = TRUE.copy(), RATES.copy()
    log = clean_log(times, rates)
    rates[:] = 0.0
    np.testing.assert_array_equal(log.rates, RATES)


def test_samples_closer_than_any_sensors_are_refused():
    """Of steps of 1e-302 s the answer was: Python int too large to convert to C ssize_t; of 1e-12 s, no memory."""
    for scale in (5e-301, 5e-11):
        with pytest.raises(InvalidInput, match=r"times of rates must lie 1e-09 s apart or more; got 1e-.*their unit"):
            clean_log(scale * TRUE, RATES)
    times = TRUE.copy()
    times[500] = np.nextafter(times[499], 1e3)  # rounding parts two samples of one time
    assert len(clean_log(times, RATES).times) == 1000
