"""Inertia and a constant torque from telemetry: attitudes and rates made by integration of Euler's equations."""

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.spatial.transform import Rotation

from polhode import InvalidInput, measuring
from polhode.measuring.attitudes.report import AttitudeReport

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
    fit = measuring.fit_attitude(t, quaternions, rates if with_rates else None, "auto")
    assert fit.aicc["torque"] < fit.aicc["free"] - 1000
    assert (off(fit.ratios, MOMENTS[:2]) < 4).all()
    assert (off(fit.torque, AXES.apply(TORQUE)) < 4).all()
    assert (fit.ratios.standard_error < 1e-4).all()
    assert np.isclose(fit.sigma, 1e-4, rtol=0.2)
    assert (fit.rate_sigma is None) != with_rates
    free = measuring.fit_attitude(t, quaternions)  # the wrong model is noticed, and said
    assert free.rms > 100 * fit.rms
    assert free.misfit is not None and "Something else acts" in AttitudeReport("log", free, None).summary
    assert not AttitudeReport("log", fit, None).notes


@pytest.mark.long
def test_no_torque_is_seen_where_there_is_none():
    t, quaternions, rates = telemetry(2, torque=np.zeros(3))
    forced = measuring.fit_attitude(t, quaternions, rates, True)
    assert (off(forced.torque, np.zeros(3)) < 4).all()
    assert (off(forced.ratios, MOMENTS[:2]) < 4).all()
    chosen = measuring.fit_attitude(t, quaternions, rates, "auto")
    assert chosen.torque is None or (off(chosen.torque, np.zeros(3)) < 4).all()


@pytest.mark.sweep
def test_rates_make_the_errors_smaller():
    t, quaternions, rates = telemetry(3, noise=1e-3, rate_noise=1e-6)
    alone, both = (measuring.fit_attitude(t, quaternions, given, True) for given in (None, rates))
    assert (both.ratios.standard_error < 0.1 * alone.ratios.standard_error).all()
    assert (off(both.ratios, MOMENTS[:2]) < 4).all()


@pytest.mark.usefixtures("any_type")
@pytest.mark.parametrize(("change", "words"), [
    ({"torque": "perhaps"}, "torque must be"), ({"rates": np.ones((5, 3))}, "one for each time"),
])  # fmt: skip
def test_bad_input_is_refused(change, words):
    t, quaternions, rates = telemetry(1, count=20)
    with pytest.raises(InvalidInput, match=words):
        measuring.fit_attitude(t, quaternions, **{"rates": rates, **change})


@pytest.mark.sweep
@pytest.mark.parametrize("torque", [False, True])
def test_intervals_cover_the_truth(torque):
    runs, inside = 150, np.zeros(5)
    for seed in range(runs):
        rng = np.random.default_rng(1000 + seed)
        start = START + 0.1 * rng.normal(size=3)
        push = TORQUE * torque
        t, quaternions, rates = telemetry(seed, push, 1e-3, 1e-3, span=30.0, count=61, start=start)
        fit = measuring.fit_attitude(t, quaternions, rates, torque)
        for k, (low, high) in enumerate(fit.ratios.interval()):
            inside[k] += low <= MOMENTS[k] <= high
        if torque:
            true = AXES.apply(push)
            inside[2:] += [low <= x <= high for x, (low, high) in zip(true, fit.torque.interval(), strict=True)]
    share = inside[: 5 if torque else 2] / runs
    assert (share > 0.88).all(), share  # four standard deviations of 150 runs
    assert 0.92 < share.mean() < 0.98, share


def acted_on(seed, act, wheel=(0.0, 0.0, 0.0), span=120.0, count=240, noise=1e-4, bias=0.0, step=None):
    """Attitudes and rates of a body on which a torque act(t, q, w) acts and in which a wheel turns, by SciPy."""

    def field(t, y):
        q, w = y[:4] / np.linalg.norm(y[:4]), y[4:]
        dq = 0.5 * np.r_[-q[1:] @ w, q[0] * w + np.cross(q[1:], w)]
        return np.r_[dq, (np.cross(MOMENTS * w + np.asarray(wheel), w) + act(t, q, w)) / MOMENTS]

    rng = np.random.default_rng([46, seed])
    t = np.sort(rng.uniform(0.0, span, count)) if seed % 2 else np.linspace(0.0, span, count)
    y = solve_ivp(field, (0.0, span), [1.0, 0, 0, 0, *START], t_eval=t, method="DOP853", rtol=1e-11, atol=1e-12).y.T
    turns = Rotation.from_quat(y[:, :4], scalar_first=True) * AXES.inv()
    turns = turns * Rotation.from_rotvec(noise * rng.normal(size=(count, 3)))
    rates = y[:, 4:] @ AXES.as_matrix().T + 1e-4 * rng.normal(size=(count, 3)) + bias
    quaternions = turns.as_quat(scalar_first=True)
    return t, quaternions if step is None else np.round(quaternions / step) * step, rates


