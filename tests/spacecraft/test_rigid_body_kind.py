"""The kind of rigid bodies with wheels, torques, mounts and control: specs, refusals, answers, sweeps."""

import csv
import math
from pathlib import Path

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import polhode as ph
from polhode import formats, spacecraft
from polhode.cli.main import main
from polhode.errors import InvalidInput
from polhode.kinds.reading import build_spec, read_spec
from polhode.rotation import as_matrix
from polhode.spacecraft.rigid_body import answers
from polhode.spec.keys import number_at
from polhode.sweeps.evaluation import Evaluator
from polhode.sweeps.plan import read_plan

BODY = '[body]\nmoments = ["85 kg*m^2", "2500 kg*m^2", "2530 kg*m^2"]\n'
GRAVITY = '[[torque]]\ntype = "gravity-gradient"\n'
ORBIT = '[orbit]\nperiod = "6052.4 s"\n'
HEAD = 'system = "rigid-body"\n'
SPIN = '[spin]\nrate = "0.0595 deg/s"\nabout = "z"\n'
END = '[time]\nuntil = "30000 s"\nsamples = 301\n'
LONGEST_LIBRATION = math.radians(7.0)
EXAMPLES = Path(__file__).parents[2] / "examples"
DOUBLE = 1e-12


def spec(tmp_path, text):
    path = tmp_path / "craft.toml"
    path.write_text(text, "utf-8")
    return read_spec(path)


@pytest.mark.long
def test_ten_lines_say_that_a_satellite_stays_under_gravity(tmp_path):
    found = spec(tmp_path, HEAD + BODY + SPIN + ORBIT + GRAVITY + END).report()
    values = found.values()["gravity"]
    assert values["verdict"] == "stable" and values["region"] == "Lagrange" and values["stays"] is True
    n = 2 * math.pi / 6052.4
    # pitch about the normal, by hand: n √(3 (I_roll − I_yaw)/I_pitch)
    assert values["pitch_period"] == pytest.approx(2 * math.pi / (n * math.sqrt(3 * (2500 - 85) / 2530)), rel=1e-12)
    assert values["from_rest"]["largest"] < LONGEST_LIBRATION
    assert "can never leave it" in found.summary
    assert max(found.trajectory.drift.values()) < DOUBLE
    turned = spec(tmp_path, HEAD + BODY.replace('"85 kg*m^2", "2500 kg*m^2"', '"2500 kg*m^2", "85 kg*m^2"') + SPIN
                  + ORBIT + GRAVITY + END).report()  # fmt: skip
    assert turned.values()["gravity"]["verdict"] == "unstable"


THOMSON = HEAD + """[body]
moments = ["100 kg*m^2", "100 kg*m^2", "130 kg*m^2"]
[spin]
attitude = { axis = [1, 0, 0], angle = "0.01 deg" }
angular_velocity = ["0 rad/s", "0 rad/s", "0.005 rad/s"]
[orbit]
period = "6000 s"
""" + GRAVITY + '[time]\nuntil = "30000 s"\nsamples = 601\n'


@pytest.mark.long
def test_the_axis_of_a_spinning_satellite_rests_and_swings_at_the_rates_that_are_said(tmp_path):
    found = spec(tmp_path, THOMSON).report()
    values = found.values()["gravity"]
    assert (values["case"], values["region"], values["verdict"]) == ("cylindrical", "static", "stable")
    assert values["from_rest"]["start"] == pytest.approx(math.radians(0.01), rel=1e-9)
    assert values["from_rest"]["largest"] < math.radians(0.011)
    assert "along the orbit's normal, is stable" in found.summary
    # the small motion of the axis across the normal, in the orbit's frame, is made of both frequencies and no others
    trajectory, n = found.trajectory, 2 * math.pi / 6000
    across = np.asarray(as_matrix(trajectory.attitude))[:, :2, 2] @ [1.0, 1j] * np.exp(-1j * n * trajectory.times)

    def left(periods):
        phases = 2 * math.pi * trajectory.times[:, None] / np.array([*periods, *(-p for p in periods)])
        waves = np.exp(1j * phases)
        return np.abs(across - waves @ np.linalg.lstsq(waves, across, rcond=None)[0]).max() / np.abs(across).max()

    assert left(values["axis_periods"]) < 1e-4
    assert left([values["axis_periods"][0], 1.01 * values["axis_periods"][1]]) > 1e-2
    slow = THOMSON.replace('"130 kg*m^2"', '"70 kg*m^2"').replace("0.005 rad/s", "0.001 rad/s")
    thrown = spec(tmp_path, slow).report()
    assert thrown.values()["gravity"]["verdict"] == "unstable"
    assert thrown.values()["gravity"]["from_rest"]["largest"] > math.radians(1.0)


