"""Reports from Python: the numbers of the command, shown in a notebook, without files."""

import json
import shutil
from contextlib import nullcontext
from pathlib import Path

import jaxtyping
import numpy as np
import pytest

import polhode as ph
from polhode import rotation
from polhode.celestial.tumbling.study import Friction
from polhode.cli.main import main
from polhode.errors import InvalidInput
from polhode.motion._layout import ATTITUDE, StateLayout
from polhode.motion._trajectory import Trajectory
from polhode.reports.report import PlainReport
from polhode.studies import sources

EXAMPLES = Path(__file__).parents[1] / "examples"
PHONE, WATER = EXAMPLES / "phone_throw.csv", EXAMPLES / "water_spectrum.toml"
KEYS = {"name", "kind", "summary", "units", "notes"}


def said_by(capsys, *arguments):
    with pytest.raises(SystemExit) as end:
        main([*map(str, arguments), "--json"])
    assert not end.value.code
    return json.loads(capsys.readouterr().out)


@pytest.mark.long
def test_a_tumbler_is_that_of_the_command(capsys):
    found = ph.tumble("apophis", friction=Friction(340.0))
    said = said_by(capsys, "tumble", "apophis", "--diameter", "340 m")
    wanted = json.loads(found.json())
    assert '`mode="long-axis"` takes the other' in wanted["notes"][0]
    wanted["notes"][0] = wanted["notes"][0].replace('`mode="long-axis"`', "--mode long-axis")
    assert said.pop("files") == [] and said == wanted
    assert KEYS <= said.keys() and said["kind"] == "tumble" and found.determined
    by_hand = ph.tumble(precession="27.38 ± 0.07 h", rotation=(263 * 3600.0, 6 * 3600.0),
                        moments=("0.61 ± 0.03", 0.965, 1.0))  # fmt: skip
    assert by_hand.values()["energy_ratio"] == pytest.approx(found.values()["energy_ratio"], rel=1e-2)


def test_a_notebook_shows_it():
    found = ph.tumble("apophis")
    shown = found._repr_html_()
    assert shown.count("<table>") >= 4 and "Apophis" in shown and found.summary[:20] in shown
    assert set(found.plot()) == {"polhode", "light_curve", "spectrum"}
    assert "<script>" not in PlainReport("<script>", "x", "", [])._repr_html_()


@pytest.mark.parametrize(
    ("given", "words"),
    [
        ({}, "`precession` and `rotation` and `moments` are missing"),
        ({"precession": -1.0, "rotation": 2.0, "moments": (1, 2, 2.5)}, "`precession` must be positive; got -1.0"),
        ({"precession": 1.0, "rotation": "2 ± x h", "moments": (1, 2, 2.5)}, "`rotation`"),
        ({"precession": 1.0, "rotation": (2.0, -1.0), "moments": (1, 2, 2.5)}, "`rotation` must not have a negative"),
        ({"precession": 1.0, "rotation": 2.0, "moments": (1, 2, 2.5), "semi_axes": (1, 1, 1)}, "both give the moments"),
        ({"precession": 1.0, "rotation": 2.0, "semi_axes": (1, 0, 1)}, "three positive numbers"),
        ({"body": "apophis", "mode": "tumbling"}, "`mode` must be \"short-axis\" or \"long-axis\"; got 'tumbling'"),
        ({"body": "apophis", "aspect": 60.0}, "`aspect` must be from 0 to 3.142, 180°, .rad.; got 60"),
        ({"body": "apophis", "rotation": (1.0, 2.0, 3.0)}, "a number, one with its standard deviation, or a text"),
        ({"body": 5}, "no tumbler is called '5'"),
    ],
)
def test_mistakes_name_the_argument(given, words, monkeypatch):
    monkeypatch.setattr(jaxtyping.config, "jaxtyping_disable", True)  # as nobody checks the types of a user's numbers
    with pytest.raises(InvalidInput, match=words):
        ph.tumble(**given)


