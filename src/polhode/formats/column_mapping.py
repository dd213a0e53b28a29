"""The mapping that gives the columns of a plain table their meaning, in the words of ``polhode import``.

Nothing is assumed that would change the motion: units, the place of a quaternion's scalar and the sequence of Euler
angles must be given, here or by the names of the columns.
"""

from __future__ import annotations

import difflib
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, fields
from typing import TYPE_CHECKING, Any

import numpy as np

from polhode import rotation
from polhode.errors import InvalidInput, shown
from polhode.formats.header_words import ANGLE_UNITS, CALENDARS, RATE_UNITS, TIME_UNITS, find_unit
from polhode.formats.rate_scale import read_scale
from polhode.formats.time_scales import CLOCKS

Columns = tuple[str | int, ...]
if TYPE_CHECKING:
    Column = str | int | None
    Word = str | None
    Several = str | Sequence[str | int] | None
else:
    Column = Word = Several = Any
    """Words come from files too, so the mapping itself checks them, with its own messages."""
ORDERS = ("wxyz", "xyzw")
DIRECTIONS = ("body-to-space", "space-to-body")
DECIMALS = ("point", "comma")
COUNTS = {"quat": 4, "matrix": 9, "mrp": 3, "euler": 3, "gyro": 3}
"""How many columns each takes; three of a quaternion are its vector part."""
ATTITUDES = ("quat", "matrix", "mrp", "euler")


