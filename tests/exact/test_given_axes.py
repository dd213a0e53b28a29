"""A motion made from a body speaks of the body's given axes; how these lie in the body changes no physical answer."""

import math
from dataclasses import replace

import numpy as np
import pytest

import polhode as ph
from polhode import rotation
from polhode.analysis.poinsot import herpolhode, herpolhode_curve
from polhode.analysis.polhodes import polhode
from polhode.analysis.precession import body_precession, space_precession
from polhode.analysis.twist import racket_twist
from polhode.spacecraft.formats.aem import write_aem
from polhode.spacecraft.formats.aem_reading import read_aem
from polhode.viewer.samples import take_samples

MOMENTS = np.array([0.00121, 0.01638, 0.01748])
VELOCITY = np.array([0.1, 1.0, 0.0])
TWIST = 166.27
"""[deg], of the racket thrown at 0.1 of the spin about its handle (Ashbaugh, Chicone & Cushman 1991)."""
SAME = 1e-9
"""A turned inertia matrix gives its principal moments back to 1e-15 of the largest, 1e-14 of the handle's own, and this
throw passes the unstable axis, where e^{λt} of some thousand magnifies that."""
ROUNDING = 1e-16
"""[kg m²/s], some ulp of the momentum, 0.016, that two turns leave."""
TURNS = {
    "permuted": np.array([[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]),
    "reversed": np.array([[0.0, 0.0, -1.0], [0.0, 1.0, 0.0], [1.0, 0.0, 0.0]]),
    "rotated": rotation.as_matrix(rotation.from_rotation_vector([0.4, -1.2, 0.9])),
}
TIMES = 0.25 * np.arange(40)


@pytest.fixture(params=TURNS)
def thrown(request):
    """The principal axes by columns in the given ones, the body, and its motion."""
    turn = TURNS[request.param]
    body = ph.Body(1.0, (0.0, 0.0, 0.0), turn @ np.diag(MOMENTS) @ turn.T)
    return turn, body, ph.FreeMotion.from_body(body, angular_velocity=turn @ VELOCITY)


@pytest.fixture(scope="module")
def plain():
    return ph.FreeMotion(MOMENTS, momentum=MOMENTS * VELOCITY)


def test_what_is_said_at_the_epoch_is_what_is_said_of_that_time(thrown):
    turn, _, motion = thrown
    attitude, momentum = motion.state(0.0)
    assert motion.momentum_at_epoch == pytest.approx(turn @ (MOMENTS * VELOCITY), abs=ROUNDING)
    assert motion.momentum_at_epoch == pytest.approx(momentum, abs=ROUNDING)
    assert motion.attitude_at_epoch == pytest.approx((1.0, 0.0, 0.0, 0.0), abs=1e-15)
    assert motion.attitude_at_epoch == pytest.approx(attitude, abs=1e-15)
    principal = motion.along("principal")
    assert principal.axes is None and principal.along("principal") is principal
    assert np.abs(principal.momentum_at_epoch) == pytest.approx(np.abs(MOMENTS * VELOCITY), abs=ROUNDING)
    assert motion.axes @ principal.momentum(3.0) == pytest.approx(motion.momentum(3.0), abs=1e-16)
    assert principal.rotation_matrix(3.0) == pytest.approx(motion.rotation_matrix(3.0) @ motion.axes, abs=1e-15)


def test_scalar_answers(thrown, plain):
    motion = thrown[2]
    assert (motion.regime, motion.encircled_axis) == (plain.regime, plain.encircled_axis)
    names = ("energy", "momentum_norm", "modulus", "period", "flip_interval", "precession_rate", "solid_angle",
             "precession_per_period", "geometric_phase", "action", "tumbling_periods", "long_axis_period")  # fmt: skip
    for name in names:
        assert getattr(motion, name) == pytest.approx(getattr(plain, name), rel=SAME)


@pytest.mark.parametrize("handle", [0, 1, 2])
def test_racket_twist(thrown, plain, handle):
    assert racket_twist(thrown[2], handle) == pytest.approx(racket_twist(plain, handle), abs=SAME)
    if handle == 0:
        assert math.degrees(racket_twist(thrown[2])) == pytest.approx(TWIST, abs=0.005)


def test_poinsot_and_precession(thrown, plain):
    turn, _, motion = thrown
    assert herpolhode(motion) == pytest.approx(herpolhode(plain), rel=SAME, abs=SAME)
    for precession in (body_precession, space_precession):
        assert precession(motion).rate == pytest.approx(precession(plain).rate, rel=SAME)
        assert precession(motion).sense == precession(plain).sense
    # the plane's first direction is chosen in space, where given axes begin turned against the principal ones
    radius = np.linalg.norm(herpolhode_curve(motion, TIMES), axis=-1)
    assert radius == pytest.approx(np.linalg.norm(herpolhode_curve(plain, TIMES), axis=-1), rel=1e-7)
    assert polhode(motion, 50)[0] == pytest.approx(turn @ polhode(plain, 50)[0], abs=SAME)


def test_samples_and_pages(thrown):
    _, _, motion = thrown
    principal = motion.along("principal")
    sampled = motion.sample(TIMES)
    assert max(np.max(drift) for drift in sampled.drift.values()) < 1e-14
    for times in (TIMES, TIMES[:1]):
        shown, wanted = take_samples(motion.sample(times)), take_samples(principal.sample(times))
        for name in ("attitude", "momentum", "angular_velocity", "states"):
            assert getattr(shown, name) == pytest.approx(getattr(wanted, name), abs=1e-14)


def test_files(thrown, tmp_path):
    _, body, motion = thrown
    frame, sampled = body.frame, motion.sample(TIMES)
    principal = motion.along("principal").sample(TIMES)
    for trajectory, given in ((sampled, None), (sampled, frame), (principal, frame)):
        write_aem(replace(trajectory, frame=given), tmp_path / "thrown.aem")
        found = rotation.as_matrix(read_aem(tmp_path / "thrown.aem").attitude)
        assert found == pytest.approx(rotation.as_matrix(sampled.attitude), abs=1e-14)
    dataset = ph.as_dataset(replace(sampled, frame=frame))
    for name in ("attitude", "momentum", "angular_velocity"):
        assert dataset[name].values == pytest.approx(getattr(principal, name), abs=1e-14)
