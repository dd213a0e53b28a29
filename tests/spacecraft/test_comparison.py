"""Comparisons of attitude histories: specimens whose differences are known."""

from dataclasses import replace

import numpy as np
import pytest

from polhode import FreeMotion, InvalidInput, LagrangeMotion, rotation
from polhode.analysis import AttitudeHistory, Mechanics
from polhode.spacecraft import compare
from polhode.spacecraft.comparing.alignment import fit_alignment, mean_quaternion

EXACT = 1e-12  # rad, rad/s and relative: rounding of a few quaternion products
MOTION = FreeMotion((1.0, 2.0, 3.0), momentum=(0.3, 1.8, 1.5), attitude=(0.5, -0.5, 0.5, 0.5))
TIMES = np.linspace(3.0, 43.0, 1501)
BODY = Mechanics(np.diag([1.0, 2.0, 3.0]))


def history(times=TIMES, shift=0.0, rates=False, name="samples"):
    velocity = MOTION.angular_velocity(times) if rates else None
    return AttitudeHistory(name, times - shift, MOTION.attitude(times), velocity, mechanics=BODY)


def exact(times=TIMES):
    return replace(history(times), name="exact", exact=lambda t: (MOTION.attitude(t), MOTION.angular_velocity(t)))


def disturbed(body, space, rate, times=TIMES):
    """Return the motion, rotated by constants of the body and of space, space turning on at a rate."""
    turning = rotation.from_rotation_vector(np.asarray(rate) * (times - times[0])[:, None])
    turned = rotation.multiply(rotation.multiply(turning, rotation.from_rotation_vector(space)), MOTION.attitude(times))
    return AttitudeHistory("disturbed", times, rotation.multiply(turned, rotation.from_rotation_vector(body)))


def test_motions_and_trajectories_are_compared_as_they_are():
    motion = FreeMotion((1.0, 2.0, 3.0), momentum=(0.3, 1.8, 1.5))
    other = FreeMotion((1.0, 2.0, 3.0), momentum=(0.3, 1.8, 1.5 + 1e-6))
    times = np.linspace(0.0, 5.0, 101)
    assert compare(motion, motion.sample(times)).largest < 1e-14
    assert compare(motion.sample(times), motion).largest < 1e-14
    found = compare(motion.sample(times), other)
    wanted = rotation.angle_between(motion.attitude(times), other.attitude(times))
    assert found.angle == pytest.approx(wanted, abs=1e-14) and found.largest > 1e-7
    late = FreeMotion((1.0, 2.0, 3.0), momentum=(0.3, 1.8, 1.5), epoch=-2.0)
    assert compare(late.sample(times - 2.0), motion, offset=-2.0).largest < 1e-13
    with pytest.raises(InvalidInput, match="both motions in closed form"):
        compare(motion, other)


@pytest.mark.usefixtures("any_type")
def test_what_has_no_attitude_is_not_compared():
    samples = FreeMotion((1.0, 2.0, 3.0), momentum=(0.3, 1.8, 1.5)).sample(np.linspace(0.0, 5.0, 101))
    with pytest.raises(InvalidInput, match="`b` must be a file, an AttitudeHistory, a Trajectory"):
        compare(samples, "motion.nc")


@pytest.mark.parametrize(
    ("body", "space", "rate"),
    [
        ((0.01, -0.02, 0.03), (0.0, 0.0, 0.0), (0.0, 0.0, 0.0)),
        ((0.0, 0.0, 0.0), (0.1, 0.2, -0.3), (0.0, 0.0, 0.0)),
        ((0.0, 0.0, 0.0), (0.0, 0.0, 0.0), (1e-3, 0.0, -2e-3)),
        ((1.0, -0.5, 0.3), (0.4, 1.0, -2.0), (1e-3, 2e-3, -1e-2)),
        ((3e-7, 0.0, 1e-7), (0.0, 2e-7, 0.0), (0.0, 1e-8, 0.0)),
    ],
)
def test_known_misalignments_and_rates_come_back(body, space, rate):
    found = compare(disturbed(body, space, rate), exact()).alignment
    assert found is not None and found.determined
    for value, expected in ((found.body, body), (found.space, space), (found.rate, rate)):
        assert np.abs(value - np.asarray(expected)).max() <= EXACT
    assert found.remaining.max() <= EXACT


