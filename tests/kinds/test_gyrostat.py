"""Reports on gyrostats: against equations of motion written again, equilibria as roots of a polynomial, bad specs."""

import functools
import json

import mpmath
import numpy as np
import pytest
from scipy.integrate import solve_ivp

import polhode as ph
from polhode.analysis import mean_winding_rate, steady_rotations
from polhode.analysis._steady_points import steady_points
from polhode.cli.main import main
from polhode.errors import InvalidInput
from polhode.kinds.reading import read_spec
from polhode.systems import DoubleBracket
from polhode.systems.gyrostat import Gyrostat

MOTION = 2e-9
"""Relative: two methods of steps, each with its own error over some turns."""
ROOTS = 1e-8
"""Of unit vectors: a polynomial of degree six against Newton's method."""
INERTIA = np.array([[2.0, 0.3, -0.1], [0.3, 2.5, 0.2], [-0.1, 0.2, 3.0]])
TILTED = f"inertia = {json.dumps([[f'{x} kg*m^2' for x in row] for row in INERTIA.tolist()])}"
AXIS = np.array([1.0, 2.0, -1.0]) / np.sqrt(6.0)
START = np.array([0.3, -0.2, 0.5])
SPIN = 'angular_velocity = ["0.3 rad/s", "-0.2 rad/s", "0.5 rad/s"]\nattitude = [0.8, 0.0, 0.6, 0.0]'
ROTOR = 'rotor_axis = [1, 2, -1]\nrotor_moment = "0.4 kg*m^2"\nrotor_rate = "3 rad/s"'
SYMMETRIC = 'moments = ["2 kg*m^2", "2 kg*m^2", "3 kg*m^2"]'
ALONG_3 = 'rotor_axis = [0, 0, 1]\nrotor_moment = "0.5 kg*m^2"\nrotor_rate = "1.4 rad/s"'


@pytest.fixture
def spec(tmp_path):
    def write(body, system, spin="", time='until = "12 s"\nsamples = 49'):
        path = tmp_path / "spec.toml"
        text = f'[body]\n{body}\n[system]\nkind = "gyrostat"\n{system}\n[spin]\n{spin}\n[time]\n{time}\n'
        path.write_text(text, "utf-8")
        return path

    return write


FOUND = {}


def report_on(path):
    """The report on a spec; the same text twice is computed once."""
    text = path.read_text("utf-8")
    if text not in FOUND:
        FOUND[text] = read_spec(path).report()
    return FOUND[text]


def equations(moment, torque):
    """Euler's equations of body and rotor, along the given axes: with ω the rotor's rate against the body,
    d/dt (IΩ + Jωa) + Ω × (IΩ + Jωa) = 0, and ω̇ = 0 or J (ω̇ + a·Ω̇) = u."""

    def rates(t, y):
        velocity, rate = y[:3], y[3]
        matrix = np.zeros((4, 4))
        matrix[:3, :3], matrix[:3, 3] = INERTIA, moment * AXIS
        turning = -np.cross(velocity, INERTIA @ velocity + moment * rate * AXIS)
        matrix[3, 3] = 1.0
        if torque is None:
            return np.linalg.solve(matrix, np.append(turning, 0.0))
        matrix[3, :3], matrix[3, 3] = moment * AXIS, moment
        return np.linalg.solve(matrix, np.append(turning, torque))

    return rates


@pytest.mark.sweep
@pytest.mark.parametrize(
    ("drive", "torque"),
    [('motor_torque = "0.05 N*m"', 0.05), ('rotor_drive = "constant-rate"', None), ('rotor_drive = "free"', 0.0)],
)
def test_motion_is_that_of_body_and_rotor_in_the_given_axes(spec, drive, torque):
    report = report_on(spec(TILTED, f"{ROTOR}\n{drive}", SPIN))
    times = np.asarray(report.trajectory.times)
    wanted = solve_ivp(equations(0.4, torque), (0.0, 12.0), np.append(START, 3.0), "DOP853", times,
                       rtol=1e-12, atol=1e-12).y  # fmt: skip
    velocity = np.asarray(report.trajectory.angular_velocity) @ report.axes.T
    assert np.abs(velocity - wanted[:3].T).max() < MOTION
    assert np.abs(report.rotor_rate - wanted[3]).max() < 10 * MOTION
    values = report.as_json_dict()
    assert values["rotor"]["drive"] == ("constant-rate" if torque is None else "free")
    # the momentum in space, from the given attitude and axes
    total = INERTIA @ START + 0.4 * 3.0 * AXIS
    turn = ph.rotation.as_matrix(np.array([0.8, 0.0, 0.6, 0.0]))
    in_space = ph.rotation.rotate(report.trajectory.attitude, report.trajectory.momentum)
    assert np.abs(in_space - turn @ total).max() < MOTION
    assert max(report.trajectory.drift.values()) < MOTION


