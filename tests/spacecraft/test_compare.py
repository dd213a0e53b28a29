"""``polhode import`` and ``polhode compare`` on files of every kind, and on others."""

import json
import shutil
from dataclasses import replace

import numpy as np
import pytest
import spiceypy as spice

from polhode import FreeMotion, rotation
from polhode.cli.main import main
from polhode.errors import InvalidInput
from polhode.formats.csv_table import write_csv
from polhode.formats.dataset import write_dataset
from polhode.formats.dataset_reading import read_dataset
from polhode.formats.form import Kernels
from polhode.formats.labels import AttitudeLabels
from polhode.kinds.base import AbstractKind
from polhode.kinds.reading import read_spec
from polhode.kinds.registry import find_kind
from polhode.spacecraft.formats.aem import write_aem
from polhode.spacecraft.formats.aem_reading import read_aem
from polhode.spacecraft.formats.spice import write_ck
from polhode.spacecraft.formats.spice_reading import read_ck
from polhode.studies.sources import load_source
from sweeping import first

EXACT = 1e-12  # rad and relative
AXIS = np.array([2.0, -1.0, 2.0]) / 3.0
BOX = """
[body]
parts = [
  { shape = "box", mass = "2 kg", size = ["10 cm", "20 cm", "40 cm"] },
  { shape = "sphere", mass = "1 kg", radius = "3 cm", at = ["5 cm", "10 cm", "20 cm"] },
]
[spin]
angular_velocity = ["0.1 rad/s", "0.4 rad/s", "0.2 rad/s"]
[time]
until = "60 s"
samples = 500
"""
TOP = """
[body]
parts = [{ shape = "cone", mass = "0.2 kg", radius = "3 cm", height = "6 cm", at = ["0 cm", "0 cm", "4 cm"] }]
[system]
kind = "KIND"
pivot = ["0 cm", "0 cm", "0 cm"]
lean = "20 deg"
[spin]
rate = "100 rad/s"
about = "z"
[time]
until = "0.5 s"
samples = 400
"""
GYROSTAT = """
[system]
kind = "gyrostat"
rotor_axis = [0, 0, 1]
rotor_moment = "1e-4 kg*m^2"
rotor_rate = "60 rpm"
"""


def run(arguments, capsys):
    with pytest.raises(SystemExit) as stopped:
        main(list(map(str, arguments)))
    out, err = capsys.readouterr()
    return stopped.value.code or 0, out, err


def values_of(arguments, capsys):
    code, out, err = run([*arguments, "--json"], capsys)
    assert code == 0, err
    return json.loads(out, parse_constant=lambda name: pytest.fail(name))


@pytest.fixture(scope="module")
def written(tmp_path_factory):
    """The motion of a spec in every kind of file, and an AEM that differs from it by a known turn and rate."""
    tmp_path = tmp_path_factory.mktemp("written")
    spec = tmp_path / "box.toml"
    spec.write_text(BOX)
    report = read_spec(spec).report()
    labels = AttitudeLabels(object_name="BOX", epoch="2026-03-01T12:00:00", spice_id=-321)
    write_aem(report.trajectory, tmp_path / "box.aem", labels=labels)
    write_ck(report.trajectory, tmp_path / "box.bc", labels=labels)
    write_dataset(report.trajectory, tmp_path / "own.nc", {})
    write_csv(report.trajectory, tmp_path / "own.csv")
    given = report.trajectory.along("given")
    turn = rotation.from_rotation_vector((1e-3 + 2e-5 * given.times)[:, None] * AXIS)
    turned = replace(given, attitude=rotation.multiply(turn, given.attitude))
    write_aem(turned, tmp_path / "turned.aem", labels=labels)
    write_aem(turned, tmp_path / "late.aem", labels=replace(labels, epoch="2026-03-01T12:01:39.184", time_system="TT"))
    return tmp_path


@pytest.fixture
def files(written, tmp_path, monkeypatch):
    """A folder with these files."""
    shutil.copytree(written, tmp_path, dirs_exist_ok=True)
    monkeypatch.chdir(tmp_path)
    return tmp_path