@pytest.mark.long
def test_another_packages_torque_is_named_by_its_entry_point(tmp_path, plugin):
    text = HEAD + '[body]\nmoments = ["2 kg*m^2", "2 kg*m^2", "2 kg*m^2"]\n' + (
        '[spin]\nangular_velocity = ["0.3 rad/s", "0 rad/s", "0.4 rad/s"]\n'
        '[[torque]]\ntype = "bdot-coils"\ngain = "4e7 A*m^2*s/T"\nfield = ["30 uT", "0 T", "0 T"]\n'
        '[time]\nuntil = "100 s"\nsamples = 11\n'
    )  # fmt: skip
    found = spec(tmp_path, text).report()
    rate = 4e7 * 3e-5**2 / 2.0
    assert np.linalg.norm(found.history.velocity[-1]) == pytest.approx(math.hypot(0.3, 0.4 * math.exp(-100 * rate)))
    with pytest.raises(InvalidInput, match="did you mean bdot-coils"):
        spec(tmp_path, text.replace("bdot-coils", "bdot-coil"))


@pytest.mark.long
def test_pulses_of_a_thruster_in_a_spec(tmp_path):
    text = HEAD + BODY + (
        '[[torque]]\ntype = "thruster"\nat = ["500 s", "700 s"]\nlasting = "20 ms"\nforce = ["0 N", "5 N", "0 N"]\n'
        'position = ["0.1 m", "0 m", "0 m"]\n[time]\nuntil = "1000 s"\nsamples = 2\n'
    )  # fmt: skip
    found = spec(tmp_path, text).report()
    assert found.history.momentum[-1] == pytest.approx([0.0, 0.0, 0.1 * 5.0 * 0.04], rel=1e-12, abs=1e-14)
    assert any("starts or ends on the way" in note for note in found.notes)
    late = spec(tmp_path, text.replace('["500 s", "700 s"]', '"2000 s"')).report()
    assert any("acts from 2000 s to 2000.02 s, and this motion goes from 0 s to 1000 s" in note for note in late.notes)
    (row,) = (table.rows for table in late.answers if getattr(table, "name", "") == "torques")
    assert row[0]["mean"] == 0.0


@pytest.mark.long
@pytest.mark.parametrize("moments", [(100, 200, 200), (200, 200, 200)])
def test_a_body_of_equal_moments_has_the_periods_that_it_has(tmp_path, monkeypatch, capsys, moments):
    """A boom does not librate about its own axis, and a ball about none: they drift there."""
    text = "".join(f'"{x} kg*m^2", ' for x in moments)
    found = spec(tmp_path, HEAD + f"[body]\nmoments = [{text}]\n" + SPIN + ORBIT + GRAVITY + END).report()
    gravity = found.values()["gravity"]
    assert ("axis_periods" in gravity) == (moments[0] < moments[1]), "a boom has an axis, and a ball has none"
    assert all(math.isfinite(x) for x in gravity.get("axis_periods", gravity.get("roll_yaw_periods")) or ())
    monkeypatch.chdir(tmp_path)
    with pytest.raises(SystemExit) as end:
        main(["report", "craft.toml"])
    assert not end.value.code and "region" in capsys.readouterr().out