@pytest.mark.sweep
def test_a_report_on_a_spec_is_that_of_the_command(capsys, tmp_path):
    spec = EXAMPLES / "t_handle.toml"
    found = ph.report(spec)
    said = said_by(capsys, "report", spec, "--out", tmp_path / "by_command")
    assert said.pop("files") and said.pop("removed") == [] and said == json.loads(found.json())
    written = found.write(tmp_path / "by_python")
    names = {path.name for path in (tmp_path / "by_command").iterdir()}
    assert {path.name for path in written} == names
    assert set(found.plot()) == {Path(name).stem for name in names} - {"motion"}
    for path in written:
        assert path.suffix == ".nc" or path.read_bytes() == (tmp_path / "by_command" / path.name).read_bytes()
    with pytest.raises(InvalidInput, match=r"`name` must be one of .*momentum_sphere.* in a report of kind free-body"):
        found.figure("tilt")


@pytest.mark.long
def test_a_fit_is_that_of_the_command(capsys):
    found = ph.fit(EXAMPLES / "phone_throw.csv", moment="I3 = 1.2e-4 kg m^2")
    said = said_by(capsys, "fit", EXAMPLES / "phone_throw.csv", "--moment", "I3 = 1.2e-4 kg m^2")
    assert said.pop("files") == [] and said == json.loads(found.json()) and found.determined
    assert found.values()["moments"]["value"][2] == 1.2e-4 and "corner" in found.figures()


@pytest.mark.parametrize(
    ("files", "given", "words"),
    [
        ((), {}, "`files` is empty"),
        (("phone_throw.csv",), {"free": ("A",)}, "`free` names constants of a molecule"),
        (("phone_throw.csv",), {"torque": True}, "`torque` is for a log of attitudes"),
        (("phone_throw.csv",), {"clip": -1.0}, "`clip` must be positive .rad/s.; got -1"),
        (("phone_throw.csv",), {"windows": [(1.0, 2.0, 3.0)]}, "`windows` must be two times"),
        (("phone_throw.csv",), {"mass": "1 kg"}, "`mass`, `added_weight` and `weighted` belong together"),
        (("phone_throw.csv",), {"moment": "I4 = 1 kg m^2"}, "`moment` must be like"),
        (("water.xyz", "phone_throw.csv"), {"drag": False}, "`drag` is for gyro logs, and .*water.xyz is a molecule"),
        (("water.xyz",), {}, "a molecule is fitted to one file of lines; got 0"),
    ],
)
def test_mistakes_of_fits_name_the_argument(files, given, words, monkeypatch):
    monkeypatch.setattr(jaxtyping.config, "jaxtyping_disable", True)
    with pytest.raises(InvalidInput, match=words):
        ph.fit(*(EXAMPLES / name for name in files), **given)


def test_tables_are_compared_by_their_columns(tmp_path):
    table, words = tmp_path / "a.csv", {"time": "t", "time_unit": "s", "quat": "a,b,c,d", "order": "wxyz"}
    motion = ph.FreeMotion((1.0, 2.0, 3.0), momentum=(0.3, 1.8, 1.5))
    found = motion.sample([0.1 * k for k in range(40)])
    rows = zip(found.times.tolist(), found.attitude.tolist(), strict=True)
    table.write_text("t,a,b,c,d\n" + "".join(f"{time},{','.join(map(repr, q))}\n" for time, q in rows))
    assert ph.compare(table, motion, columns=words).comparison.largest < 1e-12
    assert ph.compare(table, table, columns=words).comparison.is_rounding
    with pytest.raises(InvalidInput, match="`columns` must be left out where neither is a file"):
        ph.compare(found, motion, columns=words)


@pytest.mark.long
def test_files_and_motions_are_compared(capsys, tmp_path):
    spec = EXAMPLES / "t_handle.toml"
    motion = ph.report(spec).trajectory
    found = ph.compare(motion, motion.motion)
    assert found.comparison.is_rounding and found.kind == "comparison" and "comparison" in found.figures()
    by_files = ph.compare(spec, spec)
    said = said_by(capsys, "compare", spec, spec, "--figures", tmp_path / "out")
    assert said.pop("files") == [str(tmp_path / "out" / "comparison.png")] and said == json.loads(by_files.json())
    assert ph.compare(str(spec), by_files_history(spec)).comparison.is_rounding
    with pytest.raises(InvalidInput, match="`offset` must be a time in seconds where not both are files; got 'start'"):
        ph.compare(motion, spec, offset="start")
    with pytest.raises(InvalidInput, match="`spec` must be left out where not both are files"):
        ph.compare(motion, spec, spec=spec)
    with pytest.raises(InvalidInput, match="a report of kind comparison has no data to save"):
        found.save(tmp_path / "out.nc")


