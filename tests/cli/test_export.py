"""``polhode export``: what it writes is the report's motion, and how it refuses."""

import json
import re
from pathlib import Path

import numpy as np
import pytest
from pygltflib import GLTF2

from polhode import formats, rotation, spacecraft
from polhode.cli.main import main
from polhode.formats.form_registry import writable_forms
from polhode.kinds.reading import read_spec

DIGITS = 2e-15
"""rad: the 16 digits of an AEM."""
SPEC = """
name = "</script> a = b Größe\\nnext"
[body]
inertia = [["3 kg*m^2", "0.1 kg*m^2", "0 kg*m^2"], ["0.1 kg*m^2", "2 kg*m^2", "0.2 kg*m^2"],
           ["0 kg*m^2", "0.2 kg*m^2", "1.5 kg*m^2"]]
[spin]
angular_velocity = ["0.1 rad/s", "2 rad/s", "-0.3 rad/s"]
attitude = [0.5, -0.5, 0.1, 0.7]
[time]
until = "10 s"
samples = 101
[export]
object_id = "2026-001A"
epoch = 2026-03-01T12:00:00.25
"""

DISK = (Path(__file__).parents[2] / "examples" / "euler_disk.toml").read_text("utf-8")


@pytest.fixture
def run(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "case.toml").write_text(SPEC, "utf-8")

    def call(*arguments):
        with pytest.raises(SystemExit) as stopped:
            main(["export", "case.toml", *arguments])
        out, err = capsys.readouterr()
        old = "leap seconds are known until", "is deprecated"  # by old libraries, said where pytest shows all warnings
        lines = [line for line in err.splitlines(True) if not any(words in line for words in old)]
        return stopped.value.code or 0, out, "".join(lines)

    return call


def written(tmp_path):
    return sorted(path.name for path in tmp_path.iterdir() if path.name != "case.toml")


def test_animation_and_robot_link(run, tmp_path):
    code, out, err = run("--to", "gltf")
    assert code == 0 and err == "" and written(tmp_path) == ["case.glb"]
    found = GLTF2().load(str(tmp_path / "case.glb"))
    assert found is not None and len(found.animations) == 1 and len(found.meshes) >= 1
    code, out, err = run("--to", "urdf")
    assert code == 2 and "mass" in err and written(tmp_path) == ["case.glb"]  # the spec gives none
    text = SPEC.replace("[body]", '[body]\nmass = "30 kg"').replace("</script> a = b Größe\\nnext", "base link")
    (tmp_path / "case.toml").write_text(text, "utf-8")
    code, out, err = run("--to", "urdf")
    assert code == 0 and "samples" not in out
    link = spacecraft.read_urdf_inertial(tmp_path / "case.urdf")
    spec = read_spec(tmp_path / "case.toml")
    assert spec.body is not None and np.array_equal(link.inertia, spec.body.inertia) and link.mass == 30.0


def test_every_form_holds_the_motion(run, tmp_path):
    code, out, err = run("--to", "netcdf", "--to", "zarr", "--to", "csv", "--to", "aem", "--to", "csv")
    assert code == 0 and err == ""
    assert written(tmp_path) == ["case.aem", "case.csv", "case.nc", "case.zarr"]
    lines = out.splitlines()
    assert len(lines) == 4 and all("101 samples" in line for line in lines)
    spec = read_spec(tmp_path / "case.toml")
    report = spec.report()
    for name in ("case.nc", "case.zarr"):
        found = formats.read_dataset(tmp_path / name)
        assert np.array_equal(found.attitude, report.trajectory.attitude)
        assert np.array_equal(found.momentum, report.trajectory.momentum)
        assert found.source.title == spec.name and found.source.labels == spec.labels
    given = report.trajectory.along("given")
    table, message = formats.read_csv(tmp_path / "case.csv"), spacecraft.read_aem(tmp_path / "case.aem")
    assert np.array_equal(table.attitude, given.attitude) and np.array_equal(table.momentum, given.momentum)
    assert np.array_equal(found.frame.axes, report.trajectory.frame.axes)
    for one in (table, message):
        # the message holds the motion at its own epochs, 9 s + 0.8 s being another double than 9.8 s
        late = 2.1 * np.abs(one.times - given.times).max()  # |Ω| < 2.1 rad/s
        assert late < 1e-14 and rotation.angle_between(one.attitude, given.attitude).max() <= DIGITS + late
        assert one.angular_velocity[0] == pytest.approx((0.1, 2.0, -0.3), abs=1e-14)
        assert rotation.angle_between(one.attitude[0], np.array([0.5, -0.5, 0.1, 0.7])) <= 1e-14
    assert message.source.labels.object_name == "</SCRIPT> A = B GRO_E NEXT"
    assert message.source.labels.epoch == "2026-03-01T12:00:00.25" and message.source.labels.object_id == "2026-001A"


