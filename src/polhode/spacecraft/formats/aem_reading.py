"""CCSDS Attitude Ephemeris Messages read as trajectories, versions 1.0 and 2.0, keyword = value."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np

from polhode.errors import FormatError, InvalidInput, shown
from polhode.formats.aem_attitudes import Meaning, attitudes
from polhode.formats.epochs import shortest, since
from polhode.formats.labels import AttitudeLabels, Recording, is_in_spacecraft, plain
from polhode.formats.paths import as_path
from polhode.motion._layout import ATTITUDE, StateLayout
from polhode.motion._outcome import Ending, Outcome
from polhode.motion._trajectory import Trajectory
from polhode.spacecraft.formats.aem_segments import Segment, WrittenInXml, read_segments, refuse
from polhode.spacecraft.formats.aem_xml import read_xml_segments
from polhode.types import Array

ONE_ALONE = ("Leave one of them in the file, or read one in Python by read_aem(path, segment=k), where k counts from 0")
_ROTATION_SEQUENCE = re.compile(r"([XYZ])(?!\1)([XYZ])(?!\2)[XYZ]")
_SAME = ("OBJECT_NAME", "OBJECT_ID", "REF_FRAME_A", "REF_FRAME_B", "TIME_SYSTEM", "ATTITUDE_DIR")


def read_aem(path: str | Path, segment: int | None = None) -> Trajectory:
    """Return the attitude history in a CCSDS AEM, version 1.0 or 2.0.

    Times count in seconds from the first START_TIME, leap seconds included. The attitude takes body to space, the frame
    that names a part of a spacecraft being the body's, else the second. The angular velocity, where the file has it or
    derivatives that it follows from, is along the body axes; there is no momentum. Segments of the same object and
    frames are joined; the angular velocity is None then unless all of them have it. Of each segment only the useable
    time is taken, and the trajectory's outcome counts the samples outside. The source is a ``Recording`` with labels.

    Args:
        path: the file.
        segment: index, from 0, of the one segment to read.

    Raises:
        InvalidInput: if the file is missing, or has no such segment.
        FormatError: naming the line, if it is no AEM or leaves open what it means.
    """
    path = as_path("path", path)
    try:
        segments = read_segments(path)
    except WrittenInXml:
        segments = read_xml_segments(path)
    if segment is not None:
        if not 0 <= segment < len(segments):
            raise InvalidInput(f"`segment` must be from 0 to {len(segments) - 1} in {path}; got {segment}.")
        segments = [segments[segment]]
    if len({tuple(plain(one.values.get(name, "")) for name in _SAME) for one in segments}) > 1:
        raise FormatError(f"{path}: its {len(segments)} segments are about different objects, frames or time systems. "
                          f"{ONE_ALONE}.")  # fmt: skip
    start = segments[0].epoch("START_TIME")
    times, attitude, velocity = _join([_history(one, start) for one in segments], segments)
    left_out = sum(int((~_useable(one)).sum()) for one in segments)
    message = f"{left_out} samples outside the useable times were left out" if left_out else ""
    labels = _labels(segments[0])
    return Trajectory(
        times, attitude, StateLayout((ATTITUDE,)), attitude, angular_velocity=velocity,
        outcome=Outcome(Ending.RECORDED, message=message), source=Recording(labels.object_name, labels=labels),
    )  # fmt: skip


def _history(one: Segment, start: tuple[int, int]) -> tuple[Array, Array, Array | None]:
    """Return times, attitude and angular velocity of one segment over its useable time."""
    meaning = _interpret(one)
    try:
        with np.errstate(all="ignore"):  # what overflows is not finite, and refused
            attitude, velocity = attitudes(meaning, one.columns)
    except ValueError as error:
        what, k = error.args
        refuse(one.path, int(one.numbers[k]), what)
    samples = attitude if velocity is None else np.concatenate([attitude, velocity], axis=-1)
    if (wrong := ~np.isfinite(samples).all(axis=-1)).any():
        refuse(one.path, int(one.numbers[np.argmax(wrong)]), "gives a rotation or a rate too large for numbers")
    times, within = since(start, one.whole, one.picoseconds), _useable(one)
    return times[within], attitude[within], None if velocity is None else velocity[within]


def _useable(one: Segment) -> Array:
    """Return which samples (n,) of a segment lie within its useable time."""
    within = np.ones(len(one.whole), dtype=bool)
    for keyword, sign in (("USEABLE_START_TIME", 1), ("USEABLE_STOP_TIME", -1)):
        if keyword in one.values:
            whole, picoseconds = one.epoch(keyword)
            ahead = one.whole - whole
            within &= (sign * ahead > 0) | ((ahead == 0) & (sign * (one.picoseconds - picoseconds) >= 0))
    return within


def _join(
    parts: list[tuple[Array, Array, Array | None]], segments: list[Segment]
) -> tuple[Array, Array, Array | None]:
    """Return histories joined; of two samples at the end of one and start of the next, the later one stays."""
    for k in range(len(parts) - 1):
        times, following = parts[k][0], parts[k + 1][0]
        if len(times) and len(following) and times[-1] == following[0]:
            times, attitude, velocity = parts[k]
            parts[k] = times[:-1], attitude[:-1], None if velocity is None else velocity[:-1]
    times = np.concatenate([part[0] for part in parts])
    if not len(times):
        refuse(segments[0].path, None, "no sample lies within the useable times. Check USEABLE_START_TIME and "
                                       "USEABLE_STOP_TIME")  # fmt: skip
    if (np.diff(times) <= 0).any():
        refuse(segments[0].path, None, f"its segments overlap in time. {ONE_ALONE}")
    rates = [part[2] for part in parts if part[2] is not None]
    velocity = np.concatenate(rates) if len(rates) == len(parts) else None
    return times, np.concatenate([part[1] for part in parts]), velocity


def _frames(one: Segment) -> tuple[str, str, bool]:
    """Return the space frame, the body's, and whether the rotation is from body to space."""
    a, b = one.values["REF_FRAME_A"], one.values["REF_FRAME_B"]
    first_is_body = is_in_spacecraft(a) and not is_in_spacecraft(b)
    direction = plain(one.values.get("ATTITUDE_DIR", "" if one.old else "A2B"))
    if direction not in ("A2B", "B2A"):
        one.wrong("ATTITUDE_DIR", f"must be A2B or B2A in version 1.0; got {shown(direction or 'nothing')}")
    if direction == "B2A" and not one.old:
        one.wrong("ATTITUDE_DIR", "is of version 1.0; in version 2.0 the rotation is from A to B")
    return *((b, a) if first_is_body else (a, b)), first_is_body == (direction == "A2B")


