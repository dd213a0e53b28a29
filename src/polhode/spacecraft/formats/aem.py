"""Attitude histories as CCSDS Attitude Ephemeris Messages, written in version 2.0, keyword = value.

A is the space frame and B the body's. The quaternion from A to B is that of the rotation which takes the axes of A to
those of B, so it is polhode's body → space quaternion with the scalar moved to the end.

Source: CCSDS 504.0-B-2, Attitude Data Messages (2024), sections 4, 6 and annex F; "504" below.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from datetime import UTC, datetime
from pathlib import Path
from typing import NamedTuple, TextIO

import numpy as np

from polhode import rotation
from polhode._base import check
from polhode.errors import InvalidInput, shown
from polhode.formats.animation_keys import exact_motion
from polhode.formats.attitude_checks import single_attitude
from polhode.formats.epochs import TIME_SYSTEMS, as_text, later, read_epoch, since
from polhode.formats.labels import USUAL_ID, USUAL_ORIGINATOR, AttitudeLabels, find_labels, is_in_spacecraft, plain
from polhode.formats.paths import write_whole
from polhode.motion._trajectory import Trajectory
from polhode.types import Array

TYPES = {None: "QUATERNION", "derivative": "QUATERNION/DERIVATIVE", "angular velocity": "QUATERNION/ANGVEL"}


class LineLimits(NamedTuple):
    """What a line of the file may have.

    Attributes:
        max_length: characters; 504, 6.6.1.
    """

    max_length: int = 254


LIMITS = LineLimits()


def write_aem(
    trajectory: Trajectory,
    path: str | Path,
    labels: AttitudeLabels | None = None,
    rates: str | None = None,
) -> Path:
    """Write an attitude history as CCSDS AEM 2.0; the file appears whole or not at all.

    Quaternions have 16 significant digits, the most that the standard allows, epochs picoseconds; exact motions are
    evaluated at the very epochs that the file holds. Text is in capitals, as the standard wants it.

    Args:
        trajectory: of one body, at ascending times counted from the labels' epoch; the file is about the given axes.
        path: where to.
        labels: object, frames and epoch; by default those that the trajectory was read with, if any.
        rates: "angular velocity" (along the body axes, in deg/s), "derivative" (of the quaternion), or None.

    Raises:
        InvalidInput: for motions without attitude or the rates asked for, batches, times that do not ascend by a
            picosecond at least, labels that the format cannot hold, and where the file cannot be written.
    """
    if rates not in TYPES:
        raise InvalidInput(f'`rates` must be None, "derivative" or "angular velocity"; got {shown(rates)}.')
    if labels is None:
        labels = find_labels(trajectory) or AttitudeLabels()
        usual, named = AttitudeLabels(), ("object_name", "reference_frame", "body_frame")
        labels = replace(labels, **{name: getattr(labels, name) or getattr(usual, name) for name in named})
    if is_in_spacecraft(labels.reference_frame) and not is_in_spacecraft(labels.body_frame):
        raise InvalidInput(f"`reference_frame` {labels.reference_frame} has a name for frames of a spacecraft, and "
                           f"`body_frame` {labels.body_frame} has not: readers would take one for the other. "
                           "Rename one.")
    if plain(labels.reference_frame) == plain(labels.body_frame):
        raise InvalidInput("`reference_frame` and `body_frame` must be two frames; got "
                           f"{shown(labels.body_frame)} for both. Rename one.")
    single_attitude(trajectory, "an AEM")
    epoch = _epoch(labels)
    whole, picoseconds = later(epoch, trajectory.times)
    _check_ascending(np.asarray(trajectory.times), whole, picoseconds)
    if exact_motion(trajectory) is not None:
        again = trajectory.resample(since(epoch, whole, picoseconds))
        trajectory = again if trajectory.angular_velocity is not None else replace(again, angular_velocity=None)
    trajectory = trajectory.along("given")
    columns = _columns(trajectory, np.asarray(trajectory.attitude), rates)
    ends = as_text(whole[[0, -1]], picoseconds[[0, -1]], labels.time_system)
    head = _head(labels, TYPES[rates], *ends)
    with write_whole(path) as draft, draft.open("w", encoding="ascii", newline="\n") as file:
        file.writelines(f"{line}\n" for line in head)
        _write_lines(file, whole, picoseconds, labels.time_system, columns)
        file.write("DATA_STOP\n")
    return Path(path)


def _check_ascending(times: Array, whole: Array, picoseconds: Array) -> None:
    steps = np.diff(whole)
    ascending = (steps > 0) | ((steps == 0) & (np.diff(picoseconds) > 0))
    if not ascending.all():
        k = int(np.argmin(ascending))
        if (np.diff(times) > 0).all():
            raise InvalidInput(
                f"samples {k} and {k + 1} are {times[k + 1] - times[k]:.3g} s apart, and epochs of an AEM do not tell "
                "apart what is closer than a picosecond. Take samples further apart, or write a dataset or a C-kernel, "
                "which have every digit of the times."
            )
        raise InvalidInput(
            f"`times` of an AEM must ascend, by a picosecond at least; sample {k + 1} does not come after sample {k}. "
            "Leave it out, or write a dataset, which has every digit."
        )


def _columns(trajectory: Trajectory, attitude: Array, rates: str | None) -> Array:
    parts = [_scalar_last(attitude)]
    if rates is not None:
        if trajectory.angular_velocity is None:
            raise InvalidInput(
                f"`rates` {shown(rates)} need an angular velocity, and this motion has none. "
                "Leave them out."
            )
        velocity = np.asarray(trajectory.angular_velocity)
        if rates == "derivative":
            parts.append(_scalar_last(rotation.quaternion_rate(attitude, velocity)))
        else:
            parts.append(np.degrees(velocity))
    columns = np.concatenate(parts, axis=-1) + 0.0  # 504, 6.8.5: −0 is not supported
    if not np.isfinite(columns).all():
        raise InvalidInput("an AEM holds finite numbers only; the trajectory has others. Leave those samples out.")
    return columns


def _scalar_last(quaternion: Array) -> Array:
    return np.concatenate([quaternion[:, 1:], quaternion[:, :1]], axis=-1)


def _epoch(labels: AttitudeLabels) -> tuple[int, int]:
    check.one_of("time_system", labels.time_system, TIME_SYSTEMS)
    try:
        return read_epoch(labels.epoch, labels.time_system)
    except ValueError as error:
        raise InvalidInput(f"`epoch` {error}.") from None


def _head(labels: AttitudeLabels, kind: str, start: str, stop: str) -> Iterator[str]:
    yield "CCSDS_AEM_VERS = 2.0"
    yield "COMMENT Made by polhode"
    yield f"CREATION_DATE = {datetime.now(UTC):%Y-%m-%dT%H:%M:%S}"
    yield _line("ORIGINATOR", "originator", labels.originator or USUAL_ORIGINATOR)
    yield ""
    yield "META_START"
    for comment in labels.comments:
        yield _printable(f"COMMENT {comment}", "comments", comment)
    yield _line("OBJECT_NAME", "object_name", labels.object_name)
    yield _line("OBJECT_ID", "object_id", labels.object_id or USUAL_ID)
    if labels.center is not None:
        yield _line("CENTER_NAME", "center", labels.center)
    yield _line("REF_FRAME_A", "reference_frame", labels.reference_frame)
    yield _line("REF_FRAME_B", "body_frame", labels.body_frame)
    yield f"TIME_SYSTEM = {labels.time_system}"
    yield f"START_TIME = {start}"
    yield f"STOP_TIME = {stop}"
    yield f"ATTITUDE_TYPE = {kind}"
    if kind.endswith("ANGVEL"):
        yield _line("ANGVEL_FRAME", "body_frame", labels.body_frame)
    yield "META_STOP"
    yield ""
    yield "DATA_START"


def _line(keyword: str, name: str, value: str) -> str:
    if not value.strip():
        raise InvalidInput(f"`{name}` must not be empty in an AEM. Give it, or leave it out for its default.")
    return _printable(f"{keyword} = {value.upper()}", name, value)


def _printable(line: str, name: str, value: str) -> str:
    if not (value.isascii() and value.isprintable() and len(line) <= LIMITS.max_length):
        raise InvalidInput(f"`{name}` must be one line of printable ASCII, at most {LIMITS.max_length} characters with "
                           "its keyword, in an AEM; "
                           f"got {shown(value)}. Write it in ASCII.")
    return line


def _write_lines(file: TextIO, whole: Array, picoseconds: Array, time_system: str, columns: Array) -> None:
    form = "%s" + " % .15e" * columns.shape[1] + "\n"
    chunk = 50_000  # lines that are in memory as text at once
    for begin in range(0, len(columns), chunk):
        part = slice(begin, begin + chunk)
        epochs = as_text(whole[part], picoseconds[part], time_system)
        file.writelines(form % (epoch, *row) for epoch, row in zip(epochs, columns[part].tolist(), strict=True))