@pytest.mark.long_cases("False-box.aem", "False-own.csv", "False-box.toml")
@pytest.mark.parametrize("other", ["box.aem", "box.bc", "own.nc", "own.csv", "box.toml"])
@pytest.mark.parametrize("exact_first", first(1, [False, True]))
def test_every_kind_of_file_agrees_with_the_spec_that_it_is_from(files, capsys, other, exact_first):
    pair = ["box.toml", other] if exact_first else [other, "box.toml"]
    found = values_of(["compare", *pair], capsys)
    assert found["angle"]["largest"] <= EXACT and found["alignment"] is None
    assert found["times"] == {"first": 0.0, "last": 60.0, "samples": 500}
    for side, name in zip(found["invariants"], pair, strict=True):
        assert max(side["drift"].values()) <= (1e-4 if name == "box.aem" else EXACT)  # by a spline of coarse steps
    assert all((files / name).is_file() for name in found["files"])


@pytest.mark.long
def test_a_known_turn_and_rate_come_back(files, capsys):
    for other in ("box.toml", "box.bc", "box.aem"):
        found = values_of(["compare", "turned.aem", other, "--spec", "box.toml"], capsys)
        assert found["angle"]["first"] == pytest.approx(1e-3, abs=EXACT)
        assert found["angle"]["last"] == pytest.approx(1e-3 + 2e-5 * 60.0, abs=EXACT)
        assert found["growth"] == pytest.approx(2e-5, abs=EXACT)
        assert found["alignment"]["space"] == pytest.approx(1e-3 * AXIS, abs=EXACT)
        assert found["alignment"]["rate"] == pytest.approx(2e-5 * AXIS, abs=EXACT)
        assert found["alignment"]["explains"] and found["alignment"]["remaining"]["largest"] <= EXACT
        assert len(found["invariants"]) == 2 and None not in found["invariants"]
    code, out, _ = run(["compare", "turned.aem", "box.toml"], capsys)
    assert code == 0 and "explain all but" in out and "turning at" in out


def test_epochs_in_different_time_systems_are_laid_side_by_side(files, capsys):
    """12:01:39.184 TT is 12:00:30 UTC: thirty seconds, and 69.184 s of leap seconds and TT."""
    found = values_of(["compare", "box.bc", "late.aem"], capsys)
    assert "UTC and 2026-03-01T12:01:39.184 TT" in found["clocks"]
    assert (found["times"]["first"], found["times"]["last"]) == (pytest.approx(30.0, abs=0.13), 60.0)
    assert any("interpol" in note for note in [found["method"], *found["notes"]])


@pytest.mark.long_cases("UTC-2026-03-01 12:00:30")
@pytest.mark.parametrize(("system", "moment"), [("UTC", "2026-03-01 12:00:30"), ("TDB", "2026-03-01 12:00:30 TDB")])
def test_spice_itself_finds_an_exported_spec(files, capsys, system, moment):
    """Thirty seconds after the spec's epoch, to what SPICE's ephemeris time tells apart."""
    (files / "at.toml").write_text(BOX + f"""
[export]
epoch = "2026-03-01T12:00:00"
time_system = "{system}"
body_frame = "BOX_AXES"
spice_id = -42
""")
    code, out, _ = run(["export", "at.toml", "--to", "ck"], capsys)
    assert code == 0 and out.startswith("at.bc: 500 samples")
    kernels = [files / f"at.{ending}" for ending in ("bc", "tf", "tsc")]
    kernels.append(files / "box.tls")  # of another export: any leap seconds will do
    spec = read_spec(files / "at.toml")
    motion = FreeMotion.from_body(spec.body, angular_velocity=(0.1, 0.4, 0.2))
    try:
        for kernel in kernels:
            spice.furnsh(str(kernel))
        matrix = spice.pxform("J2000", "BOX_AXES", spice.str2et(moment))
    finally:
        spice.kclear()
    between = 0.5 * 0.46**2 * (60.0 / 499.0) ** 2  # SPICE turns at constant speed between samples
    assert np.abs(matrix - motion.rotation_matrix(30.0).T).max() <= between
    exact = values_of(["compare", "at.toml", "at.bc"], capsys)
    assert exact["angle"]["largest"] <= EXACT and exact["clocks"].startswith("both count from")


