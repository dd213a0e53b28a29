"""The inertia of a thrown body by command, from logs to numbers, data and figures."""

import json
import shutil
from pathlib import Path

import numpy as np
import pytest
import xarray as xr
from scipy.integrate import solve_ivp

import polhode as ph
from measuring.thrown import euler
from polhode.cli.main import main

EXAMPLE = Path(__file__).parents[2] / "examples" / "phone_throw.csv"
SIZE = np.array([0.071, 0.147, 0.0078])
TRUE = np.sort(np.sum(SIZE**2) - SIZE**2)
TRUE = TRUE / TRUE[2]


@pytest.fixture
def run(capsys):
    def of(*arguments, code="0"):
        with pytest.raises(SystemExit, match=code):
            main([str(argument) for argument in arguments])
        return capsys.readouterr()

    return of


def log(path, moments, rates, noise=1e-3, seed=1, axes=None):
    times = np.arange(0.0, 0.9, 0.01)
    motion = ph.FreeMotion(moments, angular_velocity=rates)
    body = motion.angular_velocity(times)
    seen = (body if axes is None else body @ axes.T) + noise * np.random.default_rng(seed).normal(size=(len(times), 3))
    rows = [f"{t:.4f};{x:.8f};{y:.8f};{z:.8f}".replace(".", ",") for t, (x, y, z) in zip(times, seen, strict=True)]
    path.write_text("t_s;gx;gy;gz\n" + "\n".join(rows) + "\n")
    return path


COLUMNS = ("--time", "t_s", "--gyro", "gx,gy,gz", "--unit", "rad/s")


@pytest.mark.long
def test_the_example_gives_the_ratios_it_was_made_with(run, tmp_path):
    said = run("fit", EXAMPLE, "--out", tmp_path / "fit.nc", "--figures", tmp_path / "figures", "--json",
               "--moment", "I3 = 3.3e-4 kg*m^2")  # fmt: skip
    found = json.loads(said.out)
    for name, true in zip(("I1/I3", "I2/I3"), TRUE, strict=False):
        one = found["ratios"][name]
        assert abs(one["value"] - true) < 3 * one["standard_error"] < 0.03
        assert one["interval"][0] < one["value"] < one["interval"][1]
    assert found["window"] == pytest.approx([1.2, 1.9], abs=0.02) and found["degenerate"] is None
    assert found["drag"] is None and found["regime"] == "short-axis"
    assert abs(found["bias"]["value"][0] - 0.02) < 3 * found["bias"]["standard_error"][0]
    assert 1e-3 < found["rms"] < 3e-3
    assert found["moments"]["value"] == pytest.approx(
        [3.3e-4 * found["ratios"]["I1/I3"]["value"], 3.3e-4 * found["ratios"]["I2/I3"]["value"], 3.3e-4])  # fmt: skip
    data = xr.open_dataset(tmp_path / "fit.nc", engine="h5netcdf")
    left = data.angular_velocity.values - data.fitted_angular_velocity.values
    assert np.sqrt(np.mean(left**2)) == pytest.approx(found["rms"], rel=1e-9)
    names = {path.name for path in (tmp_path / "figures").iterdir()}
    assert names == {"data_and_fit.png", "residuals.png", "polhode.png", "corner.png"}
    assert set(found["files"]) == {str(tmp_path / "fit.nc"), *(str(tmp_path / "figures" / name) for name in names)}


def test_the_example_says_that_it_is_synthetic():
    assert "SYNTHETIC" in EXAMPLE.read_text().splitlines()[0]


@pytest.mark.long
def test_the_text_says_ratios_regime_and_model(run):
    said = run("fit", EXAMPLE, "--no-drag", "--no-gain", "--window", "1.2,1.9").out
    said = " ".join(said.split())
    assert "I1/I3" in said and "as given" in said and "chosen" in said
    assert "turning about the middle axis, over which it flips" in said  # (9, 1, 1.2) rad/s; moments of a phone


@pytest.mark.long
def test_two_throws_with_decimal_commas_are_fitted_together(run, tmp_path):
    moments = (0.4, 0.7, 1.0)
    paths = [
        log(tmp_path / "a.csv", moments, (2.0, 9.0, 3.0)),
        log(tmp_path / "b.csv", moments, (9.0, 1.0, 3.0), 1e-3, 2),
    ]
    windows = ("--window", "0,0.89", "--window", "0,0.89")
    found = json.loads(run("fit", *paths, *COLUMNS, *windows, "--no-drag", "--no-gain", "--json").out)
    assert [throw["log"] for throw in found["throws"]] == ["a.csv", "b.csv"]
    for name, true in zip(("I1/I3", "I2/I3"), moments, strict=False):
        assert abs(found["ratios"][name]["value"] - true) < 4 * found["ratios"][name]["standard_error"] < 0.01


