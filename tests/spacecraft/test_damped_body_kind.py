"""Reports on bodies with losses: against motions and exponents in closed form, starts on an axis, bad specs."""

import json

import numpy as np
import pytest

from polhode.cli.main import main
from polhode.kinds.reading import read_spec
from polhode.reports import length
from polhode.spacecraft.damped_body.figures import draw_damped_motion, draw_damped_sphere
from polhode.sweeps.evaluation import Evaluator
from polhode.sweeps.plan import read_plan

MOTION = 1e-9
"""Relative: adaptive steps at 1e-12 over some turns, against a closed form."""
BALANCE = 1e-10
MOMENTS = np.array([1.0, 2.0, 2.6])
TRIAXIAL = 'moments = ["1 kg*m^2", "2 kg*m^2", "2.6 kg*m^2"]'
ROD = 'moments = ["1 kg*m^2", "3 kg*m^2", "3 kg*m^2"]'
DISK = 'moments = ["2 kg*m^2", "2 kg*m^2", "3 kg*m^2"]'


@pytest.fixture
def report(tmp_path):
    def make(body, system, spin="", time="samples = 41"):
        path = tmp_path / "spec.toml"
        text = f'[body]\n{body}\n[system]\nkind = "damped-body"\n{system}\n[spin]\n{spin}\n[time]\n{time}\n'
        path.write_text(text, "utf-8")
        return read_spec(path).report()

    return make


@pytest.mark.sweep
def test_a_rod_goes_flat_as_the_closed_form_says(report):
    """Of θ from the long axis, tan θ grows as exp(ε |L| (1/I1 − 1/I2) t): θ̇ = ½ ε |L| (1/I1 − 1/I2) sin 2θ."""
    found = report(ROD, "damping = 0.1", 'rate = "3 rad/s"\nabout = 1\ntilt = "1 deg"')
    start = np.array([3 * np.cos(np.radians(1)), 9 * np.sin(np.radians(1))])
    rate = 0.1 * np.hypot(*start) * (1 - 1 / 3)
    times = np.asarray(found.trajectory.times)
    from_long = np.arctan(start[1] / start[0] * np.exp(rate * times))
    assert found.angle_to_major_axis == pytest.approx(np.pi / 2 - from_long, rel=1e-7, abs=MOTION)
    energy = 0.5 * np.hypot(*start) ** 2 * (np.cos(from_long) ** 2 + np.sin(from_long) ** 2 / 3)
    assert found.energy == pytest.approx(energy, rel=MOTION)
    values = found.as_json_dict()
    assert values["end"]["angle_to_major_axis"] < 1e-4 and max(values["drift"].values()) < BALANCE
    assert values["end"]["energy"] == pytest.approx(values["lowest_energy"], rel=1e-6)
    assert values["time_constant"] == pytest.approx(1 / rate, rel=1e-12)
    assert [axis["verdict"] for axis in values["axes"]] == ["unstable", "stable", "stable"]
    assert values["axes"][0]["rate"] == pytest.approx(rate, rel=1e-12)
    assert "about an axis of the same moment, no farther off" in values["axes"][1]["certificate"]
    assert [note for note in values["notes"] if "Explorer 1" not in note] == []


@pytest.mark.long
def test_verdicts_and_rates_inside_a_triaxial_body(report):
    """About axis k the exponents are those of ẋ = a y − d x, ẏ = −b x − e y with a, b of Euler's equations."""
    found = report(TRIAXIAL, "damping = 0.03", 'rate = "2 rad/s"\nabout = 1\ntilt = "3 deg"')
    norm, inverse = found.momentum_norm[0], 1 / MOMENTS
    alpha = 0.03 / norm
    for k, verdict in enumerate(found.axes):
        i, j = (k + 1) % 3, (k + 2) % 3
        spin = norm * np.array([[0.0, inverse[k] - inverse[j]], [inverse[i] - inverse[k], 0.0]])
        loss = alpha * norm**2 * np.diag([inverse[k] - inverse[i], inverse[k] - inverse[j]])
        exponents = np.linalg.eigvals(spin + loss)
        assert verdict.rate == pytest.approx(exponents.real.max(), rel=1e-10)
        assert verdict.verdict == ("stable" if k == 2 else "unstable")
    assert found.angle_to_major_axis[-1] < 1e-3 and (np.diff(found.energy) <= BALANCE * found.energy[0]).all()
    assert max(found.trajectory.drift.values()) < BALANCE


