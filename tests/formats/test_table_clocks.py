"""Times of tables as dates, times of day, Julian days, GPS weeks and counts of nanoseconds, against other clocks."""

from datetime import UTC, datetime, timedelta
from fractions import Fraction

import numpy as np
import pytest

from polhode.errors import FormatError, InvalidInput
from polhode.formats import ColumnMapping, read_columns
from polhode.formats.dates import read_date
from polhode.formats.time_scales import terrestrial_time

RATES = {"gyro": "gx,gy,gz", "unit": "rad/s"}


@pytest.fixture
def read(tmp_path):
    def read(stamps, header="t", more=(), **words):
        path = tmp_path / "log.csv"
        path.write_text(f"{header},gx,gy,gz\n" + "".join(f"{stamp},1,2,{k}\n" for k, stamp in enumerate(stamps)))
        return read_columns(path, ColumnMapping(**{"time": "t"} | words | RATES))

    return read


def epoch_of(trajectory):
    labels = trajectory.source.labels
    return labels.epoch, labels.time_system


@pytest.mark.parametrize(("stamps", "epoch"), [
    (["2020-11-15T00:34:05.000Z", "2020-11-15T00:34:05.005Z", "2020-11-15T00:34:06.25Z"], "2020-11-15T00:34:05"),
    (["2020-11-15 01:34:05+01:00", "2020-11-15 01:34:05.005+01:00", "2020-11-15 01:34:06.25+0100"],
     "2020-11-15T00:34:05"),
    (["2020/11/14 23:59:59.5 UTC", "2020/11/14 23:59:59.505 UTC", "2020/11/15 00:00:00.75 UTC"],
     "2020-11-14T23:59:59.5"),
    (["2020-320T00:34:05Z", "2020-320T00:34:05.005Z", "2020-320T00:34:06.25Z"], "2020-11-15T00:34:05"),
])  # fmt: skip
def test_dates_with_a_zone(read, stamps, epoch):
    found = read(stamps)
    assert found.times.tolist() == [0.0, 0.005, 1.25] and epoch_of(found) == (epoch, "UTC")
    assert found.source.attributes["time"] == "column 1 't', dates"


def test_fractions_of_dates_are_exact(read):
    """Nanoseconds in 2020 as POSIX seconds in doubles are 2.4e-7 s apart."""
    stamps = [f"2020-11-15T00:34:05.{k * 1001:09d}Z" for k in range(5)]
    assert np.abs(read(stamps).times - np.arange(5) * 1.001e-6).max() < 1e-18


def test_a_leap_second_lasts_a_second(read):
    stamps = ["2016-12-31T23:59:59Z", "2016-12-31T23:59:60Z", "2017-01-01T00:00:00Z"]
    assert read(stamps).times.tolist() == [0.0, 1.0, 2.0]
    bare = [stamp[:-1] for stamp in (stamps[0], stamps[2])]
    assert read(bare, time_system="UTC").times.tolist() == [0.0, 2.0]
    assert read(bare, time_system="TAI").times.tolist() == [0.0, 1.0]


def test_dates_of_other_spellings(read):
    found = read(["1 Jun 2002 12:00:00.000", "01 June 2002 12:00:00.5"], time_system="TAI")
    assert found.times.tolist() == [0.0, 0.5] and epoch_of(found) == ("2002-06-01T12:00:00", "TAI")


def test_times_of_day_pass_midnight(read):
    found = read(["23:59:50.000000", "23:59:59.98", "00:00:00.01", "12:00:00", "23:00:00", "00:30:00"])
    assert found.times.tolist() == [86390.0, 86399.98, 86400.01, 129600.0, 169200.0, 174600.0]
    assert "pass midnight 2 times" in found.source.attributes["notes"][0] and found.source.labels is None


def test_julian_days_by_number(read):
    """J2000 is JD 2451545.0; days of UTC that end in a leap second have 86401 s, as SOFA has it."""
    found = read(["2451545.0", "2451545.25"], time_unit="jd", time_system="TT")
    assert found.times.tolist() == [0.0, 21600.0] and epoch_of(found) == ("2000-01-01T12:00:00", "TT")
    found = read(["57753.5", "57754.5"], header="MJD", time="MJD", time_system="UTC")
    assert found.times.tolist() == [0.0, 86400.5] and epoch_of(found) == ("2016-12-31T12:00:00.5", "UTC")
    assert found.source.attributes["time_resolution"] == pytest.approx(4320.0)


