"""Thresholds up to which samples and motions are judged, each on either side."""

import math
from types import SimpleNamespace

import numpy as np
import pytest

import polhode as ph
from polhode.analysis import top_motion
from polhode.analysis._attitude_noise import attitude_noise
from polhode.analysis._exact_arithmetic import check_digits
from polhode.analysis.cone import rotation_form
from polhode.analysis.gravity_gradient import orbital_equilibria
from polhode.analysis.gyrostat_rotations import mean_winding_rate
from polhode.analysis.top_rates import _symmetric, mean_top_rates
from polhode.analysis.top_start import steady_precession_at, top_velocity
from polhode.errors import InvalidInput


def turning(count, angle, bend=0.0):
    """Return times and attitudes that turn by an angle from sample to sample, one step longer by a share."""
    times = np.arange(float(count))
    times[-1] += bend
    half = 0.5 * angle * np.arange(count)
    return times, np.stack([np.cos(half), np.zeros(count), np.zeros(count), np.sin(half)], axis=-1)


@pytest.mark.parametrize(("samples", "known"), [
    (turning(40, 0.1), True), (turning(39, 0.1), False), (turning(40, 0.99), True), (turning(40, 1.01), False),
    (turning(40, 0.1, 0.19), True), (turning(40, 0.1, 0.21), False),
])  # fmt: skip
def test_the_noise_of_attitudes_needs_many_even_close_samples(samples, known):
    assert (attitude_noise(*samples) is not None) == known


@pytest.mark.parametrize(("step", "tilt", "known"), [
    (2.4, 1.0, True), (2.6, 1.0, False), (0.1, 2e-9, True), (0.1, 0.5e-9, False),
])  # fmt: skip
def test_a_vector_is_followed_about_an_axis(step, tilt, known):
    angle, times = step * np.arange(30.0), np.arange(30.0)
    vectors = np.stack([tilt * np.cos(angle), tilt * np.sin(angle), np.ones(30)], axis=-1)
    rate = mean_winding_rate(times, vectors, np.array([0.0, 0.0, 1.0]))
    assert rate == pytest.approx(step) if known else rate is None


def nodding(step=0.3, height=0.1, samples=8, nutations=4):
    """Return times and a top's axis with a step of azimuth, a range of heights, and samples a nutation."""
    times = np.arange(float(samples * nutations))
    z = 0.5 + 0.5 * height * np.cos(2.0 * np.pi * (times + 0.3) / samples)
    across = np.sqrt(1.0 - z * z)
    return times, np.stack([across * np.cos(step * times), across * np.sin(step * times), z], axis=-1)


@pytest.mark.parametrize(("samples", "precesses", "nutates"), [
    (nodding(), True, True), (nodding(step=2.4), True, True), (nodding(step=2.6), False, True),
    (nodding(height=1.2e-9), True, True), (nodding(height=0.9e-9), True, False), (nodding(samples=7), True, False),
    (nodding(nutations=3), True, False),
])  # fmt: skip
def test_mean_rates_of_a_top_need_close_samples_of_several_nutations(samples, precesses, nutates):
    rates = mean_top_rates(*samples)
    assert (rates.precession is not None, rates.nutation is not None) == (precesses, nutates)


def test_a_top_may_be_a_little_less_than_symmetric():
    assert _symmetric(ph.systems.HeavyTop((1.0, 0.901, 0.5), 1.0)) is not None
    assert _symmetric(ph.systems.HeavyTop((1.0, 0.899, 0.5), 1.0)) is None


@pytest.mark.parametrize(("degrees", "form"), [(44.9, "coning"), (45.1, "tumbling")])
def test_a_cone_is_no_wider_than_half_a_right_angle(degrees, form):
    angle = math.radians(degrees)
    assert rotation_form(ph.FreeMotion((2.0, 2.0, 3.0), momentum=(math.sin(angle), 0.0, math.cos(angle)))) == form


def test_a_top_leans_beyond_rounding():
    top = ph.systems.HeavyTop((1.0, 1.0, 0.5), 1.0)
    assert top_velocity(top, top.leaning(2e-12), nutation_rate=1.0) is not None
    with pytest.raises(InvalidInput, match="needs an axis that leans"):
        top_velocity(top, top.leaning(0.5e-12), nutation_rate=1.0)
    assert steady_precession_at(top, 1.1e-12, 10.0).slow > 0.0
    with pytest.raises(InvalidInput, match="needs an axis that leans"):
        steady_precession_at(top, 0.9e-12, 10.0)


@pytest.mark.parametrize(("width", "steady"), [(0.9e-12, True), (1.1e-12, False)])
def test_a_tilt_is_constant_up_to_rounding(width, steady):
    motion = SimpleNamespace(regime="loop", nutation_limits=(-0.5 * width, 0.5 * width))
    assert top_motion.is_steady_precession(motion) is steady


@pytest.mark.parametrize(("gap", "degenerate"), [(1.4e-12, True), (1.6e-12, False)])
def test_moments_that_are_equal_but_for_rounding_have_a_degenerate_rest(gap, degenerate):
    """The difference of the moments along and across the radius is compared with that about the orbit's normal."""
    rests = {(one.roll, one.pitch, one.yaw): one.region for one in orbital_equilibria((1.0 + gap, 1.5, 1.0), 1e-3)}
    assert (rests[1, 2, 3] == "degenerate") is degenerate


def test_digits_have_a_bound():
    assert check_digits(10_000) == 10_000
    with pytest.raises(InvalidInput, match="from 1 to 10,000"):
        check_digits(10_001)
