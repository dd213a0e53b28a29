"""SciPy's rotations turn vectors as the trajectory's attitude does."""

from dataclasses import replace

import numpy as np
import pytest

import polhode as ph
from polhode import rotation
from polhode.errors import InvalidInput
from polhode.formats import as_rotation, as_rotation_spline
from polhode.motion.frame import BodyFrame

EXACT = 1e-15
MOTION = ph.FreeMotion((1.0, 2.0, 3.0), momentum=(0.3, 1.8, 1.5), attitude=(0.5, -0.5, 0.1, 0.7))
TRAJECTORY = MOTION.sample(np.linspace(0.0, 5.0, 501))


def test_rotations_take_body_to_space():
    turns = as_rotation(TRAJECTORY)
    space = turns.apply(TRAJECTORY.momentum)
    assert np.abs(space - space[0]).max() <= 10 * EXACT
    assert turns.as_matrix() == pytest.approx(MOTION.rotation_matrix(TRAJECTORY.times), abs=10 * EXACT)


def test_rotations_of_the_given_axes():
    frame = BodyFrame((1.0, 2.0, 3.0), np.eye(3)[[2, 0, 1]], np.zeros(3), None)
    given = as_rotation(replace(TRAJECTORY, frame=frame)).apply(TRAJECTORY.momentum @ frame.axes.T)
    assert np.abs(given - as_rotation(TRAJECTORY).apply(TRAJECTORY.momentum)).max() <= 10 * EXACT


def test_the_spline_is_close_between_samples():
    spline = as_rotation_spline(TRAJECTORY)
    between = TRAJECTORY.times[20:-20] + 0.005  # its ends are free, and worse
    found = rotation.from_scipy(spline(between))
    assert rotation.angle_between(found, MOTION.attitude(between)).max() <= 1e-8
    assert spline(between, 1) == pytest.approx(MOTION.angular_velocity(between), abs=1e-5)


def test_motions_without_one_attitude_each_time():
    with pytest.raises(InvalidInput, match="holds attitudes"):
        as_rotation(replace(TRAJECTORY, attitude=None))
    with pytest.raises(InvalidInput, match="batch"):
        as_rotation(ph.FreeMotion((1.0, 2.0, 3.0), momentum=np.ones((4, 1, 3))).sample(np.linspace(0.0, 1.0, 3)))
    with pytest.raises(InvalidInput, match="sample 2 does not come after"):
        as_rotation_spline(replace(TRAJECTORY.select(slice(3)), times=np.array([0.0, 1.0, 1.0])))
    with pytest.raises(InvalidInput, match="got one"):
        as_rotation_spline(TRAJECTORY.select(slice(1)))
    with pytest.raises(InvalidInput, match="at least one sample"):
        as_rotation(TRAJECTORY.select(slice(0)))