@dataclass(frozen=True)
class ColumnMapping:
    """The meaning of a plain table's columns; a column is given by its name, or its number from 1.

    Attributes:
        time: the column of the times, or two columns whose values add up, like seconds and nanoseconds.
        time_unit: "s", "ms", "us", "ns", "min", "h" or "d", one for each column; or a calendar: "mjd", "jd", "unix",
            "unix-ms", "unix-us", "unix-ns", "gmat", days from JD 2430000, or "gps", seconds from 1980 or weeks and
            seconds. None where the column's
            name says it, as "t [s]" or "time_ms" do, and for dates and times of day, which show what they are.
        time_system: of dates without a zone and of Julian days: "UTC", "TAI", "TT", "TDB" or "GPS".
        quat: the four columns of the attitude quaternion, as names or numbers with commas between, or a sequence; or
            the three of its vector part, whose scalar then follows from the length.
        order: "wxyz" or "xyzw", what these columns are in their order; None where their names end in w, x, y and z.
        direction: "body-to-space" where the rotation takes components along the body's axes to those along the axes
            of space, else "space-to-body"; None is the first, but for matrices, where it must be given unless an
            angular velocity shows it.
        matrix: the nine columns of the rotation matrix, row by row.
        mrp: the three columns of modified Rodrigues parameters.
        euler: the three columns of Euler angles, in the order of ``sequence``, instead of a quaternion.
        sequence: of the turns, as ``rotation.from_euler_angles`` takes it: capitals about the body's own axes.
        gyro: the three columns of the angular velocity along the body's axes x, y and z.
        unit: of the angles ("deg", "rad"), of the angular velocity ("deg/s", "rad/s", "rpm"), or both with a comma
            between; None where the names say them.
        scale: of raw counts of the angular velocity, instead of its unit, like "131 LSB/(deg/s)".
        decimal: "point", or "comma" for numbers like 0,5; None is the first.

    Raises:
        InvalidInput: with a line for each word that is wrong or missing.

    >>> mapping = ColumnMapping("t", time_unit="ms", quat="qw,qx,qy,qz", gyro=(6, 7, 8), unit="deg/s")
    >>> mapping.quat, mapping.gyro, mapping.rate_unit
    (('qw', 'qx', 'qy', 'qz'), (6, 7, 8), 'deg/s')
    """

    time: Column | Several
    time_unit: Several = None
    time_system: Word = None
    quat: Several = None
    order: Word = None
    direction: Word = None
    matrix: Several = None
    mrp: Several = None
    euler: Several = None
    sequence: Word = None
    gyro: Several = None
    unit: Several = None
    scale: Word = None
    decimal: Word = None

    def __post_init__(self) -> None:
        problems: list[str] = []
        for name, wanted in COUNTS.items():
            object.__setattr__(self, name, _columns(getattr(self, name), name, wanted, problems))
        object.__setattr__(self, "unit", _units(self.unit, problems))
        object.__setattr__(self, "time_unit", _time_units(self.time_unit, problems))
        problems += [*self._wrong_words(), *self._wrong_together()]
        if problems:
            raise InvalidInput(*problems)

    @property
    def angle_unit(self) -> str | None:
        """The unit of Euler angles in ``unit``."""
        return next((unit for unit in self.unit or () if unit in ANGLE_UNITS), None)

    @property
    def rate_unit(self) -> str | None:
        """The unit of the angular velocity in ``unit``."""
        return next((unit for unit in self.unit or () if unit in RATE_UNITS), None)

    @property
    def is_backward(self) -> bool:
        """Whether the attitude is the rotation from space to body."""
        return self.direction == DIRECTIONS[1]

    @property
    def attitude(self) -> Columns:
        """The columns of the attitude, none where there is none."""
        return tuple(self.quat or self.matrix or self.mrp or self.euler or ())

    def _wrong_words(self) -> Iterator[str]:
        if self.time is None:
            yield "time is missing: which column has the times? Give its name, or its number from 1."
        elif not (_is_column(self.time) or _are_two(self.time)):
            yield f'time must be the name of a column, like "t", or its number from 1; got {shown(self.time)}.'
        words = {"time_system": CLOCKS, "order": ORDERS, "direction": DIRECTIONS, "decimal": DECIMALS}
        for name, choices in words.items():
            value = getattr(self, name)
            if value is not None and value not in choices:
                yield f"{name} must be one of {', '.join(choices)}; got {shown(value)}."
        if self.scale is not None:
            try:
                read_scale(str(self.scale))
            except ValueError as error:
                yield f"scale {error}; got {shown(self.scale)}."
        if self.sequence is not None:
            try:
                rotation.from_euler_angles(np.zeros(3), str(self.sequence))
            except InvalidInput as error:
                yield f"{error}."

    def _wrong_together(self) -> Iterator[str]:
        """Yield words that are missing, and words about columns that are not given."""
        if not (self.attitude or self.gyro):
            yield "no column is an attitude or an angular velocity. Name them by quat, matrix, mrp, euler or gyro."
        given = [name for name in ATTITUDES if getattr(self, name)]
        if len(given) > 1:
            both = "both" if len(given) == 2 else "all"
            yield f"{' and '.join(given)} are {both} given, and {both} are the attitude. Leave one out."
        if self.order and not self.quat:
            yield "order is that of a quaternion, and quat is not given. Give it, or leave order out."
        if self.order and self.quat and len(self.quat) == 3:
            yield "order is that of four columns; three are the vector part, x, y and z. Leave it out."
        if self.euler and not self.sequence:
            yield 'euler needs sequence, the axes of the turns in the order of the columns, like "ZYX".'
        if self.sequence and not self.euler:
            yield "sequence is that of Euler angles, and euler is not given. Give it, or leave sequence out."
        if self.euler and (doubt := _explain_reversed_names(self.euler, self.sequence)):
            yield doubt
        if self.direction and not self.attitude:
            yield "direction is that of an attitude, and none is given. Leave it out."
        if self.scale and not self.gyro:
            yield "scale is that of counts of the angular velocity, and gyro is not given. Give it, or leave scale out."
        if self.scale and self.rate_unit:
            yield f"scale and the unit {self.rate_unit} are both given for the angular velocity. Leave one out."
        for unit, kind, name in ((self.angle_unit, "of angles", "euler"), (self.rate_unit, "of a rate", "gyro")):
            if unit and not getattr(self, name):
                yield f"unit {unit} is one {kind}, and {name} is not given. Give it, or leave the unit out."


def make_mapping(words: Mapping[str, Any]) -> ColumnMapping:
    """Return the mapping that has these words.

    Raises:
        InvalidInput: for words that are not those of a mapping, and as the mapping itself does.
    """
    known = [field.name for field in fields(ColumnMapping)]
    problems = []
    for name in words:
        if name not in known:
            near = difflib.get_close_matches(str(name).replace("-", "_"), known, 1)
            hint = f"did you mean {near[0]}?" if near else f"choose from {', '.join(known)}."
            problems.append(f"{shown(name)} is not a word of a mapping; {hint}")
    if problems:
        raise InvalidInput(*problems)
    return ColumnMapping(**{"time": None, **words})