def test_a_constant_rotation_and_its_growth_are_the_angle_themselves():
    axis = np.array([2.0, -1.0, 2.0]) / 3.0
    found = compare(disturbed((0, 0, 0), 1e-3 * axis, 2e-5 * axis), exact())
    assert np.abs(found.angle - (1e-3 + 2e-5 * (TIMES - TIMES[0]))).max() <= EXACT
    assert found.growth == pytest.approx(2e-5, abs=EXACT)
    assert found.largest == pytest.approx(1e-3 + 2e-5 * 40.0, abs=EXACT)
    mean_square = 1e-3**2 + 1e-3 * 2e-5 * 40.0 + (2e-5 * 40.0) ** 2 / 3.0
    assert found.rms == pytest.approx(np.sqrt(mean_square), rel=1e-4)  # samples are not an integral
    still = compare(disturbed((0, 0, 1e-9), (0, 0, 0), (0, 0, 0)), exact())
    assert still.largest == pytest.approx(1e-9, abs=1e-15) and abs(still.growth or 0.0) <= 1e-17


def test_what_no_alignment_explains_remains():
    wobble = rotation.from_rotation_vector(0.01 * np.sin(5.0 * TIMES)[:, None] * np.array([1.0, 0.0, 0.0]))
    shaken = AttitudeHistory("shaken", TIMES, rotation.multiply(wobble, MOTION.attitude(TIMES)))
    found = compare(shaken, exact()).alignment
    assert found is not None and 0.009 < found.remaining.max() < 0.0111


def test_a_steady_spin_does_not_tell_all_nine_apart():
    spin = FreeMotion((1.0, 2.0, 3.0), momentum=(0.0, 0.0, 3.0)).attitude(TIMES)
    turned = rotation.multiply(spin, rotation.from_rotation_vector((0.0, 0.0, 0.02)))
    found = fit_alignment(TIMES, turned, spin)
    assert found is not None and not found.determined and found.remaining.max() <= EXACT
    assert found.body[2] + found.space[2] == pytest.approx(0.02, abs=EXACT)


def test_the_mean_does_not_mind_signs():
    quaternions = rotation.from_rotation_vector(0.3 + 0.01 * np.random.default_rng(3).standard_normal((50, 3)))
    signs = np.where(np.arange(50) % 3, 1.0, -1.0)[:, None]
    assert rotation.angle_between(mean_quaternion(signs * quaternions), mean_quaternion(quaternions)) <= EXACT


# ---------------------------------------------------------------- times


def test_exact_motions_go_to_the_samples_of_the_other():
    other = history(np.linspace(-5.0, 99.0, 77), shift=-1000.0)  # its clock is 1000 s ahead
    for a, b, offset, times in (
        (exact(), other, -1000.0, np.linspace(-5.0, 99.0, 77)),
        (other, exact(), 1000.0, other.times), (exact(), exact(), 0.0, TIMES),
    ):  # fmt: skip
        found = compare(a, b, offset=offset)
        assert np.abs(found.times - times).max() <= 1e-12
        assert found.largest <= EXACT and "exactly" in found.method and found.interpolation_error is None
        assert found.alignment is None


def test_samples_at_the_same_times_are_not_interpolated():
    late = history(TIMES + 0.0, shift=17.25)
    found = compare(history(), late, offset=17.25)
    assert found.largest <= EXACT and "same times" in found.method and found.interpolation_error is None
    part = compare(history(), history(TIMES[700:900]))
    assert np.array_equal(part.times, TIMES[700:900]) and part.largest <= EXACT
    one = compare(history(), history(TIMES[7:8]))
    assert np.array_equal(one.times, TIMES[7:8]) and one.growth is None


@pytest.mark.parametrize("late", [0.0, 80.0])
def test_times_to_a_digit_are_the_same_times(late):
    """Steps that shrink to far below a thousand million times the digit, as at the end of a rolling disk."""
    times = late + 1.0 - np.geomspace(1.0, 1e-4, 60)
    digit = 1e-9
    written = AttitudeHistory("written", np.round(times / digit) * digit, MOTION.attitude(times), resolution=digit / 2)
    for a, b in ((history(times), written), (written, history(times)), (written, written)):
        found = compare(a, b)
        assert found.method == "both have samples at the same times" and len(found.times) == 60
        assert found.interpolation_error is None and found.is_rounding and found.alignment is None
    strict = compare(history(times), replace(written, resolution=0.0))
    assert strict.interpolation_error is not None