def test_an_exact_motion_is_found_by_its_epoch(files, capsys):
    """A part of the motion, from its twentieth second on, in a file that starts there."""
    (files / "at.toml").write_text(BOX + '[export]\nepoch = 2026-03-01T12:00:00\ntime_system = "TAI"\n')
    motion = FreeMotion.from_body(read_spec(files / "at.toml").body, angular_velocity=(0.1, 0.4, 0.2))
    part = motion.sample(np.linspace(20.0, 40.0, 81))
    labels = AttitudeLabels(epoch="2026-03-01T12:00:01", time_system="GPS")  # 19 s behind TAI
    write_aem(replace(part, times=part.times - 20.0), files / "part.aem", labels=labels)
    found = values_of(["compare", "at.toml", "part.aem"], capsys)
    assert found["angle"]["largest"] <= EXACT
    assert (found["times"]["first"], found["times"]["last"]) == (20.0, 40.0)


def test_no_time_in_common_is_one_error(files, capsys):
    motion = FreeMotion((1.0, 2.0, 3.0), momentum=(0.0, 0.1, 1.0))
    write_aem(motion.sample(np.linspace(0.0, 9.0, 20)), files / "other.aem",
              labels=AttitudeLabels(epoch="2027-01-01T00:00:00"))  # fmt: skip
    code, _, err = run(["compare", "box.aem", "other.aem"], capsys)
    assert code == 2 and "no time in common" in err and err.count("\n") == 1


@pytest.mark.long
@pytest.mark.parametrize("kind", first(1, ["lagrange-top", "heavy-top"]))
def test_tops_against_their_kernels(tmp_path, monkeypatch, capsys, kind):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "top.toml").write_text(TOP.replace("KIND", kind))
    report = read_spec(tmp_path / "top.toml").report()
    write_ck(report.trajectory, tmp_path / "top.bc")
    found = values_of(["compare", "top.bc", "top.toml"], capsys)
    assert found["angle"]["largest"] <= EXACT
    for side in found["invariants"]:
        assert set(side["drift"]) == {"energy", "vertical_momentum"}
        assert max(side["drift"].values()) <= (EXACT if kind == "lagrange-top" else 1e-4)  # of a splitting's steps
    assert any("without a closed form" in note for note in found["notes"]) == (kind == "heavy-top")


@pytest.mark.parametrize("name", ["box.aem", "box.bc"])
def test_import_says_what_is_there_and_writes_it(files, capsys, name):
    found = values_of(["import", name], capsys)
    assert (found["object"], found["samples"], found["last"]) == ("BOX", 500, 60.0)
    assert found["largest_gap"] == pytest.approx(60.0 / 499.0)
    assert found["has_angular_velocity"] == (name == "box.bc")
    back = read_dataset(files / "box_imported.nc")
    expected = read_spec(files / "box.toml").report().trajectory.along("given")
    assert rotation.angle_between(back.attitude, expected.attitude).max() <= EXACT
    assert back.source.labels.epoch == "2026-03-01T12:00:00" and back.momentum is None
    code, out, _ = run(["import", name, "--out", "again.nc"], capsys)
    assert code == 0 and "largest gap" in out and (files / "again.nc").is_file()


@pytest.mark.long
def test_import_with_moments_has_momentum_and_energy(files, capsys):
    found = values_of(["import", "box.bc", "--spec", "box.toml"], capsys)
    assert set(found["drift"]) == {"energy", "momentum_norm", "momentum_space"} and not found["notes"]
    assert max(found["drift"].values()) <= EXACT
    back, report = read_dataset(files / "box_imported.nc"), read_spec(files / "box.toml").report()
    assert np.abs(back.momentum - report.trajectory.momentum).max() <= EXACT
    assert np.abs(back.invariants["energy"] / report.trajectory.invariants["energy"] - 1.0).max() <= EXACT
    assert values_of(["compare", "box_imported.nc", "box.toml"], capsys)["angle"]["largest"] <= EXACT
    assert values_of(["import", "box.aem", "--spec", "box.toml"], capsys)["notes"]


