"""Reports of rolling disks against textbook formulas, and what a spec of one may not say."""

import math
from typing import Any

import jax.numpy as jnp
import matplotlib.image
import numpy as np
import pytest

from polhode.cli.main import main
from polhode.errors import InvalidInput
from polhode.kinds.reading import read_spec
from polhode.reports.answer import Table
from polhode.rolling.euler_disk.end_figure import draw_disk_end
from polhode.rolling.euler_disk.path_figure import draw_contact_path

M, A, G, TILT = 0.4, 0.04, 9.80665, 0.05
THIN = f'mass = "{M} kg"\nradius = "{A} m"'
INTEGRALS = 1e-10
BALANCE = 1e-10
SAME_END = 1e-9  # of runs in time and by the disk's own clock
FORMULA = 1e-12  # closed forms, a few roundings each


def report_on(spec) -> Any:
    return spec.report()


@pytest.fixture
def read(tmp_path):
    def reader(keys, rest=""):
        path = tmp_path / "case.toml"
        path.write_text(f'[system]\nkind = "euler-disk"\n{keys}\n{rest}', "utf-8")
        return read_spec(path)

    return reader


@pytest.fixture(scope="module")
def ended(tmp_path_factory):
    """A thin disk under viscous contour friction, to its end."""
    path = tmp_path_factory.mktemp("disk") / "case.toml"
    law = 'dissipation = [{law = "viscous-contour-friction", coefficient = "2e-7 W*s^2"}]'
    path.write_text(f'[system]\nkind = "euler-disk"\n{THIN}\ntilt = "{TILT} rad"\n{law}\n[time]\nsamples = 600')
    return report_on(read_spec(path))


@pytest.mark.sweep
def test_steady_rolling_of_a_thin_disk(read):
    values = report_on(read(f'{THIN}\ntilt = "0.3 rad"\nheading = "90 deg"')).as_json_dict()
    s, rate = math.sin(0.3), math.sqrt(4 * G / (A * math.sin(0.3)))
    start, steady = values["start"], values["steady"]
    assert start["precession"] == pytest.approx(rate, rel=FORMULA) and start["spin"] == 0.0
    assert start["heading"] == math.pi / 2 and start["angular_velocity"] == pytest.approx(rate * s, rel=FORMULA)
    assert start["face_rate"] == pytest.approx(rate * (1 - math.cos(0.3)), rel=FORMULA)
    assert start["energy"] == pytest.approx(1.5 * M * G * A * s, rel=FORMULA)
    assert start["normal_force"] == pytest.approx(M * G, rel=FORMULA)
    assert (steady["nutation"] / rate) ** 2 == pytest.approx(3 / 5 + s * s / 5, rel=FORMULA)
    assert steady["stability"]["verdict"] == "stable" and "J2" in steady["stability"]["certificate"]
    assert values["spin_down"] is None and values["laws"] == [] and values["critical_rolling_speed"] is None
    assert set(values["drift"]) == {"energy", "linear_integral_1", "linear_integral_2"}
    assert max(values["drift"].values()) < INTEGRALS
    assert values["end_time"] == pytest.approx(20 * math.pi / steady["nutation"], rel=FORMULA)
    assert values["normal_force_minimum_of_weight"] == pytest.approx(1.0, abs=1e-9)


@pytest.mark.sweep
def test_upright_rolling_falls_over_below_the_critical_speed(read):
    """Straight along its heading: v² = ga/3."""
    critical = math.sqrt(G * A / 3)
    for factor, word in ((0.99, "unstable"), (1.01, "stable")):
        rates = f'precession = "0 rad/s"\nspin = "{factor * critical / A} rad/s"'
        report = report_on(read(f'{THIN}\ntilt = "90 deg"\n{rates}', '[time]\nuntil = "0.2 s"\nsamples = 11'))
        values = report.as_json_dict()
        assert values["steady"]["stability"]["verdict"] == word
        assert values["critical_rolling_speed"] == pytest.approx(critical, rel=FORMULA)
        assert values["critical_spin_rate"] == pytest.approx(math.sqrt(G / (1.25 * A)), rel=FORMULA)
        way = np.linalg.norm(np.asarray(report.path.states)[-1, 3:5])
        assert way == pytest.approx(factor * critical * 0.2, rel=1e-9)