@pytest.mark.long
def test_the_example_of_a_cubesat_points_down(tmp_path):
    text = (EXAMPLES / "cubesat_6u.toml").read_text("utf-8").replace('until = "95 min"', 'until = "10 min"')
    found = spec(tmp_path, text.replace("samples = 1141", "samples = 121")).report()
    values = found.values()
    assert values["control"]["limits"] == "not reached" and values["control"]["load"] < 1.0
    assert 100 < values["control"]["settling_time"] < 300
    assert values["control"]["pointing_error"]["end"] < math.radians(0.1)
    assert all(row["phase"] > math.radians(60) for row in values["margins"].values())
    assert all(0.79 < row["damping"] < 0.81 for row in values["closed_loop"])
    assert max(found.trajectory.drift.values()) < 1e-11
    # an asked torque beyond the limit is cut off, and that is said
    weak = spec(tmp_path, text.replace("3 mN*m", "0.03 mN*m").replace("samples = 1141", "samples = 121")).report()
    assert weak.values()["control"]["limits"] == "acted" and "limit of the actuators acts" in weak.summary
    assert all(row["torque_margin"] >= -1e-12 for row in weak.values()["wheels"])


@pytest.mark.parametrize(
    "changed, place, said",
    [
        ('[[torque]]\ntype = "gravity-grad"\n', "torque.1.type", "did you mean gravity-gradient"),
        (GRAVITY + "strength = 3\n", "torque.1.strength", "unknown key"),
        ('[[torque]]\ntype = "constant"\ntorque = ["1 N", "0 N*m", "0 N*m"]\n', "torque.1.torque.1", "N*m"),
        ('[[torque]]\ntype = "constant"\n', "torque.1.torque", "is missing"),
        ('[[torque]]\ntype = "constant"\ntorque = ["1 N*m", "0 N*m", "0 N*m"]\nframe = "sun"\n', "torque.1.frame",
         "must be one of"),
        ('[torque]\ntype = "gravity-gradient"\n', "torque", "two brackets"),
        (GRAVITY, "torque.1.type", "acts on an orbit; give one"),
        (f'{ORBIT}gravitational_parameter = "4.28e13 m^3/s^2"\n[[torque]]\ntype = "eddy-currents"\n',
         "torque.1.type", "Earth's field alone"),
        ('[[flywheel]]\naxis = [0, 0, 1]\n', "flywheel", "did you mean wheel"),
        ('[photon]\nx = 1\n', "photon", "control, orbit"),
        (ORBIT + 'altitude = "500 km"\n', "orbit", "exactly one of period, semi_major_axis and altitude"),
        ('[orbit]\naltitude = "300 km"\ngravitational_parameter = "42828 km^3/s^2"\n', "orbit.altitude",
         "counts from the Earth's radius; about another body give semi_major_axis"),
        ('[control]\nlaw = "quaternion-pd"\nbandwidth = "0.1 rad/s"\n', "control", "works by wheels, and there"),
        ('[control]\nlaw = "pid"\n', "control.law", "names no control law"),
        ('[control]\nlaw = "quaternion-pd"\nby = "torque"\ntarget = "nadir"\nbandwidth = "0.1 rad/s"\n',
         "control.target", "along an orbit"),
        ('[[wheel]]\naxis = [0, 0, 1]\nmoment = "1 kg*m^2"\nmax_torque = "1 N*m"\n', "wheel.1", "controlled wheel"),
        ('[[wheel]]\naxis = [0, 0, 0]\nmoment = "1 kg*m^2"\n', "wheel.1.axis", "not all zero"),
        ('[[wheel]]\naxis = [0, 0, 1]\nmoment = "1 kg*m^2"\nspeed = "1 rpm"\n', "wheel.1.speed", "unknown key"),
        ('[[mount]]\ntype = "slug"\nmoment = "1 kg*m^2"\n', "mount.1.damping", "is missing"),
    ],
)  # fmt: skip
def test_what_is_wrong_is_refused_at_its_place(tmp_path, changed, place, said):
    with pytest.raises(InvalidInput) as caught:
        spec(tmp_path, HEAD + BODY + changed)
    message = str(caught.value)
    assert f"  {place}: " in message and said in message, message