@pytest.mark.sweep
def test_the_motors_work_is_what_body_and_rotor_gained(spec):
    report = report_on(spec(TILTED, f'{ROTOR}\nmotor_torque = "0.05 N*m"', SPIN))
    gained = []
    for k in (0, -1):
        velocity, rate = report.axes @ report.trajectory.angular_velocity[k], report.rotor_rate[k]
        gained.append(0.5 * velocity @ INERTIA @ velocity + 0.4 * rate * AXIS @ velocity + 0.2 * rate**2)
    assert report.motor_work == pytest.approx(gained[1] - gained[0], rel=1e-9)
    assert report.as_json_dict()["final"]["motor_work"] == report.motor_work
    assert report.as_json_dict()["final"]["rotor_momentum"] == pytest.approx(
        0.4 * (3.0 + AXIS @ START) + 0.05 * 12.0, rel=1e-10
    )


@pytest.mark.long
def test_momentum_in_a_spec_is_that_of_all(spec):
    total = INERTIA @ START + 0.4 * 3.0 * AXIS
    momentum = ", ".join(f'"{x!r} kg*m^2/s"' for x in total.tolist())
    report = read_spec(spec(TILTED, f'{ROTOR}\nrotor_drive = "free"', f"momentum = [{momentum}]")).report()
    assert report.axes @ report.trajectory.momentum[0] == pytest.approx(total, abs=1e-14)
    assert report.axes @ report.trajectory.angular_velocity[0] == pytest.approx(START, abs=1e-14)


@pytest.mark.long
def test_symmetric_carriers_nutate_at_the_rate_known_by_hand(spec):
    """I1 = I2: Π turns about axis 3 at ((I3 − I1) Ω3 + h)/I1 in the body, the axis about L at |L|/I1 in space."""
    turning = 'angular_velocity = ["0.2 rad/s", "0 rad/s", "0.4 rad/s"]'
    report = read_spec(spec(SYMMETRIC, ALONG_3, turning)).report()
    values = report.as_json_dict()
    assert values["nutation_rate"] == pytest.approx(((3 - 2) * 0.4 + 0.7) / 2, rel=1e-14)
    assert values["precession_rate"] == pytest.approx(np.hypot(0.4, 3 * 0.4 + 0.7) / 2, rel=1e-14)
    seen = report.trajectory.angular_velocity[:, 0]
    assert values["rotor"]["drive"] == "constant-rate"
    assert seen == pytest.approx(0.2 * np.cos(values["nutation_rate"] * report.trajectory.times), abs=MOTION)
    # a free rotor carries its share of the body's spin, and the carrier has the less
    free = read_spec(spec(SYMMETRIC, ALONG_3 + '\nrotor_drive = "free"', turning)).report().as_json_dict()
    assert free["moments"] == [2.0, 2.0, 2.5] and free["rotor"]["momentum"] == pytest.approx(0.5 * 1.8, rel=1e-14)
    assert free["nutation_rate"] == pytest.approx(((2.5 - 2) * 0.4 + 0.9) / 2, rel=1e-14)
    assert free["momentum_norm"] == pytest.approx(values["momentum_norm"], rel=1e-14)


