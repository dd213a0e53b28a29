"""Levels and lines of molecules by command."""

import json
from pathlib import Path

import numpy as np
import pytest
import xarray as xr

from polhode.cli.main import main
from polhode.errors import InvalidInput
from polhode.kinds.reading import read_spec
from polhode.spectra import MeasuredLines, Rotor, line_list, read_cat, read_par, spectrum_dataset, write_lin
from polhode.spectra.spec_rotors import SpecRotor, check_summable, rotor_of_spec

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
    result = json.loads(run("levels", EXAMPLES / "water_spectrum.toml", "--json", "--j-max", "1").out)
    assert result["j_max"] == 1 and [row["J"] for row in result["levels"]] == [0, 1, 1, 1]
    assert result["levels"][1]["energy"] / WAVE_NUMBER == pytest.approx(23.79446251, abs=1e-8)
    assert result["levels"][1]["wave_number"] == pytest.approx(2379.446251, abs=1e-6)
    # J = 1 of a rigid rotor: B + C, A + C, A + B, with the masses of the common isotopes
    atoms, spec = (json.loads(run("levels", EXAMPLES / name, "--json", "--j-max", "1").out)
                   for name in ("water.xyz", "water.toml"))  # fmt: skip
    A, B, C = atoms["constants"]
    assert pytest.approx(822482.650e6, abs=1e3) == A
    assert [row["energy"] for row in atoms["levels"]] == pytest.approx([0.0, B + C, A + C, A + B], rel=1e-14)
    assert spec["levels"] == atoms["levels"] and (atoms["name"], spec["name"]) == ("water", "water")


@pytest.mark.long
def test_spin_weights_are_called_so(run):
    """The CDMS has 9 for the upper level at 4829.66 MHz: 2J + 1 = 3 times 3 of the hydrogens' spins."""
    given = run("lines", EXAMPLES / "formaldehyde.toml", "--to", "5 GHz", "--min-intensity", "1e-6").out.splitlines()
    (head,) = [line.split() for line in given if line.startswith("line ")]
    (row,) = [line.split() for line in given if line.startswith("1_1,0 ")]
    assert head[-1] == "g_ns" and (2 * 1 + 1) * int(row[-1]) == 9
    given = run("levels", EXAMPLES / "formaldehyde.toml").out.splitlines()
    (head,) = [line for line in given if line.startswith("level ")]
    assert head.split()[-1] == "g_ns"


@pytest.mark.long
def test_lines_between_frequencies(run):
    """Three lines of formaldehyde as measured [MHz], and their intensities in the CDMS."""
    path = EXAMPLES / "formaldehyde.toml"
    result = json.loads(run("lines", path, "--json", "--to", "150 GHz", "--min-intensity", "1e-6").out)
    assert result["partition_function"] == pytest.approx(2883.02, abs=0.01)
    nearest = [min(result["lines"], key=lambda line: abs(line["frequency"] / MHZ - nu))
               for nu in (4829.660, 72837.948, 140839.502)]  # fmt: skip
    assert [line["lg_intensity"] for line in nearest] == pytest.approx([-5.9024, -4.1792, -2.9775], abs=1e-4)
    assert nearest[1]["frequency"] / MHZ == pytest.approx(72837.948, abs=0.01)
    assert all(line["frequency"] <= 150e9 and line["intensity"] >= 1e-18 for line in result["lines"])
    frequencies = [line["frequency"] for line in result["lines"]]
    assert frequencies == sorted(frequencies) and len(frequencies) == result["lines_within"]