def _interpret(one: Segment) -> Meaning:
    space, body, backward = _frames(one)
    family, _, rates = one.kind.partition("/")
    if family == "SPIN":
        if backward:
            one.wrong("ATTITUDE_TYPE", "of spin data wants the body as frame B and space as frame A; here it is the "
                                       "other way round")  # fmt: skip
        return Meaning(one.kind)
    sequence = _sequence(one) if family == "EULER_ANGLE" else None
    if rates != "ANGVEL":
        return Meaning(one.kind, sequence, _scalar_first(one, family), False, backward)
    if one.old and backward:
        one.wrong("ATTITUDE_TYPE", "with rates leaves open in version 1.0 which frame they are of when the rotation is "
                                   "from body to space. Have it written in version 2.0")  # fmt: skip
    keyword = "RATE_FRAME" if one.old else "ANGVEL_FRAME"
    frame = plain(one.values.get(keyword, ""))
    names = {"REF FRAME A": one.values["REF_FRAME_A"], "REF FRAME B": one.values["REF_FRAME_B"]}
    frame = plain(names.get(frame, frame))
    if frame not in (plain(space), plain(body)):
        one.wrong(keyword, f"must be one of the two frames, as there are velocities; got {shown(frame or 'nothing')}")
    return Meaning(one.kind, sequence, _scalar_first(one, family), frame == plain(space), backward)


def _scalar_first(one: Segment, family: str) -> bool:
    if family != "QUATERNION":
        return False
    place = plain(one.values.get("QUATERNION_TYPE", "" if one.old else "LAST"))
    if place not in ("FIRST", "LAST"):
        one.wrong("QUATERNION_TYPE", f"must say FIRST or LAST, where the scalar is, in version 1.0; "
                                     f"got {shown(place or 'nothing')}")  # fmt: skip
    if place == "FIRST" and not one.old:
        one.wrong("QUATERNION_TYPE", "is of version 1.0; in version 2.0 the scalar is the last")
    return place == "FIRST"


def _sequence(one: Segment) -> str:
    text = one.values.get("EULER_ROT_SEQ", "")
    sequence = text.upper().translate(str.maketrans("123", "XYZ"))
    if not _ROTATION_SEQUENCE.fullmatch(sequence):
        one.wrong(
            "EULER_ROT_SEQ", "must be three axes, neighbours different, like ZXZ; "
            f"got {shown(text or 'nothing')}"
        )
    return sequence


def _labels(one: Segment) -> AttitudeLabels:
    space, body, _ = _frames(one)
    return AttitudeLabels(
        object_name=one.values["OBJECT_NAME"],
        object_id=one.values["OBJECT_ID"],
        center=one.values.get("CENTER_NAME"),
        reference_frame=space,
        body_frame=body,
        epoch=shortest(one.epoch("START_TIME"), one.time_system),
        time_system=one.time_system,
        originator=one.values.get("ORIGINATOR"),
        spice_id=None,
        comments=tuple(one.comments),
    )
