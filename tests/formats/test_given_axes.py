"""Trajectories along the given axes, against the same motion made along them from the start."""

from dataclasses import replace

import numpy as np
import pytest

import polhode as ph
from polhode.errors import InvalidInput
from polhode.formats.given_axes import along_given_axes, single_attitude

EXACT = 1e-14
"""A few roundings of products of unit quaternions and matrices, relative."""
BODY = ph.shapes.box(2.0, (1.0, 2.0, 3.0)).placed((0.8, 0.2, -0.4, 0.4), (5.0, -7.0, 11.0))
TIMES = np.linspace(0.0, 10.0, 50)
VELOCITY, ATTITUDE = np.array([0.3, -1.0, 0.7]), np.array([0.5, -0.5, 0.5, 0.5])


def along_principal_axes():
    axes = BODY.principal_axes
    attitude = ph.rotation.multiply(ATTITUDE, ph.rotation.from_matrix(axes))
    return ph.FreeMotion(BODY.principal_moments, BODY.principal_moments * (VELOCITY @ axes), attitude).sample(TIMES)


def test_it_is_the_motion_along_the_given_axes():
    found = along_given_axes(replace(along_principal_axes(), frame=BODY.frame))
    wanted = ph.FreeMotion.from_body(BODY, angular_velocity=VELOCITY, attitude=ATTITUDE).sample(TIMES)
    assert ph.rotation.angle_between(found.attitude, wanted.attitude).max() <= 20 * EXACT
    for name in ("momentum", "angular_velocity"):
        assert np.abs(getattr(found, name) - getattr(wanted, name)).max() <= 20 * EXACT
    # the same vectors in space as before
    before = along_principal_axes()
    space = [ph.rotation.rotate(x.attitude, x.momentum) for x in (before, found)]
    assert np.abs(space[0] - space[1]).max() <= 20 * EXACT * np.abs(space[0]).max()


def test_without_a_frame_it_stays():
    trajectory = along_principal_axes()
    assert along_given_axes(trajectory) is trajectory


def test_what_a_trajectory_does_not_have_it_does_not_get():
    bare = replace(along_principal_axes(), frame=BODY.frame, attitude=None, momentum=None, angular_velocity=None)
    found = along_given_axes(bare)
    assert found.attitude is None and found.momentum is None and found.angular_velocity is None


def test_one_body_with_attitude_and_samples():
    trajectory = along_principal_axes()
    assert np.array_equal(single_attitude(trajectory, "A file"), trajectory.attitude)
    with pytest.raises(InvalidInput, match="A file holds attitudes, and this motion has none"):
        single_attitude(replace(trajectory, attitude=None), "A file")
    with pytest.raises(InvalidInput, match=r"A file holds one body; got a batch of shape \(2,\)"):
        two = replace(trajectory, attitude=np.zeros((2, 50, 4)), momentum=None, angular_velocity=None)
        single_attitude(two, "A file")
    with pytest.raises(InvalidInput, match="A file needs at least one sample"):
        single_attitude(trajectory.taken(slice(0)), "A file")
