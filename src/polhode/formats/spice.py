"""Attitude histories as SPICE's C-kernels.

SPICE's matrix C takes components along the reference frame to components along the body's axes, so that its
quaternion is the conjugate of ours; its angular velocity is along the reference frame.

Source: NAIF, *CK Required Reading*, *SCLK Required Reading*, *Rotations Required Reading* (toolkit N0067).
"""

from __future__ import annotations

import contextlib
import math
from pathlib import Path
from typing import Any

import numpy as np

from polhode import rotation
from polhode.bodies.frame import BodyFrame
from polhode.errors import InvalidInput
from polhode.formats.given_axes import along_given_axes, single_attitude
from polhode.formats.labels import AttitudeLabels
from polhode.formats.paths import written_whole
from polhode.formats.spice_kernels import (
    KINDS,
    Clock,
    clock_kernel,
    frame_kernel,
    instrument,
    reference,
    spiceypy,
    worded,
)
from polhode.formats.time_scales import leap_seconds_kernel
from polhode.trajectory import Trajectory

Array = Any


def write_ck(
    trajectory: Trajectory,
    path: str | Path,
    *,
    labels: AttitudeLabels | None = None,
    frame: BodyFrame | None = None,
    angular_velocity: bool = True,
) -> list[Path]:
    """Write an attitude history as a C-kernel of type 3, with the kernels that SPICE needs beside it.

    Beside ``name.bc`` stand the frame kernel ``name.tf``, the clock kernel ``name.tsc`` and, unless the epoch is in
    TDB, the leap-seconds kernel ``name.tls``, which may give way to NAIF's. Records hold the samples' quaternions to
    the last digit, at their times without rounding, as the clock's ticks are a power of two of a second. Asked by
    ephemeris time instead of the clock's, SPICE rounds to what a double tells apart: 1e-7 s nowadays.

    Between records SPICE turns at constant speed the shorter way; where a step is half a turn or more, as the angular
    velocity tells, it interpolates nothing.

    Args:
        trajectory: with attitude; one body.
        path: of the C-kernel.
        labels: names, frames, epoch and SPICE's number; those that the trajectory was read with, or the usual.
        frame: principal axes that the trajectory is along, in the given ones; None where it is along these.
        angular_velocity: write it too, where the trajectory has it.

    Returns:
        The files written.

    Raises:
        InvalidInput: without spiceypy, for a motion without attitude, times that do not rise, labels that SPICE has no
            words for, or a folder that cannot be written to.
    """
    spice, path = spiceypy(), Path(path)
    given = along_given_axes(trajectory, frame)
    attitude, times = single_attitude(given, "A C-kernel"), np.asarray(trajectory.times)
    if labels is None:
        labels = trajectory.system if isinstance(trajectory.system, AttitudeLabels) else AttitudeLabels()
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
        raise InvalidInput(f"{path}: a C-kernel may not end as the kernels beside it; call it {path.stem}.bc.")
    with contextlib.ExitStack() as stack:
        drafts = [stack.enter_context(written_whole(file)) for file in files]
        for draft, text in zip(drafts[1:], texts.values(), strict=True):
            draft.write_text(text, "ascii")
        with worded(path, "Choose a shorter path, or check the labels."):
            ticks = clock.ticks(times)
            starts = ticks[_begins(times, velocity)]
            _write_segment(spice, drafts[0], labels, ticks, starts, attitude, velocity)
    return files


def _begins(times: Array, velocity: Array | None) -> Array:
    """Return at which samples (T,) an interval of SPICE's interpolation begins."""
    found = np.zeros(len(times), dtype=bool)
    if velocity is not None:
        speed = np.linalg.norm(velocity, axis=-1)
        found[1:] = np.maximum(speed[1:], speed[:-1]) * np.diff(times) >= math.pi
    found[0] = True
    return found


def _write_segment(
    spice: Any, path: Path, labels: AttitudeLabels, ticks: Array, starts: Array, attitude: Array, velocity: Array | None
) -> None:
    """Write one segment of type 3."""
    rates = np.zeros((len(ticks), 3)) if velocity is None else velocity
    handle = spice.ckopn(str(path), "polhode", 0)
    try:
        spice.ckw03(handle, ticks[0], ticks[-1], instrument(labels), reference(labels), velocity is not None, "POLHODE",
                    len(ticks), ticks, rotation.conjugate(attitude), rates, len(starts), starts)  # fmt: skip
        spice.ckcls(handle)
    except BaseException:
        spice.dafcls(handle)  # a kernel without segments cannot be closed as one
        raise