@pytest.mark.long_after(1)
@pytest.mark.parametrize("gap", [0.0, 0.01, pytest.param(0.4, marks=pytest.mark.sweep)])
def test_every_steady_rotation_has_its_nutation_symmetric_or_not(gap):
    """Against the linearised equations on the tangent plane, by their eigenvalues, and by a motion close to each."""
    gyrostat = Gyrostat((2.0 - gap, 2.0, 3.0), (0.0, 0.0, 0.5))
    moments, rotor = np.asarray(gyrostat.moments), np.asarray(gyrostat.rotor)
    for found in steady_rotations(gyrostat, 2.0):
        point = 2.0 * found.along
        velocity = (point - rotor) / moments
        hat = lambda v: np.cross(np.eye(3), v).T  # noqa: E731
        rates = np.linalg.eigvals(hat(point) @ np.diag(1.0 / moments) - hat(velocity))
        turning = np.abs(rates.imag).max()
        if found.nutation is not None:
            assert found.nutation == pytest.approx(turning, rel=1e-9)
            start = point + 1e-4 * np.cross(found.along, [0.3, 0.5, 0.4])
            times = np.linspace(0.0, 20.0 * 2.0 * np.pi / turning, 1001)
            motion = ph.simulate(gyrostat, start * 2.0 / np.linalg.norm(start), times)
            mean = mean_winding_rate(times, motion.states, found.along)
            assert abs(mean) == pytest.approx(found.nutation, rel=2e-3)
        else:
            assert found.extremum == "saddle" or found.circle
            assert turning < 1e-7
    assert len(steady_rotations(gyrostat, 2.0)) == (3 if gap == 0.0 else 6)


@pytest.mark.long
def test_a_report_has_the_mean_rates_of_its_motion_where_two_moments_nearly_agree(spec):
    nearly = 'moments = ["1.99 kg*m^2", "2 kg*m^2", "3 kg*m^2"]'
    turning = 'angular_velocity = ["0.01 rad/s", "0 rad/s", "0.4 rad/s"]'
    values = read_spec(spec(nearly, ALONG_3, turning, 'until = "100 s"\nsamples = 2001')).report().as_json_dict()
    small = next(row["nutation"] for row in values["equilibria"] if row["along"][2] == 1.0)
    assert values["nutation_rate"] is None and values["mean_nutation_rate"] == pytest.approx(small, rel=1e-2)
    momentum = np.hypot(0.01 * 1.99, 3 * 0.4 + 0.7)
    assert values["mean_precession_rate"] == pytest.approx(momentum / 1.995, rel=1e-2)


def by_polynomial(moments, rotor, norm):
    """(Π − h)/I = λΠ gives Π_i = h_i/(1 − λ I_i), and |Π| = norm a polynomial of degree six for λ."""
    ways = [np.poly1d([-moment, 1.0]) ** 2 for moment in moments]
    terms = [ways[(k + 1) % 3] * ways[(k + 2) % 3] * float(h) ** 2 for k, h in enumerate(rotor)]
    roots = (sum(terms, np.poly1d([0.0])) - ways[0] * ways[1] * ways[2] * norm**2).roots
    real = roots[np.abs(roots.imag) < 1e-9 * np.abs(roots)].real
    return np.array([rotor / (1.0 - x * np.asarray(moments)) for x in real]) / norm


@pytest.mark.long
def test_steady_rotations_are_all_and_none_but_the_roots_of_a_polynomial():
    moments, counts = np.array([1.0, 2.0, 2.6]), set()
    for rotor in ([0.05, 0.1, 0.08], [0.3, 0.2, 0.1], [0.9, -0.8, 1.5]):
        found = steady_rotations(Gyrostat(moments, rotor), 1.5)
        wanted = by_polynomial(moments, np.array(rotor), 1.5)
        counts.add(len(found))
        assert len(found) == len(wanted)
        for equilibrium in found:
            assert np.linalg.norm(wanted - equilibrium.along, axis=1).min() < ROOTS
            velocity = (1.5 * equilibrium.along - rotor) / moments
            assert velocity == pytest.approx(equilibrium.spin * equilibrium.along, abs=1e-8)
        kinds = [e.extremum for e in found]
        # Morse: a sphere has two more summits and pits than passes
        assert kinds.count("minimum") + kinds.count("maximum") - kinds.count("saddle") == 2
        assert all((e.verdict.verdict == "unstable") == (e.extremum == "saddle") for e in found)
    assert counts == {2, 4, 6}