@pytest.mark.long_after(1)
@pytest.mark.parametrize("moments, rates", [((1.0, 1.0, 1.0), (2.0, 9.0, 3.0)), ((0.4, 0.7, 1.0), (0.0, 0.0, 9.0))])
def test_a_sphere_and_a_steady_spin_give_no_number(run, tmp_path, moments, rates):
    path = log(tmp_path / "a.csv", moments, rates)
    found = json.loads(run("fit", path, *COLUMNS, "--window", "0,0.89", "--json", "--out", tmp_path / "a.nc",
                           "--figures", tmp_path / "f", code="3").out)  # fmt: skip
    assert found["ratios"] is None and found["axes"] is None and found["regime"] is None and found["degenerate"]
    assert found["rms"] is None and found["sigma"] is None and found["bias"] is None and found["rotor"] is None
    assert [path.name for path in (tmp_path / "f").iterdir()] == ["data_and_fit.png"]
    said = run("fit", path, *COLUMNS, "--window", "0,0.89", code="3").out
    assert "not determined" in said
    assert "nan" not in said and "noise of a sample" not in said


def test_degrees_that_are_called_radians_give_no_number(run, tmp_path):
    """At 6 rad a sample a fit took 164 s and gave .97701 ± .00015 for .1914."""
    path = log(tmp_path / "a.csv", 57.3 * np.array((0.1914, 0.8131, 1.0)), 57.3 * np.array((1.2, 9.0, 1.0)))
    found = json.loads(run("fit", path, *COLUMNS, "--window", "0,0.89", "--json", code="3").out)
    assert found["ratios"] is None and "deg/s" in found["degenerate"] and found["models"] == []


@pytest.mark.long
def test_an_added_weight_gives_the_moments(run, tmp_path):
    """The body alone, and with a point of 20 g at r: inertia μ (|r|² − r rᵀ) more, about the common centre of mass."""
    moments, place, mass, weight = np.array([1e-4, 3e-4, 3.6e-4]), np.array([0.05, 0.03, 0.02]), 0.15, 0.02
    added = mass * weight / (mass + weight) * (place @ place * np.eye(3) - np.outer(place, place))
    heavier, axes = np.linalg.eigh(np.diag(moments) + added)
    axes = axes * np.linalg.det(axes)
    rates = np.array([3.0, 9.0, 2.0])
    alone = log(tmp_path / "alone.csv", moments, rates, 1e-4)
    with_it = log(tmp_path / "with.csv", heavier, axes.T @ rates, 1e-4, seed=2, axes=axes)
    given = ("--mass", "150 g", "--added-weight", "20 g at 50, 30, 20 mm", "--weighted", with_it)
    found = json.loads(run("fit", alone, *COLUMNS, *given, "--no-gain", "--no-drag", "--json").out)["moments"]
    assert np.all(abs(np.array(found["value"]) - moments) < 4 * np.array(found["standard_error"]) + 1e-9)
    assert np.all(np.array(found["standard_error"]) < 0.05 * moments)
    assert "belong together" in run("fit", alone, *COLUMNS, *given[:4], code="2").err


@pytest.mark.sweep
def test_a_log_of_attitudes(run, tmp_path):
    times = np.arange(0.0, 2.0, 0.01)
    attitude = ph.FreeMotion((0.2, 0.8, 1.0), angular_velocity=(1.0, 5.0, 1.0)).attitude(times)
    rows = [",".join(f"{x:.9f}" for x in row) for row in np.column_stack([times, attitude])]
    path = tmp_path / "a.csv"
    path.write_text("t_s,q_w,q_x,q_y,q_z\n" + "\n".join(rows) + "\n")
    columns = ("--time", "t_s", "--quat", "q_w,q_x,q_y,q_z")
    found = json.loads(run("fit", path, *columns, "--json").out)
    assert [found["ratios"][name]["value"] for name in ("I1/I3", "I2/I3")] == pytest.approx([0.2, 0.8], abs=1e-6)
    assert "is for gyro logs" in run("fit", path, *columns, "--drag", code="2").err
    run("fit", path, *columns, "--torque", "--out", tmp_path / "fit.nc", "--figures", tmp_path / "figures")
    with xr.open_dataset(tmp_path / "fit.nc") as kept:
        assert kept.ratios.values == pytest.approx([0.2, 0.8], abs=1e-6)
        assert kept.torque.units == "rad s-2"
        assert kept.residual.shape == (200, 3)
    assert {file.name for file in (tmp_path / "figures").iterdir()} == {"residuals.png", "corner.png"}
    assert "would destroy it" in run("fit", path, *columns, "--out", path, code="2").err


