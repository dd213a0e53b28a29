"""Units and components in the names of columns."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Mapping, Sequence

TIME_UNITS = {
    "s": ("sec", "secs", "second", "seconds"),
    "ms": ("msec", "millisecond", "milliseconds"),
    "us": ("usec", "µs", "μs", "microsecond", "microseconds"),
    "ns": ("nsec", "nanosecond", "nanoseconds"),
    "min": ("mins", "minute", "minutes"),
    "h": ("hr", "hrs", "hour", "hours"),
    "d": ("day", "days"),
}
CALENDARS = ("mjd", "jd", "gps", "unix", "unix-ms", "unix-us", "unix-ns", "gmat")
"""Ways to count time from a calendar day, besides dates written out, which need no name."""
ANGLE_UNITS = {"deg": ("°", "degs", "degree", "degrees"), "rad": ("rads", "radian", "radians")}
RATE_UNITS = {
    "deg/s": ("°/s", "deg/sec", "degree/s", "degrees/s", "degrees/sec", "dps", "deg s-1", "deg s^-1", "deg_s",
              "deg_per_s", "deg_per_sec"),
    "rad/s": ("rad/sec", "radian/s", "radians/s", "radians/sec", "rad s-1", "rad s^-1", "rad_s",
              "rad_per_s", "rad_per_sec"),
    "rpm": ("rev/min", "r/min"),
}  # fmt: skip
"""Units by our name for them, with the other ways to write them; case does not matter."""
PER_SECOND = {"ms": 1e3, "us": 1e6, "ns": 1e9}  # divided by, which rounds once
IN_SECONDS = {"s": 1.0, "min": 60.0, "h": 3600.0, "d": 86400.0}
IN_RADIANS = {"deg": math.pi / 180.0, "rad": 1.0, "deg/s": math.pi / 180.0, "rad/s": 1.0, "rpm": math.pi / 30.0}
_BRACKETED = re.compile(r"(?P<name>.*?)\s*[\[(](?P<unit>[^\])]*)[\])]\s*")


def find_unit(word: str, units: Mapping[str, Iterable[str]]) -> str | None:
    """Return the unit that a word means, None for none.

    >>> find_unit("Deg/Sec", RATE_UNITS), find_unit("Hz", RATE_UNITS)
    ('deg/s', None)
    """
    word = " ".join(word.lower().split())
    return next((unit for unit, others in units.items() if word == unit or word in others), None)


def bare_name(name: str) -> str:
    """Return the name of a column without a unit in brackets.

    >>> bare_name("t [s]"), bare_name("Time (s)"), bare_name("time_ms")
    ('t', 'Time', 'time_ms')
    """
    match = _BRACKETED.fullmatch(name)
    return match["name"] if match and match["name"] else name.strip()


def unit_in(name: str, units: Mapping[str, Iterable[str]]) -> str | None:
    """Return the unit that a column's name ends in: in brackets, or behind an underscore.

    >>> unit_in("t [s]", TIME_UNITS), unit_in("time_ms", TIME_UNITS), unit_in("wx_rad_s", RATE_UNITS)
    ('s', 'ms', 'rad/s')
    >>> unit_in("gyro_x", RATE_UNITS), unit_in("gyros", TIME_UNITS)
    (None, None)
    """
    if match := _BRACKETED.fullmatch(name):
        return find_unit(match["unit"], units)
    words = name.strip().lower().split("_")
    endings = ["_".join(words[-k:]) for k in range(min(4, len(words) - 1), 0, -1)]  # the longest first
    return next((unit for ending in endings if (unit := find_unit(ending, units))), None)


def components_in(names: Sequence[str]) -> str | None:
    """Return the letters w, x, y and z in the order in which four names end in them; None unless all four occur.

    >>> components_in(["q_x", "q_y", "q_z", "q_w"]), components_in(["q0", "q1", "q2", "q3"])
    ('xyzw', None)
    """
    letters = "".join(bare_name(name)[-1:].lower() for name in names)
    return letters if sorted(letters) == sorted("wxyz") else None


SCALARS, VECTOR = "ws", "xyz"
_NUMBERED = re.compile(r"(?P<stem>.*?)(?P<number>\d+)(?P<end>\W*)", re.DOTALL)


def explain_vector_names(names: Sequence[str], all_names: Sequence[str]) -> str:
    """Return why three names are not those of a quaternion's vector part, x, y and z; "" where they may be.

    Letters tell components where each name ends in one, w or s for the scalar, or x, y and z. Numbers tell them where
    the table has no more than four columns of that name, counted from 0 or 1. Of four the first may be left out, as
    the scalar; the last may not, because numbers do not tell whether it or the first is the scalar.

    Args:
        names: the three.
        all_names: of the table.

    >>> explain_vector_names(["qw", "qx", "qy"], [])
    'their names end in w, x, y'
    >>> every = ["q0", "q1", "q2", "q3"]
    >>> explain_vector_names(every[:3], every), explain_vector_names(every[1:], every)
    ('the table has a fourth of them, q3', '')
    """
    max_components = 4
    letters = "".join(bare_name(name)[-1:].lower() for name in names)
    if len(letters) == len(VECTOR) and set(letters) <= set(SCALARS + VECTOR):
        return "" if letters == VECTOR else f"their names end in {', '.join(letters)}"
    families: dict[tuple[str, str], dict[int, str]] = {}
    for name in (*all_names, *names):
        if match := _NUMBERED.fullmatch(name.strip()) or _NUMBERED.fullmatch(bare_name(name)):
            families.setdefault((match["stem"], match["end"]), {})[int(match["number"][:9])] = name
    family = next((family for family in families.values() if set(names) <= set(family.values())), {})
    if not family or len(family) > max_components or max(family) > max_components:
        return ""  # they count columns of a table, not components
    numbers = [next(number for number, other in family.items() if other == name) for name in names]
    if numbers != list(range(numbers[0], numbers[0] + len(VECTOR))):
        return f"their names end in {', '.join(map(str, numbers))}"
    return f"the table has a fourth of them, {family[numbers[-1] + 1]}" if numbers[-1] + 1 in family else ""


ENTRIES = "11 12 13 21 22 23 31 32 33"
"""Row and column of the entries of a matrix, row by row."""


def entries_in(names: Sequence[str]) -> str | None:
    """Return row and column that nine names of a matrix's entries end in, counted from 1; None where they do not.

    >>> entries_in([f"R{i}{j}" for j in "123" for i in "123"]), entries_in([f"m[{k}]" for k in range(9)])
    ('11 21 31 12 22 32 13 23 33', None)
    """
    matches = [re.search(r"([0-3xyz])[\W_]*([0-3xyz])\W*$", name.lower()) for name in names]
    pairs = [match[1] + match[2] for match in matches if match]
    for letters in ("123", "012", "xyz"):
        if sorted(pairs) == sorted(i + j for i in letters for j in letters):
            return " ".join(f"{letters.index(i) + 1}{letters.index(j) + 1}" for i, j in pairs)
    return None