def pulled_down(t, q, w):
    """As the gravity gradient does on an orbit of 200 s, 3n² u × I u with u along the nadir."""
    n = 2 * np.pi / 200.0
    u = Rotation.from_quat(q, scalar_first=True).inv().apply([np.cos(n * t), np.sin(n * t), 0.0])
    return 3 * n * n * np.cross(u, MOMENTS * u)


def magnetic(t, q, w):
    """A dipole in a field that turns twice an orbit."""
    field = Rotation.from_quat(q, scalar_first=True).inv().apply([np.cos(0.06 * t), 0.3, np.sin(0.06 * t)])
    return 2e-3 * np.cross([1.0, 0.0, 1.0], field)


@pytest.mark.long
@pytest.mark.parametrize(("act", "wheel", "cause"), [
    (pulled_down, (0.0, 0.0, 0.0), None), (magnetic, (0.0, 0.0, 0.0), None),
    (lambda t, q, w: np.zeros(3), (0.02, 0.0, 0.05), "wheel"),
])  # fmt: skip
def test_what_acts_beside_the_inertia_leaves_no_errors(act, wheel, cause):
    """I1/I3 was 26 to 65 of its errors off, with exit code 0."""
    t, quaternions, rates = acted_on(2, act, np.array(wheel))
    fit = measuring.fit_attitude(t, quaternions, rates, "auto")
    assert fit.misfit is not None and fit.misfit.cause == cause
    assert fit.ratios is not None and np.isnan(fit.ratios.standard_error).all()
    assert np.isnan(fit.ratios.interval()).all()
    report = AttitudeReport("log", fit, None)
    assert not report.determined and report.summary.startswith("Something else acts on the body, or it is not free")
    assert "±" not in str(report.summary) + " ".join(line for group in report.answers for _, line in group.lines)
    values = report.as_json_dict()
    ratio = values["ratios"]["I1/I3"]
    assert ratio["standard_error"] is ratio["interval"] is values["axes_error"] is values["sigma"] is None
    assert values["misfit"]["cause"] == cause
    assert ("A wheel that turns in the body explains" in report.summary) == (cause == "wheel")


@pytest.mark.sweep
def test_honest_logs_keep_their_errors():
    """One false alarm in a hundred would be one in these with a probability of .64; none is at one in ten thousand."""
    alarms, inside = 0, []
    for seed in range(100):
        count = (14, 40, 200)[seed % 3]
        step = 1e-3 if seed % 5 == 0 else None
        rates = None if seed % 4 == 0 else 0.01
        t, quaternions, gyro = acted_on(seed, lambda t, q, w: np.zeros(3), count=count, span=0.4 * count, noise=1e-3,
                                        bias=0.0 if rates is None else rates, step=step)  # fmt: skip
        lengths = np.linalg.norm(quaternions, axis=1, keepdims=True)
        fit = measuring.fit_attitude(t, quaternions / lengths, None if rates is None else gyro)
        alarms += fit.misfit is not None
        if fit.ratios is not None:
            inside.append(off(fit.ratios, MOMENTS[:2]) < 3)
    assert alarms == 0 and len(inside) > 60 and np.mean(inside) > 0.97


def test_a_gyros_bias_is_no_misfit():
    """It was left out, which made the noise of rates as large as itself."""
    t, quaternions, rates = acted_on(4, lambda t, q, w: np.zeros(3), count=60, span=30.0, bias=0.01)
    fit = measuring.fit_attitude(t, quaternions, rates)
    assert fit.misfit is None and (off(fit.bias, AXES.apply(np.zeros(3)) + 0.01) < 4).all()
    assert np.isclose(fit.rate_sigma, 1e-4, rtol=0.3) and (off(fit.ratios, MOMENTS[:2]) < 4).all()


@pytest.mark.long
def test_no_torque_is_not_said_beside_one_that_the_criterion_prefers():
    """A steady spin about an axis, spun up along it: nothing is known of moments, and so of the torque over one."""
    t = np.linspace(0.0, 20.0, 60)
    angle = 1.0 * t + 0.5 * 0.02 * t**2
    turns = Rotation.from_rotvec(np.outer(angle, [0.0, 0.0, 1.0]))
    turns = turns * Rotation.from_rotvec(1e-3 * np.random.default_rng(1).normal(size=(60, 3)))
    fit = measuring.fit_attitude(t, turns.as_quat(scalar_first=True), None, "auto")
    assert fit.degenerate is not None and fit.aicc["torque"] < fit.aicc["free"] - 100
    [words] = [line for group in AttitudeReport("log", fit, None).answers for label, line in group.lines
               if label.startswith("N/I3")]  # fmt: skip
    assert words == "not determined"