def test_julian_days_keep_all_digits(read):
    """A microsecond is 1.2e-11 days, and JD in doubles are 4e-5 s apart."""
    steps = np.arange(6) * 1e-6
    days = [f"2459168.{round(10**17 * (Fraction(1, 2) + Fraction(k, 86400 * 10**6))):017d}" for k in range(6)]
    assert np.abs(read(days, time_unit="jd", time_system="TAI").times - steps).max() < 1e-12


@pytest.mark.parametrize(("days", "unit", "resolution", "by_doubles"), [
    ("2461101.{:010d}", "jd", 0.5 * 2.0**-31 * 86400, True),  # 2²¹ ≤ JD < 2²², whose doubles are 2²¹⁻⁵² apart
    ("61100.{:017d}", "mjd", 0.5 * 2.0**-37 * 86400, True),
    ("31101.{:013d}", "gmat", 0.5 * 2.0**-38 * 86400, True),
    ("2461101.{:06d}", "jd", 0.0432, False),
    ("61100.{:010d}", "mjd", 4.32e-6, False),
])  # fmt: skip
def test_days_are_known_no_better_than_doubles_tell_them(read, days, unit, resolution, by_doubles):
    """Ten decimals of a Julian day promised 4.3e-6 s, and doubles are 4.0e-5 s apart there."""
    found = read([days.format(0), days.format(10**5)], time_unit=unit, time_system="UTC").source.attributes
    assert found["time_resolution"] == pytest.approx(resolution, rel=1e-12)
    (note,) = [note for note in found["notes"] if "decimals" in note]
    assert f"times are known to {resolution:.2g} s" in note
    assert ("double precision" in note) == by_doubles


@pytest.mark.parametrize("bare", [1, 2])
def test_a_date_without_a_zone_among_dates_with_one(read, bare):
    stamps = ["2026-03-01T12:00:00Z", "2026-03-01T12:00:02Z", "2026-03-01T12:00:04+00:00"]
    stamps[bare] = "2026-03-01 12:00:03"
    with pytest.raises(FormatError, match=f"line {bare + 2}, column 1 't': '2026-03-01 12:00:03' has no") as caught:
        read(stamps)
    assert "say `time_system` UTC if both are in UTC" in str(caught.value)
    assert read(stamps, time_system="UTC").times[bare] == 3.0


@pytest.mark.parametrize("unit", ["unix", "unix-ms", "unix-us", "unix-ns"])
def test_posix_seconds_are_utc(read, unit):
    first = datetime(2020, 11, 15, 0, 34, 5, tzinfo=UTC)
    per = {"unix": 0, "unix-ms": 3, "unix-us": 6, "unix-ns": 9}[unit]
    stamps = [str(int(first.timestamp()) * 10**per + k * 10 ** max(0, per - 3)) for k in range(4)]
    found = read(stamps, time_unit=unit)
    assert epoch_of(found) == ("2020-11-15T00:34:05", "UTC")
    assert found.times.tolist() == ([0.0, 1.0, 2.0, 3.0] if per == 0 else [0.0, 0.001, 0.002, 0.003])


def test_weeks_and_seconds_of_gps(read):
    """Of the calendar by ``datetime``, and GPS ahead of UTC by 18 s since 2017."""
    begin = datetime(1980, 1, 6) + timedelta(weeks=2131, seconds=345.5)
    found = read(["2131,345.5", "2131,346.75", "2132,0"], header="w,s", time="w,s", time_unit="gps")
    assert found.times.tolist() == [0.0, 1.25, 604800 - 345.5]
    assert epoch_of(found) == (begin.isoformat(timespec="milliseconds").rstrip("0"), "GPS")
    single = read([str(2131 * 604800 + 345.5), str(2131 * 604800 + 346.75)], time_unit="gps")
    assert epoch_of(single) == epoch_of(found)
    utc = (begin - timedelta(seconds=18)).isoformat(timespec="milliseconds")
    assert terrestrial_time(*epoch_of(found)) == terrestrial_time(utc, "UTC")
    old = read(["83,0", "83,1"], header="w,s", time="w,s", time_unit="gps")
    assert "modulo 1024" in old.source.attributes["notes"][1]


def test_seconds_and_nanoseconds_add_up_exactly(read):
    """1605400445 s and 123456789 ns have nineteen digits."""
    stamps = ["1605400445,123456789", "1605400445,123456790", "1605400446,0"]
    found = read(stamps, header="secs,nsecs", time="secs,nsecs", time_unit="s,ns")
    exact = [0, Fraction(1, 10**9), Fraction(876543211, 10**9)]
    assert found.times.tolist() == [float(one) for one in exact]
    assert found.source.attributes["counted_from"] == "1605400445.123456789"
    again = read(["1605400445123456789", "1605400445123456790", "1605400446000000000"], time_unit="ns")
    assert again.times.tolist() == found.times.tolist()


