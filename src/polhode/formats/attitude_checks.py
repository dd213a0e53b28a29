"""Checks of attitudes before they are written to a file, and after they are read."""

from __future__ import annotations

from pathlib import Path
from typing import NamedTuple

import numpy as np

from polhode.errors import FormatError, InvalidInput
from polhode.motion._trajectory import Trajectory
from polhode.types import Array, Float64, Shaped

DAMAGED = "The file is damaged; write it again."


class RecordingLimits(NamedTuple):
    """A number that decides whether the attitudes of a file are refused."""

    max_norm_error: float = 1e-6  # of quaternions from one: a file gives at least seven digits of each component


LIMITS = RecordingLimits()


def single_attitude(trajectory: Trajectory, form: str) -> Float64[Array, "time 4"]:
    """Return the attitude (T, 4) of one body, checked for a form of file.

    Raises:
        InvalidInput: for motions without attitude, batches, and trajectories without samples.
    """
    if trajectory.attitude is None:
        raise InvalidInput(f"{form} holds attitudes, and this motion has none. Write a dataset instead.")
    attitude = np.asarray(trajectory.attitude)
    if attitude.ndim != 2:
        raise InvalidInput(f"{form} holds one body; got a batch of shape {attitude.shape[:-2]}. Write one at a time.")
    if not len(attitude):
        raise InvalidInput(f"{form} needs at least one sample; the trajectory is empty. Give it times.")
    return attitude


def check_recorded(
    path: Path,
    times: Shaped[Array, "time"],
    attitude: Shaped[Array, "*batch time 4"] | None,
    velocity: Shaped[Array, "*batch time 3"] | None = None,
) -> None:
    """Refuse times, attitudes (…, 4) and velocities of a file that are not finite, as in a store with missing chunks.

    Raises:
        FormatError: naming the first sample that is wrong.
    """
    wrong = ~np.isfinite(np.asarray(times))
    if wrong.any():
        raise FormatError(f"{path}: the time of sample {int(np.argmax(wrong))} is not a finite number. {DAMAGED}")
    if velocity is not None and not np.isfinite(velocity).all():
        place = np.argwhere(~np.isfinite(np.asarray(velocity)))[0]
        raise FormatError(f"{path}: the angular velocity of sample {int(place[-2])} is not a finite number. {DAMAGED}")
    if attitude is None:
        return
    with np.errstate(over="ignore"):  # an infinite length is not one
        norms = np.linalg.norm(np.asarray(attitude), axis=-1)
    wrong = ~(np.abs(norms - 1.0) <= LIMITS.max_norm_error)
    if wrong.any():
        place = tuple(np.argwhere(wrong)[0])
        got = np.asarray(attitude)[place].tolist()
        why = f"the attitude of sample {place[-1]} is not a unit quaternion; got {got}"
        raise FormatError(f"{path}: {why}. {DAMAGED}")