@pytest.mark.long
@pytest.mark.parametrize("kind", first(1, ["lagrange-top", "heavy-top"]))
def test_import_of_a_top_has_what_its_own_dataset_has(tmp_path, monkeypatch, capsys, kind):
    """Its moments are about the pivot, its energy that of height too."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / "top.toml").write_text(TOP.replace("KIND", kind))
    report = read_spec(tmp_path / "top.toml").report()
    write_ck(report.trajectory, tmp_path / "top.bc")
    found = values_of(["import", "top.bc", "--spec", "top.toml"], capsys)
    assert set(found["drift"]) == {"energy", "vertical_momentum"} and not found["notes"]
    back, own = read_dataset(tmp_path / "top_imported.nc"), report.trajectory
    assert np.array_equal(back.frame.moments, report.frame.moments)
    assert np.array_equal(back.frame.pivot, report.frame.pivot)
    assert np.abs(back.momentum - own.momentum).max() <= EXACT * np.abs(own.momentum).max()
    for name in found["drift"]:
        assert np.abs(back.invariants[name] / own.invariants[name] - 1.0).max() <= EXACT
    assert "a top's invariants" in run(["import", "top.bc", "--spec", "top.toml"], capsys)[1]


@pytest.mark.long
@pytest.mark.parametrize("system", first(1, [GYROSTAT, '[system]\nkind = "damped-body"\ndamping = 0.01\n']))
def test_import_leaves_out_momentum_that_it_does_not_know(files, capsys, system):
    (files / "other.toml").write_text(BOX + system)
    found = values_of(["import", "box.bc", "--spec", "other.toml"], capsys)
    assert not found["drift"] and len(found["notes"]) == 1 and "are left out" in found["notes"][0]
    back = read_dataset(files / "box_imported.nc")
    assert back.momentum is None and not back.invariants and back.angular_velocity is not None
    assert values_of(["compare", "box_imported.nc", "box.toml"], capsys)["angle"]["largest"] <= EXACT


@pytest.mark.sweep
def test_datasets_of_a_free_body_have_their_moments(files, capsys):
    """Both along principal axes, whose moments they hold; a gyrostat's momentum is not its moments' alone."""
    found = values_of(["compare", "own.nc", "own.csv"], capsys)
    assert [side["source"] for side in found["invariants"]] == ["as given", "as given"] and not found["notes"]
    assert all(max(side["drift"].values()) <= EXACT for side in found["invariants"])
    own = read_dataset("own.nc")
    for side in found["invariants"]:
        assert side["first"]["energy"] == pytest.approx(own.invariants["energy"][0], rel=EXACT)
        assert side["first"]["momentum_space"] == pytest.approx(own.invariants["momentum_space"][0], rel=1e-9)
    (files / "wheel.toml").write_text(BOX + GYROSTAT)
    run(["export", "wheel.toml", "--to", "netcdf"], capsys)
    assert "energy" in read_dataset("wheel.nc").invariants
    assert values_of(["compare", "wheel.nc", "own.csv"], capsys)["invariants"] == [None, None]
    (note,) = [note for note in values_of(["compare", "wheel.toml", "wheel.nc"], capsys)["notes"] if "energy" in note]
    assert "wheel.toml is of the system gyrostat" in note and "--spec" not in note


def test_what_a_file_does_not_tell_is_not_made_up(files, capsys):
    """A kernel has no designator, an AEM no number of SPICE's; a file written on from it has the usual ones."""
    found = values_of(["import", "box.bc"], capsys)
    assert (found["object"], found["object_id"]) == ("BOX", None)
    labels = read_dataset("box_imported.nc").source.labels
    assert (labels.object_id, labels.originator, labels.spice_id) == (None, None, -321)
    assert "1900-000A" not in run(["import", "box.bc"], capsys)[1]
    assert values_of(["import", "box.aem"], capsys)["object_id"] == "1900-000A"  # as the file has it
    labels = read_dataset("box_imported.nc").source.labels
    assert (labels.object_id, labels.originator, labels.spice_id) == ("1900-000A", "POLHODE", None)
    assert write_ck(read_aem("box.aem"), "on.bc")[0].is_file() and "_999 " in (files / "on.tsc").read_text()
    write_aem(read_ck("box.bc"), "on.aem")
    assert "OBJECT_ID = 1900-000A" in " ".join((files / "on.aem").read_text().split())


