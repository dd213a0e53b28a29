"""FreeMotion's numbers: published values, quadrature, differences; frames, batches and refusals."""

import numpy as np
import pytest
from scipy.integrate import quad, solve_ivp

import polhode as ph
from polhode.errors import InvalidInput
from polhode.exact.free_body._geometry import REGIMES
from starts import free_motion

MOMENTS = (1.0, 2.0, 3.0)
SAM, LAM = (0.3, 0.9, 0.5), (0.9, 0.8, 0.1)
DIGITS = 3e-14
"""The published table's fifteen digits, with a period's rounding."""


def spun(velocity, moments=MOMENTS):
    return ph.FreeMotion(moments, momentum=np.array(moments) * velocity)


@pytest.mark.parametrize(
    ("velocity", "period"),
    [
        (SAM, 10.68012008138356204829621),
        (LAM, 10.48993138150295622095543),
        ((0.01, 1.0, 0.01), 39.10573419726872085421824),
        ((1e-6, 1.0, 1e-6), 102.920061678615156180838),
    ],
)
def test_published_periods(velocity, period):
    assert spun(velocity).period == pytest.approx(period, rel=1e-14)


def test_published_table():
    short, long = spun(SAM), spun(LAM)
    assert (short.regime, long.regime) == ("short-axis", "long-axis")
    assert short.precession_rate == pytest.approx(1.52169483193313, rel=DIGITS)
    assert long.precession_rate == pytest.approx(0.797968677467726, rel=DIGITS)
    assert short.precession_per_period == pytest.approx(16.2518835322666, rel=DIGITS)
    assert long.precession_per_period == pytest.approx(8.37063667122511, rel=DIGITS)
    assert -short.geometric_phase == pytest.approx(1.15358994995955, rel=DIGITS)
    assert -long.geometric_phase == pytest.approx(-2.69824723632312, rel=DIGITS)
    assert short.action == pytest.approx(0.433699273789513, rel=DIGITS)
    assert long.action == pytest.approx(0.798803431684801, rel=DIGITS)
    assert short.tumbling_periods == pytest.approx((2 * np.pi / 1.52169483193313, 10.6801200813836), rel=DIGITS)
    assert long.tumbling_periods[0] == pytest.approx(7.87397486216959, rel=DIGITS)
    state = ph.FreeMotion((0.6, 0.8, 1.0), momentum=(1.8, 0.4, -0.9)).momentum(10.0)
    assert state == pytest.approx((1.765962508518208, -0.6954641970330868, 0.7795549814818724), abs=1e-15)


@pytest.mark.parametrize("velocity", [SAM, LAM, (0.01, 1.0, 0.02)])
def test_precession_per_period_by_quadrature(velocity):
    motion = spun(velocity)
    j, k = (i for i in range(3) if i != motion.encircled_axis)

    def rate(t):
        L = motion.momentum(t)
        a, b = L[j] ** 2, L[k] ** 2
        return motion.momentum_norm * (a / MOMENTS[j] + b / MOMENTS[k]) / (a + b)

    wanted = quad(rate, 0.0, motion.period, epsabs=1e-12, epsrel=1e-12, limit=400)[0]
    assert motion.precession_per_period == pytest.approx(wanted, rel=1e-11)


@pytest.mark.parametrize(("momentum", "sign"), [((0.3, 1.8, 1.5), 1.0), ((0.9, 1.6, 0.3), -1.0)])
def test_solid_angle_grows_with_energy_as_the_period_says(momentum, sign):
    momentum = np.array(momentum)
    step = 1e-5
    ends = []
    for side in (-1.0, 1.0):
        # along the meridian towards axis 1 the energy changes at fixed |L|
        turn = ph.rotation.from_rotation_vector([0.0, side * step, 0.0])
        motion = ph.FreeMotion(MOMENTS, momentum=ph.rotation.rotate(turn, momentum))
        ends.append((motion.energy, motion.solid_angle))
    slope = (ends[1][1] - ends[0][1]) / (ends[1][0] - ends[0][0])
    motion = ph.FreeMotion(MOMENTS, momentum=momentum)
    assert slope == pytest.approx(sign * motion.period / motion.momentum_norm, rel=1e-8)


