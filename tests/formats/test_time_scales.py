"""Calendar epochs against SPICE's own arithmetic, and by hand."""

from fractions import Fraction

import pytest
import spiceypy as spice

from polhode.errors import InvalidInput
from polhode.formats.time_scales import as_epoch, barycentric_time, leap_seconds_kernel, terrestrial_time

ULP = 1.2e-7  # of SPICE's double of seconds since 2000, to which both round, in 2026
EPOCHS = ["2000-01-01T12:00:00", "2026-03-01T12:34:56.789", "1972-01-01T00:00:00", "2016-12-31T23:59:60.5",
          "2017-01-01T00:00:00", "2015-06-30T23:59:59.999"]  # fmt: skip


@pytest.fixture
def leap_seconds(tmp_path):
    kernel = tmp_path / "own.tls"
    kernel.write_text(leap_seconds_kernel())
    spice.furnsh(str(kernel))
    yield
    spice.unload(str(kernel))


@pytest.mark.parametrize("epoch", EPOCHS)
def test_utc_is_what_spice_makes_of_it(leap_seconds, epoch):
    found = spice.str2et(epoch)
    assert abs(float(barycentric_time(epoch, "UTC")) - found) <= ULP
    assert abs(float(terrestrial_time(epoch, "UTC")) - spice.unitim(found, "ET", "TDT")) <= ULP


@pytest.mark.parametrize(("system", "theirs"), [("TT", "TDT"), ("TDB", "TDB")])
def test_dynamical_times_are_what_spice_makes_of_them(leap_seconds, system, theirs):
    found = spice.str2et(f"2026-03-01 12:34:56.789 {theirs}")
    assert abs(float(barycentric_time("2026-03-01T12:34:56.789", system)) - found) <= ULP


def test_the_systems_stand_apart_as_they_should():
    utc, tai, tt, gps = (terrestrial_time("2026-01-01T00:00:00", x) for x in ("UTC", "TAI", "TT", "GPS"))
    assert (utc - tt, tai - tt, gps - tt) == (Fraction(69184, 1000), Fraction(32184, 1000), Fraction(51184, 1000))


def test_tai_and_utc_drift_apart_by_every_leap_second():
    """Counts of leap seconds at some dates, from the IERS's table of TAI − UTC."""
    for year, offset in ((1972, 10), (1973, 12), (1980, 19), (1990, 25), (1999, 32), (2009, 34), (2017, 37)):
        epoch = f"{year}-01-01T00:00:00"
        assert terrestrial_time(epoch, "UTC") - terrestrial_time(epoch, "TAI") == offset


def test_days_of_the_year_and_back_to_the_calendar():
    assert terrestrial_time("2026-060T01:02:03.25", "TT") == terrestrial_time("2026-03-01T01:02:03.25", "TT")
    for epoch in ("2026-03-01T01:02:03.25", "1999-12-31T23:59:59.999999999", "2000-01-01T12:00:00"):
        assert as_epoch(terrestrial_time(epoch, "TT")) == epoch


@pytest.mark.parametrize(
    ("epoch", "system", "words"),
    [("2026-02-30T00:00:00", "TT", "epoch"), ("1960-01-01T00:00:00", "UTC", "1972"),
     ("2026-01-01T00:00:00", "TCB", "must be one of")],
)  # fmt: skip
def test_what_is_no_epoch_is_refused(epoch, system, words):
    with pytest.raises(InvalidInput, match=words):
        terrestrial_time(epoch, system)