def _is_column(value: Any) -> bool:
    if isinstance(value, str):
        return bool(value.strip())
    return isinstance(value, int) and not isinstance(value, bool) and value >= 1


def _columns(value: Any, name: str, wanted: int, problems: list[str]) -> Columns | None:
    """Return columns as a tuple, and note mistakes in them."""
    if value is None:
        return None
    matrix = "r11,r12,r13,r21,r22,r23,r31,r32,r33"
    example = {"quat": "qw,qx,qy,qz", "matrix": matrix, "mrp": "s1,s2,s3", "euler": "yaw,pitch,roll",
               "gyro": "gx,gy,gz"}[name]
    columns = tuple(word.strip() for word in value.split(",")) if isinstance(value, str) else value
    if not isinstance(columns, list | tuple) or not all(map(_is_column, columns)):
        problems.append(f'{name} must be columns by name or number, like "{example}"; got {shown(value)}.')
    elif len(columns) != wanted and not (name == "quat" and len(columns) == 3):
        problems.append(f'{name} must be {wanted} columns, like "{example}"; got {len(columns)}, {shown(value)}.')
    elif len(set(map(str, columns))) < len(columns):
        problems.append(f"{name} must be {len(columns)} different columns; got {shown(value)}.")
    return tuple(columns) if isinstance(columns, list | tuple) else ()


def _are_two(value: Any) -> bool:
    """Whether a word is two columns in a sequence; two names with a comma between are split where the file is known."""
    return isinstance(value, list | tuple) and len(value) == 2 and all(map(_is_column, value))


def _time_units(value: Any, problems: list[str]) -> tuple[str, ...] | None:
    """Return the units of the columns of times, and note mistakes in them."""
    if value is None:
        return None
    words = [word.strip() for word in value.split(",")] if isinstance(value, str) else value
    known = (*TIME_UNITS, *CALENDARS)
    if not isinstance(words, list | tuple) or not 1 <= len(words) <= 2 or any(word not in known for word in words):
        problems.append(f"time_unit must be one of {', '.join(known)}, or two of a sum, like s,ns; got {shown(value)}.")
        return None
    if len(words) == 2 and set(words) & set(CALENDARS):
        problems.append(f"time_unit is one word for both columns of a calendar, like gps; got {shown(value)}.")
        return None
    return tuple(words)


def _units(value: Any, problems: list[str]) -> tuple[str, ...] | None:
    """Return the units by their names here, and note mistakes in them."""
    if value is None:
        return None
    words = [word.strip() for word in value.split(",")] if isinstance(value, str) else value
    if not isinstance(words, list | tuple) or not all(isinstance(word, str) for word in words):
        problems.append(f'unit must be words, like "deg/s" or "deg,deg/s"; got {shown(value)}.')
        return None
    units: list[str] = []
    for word in words:
        unit = find_unit(word, RATE_UNITS) or find_unit(word, ANGLE_UNITS)
        if unit is None:
            choices = ", ".join((*ANGLE_UNITS, *RATE_UNITS))
            problems.append(f"unit must be one of {choices}; got {shown(word)}.")
        else:
            units.append(unit)
    for table, kind in ((ANGLE_UNITS, "angles"), (RATE_UNITS, "rates")):
        if sum(unit in table for unit in units) > 1:
            problems.append(f"unit has two units of {kind}; got {shown(value)}. Give one of each kind at most.")
    return tuple(units)


def _explain_reversed_names(columns: Sequence[str | int], sequence: Word) -> str:
    """Return a message where columns are named in the opposite order of the turns; "" elsewhere.

    "roll, pitch, yaw" with "ZYX" usually means turns by yaw, pitch and roll, one after the other; in the
    order as written roll would be about z.
    """
    named = [next((word for word in ("roll", "pitch", "yaw") if word in str(name).lower()), "") for name in columns]
    if named != ["roll", "pitch", "yaw"] or sequence not in ("ZYX", "zyx"):
        return ""
    reversed_names = ",".join(map(str, reversed(columns)))
    return (
        f"euler must have its columns in the order of the turns: {sequence} begins with one about {sequence[0]}, which "
        f'is rarely roll. Write euler "{reversed_names}", or give the columns by number if they are meant so.'
    )