@pytest.mark.parametrize("rotor", [(1e-12, 0.0, 0.3), (0.2, 1e-9, 1e-15), (1e-7, 1e-7, 1e-7), (0.9, -0.8, 1e-10)])
@pytest.mark.parametrize("moments", [(1.0, 2.0, 2.6), (2.0, 2.0 + 1e-7, 3.0)])
def test_no_steady_rotation_is_missed_however_small_a_part_of_the_rotor(moments, rotor):
    """Against the polynomial's roots by 80 digits; a part that is zero adds its own."""
    found = steady_points(np.array(moments), np.array(rotor), 1.5)
    with mpmath.workdps(80):
        parts = [(mpmath.mpf(i), mpmath.mpf(h)) for i, h in zip(moments, rotor, strict=True) if h]
        coefficients = [mpmath.mpf(0)]
        product = lambda ways: functools.reduce(np.polymul, ways, np.array([mpmath.mpf(1)]))  # noqa: E731
        ways = [np.polymul([-i, mpmath.mpf(1)], [-i, mpmath.mpf(1)]) for i, _ in parts]
        for k, (_, h) in enumerate(parts):
            coefficients = np.polyadd(coefficients, h**2 * product(ways[:k] + ways[k + 1 :]))
        coefficients = np.polysub(coefficients, mpmath.mpf(1.5) ** 2 * product(ways))
        roots = mpmath.polyroots(list(coefficients), maxsteps=2000, extraprec=600)
        real = [mpmath.re(x) for x in roots if abs(mpmath.im(x)) < mpmath.mpf(10) ** -60]
        wanted = [[float(h / (1 - x * i)) for i, h in zip(moments, map(mpmath.mpf, rotor), strict=True)] for x in real]
    own = [k for k, h in enumerate(rotor) if not h]
    for k in own:  # Π_k is free at λ = 1/I_k
        rest = 2.25 - sum((h / (1.0 - i / moments[k])) ** 2 for i, h in zip(moments, rotor, strict=True) if h)
        assert rest < 0.0 or np.abs(found[:, k]).max() == pytest.approx(np.sqrt(rest))
    assert len(found) == len(wanted) + 2 * len(own)
    for point in wanted:
        assert np.abs(found - point).max(axis=1).min() < 1e-13


@pytest.mark.long
def test_carriers_of_revolution_have_poles_and_maybe_a_circle():
    moments = np.array([2.0, 2.0, 3.0])
    for rotor, circle in ((0.0, True), (0.49, True), (0.51, False), (-0.49, True)):
        found = steady_rotations(Gyrostat(moments, (0.0, 0.0, rotor)), 1.0)
        assert len(found) == 2 + circle and sum(e.circle for e in found) == circle
        for e in found:
            velocity = (e.along - [0.0, 0.0, rotor]) / moments
            assert np.linalg.norm(np.cross(velocity, e.along)) < 1e-15
            if e.circle:
                assert e.along[2] == pytest.approx(-2.0 * rotor) and e.verdict.growth == "linear"
    assert len(steady_rotations(Gyrostat(np.full(3, 2.0), np.zeros(3)), 1.0)) == 1
    assert len(steady_rotations(Gyrostat(np.full(3, 2.0), (0.1, 0.0, 0.2)), 1.0)) == 2
    assert steady_rotations(Gyrostat(moments, np.zeros(3)), 0.0) == []


@pytest.mark.usefixtures("any_type")
def test_only_gyrostats_have_steady_rotations():
    moments = np.array([1.0, 2.0, 3.0])
    for system, norm, words in ((moments, 1.0, "must be a Gyrostat"), (Gyrostat(moments, np.zeros(3)), -1.0, "got -1")):
        with pytest.raises(InvalidInput, match=words):
            steady_rotations(system, norm)