def by_files_history(spec):
    moved = ph.report(spec).trajectory.along("given")
    return ph.analysis.AttitudeHistory("samples", np.asarray(moved.times), np.asarray(moved.attitude))


@pytest.mark.long
def test_levels_and_lines_are_those_of_the_commands(capsys, tmp_path):
    water = EXAMPLES / "water_spectrum.toml"
    for found, arguments in ((ph.levels(water, j_max=3), ("levels", water, "--j-max", 3)),
                             (ph.spectrum(water, highest="1 THz", temperature=250.0, j_max=6),
                              ("lines", water, "--to", "1 THz", "--temperature", "250 K", "--j-max", 6))):  # fmt: skip
        said = said_by(capsys, *arguments)
        assert said.pop("files") == [] and said == json.loads(found.json())
        assert {path.suffix for path in found.write(tmp_path / found.kind)} == {".png", ".nc"}
    assert ph.spectrum(ph.read_spec(water), highest=1e12, temperature="250 K", j_max=6).json() == found.json()
    with pytest.raises(InvalidInput, match="`lowest` must not be above `highest`; got 2 THz and 1 THz"):
        ph.spectrum(water, lowest="2 THz", highest="1 THz")
    with pytest.raises(InvalidInput, match=r"Give one, like `dipole=\(0, 1.857, 0\)`"):
        ph.spectrum(EXAMPLES / "water.xyz")
    with pytest.raises(InvalidInput, match="`dipole` must be three numbers in debye"):
        ph.spectrum(water, dipole=(1.0, 2.0))


@pytest.mark.long
def test_nothing_is_saved_over_what_was_read(tmp_path):
    for name in ("t_handle.toml", "t_handle.stl", "phone_throw.csv", "water.xyz"):
        shutil.copy(EXAMPLES / name, tmp_path / name)
    made = {
        "t_handle.stl": ph.report(tmp_path / "t_handle.toml"), "phone_throw.csv": ph.fit(tmp_path / "phone_throw.csv"),
        "water.xyz": ph.levels(tmp_path / "water.xyz", j_max=2),
    }  # fmt: skip
    for name, report in made.items():
        with pytest.raises(InvalidInput, match=f"{name}: is the file that was read; writing would destroy it"):
            report.save(tmp_path / name)
        assert (tmp_path / name).read_bytes() == (EXAMPLES / name).read_bytes()
        assert report.save(tmp_path / "new.nc").is_file() and len(repr(report)) < 500


@pytest.mark.long_cases("None")
@pytest.mark.parametrize("wrong", [None, 3, "", ["a"]])
def test_what_is_no_path_is_refused(wrong, monkeypatch):
    monkeypatch.setattr(jaxtyping.config, "jaxtyping_disable", True)
    found = ph.report(EXAMPLES / "t_handle.toml")
    calls = [found.save, found.write, ph.fit, ph.levels, ph.spectrum, lambda path: ph.fit("a", weighted=[path])]
    for call in calls:
        with pytest.raises(InvalidInput, match="must be the path of a file or folder"):
            call(wrong)
    with pytest.raises(InvalidInput, match=r"must end in \.aem, .*\.nc"):
        found.save("motion.txt")


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda: ph.fit("a", windows=3), "`windows` must be a list"),
        (lambda: ph.fit("a", moment=3), "`moment` must be a text"),
        (lambda: ph.fit("a", columns=3), "`columns` must be words by name"),
        (lambda: ph.fit(PHONE, PHONE), "phone_throw.csv: is given twice"),
        (lambda: ph.tumble("apophis", moments=3), "`moments` must be three quantities"),
        (lambda: ph.tumble("apophis", friction=3), "`friction` must be"),
        (lambda: ph.tumble("apophis", aspect="60 deg"), "`aspect` must be .*; got '60 deg'. Functions take SI"),
        (lambda: ph.wobble(start=3), "`start` must be a day"),
        (lambda: ph.wobble(window="x"), "`window` must be positive .years.; got 'x'"),
        (lambda: ph.spectrum(WATER, most=-1), "`most` must be a whole number"),
        (lambda: ph.spectrum(WATER, most=1.5), "`most` must be a whole number"),
        (lambda: ph.spectrum(WATER, min_intensity="x"), "`min_intensity` must be finite and not negative"),
        (lambda: ph.spectrum(WATER, dipole=3), "`dipole` must be three numbers"),
        (lambda: ph.spectrum(WATER, temperature=float("nan")), "`temperature` must be a number; got nan"),
        (lambda: ph.spectrum(WATER, temperature=[3]), "`temperature` must be a number, or a text with its unit"),
        (lambda: ph.compare(WATER, WATER, offset=[1]), "`offset` must be a time"),
        (lambda: ph.compare(WATER, WATER, offset="x"), "`offset` must be `start`"),
    ],
)
def test_wrong_types_are_refused_by_name(call, words, monkeypatch):
    monkeypatch.setattr(jaxtyping.config, "jaxtyping_disable", True)
    with pytest.raises(InvalidInput, match=words):
        call()


