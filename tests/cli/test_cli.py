"""The command: what it prints, what it writes, and how it refuses."""

import json
import subprocess
import sys

import numpy as np
import pytest

from cli.specs import SPEC
from polhode.cli.main import main


def run(arguments, capsys):
    with pytest.raises(SystemExit) as stopped:
        main(arguments)
    out, err = capsys.readouterr()
    return stopped.value.code or 0, out, err


@pytest.fixture
def spec(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)

    def write(text=SPEC, old="", new=""):
        path = tmp_path / "case.toml"
        path.write_text(text.replace(old, new) if old else text)
        return str(path)

    return write


@pytest.mark.long
def test_json_is_one_object_with_every_key(spec, capsys, tmp_path):
    code, out, _ = run(["report", spec(), "--json"], capsys)
    values = json.loads(out, parse_constant=lambda name: pytest.fail(name))
    assert code == 0
    wanted = """mass center_of_mass principal_moments principal_axes energy momentum_norm regime polhode_period
    flip_interval precession_per_period geometric_phase action axes files""".split()
    assert set(wanted) <= set(values)
    assert [axis["verdict"] for axis in values["axes"]] == ["stable", "unstable", "stable"]
    assert {"axis", "verdict", "rate", "certificate"} <= set(values["axes"][0])
    assert all((tmp_path / name).is_file() for name in values["files"])
    assert len(values["files"]) == 5 and not (tmp_path / "case" / "page.html").exists()  # nobody asked for a page


@pytest.mark.long
def test_report_and_body_for_people(spec, capsys):
    code, out, _ = run(["report", spec()], capsys)
    assert code == 0
    assert "Flipping" in out and "unstable" in out and "the energy" in out and "δL" not in out
    code, out, _ = run(["report", spec(), "--certificates"], capsys)
    assert code == 0 and "the energy" in out and "δL" in out
    code, out, _ = run(["body", spec()], capsys)
    assert code == 0 and "principal moments" in out
    code, out, _ = run(["body", spec(), "--json"], capsys)
    assert json.loads(out)["principal_moments"] == [1.0, 2.0, 3.0]


def test_rest_is_a_valid_report(spec, capsys):
    code, out, _ = run(["report", spec(SPEC.replace('tilt = "1 deg"', ""), '"60 rpm"', '"0 rpm"'), "--json"], capsys)
    values = json.loads(out)
    assert code == 0 and values["regime"] == "rest" and values["polhode_period"] is None


BAD = [
    ('"1 kg*m^2", ', '"1 kg*m", ', "wrong unit"),
    ('"60 rpm"', '"1 Hz"', "ambiguous"),
    ('"60 rpm"', '"1 1/s"', "names no angle"),
    ('"60 rpm"', '"1 m/s"', "names no angle"),
    ('"3 kg*m^2"', '"4 kg*m^2"', "I1 + I2 ≥ I3"),
    ('"1 kg*m^2", ', '"nan kg*m^2", ', "finite"),
    ('"1 kg*m^2", ', '"-1 kg*m^2", ', "negative"),
    ('"1 kg*m^2", ', '"0 kg*m^2", ', "I1 + I2 ≥ I3"),
    ('"1 kg*m^2", ', "1, ", "unit in quotes"),
    ('"60 rpm"', '"0 rpm"', "no direction"),
    ("[spin]", 'mass = "-2 kg"\n[spin]', "positive"),
    ("samples = 20", "samples = 1", "must be at least 2"),
    ("samples = 20", 'until = "-3 s"', "positive"),
    ("about = 2", "", "about"),
    ("[spin]", "[spin", "not TOML"),
]


@pytest.mark.parametrize(("old", "new", "words"), BAD)
def test_bad_specs(spec, capsys, tmp_path, old, new, words):
    code, out, err = run(["report", spec(old=old, new=new)], capsys)
    assert code == 2 and out == ""
    assert words in err and "case.toml" in err and "Traceback" not in err
    assert [path.name for path in tmp_path.iterdir()] == ["case.toml"]


def test_all_unknown_keys_at_once(spec, capsys):
    text = SPEC.replace("tilt", "tilted").replace("samples", "sample") + "\n[colour]\nred = 1\n"
    code, _, err = run(["report", spec(text)], capsys)
    assert code == 2
    for words in ("spin.tilted: unknown key; did you mean tilt?", "time.sample: unknown", "colour: unknown key"):
        assert words in err


@pytest.mark.parametrize(("where", "words"), [("missing.toml", "no such spec file"), (".", "is a folder")])
def test_specs_that_cannot_be_read(spec, capsys, where, words):
    code, _, err = run(["report", where], capsys)
    assert code == 2 and words in err


def test_folders_that_cannot_be_written(spec, capsys, tmp_path):
    path = spec()
    for folder in (path, "/dev/null/out", str(tmp_path / "case.toml" / "out")):
        code, out, err = run(["report", path, "--out", folder], capsys)
        assert code == 2 and out == "" and "Choose another" in err
    assert [p.name for p in tmp_path.iterdir()] == ["case.toml"]


def test_meshes_that_are_no_bodies(spec, capsys, tmp_path):
    import trimesh

    mesh = trimesh.creation.box((1, 2, 3))
    text = '[body]\nmesh = "part.stl"\nmesh_unit = "mm"\nmass = "1 kg"\n'
    mesh.update_faces([k > 0 for k in range(len(mesh.faces))])
    mesh.export(tmp_path / "part.stl")
    code, _, err = run(["body", spec(text)], capsys)
    assert code == 2 and "open" in err and "part.stl" in err
    inverted = trimesh.creation.box((1, 2, 3))
    inverted.invert()
    inverted.export(tmp_path / "part.stl")
    code, _, err = run(["body", spec(text)], capsys)
    assert code == 2 and "inverted" in err
    code, _, err = run(["body", spec(text.replace("part", "none"))], capsys)
    assert code == 2 and "no such mesh file" in err
    code, _, err = run(["body", spec(text.replace('mesh_unit = "mm"\n', ""))], capsys)
    assert code == 2 and "mesh files carry no unit" in err


HEAVY = ("jax", "matplotlib", "xarray", "trimesh", "scipy", "pint", "sympy")


@pytest.mark.parametrize("arguments", [["--help"], ["report", "--help"], ["--version"]])
def test_help_comes_fast(arguments):
    code = f"""
import sys
from polhode.cli.main import main
try:
    main({arguments!r})
except SystemExit:
    pass
print([name for name in {HEAVY!r} if name in sys.modules])
"""
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.splitlines()[-1] == "[]"


def test_the_package_can_be_run_as_the_command():
    done = subprocess.run([sys.executable, "-m", "polhode", "--version"], capture_output=True, text=True, check=True)
    assert "polhode" in done.stdout


def test_importing_polhode_imports_nothing_heavy():
    code = f"import sys, polhode; polhode.FreeMotion, polhode.Body; print([n for n in {HEAVY!r} if n in sys.modules])"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "[]"


def test_a_lack_of_memory_is_one_message(spec, capsys, monkeypatch):
    from polhode.cli import body

    def lacks(path, json, about):
        np.empty(2**58)

    monkeypatch.setattr(body, "run_body", lacks)
    code, out, err = run(["body", spec()], capsys)
    assert code == 2 and out == "" and "not enough memory" in err and "2.00 EiB" in err and err.count("\n") == 1