def test_refusals_of_the_system_name_the_table(tmp_path):
    with pytest.raises(InvalidInput, match=r"wheel\.1|`mounts`"):
        spec(tmp_path, HEAD + BODY + '[[wheel]]\naxis = [0, 0, 1]\nmoment = "1e4 kg*m^2"\n').report()
    fast = '[[wheel]]\naxis = [0, 0, 1]\nmoment = "1 g*m^2"\nrate = "100 rpm"\nmax_rate = "50 rpm"\n'
    fast += 'max_torque = "1 N*m"\n'
    law = '[control]\nlaw = "quaternion-pd"\ngain = "1 N*m"\nrate_gain = "1 N*m*s"\n'
    with pytest.raises(InvalidInput, match=r"wheel\.1: its rate at the start, 10.472 rad/s, is beyond its max_rate"):
        spec(tmp_path, HEAD + BODY + fast + law).report()
    for orbit in ('altitude = "500 km"\neccentricity = 0.5\n', 'period = "1 s"\n'):
        with pytest.raises(InvalidInput, match="of the Earth's centre"):
            spec(tmp_path, f"{HEAD}{BODY}[orbit]\n{orbit}{GRAVITY}").report()
    with pytest.raises(InvalidInput, match=r"torque.1: `lasting`"):
        text = '[[torque]]\ntype = "thruster"\nat = "5 s"\nlasting = "0 s"\nforce = ["0 N", "5 N", "0 N"]\n'
        spec(tmp_path, HEAD + BODY + text + 'position = ["0.1 m", "0 m", "0 m"]\n').report()


def test_a_spec_of_another_kind_says_where_the_tables_go(tmp_path):
    with pytest.raises(InvalidInput) as caught:
        spec(tmp_path, BODY + SPIN + ORBIT)
    assert 'orbit: goes with another system; write system = "rigid-body" at the top' in str(caught.value)
    with pytest.raises(InvalidInput, match=r"belongs at the top of the file"):
        spec(tmp_path, '[system]\nkind = "rigid-body"\norbit = { period = "1 h" }\n' + BODY)


def test_numbers_of_its_tables_can_be_swept(tmp_path):
    found = spec(tmp_path, HEAD + BODY + ORBIT + GRAVITY)
    model = found.kind.model_of({"kind": "rigid-body", "torque": [{"type": "linear-drag"}, {"type": "constant"}]})
    beside = found.kind.table.beside
    assert number_at("wheel.1.moment", model, beside).unit == "kg*m^2"
    assert number_at("torque.1.coefficient", model, beside).unit == "N*m*s"
    assert number_at("torque.2.torque.3", model, beside).unit == "N*m"
    assert number_at("orbit.inclination", model, beside).unit == "rad"
    with pytest.raises(ValueError, match=r"must begin with body\., spin\., time\., system\., wheel\., torque\."):
        number_at("wheels.1", model, beside)
    plan = read_plan(EXAMPLES / "cubesat_6u.toml")
    assert "control.bandwidth" in plan.design.inputs


@pytest.mark.long
def test_a_sweep_of_a_spec_whose_system_is_one_word_says_how_many_have_a_motion(tmp_path, capsys):
    text = SWEPT.format(HEAD + BODY + SPIN)
    (tmp_path / "craft.toml").write_text(text, "utf-8")
    with pytest.raises(SystemExit) as ended:
        main(["sweep", str(tmp_path / "craft.toml"), "--out", str(tmp_path / "s.zarr"), "--no-figures"])
    assert ended.value.code == 0
    assert "2 of 2 samples have a motion" in capsys.readouterr().out


