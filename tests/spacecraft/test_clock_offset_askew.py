"""The offset between two clocks where a sensor sits askew, against Euler's equations integrated by SciPy."""

from functools import cache

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.spatial.transform import Rotation

from polhode import FreeMotion, rotation
from polhode.errors import InvalidInput
from polhode.spacecraft.comparing.comparison import AttitudeHistory, align_clocks

BEGIN = np.array([0.5, 0.5, -0.5, 0.5])
TUMBLING = (1.0, 2.0, 3.0), (0.3, 0.9, 0.5)
SPINNING = (1.0, 2.0, 3.0), (0.0, 0.0, 0.04)  # less than half a turn in a minute
WOBBLING = (1.0, 2.0, 3.0), (0.002, 0.004, 0.04)
SPANNED = 60.0
NOISE = 2e-3  # rad, each axis


@cache
def follow(body):
    """Euler's equations and the quaternion's, by DOP853; its dense output."""
    moments, velocity = np.array(body[0]), np.array(body[1])

    def derive(_, state):
        w, (a, b, c, d) = state[:3], state[3:]
        turn = [-b * w[0] - c * w[1] - d * w[2], a * w[0] + c * w[2] - d * w[1],
                a * w[1] + d * w[0] - b * w[2], a * w[2] + b * w[1] - c * w[0]]  # fmt: skip
        return np.concatenate([np.cross(moments * w, w) / moments, 0.5 * np.array(turn)])

    begin = np.concatenate([velocity, BEGIN])
    return solve_ivp(derive, (0.0, SPANNED), begin, "DOP853", rtol=1e-12, atol=1e-13, dense_output=True).sol


def known(body):
    motion = FreeMotion(body[0], angular_velocity=body[1], attitude=tuple(BEGIN))
    times = np.linspace(0.0, SPANNED, 601)
    return AttitudeHistory("known", times, np.asarray(motion.attitude(times)),
                           exact=lambda t: (motion.attitude(t), motion.angular_velocity(t)))  # fmt: skip


def log(body, seed, askew=0.0, space=0.0, lasting=None):
    """A log with noise of axes rotated at random [rad, each axis], and when it began."""
    random = np.random.default_rng(seed)
    length = random.uniform(10.0, 25.0) if lasting is None else lasting
    start = random.uniform(0.0, SPANNED - length)
    times = np.arange(0.0, length, 0.1)
    mount, frame = (Rotation.from_rotvec(random.normal(0.0, size, 3)) for size in (askew, space))
    true = Rotation.from_quat(follow(body)(times + start)[3:].T[:, [1, 2, 3, 0]])
    scatter = Rotation.from_rotvec(random.normal(0.0, NOISE, (len(times), 3)))
    return AttitudeHistory("log", times, rotation.from_scipy(frame * true * mount * scatter)), start


def pulls(body, count, **how):
    """Errors of offsets over their stated standard errors."""
    exact, found = known(body), []
    for seed in range(count):
        seen, start = log(body, seed, **how)
        one = align_clocks(exact, seen)
        found.append((one.offset - start) / one.error)
    return np.array(found)


def calibrated(found):
    return 0.7 < np.sqrt(np.mean(found**2)) < 1.4 and np.abs(found).max() < 3.5


@pytest.mark.long_after(1)
@pytest.mark.parametrize("askew", [1e-2, 5e-2])
def test_a_sensor_that_sits_askew_does_not_move_it(askew):
    """With 10 mrad on each axis it was off by up to 13 of its errors, by 8 rms; with 50 mrad some were refused."""
    assert calibrated(pulls(TUMBLING, 8, askew=askew))


@pytest.mark.long
@pytest.mark.parametrize("body", [TUMBLING, ((1.0, 1.0, 2.0), (0.3, 0.2, 0.5)), WOBBLING])
@pytest.mark.parametrize("askew", [0.0, 1e-2])
def test_its_error_is_that_of_the_joint_fit(body, askew):
    lasting = 45.0 if body is WOBBLING else None
    assert calibrated(pulls(body, 30, askew=askew, lasting=lasting))


@pytest.mark.long
def test_axes_of_space_that_are_slightly_turned_are_fitted_as_well():
    """They leave 10 mrad, so that the axes as given fit, at an offset off by 10 to 17 of its errors."""
    found = pulls(TUMBLING, 20, askew=1e-2, space=1e-2)
    assert 0.6 < np.sqrt(np.mean(found**2)) < 1.4 and np.abs(found).max() < 3.5


