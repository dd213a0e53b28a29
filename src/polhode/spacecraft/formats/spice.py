"""Attitude histories as SPICE's C-kernels.

SPICE's matrix C takes components along the reference frame to components along the body's axes, so that its
quaternion is the conjugate of ours; its angular velocity is along the reference frame.

Source: NAIF, *CK Required Reading*, *SCLK Required Reading*, *Rotations Required Reading* (toolkit N0067).
"""

from __future__ import annotations

import errno
import math
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from polhode import rotation
from polhode.errors import InvalidInput
from polhode.formats.attitude_checks import single_attitude
from polhode.formats.labels import AttitudeLabels, find_labels
from polhode.formats.paths import write_whole
from polhode.formats.time_scales import leap_seconds_kernel
from polhode.motion._trajectory import Trajectory
from polhode.spacecraft.formats.spice_kernels import (
    DIRECTORY,
    KINDS,
    OF_BROKEN_FILES,
    Clock,
    clock_kernel,
    frame_kernel,
    instrument,
    reference,
    reword,
    spice_alone,
    spiceypy,
)
from polhode.types import Array, Float64

UNREADABLE = "SPICE cannot read again what it wrote; the disk may be full"


def write_ck(
    trajectory: Trajectory,
    path: str | Path,
    *,
    labels: AttitudeLabels | None = None,
    angular_velocity: bool = True,
) -> list[Path]:
    """Write an attitude history as a C-kernel of type 3, with the kernels that SPICE needs next to it.

    Next to ``name.bc`` are written the frame kernel ``name.tf``, the clock kernel ``name.tsc`` and, unless the epoch is
    in TDB, the leap-seconds kernel ``name.tls``, which may give way to NAIF's. Records hold the samples' quaternions to
    the last digit, at their times without rounding, as the clock's ticks are a power of two of a second. Asked by
    ephemeris time instead of the clock's, SPICE rounds to the resolution of a double: 1e-7 s nowadays.

    Between records SPICE turns at constant speed the shorter way; where a step is half a turn or more, by the angular
    velocity, it interpolates nothing.

    Args:
        trajectory: with attitude; one body. The kernel is of the given axes.
        path: of the C-kernel.
        labels: names, frames, epoch and SPICE's number; those that the trajectory was read with, or the usual.
        angular_velocity: write it too, where the trajectory has it.

    Returns:
        The files written.

    Raises:
        InvalidInput: without spiceypy, for a motion without attitude, times that do not rise, labels that SPICE has no
            words for, a folder that cannot be written to, or where kernels that polhode did not write are in the way;
            leap seconds of others stay instead.
    """
    spice, path = spiceypy(), Path(path)
    given = trajectory.along("given")
    attitude, times = single_attitude(given, "A C-kernel"), np.asarray(trajectory.times)
    if labels is None:
        labels = find_labels(trajectory) or AttitudeLabels()
    if not (np.diff(times) > 0).all():
        raise InvalidInput("a C-kernel needs times that rise from sample to sample; sort them, each once.")
    clock = Clock.of(float(times[0]), float(times[-1]))
    velocity = None
    if angular_velocity and given.angular_velocity is not None:
        velocity = rotation.rotate(attitude, np.asarray(given.angular_velocity))
    texts = {KINDS["frame"]: frame_kernel(labels), KINDS["clock"]: clock_kernel(labels, clock)}
    if labels.time_system != "TDB":
        texts[KINDS["leap seconds"]] = leap_seconds_kernel()
    files = [path, *(path.with_suffix(f".{ending}") for ending in texts)]
    if path in files[1:]:
        raise InvalidInput(f"{path}: a C-kernel may not end as the kernels next to it; call it {path.stem}.bc.")
    ticks = clock.ticks(times)
    records = _Records(ticks, rotation.conjugate(attitude), velocity, ticks[_begins(times, velocity)])
    kept = [file for file in files[1:] if _is_anothers(file)]
    with write_whole(path) as draft, spice_alone():
        for ending, text in texts.items():
            if path.with_suffix(f".{ending}") not in kept:
                draft.with_suffix(f".{ending}").write_text(text, "ascii")
        with reword(path, "Choose a shorter path, or check the labels."):
            _write_segment(spice, draft, labels, records)
        _check_holds(spice, draft, records)
    return files


