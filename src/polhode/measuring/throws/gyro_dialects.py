"""The headers of known gyro logs: one row of a table for each program that writes them.

A new one is a row of ``DIALECTS``. Names are compared in small letters, with or without a unit in brackets.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from polhode.formats.header_words import bare_name


class GyroDialect(NamedTuple):
    """How a program names its columns.

    Attributes:
        name: of the program.
        time: names of the column of times; the first that is there is taken.
        time_unit: of a column whose name has none.
        gyro: names of the columns along the device's x, y and z.
        rate_unit: of columns whose names have none.
        acceleration: likewise, of what includes gravity; in the same file or in one of ``beside``.
        beside: names of files next to the gyro's that have the acceleration.
        per_unit: m/s² of a unit of acceleration that has no name; None where it must have one.
    """

    name: str
    time: tuple[str, ...]
    time_unit: str
    gyro: tuple[str, str, str]
    rate_unit: str
    acceleration: tuple[tuple[str, str, str], ...] = ()
    beside: tuple[str, ...] = ()
    per_unit: float | None = 1.0


def _axes(words: str, letters: str = "xyz") -> tuple[str, str, str]:
    x, y, z = (words.format(letter) for letter in letters)
    return x, y, z


DIALECTS = (
    GyroDialect("AndroSensor", ("time since start in ms",), "ms", _axes("gyroscope {}"), "rad/s",
                (_axes("accelerometer {}"),)),
    GyroDialect("phyphox", ("time",), "s", _axes("gyroscope {}"), "rad/s",
                (_axes("acceleration {}"), _axes("accelerometer {}")), ("Accelerometer.csv",)),
    GyroDialect("Sensor Logger", ("seconds_elapsed",), "s", _axes("{}"), "rad/s",
                (_axes("{}"),), ("TotalAcceleration.csv",)),
    GyroDialect("Sensor Logger, all in one file", ("seconds_elapsed",), "s", _axes("gyroscope_{}"), "rad/s",
                (_axes("totalacceleration_{}"),)),
    GyroDialect("Betaflight", ("time",), "us", _axes("gyroadc[{}]", "012"), "deg/s",
                (_axes("accsmooth[{}]", "012"),), (), None),
)  # fmt: skip
GYRO_FILES = ("Gyroscope.csv", "Raw Data.csv", "Gyroscope rotation rate.csv")
"""Names of the gyro's table in a folder or an archive."""
ACCELERATION_UNITS = {"m/s²": 1.0, "m/s^2": 1.0, "m/s2": 1.0, "m/s/s": 1.0, "g": 9.80665}


def find_places(names: Sequence[str], wanted: Sequence[str]) -> tuple[int, ...] | None:
    """Return the indices of the columns of these names, from 0; None where one is missing or comes twice.

    >>> find_places(["Time (s)", "gyroADC[0] (deg/s)", "gyroADC[1]"], ["gyroadc[1]", "gyroadc[0]"])
    (2, 1)
    """
    known = [{name.strip().lower(), bare_name(name).strip().lower()} for name in names]
    places = [[place for place, words in enumerate(known) if name in words] for name in wanted]
    return tuple(each[0] for each in places) if all(len(each) == 1 for each in places) else None


def detect_dialect(names: Sequence[str]) -> GyroDialect | None:
    """Return the dialect of a header; None for an unknown one.

    >>> detect_dialect(["Time (s)", "Gyroscope x (rad/s)", "Gyroscope y (rad/s)", "Gyroscope z (rad/s)"]).name
    'phyphox'
    >>> detect_dialect(["time", "seconds_elapsed", "z", "y", "x"]).name, detect_dialect(["t", "a", "b", "c"])
    ('Sensor Logger', None)
    """
    known = (each for each in DIALECTS if find_places(names, each.gyro) and time_place(names, each) is not None)
    return next(known, None)


def time_place(names: Sequence[str], dialect: GyroDialect) -> int | None:
    """Return the index of the column of times, from 0."""
    candidates = (find_places(names, [name]) for name in dialect.time)
    return next((places[0] for places in candidates if places), None)


def acceleration_unit(name: str, dialect: GyroDialect) -> float | None:
    """Return a unit of acceleration in m/s², by the name of a column or by the dialect; None where neither says it.

    >>> acceleration_unit("Acceleration x (m/s^2)", DIALECTS[1]), acceleration_unit("accSmooth[0]", DIALECTS[-1])
    (1.0, None)
    """
    ending = name.strip().rpartition("(")[2].rstrip(") ").lower() if "(" in name else ""
    return ACCELERATION_UNITS.get(ending, dialect.per_unit)
