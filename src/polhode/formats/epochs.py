"""Calendar epochs as attitude files write them, and the seconds between them, with leap seconds counted.

An instant is a pair of whole numbers: seconds of its own time system since 1970-01-01T00:00:00 of it, and picoseconds.
UTC counts its leap seconds, so that differences are SI seconds in it as in the uniform systems.
"""

from __future__ import annotations

import bisect
import functools
import re
from datetime import date, timedelta

import numpy as np

from polhode.errors import InvalidInput, shown
from polhode.formats.leap_seconds import FIRST_DAY, ORIGIN, leap_seconds, warn_beyond
from polhode.types import Array, Float64, Integer

TIME_SYSTEMS = ("UTC", "TAI", "TT", "TDB", "TCB", "TCG", "GPS")
PICO = 10**12
_FORM = re.compile(r"(\d{4})-(?:(\d\d)-(\d\d)|(\d{3}))T(\d\d):(\d\d):(\d\d)(?:\.(\d+))?Z?", re.ASCII)


def read_epoch(text: str, time_system: str) -> tuple[int, int]:
    """Return an instant from ``YYYY-MM-DDThh:mm:ss[.d…][Z]`` or the like with the day of the year, ``YYYY-DDDT…``.

    Digits beyond picoseconds are rounded.

    Raises:
        ValueError: with a message, for text that is not such an epoch.
    """
    match = _FORM.fullmatch(text)
    if not match:
        raise ValueError(f'must be an epoch like "2026-03-01T12:00:00.5" or "2026-060T12:00:00.5"; got {shown(text)}')
    day = _day(*match.group(1, 2, 3, 4))
    hour, minute, second = (int(match[k]) for k in (5, 6, 7))
    after: tuple[int, ...] = ()
    if time_system == "UTC":
        if day < FIRST_DAY:
            raise ValueError(f"lies before 1972, when UTC had no seconds of one length; got {shown(text)}. Use TAI")
        after = leap_seconds().after
        warn_beyond(day)
    longest = 60 if second == 60 and (hour, minute) == (23, 59) and day + 1 in after else 59
    if hour > 23 or minute > 59 or second > longest:
        raise ValueError(f"has no such time of day in {time_system}; got {shown(text)}")
    whole = 86400 * day + 3600 * hour + 60 * minute + second + bisect.bisect_right(after, day)
    digits = match[8] or ""
    carry, picoseconds = divmod((int(digits.ljust(13, "0")[:13]) + 5) // 10, PICO)
    return whole + carry, picoseconds


@functools.lru_cache(maxsize=64)  # lines of a file lie on few days
def _day(year: str, month: str | None, day: str | None, day_of_year: str | None) -> int:
    try:
        if day_of_year is None:
            return (date(int(year), int(month or 0), int(day or 0)) - ORIGIN).days
        ordinal_date = date(int(year), 1, 1) + timedelta(int(day_of_year) - 1)
        if ordinal_date.year != int(year):
            raise ValueError
        return (ordinal_date - ORIGIN).days
    except (ValueError, OverflowError):
        named = f"{month}-{day}" if day_of_year is None else f"day {day_of_year}"
        raise ValueError(f"has no such day; got {named} of {year}") from None


def later(
    epoch: tuple[int, int], times: Float64[Array, "time"]
) -> tuple[Integer[Array, "time"], Integer[Array, "time"]]:
    """Return the instants at times (T,) [s] after an epoch, rounded to picoseconds: whole seconds and picoseconds (T,).

    Raises:
        InvalidInput: for times that are not finite, or beyond the years that four digits write.
    """
    times = np.asarray(times, dtype=float)
    least, most = ((date(year, 1, 1) - ORIGIN).days * 86400 - epoch[0] for year in (1, 9999))
    if not ((times >= least) & (times <= most)).all():
        raise InvalidInput("`times` must be finite and lead to years from 1 to 9998, of four digits; check them.")
    floor = np.floor(times)
    carry, picoseconds = np.divmod(np.rint((times - floor) * PICO).astype(np.int64) + epoch[1], PICO)
    return floor.astype(np.int64) + carry + epoch[0], picoseconds


def since(
    epoch: tuple[int, int], whole: Integer[Array, "time"], picoseconds: Integer[Array, "time"]
) -> Float64[Array, "time"]:
    """Return the time (T,) [s] from an epoch to instants."""
    return (np.asarray(whole) - epoch[0]) + (np.asarray(picoseconds) - epoch[1]) / PICO


def as_text(whole: Integer[Array, "time"], picoseconds: Integer[Array, "time"], time_system: str) -> list[str]:
    """Return instants (T,) as ``YYYY-MM-DDThh:mm:ss.dddddddddddd``, leap seconds as 23:59:60.

    Raises:
        InvalidInput: for UTC before 1972.
    """
    whole = np.asarray(whole)
    within = np.zeros(whole.shape, dtype=bool)
    if time_system == "UTC":
        if (whole < 86400 * FIRST_DAY).any():
            raise InvalidInput("UTC before 1972 had no seconds of constant length. Choose the time system TAI.")
        leaps = np.array([86400 * day + k for k, day in enumerate(leap_seconds().after)])
        begun = np.searchsorted(leaps, whole, side="right")
        within = whole == leaps[np.maximum(begun, 1) - 1]
        whole = whole - begun
        if whole.size:
            warn_beyond(int(whole.max()) // 86400)
    labels = np.datetime_as_string(whole.astype("datetime64[s]")).tolist()
    return [
        f"{label[:-2]}60.{rest:012d}" if leap else f"{label}.{rest:012d}"
        for label, rest, leap in zip(labels, np.asarray(picoseconds).tolist(), within.tolist(), strict=True)
    ]


def shortest(epoch: tuple[int, int], time_system: str) -> str:
    """Return one instant without trailing zeros."""
    return as_text(np.array([epoch[0]]), np.array([epoch[1]]), time_system)[0].rstrip("0").rstrip(".")
