"""Precession and nutation of tops by samples, linearised and estimated, against the exact Lagrange top and mpmath."""

import math

import mpmath
import numpy as np
import pytest

import polhode as ph
from polhode import rotation
from polhode.analysis import axis_in_space, gyroscopic_rates, mean_top_rates, steady_top_rates
from polhode.systems import HeavyTop

MOMENTS, MGL = (1.0, 1.0, 0.5), 1.0
TOP = HeavyTop(MOMENTS, MGL)
TILT = math.radians(60.0)


def released(spin, azimuthal=0.0, tilt=TILT):
    """A top leaning by the tilt towards −y, which is let go while it precesses at a rate."""
    lean = np.array([math.cos(0.5 * tilt), math.sin(0.5 * tilt), 0.0, 0.0])
    velocity = rotation.rotate(rotation.conjugate(lean), np.array([0.0, 0.0, azimuthal]))
    momentum = np.asarray(MOMENTS) * velocity
    momentum[2] = MOMENTS[2] * spin
    return ph.LagrangeMotion(MOMENTS, mgl=MGL, momentum=momentum, attitude=lean)


@pytest.mark.parametrize("azimuthal", [0.0, -0.3, 0.25])  # a cusp, loops, undulation
def test_mean_rates_of_samples_are_those_of_the_closed_form(azimuthal):
    motion = released(5.0, azimuthal)
    times = np.linspace(0.0, 40.0, 4001)
    found = mean_top_rates(times, axis_in_space(TOP, motion.state(times)[0]))
    assert found.nutation == pytest.approx(2.0 * math.pi / motion.nutation_period, rel=1e-5)
    assert found.precession == pytest.approx(motion.precession_rate, rel=1e-4)
    # seen once in a nutation the axis stands still: nothing is said of what cannot be followed
    rare = np.arange(0.0, 40.0, motion.nutation_period)
    assert mean_top_rates(rare, axis_in_space(TOP, motion.state(rare)[0])).nutation is None
    fast = np.arange(0.0, 40.0, 2.8 / abs(motion.precession_rate))
    assert mean_top_rates(fast, axis_in_space(TOP, motion.state(fast)[0])).precession is None


def test_a_steady_top_precesses_and_does_not_nod():
    slow = steady_top_rates(TOP, 2.5, TILT).precession
    motion = released(5.0, slow)
    times = np.linspace(0.0, 10.0, 101)
    found = mean_top_rates(times, axis_in_space(TOP, motion.state(times)[0]))
    assert found.nutation is None and found.precession == pytest.approx(slow, rel=1e-9)


@pytest.mark.parametrize("tilt", [0.4, TILT, 0.5 * math.pi, 2.2])
def test_small_nutation_is_the_limit_of_the_exact_one(tilt):
    rates = steady_top_rates(TOP, 2.5, tilt)
    periods = [released(5.0, rates.precession * (1.0 + x), tilt).nutation_period for x in (1e-3, -1e-3)]
    assert rates.nutation == pytest.approx(2.0 * math.pi / np.mean(periods), rel=1e-5)


def test_it_is_the_curvature_of_the_effective_potential():
    with mpmath.workdps(40):
        I1, p = mpmath.mpf(1), mpmath.mpf("2.5")
        tilt = mpmath.mpf(TILT)
        slow = (p - mpmath.sqrt(p**2 - 4 * I1 * mpmath.cos(tilt))) / (2 * I1 * mpmath.cos(tilt))
        vertical = I1 * mpmath.sin(tilt) ** 2 * slow + p * mpmath.cos(tilt)
        potential = lambda x: (vertical - p * mpmath.cos(x)) ** 2 / (2 * I1 * mpmath.sin(x) ** 2) + mpmath.cos(x)  # noqa: E731
        wanted = mpmath.sqrt(mpmath.diff(potential, tilt, 2) / I1)
    found = steady_top_rates(TOP, 2.5, TILT)
    assert found.nutation == pytest.approx(float(wanted), rel=1e-12)
    assert found.precession == pytest.approx(float(slow), rel=1e-14)


def test_a_fast_top_is_a_gyroscope():
    """T I3 ω3/(2π I1) of a top let go at 60° comes to one as 1.00991605 at ω3 = 20, 1.00159804 at 50."""
    for spin, ratio in ((20.0, 1.00991605), (50.0, 1.00159804)):
        motion, estimate = released(spin), gyroscopic_rates(TOP, 0.5 * spin)
        assert estimate.nutation * motion.nutation_period / (2.0 * math.pi) == pytest.approx(ratio, rel=1e-8)
        assert estimate.precession == pytest.approx(1.0 / (0.5 * spin))
    assert gyroscopic_rates(TOP, 0.0) is None


def test_what_is_far_from_symmetric_has_no_such_rates():
    lopsided = HeavyTop((1.0, 1.3, 0.5), MGL)
    assert steady_top_rates(lopsided, 2.5, TILT) is None and gyroscopic_rates(lopsided, 2.5) is None
    nearly = HeavyTop((0.99, 1.01, 0.5), MGL)
    assert steady_top_rates(nearly, 2.5, TILT).nutation == pytest.approx(steady_top_rates(TOP, 2.5, TILT).nutation)
    assert steady_top_rates(TOP, 0.5, TILT) is None  # too slow to precess steadily
