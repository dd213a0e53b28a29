"""Leap seconds as the IERS announces them, from the file that the package astropy-iers-data carries.

That package appears every month; its file gives the date up to which no leap second can be missing.

Source: IERS, Bulletin C, and its file Leap_Second.dat.
"""

from __future__ import annotations

import functools
import re
import shlex
import sys
import warnings
from dataclasses import dataclass
from datetime import date, timedelta
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path

from polhode.errors import FormatError

PACKAGE = "astropy-iers-data"
FIRST_OFFSET = 10  # TAI − UTC in 1972 [s]
ORIGIN = date(1970, 1, 1)
FIRST_DAY = (date(1972, 1, 1) - ORIGIN).days
_MONTHS = ("January", "February", "March", "April", "May", "June", "July", "August", "September", "October", "November",
           "December")  # fmt: skip
_ROW = re.compile(r"\s*(\d{5})(?:\.0*)?\s+(\d+)\s+(\d+)\s+(\d{4})\s+(\d+)\s*", re.ASCII)
_EXPIRES = re.compile(r"#\s*File expires on\s+(\d+)\s+([A-Za-z]+)\s+(\d{4})\s*", re.ASCII)


@dataclass(frozen=True)
class LeapSeconds:
    """The leap seconds since 1972.

    Attributes:
        after: days since 1970-01-01 that begin after a leap second, ascending: TAI − UTC rises by 1 s at each.
        expires: the day since 1970-01-01 from which on others may have been announced.
    """

    after: tuple[int, ...]
    expires: int


@functools.cache
def leap_seconds() -> LeapSeconds:
    """Return the leap seconds of the installed table.

    Raises:
        FormatError: if the table is not one that polhode reads.
    """
    import astropy_iers_data

    return read_leap_seconds(Path(str(astropy_iers_data.IERS_LEAP_SECOND_FILE)))


def read_leap_seconds(path: Path) -> LeapSeconds:
    """Return the leap seconds of a file like the IERS's Leap_Second.dat: MJD, day, month, year, TAI − UTC [s].

    Raises:
        FormatError: for another form, and for offsets that do not rise by one second from row to row.
    """
    lines = path.read_text("utf-8").splitlines()
    rows = [_ROW.fullmatch(line) for line in lines if line.strip() and not line.startswith("#")]
    expires = [match for line in lines if (match := _EXPIRES.fullmatch(line)) and match[2] in _MONTHS]
    if not rows or None in rows or len(expires) != 1:
        raise FormatError(f"{path}: is not the IERS's table of leap seconds. Install {PACKAGE} again.")
    table = [tuple(map(int, row.groups())) for row in rows if row]
    days = [(date(year, month, day) - ORIGIN).days for _, day, month, year, _ in table]
    offsets = [offset for *_, offset in table]
    if days[0] != FIRST_DAY or offsets != list(range(FIRST_OFFSET, FIRST_OFFSET + len(table))):
        raise FormatError(f"{path}: TAI − UTC must be 10 s in 1972 and rise by one second at a time, which is all that "
                          "polhode knows. Give times in TAI.")
    day, month, year = expires[0].groups()
    return LeapSeconds(tuple(days[1:]), (date(int(year), _MONTHS.index(month) + 1, int(day)) - ORIGIN).days)


def warn_beyond(day: int) -> None:
    """Warn if a day since 1970-01-01, in UTC, lies beyond the installed table; once, as files hold many epochs."""
    if day >= leap_seconds().expires:
        _warn_of_table()


@functools.cache
def _warn_of_table() -> None:
    try:
        number = f" {version(PACKAGE)}"
    except PackageNotFoundError:
        number = ""
    warnings.warn(
        f"leap seconds are known until {ORIGIN + timedelta(leap_seconds().expires)}, by {PACKAGE}{number}; epochs in "
        "UTC after that are off by a second for each that was announced since, or will be. "
        f"Run `{shlex.join([sys.executable, '-m', 'pip', 'install', '-U', PACKAGE])}`, or give times in TAI.",
        stacklevel=3,
    )
