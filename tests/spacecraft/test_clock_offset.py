"""The offset between two clocks from attitudes, its error, and motions that do not tell it."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from polhode import FreeMotion, rotation
from polhode.analysis._attitude_noise import attitude_noise
from polhode.errors import InvalidInput
from polhode.spacecraft.comparing.comparison import AttitudeHistory, align_clocks, compare

MOMENTS = (1.0, 2.0, 3.0)
TUMBLE = FreeMotion(MOMENTS, momentum=(0.3, 1.8, 1.5))


def exactly(motion, until=60.0, name="exact"):
    times = np.linspace(0.0, until, 600)
    return AttitudeHistory(name, times, np.asarray(motion.attitude(times)),
                           exact=lambda t: (motion.attitude(t), motion.angular_velocity(t)))  # fmt: skip


def seen(motion, start, noise=0.0, seed=0, lasting=25.0, rate=20.0, space=(0.0, 0.0, 0.0)):
    """Samples on a clock that began ``start`` seconds after the motion's, with noise [rad, each axis]."""
    times = np.arange(0.0, lasting, 1.0 / rate)
    attitude = np.asarray(motion.attitude(times + start))
    scatter = np.random.default_rng(seed).normal(0.0, noise, (len(times), 3))
    attitude = rotation.multiply(rotation.from_rotation_vector(np.array(space)), attitude)
    return AttitudeHistory("seen", times, rotation.multiply(attitude, rotation.from_rotation_vector(scatter)))


@pytest.mark.long_after(2)
@pytest.mark.parametrize("start", [-5.0, 0.0, 0.123456789, 17.3, 42.0])
def test_an_exact_motion_gives_it_to_rounding(start):
    found = align_clocks(exactly(TUMBLE), seen(TUMBLE, start))
    assert found.offset == pytest.approx(start, abs=1e-12) and not found.turned
    back = align_clocks(seen(TUMBLE, start), exactly(TUMBLE))
    assert back.offset == pytest.approx(-start, abs=1e-12)


def test_two_logs_of_different_times_overlap():
    early, late = seen(TUMBLE, 0.0, lasting=30.0, rate=50.0), seen(TUMBLE, 11.7, lasting=25.0, rate=33.0)
    assert align_clocks(early, late).offset == pytest.approx(11.7, abs=1e-7)
    assert compare(early, late, offset=11.7).largest < 1e-4  # the ends of a spline


@pytest.mark.sweep
def test_its_error_is_the_scatter_of_repeated_logs():
    """Of forty logs with noise of 2 mrad the offset scatters by what each says of itself."""
    found = [align_clocks(exactly(TUMBLE), seen(TUMBLE, 3.21, 2e-3, seed)) for seed in range(40)]
    pulls = [(one.offset - 3.21) / one.error for one in found]
    assert 0.7 < np.sqrt(np.mean(np.square(pulls))) < 1.35 and abs(np.mean(pulls)) < 0.6
    assert found[0].error < 1e-4 and found[0].left == pytest.approx(2e-3 * np.sqrt(3.0), rel=0.1)


def swinging(times, axes=None):
    """A motion that never repeats itself: two swings of other frequencies, and a turn that speeds up."""
    turns = Rotation.from_euler("ZYX", np.stack([0.05 * times**2, np.sin(0.7 * times), 0.8 * np.sin(1.9 * times)], -1))
    return rotation.from_scipy(turns if axes is None else Rotation.from_rotvec(axes) * turns)


@pytest.mark.long
def test_axes_of_space_may_be_turned():
    """As of a log whose heading has another zero; the axes as given leave a radian."""
    times, late = np.arange(0.0, 25.0, 0.02), np.arange(0.0, 12.0, 0.03)
    other = AttitudeHistory("b", late, swinging(late + 8.4, (0.0, 0.0, 2.0)))
    found = align_clocks(AttitudeHistory("a", times, swinging(times)), other)
    assert found.turned and found.offset == pytest.approx(8.4, abs=1e-4)


def test_a_free_body_repeats_itself_but_for_a_turn_of_space():
    """After each period of the polhode the motion repeats, rotated about L."""
    with pytest.raises(InvalidInput, match="ambiguous"):
        align_clocks(exactly(TUMBLE), seen(TUMBLE, 8.4, 1e-3, space=(0.0, 0.0, 2.0)))


@pytest.mark.parametrize(("motion", "space", "words"), [
    (FreeMotion(MOMENTS, momentum=(0.0, 0.0, 3.0)), (0.0, 0.0, 0.0), "ambiguous, as the motion nearly repeats"),
    (FreeMotion(MOMENTS, momentum=(0.0, 0.0, 3.0)), (1.0, 0.0, 0.0), "turns steadily"),
    (FreeMotion((1.0, 1.0, 2.0), momentum=(0.0, 1.0, 0.0)), (0.0, 0.0, 0.0), "ambiguous"),
    (FreeMotion(MOMENTS, momentum=(0.0, 0.0, 0.0)), (0.0, 0.0, 0.0), "does not change"),
])  # fmt: skip
def test_motions_that_do_not_tell_it(motion, space, words):
    with pytest.raises(InvalidInput, match=words) as caught:
        align_clocks(exactly(motion), seen(motion, 2.0, 1e-3, space=space))
    assert "`offset`" in str(caught.value)


def test_another_motion_is_not_taken_for_it():
    other = FreeMotion(MOMENTS, momentum=(1.4, 0.2, 1.5))
    with pytest.raises(InvalidInput, match="no offset of the clocks makes the two agree: the best"):
        align_clocks(exactly(TUMBLE), seen(other, 2.0))