@pytest.mark.sweep
def test_how_a_disk_ends(ended):
    values = ended.as_json_dict()
    down = values["spin_down"]
    assert down["end"] == pytest.approx(3 * M * A**2 * TILT**2 / (16 * 2e-7), rel=TILT)  # first order in the tilt
    assert down["end_by_energy"] == pytest.approx(down["end"], rel=TILT) and 0 < down["end_uncertainty"] < 0.01
    assert down["first_event"] == "end of asymptotic regime" and list(down["events"])[1:] == ["flat"]
    assert down["dominant_law"] == "viscous-contour-friction"
    for key, wanted in (("tilt", 0.5), ("precession", -0.25), ("precession_by_tilt", -0.5)):
        fit = down[f"{key}_exponent"]
        assert fit["predicted"] == wanted and abs(fit["fitted"] / wanted - 1) < 0.01
    (law,) = values["laws"]
    assert law["share"] == law["share_late"] == 1.0 and law["exponent"] == 0.5
    assert law["power"] == pytest.approx(2e-7 * 4 * G / (A * math.sin(TILT)), rel=FORMULA)
    assert down["energy_balance"] < BALANCE and values["drift"]["energy"] < BALANCE
    assert 0.19 < values["normal_force_minimum_of_weight"] < 0.5
    # the rest is that of its fall about the rim
    assert 0.0 < values["end_energy"] < 0.03 * values["start"]["energy"] and values["status"] == "flat"
    assert ended.notes == [] and "lies flat after 1.50" in values["summary"]
    text = str([group.cells if isinstance(group, Table) else group.lines for group in ended.answers])
    assert "not −1" in text and "1/2 (viscous-contour-friction)" in text


@pytest.mark.sweep
def test_the_path_is_the_last_turns_of_the_same_motion(ended):
    """Stepped again from a sample on the way, it ends where the other did, but for rounding that the end amplifies."""
    path, whole = ended.path, ended.trajectory
    assert path.outcome.event == "flat" and path.times[-1] == pytest.approx(whole.times[-1], rel=1e-9)
    turns = (path.states[-1, 1] - path.states[0, 1]) / (2 * math.pi)
    assert 12 <= turns < 16 and np.diff(path.times)[:-1] == pytest.approx(path.times[1] - path.times[0], rel=1e-6)
    assert np.abs(path.states[-1, 3:5] - np.asarray(whole.states)[-1, 3:5]).max() < 1e-6 * A
    way = np.hypot(*np.diff(path.states[:, 3:5], axis=0).T).sum()
    assert way == pytest.approx(turns * 2 * math.pi * A, rel=0.01)  # it touches along its whole rim
    first = ended.opening.states[:, 3:5]
    assert np.abs(first[-1] - first[0]).max() < 0.05 * A  # in the time of a turn at the first rate, which grows
    assert np.ptp(first[:, 0]) == pytest.approx(2 * A * math.cos(TILT), rel=1e-3)


@pytest.mark.sweep
def test_figures_say_what_they_show(ended, tmp_path):
    for path in ended.draw(tmp_path):
        picture = matplotlib.image.imread(path)
        assert picture.shape[0] > 500 and picture[..., :3].std() > 0.02
    upper, lower = draw_disk_end(ended).axes
    assert "[°]" in upper.get_ylabel() and "[rad/s]" in lower.get_ylabel() and "[s]" in lower.get_xlabel()
    assert upper.get_xscale() == upper.get_yscale() == "log"
    assert {"end of asymptotic regime", "motion"} <= set(upper.get_legend_handles_labels()[1])
    motion, fit = upper.lines[0], upper.lines[1]
    # the line of the fit lies on the motion where it was fitted
    x, y = (np.asarray(values) for values in fit.get_data())
    times, tilts = (np.log(np.asarray(values)[::-1]) for values in motion.get_data())
    assert np.interp(np.log(x[:20]), times, tilts) == pytest.approx(np.log(y[:20]), abs=0.01)
    plane = draw_contact_path(ended).axes[0]
    assert "[mm]" in plane.get_xlabel() and "[mm]" in plane.get_ylabel()


