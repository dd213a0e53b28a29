"""Whether a gyro is at its limit: of motions by SciPy's DOP853, rounded as devices round, and clipped or not.

The rule before took three equal largest samples of one axis for a limit, and lost up to 99 % of the samples of those
here that are not clipped.
"""

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.spatial.transform import Rotation

from measuring.thrown import euler
from polhode.measuring import Window, clean_log, fit_throw
from polhode.measuring.throws._saturation import saturation

DPS = np.pi / 180
STEPS = {"whole deg/s": DPS, "counts": DPS / 16.4, "mrad/s": 1e-3, "none": 0.0}
SPINS = {"any": (1.0, 6.0, 0.6), "near the middle axis": (0.01, 8.0, 0.01), "near the largest": (0.3, 0.2, 9.0)}


def motion(spin, rate, seconds=1.0, moments=(0.2, 0.8, 1.0)):
    t = np.arange(0.0, seconds, 1.0 / rate)
    done = solve_ivp(euler(moments, 0.0), (0.0, seconds), spin, method="DOP853", rtol=1e-10, atol=1e-11, t_eval=t)
    return t, done.y.T


def rounded(rates, step):
    return step * np.round(rates / step) if step else rates


@pytest.mark.long_after(16)
@pytest.mark.parametrize("step", STEPS)
@pytest.mark.parametrize("spin", SPINS)
@pytest.mark.parametrize(("rate", "repeated", "noise"), [
    (50, 1, 0.0), (1000, 1, 0.0), (1000, 1, 3e-3), (1000, 20, 0.0),
])  # fmt: skip
def test_smooth_peaks_are_no_limit(step, spin, rate, repeated, noise):
    t, w = motion(SPINS[spin], rate, 2.0)
    w = w + noise * np.random.default_rng(1).normal(size=w.shape)
    w = np.repeat(w[::repeated], repeated, axis=0)[: len(t)]  # as a logger does that is faster than its sensor
    assert saturation([clean_log(t, rounded(w, STEPS[step]))]) is None


@pytest.mark.parametrize("step", STEPS)
@pytest.mark.parametrize(("rate", "noise"), [(100, 0.0), (100, 2e-3), (1000, 2e-3), (1000, 0.02)])
def test_a_range_that_is_sold_is_a_limit(step, rate, noise):
    t, w = motion((2.0, 10.0, 3.0), rate)
    limit = 500 * DPS
    w = np.clip(w + noise * np.random.default_rng(2).normal(size=w.shape), -limit, limit)
    at_it = np.abs(w) >= limit
    assert 0.05 < at_it.any(axis=1).mean() < 0.8
    found = saturation([clean_log(t, rounded(w, STEPS[step]))])
    assert found == pytest.approx(limit, rel=0.01)


def test_a_limit_of_its_own_shows_on_both_sides_or_twice():
    t, w = motion((9.0, 2.5, 2.0), 200, 3.0)
    turned = w @ Rotation.from_rotvec([0.3, 0.9, 0.5]).as_matrix().T
    clipped = np.clip(turned, -6.3, 6.3)
    assert saturation([clean_log(t, clipped)]) == pytest.approx(6.3, rel=1e-6)
    smeared = clipped + 2e-3 * np.random.default_rng(3).normal(size=w.shape)  # noise that is added later
    assert 6.2 < saturation([clean_log(t, smeared)]) < 6.3


def test_a_steady_spin_and_rest_are_no_limit():
    t = np.arange(0.0, 3.0, 0.01)
    spin = np.where((t > 1) & (t < 2), 7.0, 0.0)[:, None] * [0.0, 0.0, 1.0]
    for noise in (0.0, 1e-3):
        log = clean_log(t, spin + noise * np.random.default_rng(4).normal(size=spin.shape))
        assert saturation([log]) is None


def test_nothing_above_a_limit_means_nothing_on_any_axis():
    """A plateau below what another axis reaches is not the gyro's limit, which all axes have."""
    t, w = motion((2.0, 10.0, 3.0), 500)
    w[:, 2] = np.clip(w[:, 2], -2.0, 2.0)
    assert saturation([clean_log(t, w)]) is None


@pytest.mark.long
def test_whole_degrees_lose_no_sample_of_a_fit():
    """58 of 1000 samples were left, and the body "turned by 0.39 rad only"."""
    t, w = motion((1.0, 6.0, 0.6), 500)
    seen = rounded(w + 0.2 * DPS * np.random.default_rng(1).normal(size=w.shape), DPS)
    fit = fit_throw(clean_log(t, seen), [[Window(0.0, 1.0)]], drag=False, gain=False)
    assert len(fit.residuals) == 500 and fit.clip is None
    assert (np.abs(fit.ratios.value - [0.2, 0.8]) < 4 * fit.ratios.standard_error).all()
