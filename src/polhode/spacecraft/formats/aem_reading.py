"""CCSDS Attitude Ephemeris Messages read as trajectories, versions 1.0 and 2.0, keyword = value or XML.

Source: CCSDS 504.0-B-2, section 4, annex J for version 1.0.
"""

from __future__ import annotations

from pathlib import Path
from typing import NamedTuple

import numpy as np

from polhode._base import check
from polhode.errors import shown
from polhode.formats.aem_attitudes import COLUMNS, OLD_NAMES, Meaning
from polhode.formats.epochs import read_epoch, shortest, since
from polhode.formats.labels import AttitudeLabels, Recording, plain
from polhode.formats.paths import as_path
from polhode.motion._layout import ATTITUDE, StateLayout
from polhode.motion._outcome import Ending, Outcome
from polhode.motion._trajectory import Trajectory
from polhode.spacecraft.formats.adm_blocks import CHECK, Block, refuse
from polhode.spacecraft.formats.adm_keywords import AEM, AEM_NEEDED, OLD_RATES
from polhode.spacecraft.formats.adm_reading import read_blocks
from polhode.types import Array

ONE_ALONE = "Leave one of them in the file, or read one in Python by read_aem(path, segment=k), where k counts from 0."
IN_VERSION_2 = "Have it written in version 2.0."


class _Samples(NamedTuple):
    """The data of a segment: instants (n,), numbers (n, k), and their lines in the file (n,)."""

    whole: Array
    picoseconds: Array
    columns: Array
    lines: Array


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
    _, *blocks = read_blocks(path, AEM, _convert_rows)
    if not blocks:
        refuse(path, None, "holds no segment, META_START … DATA_STOP; it is cut short. Get it whole.")
    segments = [(block, _join_parts(block)) for block in blocks]
    if segment is not None:
        segments = [segments[check.whole(f"`segment` of {path}", segment, 0, len(segments) - 1)]]
    alike = ("OBJECT_NAME", "OBJECT_ID", "REF_FRAME_A", "REF_FRAME_B", "TIME_SYSTEM", "ATTITUDE_DIR")
    if len({tuple(plain(block.text(name, "")) for name in alike) for block, _ in segments}) > 1:
        refuse(path, None, f"its {len(segments)} segments are about different objects, frames or time systems. "
                           f"{ONE_ALONE}")
    start = segments[0][0].epoch("START_TIME")
    times, attitude, velocity = _join(path, [_history(*one, start) for one in segments])
    left_out = sum(int((~_useable(*one)).sum()) for one in segments)
    message = f"{left_out} samples outside the useable times were left out" if left_out else ""
    labels = _labels(segments[0][0])
    return Trajectory(
        times, attitude, StateLayout((ATTITUDE,)), attitude, angular_velocity=velocity,
        outcome=Outcome(Ending.RECORDED, message=message), source=Recording(labels.object_name, labels=labels),
    )


def _kind(block: Block) -> str:
    """Return the type of attitude, as version 2.0 names it."""
    name = plain(block.text("ATTITUDE_TYPE")).replace(" ", "_")
    name = OLD_NAMES.get(name, name) if _is_old(block) else name
    if name not in COLUMNS:
        block.wrong("ATTITUDE_TYPE", f"must be one of {', '.join(COLUMNS)}; got {shown(block.text('ATTITUDE_TYPE'))}")
    return name


def _is_old(block: Block) -> bool:
    return block.text(AEM.version_keyword) == "1.0"


def _check_metadata(block: Block) -> None:
    """Refuse metadata without a keyword that is needed, and spans that end before they begin.

    Raises:
        FormatError: naming the line.
    """
    for keyword, (value, _) in block.values.items():
        if not value:
            block.wrong(keyword, "must have a value")
    for keyword in AEM_NEEDED:
        block.text(keyword)
    for first, last in (("START_TIME", "STOP_TIME"), ("USEABLE_START_TIME", "USEABLE_STOP_TIME")):
        if first in block.values and last in block.values and block.epoch(last) < block.epoch(first):
            block.wrong(last, f"must not lie before {first}; got {block.text(last)}, and {block.text(first)} there")


def _convert_rows(block: Block) -> tuple[Array, ...]:
    """Return instants, numbers (n, k) and lines of a segment's data lines."""
    if not block.parts:
        _check_metadata(block)
    kind, time_system = _kind(block), block.time_system
    instants, columns, lines = block.read_rows(
        lambda word: read_epoch(word, time_system), len(COLUMNS[kind]), "as ATTITUDE_TYPE says")
    return instants.reshape(-1, 2), columns.reshape(-1, len(COLUMNS[kind])), lines


def _convert_states(block: Block) -> tuple[Array, ...]:
    """Return instants, numbers (n, k) and lines of a segment's attitudes in XML."""
    _check_metadata(block)
    kind, time_system, instants, columns = _kind(block), block.time_system, [], []
    known = {"EPOCH", *COLUMNS[kind]}
    if _is_old(block):
        known |= {name for pair in OLD_RATES.items() if not known.isdisjoint(pair) for name in pair}
    for state in block.states:
        for keyword in state.values:
            if keyword not in known:
                state.wrong(keyword, f"must not be there, as ATTITUDE_TYPE is {block.text('ATTITUDE_TYPE')}")
        epoch = state.text("EPOCH")
        try:
            instants.append(read_epoch(epoch, time_system))
        except ValueError as error:
            refuse(block.path, state.values["EPOCH"][1], f"the epoch {error}. {CHECK}")
        columns.append(state.numbers(COLUMNS[kind]))
    if _is_old(block) and kind.startswith("QUATERNION"):  # as the elements are taken by their names
        block.values["QUATERNION_TYPE"] = ("LAST", block.line)
    lines = np.array([state.line for state in block.states])
    return np.array(instants).reshape(-1, 2), np.array(columns).reshape(-1, len(COLUMNS[kind])), lines


