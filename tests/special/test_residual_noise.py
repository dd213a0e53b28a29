"""Residuals that are noise and that are not; noise made by NumPy and by SciPy's filters."""

import numpy as np
import pytest
from scipy.signal import butter, lfilter

from polhode.special import _residual_noise
from polhode.special._residual_noise import LIMITS

SWING = 0.35  # of the noise, the amplitude of what a model leaves out


def judge(residuals, **how):
    return _residual_noise.test_noise(residuals, **how)


def noises(kind, rng, count):
    white = rng.normal(size=(count, 3))
    return {
        "white": white, "of axes that differ": white * [1.0, 30.0, 0.1],
        "rounded": np.round(0.6 * white), "uniform": rng.uniform(-1.0, 1.0, (count, 3)),
        "with outliers": np.where(rng.uniform(size=(count, 3)) < 0.02, 20.0, 1.0) * white,
        "that grows threefold": white * np.linspace(1.0, 3.0, count)[:, None],
    }[kind]  # fmt: skip


@pytest.mark.long
@pytest.mark.parametrize("kind", ["white", "of axes that differ", "rounded", "uniform", "with outliers",
                                  "that grows threefold"])  # fmt: skip
@pytest.mark.parametrize("count", [12, 70, 1000])
def test_noise_is_noise(kind, count):
    """Of 300 logs three would be one in a hundred; at LIMITS.probability two are already one chance in a thousand."""
    rng = np.random.default_rng(count)
    assert sum(not judge([noises(kind, rng, count)]).is_noise for _ in range(300)) <= 1


def test_the_probability_is_one_of_chance():
    rng = np.random.default_rng(5)
    seen = np.array([judge([rng.normal(size=(60, 3))]).probability for _ in range(1000)])
    assert 0.005 < np.mean(seen < 0.05) < 0.06  # Bonferroni's correction makes it less


@pytest.mark.parametrize("turns", [0.5, 3.3, 40.0, 180.0])
def test_a_swing_of_any_frequency_below_the_noise_is_no_noise(turns):
    """Neighbours are alike by a twentieth only: their correlation, which was looked at, would not show it."""
    rng = np.random.default_rng(2)
    t = np.linspace(0.0, 1.0, 600)
    swing = SWING * np.sqrt(2.0) * np.stack([np.sin(2 * np.pi * turns * t + k) for k in range(3)], axis=1)
    found = judge([rng.normal(size=(600, 3)) + swing])
    assert not found.is_noise and found.probability < 1e-6
    assert abs(found.alike) < 0.3


def test_the_limit_has_two_sides():
    rng = np.random.default_rng(8)
    t = np.linspace(0.0, 1.0, 400)
    noise, swing = rng.normal(size=(400, 3)), np.sin(2 * np.pi * 3 * t)[:, None]
    sizes = np.linspace(0.0, 0.5, 26)
    chances = [judge([noise + size * swing]) for size in sizes]
    assert chances[0].is_noise and not chances[-1].is_noise
    assert all(one.is_noise == (one.probability >= LIMITS.probability) for one in chances)


def test_what_parameters_took_is_not_missed():
    """12 samples and 14 parameters: what is left of white noise has no low frequencies."""
    rng = np.random.default_rng(3)
    t = np.linspace(0.0, 1.0, 12)
    plain = corrected = 0
    for _ in range(400):
        slopes = np.stack([np.cos(np.pi * k * t)[:, None] * rng.normal(size=3) for k in range(14)], axis=-1)
        rows, z = slopes.reshape(36, 14), rng.normal(size=36)
        left = (z - rows @ np.linalg.lstsq(rows, z, rcond=None)[0]).reshape(12, 3)
        plain += judge([left]).probability < 0.01
        corrected += judge([left], slopes=[slopes]).probability < 0.01
    assert corrected <= 4 < plain


@pytest.mark.long
@pytest.mark.parametrize("cutoff", [0.18, 0.42])
def test_a_gyros_filter_leaves_noise(cutoff):
    """Butterworth filters of second order, at 90 Hz of 1 kHz and at 42 Hz of 200 Hz."""
    rng = np.random.default_rng(6)
    for _ in range(100):
        noise = lfilter(*butter(2, cutoff), rng.normal(size=(900, 3)), axis=0)[200:]
        assert _residual_noise.test_filtered_noise([noise], 0.01 / cutoff * 0.18).is_noise


def test_what_moves_with_the_body_is_not_taken_for_a_filter():
    rng = np.random.default_rng(6)
    t = np.arange(700) * 0.009  # rad
    noise = lfilter([0.43], [1.0, -0.57], rng.normal(size=(700, 3)), axis=0)
    moving = 0.6 * np.stack([np.sin(t), np.cos(2 * t), np.sin(2 * t)], axis=1)
    assert not _residual_noise.test_filtered_noise([noise + moving], 0.009).is_noise
    assert _residual_noise.test_filtered_noise([noise], 0.009).is_noise