def test_levels_and_lines_as_netcdf(run, tmp_path):
    """What is written is what is printed; levels of J = 1 are sums of two constants."""
    path, files = EXAMPLES / "water_spectrum.toml", (tmp_path / "levels.nc", tmp_path / "lines.nc")
    run("levels", EXAMPLES / "water.xyz", "--j-max", "1", "--out", files[0])
    said = json.loads(run("lines", path, "--json", "--j-max", "3", "--most", "4", "--out", files[1]).out)
    with xr.open_dataset(files[0]) as result:
        A, B, C = result.attrs["rotational_constants_hertz"]
        assert result.energy.units == "Hz" and result.symmetry.values.tolist() == ["A", "Ba", "Bb", "Bc"]
        assert result.energy.values == pytest.approx([0.0, B + C, A + C, A + B], rel=1e-14)
        assert result.Ka.values.tolist() == [0, 0, 1, 1]
    with xr.open_dataset(files[1]) as result:
        assert result.line_frequency.values.tolist() == [line["frequency"] for line in said["lines"]]
        assert result.line_upper.sel(quantum_number="Ka").values.tolist() == [x["upper"][1] for x in said["lines"]]
        assert (result.line_intensity.units, result.attrs["temperature_kelvin"]) == ("m2 Hz", 300.0)
        assert result.attrs["reduction"] == "A" and result.attrs["representation"] == "Ir"
    assert said["files"] == [str(files[1])]
    with pytest.raises(InvalidInput, match="`levels` or `lines`"):
        spectrum_dataset()


def test_nothing_half_written(run, tmp_path):
    missing, taken = tmp_path / "none" / "levels.nc", tmp_path / "copy.xyz"
    taken.write_text((EXAMPLES / "water.xyz").read_text())
    assert "none" in run("levels", taken, "--out", missing, code="[^0]").err
    assert "would destroy it" in run("levels", taken, "--out", taken, code="[^0]").err
    assert sorted(path.name for path in tmp_path.iterdir()) == ["copy.xyz"]


def test_too_many_lines_are_refused_before_they_are_computed(run):
    """J³/2 for each component of the dipole: counted 510,045 at J = 100 for one."""
    said = run("lines", EXAMPLES / "formaldehyde.toml", "--j-max", "1000", code="[^0]").err
    assert "about 500 million lines" in said and "Lower --j-max to 296" in said
    with pytest.raises(InvalidInput, match="Lower `j_max` to 205"):
        check_summable(SpecRotor(Rotor((27e9, 14e9, 9e9), dipole=(1e-30, 1e-30, 1e-30)), 10.0, 206))


@pytest.mark.long
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
    (("lines", EXAMPLES / "water.xyz"), "without a dipole has no lines. Give one, like --dipole"),
    (("lines", EXAMPLES / "water.xyz", "--dipole", "1,2"), "--dipole must be three numbers"),
    (("lines", EXAMPLES / "formaldehyde.toml", "--from", "3"), "--from needs a unit"),
    (("lines", EXAMPLES / "formaldehyde.toml", "--from", "3 GHz", "--to", "2 GHz"), "must not be above --to"),
    (("lines", EXAMPLES / "formaldehyde.toml", "--temperature", "3 m"), "--temperature has the wrong unit"),
    (("lines", EXAMPLES / "formaldehyde.toml", "--min-intensity", "nan"), "must be a number in decimal digits"),
    (("levels", EXAMPLES / "formaldehyde.toml", "--j-max", "2.5"), "must be a whole number from 0 to 1000"),
    (("levels", EXAMPLES / "euler_disk.toml"), "there is no molecule"),
    (("levels", EXAMPLES / "none.xyz"), "no such molecule file"),
])  # fmt: skip
def test_mistakes(run, arguments, said):
    given = run(*arguments, code="2")
    assert said in given.err.replace("\n│ ", "") and not given.out and "Traceback" not in given.err


@pytest.fixture
def measured(tmp_path):
    """Lines of sulfur dioxide's own constants, with errors of 20 kHz."""
    spec = read_spec(EXAMPLES / "sulfur_dioxide.toml")
    result, rng = rotor_of_spec(spec).rotor.lines(8), np.random.default_rng(2)
    kept = np.sort(rng.choice(len(result.frequency), 60, replace=False))
    error = np.full(60, 20e3)
    path = tmp_path / "measured.lin"
    frequency = result.frequency[kept] + error * rng.normal(size=60)
    write_lin(line_list(MeasuredLines(result.upper[kept], result.lower[kept], frequency, error)), path)
    return path


