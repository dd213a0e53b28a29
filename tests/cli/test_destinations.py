"""Odd destinations of every command that writes: one sentence and exit code 2, or what was asked for; nothing else."""

import os
import shutil
from pathlib import Path

import pytest

from polhode.cli.main import main
from sweeping import only

EXAMPLES = Path(__file__).parents[2] / "examples"
SPEC = """
[body]
moments = ["1.2 g*cm^2", "2 g*cm^2", "2.9 g*cm^2"]
[spin]
about = 2
rate = "60 rpm"
[time]
until = "2 s"
samples = 9
[sweep]
samples = 6
outputs = ["energy"]
[sweep.inputs]
"spin.tilt" = { uniform = ["1 deg", "9 deg"] }
"""
WATER = "3\nwater\nO 0 0 0.1173\nH 0 0.7572 -0.4692\nH 0 -0.7572 -0.4692\n"
COMMANDS = {
    "sweep": ("sweep", "case.toml", "--no-figures"), "figures of a sweep": ("sweep", "case.toml"),
    "report": ("report", "case.toml"), "new": ("new", "cubesat"),
    "view": ("view", "case.toml", "--no-open"), "levels": ("levels", "water.xyz", "--j-max", "1"),
    "lines": ("lines", "water.xyz", "--j-max", "1", "--dipole", "0,1.85,0"),
    "csv": ("export", "case.toml", "--to", "csv"), "zarr": ("export", "case.toml", "--to", "zarr"),
    "urdf": ("export", "case.toml", "--to", "urdf"), "import": ("import", "motion.csv"),
    "compare": ("compare", "case.toml", "motion.csv"), "tumble": ("tumble", "Toutatis"),
    "figures of tumble": ("tumble", "Toutatis"),
}  # fmt: skip
PLACES = (".", "..", "/", "", "case.toml", "none/a", "x" * 300, "pipe", "folder", "nowhere", "loop", "/dev/null",
          "/proc/a", "case.toml/a", "mine/..", "folder/", "-", "~")  # fmt: skip


@pytest.fixture(scope="module")
def inputs(tmp_path_factory):
    place = tmp_path_factory.mktemp("inputs")
    (place / "case.toml").write_text(SPEC)
    (place / "water.xyz").write_text(WATER)
    with pytest.raises(SystemExit):
        main(["export", str(place / "case.toml"), "--to", "csv", "--out", str(place / "motion.csv")])
    return place


@pytest.fixture
def folder(inputs, tmp_path, monkeypatch):
    place = tmp_path / "in"
    shutil.copytree(inputs, place)
    for name in ("folder", "mine"):
        (place / name).mkdir()
        (place / name / "thesis.txt").write_text("all of it")
    os.mkfifo(place / "pipe")
    (place / "nowhere").symlink_to("not-there")
    (place / "loop").symlink_to("loop")
    monkeypatch.chdir(place)
    return place


CASES = [(name, place) for name in COMMANDS for place in PLACES]
QUICK = [("sweep", place) for place in PLACES] + [(name, ".") for name in COMMANDS if name not in ("report", "compare")]


@pytest.mark.long_after(14)
@pytest.mark.long_cases("figures of tumble-.")
@pytest.mark.parametrize(("name", "place"), only(QUICK, CASES))
def test_odd_destinations(folder, capsys, name, place):
    before = {path: path.read_bytes() for path in folder.rglob("*") if path.is_file()}
    option = "--figures" if name in ("compare", "figures of tumble") else "--out"
    with pytest.raises(SystemExit) as ended:
        main([*COMMANDS[name], option, place])
    code, errors = ended.value.code or 0, capsys.readouterr().err
    assert code in (0, 2), errors
    assert "Traceback" not in errors
    if code == 2:
        assert errors.startswith("polhode: ") and len(errors.splitlines()) == 1, errors
    if code == 0:  # a file that is named is replaced
        before.pop(folder / place, None)
    assert {path: path.read_bytes() for path in before} == before
    assert not [path for path in folder.rglob(".polhode-*")]
