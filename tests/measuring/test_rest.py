"""Where a device lies still: of logs with noise, rounding, bias and hands, whose rest is known."""

import numpy as np
import pytest

from polhode.measuring import clean_log, rest_stretches

BIAS = np.array([0.02, -0.01, 0.0])


def handled(rate, noise, step, seed=1):
    """Return times and rates: at rest to 2 s, turned by hand to 4 s, held to 5 s, at rest to 6 s."""
    rng = np.random.default_rng(seed)
    t = np.arange(0.0, 6.0, 1.0 / rate)
    w = BIAS + noise * rng.normal(size=(len(t), 3))
    x = t[:, None]
    w += np.where((x > 2) & (x < 4), [4.0, 3.0, 1.0] * np.sin(x * [9.0, 7.0, 5.0]), 0.0)
    tremor = 0.05 * np.sin(2 * np.pi * 9 * x + [0, 1, 2]) + 0.06 * np.sin(2 * np.pi * 1.3 * x + [2, 0, 1])
    w += np.where((x >= 4) & (x < 5), tremor, 0.0)
    return t, step * np.round(w / step) if step else w


@pytest.mark.parametrize("rate", [50, 100, 1000])
@pytest.mark.parametrize(("noise", "step"), [(1e-4, 0.0), (5e-3, 0.0), (3e-3, np.radians(1 / 16.4)), (1e-2, 0.01745)])
def test_rest_before_and_after_a_hand(rate, noise, step):
    t, w = handled(rate, noise, step)
    found = rest_stretches(clean_log(t, w))
    assert found[0][0] == 0.0 and 1.7 < found[0][1] < 2.0 and found[-1][1] > 5.8
    assert all(end < 2.0 or start > 5.0 for start, end in found)
    still = np.any([(t >= start) & (t <= end) for start, end in found], axis=0)
    assert np.abs(w[still].mean(axis=0) - BIAS).max() < 0.5 * step + 5 * noise / np.sqrt(still.sum())


def test_a_bias_of_a_cheap_gyro_needs_two_rests_or_a_weight():
    # 20 deg/s on each axis; a body that turns slowly and steadily in flight shows one such stretch
    t, w = handled(100, 4e-3, 0.0)
    large = w + np.array([0.33, -0.2, 0.25])
    assert rest_stretches(clean_log(t, large))[0][0] == 0.0
    once = t < 4.9
    assert rest_stretches(clean_log(t[once], large[once])) == []
    down = np.broadcast_to([0.0, 0.0, 9.8], w.shape)
    assert len(rest_stretches(clean_log(t[once], large[once], t[once], down[once]))) == 1
    # turned steadily before and after, at rest between: what is near zero is the rest
    turned = np.where(((t >= 4) & (t < 5))[:, None], 0.01, large)
    assert all(4 <= start and end <= 5 for start, end in rest_stretches(clean_log(t, turned)))


def test_a_flight_a_hand_and_a_turn_are_no_rest():
    t, w = handled(100, 2e-3, 0.0)
    moved = (t > 2.2) & (t < 4.8)
    assert rest_stretches(clean_log(t[moved], w[moved])) == []
    steady = np.broadcast_to([0.0, 0.0, 2.0], w.shape) + 2e-3 * np.random.default_rng(2).normal(size=w.shape)
    assert rest_stretches(clean_log(t, steady)) == []


def test_what_is_turned_slowly_and_steadily_is_told_by_its_weight():
    t = np.arange(0.0, 6.0, 0.01)
    turned = np.broadcast_to([0.2, 0.0, 0.0], (len(t), 3))
    still = np.broadcast_to([0.0, 0.0, 9.8], turned.shape)
    felt = 9.8 * np.stack([0 * t, np.sin(0.2 * t), np.cos(0.2 * t)], axis=1)
    assert rest_stretches(clean_log(t, turned, t, felt)) == []
    assert rest_stretches(clean_log(t, turned, t, still)) == [(0.0, t[-1])]