@pytest.mark.sweep
def test_linear_drag_turns_a_symmetric_body_towards_its_larger_moment(report):
    """L_k falls as exp(−c t/I_k): tan of the angle from axis 3 as exp(c (1/I3 − 1/I1) t), whatever the nutation."""
    found = report(DISK, 'linear_drag = "0.2 N*m*s"', 'rate = "3 rad/s"\nabout = 3\ntilt = "20 deg"')
    times, first = np.asarray(found.trajectory.times), 2 / 3 * np.tan(np.radians(20))
    assert np.tan(found.angle_to_major_axis) == pytest.approx(first * np.exp(0.2 * (1 / 3 - 1 / 2) * times), rel=MOTION)
    values = found.as_json_dict()
    assert values["time_constant"] == pytest.approx(15.0) and times[-1] == pytest.approx(75.0)
    assert values["end"]["momentum_norm"] == pytest.approx(
        np.hypot(9 * np.cos(np.radians(20)) * np.exp(-5), 6 * np.sin(np.radians(20)) * np.exp(-7.5)), rel=MOTION
    )
    assert [axis["verdict"] for axis in values["axes"]] == ["unstable", "unstable", "stable"]
    assert values["axes"][2]["rate"] == pytest.approx(0.2 * (1 / 3 - 1 / 2), rel=1e-9)
    assert values["lowest_energy"] is None and set(values["drift"]) == {"kinetic_energy", "|L|²"}


@pytest.mark.sweep
def test_quadratic_drag_brakes_as_one_over_time(report):
    found = report(TRIAXIAL, 'quadratic_drag = "0.4 N*m*s^2"', 'rate = "3 rad/s"\nabout = 3')
    times = np.asarray(found.trajectory.times)
    assert found.start.time_constant == pytest.approx(2.6 / (0.4 * 3), rel=1e-12)
    assert found.momentum_norm == pytest.approx(7.8 / (1 + times / found.start.time_constant), rel=MOTION)
    assert found.start.axes[2].rate == pytest.approx(0.4 * 3 * (1 / 2.6 - (1 + 1 / 2) / 2), rel=1e-9)
    assert [axis.verdict for axis in found.start.axes] == ["unstable", "unstable", "stable"]


@pytest.mark.sweep
def test_in_orbit_the_balances_close(report):
    drag = 'linear_drag = "0.0001 N*m*s"\norbital_period = "90 min"'
    found = report(TRIAXIAL, drag, 'rate = "0.2 rpm"\nabout = 3\ntilt = "5 deg"', 'until = "3 h"\nsamples = 41')
    assert set(found.trajectory.drift) == {"kinetic_energy", "|L|²", "jacobi_integral"}
    assert max(found.trajectory.drift.values()) < BALANCE
    values = found.as_json_dict()
    assert values["eccentricity"] == 0.0 and values["orbital_period"] == 5400.0
    assert any("gravity" in note for note in values["notes"])


