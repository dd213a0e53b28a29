"""Dates and times of day as tables write them, brought into the one form that ``epochs.read_epoch`` takes."""

from __future__ import annotations

import re
from datetime import datetime, timedelta
from decimal import Decimal

from polhode.errors import shown

MONTHS = ("jan", "feb", "mar", "apr", "may", "jun", "jul", "aug", "sep", "oct", "nov", "dec")
_ZONE = r"\s*(?P<zone>Z|z|UTC|[+-]\d\d(?::?\d\d)?)?"
_DAY = r"(?P<year>\d{4})[-/](?:(?P<month>\d\d)[-/](?P<day>\d\d)|(?P<doy>\d{3}))[T ]\s*"
_NAMED = r"(?P<nday>\d{1,2})\s+(?P<nmonth>[A-Za-z]{3})[a-z]*\s+(?P<nyear>\d{4})\s+"
_TIME = r"(?P<hour>\d\d):(?P<minute>\d\d):(?P<second>\d\d)(?:[.,](?P<rest>\d*))?"
_DATE = re.compile(f"(?:{_DAY}|{_NAMED}){_TIME}{_ZONE}", re.ASCII)
_TIME_OF_DAY = re.compile(r"(\d{1,4}):(\d\d):(\d\d(?:\.\d*)?)", re.ASCII)


def is_date(text: str) -> bool:
    """Whether a text is a date with a time of day.

    >>> [is_date(text) for text in ("2020-11-15T00:34:05.5Z", "1 Jun 2002 12:00:00", "12:00:00", "59000.5")]
    [True, True, False, False]
    """
    return _DATE.fullmatch(text.strip()) is not None


def is_time_of_day(text: str) -> bool:
    """Whether a text is a time of day alone, like 23:59:50.25."""
    return _TIME_OF_DAY.fullmatch(text.strip()) is not None


def read_date(text: str) -> tuple[str, bool]:
    """Return a date as ``YYYY-MM-DDThh:mm:ss.d…``, in UTC where it has a zone, and whether it has one.

    A leap second, 23:59:60, stays one where the zone is UTC's.

    Raises:
        ValueError: with a message, for text that is no date.

    >>> read_date("2020-11-15 01:34:05.25+01:00")
    ('2020-11-15T00:34:05.25', True)
    >>> read_date("1 Jun 2002 12:00:00")
    ('2002-06-01T12:00:00', False)
    """
    match = _DATE.fullmatch(text.strip())
    if not match:
        raise ValueError(f'must be a date like "2026-03-01T12:00:00.5Z"; got {shown(text)}')
    part = match.groupdict()
    if part["nyear"]:
        if part["nmonth"].lower() not in MONTHS:
            raise ValueError(f"has no such month; got {shown(text)}")
        day = f"{part['nyear']}-{MONTHS.index(part['nmonth'].lower()) + 1:02d}-{int(part['nday']):02d}"
    elif part["doy"]:
        day = f"{part['year']}-{part['doy']}"
    else:
        day = f"{part['year']}-{part['month']}-{part['day']}"
    hour, minute, zone = part["hour"], part["minute"], part["zone"]
    if zone and zone[0] in "+-" and (ahead := _minutes(zone)):
        day, hour, minute = _shift(text, day, int(hour), int(minute), ahead)
    rest = f".{part['rest']}" if part["rest"] else ""
    return f"{day}T{hour}:{minute}:{part['second']}{rest}", bool(zone)


def _minutes(zone: str) -> int:
    digits = zone[1:].replace(":", "").ljust(4, "0")
    return (-1 if zone[0] == "-" else 1) * (60 * int(digits[:2]) + int(digits[2:]))


def _shift(text: str, day: str, hour: int, minute: int, ahead: int) -> tuple[str, str, str]:
    """Return day, hour and minute in UTC of a zone that is some minutes ahead; seconds are equal in all zones."""
    form = "%Y-%j" if len(day) == 8 else "%Y-%m-%d"
    try:
        moment = datetime.strptime(day, form) + timedelta(hours=hour, minutes=minute - ahead)
    except (ValueError, OverflowError):
        raise ValueError(f"has no such day; got {shown(text)}") from None
    return f"{moment:%Y-%m-%d}", f"{moment:%H}", f"{moment:%M}"


def read_time_of_day(text: str) -> Decimal:
    """Return the seconds of a time of day, or of a stopwatch, exactly.

    Raises:
        ValueError: with a message, for text that is none.

    >>> read_time_of_day("23:59:50.02")
    Decimal('86390.02')
    """
    match = _TIME_OF_DAY.fullmatch(text.strip())
    if not match:
        raise ValueError(f"must be a time like 23:59:50.25; got {shown(text)}")
    hours, minutes, seconds = int(match[1]), int(match[2]), Decimal(match[3])
    if minutes > 59 or seconds >= 61:
        raise ValueError(f"has no such time; got {shown(text)}")
    return 3600 * hours + 60 * minutes + seconds