def test_a_fit_comes_back_to_the_constants(run, measured, tmp_path):
    """From rigid constants that are off, by chance within four of the errors."""
    start = tmp_path / "start.toml"
    text = (EXAMPLES / "sulfur_dioxide.toml").read_text("utf-8")
    start.write_text(text.replace("60778.5522", "60779.5").replace("10318.0722", "10318.5"), "utf-8")
    out = tmp_path / "fitted.par"
    result = json.loads(run("fit", start, measured, "--json", "--out", out).out)
    rotor = rotor_of_spec(read_spec(EXAMPLES / "sulfur_dioxide.toml")).rotor
    wanted = dict(zip("ABC", rotor.constants, strict=True)) | dict(rotor.distortion)
    assert set(result["constants"]) == set(wanted) and result["units"]["constants.value"] == "Hz"
    for name, row in result["constants"].items():
        assert abs(row["value"] - wanted[name]) < 4.0 * row["standard_error"], name
    assert 0.7 < result["rms"] < 1.3 and result["degrees_of_freedom"] == 60 - len(wanted)
    assert np.allclose(np.diag(result["correlation"]), 1.0) and result["files"] == [str(out)]
    kept = read_par(out)
    assert kept.value[0] * MHZ == pytest.approx(result["constants"]["A"]["value"], rel=1e-14)
    assert kept.error[0] * MHZ == pytest.approx(result["constants"]["A"]["standard_error"], rel=1e-6)


def test_a_fit_in_words(run, measured):
    said = run("fit", EXAMPLES / "sulfur_dioxide.toml", measured, "--free", "A,B,C").out
    assert "3 constants from 60 observations" in said and "Observations that fit worst" in said


TOP = """
[system]
kind = "quantum-rotor"
constants = ["158099 MHz", "9198 MHz", "9198 MHz"]
reduction = "S"
representation = "Ir"
[system.distortion]
D_J = "3 kHz"
D_JK = "170 kHz"
"""


def test_a_symmetric_top_is_fitted_by_the_plain_command(run, tmp_path):
    """Lines of methyl cyanide by 2(J + 1)(B − D_JK K²) − 4 D_J (J + 1)³; the command said: A is not determined."""
    (tmp_path / "top.toml").write_text(TOP)
    lines = [(J + 1, K, J + 1 - K, J, K, J - K, 2 * (J + 1) * (9198.899 - 0.1774 * K**2) - 4 * 3.8e-3 * (J + 1) ** 3)
             for J in range(7) for K in range(J + 1)]  # fmt: skip
    text = "".join("".join(f"{n:3d}" for n in line[:6]) + f"{'':18}{line[6]:16.6f} 0.001\n" for line in lines)
    (tmp_path / "top.lin").write_text(text)
    for free, kept in (((), True), (("--free", "C,B,D_J,D_JK"), False)):
        result = json.loads(run("fit", tmp_path / "top.toml", tmp_path / "top.lin", *free, "--json").out)
        name = "C" if free else "B"
        assert list(result["constants"]) == [name, "D_J", "D_JK"] and result["rms"] < 1e-2
        assert result["constants"][name]["value"] == pytest.approx(9198.899e6, abs=2.0)
        assert any("fitted as one" in note for note in result["notes"])
        assert any("A is kept as the spec says" in note for note in result["notes"]) == kept