@pytest.mark.long
def test_names_that_differ_by_case_and_underscore_are_the_same(files, capsys):
    samples, labels = read_aem("box.aem"), AttitudeLabels(object_name="Odd Sat", epoch="2026-03-01T12:00:00")
    write_aem(samples, "odd.aem", labels=labels)
    write_ck(samples, "odd.bc", labels=labels)
    assert not any("different names" in note for note in values_of(["compare", "odd.aem", "odd.bc"], capsys)["notes"])
    assert any("different names" in note for note in values_of(["compare", "odd.aem", "box.bc"], capsys)["notes"])


@pytest.mark.long
def test_two_attitudes_at_one_time_are_a_contradiction(tmp_path, monkeypatch, capsys):
    """One of them was taken silently; the same one twice is no contradiction."""
    monkeypatch.chdir(tmp_path)
    samples = FreeMotion((1.0, 2.0, 3.0), momentum=(0.3, 0.4, 0.5)).sample(np.array([0.0, 1.0, 1.0, 2.0, 0.5]))
    write_dataset(samples, tmp_path / "same.nc")
    with pytest.raises(SystemExit, match="0"):
        main(["compare", "same.nc", "same.nc"])
    attitude = samples.attitude.copy()
    attitude[2] = attitude[3]
    write_dataset(replace(samples, attitude=attitude), tmp_path / "two.nc")
    capsys.readouterr()
    with pytest.raises(SystemExit, match="2"):
        main(["compare", "same.nc", "two.nc"])
    assert "two.nc: has two attitudes at 1 s" in " ".join(capsys.readouterr().err.split())


def test_one_attitude_is_one(files, capsys):
    write_aem(FreeMotion((1.0, 2.0, 3.0), momentum=(0.0, 0.1, 1.0)).sample(np.zeros(1)), "one.aem")
    assert "AEM with 1 attitude." in run(["import", "one.aem"], capsys)[1]


REFUSED = [
    (["compare", "box.toml", "none.aem"], "none.aem: no such spec or motion file"),
    (["compare", "box.toml", "noise.bin"], "is not a spec, a dataset"),
    (["compare", "box.toml", "text.txt"], "is not TOML"),
    (["compare", "box.toml", "cut.nc"], "cut.nc"),
    (["compare", "box.toml", "cut.bc"], "--sclk"),
    (["compare", "box.toml", "xml.aem"], "XML"),
    (["compare", "box.toml", "half.aem"], "half.aem"),
    (["compare", "box.toml", "box.bc", "--sclk", "none.tsc"], "none.tsc"),
    (["compare", "box.toml", "box.bc", "--spice-id", "-5"], "-321000"),
    (["compare", "box.toml", "box.bc", "--spec", "wheel.toml"], "neither of a free body nor of a top"),
    (["compare", "wheel.toml", "box.bc", "--figures", "box.toml"], "box.toml"),
    (["import", "box.toml"], "is no AEM"),
    (["import", "box.bc", "--spec", "box.aem"], "box.aem: is an AEM, and --spec wants a spec"),
    (["compare", "box.aem", "box.bc", "--spec", "own.nc"], "own.nc: is a dataset, and --spec wants a spec"),
    (["import", "own.csv"], "is a CSV table of polhode's already"),
    (["import", "box.bc", "--spec", "own.csv"], "own.csv: is a CSV table, and --spec wants a spec"),
    (["compare", "spin.toml", "box.bc"], "spin.toml: holds no attitudes"),
    (["import", "own.nc"], "nothing to import"),
    (["import", "box.bc", "--out", "missing/box.nc"], "is not a folder"),
    (["import", "box.aem", "--out", "box.aem"], "writing would destroy it"),
]


