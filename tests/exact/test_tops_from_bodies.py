"""A Lagrange top made from a body, against the equations of motion about the pivot integrated along the given axes."""

import dataclasses
import math

import jax
import numpy as np
import pytest
from scipy.integrate import solve_ivp

import polhode as ph
from polhode import rotation
from polhode.bodies._pivot import PivotedBody
from polhode.errors import InvalidInput
from polhode.exact.lagrange_top._symmetry import third_axis_to_centre
from polhode.kinds.reading import read_spec
from polhode.motion.frame import BodyFrame
from polhode.spacecraft.formats.aem import write_aem
from polhode.spacecraft.formats.aem_reading import read_aem
from polhode.viewer.samples import take_samples
from sweeping import only

INTEGRATED = 1e-10
"""DOP853 at 1e-13 leaves up to 1e-11 over a second, some thirty radians, in which the slow top falls far over."""
SEEN = 1e-2
"""What a top with one of its numbers wrong differs by at least."""
SAME = 1e-11
"""A turned inertia matrix gives its moments back to 1e-15, and phases of thirty radians magnify that."""
TURNS = {
    "as given": np.eye(3),
    "permuted": np.array([[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]),
    "reversed": np.array([[0.0, 0.0, -1.0], [0.0, 1.0, 0.0], [1.0, 0.0, 0.0]]),
    "rotated": rotation.as_matrix(rotation.from_rotation_vector([0.4, -1.2, 0.9])),
}
# mass, (A, A, C) about the centre of mass, where that stands above the pivot along the axis, gravity
TOPS = {
    "prolate": (0.3, (2e-4, 2e-4, 1.2e-4), 0.04, 9.80665),
    "oblate": (0.3, (2e-4, 2e-4, 3.5e-4), 0.01, 9.80665),
    "below its pivot": (0.3, (2e-4, 2e-4, 3.5e-4), -0.03, 9.80665),
    "a ball there": (0.3, (2e-4, 2e-4, 3.2e-4), 0.02, 9.80665),  # 2e-4 + 0.3 · 0.02² = 3.2e-4
    "on the moon": (0.3, (2e-4, 2e-4, 1.2e-4), 0.04, 1.625),
}
VELOCITY = np.array([1.3, -0.7, 25.0])  # along the axes of the untwisted top
ATTITUDE = rotation.normalize([0.9, 0.3, -0.2, 0.1])
PIVOT = np.array([0.02, -0.05, 0.03])
TIMES = np.linspace(0.0, 1.0, 9)


def body_of(name, turn):
    """The body along axes in which its own are the columns of ``turn``, about ``PIVOT``."""
    mass, moments, height, _ = TOPS[name]
    return ph.Body(mass, PIVOT + height * turn[:, 2], turn @ np.diag(moments) @ turn.T)


def made(name, turn, **changed):
    given = {"angular_velocity": turn @ VELOCITY, "attitude": ATTITUDE, "gravity": TOPS[name][3]} | changed
    return ph.LagrangeMotion.from_body(body_of(name, turn), pivot=PIVOT, **given)


CASES = [f"{name}, {turn}" for name in TOPS for turn in TURNS]
# every top and every turn by default, all pairs in the sweep
CHOSEN = [case for case in CASES if case.startswith("prolate") or case.endswith("rotated")]


@pytest.fixture(params=only(CHOSEN, CASES))
def case(request):
    name, turn = request.param.split(", ")
    return name, TURNS[turn]


def integrated(name, turn):
    """Rotation matrices and momenta in space by d(RJRᵀω)/dt = R d × (−m g e_z), dR/dt = hat(ω) R, no principal axes."""
    mass, _, _, gravity = TOPS[name]
    body = body_of(name, turn)
    d = body.center_of_mass - PIVOT
    inertia = body.inertia + mass * (d @ d * np.eye(3) - np.outer(d, d))
    start = rotation.as_matrix(ATTITUDE)

    def field(_, y):
        R, L = y[:9].reshape(3, 3), y[9:]
        omega = R @ np.linalg.solve(inertia, R.T @ L)
        return [*np.cross(omega, R.T).T.ravel(), *np.cross(R @ d, (0.0, 0.0, -mass * gravity))]

    begin = [*start.ravel(), *(start @ inertia @ turn @ VELOCITY)]
    scale = [1e-14] * 9 + [1e-17] * 3
    found = solve_ivp(field, TIMES[[0, -1]], begin, "DOP853", TIMES, rtol=1e-13, atol=scale)
    return found.y[:9].T.reshape(-1, 3, 3), found.y[9:].T


def miss(motion, wanted):
    """The largest departure of attitude and of the momentum in space, relative to its size."""
    matrix = motion.rotation_matrix(TIMES)
    momentum = np.einsum("tij,tj->ti", matrix, motion.momentum(TIMES))
    return np.abs(matrix - wanted[0]).max(), np.abs(momentum - wanted[1]).max() / np.abs(wanted[1]).max()


@pytest.mark.long_after(3)
def test_it_moves_by_newton_and_euler(case):
    assert max(miss(made(*case), integrated(*case))) < INTEGRATED


@pytest.mark.parametrize("turn", ["permuted", "rotated"])
def test_a_wrong_top_would_be_seen(turn):
    """The comparison above fails for each mistake that making a top of a body can have."""
    turn = TURNS[turn]
    top, wanted = made("prolate", turn), integrated("prolate", turn)
    wrong = {
        "weight upward": dataclasses.replace(top, mgl=-top.mgl),
        "another gravity": made("prolate", turn, gravity=9.0),
        "moments about the centre of mass": dataclasses.replace(
            top, moments=np.array(TOPS["prolate"][1]), momentum_at_epoch=top.momentum_at_epoch
        ),
        "axes by rows": dataclasses.replace(top, axes=np.asarray(top.axes).T),
        "attitude of the principal axes": made(
            "prolate", turn, attitude=rotation.multiply(ATTITUDE, rotation.from_matrix(turn))
        ),
        "spin along the principal axes": made("prolate", turn, angular_velocity=VELOCITY),
        "axis reversed": dataclasses.replace(top, axes=np.asarray(top.axes) * [1.0, -1.0, -1.0]),
    }
    for name, motion in wrong.items():
        assert max(miss(motion, wanted)) > SEEN, name


def test_what_is_said_is_along_the_given_axes(case):
    name, turn = case
    motion, body = made(*case), body_of(*case)
    inertia = body.about(PIVOT)
    assert motion.attitude_at_epoch == pytest.approx(ATTITUDE, abs=1e-15)
    assert motion.attitude(0.0) == pytest.approx(ATTITUDE, abs=1e-15)
    size = np.abs(inertia @ turn @ VELOCITY).max()
    assert motion.momentum_at_epoch == pytest.approx(inertia @ turn @ VELOCITY, abs=1e-14 * size)
    assert motion.momentum(0.0) == pytest.approx(inertia @ turn @ VELOCITY, abs=1e-14 * size)
    assert motion.angular_velocity(0.0) == pytest.approx(turn @ VELOCITY, abs=1e-13)
    # the third axis points to the centre of mass; moments are those of the inertia about the pivot
    height = TOPS[name][2]
    assert motion.axes[:, 2] == pytest.approx(math.copysign(1.0, height) * turn[:, 2], abs=1e-13)
    assert motion.axes @ np.diag(motion.moments) @ motion.axes.T == pytest.approx(inertia, abs=1e-13 * inertia.max())
    assert motion.mgl == pytest.approx(0.3 * TOPS[name][3] * abs(height), rel=1e-14)
    same = made(name, turn, angular_velocity=None, momentum=inertia @ turn @ VELOCITY)
    assert same.momentum(TIMES) == pytest.approx(motion.momentum(TIMES), abs=SAME * size)


def test_answers_do_not_depend_on_the_axes(case):
    """But for a ball, whose principal axes are any, moments and momentum are what the textbook's top has."""
    name, turn = case
    mass, (A, _, C), height, gravity = TOPS[name]
    side = math.copysign(1.0, height)
    I1, mgl = A + mass * height**2, mass * gravity * abs(height)
    turned = np.diag([1.0, side, side])  # half a turn about the first axis
    attitude = rotation.multiply(ATTITUDE, rotation.from_matrix(turn @ turned))
    plain = ph.LagrangeMotion(
        (I1, I1, C), mgl=mgl, momentum=np.array([I1, I1, C]) * (turned @ VELOCITY), attitude=attitude
    )
    motion = made(name, turn)
    assert motion.regime == plain.regime
    for answer in ("energy", "vertical_momentum", "axial_momentum", "nutation_limits", "nutation_period",
                   "precession_per_period", "spin_per_period", "precession_rate", "spin_rate"):  # fmt: skip
        assert getattr(motion, answer) == pytest.approx(getattr(plain, answer), rel=1e-10), answer
    height_then = motion.rotation_matrix(TIMES)[:, 2] @ motion.axes[:, 2]
    assert height_then == pytest.approx(plain.rotation_matrix(TIMES)[:, 2, 2], abs=SAME)


def test_samples_and_files_know_the_axes(case, tmp_path):
    motion, body = made(*case), body_of(*case)
    principal, sampled = motion.along("principal"), motion.sample(TIMES)
    assert principal.axes is None and principal.along("principal") is principal
    assert principal.rotation_matrix(1.0) == pytest.approx(motion.rotation_matrix(1.0) @ motion.axes, abs=1e-14)
    assert max(np.max(drift) for drift in sampled.drift.values()) < 1e-14
    by_name = principal.sample(TIMES).invariants
    for name, values in sampled.invariants.items():
        assert values == pytest.approx(by_name[name], rel=1e-12)
    shown, wanted = take_samples(sampled), take_samples(principal.sample(TIMES))
    for name in ("attitude", "momentum", "angular_velocity"):
        assert getattr(shown, name) == pytest.approx(getattr(wanted, name), abs=1e-12)
    frame = BodyFrame(motion.moments, motion.axes, body.center_of_mass, body.mass, PIVOT)
    for trajectory, given in ((sampled, None), (sampled, frame), (principal.sample(TIMES), frame)):
        write_aem(dataclasses.replace(trajectory, frame=given), tmp_path / "top.aem")
        found = rotation.as_matrix(read_aem(tmp_path / "top.aem").attitude)
        assert found == pytest.approx(motion.rotation_matrix(TIMES), abs=1e-13)


def test_a_top_is_made_again_with_another_value():
    turn = TURNS["rotated"]
    top = made("prolate", turn)
    later = dataclasses.replace(top, epoch=2.5)
    assert later.momentum(TIMES + 2.5) == pytest.approx(top.momentum(TIMES), abs=1e-14)
    heavier, twice = dataclasses.replace(top, mgl=2.0 * top.mgl), made("prolate", turn, gravity=2.0 * 9.80665)
    assert np.abs(heavier.attitude(TIMES) - twice.attitude(TIMES)).max() < SAME
    assert np.abs(heavier.attitude(TIMES) - top.attitude(TIMES)).max() > SEEN
    other = dataclasses.replace(top, attitude_at_epoch=(1.0, 0.0, 0.0, 0.0))
    assert other.attitude(0.0) == pytest.approx((1.0, 0.0, 0.0, 0.0), abs=1e-15)
    assert other.momentum(0.0) == pytest.approx(top.momentum(0.0), abs=1e-16)


def test_many_spins_at_many_times():
    turn = TURNS["rotated"]
    velocities = np.stack([turn @ VELOCITY, [3.0, 1.0, -9.0], [0.0, 0.0, 5.0]])
    tops = made("oblate", turn, angular_velocity=velocities)
    attitude, momentum = made("oblate", turn, angular_velocity=velocities[:, None]).state(TIMES)
    assert tops.batch_shape == (3,) and attitude.shape == (3, len(TIMES), 4)
    for k, velocity in enumerate(velocities):
        alone = made("oblate", turn, angular_velocity=velocity).state(TIMES)
        assert np.abs(attitude[k] - alone[0]).max() < 1e-14 and np.abs(momentum[k] - alone[1]).max() < 1e-16
    assert tops.sample(TIMES).momentum == pytest.approx(momentum, abs=1e-16)


def test_a_traced_spin_makes_a_traced_top():
    with jax.enable_x64(True):
        found = jax.eval_shape(lambda x: made("oblate", TURNS["rotated"], angular_velocity=x).state(1.0), VELOCITY)
    assert [part.shape for part in found] == [(4,), (3,)]


@pytest.mark.long
def test_it_is_what_the_report_says(tmp_path):
    spec = tmp_path / "top.toml"
    spec.write_text("""
[system]
kind = "lagrange-top"
pivot = ["1 cm", "9 cm", "0 m"]
gravity = "9.7 m/s^2"
[body]
parts = [{shape = "cone", mass = "60 g", radius = "3 cm", height = "4 cm", axis = "-y", at = ["1 cm", "2 cm", "0 m"]}]
[spin]
angular_velocity = ["1 rad/s", "30 rad/s", "-2 rad/s"]
attitude = [0.8, 0.0, 0.6, 0.0]
""")
    read = read_spec(spec)
    report = read.report()
    top = ph.LagrangeMotion.from_body(
        read.body,
        pivot=(0.01, 0.09, 0.0),
        angular_velocity=(1.0, 30.0, -2.0),
        attitude=(0.8, 0.0, 0.6, 0.0),
        gravity=9.7,
    )
    values = report.as_json_dict()
    assert values["mgl"] == pytest.approx(0.06 * 9.7 * 0.07, rel=1e-14)
    for name in ("energy", "nutation_period", "precession_per_period", "spin_per_period", "nutation_limits", "regime"):
        assert values[name] == (pytest.approx(getattr(top, name), rel=1e-13) if name != "regime" else top.regime)
    times = report.trajectory.times
    turned = top.rotation_matrix(times) @ values["principal_axes"]
    assert turned == pytest.approx(rotation.as_matrix(report.trajectory.attitude), abs=1e-11)


CONE = ph.shapes.cone(0.1, 0.03, 0.05)


def _top(body, pivot, angular_velocity=None, momentum=None, **given):
    return ph.LagrangeMotion.from_body(
        body, pivot=pivot, angular_velocity=angular_velocity, momentum=momentum, **given
    )


REFUSED = {
    "no body": (lambda: _top(3, PIVOT, VELOCITY), "`body` must be a Body; got 3"),
    "no mass": (lambda: _top(ph.Body.from_moments((2, 2, 3)), PIVOT, VELOCITY), "give `mass`"),
    "no spin": (lambda: _top(CONE, (0, 0, 0.04)), "exactly one of `angular_velocity` and"),
    "two spins": (lambda: _top(CONE, (0, 0, 0.04), VELOCITY, VELOCITY), "exactly one of"),
    "three moments": (lambda: _top(ph.shapes.box(1, (1, 2, 3)), (0, 0, 1), VELOCITY),
                      r"must be a Lagrange top, .* HeavyTop\.from_body with simulate"),
    "pivot beside the axis": (lambda: _top(CONE, (1e-7, 0, 0.04), VELOCITY),
                              "not symmetric about the line from pivot to centre of mass"),
    "three moments, free": (lambda: _top(ph.shapes.box(1, (1, 2, 3)), (0, 0, 0), VELOCITY),
                            r"its moments at the pivot are \(.*\) kg m²\. Check"),
    "no gravity": (lambda: _top(CONE, (0, 0, 0.04), VELOCITY, gravity=0.0),
                   r"`gravity` must be positive and finite \[m/s²\]; got 0"),
    "pivot of two": (lambda: _top(CONE, (0, 0), VELOCITY), r"`point` must be three finite numbers; got shape \(2,\)"),
    "a thin rod": (lambda: _top(ph.shapes.rod(1, 1).placed(translation=(0, 0, 0.5)), (0, 0, 0),
                                                       VELOCITY), "`moments` must be positive"),
    "attitude of three": (lambda: _top(CONE, (0, 0, 0.04), VELOCITY, attitude=(1, 0, 0)),
                          r"`attitude` must have shape \(\.\.\., 4\)"),
}  # fmt: skip


@pytest.mark.parametrize("name", REFUSED)
@pytest.mark.filterwarnings("ignore:the fixed point is the centre")
@pytest.mark.usefixtures("any_type")
def test_bodies_that_are_not_lagrange_tops_are_refused(name):
    make, words = REFUSED[name]
    with pytest.raises(InvalidInput, match=words):
        make()


def test_a_pivot_at_the_centre_of_mass_leaves_the_free_body():
    turn = TURNS["rotated"]
    body = ph.Body(0.3, PIVOT, turn @ np.diag([2e-4, 2e-4, 3.5e-4]) @ turn.T)
    with pytest.warns(UserWarning, match="the body is free") as caught:
        top = ph.LagrangeMotion.from_body(body, pivot=PIVOT, angular_velocity=VELOCITY, attitude=ATTITUDE)
    assert len(caught) == 1 and top.mgl == 0.0 and top.regime == "free"
    free = ph.FreeMotion.from_body(body, angular_velocity=VELOCITY, attitude=ATTITUDE)
    assert top.rotation_matrix(TIMES) == pytest.approx(free.rotation_matrix(TIMES), abs=1e-12)
    # an axis of symmetry whose other moments a turned body has equal but for rounding
    nearly = PivotedBody(np.array([0.3, 0.7, np.nextafter(0.7, 1.0)]), np.eye(3), np.zeros(3), 0.0)
    assert third_axis_to_centre(nearly)[0].tolist() == [0.7, 0.7, 0.3]