@pytest.mark.parametrize("tilt", [1e-3, 1e-6, 1e-7, 1e-9, 1e-30])
def test_small_caps_keep_their_digits(tilt):
    motion = ph.FreeMotion(MOMENTS, momentum=(tilt, 0.0, 1.0))
    # an ellipse with half axes tilt and tilt √(C/B): C = 1/I1 − 1/I3, B = 1/I2 − 1/I3
    area = np.pi * tilt**2 * np.sqrt((1 - 1 / 3) / (1 / 2 - 1 / 3))
    assert motion.solid_angle == pytest.approx(area, rel=max(2 * tilt**2, 1e-13))


def test_regimes_one_by_one_and_in_a_batch():
    cases = {
        "rest": (MOMENTS, (0.0, 0.0, 0.0)),
        "spherical": ((2.0, 2.0, 2.0), (1.0, 2.0, 3.0)),
        "permanent": (MOMENTS, (0.0, 2.0, 0.0)),
        "symmetric": ((2.0, 1.0, 2.0), (1.0, 2.0, 3.0)),
        "short-axis": (MOMENTS, (0.1, 0.2, 3.0)),
        "long-axis": (MOMENTS, (3.0, 0.2, 0.1)),
        "separatrix": ((6.0, 3.0, 4.0), (1.0, 1.0, -5.0)),
    }
    assert tuple(cases) == REGIMES
    for name, (moments, momentum) in cases.items():
        motion = ph.FreeMotion(moments, momentum=momentum)
        assert motion.regime == name
        assert (motion.period is None) == (name in ("rest", "spherical", "permanent"))
        assert (motion.period == np.inf) == (name == "separatrix")
    batch = free_motion(*(np.array([case[k] for case in cases.values()]) for k in (0, 1)))
    assert batch.regime.tolist() == list(range(7))
    assert np.isnan(batch.period[:3]).all() and np.isinf(batch.period[6])
    assert batch.encircled_axis.tolist() == [-1, -1, -1, 1, 2, 0, -1]


def test_integration_agrees():
    moments, momentum = np.array(MOMENTS), np.array((0.3, 1.8, 1.5))

    def field(_, y):
        velocity = y[4:] / moments
        turn = 0.5 * ph.rotation.multiply(y[:4], np.concatenate([[0.0], velocity]))
        return np.concatenate([turn, np.cross(y[4:], velocity)])

    start = np.concatenate([[0.5, 0.5, -0.5, 0.5], momentum])
    run = solve_ivp(field, (2.0, 12.0), start, method="DOP853", rtol=1e-13, atol=1e-14)
    attitude, later = ph.FreeMotion(moments, momentum=momentum, attitude=start[:4], epoch=2.0).state(12.0)
    assert attitude == pytest.approx(run.y[:4, -1], abs=1e-11)
    assert later == pytest.approx(run.y[4:, -1], abs=1e-11)


def test_given_axes_in_and_out():
    body = ph.shapes.box(2.0, (1.0, 2.0, 3.0)).placed(ph.rotation.from_rotation_vector([0.4, -0.2, 0.9]))
    velocity, attitude = np.array([0.3, -0.5, 0.2]), ph.rotation.from_rotation_vector([1.0, 0.2, -0.4])
    motion = ph.FreeMotion.from_body(body, angular_velocity=velocity, attitude=attitude)
    assert motion.attitude(0.0) == pytest.approx(attitude, abs=1e-15)
    assert motion.angular_velocity(0.0) == pytest.approx(velocity, abs=1e-15)
    assert motion.momentum(0.0) == pytest.approx(body.inertia @ velocity, abs=1e-15)
    # L in space stays, and dR/dt = R hat(Ω)
    assert ph.rotation.rotate(*motion.state(50.0)) == pytest.approx(ph.rotation.rotate(*motion.state(0.0)), abs=1e-14)
    step = 1e-5
    rate = (motion.rotation_matrix(7.0 + step) - motion.rotation_matrix(7.0 - step)) / (2 * step)
    wanted = motion.rotation_matrix(7.0) @ ph.rotation.hat(motion.angular_velocity(7.0))
    assert rate == pytest.approx(wanted, abs=1e-9)
    same = ph.FreeMotion.from_body(body, momentum=body.inertia @ velocity, attitude=attitude)
    assert same.attitude(9.0) == pytest.approx(motion.attitude(9.0), abs=1e-14)


