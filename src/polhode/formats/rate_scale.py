"""Scales of raw counts, as data sheets of gyros print them."""

from __future__ import annotations

import re

from polhode.formats.header_words import IN_RADIANS, RATE_UNITS, find_unit

_COUNT = r"(?:lsb|counts?|digits?)"
_PER_RATE = re.compile(rf"(?P<number>\S+)\s*{_COUNT}\s*(?:/|per)\s*\(?\s*(?P<unit>[^()]+?)\s*\)?", re.I)
_PER_COUNT = re.compile(
    rf"(?P<number>\S+)\s*(?P<milli>m(?=dps))?\(?\s*(?P<unit>[^()]+?)\s*\)?\s*(?:/|per)\s*{_COUNT}", re.I
)
EXAMPLE = '"131 LSB/(deg/s)" or "8.75 mdps/LSB"'


def read_scale(text: str) -> float:
    """Return the rate [rad/s] of one count.

    Raises:
        ValueError: with a message, for text that is no scale.

    >>> round(1.0 / read_scale("131 LSB/(deg/s)"), 6), round(read_scale("70 mdps/LSB") * 180 / 3.141592653589793, 9)
    (7505.747116, 0.07)
    """
    for form, inverse in ((_PER_RATE, True), (_PER_COUNT, False)):
        match = form.fullmatch(text.strip())
        unit = find_unit(match["unit"], RATE_UNITS) if match else None
        if match is None or unit is None:
            continue
        try:
            number = float(match["number"])
        except ValueError:
            continue
        if not 1e-12 < number < 1e12:
            break
        if inverse:
            return IN_RADIANS[unit] / number
        return number * IN_RADIANS[unit] * (1e-3 if match["milli"] else 1.0)
    raise ValueError(f"must be counts a rate, or a rate a count, like {EXAMPLE}")
