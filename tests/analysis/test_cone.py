"""Angles of the principal axes and of the angular velocity to L, against the motion itself at many times."""

import math

import numpy as np
import pytest

from polhode import FreeMotion
from polhode.analysis import axis_angles, cone_angles, velocity_angles

SAMPLED = 2e-5  # rad; angles are level at their extremes, so that a thousandth of a period is this far from them
MOTIONS = {
    "short-axis": ((1.0, 2.0, 3.0), (0.3, 1.8, 1.5)),
    "short-axis, at the far end": ((1.0, 2.0, 3.0), (0.3, 1.8, -1.5)),
    "long-axis": ((1.0, 2.0, 3.0), (0.9, 1.6, 0.3)),
    "moments in another order": ((3.0, 1.0, 2.0), (1.5, 0.3, 1.8)),
    "oblate": ((2.0, 2.0, 3.0), (0.5, 0.1, 1.0)),
    "prolate": ((1.0, 2.0, 2.0), (-1.0, 0.5, 0.2)),
    "near the separatrix": ((1.0, 2.0, 3.0), (1e-4, 2.0, 2e-4)),
    "near permanent": ((1.0, 2.0, 3.0), (1e-4, 0.0, 2.0)),
    "permanent": ((1.0, 2.0, 3.0), (0.0, 0.0, -2.0)),
    "spherical": ((2.0, 2.0, 2.0), (0.3, -0.4, 1.0)),
}


def between(first, second):
    """Angles of directions (…, 3), without arc cosines."""
    return np.arctan2(np.linalg.norm(np.cross(first, second), axis=-1), np.sum(first * second, axis=-1))


@pytest.mark.parametrize("name", MOTIONS)
def test_they_are_those_of_the_motion(name):
    moments, momentum = MOTIONS[name]
    motion = FreeMotion(moments, momentum=momentum)
    period = motion.period if motion.period and np.isfinite(motion.period) else 10.0
    L = motion.momentum(np.linspace(0.0, period, 4001))
    sampled = np.stack([between(np.eye(3)[k], L) for k in range(3)])
    found = axis_angles(motion)
    assert np.abs(found - np.stack([sampled.min(axis=1), sampled.max(axis=1)], axis=1)).max() < SAMPLED
    velocity = between(L / np.asarray(moments), L)
    assert np.abs(np.array(velocity_angles(motion)) - (velocity.min(), velocity.max())).max() < SAMPLED
    cone = cone_angles(motion)
    if motion.encircled_axis is not None and name != "spherical":
        axis = sampled[motion.encircled_axis]
        line = np.minimum(axis, math.pi - axis)
        assert np.abs(np.array(cone) - (line.min(), line.max())).max() < SAMPLED


def test_a_tiny_cone_keeps_its_digits():
    """Of the Earth's size: a hair off the axis of largest moment, oblate, where the angle is that of L itself."""
    small = 3e-12
    found = cone_angles(FreeMotion((1.0, 1.0, 1.003), momentum=(small, 0.0, 1.0)))
    assert np.abs(np.array(found) / math.atan(small) - 1.0).max() < 1e-12
    assert (
        abs(velocity_angles(FreeMotion((1.0, 1.0, 1.003), momentum=(small, 0.0, 1.0)))[0] / (0.003 * small) - 1.0)
        < 1e-9
    )


def test_on_the_separatrix_they_are_those_of_all_time():
    """I = (1, 2, 3): the great circle's plane passes half-way between the axes where 2E = |L|²/I_2."""
    motion = FreeMotion((3.0, 4.0, 6.0), momentum=(1.0, 0.5, -1.0))
    assert motion.regime == "separatrix"
    L = motion.momentum(np.linspace(-200.0, 200.0, 40001))
    found = axis_angles(motion)
    for k in range(3):
        sampled = between(np.eye(3)[k], L)
        assert abs(found[k, 0] - sampled.min()) < 1e-4 and abs(found[k, 1] - sampled.max()) < 1e-4


def test_at_rest_there_are_none():
    still = FreeMotion((1.0, 2.0, 3.0), momentum=(0.0, 0.0, 0.0))
    assert axis_angles(still) is None and cone_angles(still) is None and velocity_angles(still) is None