@pytest.mark.long
def test_a_sweep_takes_no_more_answers_than_its_outputs(tmp_path, monkeypatch):
    """The linearised loop and its margins take longer than the motion of a minute."""
    text = (EXAMPLES / "cubesat_6u.toml").read_text("utf-8").replace("samples = 1000", "samples = 2")
    text = text.replace('until = "95 min"', 'until = "1 min"').replace("samples = 1141", "samples = 13")
    (tmp_path / "craft.toml").write_text(text, "utf-8")
    evaluator = Evaluator(read_plan(tmp_path / "craft.toml"))
    monkeypatch.setattr(answers, "linearize_loop", lambda *_: pytest.fail("nobody asked for it"))
    assert np.isfinite(evaluator.chunk(0, 2).values["control.load"]).all()
    (tmp_path / "craft.toml").write_text(text.replace('"control.load"', '"margins.x.phase"'), "utf-8")
    with pytest.raises(pytest.fail.Exception, match="nobody asked"):
        Evaluator(read_plan(tmp_path / "craft.toml")).chunk(0, 1)


def test_the_motor_of_a_wheel_of_constant_rate_turns_it_with_the_body(tmp_path):
    """J a·Ω̇ by hand: the body gains speed about x alone, the wheel is at 60 degrees to it."""
    text = HEAD + '[body]\nmoments = ["2 kg*m^2", "2 kg*m^2", "2 kg*m^2"]\n' + (
        '[[wheel]]\naxis = [0.5, 0, 0.8660254037844386]\nmoment = "0.01 kg*m^2"\nrate = "0 rad/s"\n'
        'drive = "constant-rate"\n[[torque]]\ntype = "constant"\ntorque = ["0.4 N*m", "0 N*m", "0 N*m"]\n'
        '[time]\nuntil = "3 s"\nsamples = 4\n'
    )
    wheel = spec(tmp_path, text).report().values()["wheels"][0]
    assert wheel["torque_largest"] == pytest.approx(0.01 * 0.5 * 0.4 / 2.0, rel=1e-12)


SWEPT = """{}[time]
until = "10 s"
samples = 3
[sweep]
samples = 2
outputs = ["end.momentum"]
[sweep.inputs]
"spin.rate" = {{uniform = ["0.05 deg/s", "0.06 deg/s"]}}
"""


@pytest.mark.sweep
def test_the_report_says_for_how_long_there_was_no_sun(tmp_path):
    sunlit = '[[torque]]\ntype = "solar-pressure"\nsun = [0, 0, 1]\nbox = ["1 m", "1 m", "1 m"]\n'
    orbit = '[orbit]\naltitude = "500 km"\ninclination = "90 deg"\n'
    end = '[time]\nuntil = "1 h"\nsamples = 7\n'
    notes = spec(tmp_path, HEAD + BODY + SPIN + orbit + sunlit + end).report().notes
    (said,) = [note for note in notes if "shade" in note]
    # a circle of 6878 km goes through the cylinder of 6378 km where it is behind the Earth by √(a² − R²)
    assert said == "torque.1 (solar-pressure) is in the shade of a radius of 6378.14 km at 14.3% of the samples."
    deep = -math.sqrt(1 - (6378.137 / 6878.137) ** 2)
    dark = [math.sin(2 * math.pi / 5676.98 * t) < deep for t in range(0, 3601, 600)]
    assert sum(dark) / 7 == pytest.approx(0.143, abs=1e-3)


@pytest.mark.long
def test_free_wheels_friction_and_a_motor(tmp_path):
    text = HEAD + BODY + (
        '[spin]\nangular_velocity = ["0 rad/s", "0 rad/s", "0.01 rad/s"]\n'
        '[[wheel]]\naxis = [0, 0, 2]\nmoment = "0.1 kg*m^2"\nrate = "100 rad/s"\nfriction = "0.01 N*m*s"\n'
        '[[wheel]]\naxis = [1, 0, 0]\nmoment = "0.1 kg*m^2"\ntorque = "0.02 N*m"\n'
        '[[wheel]]\naxis = [0, 1, 0]\nmoment = "0.1 kg*m^2"\nrate = "5 rad/s"\ndrive = "constant-rate"\n'
        '[time]\nuntil = "20 s"\nsamples = 5\n'
    )  # fmt: skip
    found = spec(tmp_path, text).report()
    assert found.trajectory.drift["momentum_space"] < 1e-12
    rates = found.history.rates[-1]
    # against friction c the rate relative to the body falls with c (1/J + 1/(I − J)), nearly
    assert rates[0] == pytest.approx(100 * math.exp(-0.01 * 20 * (1 / 0.1 + 1 / 2529.9)), rel=1e-3)
    assert rates[2] == 5.0
    assert [row["rate_largest"] > 0 for row in found.values()["wheels"]] == [True] * 3
    path = formats.write_csv(found.trajectory, tmp_path / "motion.csv")
    with path.open(newline="") as file:
        last = list(csv.DictReader(file))[-1]
    assert float(last["wheel_rate_1 [rad s-1]"]) == rates[0] and float(last["wheel_rate_3 [rad s-1]"]) == 5.0
    assert float(last["wheel_torque_2 [N m]"]) == 0.02