@pytest.mark.long
def test_lines_and_constants_for_other_programs(run, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    said = run("export", EXAMPLES / "formaldehyde.toml", "--to", "cat", "--to", "par").out
    assert "formaldehyde.cat: rotational lines" in said and "formaldehyde.par" in said
    catalogue = read_cat(tmp_path / "formaldehyde.cat")
    nearest = int(np.argmin(np.abs(catalogue.frequency - 72837.948)))
    assert catalogue.log_intensity[nearest] == pytest.approx(-4.1792, abs=1e-4)
    assert catalogue.frequency.max() < 1e8
    assert read_par(tmp_path / "formaldehyde.par").value[0] == pytest.approx(281970.5780043, rel=1e-14)


@pytest.mark.sweep
def test_mistakes_of_fits_and_exports(run, measured, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    path = EXAMPLES / "sulfur_dioxide.toml"
    for arguments, said in (
        (("fit", path, tmp_path / "none.lin"), "none.lin"),
        (("fit", path, measured, "--free", "A,X"), "got 'X'"),
        (("fit", path, measured, "--free", "A,,B"), "--free must be names"),
        (("fit", path, measured, "--out", measured), "is the file that is read"),
        (("export", EXAMPLES / "euler_disk.toml", "--to", "cat"), "there is no molecule"),
        (("export", EXAMPLES / "water.toml", "--to", "cat"), "without a dipole has no lines"),
    ):  # fmt: skip
        given = run(*arguments, code="2")
        assert said in given.err.replace("\n│ ", "") and "Traceback" not in given.err
    assert not (tmp_path / "euler_disk.cat").exists()


@pytest.mark.long
def test_a_molecule_is_exported_as_netcdf(tmp_path, capsys):
    spec = Path(__file__).parents[2] / "examples" / "water_spectrum.toml"
    with pytest.raises(SystemExit, match="0"):
        main(["export", str(spec), "--to", "netcdf", "--out", str(tmp_path / "w.nc")])
    with xr.open_dataset(tmp_path / "w.nc") as result:
        rotor = rotor_of_spec(read_spec(spec))
        assert np.array_equal(result.energy.values, rotor.rotor.levels(rotor.j_max).energy)
        assert result.attrs["reduction"] == "A"
        assert "line_frequency" in result
    said = capsys.readouterr()
    assert "levels and lines" in said.out
    assert "UserWarning" not in said.err


def test_lines_of_another_molecule_give_no_errors_anywhere(run, tmp_path):
    """Lines of a molecule of half the centrifugal distortion: .par and .var had σ, and Python's fit too."""
    rotor = rotor_of_spec(read_spec(EXAMPLES / "sulfur_dioxide.toml")).rotor
    stiffer = {name: 0.5 * value for name, value in rotor.distortion.items()}
    result = Rotor(rotor.constants, stiffer, rotor.reduction.name, rotor.representation.name, rotor.dipole).lines(12)
    kept = np.random.default_rng(3).permutation(np.flatnonzero(result.frequency < 4e11))[:60]
    lines = MeasuredLines(result.upper[kept], result.lower[kept], result.frequency[kept], np.full(60, 20e3))
    write_lin(line_list(lines), tmp_path / "other.lin")
    for ending in ("par", "var"):
        out = tmp_path / f"fitted.{ending}"
        said = run("fit", EXAMPLES / "sulfur_dioxide.toml", tmp_path / "other.lin", "--free", "A,B", "--out", out,
                   "--json", code="3")  # fmt: skip
        given = json.loads(said.out)
        assert {row["standard_error"] for row in given["constants"].values()} == {None} and given["correlation"] is None
        kept = read_par(out)
        errors = dict(zip(kept.label, kept.error, strict=True))
        assert errors["A"] == errors["B"] == 1e37 and errors["C"] == 1e-37  # free, and fixed
        assert kept.title.startswith("residuals are not noise") and kept.correlation is None


def test_errors_of_lines_that_are_too_small_alike_enlarge_those_of_constants(run, tmp_path):
    """By Birge's ratio; σ in words, JSON and file was too small by 1.5."""
    rotor = rotor_of_spec(read_spec(EXAMPLES / "sulfur_dioxide.toml")).rotor
    result, rng = rotor.lines(12), np.random.default_rng(5)
    kept = rng.permutation(np.flatnonzero(result.frequency < 4e11))[:60]
    frequency, given = result.frequency[kept] + 30e3 * rng.normal(size=60), []
    for error in (20e3, 30e3):
        write_lin(line_list(MeasuredLines(result.upper[kept], result.lower[kept], frequency, np.full(60, error))),
                  tmp_path / "some.lin")  # fmt: skip
        given.append(json.loads(run("fit", EXAMPLES / "sulfur_dioxide.toml", tmp_path / "some.lin", "--free", "A,B,C",
                                   "--out", tmp_path / "some.par", "--json").out))  # fmt: skip
        assert read_par(tmp_path / "some.par").error[0] * MHZ == pytest.approx(
            given[-1]["constants"]["A"]["standard_error"], rel=1e-6)  # fmt: skip
    small, right = (one["constants"]["A"]["standard_error"] for one in given)
    ratio = np.sqrt(60 / 57) * given[0]["rms"]  # √(χ²/ν)
    assert 1.2 < given[0]["rms"] < 1.9 and small == pytest.approx(right * ratio * 20 / 30, rel=1e-6)
    assert any("Errors of the constants are enlarged by" in note for note in given[0]["notes"])
    assert not any("enlarged" in note for note in given[1]["notes"])