@pytest.mark.parametrize("turned", [0.0, 1.0])
def test_a_log_that_hardly_turns_is_laid_nowhere(turned):
    """Three samples within 4 mrad were laid at 48 ± 76 s of a body that turns by ten radians, which left 0.049 rad."""
    tilt = rotation.from_rotation_vector((turned, 0.0, 0.0))
    few = rotation.from_rotation_vector(np.array([[0.0, 0.0, 0.0], [0.0, 0.0, 0.002], [0.0, 0.0, 0.004]]))
    with pytest.raises(InvalidInput, match=r"no offset of the clocks makes the two agree.* turn by 0\.0016 rad rms"):
        align_clocks(exactly(TUMBLE), AttitudeHistory("few", np.arange(3.0), rotation.multiply(tilt, few)))


def leaning(times):
    """A steady turn about an axis that leans over by a tenth of a radian within a minute."""
    return Rotation.from_euler("ZX", np.stack([0.3 * times, 0.1 * (times / 60.0) ** 2], axis=-1))


def test_an_offset_with_an_error_as_large_as_the_span_is_none():
    """With other axes of space only the leaning tells it, and ten samples with noise do not show that."""
    times, late = np.arange(0.0, 60.0, 0.5), np.arange(0.0, 25.0, 2.5)
    whole = AttitudeHistory("a", times, rotation.from_scipy(leaning(times)))
    other = Rotation.from_rotvec([1.0, 0.0, 0.0]) * leaning(late + 8.4)
    noisy = other * Rotation.from_rotvec(np.random.default_rng(0).normal(0.0, 0.03, (len(late), 3)))
    with pytest.raises(InvalidInput, match=r"do not determine the offset of the clocks: the best is .* ± .*`offset`"):
        align_clocks(whole, AttitudeHistory("b", late, rotation.from_scipy(noisy)))
    found = align_clocks(whole, AttitudeHistory("b", late, rotation.from_scipy(other)))
    assert found.turned and found.offset == pytest.approx(8.4, abs=1e-3)


def test_a_nearly_periodic_motion_with_noise_is_ambiguous():
    """A body that nutates little: after each turn it is nearly as it was, nearer than the noise."""
    motion = FreeMotion((1.0, 1.001, 1.5), momentum=(1e-3, 0.0, 1.0))
    with pytest.raises(InvalidInput, match=r"ambiguous.* 8 offsets fit nearly as well.* leave .* rad rms"):
        align_clocks(exactly(motion), seen(motion, 2.0, 5e-3))


@pytest.mark.parametrize("digits", [4, 6, 8])
def test_printed_digits_are_noise(digits):
    """A last digit d of each component leaves 2 d/√12 of an angle along three axes."""
    times = np.arange(0.0, 20.0, 0.02)
    printed = np.round(np.asarray(TUMBLE.attitude(times)), digits)
    attitude = printed / np.linalg.norm(printed, axis=1)[:, None]
    true = rotation.angle_between(attitude, np.asarray(TUMBLE.attitude(times)))
    assert attitude_noise(times, attitude) == pytest.approx(np.sqrt(np.mean(true**2)), rel=0.15)
    assert attitude_noise(times, attitude) == pytest.approx(10.0**-digits * np.sqrt(4 * 3 / 12), rel=0.2)


@pytest.mark.parametrize("scatter", [1e-2, 1e-5])
def test_noise_of_a_gyro(scatter):
    log = seen(TUMBLE, 0.0, scatter, lasting=100.0)
    assert attitude_noise(log.times, log.attitude) == pytest.approx(scatter * np.sqrt(3.0), rel=0.1)


def test_noise_is_not_known_of_few_or_uneven_samples():
    log = seen(TUMBLE, 0.0)
    assert attitude_noise(log.times[:30], log.attitude[:30]) is None
    uneven = log.times**1.5
    assert attitude_noise(uneven, log.attitude) is None
    assert attitude_noise(log.times[::100], log.attitude[::100]) is None


def test_what_is_left_must_be_noise_to_be_explained():
    """Half of a milliradian is explained by a misalignment, the other half is a motion of its own."""
    exact = exactly(TUMBLE)
    log = seen(TUMBLE, 0.0, 1e-6)
    askew = rotation.from_rotation_vector((1e-3, 0.0, 0.0))
    fits = AttitudeHistory("askew", log.times, rotation.multiply(log.attitude, askew))
    assert compare(exact, fits).explained and not compare(exact, log).explained and compare(exact, log).is_noise
    swings = rotation.from_rotation_vector(5e-5 * np.sin(2.0 * log.times)[:, None] * np.array([0.0, 1.0, 0.0]))
    moves = AttitudeHistory("moves", log.times, rotation.multiply(fits.attitude, swings))
    found = compare(exact, moves)
    assert found.alignment.rms < 0.05 * found.rms and not found.explained and not found.is_noise


def test_noise_against_scipy():
    """Turns by SciPy, about one axis, so that the scatter along it is known."""
    generator = np.random.default_rng(3)
    times = np.arange(0.0, 10.0, 0.01)
    scatter = generator.normal(0.0, 1e-4, len(times))
    turns = Rotation.from_rotvec(np.stack([0.0 * times, 0.0 * times, np.sin(times) + scatter], axis=1))
    assert attitude_noise(times, rotation.from_scipy(turns)) == pytest.approx(1e-4, rel=0.1)