def test_hours_and_days(read):
    assert read(["0", "0.5"], header="t [d]").times.tolist() == [0.0, 43200.0]
    assert read(["0", "0.5"], time_unit="h").times.tolist() == [0.0, 1800.0]


def test_a_coarse_clock_is_spread(read):
    """Samples every 20 ms on a clock that ticks every 30 ms, as in logs of schedulers; the grid is known."""
    true = np.arange(300) * 0.02
    ticks = np.floor(true / 0.03 + 1e-9) * 30
    found = read([f"{tick:.0f}" for tick in ticks], time_unit="ms")
    assert np.diff(found.times) == pytest.approx(0.02, abs=1e-5) and found.source.attributes["spread"] == 100
    assert "its clock is rounded: 100 lines" in found.source.attributes["notes"][-1]


@pytest.mark.parametrize(("stamps", "words", "said"), [
    (["2020-11-15T00:34:05", "2020-11-15T00:34:06"], {}, "system of column 1 't' is not known. Say it by `time_"),
    (["59000.5", "59000.6"], {"time_unit": "mjd"}, "Say it by `time_system` UTC"),
    (["2020-11-15T00:34:05Z", "2020-11-15T00:34:06Z"], {"time_system": "TAI"}, "Leave `time_system` out"),
    (["2020-11-15T00:34:05Z", "2020-11-31T00:34:06Z"], {}, "line 3, column 1 't': has no such day"),
    (["2020-11-15T00:34:05Z", "noon"], {}, "line 3, column 1 't': must be a date"),
    (["2020-12-31T23:59:60Z", "2021-01-01T00:00:01Z"], {}, "line 2, column 1 't': has no such time of day in UTC"),
    (["1971-06-01T00:00:00Z", "1971-06-01T00:00:01Z"], {}, "lies before 1972"),
    (["23:59:50", "25:99:00"], {}, "has no such time"),
    (["23:59:50", "23:59:40"], {}, "is before that of line 2"),
    (["2020-11-15T00:34:05Z", "2020-11-15T00:34:06Z"], {"time_unit": "s"}, "`time_unit` must be left out"),
    (["59000.5", "five"], {"time_unit": "mjd", "time_system": "TT"}, "line 3, column 1 't'"),
    (["1e40", "1e41"], {"time_unit": "unix"}, "line 2"),
    (["9e12", "9.1e12"], {"time_unit": "mjd", "time_system": "TT"}, "line 2"),
    (["1772366400000000000", "1772366401000000000"], {"time_unit": "unix"}, "in unix; unix-ns may be meant"),
    (["1772366400000000000", "1772366401000000000"], {}, "count from a day of a calendar, mjd|jd|gps"),
    (["01/03/2026 12:00:00", "01/03/2026 12:00:01"], {}, "neither a number nor a date or time of day. Write dates"),
])  # fmt: skip
def test_stamps_that_are_none(read, stamps, words, said):
    with pytest.raises((InvalidInput, FormatError)) as caught:
        read(stamps, **words)
    assert said in str(caught.value) and "log.csv" in str(caught.value)


def test_two_columns_need_units(read):
    with pytest.raises(InvalidInput, match="need a unit each, like `time_unit` s,ns"):
        read(["1,2", "1,3"], header="a,b", time="a,b")
    with pytest.raises(InvalidInput, match="one column has the times"):
        read(["1", "2"], time_unit="s,ns")
    with pytest.raises(InvalidInput, match="one word for both columns"):
        read(["1", "2"], time_unit="gps,s")


def test_dates_of_zones_by_datetime():
    """Against ``datetime`` over days, months and years that end in between."""
    generator = np.random.default_rng(5)
    for _ in range(200):
        minutes = int(generator.integers(-14 * 60, 14 * 60))
        moment = datetime(2020, 12, 31, 22, 10) + timedelta(minutes=int(generator.integers(-10**6, 10**6)))
        zone = f"{'-' if minutes < 0 else '+'}{abs(minutes) // 60:02d}:{abs(minutes) % 60:02d}"
        text = f"{moment:%Y-%m-%dT%H:%M:%S}{zone}"
        wanted = datetime.fromisoformat(text).astimezone(UTC)
        assert read_date(text) == (f"{wanted:%Y-%m-%dT%H:%M:%S}", True)
