"""Checks of SPICE kernels before SPICE reads them: lists that end, counts that fit, text that loads nothing.

SPICE follows a C-kernel's lists without looking whether they end, and a text kernel may have it load other files.

Source: NAIF, *DAF Required Reading*, *CK Required Reading*, *Kernel Required Reading* (toolkit N0067).
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple, NoReturn

import numpy as np

from polhode.errors import FormatError, shown
from polhode.formats.opening import MB, read_file
from polhode.spacecraft.formats.spice_kernels import DIRECTORY
from polhode.types import Array, Float64

RECORD = 1024  # bytes
SUMMARIES_PER_RECORD = 25  # of segments, at most
PACKETS = {0: 8, 1: 4, 2: 14, 3: 7}  # doubles to a packet, by subtype of type 5
LARGEST_TEXT = 16 * MB  # of a frame, clock or leap-seconds kernel
_DATA = re.compile(r"\\begindata(.*?)(?:\\begintext|\Z)", re.DOTALL)
_BROKEN = "The file is cut short or damaged. Get it whole."


class QuaternionLimits(NamedTuple):
    """Which quaternions of a C-kernel are refused."""

    max_length_error: float = 1e-3  # difference of the length from one


LIMITS = QuaternionLimits()


class Segment(NamedTuple):
    """A segment's descriptor; addresses count doubles from 1."""

    first_tick: float
    last_tick: float
    instrument: int
    reference: int
    kind: int
    has_rates: bool
    start: int
    end: int


def check_text_kernel(path: Path, kind: str) -> None:
    """Refuse a kernel that is not text, or that has SPICE load others.

    Raises:
        FormatError: saying which.
    """
    content = read_file(path, kind, LARGEST_TEXT)
    text = content.decode("latin-1")
    if "\0" in text or text.startswith(("DAF/", "NAIF/", "DAS/")):
        raise FormatError(f"{path}: is not a {kind}, which is text. Check which file goes with which option.")
    for data in _DATA.findall(text):
        if "KERNELS_TO_LOAD" in data:
            raise FormatError(f"{path}: is a meta-kernel, which loads other files. Give the kernels themselves.")
        odd = re.search(r"[^\t\r\n -~]", data)
        if odd:
            raise FormatError(f"{path}: has {shown(odd[0])} among its data, and SPICE reads printable ASCII. Check it.")


def check_ck(path: Path) -> list[Segment]:
    """Return the segments of a C-kernel, after a check that SPICE can read them.

    Raises:
        FormatError: for lists of segments that do not end, addresses outside the file, counts that do not fit them,
            and times that do not ascend.
    """
    size = path.stat().st_size // 8
    head, order = _head(path), byte_order(path)
    doubles = np.memmap(path, dtype=f"{order}f8", mode="r", shape=(size,)) if size else np.zeros(0)
    segments = list(_segments(path, head, order, doubles))
    if not segments:
        _refuse(path, "holds no segment")
    for segment in segments:
        _check_segment(path, segment, doubles)
    return segments


def _refuse(path: Path, what: str) -> NoReturn:
    raise FormatError(f"{path}: {what}. {_BROKEN}")


def _head(path: Path) -> bytes:
    with path.open("rb") as file:
        head = file.read(RECORD)
    if len(head) < RECORD:
        _refuse(path, "ends within its first record")
    return head


def byte_order(path: Path) -> str:
    """Return < or >, the order of bytes in a C-kernel, as NumPy names it.

    Raises:
        FormatError: for a file without a C-kernel's layout.
    """
    head = _head(path)
    order = {b"LTL-IEEE": "<", b"BIG-IEEE": ">"}.get(head[88:96])
    for guess in [order] if order else "<>":
        if np.frombuffer(head[8:16], dtype=f"{guess}i4").tolist() == [2, 6]:
            return guess
    _refuse(path, "is not laid out as a C-kernel, with two doubles and six integers to a segment")