def test_between_sampled_histories_in_either_order():
    times = np.arange(0.0, SPANNED, 0.1)
    sampled = rotation.normalize(follow(TUMBLING)(times)[3:].T)
    seen, start = log(TUMBLING, 3, askew=1e-2)
    there = align_clocks(AttitudeHistory("sampled", times, sampled), seen)
    back = align_clocks(seen, known(TUMBLING))
    assert abs(there.offset - start) < 3.0 * there.error and abs(back.offset + start) < 3.0 * back.error
    assert not there.supposed and not back.supposed


def test_a_steady_spin_supposes_that_the_axes_agree():
    """A turn about the spin looks like an offset: 10 mrad are a quarter of a second, and the error was 2 ms."""
    exact = known(SPINNING)
    assert calibrated(pulls(SPINNING, 12, lasting=45.0))
    found = align_clocks(exact, log(SPINNING, 0, lasting=45.0)[0])
    assert found.supposed and found.agreeing is None and found.error < 5e-3
    for seed in range(8):
        seen, start = log(SPINNING, seed, askew=1e-2, lasting=45.0)
        found = align_clocks(exact, seen)
        assert found.supposed and 0.05 < found.error < 2.0 and abs(found.offset - start) < 3.0 * found.error


def test_what_equal_axes_would_gain_is_told_where_none_shows():
    exact, gained = known(WOBBLING), []
    for seed in range(12):
        straight, start = log(WOBBLING, seed, lasting=45.0)
        found = align_clocks(exact, straight)
        assert not found.supposed
        if found.agreeing is not None:  # noise looks like a turn once in 140 times
            offset, error = found.agreeing
            assert error < 0.2 * found.error
            gained.append((offset - start) / error)
    assert len(gained) >= 11 and calibrated(np.array(gained))
    assert align_clocks(exact, log(WOBBLING, 0, askew=1e-2, lasting=45.0)[0]).agreeing is None


@pytest.fixture(scope="module")
def repeating():
    """A log of a body that repeats itself but for a turn of space, and when it began."""
    seen, start = log(TUMBLING, 5, askew=1e-2, lasting=25.0)
    turned = rotation.multiply(rotation.from_rotation_vector((0.5, 0.1, -1.0)), seen.attitude)
    return AttitudeHistory("turned", seen.times + 2e6, turned), start - 2e6


def test_several_offsets_are_listed_all(repeating):
    """Four of seven were listed, to six digits of perhaps two million, without the right one."""
    seen, start = repeating
    with pytest.raises(InvalidInput, match=r"ambiguous.* (\d+) offsets fit nearly as well as each other") as caught:
        align_clocks(known(TUMBLING), seen)
    text = str(caught.value)
    listed = text.split("each other, ")[1].split(" s, and leave")[0].replace(" and ", ", ").split(", ")
    offsets = np.array(listed, dtype=float)
    assert f" {len(offsets)} offsets" in text and "at least" not in text and (np.diff(offsets) > 1.0).all()
    assert np.abs(offsets - start).min() < 0.05 and "`offset`" in text


def test_about_where_it_lies_decides(repeating):
    seen, start = repeating
    for side in (-2.0, 0.0, 2.0):
        found = align_clocks(known(TUMBLING), seen, near=start + side)
        assert abs(found.offset - start) < 3.5 * found.error and found.turned
    with pytest.raises(InvalidInput, match="No one of them is clearly the nearest to"):
        align_clocks(known(TUMBLING), seen, near=start + 5.3)


def test_a_list_that_is_cut_says_so():
    """Of a spin that turns hundreds of times, twelve are refined; the nearest to the given one are among them."""
    body = (1.0, 2.0, 3.0), (0.0, 0.0, 20.0)
    motion = FreeMotion(body[0], angular_velocity=body[1], attitude=tuple(BEGIN))
    times = np.arange(0.0, 20.0, 0.01)
    seen = AttitudeHistory("seen", times, np.asarray(motion.attitude(times + 17.3)))
    with pytest.raises(InvalidInput, match=r"at least \d+ offsets .*; others, as good, were not looked at"):
        align_clocks(known(body), seen)
    found = align_clocks(known(body), seen, near=17.25)
    assert found.offset == pytest.approx(17.3, abs=1e-9) and found.supposed