@pytest.mark.long
def test_a_drum_makes_the_axis_of_least_inertia_the_lowest_in_energy():
    """Of the example: without the drum losses leave the axis, with it they return to it."""
    moments, norm = np.array([130.8, 472.338, 474.858]), 764.8
    drum = np.array([121.0 * 2.0 * np.pi, 0.0, 0.0])
    without = steady_rotations(Gyrostat(moments, np.zeros(3)), norm)
    assert [e.extremum for e in without if abs(e.along[0]) > 0.99] == ["maximum"] * 2
    alpha = 0.05 / norm
    assert ph.stability(DoubleBracket(moments, alpha), norm * np.eye(3)[0]).verdict == "unstable"
    assert [e.along[0] for e in steady_rotations(Gyrostat(moments, drum), norm) if e.extremum == "minimum"] == [1.0]

    def losing(rotor):
        def rates(t, y):
            turn = np.cross(y, (y - rotor) / moments)
            return turn + alpha * np.cross(y, turn)

        start = norm * np.array([np.cos(0.1), np.sin(0.1), 0.0])
        end = solve_ivp(rates, (0.0, 400.0), start, rtol=1e-8, atol=1e-6).y[:, -1]
        return np.degrees(np.arccos(np.clip(end[0] / np.linalg.norm(end), -1.0, 1.0)))

    assert losing(drum) < 0.01 and losing(np.zeros(3)) == pytest.approx(90.0, abs=0.5)


@pytest.mark.sweep
def test_at_rest_and_spun_up_from_rest(spec, tmp_path):
    still = read_spec(spec(SYMMETRIC, ALONG_3.replace("1.4", "0"), time="samples = 5")).report()
    values = still.as_json_dict()
    assert values["equilibria"] == [] and values["momentum_norm"] == 0.0 and values["summary"].endswith(".")
    assert [path.name for path in still.draw(tmp_path)] == ["motion.png"]
    motor = ALONG_3.replace("1.4", "0") + '\nmotor_torque = "0.1 N*m"'
    up = read_spec(spec(SYMMETRIC, motor, time="samples = 5")).report()
    # momenta stay opposite: (I3 − J) Ω3 = −u t, and the rotor gains u t
    end = up.trajectory.times[-1]
    assert up.trajectory.angular_velocity[-1] == pytest.approx([0.0, 0.0, -0.1 * end / 2.5], rel=1e-9)
    assert up.rotor_rate[-1] == pytest.approx(0.1 * end * (1 / 0.5 + 1 / 2.5), rel=1e-9)
    json.dumps(up.as_json_dict(), allow_nan=False)


@pytest.mark.long
def test_figures_show_motion_and_equilibria(spec, tmp_path):
    report = report_on(spec(TILTED, f'{ROTOR}\nrotor_drive = "constant-rate"', SPIN))
    from polhode.kinds.gyrostat.figures import draw_gyrostat_motion, draw_gyrostat_sphere

    axes = draw_gyrostat_sphere(report).axes[0]
    marked = [line for line in axes.lines if line.get_marker() in ("o", "X") and len(line.get_xdata()) == 1]
    assert len(marked) == len(report.equilibria) + 1
    upper, lower = draw_gyrostat_motion(report).axes
    assert "[rad/s]" in upper.get_ylabel() and "[°]" in lower.get_ylabel() and "[s]" in lower.get_xlabel()
    assert upper.lines[1].get_ydata() == pytest.approx(report.trajectory.angular_velocity[:, 1])
    assert {path.name for path in report.draw(tmp_path)} == {"momentum_sphere.png", "motion.png"}


@pytest.mark.parametrize(
    ("system", "words"),
    [
        ("rotor_axis = [0, 0, 0]", ["system.rotor_axis: must be a direction", "system.rotor_moment: is missing",
                                    "system.rotor_rate: is missing"]),
        ('rotor_axis = ["1 m", 0, 0]\nrotor_moment = "-1 kg*m^2"\nrotor_rate = "3 Hz"',
         ["rotor_axis", "rotor_moment: must be positive", "rotor_rate: is ambiguous", "3 mistakes"]),
        (ROTOR + '\nrotor_drive = "braked"\nmotor_torque = "1 N"', ["rotor_drive: must be one", "motor_torque: has"]),
        (ROTOR + '\nrotor_drive = "constant-rate"\nmotor_torque = "1 N*m"', ["turns a rotor that is free"]),
        (ROTOR + '\nrotor = 1\nstep = "0 s"', ["system.rotor: unknown key", "system.step: must be positive"]),
        (ROTOR.replace("0.4", "2.2"), ["`system.rotor_moment` must be that of a part of the body; got 2.2 kg m²"]),
    ],
)  # fmt: skip
def test_bad_specs_are_refused_with_code_2(spec, capsys, system, words):
    with pytest.raises(SystemExit) as stopped:
        main(["report", str(spec(TILTED, system, SPIN))])
    assert stopped.value.code == 2
    said = " ".join(capsys.readouterr().err.split())
    assert not [word for word in words if word not in said], said


