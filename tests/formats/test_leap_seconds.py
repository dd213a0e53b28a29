"""Leap seconds of the IERS against those of the time-zone database, and what is said beyond both."""

import re
import warnings
from datetime import date, timedelta
from importlib import resources
from pathlib import Path

import astropy_iers_data
import numpy as np
import pytest

from polhode.errors import FormatError
from polhode.formats import epochs, leap_seconds
from polhode.formats.epochs import as_text, read_epoch
from polhode.formats.time_scales import leap_seconds_kernel, terrestrial_time

MONTHS = ("Jan", "Feb", "Mar", "Apr", "May", "Jun", "Jul", "Aug", "Sep", "Oct", "Nov", "Dec")
TABLE = Path(astropy_iers_data.IERS_LEAP_SECOND_FILE).read_text("utf-8")


def days_of_the_time_zone_database():
    """Days after a leap second, from lines like ``Leap 1972 Jun 30 23:59:60 + S``."""
    text = (resources.files("tzdata") / "zoneinfo" / "leapseconds").read_text("utf-8")
    lines = re.findall(r"^Leap\s+(\d+)\s+(\w+)\s+(\d+)\s+23:59:60\s+\+\s+S", text, re.MULTILINE)
    return [date(int(year), MONTHS.index(month) + 1, int(day)) + timedelta(1) for year, month, day in lines]


def table_of(tmp_path, text):
    path = tmp_path / "Leap_Second.dat"
    path.write_text(text, "utf-8")
    return leap_seconds.read_leap_seconds(path)


@pytest.fixture
def expired(tmp_path, monkeypatch):
    """The table as an installation of long ago would have it."""
    old = table_of(tmp_path, re.sub(r"expires on .*", "expires on 28 June 2016", TABLE[: TABLE.index("    57754")]))
    for module in (leap_seconds, epochs):
        monkeypatch.setattr(module, "leap_seconds", lambda: old)
    leap_seconds._warn_of_table.cache_clear()
    yield
    leap_seconds._warn_of_table.cache_clear()


def test_the_iers_and_the_time_zone_database_know_the_same_leap_seconds():
    theirs = days_of_the_time_zone_database()
    assert len(theirs) >= 27
    ours = [leap_seconds.ORIGIN + timedelta(day) for day in leap_seconds.leap_seconds().after]
    assert ours[: len(theirs)] == theirs[: len(ours)]


@pytest.mark.parametrize("after", days_of_the_time_zone_database(), ids=str)
def test_each_of_them_is_an_instant_of_its_own(after):
    last, first = f"{after - timedelta(1)}T23:59:60.25", f"{after}T00:00:00.25"
    (whole, picoseconds), (next_whole, _) = read_epoch(last, "UTC"), read_epoch(first, "UTC")
    assert next_whole - whole == 1 and picoseconds == 250_000_000_000
    assert as_text(np.array([whole]), np.array([picoseconds]), "UTC") == [f"{last}0000000000"]
    assert terrestrial_time(first, "UTC") - terrestrial_time(last, "UTC") == 1


@pytest.mark.filterwarnings("ignore:leap seconds are known")
def test_a_leap_second_to_come_is_counted(tmp_path, monkeypatch):
    """Nothing but the package's file has to change."""
    new = table_of(tmp_path, TABLE + "    61588.0    1  7 2027       38\n")
    monkeypatch.setattr(epochs, "leap_seconds", lambda: new)
    assert read_epoch("2027-07-01T00:00:00", "UTC")[0] - read_epoch("2027-06-30T23:59:60", "UTC")[0] == 1


@pytest.mark.usefixtures("expired")
def test_epochs_beyond_an_old_table_get_a_warning_with_the_remedy():
    said = r"known until 2016-06-28, by astropy-iers-data [\d.]+; .* Run `.* install -U astropy-iers-data`"
    with pytest.warns(UserWarning, match=said):
        found = read_epoch("2026-03-01T00:00:00", "UTC")
    assert found[0] == 86400 * (date(2026, 3, 1) - date(1970, 1, 1)).days + 26  # without that of 2016-12-31
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        read_epoch("2026-03-01T00:00:01", "UTC")  # said once is enough
    leap_seconds._warn_of_table.cache_clear()
    with pytest.warns(UserWarning, match=said):
        as_text(np.array([0, found[0]]) + 86400 * 1000, np.zeros(2, dtype=int), "UTC")


@pytest.mark.usefixtures("expired")
def test_what_the_table_says_nothing_of_gets_no_warning():
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        read_epoch("2016-06-27T23:59:59", "UTC")
        for system in ("TAI", "TT", "GPS"):
            read_epoch("2026-03-01T00:00:00", system)


def test_a_kernel_says_until_when_its_leap_seconds_are_known():
    until = leap_seconds.ORIGIN + timedelta(leap_seconds.leap_seconds().expires)
    assert f"known until {until};" in leap_seconds_kernel()


@pytest.mark.parametrize(
    ("text", "said"),
    [("", "is not the IERS's table"), ("<html>", "is not the IERS's table"),
     (TABLE.replace("expires", "ends"), "is not the IERS's table"),
     (TABLE.replace("       11\n", "       12\n"), "one second at a time"),
     (TABLE + "    61588.0    1  7 2027       36\n", "one second at a time")],
)  # fmt: skip
def test_tables_of_another_form_are_refused(text, said, tmp_path):
    with pytest.raises(FormatError, match=said):
        table_of(tmp_path, text)
