"""The wobble by command, from a file of the IERS's form to numbers, data and figures."""

import json

import numpy as np
import pytest
import xarray as xr

from celestial.wobbling import AMPLITUDE, DAY, MAS, kicked, lines
from polhode.cli.main import main


@pytest.fixture
def run(capsys):
    def of(*arguments, code="0"):
        with pytest.raises(SystemExit, match=code):
            main([str(argument) for argument in arguments])
        return capsys.readouterr()

    return of


@pytest.fixture(scope="module")
def series(tmp_path_factory):
    times, x, y = kicked(np.random.default_rng(6), 40.0)
    return times, x, y, written(tmp_path_factory.mktemp("pole") / "made.txt", times, x, y)


def written(path, times, x, y):
    rows = [f"1962   1   1   0 {37665 + t / DAY:10.2f} {a:12.6f}{b:12.6f}" + 6 * " 0.0" + " 0.00005 0.00005\n"
            for t, a, b in zip(times, x / MAS / 1000, y / MAS / 1000, strict=True)]  # fmt: skip
    path.write_text("# YR MM DD HH MJD x y\n" + "".join(rows))
    return path


@pytest.mark.sweep
def test_numbers_data_and_figures(run, series, tmp_path):
    times, _, _, path = series
    said = run("wobble", path, "--json", "--out", tmp_path / "w.nc", "--figures", tmp_path / "figures")
    found = json.loads(said.out)
    assert abs(found["chandler_period_days"] - 433) < 5 * found["chandler_period_days_error"] < 30
    assert 0.2 < found["chandler_amplitude_mas"] / (AMPLITUDE / MAS) < 3 and found["chandler_amplitude_mas_error"] > 0
    assert found["quality_factor_interval"][0] < 100 < found["quality_factor_interval"][1]
    assert found["quality_factor_error"] > 0
    assert found["retrograde_energy_ratio"] < 0.01
    stages = [stage["stage"] for stage in found["euler_chain"]]
    assert stages == ["rigid", "elastic", "fluid_core", "oceans", "anelastic"]
    assert found["units"]["chandler_period_days"] == "d" and found["units"]["windows.amplitude_mas"] == "mas"
    assert found["terms"]["annual_prograde"]["amplitude_mas"] == pytest.approx(90, abs=10)
    assert found["span"][0] == "1962-01-01" and len(found["files"]) == 4
    data = xr.open_dataset(tmp_path / "w.nc", engine="h5netcdf", decode_times=False)
    assert np.allclose(data.amplitude / MAS, [row["amplitude_mas"] for row in found["windows"]])
    assert data.psi_east.attrs["units"] == "rad" and len(data.excitation) == len(times) - 1
    pictures = {file.name for file in (tmp_path / "figures").iterdir()}
    assert pictures == {"pole_spiral.png", "chandler_over_time.png", "pole_spectrum.png"}
    text = run("wobble", path, "--from", "1966-01-01", "--to", "1996-01-01", "--window", "8").out
    assert "Windows of 8 years" in text and "fluid core" in text and "1966-01-" in text


@pytest.mark.long_cases("options5-the window must be from 4 years", "options6-the window must be from 4 years")
@pytest.mark.parametrize(("options", "words"), [
    (("--from", "2000-01-01", "--to", "1976-01-01"), "--from must be before --to"),
    (("--from", "1976-01-32"), "--from must be a day like 1976-01-01"),
    (("--from", "2200-01-01"), "made.txt has no data between"),
    (("--from", "1962-01-01", "--to", "1970-01-01"), "must last 12.8 years"),
    (("--window", "six"), "--window must be a number of years"),
    (("--window", "2"), "the window must be from 4 years"),
    (("--window", "90"), "the window must be from 4 years"),
])  # fmt: skip
def test_one_clear_error(run, series, tmp_path, options, words):
    said = run("wobble", series[3], *options, "--figures", tmp_path / "figures", "--out", tmp_path / "w.nc", code="2")
    assert words in said.err and said.err.count("\n") == 1 and not said.out
    assert not list(tmp_path.iterdir())


def test_a_flipped_sign_is_said(run, series, tmp_path):
    times, x, y, _ = series
    said = run("wobble", written(tmp_path / "flipped.txt", times, x, -y), code="2")
    assert "turns against the Earth's spin" in said.err and "Change the sign of y" in said.err


def test_the_input_is_spared(run, series):
    before = series[3].read_text()
    run("wobble", series[3], "--out", series[3], code="2")
    assert series[3].read_text() == before


@pytest.mark.long
def test_a_second_wobble_leaves_no_errors_anywhere(run, tmp_path):
    """Of 400 d, half as large: it had Q ± and periods ± in text, JSON and data, and the exit code was 0."""
    times, x, y = lines(np.random.default_rng(3), 30.0)
    other = 60 * MAS * np.exp(2j * np.pi * times / (400 * DAY))
    path = written(tmp_path / "two.txt", times, x + other.real, y - other.imag)
    told = run("wobble", path, "--json", "--out", tmp_path / "two.nc", code="3")
    found = json.loads(told.out)
    assert found["residual_probability"] < 1e-4 and found["whiteness"] < 1e-4
    errors = {name: value for name, value in found.items() if name.endswith(("_error", "_interval", "_interval_68"))}
    assert len(errors) == 9 and set(errors.values()) == {None}
    rows = [*found["terms"].values(), *found["windows"]]
    assert {row["amplitude_mas_error"] for row in rows} == {None}
    assert "Something else moves the pole" in found["summary"] and "±" not in found["summary"]
    data = xr.open_dataset(tmp_path / "two.nc", engine="h5netcdf", decode_times=False)
    assert np.isnan(data.wobble_error).all() and np.isnan(data.amplitude_error).all() and "not noise" in data.misfit
    assert "±" not in run("wobble", path, code="3").out