@pytest.mark.sweep
def test_mixed_laws_are_told_with_their_shares(read):
    """A thick disk: powers by hand; the note says that predictions are for one law and a thin disk."""
    laws = '[{law = "air-layer", viscosity = "18 uPa*s"}, {law = "rolling-couple", arm = "0.1 mm"}]'
    report = report_on(read(f'{THIN}\nthickness = "8 mm"\ntilt = "0.04 rad"\ndissipation = {laws}'))
    values = report.as_json_dict()
    air = math.pi * 18e-6 * G * A**2 / 0.04**2
    couple = 1e-4 * M * G * values["start"]["precession"] * math.sin(0.04)
    assert [law["power"] for law in values["laws"]] == pytest.approx([air, couple], rel=FORMULA)
    assert values["laws"][0]["share"] == pytest.approx(air / (air + couple), rel=FORMULA)
    late = [law["share_late"] for law in values["laws"]]
    assert sum(late) == pytest.approx(1.0) and late[0] > values["laws"][0]["share"]
    dominant = values["laws"][int(np.argmax(late))]
    assert values["spin_down"]["dominant_law"] == dominant["law"]
    assert values["spin_down"]["tilt_exponent"]["predicted"] == dominant["exponent"]
    assert any("thin disk" in note for note in report.notes)


@pytest.mark.sweep
def test_any_start_is_watched_for_a_time(read):
    rates = 'precession = "10 rad/s"\nspin = "-12 rad/s"\ntilt_rate = "1 rad/s"'
    law = 'dissipation = [{law = "viscous-contour-friction", coefficient = "2e-7 W*s^2"}]'
    report = report_on(read(f'{THIN}\ntilt = "40 deg"\n{rates}\n{law}', '[time]\nuntil = "0.5 s"\nsamples = 20'))
    values = report.as_json_dict()
    assert (values["start"]["tilt_rate"], values["start"]["spin"]) == (1.0, -12.0) and values["end_time"] == 0.5
    assert values["spin_down"] is None and values["end_energy"] < values["start"]["energy"]
    assert values["drift"]["energy"] < BALANCE
    assert values["steady"]["spin"] != -12.0 and values["steady"]["precession"] == pytest.approx(10.0, rel=FORMULA)


@pytest.mark.sweep
def test_a_time_after_the_stop_ends_at_the_stop(read, ended):
    law = 'dissipation = [{law = "viscous-contour-friction", coefficient = "2e-7 W*s^2"}]'
    report = report_on(read(f'{THIN}\ntilt = "{TILT} rad"\n{law}', '[time]\nuntil = "1e12 s"\nsamples = 40'))
    values = report.as_json_dict()
    assert values["status"] == "flat" and len(report.trajectory.times) == 40
    assert values["end_time"] == pytest.approx(ended.spin_down.events["flat"], rel=SAME_END)
    assert "ends: flat" in report.summary


@pytest.mark.parametrize(
    ("law", "name", "wanted"),
    [
        ('law = "air-layer", viscosity = "0.018 cP"', "viscosity", 1.8e-5),
        ('law = "boundary-layer", coefficient = "2 nW*s^2.5"', "coefficient", 2e-9),
        ('law = "viscous-contour-friction", coefficient = "3e-8 N*m*s"', "coefficient", 3e-8),
        ('law = "dry-contour-friction", coefficient = 1e-4', "coefficient", 1e-4),
        ('law = "rolling-couple", arm = "20 um"', "arm", 2e-5),
        ('law = "drilling-friction", arm = "1 mm"', "arm", 1e-3),
    ],
)
def test_each_law_has_its_key_and_unit(read, law, name, wanted):
    (table,) = read(f'{THIN}\ntilt = "5 deg"\ndissipation = [{{{law}}}]').system.dissipation
    assert float(getattr(table.build(), name)) == pytest.approx(wanted, rel=1e-15)


RIGHT = 'tilt = "5 deg"'