def flown(path, rates, moments=TRUE, seconds=0.8):
    """Write a log that rests for 10 s around each throw, of the rates with which the throws begin."""
    parts = [np.zeros((1000, 3))]
    for spin, body in zip(rates, moments, strict=True):
        t = np.arange(0.0, seconds, 0.01)
        parts += [solve_ivp(euler(body, 0.0), (0, seconds), spin, method="DOP853", rtol=1e-9, t_eval=t).y.T, parts[0]]
    w = np.concatenate(parts)
    w = w + 1e-3 * np.random.default_rng(1).normal(size=w.shape)
    rows = [f"{k / 100:.2f},{x:.6f},{y:.6f},{z:.6f}" for k, (x, y, z) in enumerate(w)]
    path.write_text("Time (s)," + ",".join(f"Gyroscope {x} (rad/s)" for x in "xyz") + "\n" + "\n".join(rows) + "\n")
    return path


@pytest.mark.long
def test_all_throws_of_a_log_are_used_and_what_is_left_out_is_listed(run, tmp_path):
    path = flown(tmp_path / "a.csv", [(1.0, 9.0, 1.0), (9.0, 2.0, 2.0), (3.0, 5.0, 5.0)], [TRUE, TRUE, (0.7, 0.3, 0.9)])
    found = json.loads(run("fit", path, "--no-drag", "--no-gain", "--json").out)
    assert [throw["window"][0] for throw in found["throws"]] == pytest.approx([10.0, 20.8], abs=0.03)
    [left] = found["left_out"]
    assert left["window"][0] == pytest.approx(31.6, abs=0.03) and "another inertia" in left["why"]
    assert any("1 stretch that may be a flight" in note for note in found["notes"])
    for name, true in zip(("I1/I3", "I2/I3"), TRUE, strict=False):
        assert abs(found["ratios"][name]["value"] - true) < 4 * found["ratios"][name]["standard_error"] < 0.01
    assert "Left out" in run("fit", path, "--no-drag", "--no-gain").out


def test_a_log_without_a_flight_is_refused_with_what_looks_like_one(run, tmp_path):
    path = flown(tmp_path / "a.csv", [(1.0, 9.0, 1.0)], [TRUE], seconds=0.2)
    said = run("fit", path, "--no-drag", code="2").err
    assert "a.csv: has no free flight" in said and "--window START,END" in said and "Traceback" not in said


@pytest.mark.parametrize(("arguments", "said"), [
    (("--window", "1.2"), "two times in seconds"),
    (("--window", "1.9,1.2"), "start before its end"),
    (("--window", "0.1,0.2", "--window", "0.2,0.3", "--free", "A"), "--free names constants"),
    (("--moment", "3e-4"), "like \"I3 = 1.2e-4"),
    (("--moment", "I3 = 3 g"), "--moment"),
    (("--clip", "35"), "--clip"),
    (("--out", str(EXAMPLE)), "would destroy it"),
])  # fmt: skip
def test_mistakes_end_with_one_message(run, arguments, said):
    found = run("fit", EXAMPLE, *arguments, code="2")
    assert said in found.err and "Traceback" not in found.err and found.out == ""


def test_options_of_logs_are_refused_for_a_molecule(run, tmp_path):
    found = run("fit", EXAMPLE.with_name("water_spectrum.toml"), tmp_path / "x.lin", "--drag", code="2")
    assert "--drag is for gyro logs" in found.err
    assert "one file of lines" in run("fit", EXAMPLE.with_name("water_spectrum.toml"), code="2").err


def test_a_log_that_is_not_there(run, tmp_path):
    shutil.copy(EXAMPLE, tmp_path / "a.csv")
    assert "no such log file" in run("fit", tmp_path / "a.csv", tmp_path / "b.csv", code="2").err