@pytest.mark.sweep
def test_rest_spheres_and_starts_on_an_axis(report, tmp_path):
    drag = 'linear_drag = "1e-5 N*m*s"\norbital_period = "90 min"'
    in_orbit = report(TRIAXIAL, drag, "attitude = [0.9, 0.1, 0.2, 0.3]")
    assert in_orbit.summary == "The body starts at rest; gravity turns it." and in_orbit.momentum_norm[-1] > 1e-5
    json.dumps(in_orbit.as_json_dict(), allow_nan=False)
    rest = report(TRIAXIAL, "damping = 0.1")
    values = rest.as_json_dict()
    assert values["axes"] == [] and values["summary"] == "The body is at rest." and values["time_constant"] is None
    json.dumps(values, allow_nan=False)
    assert [path.name for path in rest.draw(tmp_path)] == ["motion.png"]
    ball = report('moments = ["2 kg*m^2", "2 kg*m^2", "2 kg*m^2"]', "damping = 0.1", 'rate = "1 rpm"\nabout = 2')
    assert [axis.verdict for axis in ball.axes] == ["stable"] * 3 and not ball.angle_to_major_axis.any()
    on_axis = report(TRIAXIAL, "damping = 0.1", 'rate = "1 rad/s"\nabout = 1')
    (note,) = on_axis.notes
    assert note.startswith("it starts exactly on axis 1") and note.endswith("Give spin.tilt to see it.")
    assert on_axis.angle_to_major_axis == pytest.approx(np.full(41, np.pi / 2))
    slow = report(TRIAXIAL, "damping = 0.001", 'rate = "1 rad/s"\nabout = 1\ntilt = "1 deg"', 'until = "9 s"')
    leaves, later = slow.notes
    assert "Explorer 1" in leaves and later == 'it has not settled; give a later time.until = "4.27e+04 s".'


@pytest.mark.sweep
def test_figures_show_the_path_or_samples_alone(report, tmp_path):
    close = report(ROD, "damping = 0.1", 'rate = "3 rad/s"\nabout = 1\ntilt = "1 deg"', "samples = 1500")
    upper, lower = draw_damped_motion(close).axes
    assert "[J]" in upper.get_ylabel() and "[°]" in lower.get_ylabel() and "[s]" in lower.get_xlabel()
    assert lower.lines[0].get_ydata() == pytest.approx(np.degrees(close.angle_to_major_axis))
    names = [text.get_text() for text in draw_damped_sphere(close).axes[0].get_legend().get_texts()]
    assert names == ["direction of L", "levels of energy", "stable", "unstable"]
    apart = report(ROD, "damping = 0.1", 'rate = "3 rad/s"\nabout = 1\ntilt = "1 deg"', "samples = 30")
    assert draw_damped_sphere(apart).axes[0].get_legend().get_texts()[0].get_text() == "L at the samples"
    assert {path.name for path in apart.draw(tmp_path)} == {"momentum_sphere.png", "motion.png"}


@pytest.mark.parametrize(
    ("system", "words"),
    [
        ("", ["system: needs damping, like 0.01,", "or linear_drag, like", "or quadratic_drag; got none"]),
        ('orbital_period = "90 min"',
         ["needs damping, like 0.01", "of the kind that takes [orbit]; got orbital_period"]),
        ('damping = 0.1\nlinear_drag = "1 N*m*s"\norbital_period = "90 min"',
         ["1 mistake", "system.damping: is for losses inside", "goes without linear_drag and orbital_period"]),
        ('linear_drag = "1 N*m*s"\neccentricity = 0.1', ["1 mistake", "system.eccentricity: goes with orbital_period"]),
        ('linear_drag = "1 N*m"\nquadratic_drag = "-1 N*m*s^2"\norbital_period = "90 min"\neccentricity = 1.0',
         ["3 mistakes", "linear_drag: has the wrong unit", "quadratic_drag: must be positive",
          "eccentricity: must be from 0 to 0.99"]),
        ('damping = 0.1\nloss_rate = "2 mW"', ["1 mistake", "system.loss_rate: goes without damping"]),
        ('damping_time = "0 s"\nloss_rate = "2 m"', ["damping_time: must be positive", "loss_rate: has the wrong"]),
        ('damping = "0.1"', ["system.damping: must be a plain finite number"]),
        ("damping = -0.1\nextra = 1", ["system.damping: must be positive; got -0.1", "system.extra: unknown key"]),
    ],
)  # fmt: skip
def test_bad_specs_are_refused_with_code_2(tmp_path, capsys, system, words):
    path = tmp_path / "bad.toml"
    path.write_text(f'[body]\n{TRIAXIAL}\n[system]\nkind = "damped-body"\n{system}\n', "utf-8")
    with pytest.raises(SystemExit) as stopped:
        main(["report", str(path)])
    assert stopped.value.code == 2
    said = " ".join(capsys.readouterr().err.split())
    assert not [word for word in words if word not in said], said