def test_all_files_are_written_or_none(run, tmp_path):
    """The spec gives no mass for a robot's link. A store that is there is replaced, another folder is not."""
    code, out, err = run("--to", "csv", "--to", "urdf")
    assert code == 2 and "mass" in err and out == "" and written(tmp_path) == []
    assert run("--to", "zarr", "--to", "csv")[0] == 0
    before = (tmp_path / "case.csv").stat().st_ino
    assert run("--to", "zarr", "--to", "csv")[0] == 0
    assert (tmp_path / "case.csv").stat().st_ino != before and written(tmp_path) == ["case.csv", "case.zarr"]
    (tmp_path / "case.zarr" / ".zattrs").unlink()
    before = (tmp_path / "case.csv").stat().st_ino
    code, _, err = run("--to", "csv", "--to", "zarr")
    assert code == 2 and "case.zarr: is a folder, but not the store of a motion" in err
    assert (tmp_path / "case.csv").stat().st_ino == before


def test_json_names_the_files(run, tmp_path):
    code, out, _ = run("--to", "csv", "--to", "aem", "--json")
    found = json.loads(out)
    assert code == 0 and found["files"] == ["case.csv", "case.aem"] and found["kind"] == "free-body"
    assert {"name", "summary", "units", "notes"} <= set(found) and written(tmp_path) == ["case.aem", "case.csv"]


def test_one_file_may_be_named(run, tmp_path):
    (tmp_path / "there").mkdir()
    assert run("--to", "aem", "--out", "there/motion.txt")[0] == 0
    assert written(tmp_path / "there") == ["motion.txt"]


@pytest.mark.parametrize(("arguments", "words"), [
    (("--to", "aen"), "must be one of aem, cat, ck, csv, gltf, netcdf, par, urdf, zarr; got 'aen'. Did you mean aem?"),
    (("--to", "NetCDF"), "got 'NetCDF'. Did you mean netcdf?"),
    (("--to", "aem", "--to", "csv", "--out", "one"), "--out names one file, and 2 forms"),
    (("--to", "csv", "--out", "missing/motion.csv"), "csv: missing/motion.csv: cannot be written"),
    (("--to", "csv", "--out", "/proc/motion.csv"), "csv: /proc/motion.csv: cannot be written"),
    (("--to", "netcdf", "--out", "."), "is a folder"),
    (("--to", "csv", "--out", "./case.toml"), "writing would destroy it"),
])  # fmt: skip
def test_what_is_refused(run, tmp_path, arguments, words):
    code, out, err = run(*arguments)
    assert code == 2 and out == "" and words in err and "Traceback" not in err
    assert written(tmp_path) == []


@pytest.mark.parametrize("form", ["aem", "ck"])
def test_turns_too_long_to_interpolate_are_said(run, tmp_path, form):
    assert run("--to", form)[::2] == (0, "")
    (tmp_path / "case.toml").write_text(SPEC.replace("samples = 101", "samples = 11"), "utf-8")
    code, out, err = run("--to", form)
    assert code == 0 and "11 samples" in out and "between samples" in err and "Raise `samples`" in err


@pytest.mark.sweep
def test_what_part_of_the_motion_an_animation_shows(run, tmp_path):
    assert "it shows" not in run("--to", "gltf")[1]
    (tmp_path / "case.toml").write_text(DISK)
    code, out, _ = run("--to", "gltf")
    start = GLTF2().load(str(tmp_path / "case.glb")).asset.extras["seconds_at_start"]
    assert code == 0 and start > 0 and f"it shows the motion from {start:.6g} s to" in out


def test_without_a_form_nothing_is_written(run, tmp_path):
    code, _, err = run()
    assert code == 2 and "--to" in err and written(tmp_path) == []


@pytest.mark.sweep
def test_motions_without_attitude(run, tmp_path):
    text = 'system = { kind = "spin-orbit", eccentricity = 0.1, orbital_period = "21 day", asphericity = 0.9 }\n'
    (tmp_path / "case.toml").write_text(text + '[time]\nuntil = "1 day"\nsamples = 5\n')
    assert run("--to", "csv")[0] == 0
    code, _, err = run("--to", "aem")
    assert code == 2 and "holds attitudes, and this motion has none" in err
    assert written(tmp_path) == ["case.csv"]


def test_help_names_every_form(capsys):
    with pytest.raises(SystemExit):
        main(["export", "--help"])
    shown = " ".join(capsys.readouterr().out.replace("│", " ").split())
    *names, _ = writable_forms()
    assert ", ".join(names) in re.sub(r" \(extra \w+\)", "", shown)
    assert f"or {list(writable_forms())[-1]}" in shown and "ck (extra spice)" in shown
    assert "default: named after the spec" in shown