@pytest.mark.long_cases("arguments9-neither of a free body nor of a top", "arguments10-box.toml")
@pytest.mark.parametrize(("arguments", "words"), REFUSED)
def test_what_is_not_what_it_claims_is_one_error(files, capsys, arguments, words):
    (files / "noise.bin").write_bytes(bytes(range(256)))
    (files / "text.txt").write_text("hello")
    (files / "cut.nc").write_bytes((files / "own.nc").read_bytes()[:2000])
    (files / "cut.bc").write_bytes((files / "box.bc").read_bytes()[:2000])
    (files / "xml.aem").write_text('<?xml version="1.0"?><aem id="CCSDS_AEM"/>')
    (files / "half.aem").write_text((files / "box.aem").read_text()[:700])
    (files / "spin.toml").write_text(find_kind("spin-orbit").example)
    (files / "wheel.toml").write_text(BOX + GYROSTAT)  # compiled above already
    code, _, err = run(arguments, capsys)
    assert code == 2 and words in err and "Traceback" not in err


def test_a_spec_without_attitudes_is_refused_before_it_moves(tmp_path, monkeypatch):
    def moved(self, spec):
        raise AssertionError("computed")

    (tmp_path / "spin.toml").write_text(find_kind("spin-orbit").example)
    monkeypatch.setattr(AbstractKind, "motion", moved)
    monkeypatch.setattr(AbstractKind, "report", moved)
    with pytest.raises(InvalidInput, match=r"spin\.toml: holds no attitudes"):
        load_source(tmp_path / "spin.toml", Kernels())


# ---------------------------------------------------------------- clocks

FREE = """
[body]
moments = ["1 kg*m^2", "2 kg*m^2", "3 kg*m^2"]
[spin]
angular_velocity = ["0.3 rad/s", "0.9 rad/s", "0.5 rad/s"]
[time]
until = "20 s"
"""
COLUMNS = ["--time", "stamp", "--quat", "qw,qx,qy,qz"]
NANOSECONDS = [k * 5_000_000 + (k * 7919) % 1000 for k in range(401)]