def test_broadcasting():
    momenta = np.random.default_rng(1).normal(size=(5, 3))
    times = np.linspace(-3.0, 9.0, 4)
    every = ph.FreeMotion(MOMENTS, momentum=momenta[:, None, :]).state(times)
    assert every[0].shape == (5, 4, 4) and every[1].shape == (5, 4, 3)
    own = ph.FreeMotion(MOMENTS, momentum=momenta).state(np.arange(5.0))
    long = ph.FreeMotion(MOMENTS, momentum=momenta[:, None, :]).state(np.linspace(-3.0, 9.0, 1000))
    for k in range(5):
        alone = ph.FreeMotion(MOMENTS, momentum=momenta[k])
        assert every[0][k] == pytest.approx(alone.attitude(times), abs=1e-15)
        assert own[1][k] == pytest.approx(alone.momentum(float(k)), abs=1e-15)
        assert long[0][k, -1] == pytest.approx(alone.attitude(9.0), abs=1e-15)
    sampled = ph.FreeMotion(MOMENTS, momentum=momenta).sample(times)
    assert sampled.states.shape == (5, 4, 7) and sampled.drift["energy"].shape == (5,)
    assert max(d.max() for d in sampled.drift.values()) < 16 * 2.0**-52


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (((0.0, 1.0, 1.0), (1, 0, 0)), "positive and finite"),
        (((-1.0, 1.0, 1.0), (1, 0, 0)), "-1"),
        (((np.nan, 1.0, 1.0), (1, 0, 0)), "positive and finite"),
        ((MOMENTS, (np.inf, 0, 0)), "`momentum` must be finite"),
        ((MOMENTS, (1.0, 0.0)), "shape"),
        ((MOMENTS, (1, 0, 0), (1.0, 1.0, 0, 0)), "unit quaternion"),
        ((MOMENTS, (1, 0, 0), (1, 0, 0, 0), np.nan), "`epoch`"),
        ((MOMENTS, np.ones(3, dtype=np.float32)), "float64"),
        ((MOMENTS, ("a", "b", "c")), "numbers"),
    ],
)
def test_bad_input(arguments, words):
    with pytest.raises(InvalidInput, match=words):
        free_motion(*arguments)


def test_bad_times_and_spins():
    with pytest.raises(InvalidInput, match="finite"):
        ph.FreeMotion(MOMENTS, momentum=(1.0, 2.0, 3.0)).state([1.0, np.inf])
    with pytest.raises(InvalidInput, match="exactly one"):
        ph.FreeMotion.from_body(ph.shapes.box(1.0, (1, 2, 3)))
    with pytest.raises(InvalidInput, match="one-dimensional"):
        ph.FreeMotion(MOMENTS, momentum=(1.0, 2.0, 3.0)).sample(1.0)


@pytest.mark.long_cases("<lambda>-at most 1e.27 rad")
@pytest.mark.parametrize(
    ("make", "words"),
    [
        (lambda: ph.FreeMotion(np.ones((2, 3)), momentum=np.ones((3, 3))), "must broadcast"),
        (
            lambda: ph.FreeMotion((1.0, 2.0, 3.0), momentum=np.ones((3, 3))).state(np.zeros(2)),
            r"broadcast.*\(N, 1, 3\)",
        ),
        (lambda: ph.FreeMotion((1.0, 2.0, 3.0), momentum=(1.0, 2.0, 3.0)).state(1.7e308), "at most 1e.27 rad"),
        (lambda: ph.FreeMotion((1.0, 2.0, 3.0), momentum=(10**400, 0, 0)), "at most 1.8e.308, as a double is"),
        (lambda: ph.FreeMotion((1.0, 2.0, 3.0), momentum=(1.0, 2.0, 3.0)).sample([]), "not empty"),
        (
            lambda: ph.FreeMotion.from_body(ph.shapes.sphere(1.0, 1.0), angular_velocity=(1, 0)),
            "`angular_velocity` must have shape",
        ),
        (lambda: ph.FreeMotion.from_body(3, angular_velocity=(1, 0, 0)), "must be a Body"),
    ],
)
def test_what_does_not_fit_together(make, words, any_type):
    with pytest.raises(InvalidInput, match=words):
        make()


def test_a_batch_of_none():
    attitude, momentum = ph.FreeMotion((1.0, 2.0, 3.0), momentum=np.zeros((0, 3))).state(1.0)
    assert attitude.shape == (0, 4) and momentum.shape == (0, 3)
