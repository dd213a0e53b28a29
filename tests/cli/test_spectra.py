"""Levels and lines of molecules by command."""

import json
from pathlib import Path

import pytest

from polhode.cli.main import main

EXAMPLES = Path(__file__).parents[2] / "examples"
MHZ, WAVE_NUMBER = 1e6, 29979245800.0


@pytest.fixture
def run(capsys):
    def of(*arguments, code="0"):
        with pytest.raises(SystemExit, match=code):
            main([str(argument) for argument in arguments])
        return capsys.readouterr()

    return of


def test_levels_of_a_spec_and_of_atoms(run):
    found = json.loads(run("levels", EXAMPLES / "water_spectrum.toml", "--json", "--j-max", "1").out)
    assert found["j_max"] == 1 and [row["J"] for row in found["levels"]] == [0, 1, 1, 1]
    assert found["levels"][1]["energy"] / WAVE_NUMBER == pytest.approx(23.79446251, abs=1e-8)
    assert found["levels"][1]["wave_number"] == pytest.approx(2379.446251, abs=1e-6)
    # J = 1 of a rigid rotor: B + C, A + C, A + B, with the masses of the common isotopes
    atoms, spec = (json.loads(run("levels", EXAMPLES / name, "--json", "--j-max", "1").out)
                   for name in ("water.xyz", "water.toml"))  # fmt: skip
    A, B, C = atoms["constants"]
    assert pytest.approx(822482.650e6, abs=1e3) == A
    assert [row["energy"] for row in atoms["levels"]] == pytest.approx([0.0, B + C, A + C, A + B], rel=1e-14)
    assert spec["levels"] == atoms["levels"] and (atoms["name"], spec["name"]) == ("water", "water")


def test_lines_between_frequencies(run):
    """Three lines of formaldehyde as measured [MHz], and their intensities in the CDMS."""
    path = EXAMPLES / "formaldehyde.toml"
    found = json.loads(run("lines", path, "--json", "--to", "150 GHz", "--min-intensity", "1e-6").out)
    assert found["partition_function"] == pytest.approx(2883.02, abs=0.01)
    nearest = [min(found["lines"], key=lambda line: abs(line["frequency"] / MHZ - nu))
               for nu in (4829.660, 72837.948, 140839.502)]  # fmt: skip
    assert [line["lg_intensity"] for line in nearest] == pytest.approx([-5.9024, -4.1792, -2.9775], abs=1e-4)
    assert nearest[1]["frequency"] / MHZ == pytest.approx(72837.948, abs=0.01)
    assert all(line["frequency"] <= 150e9 and line["intensity"] >= 1e-18 for line in found["lines"])
    frequencies = [line["frequency"] for line in found["lines"]]
    assert frequencies == sorted(frequencies) and len(frequencies) == found["lines_within"]


def test_the_strongest_lines(run):
    """--most keeps the strongest; what is colder is weaker in what is hot."""
    path = EXAMPLES / "sulfur_dioxide.toml"
    bounds = ("--from", "80 GHz", "--to", "116 GHz", "--j-max", "20")
    everything = json.loads(run("lines", path, "--json", *bounds).out)["lines"]
    three = json.loads(run("lines", path, "--json", *bounds, "--most", "3").out)["lines"]
    strong = sorted(line["intensity"] for line in everything)[-3:]
    assert sorted(line["intensity"] for line in three) == strong
    hot = json.loads(run("lines", path, "--json", *bounds, "--temperature", "300 K").out)
    assert hot["temperature"] == 300.0 and max(x["intensity"] for x in hot["lines"]) < strong[-1]
    said = run("lines", path, *bounds, "--most", "3").out
    assert "The 3 strongest of" in said and "2_2,0 – 3_1,3" not in said and "8_1,7 – 8_0,8" in said


def test_a_dipole_for_atoms(run):
    said = run("lines", EXAMPLES / "water.xyz", "--dipole", "0,1.857,0", "--most", "2", "--j-max", "4").out
    assert "The 2 strongest" in said and "nuclear spins are left out" in said


@pytest.mark.parametrize(("arguments", "said"), [
    (("lines", EXAMPLES / "water.xyz"), "no lines without one. Give it, like --dipole"),
    (("lines", EXAMPLES / "water.xyz", "--dipole", "1,2"), "--dipole must be three numbers"),
    (("lines", EXAMPLES / "formaldehyde.toml", "--from", "3"), "--from needs a unit"),
    (("lines", EXAMPLES / "formaldehyde.toml", "--from", "3 GHz", "--to", "2 GHz"), "must not be above --to"),
    (("lines", EXAMPLES / "formaldehyde.toml", "--temperature", "3 m"), "--temperature has the wrong unit"),
    (("lines", EXAMPLES / "formaldehyde.toml", "--min-intensity", "nan"), "--min-intensity must be a number"),
    (("levels", EXAMPLES / "formaldehyde.toml", "--j-max", "2.5"), "must be a whole number from 0 to 200"),
    (("levels", EXAMPLES / "euler_disk.toml"), "there is no molecule"),
    (("levels", EXAMPLES / "none.xyz"), "no such molecule file"),
])  # fmt: skip
def test_mistakes(run, arguments, said):
    told = run(*arguments, code="2")
    assert said in told.err.replace("\n│ ", "") and not told.out and "Traceback" not in told.err