@pytest.mark.long
def test_a_flat_body_has_no_room_for_a_rotor_across_it(spec):
    """A lamina's I3 = I1 + I2 leaves nothing along axis 3; a disk about axis 2 has something there."""
    flat = 'moments = ["1 kg*m^2", "2 kg*m^2", "3 kg*m^2"]'
    path = spec(flat, 'rotor_axis = [0, 1, 0]\nrotor_moment = "0.1 kg*m^2"\nrotor_rate = "1 rpm"')
    with pytest.raises(InvalidInput, match=r"would be left with moments of at most \(0.95, 1.9, 2.95\)"):
        read_spec(path).report()
    along = spec(flat, 'rotor_axis = [0, 0, 1]\nrotor_moment = "0.1 kg*m^2"\nrotor_rate = "1 rpm"')
    values = read_spec(along).report().as_json_dict()
    assert values["moments"] == [1.0, 2.0, 3.0]
    # where L is the rotor's alone the body rests, and so it started
    assert min(abs(e["spin"]) for e in values["equilibria"]) < 1e-12


@pytest.mark.long
@pytest.mark.parametrize(("rate", "word"), [("8 rad/s", "calm"), ("-1.2 rad/s", "raise")])
def test_losses_change_nutation_as_an_integrated_motion_does(spec, rate, word):
    """A sink of energy in the platform, whose motion is integrated, against the report's time constant."""
    moments, rotor, spin, sink = np.array([2.0, 2.0, 1.5]), 0.5, 0.9, 1e-3
    speed = float(rate.split()[0])
    momentum = moments[2] * spin + rotor * speed
    felt = momentum / moments[0] - spin
    loss = float(sink * (momentum * felt) ** 2)  # α |L × Ω|² over θ²
    system = (f'rotor_axis = [0, 0, 1]\nrotor_moment = "{rotor} kg*m^2"\nrotor_rate = "{rate}"\n'
              f'rotor_drive = "free"\nplatform_loss = "{loss!r} W/rad^2"')  # fmt: skip
    body = f"moments = {json.dumps([f'{x} kg*m^2' for x in moments.tolist()])}"
    path = spec(body, system, f'angular_velocity = ["0 rad/s", "0 rad/s", "{spin} rad/s"]')
    found = report_on(path).values()["losses"]
    assert found["platform"] == word
    craft = ph.spacecraft.RigidBody(moments, [ph.spacecraft.Wheel((0, 0, 1), rotor), ph.spacecraft.EnergySink(sink)])
    tilted = (1e-4 * momentum / moments[0], 0.0, spin)
    times = np.linspace(0.0, 20.0, 3)
    run = ph.simulate(craft, craft.pack(angular_velocity=tilted, rates=[speed, None]), times)
    angles = np.linalg.norm(run.momentum[:, :2], axis=1) / momentum
    assert found["time_constant"] == pytest.approx(-times[-1] / np.log(angles[-1] / angles[0]), rel=1e-4)
    assert found["nutation_rate"] == pytest.approx(momentum / moments[0], rel=1e-12)


@pytest.mark.long
def test_losses_are_not_judged_where_the_criterion_does_not_hold(spec):
    leaning = spec('moments = ["2 kg*m^2", "2.5 kg*m^2", "3 kg*m^2"]', ALONG_3, SPIN)
    assert "losses" not in report_on(leaning).values()
    assert "losses" not in report_on(spec(SYMMETRIC, ALONG_3.replace("[0, 0, 1]", "[0, 1, 1]"), SPIN)).values()
    assert report_on(spec(SYMMETRIC, ALONG_3, SPIN)).values()["losses"]["time_constant"] is None
    with pytest.raises(InvalidInput, match="needs a number with its unit"):
        read_spec(spec(SYMMETRIC, f"{ALONG_3}\nrotor_loss = 3", SPIN))
