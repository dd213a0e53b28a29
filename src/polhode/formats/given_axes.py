"""Trajectories along the body's given axes, which files for other tools are about."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np

from polhode import rotation
from polhode.errors import FormatError, InvalidInput
from polhode.motion.base import AbstractMotion
from polhode.motion.trajectory import Trajectory
from polhode.types import Array, Float64, Shaped

UNIT = 1e-6  # how far from one the norm of a quaternion in a file may be: seven digits of each component, at least
DAMAGED = "The file is damaged; write it again."


def along_given_axes(trajectory: Trajectory) -> Trajectory:
    """Return a trajectory with attitude, momentum and angular velocity of the given axes instead of the principal ones.

    One without a frame, or sampled from a motion made by ``from_body``, is along the given axes already.
    """
    if trajectory.frame is None or _from_body(trajectory) is not None:
        return trajectory
    return replace(_turned(trajectory, np.asarray(trajectory.frame.axes).T), frame=None)


def along_principal_axes(trajectory: Trajectory) -> Trajectory:
    """Return the trajectory of a motion made by ``from_body`` along the principal axes, others as they are.

    Its states and its motion are then along these too.
    """
    motion = _from_body(trajectory)
    if motion is None:
        return trajectory
    turned = _turned(trajectory, np.asarray(motion.axes))
    states = np.concatenate([np.asarray(turned.attitude), np.asarray(turned.momentum)], axis=-1)
    return replace(turned, source=motion.along_principal_axes(), states=states)


def _from_body(trajectory: Trajectory) -> AbstractMotion | None:
    motion = trajectory.motion
    return motion if motion is not None and motion.axes is not None else None


def _turned(trajectory: Trajectory, axes: Array) -> Trajectory:
    """Return the trajectory along axes that are the columns of ``axes`` in its own."""

    def along(vectors: Array | None) -> Array | None:
        return None if vectors is None else np.asarray(vectors) @ axes

    attitude = trajectory.attitude
    if attitude is not None:
        attitude = rotation.multiply(np.asarray(attitude), rotation.from_matrix(axes))
    return replace(trajectory, attitude=attitude, momentum=along(trajectory.momentum),
                   angular_velocity=along(trajectory.angular_velocity))  # fmt: skip


def single_attitude(trajectory: Trajectory, form: str) -> Float64[Array, "time 4"]:
    """Return the attitude (T, 4) of one body, as a form of file wants it.

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
    """Refuse times, attitudes (…, 4) and velocities of a file that are not finite, as a store without its chunks has.

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
    wrong = ~(np.abs(norms - 1.0) <= UNIT)
    if wrong.any():
        place = tuple(np.argwhere(wrong)[0])
        found = np.asarray(attitude)[place].tolist()
        why = f"the attitude of sample {place[-1]} is not a unit quaternion; got {found}"
        raise FormatError(f"{path}: {why}. {DAMAGED}")
