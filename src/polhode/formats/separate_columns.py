"""Reads the attitudes of the simulator 42, whose times, quaternions and rates are in files of their own."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from polhode.errors import FormatError, InvalidInput
from polhode.formats.aem_attitudes import FAR_FROM_UNIT
from polhode.formats.labels import Recording
from polhode.formats.numerals import read_number
from polhode.formats.opening import MB, read_text
from polhode.motion._layout import ATTITUDE, StateLayout
from polhode.motion._outcome import Ending, Outcome
from polhode.motion._trajectory import Trajectory
from polhode.types import Array, Float64

LARGEST_FILE = 1000 * MB
TIMES, RATES = "time.42", "wbn.42"


def read_42(path: Path) -> Trajectory:
    """Return attitudes body → space, times [s] of the file next to it, and angular velocities [rad/s] likewise.

    Raises:
        InvalidInput: where the file of times is not next to it.
        FormatError: naming the line, for values that are no number or no unit quaternion, and for files of other
            lengths.
    """
    beside = path.with_name(TIMES)
    if not beside.is_file():
        raise InvalidInput(f"{path}: 42 writes times into {TIMES}, which is not next to it. Put it there.")
    quaternions, times = _read_lines(path, 4), _read_lines(beside, 1)[:, 0]
    lengths = np.linalg.norm(quaternions, axis=1)
    if (far := ~(np.abs(lengths - 1.0) <= FAR_FROM_UNIT)).any():
        row = int(np.argmax(far))
        raise FormatError(f"{path}, line {row + 1}: a quaternion must have length 1 to {FAR_FROM_UNIT:g}; got "
                          f"{lengths[row]:.6g}. Check the file.")
    attitude = (quaternions / lengths[:, None])[:, [3, 0, 1, 2]]
    number = path.stem.removeprefix("qbn").removeprefix("q")
    other = path.with_name(RATES.replace(".", f"{number}."))
    velocity = _read_lines(other, 3) if other.is_file() else None
    for name, values in ((beside, times), (other, velocity)):
        if values is not None and len(values) != len(attitude):
            raise FormatError(f"{path}: has {len(attitude)} lines, and {name.name} has {len(values)}. Take files of "
                              "one run.")
    return Trajectory(
        times, attitude, StateLayout((ATTITUDE,)), attitude, angular_velocity=velocity,
        outcome=Outcome(Ending.RECORDED), source=Recording(path.name),
    )


def _read_lines(path: Path, width: int) -> Float64[Array, "rows columns"]:
    rows = []
    for number, line in enumerate(read_text(path, "table", LARGEST_FILE).splitlines(), 1):
        words = line.split()
        if not words:
            continue
        try:
            if len(words) != width:
                raise ValueError(f"must have {width} numbers; got {len(words)}")
            rows.append([read_number(word) for word in words])
        except ValueError as error:
            raise FormatError(f"{path}, line {number}: {error}. Check the file.") from None
    if not rows:
        raise FormatError(f"{path}: is empty. Check the file.")
    return np.array(rows)