def test_a_temperature_that_is_the_spec_s_changes_nothing():
    assert ph.spectrum(WATER).json() == ph.spectrum(WATER, temperature=300.0).json()


def test_histories_in_any_order_are_compared():
    motion = ph.FreeMotion((1.0, 2.0, 3.0), momentum=(0.3, 1.8, 1.5))
    rising, falling = motion.sample(np.linspace(0.0, 10.0, 101)), motion.sample(np.linspace(9.0, 1.0, 81))
    mixed = motion.sample([0.0, 5.0, 2.0, 7.0])
    for one, other in ((rising, falling), (falling, rising), (mixed, rising)):
        assert ph.compare(one, other).comparison.largest < 1e-3
    with pytest.raises(InvalidInput, match="has two samples at 2 s"):
        ph.compare(rising, motion.sample([0.0, 2.0, 1.0, 2.0]))


@pytest.mark.long
def test_a_spec_of_another_body_is_told(tmp_path):
    box = '[body]\nmoments = ["1 kg*m^2", "2 kg*m^2", "{} kg*m^2"]\n[spin]\nrate = "1 rad/s"\nabout = 2\n'
    for name, moment in (("one", 3), ("other", 2.9)):
        (tmp_path / f"{name}.toml").write_text(box.format(moment) + '[time]\nuntil = "3 s"\nsamples = 31\n')
    ph.report(tmp_path / "one.toml").save(tmp_path / "one.nc")
    told = ph.compare(tmp_path / "one.nc", tmp_path / "one.nc", spec=tmp_path / "other.toml").notes
    assert "the moments of" in told[0] and told[0].endswith("are not those that one.nc has.")
    assert not any("the moments of" in note for note in
                   ph.compare(tmp_path / "one.nc", tmp_path / "one.nc", spec=tmp_path / "one.toml").notes)  # fmt: skip


@pytest.mark.long_cases("report")
@pytest.mark.parametrize("command", ["body", "report"])
def test_every_json_has_the_same_keys(command, capsys, tmp_path):
    (tmp_path / "box.toml").write_text(
        '[body]\nmoments = ["1 kg*m^2", "2 kg*m^2", "3 kg*m^2"]\n'
        '[spin]\nangular_velocity = ["0.1 rad/s", "1 rad/s", "0 rad/s"]\n'
    )
    out = [] if command == "body" else ["--out", tmp_path / "out"]
    said = said_by(capsys, command, tmp_path / "box.toml", *out)
    assert KEYS | {"files"} <= said.keys()


def test_data_go_only_where_the_ending_says_what_they_are(tmp_path):
    report = ph.levels(WATER, j_max=1)
    with pytest.raises(InvalidInput, match=r"must end in \.nc"):
        report.save(tmp_path / "levels.csv")
    assert not list(tmp_path.iterdir()) and report.save(tmp_path / "LEVELS.NC").exists()


@pytest.mark.parametrize("factor, refused", [(0.9, False), (1.1, True)])
def test_two_attitudes_of_one_time_are_equal_up_to_seven_digits(factor, refused):
    turn = factor * sources.LIMITS.max_attitude_difference
    attitude = rotation.from_rotation_vector([[0.0, 0.0, 0.0], [0.0, 0.0, turn], [0.0, 0.0, 1.0]])
    recorded = Trajectory(np.array([0.0, 0.0, 1.0]), attitude, StateLayout((ATTITUDE,)), attitude)
    with pytest.raises(InvalidInput, match="two attitudes at 0 s") if refused else nullcontext():
        assert len(sources._history(Path("a.csv"), recorded).times) == 2
