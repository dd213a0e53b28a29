"""``polhode new``: every example is listed, copied with what it needs, read, and never written over."""

import subprocess
import sys
import zipfile
from pathlib import Path

import pytest

from polhode.cli import terminal
from polhode.cli.main import main
from polhode.cli.new import examples
from polhode.kinds import registry
from polhode.kinds.reading import read_spec

EXAMPLES = Path(__file__).parents[2] / "examples"


def run(arguments, capsys):
    with pytest.raises(SystemExit) as stopped:
        main(arguments)
    out, err = capsys.readouterr()
    return stopped.value.code or 0, " ".join(out.split()), " ".join(err.split())


def test_all_are_listed_with_what_they_are(capsys):
    code, out, _ = run(["new"], capsys)
    assert code == 0 and set(examples()) == {path.stem for path in EXAMPLES.glob("*.toml")}
    assert all(name in out for name in examples())
    assert "hyperion A moon like Hyperion in the sea of chaos." in out


@pytest.mark.parametrize("name", [path.stem for path in sorted(EXAMPLES.glob("*.toml"))])
def test_a_copy_can_be_read(name, capsys, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    code, out, _ = run(["new", name], capsys)
    assert code == 0 and f"Next: polhode report {name}.toml" in out
    assert (tmp_path / f"{name}.toml").read_bytes() == (EXAMPLES / f"{name}.toml").read_bytes()
    assert read_spec(tmp_path / f"{name}.toml").name


def test_the_mesh_comes_with_it_and_nothing_is_written_over(capsys, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "t_handle.stl").write_text("mine")
    code, out, err = run(["new", "t_handle.toml"], capsys)
    assert code == 2 and out == "" and "t_handle.stl: is there already" in err
    assert [path.name for path in tmp_path.iterdir()] == ["t_handle.stl"]
    code, out, _ = run(["new", "t_handle", "--out", "other"], capsys)
    copied = sorted(path.name for path in (tmp_path / "other").iterdir())
    assert code == 0 and copied == ["t_handle.stl", "t_handle.toml"]


def test_an_unknown_one_is_refused_with_the_nearest(capsys, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    code, _, err = run(["new", "gyroscop"], capsys)
    assert code == 2 and "did you mean gyroscope?" in err and not list(tmp_path.iterdir())


def test_commands_are_told_as_they_can_be_given(monkeypatch, tmp_path):
    program = tmp_path / "bin" / "polhode"
    program.parent.mkdir()
    program.write_text("")
    program.chmod(0o755)
    monkeypatch.setattr(sys, "argv", [str(program)])
    monkeypatch.setenv("PATH", "/nowhere")
    assert terminal.spell_command("view", "a b.toml") == f"{program} view 'a b.toml'"
    monkeypatch.setenv("PATH", str(program.parent))
    assert terminal.spell_command("view", "a.toml") == "polhode view a.toml"
    monkeypatch.setattr(sys, "argv", ["pytest"])
    assert terminal.spell_command("new") == "polhode new"


@pytest.mark.sweep
def test_they_are_in_the_wheel(tmp_path):
    root = EXAMPLES.parent
    made = subprocess.run(
        [sys.executable, "-m", "pip", "wheel", "--no-deps", "--quiet", "--wheel-dir", str(tmp_path), str(root)],
        capture_output=True, text=True, check=False, timeout=300,
    )  # fmt: skip
    assert made.returncode == 0, made.stderr[-2000:]
    names = zipfile.ZipFile(next(tmp_path.glob("*.whl"))).namelist()
    assert {f"polhode/examples/{path.name}" for path in EXAMPLES.glob("*.toml")} <= set(names)
    assert "polhode/examples/t_handle.stl" in names and "polhode/bodies/atomic_weights.csv" in names


def test_an_example_of_another_package(capsys, tmp_path, monkeypatch, plugin):
    monkeypatch.chdir(tmp_path)
    code, out, _ = run(["new"], capsys)
    assert code == 0 and "(package spherical_pendulum)" in out
    with monkeypatch.context() as patched:
        plain = '[system]\nkind = "spherical-pendulum"\nlength = "1 m"\n'
        patched.setattr(type(registry.find_kind("spherical-pendulum")), "example", plain)
        code, out, _ = run(["new"], capsys)  # whose comment, which there is none of, was "."
    what = "A mass on a rod that swings any way under its weight."
    assert code == 0 and f"spherical-pendulum {what} (package spherical_pendulum)" in out
    code, out, _ = run(["new", "spherical-pendulum"], capsys)
    assert code == 0 and "Next: polhode report spherical-pendulum.toml" in out
    assert read_spec("spherical-pendulum.toml").kind.name == "spherical-pendulum"
    code, _, err = run(["new", "spherical-pendulum"], capsys)
    assert code == 2 and "is there already, and nothing was copied" in err
    code, _, err = run(["new", "spherical-pendulm"], capsys)
    assert code == 2 and "did you mean spherical-pendulum?" in err