def _is_anothers(file: Path) -> bool:
    """Return whether an existing kernel stays: another's leap seconds serve as well as ours.

    Raises:
        InvalidInput: for anything else that is not polhode's.
    """
    head = 1000  # bytes in which a kernel of ours says so
    if not file.exists():
        return False
    text = b""
    if file.is_file():
        with file.open("rb") as kernel:
            text = kernel.read(head)
    if b", by polhode" in text:
        return False
    if text.startswith(b"KPL/LSK"):
        return True
    raise InvalidInput(f"{file}: is in the way, and polhode did not write it. Name the C-kernel otherwise.")


class _Records(NamedTuple):
    """The contents of a segment of type 3, N records, as SPICE has them.

    Attributes:
        ticks: (N,).
        quaternions: (N, 4), of SPICE's C.
        velocity: (N, 3) along the reference frame, or None.
        starts: (M,) ticks at which intervals of interpolation begin.
    """

    ticks: Float64[Array, "records"]
    quaternions: Float64[Array, "records 4"]
    velocity: Float64[Array, "records 3"] | None
    starts: Float64[Array, "starts"]


def _begins(times: Array, velocity: Array | None) -> Array:
    """Return at which samples (T,) an interval of SPICE's interpolation begins."""
    begins = np.zeros(len(times), dtype=bool)
    if velocity is not None:
        speed = np.linalg.norm(velocity, axis=-1)
        begins[1:] = np.maximum(speed[1:], speed[:-1]) * np.diff(times) >= math.pi
    begins[0] = True
    return begins


def _write_segment(spice: Any, path: Path, labels: AttitudeLabels, records: _Records) -> None:
    """Write one segment of type 3.

    Raises:
        OSError: where SPICE itself notices that it wrote less than it should.
    """
    ticks, quaternions, velocity, starts = records
    rates = np.zeros((len(ticks), 3)) if velocity is None else velocity
    handle = spice.ckopn(str(path), "polhode", 0)
    try:
        spice.ckw03(handle, ticks[0], ticks[-1], instrument(labels), reference(labels), velocity is not None, "POLHODE",
                    len(ticks), ticks, quaternions, rates, len(starts), starts)
        spice.ckcls(handle)
    except BaseException as error:
        spice.dafcls(handle)  # a kernel without segments cannot be closed as one
        if getattr(error, "short", "").startswith(OF_BROKEN_FILES):
            raise OSError(errno.ENOSPC, UNREADABLE) from None
        raise


def _check_holds(spice: Any, path: Path, records: _Records) -> None:
    """Read a C-kernel again, and refuse it unless it holds every bit: SPICE does not say so when the disk is full.

    Raises:
        OSError: if it does not.
    """
    ticks, quaternions, velocity, starts = records
    packets = quaternions if velocity is None else np.hstack([quaternions, velocity])
    wanted = np.concatenate([packets.ravel(), ticks])
    try:
        handle = spice.dafopr(str(path))
        try:
            spice.dafbfs(handle)
            spice.daffna()
            _, integers = spice.dafus(spice.dafgs(), 2, 6)
            first, last = int(integers[4]), int(integers[5])
            middle = first + len(wanted)
            got = np.asarray(spice.dafgda(handle, first, middle - 1))
            after = middle + (len(ticks) - 1) // DIRECTORY
            got_starts = np.atleast_1d(spice.dafgda(handle, after, after + len(starts) - 1))
            counts = np.asarray(spice.dafgda(handle, last - 1, last))
        finally:
            spice.dafcls(handle)
    except spice.exceptions.SpiceyError:
        raise OSError(errno.ENOSPC, UNREADABLE) from None
    same = got.tobytes() == wanted.tobytes() and got_starts.tobytes() == starts.tobytes()
    if not same or counts.tolist() != [len(starts), len(ticks)]:
        raise OSError(errno.ENOSPC, "what SPICE wrote is not what it reads; the disk may be full")
