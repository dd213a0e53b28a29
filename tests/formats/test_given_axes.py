"""Trajectories along the given axes, against the same motion made along them from the start."""

from dataclasses import replace

import jaxtyping
import numpy as np
import pytest

import polhode as ph
from polhode.errors import InvalidInput
from polhode.formats.attitude_checks import single_attitude

EXACT = 1e-14
"""A few roundings of products of unit quaternions and matrices, relative."""
BODY = ph.shapes.box(2.0, (1.0, 2.0, 3.0)).placed((0.8, 0.2, -0.4, 0.4), (5.0, -7.0, 11.0))
TIMES = np.linspace(0.0, 10.0, 50)
VELOCITY, ATTITUDE = np.array([0.3, -1.0, 0.7]), np.array([0.5, -0.5, 0.5, 0.5])


def principal():
    axes = BODY.principal_axes
    attitude = ph.rotation.multiply(ATTITUDE, ph.rotation.from_matrix(axes))
    return ph.FreeMotion(
        BODY.principal_moments, momentum=BODY.principal_moments * (VELOCITY @ axes), attitude=attitude
    ).sample(TIMES)


def test_it_is_the_motion_along_the_given_axes():
    found = replace(principal(), frame=BODY.frame).along("given")
    wanted = ph.FreeMotion.from_body(BODY, angular_velocity=VELOCITY, attitude=ATTITUDE).sample(TIMES)
    assert ph.rotation.angle_between(found.attitude, wanted.attitude).max() <= 20 * EXACT
    for name in ("momentum", "angular_velocity"):
        assert np.abs(getattr(found, name) - getattr(wanted, name)).max() <= 20 * EXACT
    # the same vectors in space as before
    before = principal()
    space = [ph.rotation.rotate(x.attitude, x.momentum) for x in (before, found)]
    assert np.abs(space[0] - space[1]).max() <= 20 * EXACT * np.abs(space[0]).max()


def test_without_a_frame_it_stays():
    trajectory = principal()
    assert trajectory.along("given") is trajectory


@pytest.mark.parametrize("turned", ["given", "principal", ph.rotation.as_matrix([0.5, 0.5, -0.5, 0.5])])
def test_turns_go_round(turned):
    """Whatever the axes, the vectors in space are the same, and the motion gives what its samples have."""
    made = ph.FreeMotion.from_body(BODY, angular_velocity=VELOCITY, attitude=ATTITUDE)
    for begin in (replace(principal(), frame=BODY.frame), made.sample(TIMES), made.along(turned).sample(TIMES)):
        found = begin.along(turned)
        for name in ("momentum", "angular_velocity"):
            space = [ph.rotation.rotate(x.attitude, getattr(x, name)) for x in (begin, found)]
            assert np.abs(space[0] - space[1]).max() <= 20 * EXACT * np.abs(space[0]).max()
        again = found.resample(TIMES)
        assert np.abs(again.states - found.states).max() <= 20 * EXACT * np.abs(found.states).max()
        back = found.along("given").along("principal").along("given")
        assert np.abs(back.states - begin.along("given").states).max() <= 20 * EXACT * np.abs(back.states).max()
    one, other = made.along(turned).along("given").sample(TIMES), made.sample(TIMES).along(turned).along("given")
    assert np.abs(one.states - other.states).max() <= 20 * EXACT * np.abs(other.states).max()
    round_trip = made.along("principal").along("given")
    assert np.abs(round_trip.momentum(1.0) - made.momentum(1.0)).max() <= EXACT
    axis = made.along(turned).axes
    along = np.eye(3) if axis is None else axis
    assert made.along(turned).momentum(1.0) @ along == pytest.approx(made.along("principal").momentum(1.0), rel=EXACT)


def test_a_system_made_from_a_body_knows_its_given_axes():
    """Samples of an integrated top are along its principal axes; files of attitudes are of the given ones."""
    top = ph.systems.HeavyTop.from_body(BODY, (5.0, -7.0, 10.0))
    moved = ph.simulate(top, top.pack(ATTITUDE, angular_velocity=VELOCITY), [0.0, 1.0])
    given = moved.along("given")
    assert given.angular_velocity[0] == pytest.approx(VELOCITY, abs=EXACT) and moved.axes is None
    assert ph.rotation.angle_between(given.attitude[0], ATTITUDE) < EXACT
    exported = ph.formats.as_rotation(moved)[0].as_quat(scalar_first=True)
    assert exported == pytest.approx(given.attitude[0], abs=EXACT)
    assert given.along("principal").momentum == pytest.approx(moved.momentum, abs=EXACT * 100)


@pytest.mark.parametrize("axes", ["inertial", np.eye(4), -np.eye(3), np.full((3, 3), np.nan), 2.0 * np.eye(3)])
def test_axes_that_are_none(axes, monkeypatch):
    monkeypatch.setattr(jaxtyping.config, "jaxtyping_disable", True)
    with pytest.raises(InvalidInput, match="`axes` must"):
        principal().along(axes)


def test_samples_and_states_have_the_same_bits():
    """A matrix product rounds one vector and many in different orders: 35 of these 50 states differed so."""
    free = ph.FreeMotion.from_body(BODY, angular_velocity=VELOCITY, attitude=ATTITUDE)
    top = ph.LagrangeMotion.from_body(ph.shapes.cone(1.0, 0.3, 1.0), pivot=(0.0, 0.0, -0.75), angular_velocity=VELOCITY)
    for motion in (free, top):
        samples = motion.sample(TIMES)
        for k, t in enumerate(TIMES.tolist()):
            attitude, momentum = motion.state(t)
            assert (attitude == samples.attitude[k]).all() and (momentum == samples.momentum[k]).all()
            assert (motion.angular_velocity(t) == samples.angular_velocity[k]).all()
        assert (motion.state(TIMES)[1] == samples.momentum).all()


def test_what_a_trajectory_does_not_have_it_does_not_get():
    bare = replace(principal(), frame=BODY.frame, attitude=None, momentum=None, angular_velocity=None)
    found = bare.along("given")
    assert found.attitude is None and found.momentum is None and found.angular_velocity is None


def test_one_body_with_attitude_and_samples():
    trajectory = principal()
    assert np.array_equal(single_attitude(trajectory, "A file"), trajectory.attitude)
    with pytest.raises(InvalidInput, match="A file holds attitudes, and this motion has none"):
        single_attitude(replace(trajectory, attitude=None), "A file")
    with pytest.raises(InvalidInput, match=r"A file holds one body; got a batch of shape \(2,\)"):
        two = replace(trajectory, attitude=np.zeros((2, 50, 4)), momentum=None, angular_velocity=None)
        single_attitude(two, "A file")
    with pytest.raises(InvalidInput, match="A file needs at least one sample"):
        single_attitude(trajectory.select(slice(0)), "A file")
