"""Tumblers by command: numbers, light curves, specs, and one clear error for what cannot be."""

import json

import numpy as np
import pytest

import polhode as ph
from polhode.cli.main import main

APOPHIS = ("--precession", "27.38 h", "--rotation", "263 h", "--moments", "0.61", "0.965", "1")


@pytest.fixture
def run(capsys):
    def of(*arguments, code="0"):
        with pytest.raises(SystemExit, match=code):
            main(["tumble", *map(str, arguments)])
        return capsys.readouterr()

    return of


def test_apophis_by_its_numbers(run):
    told = json.loads(run(*APOPHIS, "--json").out)
    assert told["mode"] == "short-axis"
    assert told["energy_ratio"] == pytest.approx(1.023637, abs=5e-7)
    assert np.degrees(told["cone_angle"]) == pytest.approx(11.0857, abs=5e-5)
    assert told["periods"]["long_axis"] == pytest.approx(30.56 * 3600, abs=20)
    assert told["units"]["cone_angle"].startswith("rad")
    assert [other["mode"] for other in told["others"]] == ["long-axis"]
    first = told["frequencies"][0]
    assert (first["precession_order"], first["rotation_order"]) == (2, -2)


def test_units_order_and_axes_may_be_others(run):
    given = ("--precession", "1833.7 min", "--axis", "long", "--rotation", "10.9583333333 d",
             "--moments", "1 kg*m^2", "610 g*m^2", "0.965 kg*m^2")  # fmt: skip
    told = json.loads(run(*given, "--json").out)
    assert told["energy_ratio"] == pytest.approx(1.023637, abs=1e-5)
    axes = np.sqrt([0.965 + 1 - 0.61, 0.61 + 1 - 0.965, 0.61 + 0.965 - 1])
    told = json.loads(run(*APOPHIS[:4], "--semi-axes", *axes, "--json").out)
    assert told["energy_ratio"] == pytest.approx(1.023637, abs=5e-7)


def test_a_known_tumbler_has_errors_and_a_source(run):
    told = json.loads(run("Apophis", "--diameter", "0.34 km", "--json").out)
    assert "Pravec" in told["source"]
    low, high = told["errors"]["energy_ratio"]["interval"]
    assert low < 1.024 - 0.005 < 1.024 + 0.005 < high
    assert told["damping_time"] == pytest.approx(5e11 / (2000 * 0.03 * 170**2 * (2 * np.pi / 98568) ** 3), rel=1e-9)
    text = run("--list").out
    assert "krylov" in text
    assert "Science 270" in text


@pytest.mark.long
def test_light_curve_spec_and_figures_are_written(run, tmp_path):
    told = json.loads(run("krylov", "--out", tmp_path / "k.csv", "--figures", tmp_path / "f", "--json").out)
    assert {path.name for path in (tmp_path / "f").iterdir()} == {"polhode.png", "light_curve.png", "spectrum.png"}
    table = np.loadtxt(tmp_path / "k.csv", delimiter=",", skiprows=1)
    assert np.ptp(table[:, 1]) == pytest.approx(told["range"])
    run("krylov", "--out", tmp_path / "k.toml")
    motion = ph.read_spec(tmp_path / "k.toml").motion().trajectory.source
    assert np.array(motion.tumbling_periods) / 3600 == pytest.approx([67.27, 368.7], rel=1e-9)


@pytest.mark.parametrize(("arguments", "words"), [
    (["apofis"], "did you mean apophis"), (["2008-tc3"], "--moments is missing"), ([], "are missing"),
    (["krylov", "--mode", "both"], "--mode must be"), (["krylov", "--axis", "x"], "--axis must be"),
    (["toutatis", "--mode", "short-axis"], "one in the long-axis mode"), (["krylov", "--out", "k.png"], ".csv"),
    (["krylov", "--density", "2 g/cm^3"], "needs --diameter"), (["krylov", "--aspect", "300 deg"], "between 0 and 180"),
    (["krylov", "--precession", "27"], "needs a unit"), (["krylov", "--precession", "1 ± 2 ± 3 h"], "must be like"),
    (["krylov", "--rotation", "-3 h"], "must be positive"), (["krylov", "--moments", "1", "2", "x"], "--moments"),
    (["krylov", "--moments", "1", "1", "1"], "sphere"), (["krylov", "--semi-axes", "1", "0", "1"], "--semi-axes"),
    (["krylov", "--moments", "1", "2", "2.5", "--semi-axes", "3", "2", "1"], "Leave one out"),
    (["krylov", "--rotation", "300 h"], "more than 4.674"),
])  # fmt: skip
def test_one_clear_error(run, arguments, words):
    said = run(*arguments, code="2").err
    assert words in said
    assert len(said.splitlines()) == 1
