"""Calendar epochs of different time systems on one scale, for SPICE and for comparisons.

TT = TAI + 32.184 s, GPS = TAI − 19 s, TAI − UTC of whole leap seconds, and TDB − TT = K sin E with E = M + EB sin M, by
the formula and constants of SPICE, within 30 µs of the true one.

Source: NAIF, *Time Required Reading*; Moyer, Celestial Mechanics 23 (1981) 33.
"""

from __future__ import annotations

import math
from datetime import timedelta
from fractions import Fraction

from polhode._base import check
from polhode.errors import InvalidInput
from polhode.formats.epochs import PICO, read_epoch, shortest
from polhode.formats.leap_seconds import FIRST_DAY, FIRST_OFFSET, ORIGIN, leap_seconds

NOON = 946_728_000  # s from 1970-01-01T00:00:00 to 2000-01-01T12:00:00 of a uniform time system
TT_FROM_TAI = Fraction(32184, 1000)
TT_FROM = {
    "TT": Fraction(0),
    "TAI": TT_FROM_TAI,
    "GPS": TT_FROM_TAI + 19,
    "UTC": TT_FROM_TAI + FIRST_OFFSET,  # an instant in UTC has the later leap seconds counted already
}
CLOCKS = (*TT_FROM, "TDB")
"""Time systems whose epochs are brought onto one scale."""
K, EB, M0, M1 = 1.657e-3, 1.671e-2, 6.239996, 1.99096871e-7


def terrestrial_time(epoch: str, time_system: str) -> Fraction:
    """Return the TT seconds past J2000 (2000-01-01T12:00:00 TT) of a calendar epoch, exactly but for TDB.

    Raises:
        InvalidInput: for text that is no epoch, and a time system other than UTC, TAI, TT, TDB and GPS.

    >>> float(terrestrial_time("2000-01-01T11:58:55.816", "UTC"))
    0.0
    """
    if time_system == "TDB":
        barycentric = _time_since_noon(epoch, time_system)
        return barycentric - Fraction(periodic_term(float(barycentric)))
    return _time_since_noon(epoch, time_system) + TT_FROM[check.one_of("time_system", time_system, CLOCKS)]


def barycentric_time(epoch: str, time_system: str) -> Fraction:
    """Return the TDB seconds past J2000 of a calendar epoch, SPICE's ephemeris time; see ``terrestrial_time``."""
    if time_system == "TDB":
        return _time_since_noon(epoch, time_system)
    terrestrial = terrestrial_time(epoch, time_system)
    barycentric = float(terrestrial)
    for _ in range(3):  # each pass gains nine digits
        barycentric = float(terrestrial) + periodic_term(barycentric)
    return terrestrial + Fraction(periodic_term(barycentric))


def _time_since_noon(epoch: str, time_system: str) -> Fraction:
    try:
        whole, picoseconds = read_epoch(epoch, time_system)
    except ValueError as error:
        raise InvalidInput(f"`epoch` {error}.") from None
    return whole - NOON + Fraction(picoseconds, PICO)


def periodic_term(barycentric: float) -> float:
    """Return TDB − TT [s] at TDB seconds past J2000."""
    mean = M0 + M1 * barycentric
    return K * math.sin(mean + EB * math.sin(mean))


def as_epoch(seconds: Fraction) -> str:
    """Return the calendar epoch, in the same uniform time system, of seconds past its 2000-01-01T12:00:00.

    >>> as_epoch(Fraction(1, 2))
    '2000-01-01T12:00:00.5'
    """
    return shortest(divmod(round((seconds + NOON) * PICO), PICO), "TT")


def leap_seconds_kernel() -> str:
    """Return SPICE's leap-seconds kernel with these constants and the leap seconds known, as text."""
    known = leap_seconds()
    days = [ORIGIN + timedelta(day) for day in (FIRST_DAY, *known.after)]
    rows = ",\n".join(
        f"{'':17s}{FIRST_OFFSET + k},  @{day.year}-{'JAN' if day.month == 1 else 'JUL'}-1" for k, day in enumerate(days)
    )
    return f"""KPL/LSK

Leap seconds, by polhode. TAI - UTC as the IERS announces it in Bulletin C, in whole
seconds since 1972, known until {ORIGIN + timedelta(known.expires)}; the other constants are those of SPICE for TDB.

\\begindata

DELTET/DELTA_T_A = {float(TT_FROM_TAI)}
DELTET/K         = {K!r}
DELTET/EB        = {EB!r}
DELTET/M         = ( {M0!r}  {M1!r} )
DELTET/DELTA_AT  = (
{rows} )

\\begintext
"""