@pytest.mark.long
def test_specs_in_memory_are_the_same_as_files(tmp_path):
    tables = {"system": "rigid-body", "body": {"moments": ["1 kg*m^2"] * 3}, "wheel": [
        {"axis": [0, 0, 1], "moment": "0.1 kg*m^2", "rate": "10 rad/s"}]}  # fmt: skip
    before = repr(tables)
    found = build_spec(tables, tmp_path / "x.toml")
    assert repr(tables) == before and found.system.wheel[0].rate == 10.0
    assert ph.report(found).kind == "rigid-body"


MOUNTS = """
[[mount]]
type = "control-moment-gyroscope"
gimbal_axis = [0, 0, 1]
spin_axis = [1, 0, 0]
rotor_moment = "0.1 kg*m^2"
rotor_rate = "30 rad/s"
moments = ["0.2 kg*m^2", "0.15 kg*m^2", "0.15 kg*m^2"]
rotor = "free"
gimbal_rate = "1 rad/s"
bandwidth = "10 1/s"
angle = "0.5 rad"
angle_rate = "0.2 rad/s"
[[mount]]
type = "pendulum"
pivot = ["0 m", "0 m", "0.1 m"]
arm = ["0 m", "0 m", "-0.3 m"]
mass = "2 kg"
stiffness = "0.1 N*m/rad"
toward = [0, 3, -4]
angular_velocity = ["0.1 rad/s", "0.2 rad/s", "0 rad/s"]
[[mount]]
type = "sprung-mass"
position = ["0 m", "0.1 m", "0.1 m"]
directions = [[1, 0, 0], [0, 1, 0]]
mass = "2 kg"
stiffness = "3 N/m"
displacement = ["1 cm", "-2 cm"]
[[mount]]
type = "hinged-part"
hinge = ["1 m", "0 m", "0 m"]
axis = [0, 1, 0]
center = ["1.5 m", "0 m", "0 m"]
mass = "1 kg"
stiffness = "1 N*m/rad"
angle = "0.3 rad"
rate = "0.1 rad/s"
[[mount]]
type = "slug"
moment = "0.01 kg*m^2"
damping = "0.001 N*m*s"
angular_velocity = ["0.1 rad/s", "0 rad/s", "0 rad/s"]
[[mount]]
type = "propellant"
position = ["0 m", "0 m", "0.2 m"]
mass = "5 kg"
nozzle = ["0 m", "0 m", "-1 m"]
flow = "0.05 kg/s"
exhaust_velocity = ["0 m/s", "0 m/s", "-2000 m/s"]
at = "1 s"
lasting = "3 s"
"""