def _segments(path: Path, head: bytes, order: str, doubles: Array) -> Iterator[Segment]:
    first, _, free = np.frombuffer(head[76:88], dtype=f"{order}i4").tolist()
    record, visited, per_record = first, set(), RECORD // 8
    while record:
        if record in visited or not 1 < record <= len(doubles) // per_record:
            _refuse(path, f"its list of segments leads to record {record}, of {len(doubles) // per_record}")
        visited.add(record)
        summary = doubles[(record - 1) * per_record : record * per_record]
        control = [float(value) for value in summary[:3]]
        if not all(value.is_integer() and 0 <= value < 2**31 for value in control) or control[2] > SUMMARIES_PER_RECORD:
            _refuse(path, f"its list of segments has the pointers {shown(control)}")
        for k in range(int(control[2])):
            part = np.asarray(summary[3 + 5 * k : 8 + 5 * k])
            integers = np.frombuffer(part[2:].tobytes(), dtype=f"{order}i4").tolist()
            one = Segment(float(part[0]), float(part[1]), integers[0], integers[1], integers[2], integers[3] == 1,
                          integers[4], integers[5])
            if not per_record < one.start <= one.end < min(free, len(doubles) + 1):
                _refuse(path, f"a segment is at {one.start} to {one.end}, of {len(doubles)} numbers")
            yield one
        record = int(control[0])


def _check_segment(path: Path, segment: Segment, doubles: Array) -> None:
    values = doubles[segment.start - 1 : segment.end]
    if not (np.isfinite([segment.first_tick, segment.last_tick]).all() and segment.first_tick <= segment.last_tick):
        _refuse(path, f"a segment is from {segment.first_tick:g} to {segment.last_tick:g} ticks")
    if not 1 <= segment.kind <= 6:
        _refuse(path, f"a segment is of type {segment.kind}, and there are six")
    if not np.isfinite(values).all():
        _refuse(path, f"number {segment.start + int(np.argmin(np.isfinite(values)))} of it is not finite")
    ticks, packets = record_ticks(path, segment, values)
    if ticks is None:
        return
    if not len(ticks) or (np.diff(ticks) <= 0).any() if segment.kind != 2 else (np.diff(ticks) < 0).any():
        _refuse(path, f"the times of a segment of type {segment.kind} do not ascend")
    if segment.kind != 5 or packets.shape[1] != 14:
        with np.errstate(over="ignore"):  # an infinite length is not one
            wrong = np.abs(np.linalg.norm(packets[:, :4], axis=-1) - 1.0) > LIMITS.max_length_error
        if wrong.any():
            k = int(np.argmax(wrong))
            _refuse(path, f"record {k} of a segment is not a unit quaternion; got {shown(packets[k, :4].tolist())}")


def record_ticks(
    path: Path, segment: Segment, values: Float64[Array, "size"]
) -> tuple[Float64[Array, "n"] | None, Float64[Array, "..."]]:
    """Return the clock's times (n,) at which a segment has records, and these (m, k); None where a type has none.

    Layouts: NAIF, *CK Required Reading*, data types 1, 2, 3 and 5.

    Raises:
        FormatError: for a count that does not fit the segment's length.
    """
    size, width = len(values), 7 if segment.has_rates else 4
    if segment.kind == 2:  # start and stop of each, and a directory, but no count
        count = (DIRECTORY * size + DIRECTORY) // (10 * DIRECTORY + 1)
        if not count or 10 * count + _directory(count) != size:
            _refuse(path, f"a segment of type 2 has {size} numbers, which no count of records fills")
        ends = np.stack([values[8 * count : 9 * count], values[9 * count : 10 * count]], axis=-1)
        return ends.reshape(-1), values[: 8 * count].reshape(count, 8)
    if segment.kind not in (1, 3, 5):
        return None, values
    tail = {1: 1, 3: 2, 5: 5}[segment.kind]
    counts = [float(value) for value in values[-tail:]]
    if size <= tail or not all(value.is_integer() and 0 <= value <= size for value in counts[1 if tail == 5 else 0 :]):
        _refuse(path, f"a segment of type {segment.kind} has the counts {shown(counts)}, and {size} numbers")
    count = int(counts[-1])
    needed = count + _directory(count) + tail
    if segment.kind > 1:
        needed += int(counts[-2]) + _directory(int(counts[-2]))
    if segment.kind == 5:
        width = PACKETS.get(int(counts[1]), size)
    if not count or width * count + needed != size:
        _refuse(path, f"a segment of type {segment.kind} claims {count} records, and has {size} numbers")
    return values[width * count : (width + 1) * count], values[: width * count].reshape(count, width)


def _directory(count: int) -> int:
    return max(count - 1, 0) // DIRECTORY
