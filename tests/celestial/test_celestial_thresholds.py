"""Both sides of the thresholds of spins, series of the pole and the wobble: values just within, and just beyond."""

from pathlib import Path
from types import SimpleNamespace

import jaxtyping
import numpy as np
import pytest

from celestial.wobbling import DAY, YEAR, lines
from polhode.celestial import SpinOrbit, fit_chandler, fit_chandler_windows
from polhode.celestial.spin_orbit import answers, motion
from polhode.celestial.wobble import estimation, series_files
from polhode.celestial.wobble._pole_series import clean_pole
from polhode.celestial.wobble.report import WobbleReport
from polhode.errors import FormatError, InvalidInput

JULIAN_YEAR = 365.25 * DAY


def accepted(call):
    try:
        call()
    except (InvalidInput, FormatError):
        return False
    return True


def both(call, within, beyond):
    """Whether a call is accepted within a threshold, and beyond it."""
    return accepted(lambda: call(within)), accepted(lambda: call(beyond))


@pytest.mark.parametrize("excess, rise, verdict", [
    (20.1, 0.0, "chaotic"), (19.9, 0.0, "undecided"), (6.1, 0.0, "undecided"), (5.9, 0.0, "regular"),
    (5.9, 1.4, "regular"), (5.9, 1.6, "undecided"),
])  # fmt: skip
def test_growth_that_is_chaos(excess, rise, verdict):
    """ln|δ| exceeds ln t by one number, and rises by the other in the second half of 200 orbits."""
    last = np.log(2.0 * np.pi * 200) + excess
    assert motion._verdict(np.where(np.arange(200) > 100, last, last - rise)) == verdict


def test_librations_that_a_run_must_last():
    """On a circular orbit H(1) = 1: an asphericity of a tenth makes a tenth of a libration in an orbit."""
    system = SpinOrbit(0.1, 0.0)
    held = [motion._libration(system, 2.0 * np.pi * np.arange(count) + 0.01, 1.0) for count in (32, 30)]
    assert [one is None for one in held] == [False, True]


def test_orbits_whose_rates_overflow(monkeypatch):
    monkeypatch.setattr(jaxtyping.config, "jaxtyping_disable", True)
    table = lambda n: SimpleNamespace(orbital_period=2.0 * np.pi / n, eccentricity=0.1, asphericity=0.2)  # noqa: E731
    call = lambda n: answers._system(SimpleNamespace(), table(n))  # noqa: E731
    assert both(call, 0.99e100, 1.01e100) == (True, False)
    assert both(call, 1.01e-100, 0.99e-100) == (True, False)


def test_series_that_are_no_pole():
    series = lambda count, size: (DAY * np.arange(count), np.full(count, size), np.zeros(count))  # noqa: E731
    assert both(lambda count: clean_pole(*series(count, 1e-7)), 50, 49) == (True, False)
    assert both(lambda size: clean_pole(*series(60, size)), 0.0099, 0.0101) == (True, False)


def test_rows_of_files_that_are_no_pole():
    row = lambda day=5e4, x=0.1: series_files._check_row(Path("eop"), 1, (day, x, 0.1, 0.0, 0.0), None)  # noqa: E731
    assert both(row, 15_020.1, 15_019.9) == (True, False) and both(row, 89_999.9, 90_000.1) == (True, False)
    assert both(lambda x: row(x=x), 4.99, 5.01) == (True, False)


def test_series_too_short_for_a_fit():
    """Two beats of 6.39 years; means over 5 d of samples every 10 d span as much as the samples."""
    times, x, y = lines(np.random.default_rng(1), years=13.0, noise=1e-10)
    count = int(12.78 * JULIAN_YEAR / (10.0 * DAY)) + 1
    call = lambda n: fit_chandler(times[:n], x[:n], y[:n])  # noqa: E731
    assert both(call, count + 1, count) == (True, False)


@pytest.mark.long
def test_a_wobble_that_is_noise(monkeypatch):
    series = lines(np.random.default_rng(1))
    estimate = fit_chandler(*series).estimate
    ratio = float(estimate.value[1] / estimate.standard_error[1])

    def fit(significance):
        monkeypatch.setattr(estimation, "LIMITS", estimation.ChandlerLimits(min_significance=significance))
        fit_chandler(*series)

    assert both(fit, 0.999 * ratio, 1.001 * ratio) == (True, False)


def test_windows_that_are_refused():
    series = lines(np.random.default_rng(2), years=9.0)
    period = lambda days: fit_chandler_windows(*series, period=days * DAY)  # noqa: E731
    assert both(period, 380.1, 379.9) == (True, False) and both(period, 489.9, 490.1) == (True, False)
    # a thousandth less is allowed, for years of other lengths
    window = lambda years: fit_chandler_windows(*series, window=years * YEAR, period=433.0 * DAY)  # noqa: E731
    assert both(window, 3.9961, 3.9959) == (True, False)


def test_windows_that_lack_samples():
    """One window fits into six years, and a gap in it takes a share of its samples."""
    times, x, y = lines(np.random.default_rng(3), years=6.06)

    def fit(gap):
        kept = (times < 2.0 * YEAR) | (times >= (2.0 + 6.0 * gap) * YEAR)
        fit_chandler_windows(times[kept], x[kept], y[kept], period=433.0 * DAY)

    assert both(fit, 0.09, 0.11) == (True, False)


@pytest.mark.parametrize("change, words", [
    ({"energy_ratio": 0.0101}, "retrograde Chandler energy"), ({"energy_ratio": 0.0099}, None),
    ({"apart": 2.01}, "line and process disagree"), ({"apart": 1.99}, None),
    ({"whiteness": 0.0099}, "is correlated"), ({"whiteness": 0.0101}, None),
])  # fmt: skip
def test_notes_of_a_report(change, words):
    """Periods of two estimates with errors of 3 d and 4 d differ by a multiple of 5 d."""
    values = {"energy_ratio": 0.0, "apart": 0.0, "whiteness": 0.5, **change}
    estimate = lambda period, error: SimpleNamespace(value=[period], standard_error=[error])  # noqa: E731
    report = SimpleNamespace(
        series=SimpleNamespace(predicted=0), windows=SimpleNamespace(amplitude=np.ones(3)),
        line=SimpleNamespace(energy_ratio=values["energy_ratio"], estimate=estimate(433.0, 3.0)),
        process=SimpleNamespace(estimate=estimate(433.0 + 5.0 * values["apart"], 4.0), is_noise=True,
                                whiteness=values["whiteness"], quality_intervals={0.95: (30.0, 500.0)}),
    )  # fmt: skip
    notes = vars(WobbleReport)["notes"].fget(report)
    assert len(notes) == (words is not None) and all(words in note for note in notes)
