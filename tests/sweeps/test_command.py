"""`polhode sweep` as people use it: text, JSON, figures, dry runs, going on, mistakes."""

import json

import numpy as np
import pytest

from polhode.cli.main import main

SPEC = """
[body]
moments = ["1.2 g*cm^2", "2 g*cm^2", "2.9 g*cm^2"]
[spin]
about = 2
[sweep]
samples = 200
seed = 3
chunk = 100
outputs = ["form", "polhode_period", "angular_velocity"]
[sweep.inputs]
"spin.rate" = { normal = ["120 rpm", "5 rpm"] }
"spin.tilt" = { uniform = ["0 deg", "90 deg"] }
"body.moments.1" = { uniform = ["0.8 g*cm^2", "1.2 g*cm^2"] }
"""


@pytest.fixture
def run(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "case.toml").write_text(SPEC)

    def call(*arguments):
        with pytest.raises(SystemExit) as stopped:
            main(["sweep", "case.toml", *arguments])
        return stopped.value.code or 0, *capsys.readouterr()

    return call


@pytest.mark.long
def test_text_and_figures(run, tmp_path):
    code, said, errors = run()
    assert code == 0, errors
    assert "of 200 samples have a motion" in said and "refused" in said and "I1 + I2" in said
    assert "polhode_period [s]" in said and "±" in said and "95 % interval" in said
    assert {path.name for path in (tmp_path / "case_figures").iterdir()} == {"histograms.png", "verdict_map.png"}
    again = run()[1]
    assert again.splitlines()[:8] == said.splitlines()[:8]


def test_json(run):
    code, said, _ = run("--json", "--no-figures", "--out", "other.zarr")
    values = json.loads(said)
    assert code == 0 and values["files"] == ["other.zarr"]
    assert values["samples"] == 200 == sum(values["sample_status"].values())
    shares = [row["probability"] for row in values["probabilities"] if row["output"] == "form"]
    assert sum(shares) == pytest.approx(1.0) and all(0.0 < row["low"] < row["high"] for row in values["probabilities"])
    names = [row["output"] for row in values["statistics"]]
    assert names == ["polhode_period", *(f"angular_velocity.{k}" for k in (1, 2, 3))]
    assert values["units"]["polhode_period"] == "s" and len(values["checksum"]) == 64


def test_a_dry_run_writes_nothing(run, tmp_path):
    code, said, _ = run("--dry-run", "--json")
    values = json.loads(said)
    assert code == 0 and values["samples"] == 200 and values["chunks"] == 2 and values["computed_at_once"]
    assert values["cpu_time"] > 0.0 and values["store_size"] > 200 * 8 * 8
    assert "samples" in run("--dry-run")[1]
    assert [path.name for path in tmp_path.iterdir()] == ["case.toml"]


@pytest.mark.long
def test_sensitivities(run, tmp_path):
    spec = SPEC.replace("samples = 200", "samples = 64\nsensitivity = true").replace('"0.8 g*cm^2"', '"1 g*cm^2"')
    (tmp_path / "case.toml").write_text(spec)
    code, said, errors = run()
    assert code == 0, errors
    assert "320 of 320" in said and "Share of the variance" in said and "form = " in said
    assert (tmp_path / "case_figures" / "sensitivities.png").stat().st_size > 1000


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("--workers", "0"), "must be a whole number from 1"),
        (("--out", "case.toml"), "not the store of a sweep"),
        (("--out", "none/a.zarr"), "is not a folder"),
    ],
)
def test_mistakes(run, arguments, words):
    code, said, errors = run(*arguments)
    assert code == 2 and words in errors and "Traceback" not in errors and not said


@pytest.mark.long
def test_a_molecule_has_answers_and_no_motion(run, tmp_path):
    (tmp_path / "case.toml").write_text("""[system]
kind = "quantum-rotor"
constants = ["27 GHz", "14 GHz", "9 GHz"]
j_max = 1
j = 1
[sweep]
outputs = ["partition_function"]
[sweep.inputs]
"system.temperature" = { grid = ["10 K", "40 K"] }
""")
    code, said, errors = run("--no-figures")
    assert code == 0, errors
    assert "2 of 2 samples are computed" in said
    found = json.loads(run("--no-figures", "--json")[1])["statistics"][0]
    # √π (kT/h)^(3/2)/√(ABC), to 0.5 % here
    classical = [np.sqrt(np.pi / (27.0 * 14.0 * 9.0)) * (20.8366191233 * T) ** 1.5 for T in (10.0, 40.0)]
    assert found["mean"] == pytest.approx(np.mean(classical), rel=5e-3)