@pytest.mark.sweep
def test_mounts_of_a_spec_start_as_it_says(tmp_path):
    text = HEAD + BODY + 'mass = "100 kg"\n[spin]\nangular_velocity = ["0 rad/s", "0.2 rad/s", "0.1 rad/s"]\n' + MOUNTS
    found = spec(tmp_path, text + '[time]\nuntil = "2 s"\nsamples = 3\n').motion().trajectory
    gimbal = spacecraft.ControlMomentGyroscope(
        (0, 0, 1), spacecraft.Wheel((1, 0, 0), 0.1), (0.2, 0.15, 0.15), gimbal_rate=1.0, bandwidth=10.0
    )
    parts = [
        gimbal, spacecraft.SphericalPendulum((0, 0, 0.1), (0, 0, -0.3), 2.0, 0.1),
        spacecraft.SprungMass((0, 0.1, 0.1), [(1, 0, 0), (0, 1, 0)], 2.0, 3.0),
        spacecraft.HingedPart((1, 0, 0), (0, 1, 0), (1.5, 0, 0), 1.0, stiffness=1.0),
        spacecraft.SphericalSlug(0.01, 0.001),
        spacecraft.Propellant((0, 0, 0.2), 5.0, (0, 0, -1), 0.05, (0, 0, -2000.0), 1.0, 3.0),
    ]  # fmt: skip
    body = spacecraft.RigidBody.from_body(ph.Body(100.0, (0, 0, 0), np.diag([85.0, 2500.0, 2530.0])), parts)
    start = body.pack((1, 0, 0, 0), (0.0, 0.2, 0.1), rates=[(0.2, 30.0), (0.1, 0.2, 0.0), None, 0.1, (0.1, 0, 0), None],
                      coordinates=[0.5, (0.0, 0.6, 0.2), (0.01, -0.02), 0.3, None, None])  # fmt: skip
    assert np.asarray(found.states[0]) == pytest.approx(np.asarray(start), abs=1e-13)
    end = ph.simulate(body, start, found.times).states[-1]
    assert np.asarray(found.states[-1]) == pytest.approx(np.asarray(end), abs=1e-12)
    assert found.part("propellant_mass").tolist() == pytest.approx([5.0, 5.0, 4.95], abs=1e-13)


@pytest.mark.parametrize(
    "changed, said",
    [
        ('angle = "0.5 rad"', ('angle = 0.5', "mount.1.angle: needs a number with its unit")),
        ('toward = [0, 3, -4]', ('toward = [0, 0, 0]', "mount.2.toward")),
        ('displacement = ["1 cm", "-2 cm"]', ('displacement = ["1 cm", "2 cm", "3 cm"]', "mount.3: `displacement`")),
        ('bandwidth = "10 1/s"', ('', "mount.1: `gimbal_rate` and `bandwidth` go together")),
        ('mass = "5 kg"', ('mass = "500 kg"', "must be part of the body")),
    ],
)  # fmt: skip
def test_mounts_that_cannot_start_so_are_refused(tmp_path, changed, said):
    assert changed in MOUNTS
    with pytest.raises(InvalidInput) as refused:
        spec(tmp_path, HEAD + BODY + 'mass = "100 kg"\n' + MOUNTS.replace(changed, said[0]) + END).motion()
    assert said[1] in str(refused.value)


@pytest.mark.long
def test_one_wheel_controls_pitch_and_the_report_says_so(tmp_path):
    text = (
        f'{HEAD}[body]\nmoments = ["0.20 kg*m^2", "0.25 kg*m^2", "0.12 kg*m^2"]\n[spin]\n'
        'attitude = { axis = [0, 1, 0], angle = "5 deg" }\nangular_velocity = ["0 rad/s", "0 rad/s", "0 rad/s"]\n'
        '[orbit]\naltitude = "500 km"\nrelative = true\n[[wheel]]\naxis = [0, 1, 0]\nmoment = "1e-3 kg*m^2"\n'
        'rate = "-3000 rpm"\n[control]\nlaw = "quaternion-pd"\ntarget = "nadir"\nbandwidth = "0.02 rad/s"\n'
        '[time]\nuntil = "1200 s"\nsamples = 13\n'
    )
    found = spec(tmp_path, text).report()
    assert any("about one axis only" in note for note in found.notes)
    values = found.values()
    assert values["control"]["pointing_error"]["end"] < math.radians(1e-3)
    # nutation at h/√(I₁I₃), by hand, undamped, and pitch at the bandwidth
    rates = sorted(row["frequency"] for row in values["closed_loop"])
    assert rates[-1] == pytest.approx(1e-3 * 3000 * math.pi / 30 / math.sqrt(0.2 * 0.12), rel=1e-2)
    assert [round(row["damping"], 2) for row in values["closed_loop"]] == [0.0, 0.0, 0.7]
    assert rates[1] == pytest.approx(0.02, rel=0.01)


