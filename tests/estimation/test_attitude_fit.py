"""Inertia and a constant torque from telemetry: attitudes and rates made by integration of Euler's equations."""

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.spatial.transform import Rotation

from polhode import InvalidInput, estimation
from polhode.studies.attitude_report import AttitudeReport

MOMENTS = np.array([0.5, 0.8, 1.0])
AXES = Rotation.random(rng=4)
TORQUE = np.array([2e-3, -1e-3, 3e-3])  # over I3, principal axes
START = np.array([0.3, 0.5, -0.2])


def telemetry(seed, torque=TORQUE, noise=1e-4, rate_noise=1e-4, span=60.0, count=241, start=START):
    def field(t, y):
        q, w = y[:4], y[4:]
        dq = 0.5 * np.r_[-q[1:] @ w, q[0] * w + np.cross(q[1:], w)]
        return np.r_[dq, (np.cross(MOMENTS * w, w) + torque) / MOMENTS]

    t = np.linspace(0.0, span, count)
    y = solve_ivp(field, (0.0, span), [1.0, 0, 0, 0, *start], t_eval=t, method="DOP853", rtol=1e-11, atol=1e-12).y.T
    rng = np.random.default_rng(seed)
    turns = Rotation.from_quat(y[:, :4], scalar_first=True) * AXES.inv()
    turns = Rotation.random(rng=9) * turns * Rotation.from_rotvec(noise * rng.normal(size=(count, 3)))
    rates = y[:, 4:] @ AXES.as_matrix().T + rate_noise * rng.normal(size=(count, 3))
    return t + 100.0, turns.as_quat(scalar_first=True), rates


def off(estimate, true):
    return np.abs(estimate.value - true) / estimate.standard_error


@pytest.mark.sweep
@pytest.mark.parametrize("with_rates", [False, True])
def test_a_torque_and_the_inertia(with_rates):
    t, quaternions, rates = telemetry(1)
    fit = estimation.fit_attitude(t, quaternions, rates if with_rates else None, "auto")
    assert fit.aicc["torque"] < fit.aicc["free"] - 1000
    assert (off(fit.ratios, MOMENTS[:2]) < 4).all()
    assert (off(fit.torque, AXES.apply(TORQUE)) < 4).all()
    assert (fit.ratios.standard_error < 1e-4).all()
    assert np.isclose(fit.sigma, 1e-4, rtol=0.2)
    assert (fit.rate_sigma is None) != with_rates
    free = estimation.fit_attitude(t, quaternions)  # the wrong model is noticed, and said
    assert free.rms > 100 * fit.rms
    assert "does not explain" in AttitudeReport("log", free, None).notes[0]
    assert not AttitudeReport("log", fit, None).notes


@pytest.mark.long
def test_no_torque_is_seen_where_there_is_none():
    t, quaternions, rates = telemetry(2, torque=np.zeros(3))
    forced = estimation.fit_attitude(t, quaternions, rates, True)
    assert (off(forced.torque, np.zeros(3)) < 4).all()
    assert (off(forced.ratios, MOMENTS[:2]) < 4).all()
    chosen = estimation.fit_attitude(t, quaternions, rates, "auto")
    assert chosen.torque is None or (off(chosen.torque, np.zeros(3)) < 4).all()


@pytest.mark.sweep
def test_rates_make_the_errors_smaller():
    t, quaternions, rates = telemetry(3, noise=1e-3, rate_noise=1e-6)
    alone, both = (estimation.fit_attitude(t, quaternions, given, True) for given in (None, rates))
    assert (both.ratios.standard_error < 0.1 * alone.ratios.standard_error).all()
    assert (off(both.ratios, MOMENTS[:2]) < 4).all()


@pytest.mark.usefixtures("any_type")
@pytest.mark.parametrize(("change", "words"), [
    ({"torque": "perhaps"}, "torque must be"), ({"rates": np.ones((5, 3))}, "one for each time"),
])  # fmt: skip
def test_bad_input_is_refused(change, words):
    t, quaternions, rates = telemetry(1, count=20)
    with pytest.raises(InvalidInput, match=words):
        estimation.fit_attitude(t, quaternions, **{"rates": rates, **change})


@pytest.mark.sweep
@pytest.mark.parametrize("torque", [False, True])
def test_intervals_cover_the_truth(torque):
    runs, inside = 150, np.zeros(5)
    for seed in range(runs):
        rng = np.random.default_rng(1000 + seed)
        start = START + 0.1 * rng.normal(size=3)
        push = TORQUE * torque
        t, quaternions, rates = telemetry(seed, push, 1e-3, 1e-3, span=30.0, count=61, start=start)
        fit = estimation.fit_attitude(t, quaternions, rates, torque)
        for k, (low, high) in enumerate(fit.ratios.interval()):
            inside[k] += low <= MOMENTS[k] <= high
        if torque:
            true = AXES.apply(push)
            inside[2:] += [low <= x <= high for x, (low, high) in zip(true, fit.torque.interval(), strict=True)]
    share = inside[: 5 if torque else 2] / runs
    assert (share > 0.88).all(), share  # four standard deviations of 150 runs
    assert 0.92 < share.mean() < 0.98, share