def _join_parts(block: Block) -> _Samples:
    """Return the data of a segment.

    Raises:
        FormatError: where there are none, naming the line of an epoch that does not come after the one before.
    """
    parts = block.parts or [_convert_states(block)]
    instants, columns, lines = (np.concatenate(arrays) for arrays in zip(*parts, strict=True))
    if not len(lines):
        refuse(block.path, block.line, f"the data of this segment have no attitudes. {CHECK}")
    steps, parts_of_second = np.diff(instants, axis=0).T
    ascending = (steps > 0) | ((steps == 0) & (parts_of_second > 0))
    block.check_ascending(ascending, lines)
    return _Samples(instants[:, 0], instants[:, 1], columns, lines)


def _history(block: Block, given: _Samples, start: tuple[int, int]) -> tuple[Array, Array, Array | None]:
    """Return times, attitude and angular velocity of one segment over its useable time."""
    attitude, velocity = block.turn(_interpret(block), given.columns, given.lines)
    times, within = since(start, given.whole, given.picoseconds), _useable(block, given)
    return times[within], attitude[within], None if velocity is None else velocity[within]


def _useable(block: Block, given: _Samples) -> Array:
    """Return which samples (n,) of a segment lie within its useable time."""
    within = np.ones(len(given.whole), dtype=bool)
    for keyword, sign in (("USEABLE_START_TIME", 1), ("USEABLE_STOP_TIME", -1)):
        if keyword in block.values:
            whole, picoseconds = block.epoch(keyword)
            ahead = given.whole - whole
            within &= (sign * ahead > 0) | ((ahead == 0) & (sign * (given.picoseconds - picoseconds) >= 0))
    return within


def _join(path: Path, parts: list[tuple[Array, Array, Array | None]]) -> tuple[Array, Array, Array | None]:
    """Return histories joined; of two samples at the end of one and start of the next, the later one stays."""
    for k in range(len(parts) - 1):
        times, following = parts[k][0], parts[k + 1][0]
        if len(times) and len(following) and times[-1] == following[0]:
            times, attitude, velocity = parts[k]
            parts[k] = times[:-1], attitude[:-1], None if velocity is None else velocity[:-1]
    times = np.concatenate([part[0] for part in parts])
    if not len(times):
        refuse(path, None, "no sample lies within the useable times. Check USEABLE_START_TIME and USEABLE_STOP_TIME.")
    if (np.diff(times) <= 0).any():
        refuse(path, None, f"its segments overlap in time. {ONE_ALONE}")
    rates = [part[2] for part in parts if part[2] is not None]
    velocity = np.concatenate(rates) if len(rates) == len(parts) else None
    return times, np.concatenate([part[1] for part in parts]), velocity


def _choice(block: Block, keyword: str, choices: tuple[str, str], now: str, why: str) -> str:
    """Return which of two words a keyword of version 1.0 has; ``now`` is the only one in version 2.0, and ``why``."""
    word = plain(block.text(keyword, "" if _is_old(block) else now))
    if word not in choices:
        block.wrong(keyword, f"must be {' or '.join(choices)} in version 1.0; got {shown(word or 'nothing')}")
    if word != now and not _is_old(block):
        block.wrong(keyword, f"is of version 1.0; in version 2.0 {why}")
    return word


def _is_backward(block: Block) -> bool:
    """Whether the rotation is from body to space."""
    way = _choice(block, "ATTITUDE_DIR", ("A2B", "B2A"), "A2B", "the rotation is from A to B")
    return block.frames()[2] == (way == "A2B")


def _interpret(block: Block) -> Meaning:
    (space, body, _), backward, kind = block.frames(), _is_backward(block), _kind(block)
    family, _, rates = kind.partition("/")
    if family == "SPIN":
        if backward:
            block.wrong("ATTITUDE_TYPE", "of spin data wants the body as frame B and space as frame A; here it is the "
                                         "other way round", IN_VERSION_2)
        return Meaning(kind)
    sequence = block.sequence() if family == "EULER_ANGLE" else None
    scalar_first = family == "QUATERNION" and "FIRST" == _choice(
        block, "QUATERNION_TYPE", ("FIRST", "LAST"), "LAST", "the scalar is the last")
    if rates != "ANGVEL":
        return Meaning(kind, sequence, scalar_first, False, backward)
    if _is_old(block) and backward:
        block.wrong("ATTITUDE_TYPE", "with rates leaves open in version 1.0 which frame they are of when the rotation "
                                     "is from body to space", IN_VERSION_2)
    keyword = "RATE_FRAME" if _is_old(block) else "ANGVEL_FRAME"
    frame = plain(block.text(keyword, ""))
    names = {"REF FRAME A": block.text("REF_FRAME_A"), "REF FRAME B": block.text("REF_FRAME_B")}
    frame = plain(names.get(frame, frame))
    if frame not in (plain(space), plain(body)):
        block.wrong(keyword, f"must be one of the two frames, as there are velocities; got {shown(frame or 'nothing')}")
    return Meaning(kind, sequence, scalar_first, frame == plain(space), backward)


def _labels(block: Block) -> AttitudeLabels:
    space, body, _ = block.frames()
    return AttitudeLabels(
        object_name=block.text("OBJECT_NAME"),
        object_id=block.text("OBJECT_ID"),
        center=block.text("CENTER_NAME", "") or None,
        reference_frame=space,
        body_frame=body,
        epoch=shortest(block.epoch("START_TIME"), block.time_system),
        time_system=block.time_system,
        originator=block.text("ORIGINATOR", "") or None,
        spice_id=None,
        comments=tuple(block.comments),
    )
