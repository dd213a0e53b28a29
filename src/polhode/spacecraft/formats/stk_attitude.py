"""Reads attitude files of the Systems Tool Kit: keywords, then a line for each attitude.

Attitudes are rotations from the reference axes to the body's, so that STK's quaternion has the components of polhode's
body → space quaternion, scalar last. Direction cosine matrices, by rows, take components along the reference axes to
those along the body's. Angular velocities are in deg/s along the body's axes. Euler angles turn about axes as the
preceding turns have left them; yaw, pitch and roll turn about the reference axes, in the order of ``Sequence``, and are
written in the order yaw, pitch, roll.

Source: Ansys, *STK Help*, attitude file format (*.a); Connect commands AddAttitude Euler and AddAttitude ECIYPR.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

import numpy as np

from polhode import rotation
from polhode.errors import FormatError, shown
from polhode.formats.aem_attitudes import FAR_FROM_UNIT
from polhode.formats.attitude_columns import nearest_rotations
from polhode.formats.dates import read_date
from polhode.formats.epochs import read_epoch, shortest, since
from polhode.formats.labels import AttitudeLabels, Recording
from polhode.formats.numerals import read_number
from polhode.formats.opening import MB, read_text
from polhode.formats.paths import as_path
from polhode.motion._layout import ATTITUDE, StateLayout
from polhode.motion._outcome import Ending, Outcome
from polhode.motion._trajectory import Trajectory
from polhode.types import Array

LARGEST_FILE = 1000 * MB
WIDTHS = {"quaternions": 4, "quatscalarfirst": 4, "quatangvels": 7, "eulerangles": 3, "yprangles": 3,
          "dcm": 9, "dcmangvels": 12}  # fmt: skip
"""Numbers after the time, of the kinds of data that are read."""
DATED = {"utcg": 4, "iso-ymd": 1}
"""Words that the time of a line has in formats other than seconds."""
INERTIAL = ("j2000", "icrf", "inertial", "b1950", "meanofepoch", "trueofepoch", "temeofepoch")
_KIND = re.compile(r"attitudetime(\w+)", re.I)
_TURNS = re.compile(r"[123]{3}")


class _Group(NamedTuple):
    """The group of attitudes: its keywords, the kind of data, and lines of data with their numbers."""

    keywords: dict[str, str]
    kind: str
    rows: list[tuple[int, list[str]]]


def read_stk(path: str | Path) -> Trajectory:
    """Return the attitudes of an STK attitude file, times [s] counted from its ScenarioEpoch.

    Raises:
        InvalidInput: where the file is missing.
        FormatError: naming the line, for what is not such a file, or is of a kind that is not read here.
    """
    path = as_path("path", path)
    group = _read_group(path)
    clock = group.keywords.get("timeformat", "EpSec").lower()
    if clock != "epsec" and clock not in DATED:
        raise FormatError(f"{path}: TimeFormat must be EpSec, UTCG or ISO-YMD to be read here; got "
                          f"{shown(group.keywords['timeformat'])}. Write the file in EpSec.")
    ahead = DATED.get(clock, 1)
    numbers = np.array([_numbers(path, line, words[ahead:], group.kind) for line, words in group.rows])
    epoch = _read_scenario_epoch(path, group.keywords)
    if clock == "epsec":
        times = np.array([_numbers(path, line, words[:1], "")[0] for line, words in group.rows])
    else:
        dates = [(line, _without_quotes(" ".join(words[:ahead]))) for line, words in group.rows]
        times, epoch = _count_dates(path, dates, epoch)
    attitude, velocity = _attitudes(path, group, numbers)
    axes = group.keywords.get("coordinateaxes", "")
    still = axes.lower() in INERTIAL
    named = axes or "that it does not name"
    doubt = "" if still else f"its attitudes are relative to the axes {named}, which are taken as fixed in space"
    labels = None if epoch is None else AttitudeLabels(
        "", None, group.keywords.get("centralbody"), axes, "", epoch, "UTC", None, None
    )
    return Trajectory(
        times, attitude, StateLayout((ATTITUDE,)), attitude, angular_velocity=velocity,
        outcome=Outcome(Ending.RECORDED, message=doubt), source=Recording(path.name, labels),
    )


def _read_group(path: Path) -> _Group:
    keywords: dict[str, str] = {}
    kind, rows, inside = None, [], 0
    for number, line in enumerate(read_text(path, "STK attitude", LARGEST_FILE).splitlines(), 1):
        words = line.split("#")[0].split()
        if not words or number == 1:
            continue
        first = words[0].lower()
        if first == "begin":
            inside += 1
        elif first == "end":
            inside -= 1
            if inside == 0:
                break
        elif inside > 1:  # groups of segments' boundaries and the like
            continue
        elif kind is None and (match := _KIND.fullmatch(words[0])):
            kind = match[1].lower()
            if kind not in WIDTHS:
                known = ", ".join(("AttitudeTimeQuaternions", "AttitudeTimeQuatScalarFirst", "AttitudeTimeQuatAngVels",
                                   "AttitudeTimeEulerAngles", "AttitudeTimeYPRAngles", "AttitudeTimeDCM",
                                   "AttitudeTimeDCMAngVels"))  # fmt: skip
                raise FormatError(f"{path}, line {number}: {words[0]} is not read here, but {known}. Export one of "
                                  "these.")
        elif kind is None:
            keywords[first] = " ".join(words[1:]).strip('"')
        else:
            rows.append((number, words))
    else:
        raise FormatError(f"{path}: has no END Attitude, so it is cut short. Get it whole.")
    if kind is None or not rows:
        raise FormatError(f"{path}: has no lines of attitudes after its keywords. Check the file.")
    count = keywords.get("numberofattitudepoints")
    if count is not None and count != str(len(rows)):
        raise FormatError(f"{path}: NumberOfAttitudePoints is {count}, and there are {len(rows)} lines of attitudes. "
                          "Check the file.")
    return _Group(keywords, kind, rows)


def _numbers(path: Path, line: int, words: Sequence[str], kind: str) -> list[float]:
    try:
        if kind and len(words) != WIDTHS[kind]:
            raise ValueError(f"must have {WIDTHS[kind]} numbers after the time; got {len(words)}")
        return [read_number(word) for word in words]
    except ValueError as error:
        raise FormatError(f"{path}, line {line}: {error}. Check the file.") from None


def _read_scenario_epoch(path: Path, keywords: dict[str, str]) -> str | None:
    if (text := keywords.get("scenarioepoch")) is None:
        return None
    try:
        epoch = shortest(read_epoch(read_date(text)[0], "UTC"), "UTC")
    except ValueError as error:
        raise FormatError(f"{path}: ScenarioEpoch {error}. Check the file.") from None
    return epoch


def _without_quotes(text: str) -> str:
    """Return a date without the quotes that some programs put around it, because it has blanks."""
    return text[1:-1] if len(text) > 1 and text[0] == text[-1] == '"' else text


def _count_dates(path: Path, rows: Sequence[tuple[int, str]], epoch: str | None) -> tuple[Array, str]:
    """Return times [s] of dates from the scenario's epoch, or from the first of them."""
    instants = []
    for line, text in rows:
        try:
            date = read_date(text)[0]
            instants.append(read_epoch(date, "UTC"))
        except ValueError as error:
            raise FormatError(f"{path}, line {line}: {error}. Check the file.") from None
        epoch = epoch or date
    assert epoch is not None
    whole, picoseconds = np.array(instants, dtype=np.int64).T
    return since(read_epoch(epoch, "UTC"), whole, picoseconds), epoch