@pytest.mark.parametrize("rates", [True, False])
def test_nothing_is_fitted_to_the_rounding_of_times(rates):
    """A steady turn meets the bound speed times half a digit exactly; four times that is no rounding any more."""
    digit, speed = 1e-9, 7.0
    spin = FreeMotion((1.0, 2.0, 3.0), momentum=(0.0, 0.0, 3.0 * speed))
    velocity = spin.angular_velocity(TIMES) if rates else None
    for shift, rounded in ((0.5, True), (-0.5, True), (2.0, False)):
        seen = AttitudeHistory("seen", TIMES, spin.attitude(TIMES + shift * digit), velocity, resolution=0.5 * digit)
        truth = AttitudeHistory("truth", TIMES, spin.attitude(TIMES), exact=lambda t: (spin.attitude(t), None))
        found = compare(seen, truth)
        assert found.largest == pytest.approx(abs(shift) * digit * speed, rel=1e-4)
        assert found.is_rounding == rounded and (found.alignment is None) == rounded


@pytest.mark.parametrize("count", [101, 401, 1601])
def test_the_interpolation_error_is_said_and_not_too_small(count):
    found = compare(history(), history(np.linspace(-5.0, 50.0, count)))
    assert found.interpolation_error is not None
    assert found.largest <= found.interpolation_error <= 300.0 * found.largest


def test_only_common_times_count_and_none_is_refused():
    found = compare(history(), history(np.linspace(-10.0, 10.0, 500)))
    assert found.times[0] == 3.0 and found.times[-1] <= 10.0
    with pytest.raises(InvalidInput, match="no time in common"):
        compare(history(), history(), offset=100.0)


# ---------------------------------------------------------------- invariants


def test_invariants_of_an_exact_motion_and_of_samples():
    found = compare(exact(), history(rates=True))
    for side, source in zip(found.invariants, ("the exact motion", "as given"), strict=True):
        assert side is not None and side.source == source
        assert set(side.drift) == {"energy", "momentum_norm", "momentum_space"}
        assert max(side.drift.values()) <= EXACT
        assert side.values["energy"][0] == pytest.approx(MOTION.energy)


def test_invariants_without_rates_go_by_a_spline():
    side = compare(exact(), history(np.linspace(0.0, 50.0, 4001))).invariants[1]
    assert side is not None and "spline" in side.source
    assert max(side.drift.values()) <= 1e-8  # the spline's error of fourth order at this step
    assert len(side.times) == 4001 - 32


def test_a_motion_that_loses_energy_is_found_out():
    slowing = 1.0 - 1e-3 * (TIMES - TIMES[0])
    lossy = replace(history(), angular_velocity=MOTION.angular_velocity(TIMES) * slowing[:, None])
    side = compare(exact(), lossy).invariants[1]
    assert side is not None
    assert side.drift["momentum_norm"] == pytest.approx(0.04, abs=EXACT)
    assert side.drift["energy"] == pytest.approx(1.0 - 0.96**2, abs=EXACT)


def test_a_top_keeps_energy_and_vertical_momentum():
    top = LagrangeMotion(
        (1.0, 1.0, 2.0), mgl=3.0, momentum=(0.2, 0.4, 6.0), attitude=rotation.from_rotation_vector((0.5, 0.0, 0.0))
    )
    samples = top.sample(TIMES)
    heavy = Mechanics(np.diag([1.0, 1.0, 2.0]), np.array([0.0, 0.0, 3.0]))
    own = AttitudeHistory("top", TIMES, samples.attitude, samples.angular_velocity, mechanics=heavy)
    side = compare(own, own).invariants[0]
    assert side is not None and max(side.drift.values()) <= EXACT
    assert side.values["energy"][0] == pytest.approx(top.energy)
    assert side.values["vertical_momentum"][0] == pytest.approx(top.vertical_momentum)
    light = replace(own, mechanics=heavy._replace(weight=np.array([0.0, 0.0, 2.0])))
    lightened = compare(own, light).invariants[1]
    assert lightened is not None and lightened.drift["energy"] > 1e-3