@pytest.mark.long
def test_losses_may_be_given_by_time_or_power(report):
    spin = 'rate = "3 rad/s"\nabout = 1\ntilt = "5 deg"'
    by_time = report(TRIAXIAL, 'damping_time = "40 s"', spin, "samples = 400").as_json_dict()
    assert by_time["time_constant"] == pytest.approx(40.0, rel=1e-6) and by_time["damping_time"] == 40.0
    times = by_time["flat_spin_time"]
    assert times["motion"] == pytest.approx(times["energy_sink"], rel=0.05) and times["motion"] > 40.0
    time = 'until = "20 s"\nsamples = 400'
    by_power = report(TRIAXIAL, 'loss_rate = "20 µW"', spin, time)
    assert (by_power.energy[0] - by_power.energy[-1]) / 20.0 == pytest.approx(2e-5, rel=0.1)
    same = report(TRIAXIAL, f"damping = {by_power.start.damping!r}", spin, time)
    assert same.energy == pytest.approx(by_power.energy, rel=1e-9)


def test_a_thin_rod_is_refused(report):
    with pytest.raises(ValueError, match="thin rod"):
        report('parts = [{ shape = "rod", mass = "1 kg", length = "1 m" }]', "damping = 0.1")


@pytest.mark.long
def test_stiff_losses_are_announced(report, monkeypatch, capsys):
    """They ran for over 100 s without a word: steps are as short as the fastest loss is quick, with nothing to lose."""
    monkeypatch.setattr(length, "LIMITS", length.LengthLimits(watched_seconds=0.02, long_seconds=0.05))
    report(TRIAXIAL, "damping = 1e4", 'angular_velocity = ["0.1 rad/s", "0.1 rad/s", "1 rad/s"]', 'until = "60 s"')
    assert "this takes about" in capsys.readouterr().err


def test_a_sweep_of_the_flat_spin_moves_nothing(tmp_path, monkeypatch):
    """Eight samples of .067 s took 91 s, as each body was moved through its whole motion."""
    path = tmp_path / "sweep.toml"
    path.write_text(
        f'[body]\n{TRIAXIAL}\n[system]\nkind = "damped-body"\ndamping_time = "40 s"\n'
        '[spin]\nrate = "3 rad/s"\nabout = 1\ntilt = "5 deg"\n[time]\nuntil = "1 s"\nsamples = 2\n'
        '[sweep]\nsamples = 3\nseed = 1\n'
        'outputs = ["flat_spin_time.energy_sink", "axes.3.time_constant", "time_constant"]\n'
        '[sweep.inputs]\n"spin.tilt" = { uniform = ["0.5 deg", "5 deg"] }\n',
        "utf-8",
    )
    evaluator = Evaluator(read_plan(path))
    inputs = evaluator.draw_inputs(0, 3)
    wanted = [evaluator.make_spec(inputs, k).report().as_json_dict() for k in range(2)]

    def moved(*given, **more):
        raise AssertionError("a motion was computed")

    monkeypatch.setattr("polhode.spacecraft.damped_body.answers.simulate", moved)
    values = evaluator.chunk(0, 3).values
    for k, one in enumerate(wanted):
        assert values["flat_spin_time.energy_sink"][k] == one["flat_spin_time"]["energy_sink"]
        assert values["axes.3.time_constant"][k] == one["axes"][2]["time_constant"]
        assert values["time_constant"][k] == one["time_constant"]