@pytest.mark.parametrize(
    ("keys", "words"),
    [
        (f'{THIN}\n{RIGHT}\nthickness = "0.1 m"', ["system.thickness: must be at most the diameter, 0.08 m"]),
        (f'{THIN}\n{RIGHT}\nthickness = "-1 mm"', ["system.thickness: must not be negative"]),
        (f'{THIN}\ntilt = "0 deg"', ["system.tilt: must lie between 0 and 180 deg", "lies flat"]),
        (f'{THIN}\ntilt = "91 deg"\nthickness = "1 mm"', ["system.tilt: of a thick disk", "turn it over"]),
        (f'{THIN}\n{RIGHT}\nspin = "3 rad/s"', ["system.spin: goes with precession"]),
        (f'{THIN}\n{RIGHT}\ntilt_rate = "3 rad/s"', ["system.tilt_rate", "needs precession and spin"]),
        (f'{THIN}\n{RIGHT}\ndissipation = [{{law = "air"}}]', ['dissipation.1.law: must be one of "air-layer"']),
        (f'{THIN}\n{RIGHT}\ndissipation = [{{law = "air-layer", arm = "1 mm"}}]',
         ["dissipation.1: air-layer needs viscosity", "air-layer has no arm; it takes viscosity"]),
        (f'{THIN}\n{RIGHT}\ndissipation = [{{law = "boundary-layer", coefficient = "1 W*s^2"}}]',
         ["dissipation.1.coefficient: has the wrong unit", "W*s^2.5"]),
        (f'{THIN}\n{RIGHT}\ndissipation = [{{law = "dry-contour-friction", coefficient = "1"}}]',
         ["dissipation.1.coefficient: must be a plain finite number"]),
        (f'{THIN}\n{RIGHT}\ndissipation = [{{law = "dry-contour-friction", coefficient = 0.0}}]',
         ["dissipation.1.coefficient: must be positive", "Leave the law out"]),
        (f'{THIN}\n{RIGHT}\ndissipation = {{law = "air-layer"}}', ["system.dissipation: must be a list"]),
        (f'{THIN}\n{RIGHT}\n[body]\nmass = "1 kg"', ["body: does not go with the system euler-disk"]),
        ('mass = "1 kg"\nwidth = "3 m"',
         ["system.width: unknown key", "system.radius: is missing", "system.tilt: is missing"]),
        (f'{THIN.replace("0.04", "-0.04")}\ntilt = "0 deg"\nspin = "1 Hz"\ndissipation = [{{}}]',
         ["system.radius: must be positive", "system.tilt: must lie", "system.spin: goes with", "system.spin: is ambig",
          "dissipation.1.law: is missing"]),
    ],
)  # fmt: skip
def test_specs_that_say_it_wrong(read, keys, words):
    with pytest.raises(InvalidInput) as caught:
        read(keys)
    assert not [word for word in words if word not in str(caught.value)], str(caught.value)


@pytest.mark.parametrize(
    ("keys", "words"),
    [
        ('tilt = "0.3 rad"\ncenter_velocity = ["0.1 m/s", "0 m/s", "0 m/s"]', ["does not roll", "slip at 0.1 m/s"]),
        ('tilt = "0.3 rad"\nprecession = "20 rad/s"\nspin = "1 rad/s"', ["not steady", "one of the rates only"]),
        ('tilt = "0.3 rad"\nprecession = "40 rad/s"\nspin = "-60 rad/s"\ntilt_rate = "-90 rad/s"',
         ["leaves the plane"]),
        ('tilt = "0.3 rad"\naxial_moment = "1 kg*m^2"\ndiametral_moment = "0.1 kg*m^2"', ["at most twice"]),
        ('tilt = "0.3 rad"\ndissipation = [{law = "air-layer", viscosity = "10 Pa*s"}]',
         ["not in the asymptotic regime", "[time] until"]),
    ],
)  # fmt: skip
def test_starts_that_are_none(read, keys, words):
    spec = read(f"{THIN}\n{keys}")
    with pytest.raises(InvalidInput) as caught:
        spec.report()
    assert not [word for word in words if word not in str(caught.value)], str(caught.value)


@pytest.mark.sweep
def test_the_right_velocity_of_the_centre_is_taken(read):
    """Upright and straight ahead the centre moves at aω against the heading, by the sign of its spin."""
    rates = 'precession = "0 rad/s"\nspin = "30 rad/s"\ncenter_velocity = ["-1.2 m/s", "0 m/s", "0 m/s"]'
    report = report_on(read(f'{THIN}\ntilt = "90 deg"\n{rates}', '[time]\nuntil = "0.2 s"\nsamples = 11'))
    assert float(jnp.abs(report.disk.center_velocity(report.trajectory.states[0])[0] + 1.2)) < 1e-12


def test_a_mistake_ends_with_code_two(tmp_path, capsys):
    path = tmp_path / "case.toml"
    path.write_text(f'[system]\nkind = "euler-disk"\n{THIN}\ntilt = "0 deg"\nthickness = "1 m"')
    with pytest.raises(SystemExit) as stopped:
        main(["report", str(path)])
    assert stopped.value.code == 2
    said = capsys.readouterr().err
    assert "2 mistakes" in said and "system.tilt" in said and "system.thickness" in said