SLEW = (
    'system = "rigid-body"\n[body]\nmoments = ["0.12 kg*m^2", "0.16 kg*m^2", "0.19 kg*m^2"]\n[spin]\n'
    'attitude = [{sign}, 0, 0, 0]\nangular_velocity = ["0 deg/s", "0 deg/s", "{rate} deg/s"]\n[control]\n'
    'law = "quaternion-pd"\nbandwidth = "0.03 rad/s"\ndamping = 0.8\nby = "torque"\n'
    '[time]\nuntil = "400 s"\nsamples = 401\n'
)  # fmt: skip


@pytest.mark.long
@pytest.mark.parametrize("sign", [1, -1])
def test_a_slew_the_longer_way_is_said(tmp_path, sign):
    """One axis by SciPy: θ″ = −2 ω² sin(θ/2) − 2 ζ ω θ′, whose θ goes beyond half a turn and comes back."""
    rate, w, damping = math.radians(16.0), 0.03, 0.8
    slope = lambda t, y: (y[1], -2.0 * w**2 * math.sin(0.5 * y[0]) - 2.0 * damping * w * y[1])  # noqa: E731
    times = np.linspace(0.0, 400.0, 401)
    theta = np.degrees(solve_ivp(slope, (0.0, 400.0), (0.0, rate), "DOP853", times, rtol=1e-12, atol=1e-12).y[0])
    settled = times[np.flatnonzero(np.abs(theta) >= 1.0)[-1] + 1]
    report = spec(tmp_path, SLEW.format(sign=sign, rate=16)).report()
    (note,) = [note for note in report.notes if "quaternion-pd" in note]
    assert f"turned by up to {theta.max():.4g}° from its target, at {times[theta.argmax()]:g} s" in note
    assert f"only {360.0 - theta.max():.4g}° were left the other way" in note
    values = report.values()
    assert values["control"]["settling_time"] == settled == 337.0
    assert {round(row["damping"], 6) for row in values["closed_loop"]} == {damping}  # about either quaternion
    short = spec(tmp_path, SLEW.format(sign=sign, rate=4)).report()
    assert not [note for note in short.notes if "quaternion-pd" in note]


@pytest.mark.long
def test_a_rotor_that_the_body_carries_past_its_limit_is_said(tmp_path):
    """The body turns against the rotor, whose motor gives nothing at max_rate: σ = σ₀ + M t/(I − J)."""
    text = (
        'system = "rigid-body"\n[body]\nmoments = ["0.2 kg*m^2", "0.2 kg*m^2", "0.2 kg*m^2"]\n[spin]\n'
        'angular_velocity = ["0 rad/s", "0 rad/s", "0 rad/s"]\n[[wheel]]\naxis = [0, 0, 1]\nmoment = "1e-3 kg*m^2"\n'
        'rate = "100 rpm"\nmax_rate = "100 rpm"\nmax_torque = "1 mN*m"\n[[torque]]\ntype = "constant"\n'
        'torque = ["0 N*m", "0 N*m", "-1 mN*m"]\n[control]\nlaw = "rate"\nbandwidth = "0.1 rad/s"\n'
        'angular_velocity = ["0 rad/s", "0 rad/s", "-1 rad/s"]\n[time]\nuntil = "10 s"\nsamples = 11\n'
    )
    report = spec(tmp_path, text).report()
    past = 1e-3 * 10.0 / 0.199 / (100.0 * math.pi / 30.0)
    assert report.values()["wheels"][0]["rate_margin"] == pytest.approx(-past, rel=1e-6)
    assert [note for note in report.notes if note.startswith("wheel 1 turned past max_rate")]
    (row,) = report._wheels().rows
    assert report._wheels().columns["left of rate"](row) == f"{100.0 * past:.3g} % past"
    below = spec(tmp_path, text.replace('\nrate = "100 rpm"', '\nrate = "-50 rpm"')).report()
    assert not [note for note in below.notes if "past max_rate" in note]
    assert below._wheels().columns["left of rate"](below._wheels().rows[0]).endswith(" %")