def _attitudes(path: Path, group: _Group, numbers: Array) -> tuple[Array, Array | None]:
    if group.kind in ("eulerangles", "yprangles"):
        sequence = group.keywords.get("sequence", "")
        if not _TURNS.fullmatch(sequence):
            raise FormatError(f"{path}: Sequence must be the axes of three turns, like 321, for angles; got "
                              f"{shown(sequence or 'nothing')}. Add it.")
        letters = "".join("XYZ"[int(digit) - 1] for digit in sequence)
        if group.kind == "yprangles":  # about the reference axes, and always in the order yaw, pitch, roll
            letters, numbers = letters.lower(), numbers[:, ["zyx".index(letter) for letter in letters.lower()]]
        try:
            return rotation.from_euler_angles(np.radians(numbers), letters), None
        except ValueError:
            raise FormatError(f"{path}: Sequence {sequence} turns twice about one axis. Correct it.") from None
    if group.kind in ("dcm", "dcmangvels"):  # by rows, from components along the reference axes to the body's
        to_body = numbers[:, :9].reshape(-1, 3, 3)
        attitude, _ = nearest_rotations(path, [line for line, _ in group.rows], np.swapaxes(to_body, 1, 2))
        return attitude, np.radians(numbers[:, 9:]) if group.kind == "dcmangvels" else None
    order = [0, 1, 2, 3] if group.kind == "quatscalarfirst" else [3, 0, 1, 2]
    with np.errstate(over="ignore"):  # of damaged numbers; infinite is too far from one
        lengths = np.linalg.norm(numbers[:, :4], axis=1)
    if (far := ~(np.abs(lengths - 1.0) <= FAR_FROM_UNIT)).any():
        row = int(np.argmax(far))
        raise FormatError(f"{path}, line {group.rows[row][0]}: a quaternion must have length 1 to {FAR_FROM_UNIT:g}; "
                          f"got {lengths[row]:.6g}. Check the file.")
    velocity = np.radians(numbers[:, 4:]) if group.kind == "quatangvels" else None
    return numbers[:, order] / lengths[:, None], velocity