@pytest.fixture
def logs(tmp_path, monkeypatch):
    """A spec, and its motion logged by clocks that began with the computer, and in 1970; stamps have no common step."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / "free.toml").write_text(FREE)
    motion = FreeMotion((1.0, 2.0, 3.0), momentum=(0.3, 1.8, 1.5))
    attitudes = [",".join(map(repr, motion.attitude(n * 1e-9).tolist())) for n in NANOSECONDS]
    for name, unit, begin, divisor in (("boot", "us", 68_497_369, 1000), ("unix", "ns", 1_605_400_445_000_000_123, 1)):
        rows = [f"{begin + n // divisor},{q}" for n, q in zip(NANOSECONDS, attitudes, strict=True)]
        (tmp_path / f"{name}.csv").write_text("\n".join([f"stamp [{unit}],qw,qx,qy,qz", *rows]) + "\n")
    return tmp_path


@pytest.mark.sweep
def test_clocks_that_nothing_says_are_one_are_refused_until_told(logs, capsys):
    """A log by the clock of a computer that booted 68 s before was compared with the motion's 68th second: 119°."""
    code, _, err = run(["compare", "free.toml", "boot.csv", *COLUMNS], capsys)
    assert code == 2 and "share a clock" in err and "B at 68.497369 s" in err and "--offset=-68.497369s" in err
    assert "--align-clock" in err
    for told in ("--offset=-68.497369s", "--offset=-68497.369 ms", "--offset=start"):
        found = values_of(["compare", "free.toml", "boot.csv", *COLUMNS, told], capsys)
        assert found["angle"]["largest"] <= 2e-6 and "--offset" in found["clocks"]  # stamps are cut to microseconds
    found = values_of(["compare", "boot.csv", "free.toml", *COLUMNS, "--offset", "68.497369s"], capsys)
    assert found["angle"]["largest"] <= 2e-6
    found = values_of(["compare", "free.toml", "boot.csv", *COLUMNS, "--offset", "0 s"], capsys)
    assert found["angle"]["largest"] > 1.0 and not found["alignment"]["explains"]
    code, out, _ = run(["compare", "free.toml", "boot.csv", *COLUMNS, "--offset", "0 s"], capsys)
    assert "do not explain it" in " ".join(out.split()) and "explain all" not in out
    found = values_of(["compare", "free.toml", "boot.csv", *COLUMNS, "--align-clock"], capsys)
    assert found["angle"]["largest"] <= 2e-6 and abs(found["clock_offset"]["value"] + 68.497369) < 1e-6
    assert found["clock_offset"]["error"] < 1e-6 and "by the attitudes" in found["clocks"]
    found = values_of(["compare", "free.toml", "boot.csv", *COLUMNS, "--align-clock", "--offset", "-68 s"], capsys)
    assert abs(found["clock_offset"]["value"] + 68.497369) < 1e-6
    assert "nearest to the -68 s of --offset" in found["clocks"] and not found["clock_offset"]["supposes_body_axes"]
    code, _, err = run(["compare", "free.toml", "boot.csv", *COLUMNS, "--align-clock", "--offset", "start"], capsys)
    assert code == 2 and "Leave one out" in err
    for wrong in ("68", "soon", "nan s", "1_0 s", "3 kg"):
        code, _, err = run(["compare", "free.toml", "boot.csv", *COLUMNS, f"--offset={wrong}"], capsys)
        assert code == 2 and "--offset must be `start`" in err and err.count("\n") == 1
    for wrong in ("1e300 s", "-1e400 s", "1e-31 s"):
        code, _, err = run(["compare", "free.toml", "boot.csv", *COLUMNS, f"--offset={wrong}"], capsys)
        assert code == 2 and "--offset must be between 1e-30 and 1e30 in size" in err and err.count("\n") == 1


@pytest.mark.long
def test_what_is_assumed_of_clocks_is_said(files, capsys):
    found = values_of(["compare", "box.toml", "own.csv"], capsys)
    assert found["clocks"].startswith("assumed to be one: both begin at 0 s")
    told = values_of(["compare", "box.bc", "late.aem", "--offset", "30 s"], capsys)
    assert told["clocks"] == "B's time zero is at 30 s of A, as --offset says"
    assert told["times"] == values_of(["compare", "box.bc", "late.aem"], capsys)["times"]


@pytest.mark.long
def test_nanoseconds_since_1970_lose_nothing(logs, capsys):
    """Nineteen digits: as doubles they are 2.4e-7 s apart, which at 1 rad/s is 1e-7 rad and said nothing of it."""
    code, _, err = run(["compare", "free.toml", "unix.csv", *COLUMNS], capsys)
    assert code == 2 and "B at 1605400445.000000123 s" in err
    for told in ("start", "-1605400445.000000123 s"):
        found = values_of(["compare", "free.toml", "unix.csv", *COLUMNS, "--offset", told], capsys)
        assert found["angle"]["largest"] <= 1e-14 and found["read_as"]["b"]["counted_from"] == "1605400445.000000123"
    found = values_of(["import", "unix.csv", *COLUMNS], capsys)
    assert found["read_as"]["counted_from"] == "1605400445.000000123" and "2.4e-07 s" in found["notes"][0]
    kept = read_dataset("unix_imported.nc").times.tolist()
    assert kept == pytest.approx([n * 1e-9 for n in NANOSECONDS], abs=0.0, rel=1e-15)
    assert run(["compare", "free.toml", "unix_imported.nc"], capsys)[0] == 2  # it knows the clock it is from
    same = values_of(["compare", "unix.csv", "unix_imported.nc", *COLUMNS], capsys)
    assert same["angle"]["largest"] <= 1e-15 and "1605400445.000000123 s" in same["clocks"]
