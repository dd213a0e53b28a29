"""Trajectories along the body's given axes, which files for other tools are about."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np

from polhode import rotation
from polhode.bodies.frame import BodyFrame
from polhode.errors import InvalidInput
from polhode.trajectory import Trajectory

Array = Any


def along_given_axes(trajectory: Trajectory, frame: BodyFrame | None) -> Trajectory:
    """Return a trajectory with attitude, momentum and angular velocity of the given axes instead of the principal ones.

    Args:
        trajectory: along the principal axes.
        frame: these axes in the given ones; None where the trajectory's axes are the given ones already.
    """
    if frame is None:
        return trajectory
    axes = np.asarray(frame.axes)

    def turned(vectors: Array | None) -> Array | None:
        return None if vectors is None else np.asarray(vectors) @ axes.T

    attitude = trajectory.attitude
    if attitude is not None:
        attitude = rotation.multiply(np.asarray(attitude), rotation.conjugate(rotation.from_matrix(axes)))
    return replace(trajectory, attitude=attitude, momentum=turned(trajectory.momentum),
                   angular_velocity=turned(trajectory.angular_velocity))  # fmt: skip


def single_attitude(trajectory: Trajectory, form: str) -> Array:
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
