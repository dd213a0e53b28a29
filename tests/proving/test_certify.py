"""`polhode certify`: enclosures of a spec's motion, of its decimals where it gives them."""

import json
import re
from fractions import Fraction

import pytest

from polhode.cli.main import main
from spec.mutations import EXAMPLES

FREE = """
[body]
moments = ["3e7 g*cm^2", "1 kg*m^2", "2 kg*m^2"]
[spin]
{spin}
"""
GIVEN = 'momentum = ["1 kg*m^2/s", "0.3 kg*m^2/s", "0.2 kg*m^2/s"]'
PERIOD = "20.2049347380819979889700509566080377946"


@pytest.fixture
def run(capsys):
    def of(*arguments, code="0"):
        with pytest.raises(SystemExit, match=code):
            main([str(argument) for argument in arguments])
        return capsys.readouterr()

    return of


@pytest.fixture
def spec(tmp_path):
    def of(text):
        path = tmp_path / "body.toml"
        path.write_text(text)
        return path

    return of


def holds(result, value):
    return abs(Fraction(result["decimals"]) - Fraction(value)) <= Fraction(result["radius"])


def test_the_decimals_in_the_file_are_enclosed(run, spec):
    """The moments in another order and unit, as the body's own axes are sorted."""
    path = spec(FREE.format(spin=GIVEN + "\nattitude = [0.8, 0.6, 0.0, 0.0]"))
    result = json.loads(run("certify", path, "--digits", "38", "--at", "0.1 h", "--at", "1e9 s", "--json").out)
    assert {"name", "kind", "summary", "units", "notes", "files"} <= set(result) and result["kind"] == "certify"
    assert set(result["taken"].values()) == {"the decimals in the file"}
    assert result["regime"] == "short-axis" and result["encircled_axis"] == 3
    assert holds(result["period"], PERIOD) and Fraction(result["period"]["radius"]) < Fraction(1, 10**35)
    assert result["period"]["value"] == float(PERIOD) and result["units"]["period.value"] == "s, the nearest double"
    assert result["verdicts"] == {"axis_1": "stable", "axis_2": "unstable", "axis_3": "stable"}
    assert [row["time"] for row in result["states"]] == ["0.1 h"] * 7 + ["1e9 s"] * 7
    later = {row["component"]: row for row in result["states"][7:]}
    assert sum(Fraction(later[f"L{k}"]["decimals"]) ** 2 for k in "123") - Fraction("1.13") < Fraction(1, 10**35)
    assert holds(result["momentum_square"], "1.13")


def test_the_text_says_numbers_and_radii(run, spec):
    said = " ".join(run("certify", spec(FREE.format(spin=GIVEN)), "--at", "2 s").out.split())
    assert "20.20493473808199798897005 ± 1e-24 s" in said and "spin about axis 2 unstable" in said
    assert "moments the decimals in the file" in said and "States at value 2 s w " in said


@pytest.mark.parametrize(("spin", "taken"), [
    ('angular_velocity = ["0.1 rad/s", "0.3 rad/s", "0.2 rad/s"]\nframe = "principal"', "the decimals in the file"),
    ('angular_velocity = ["0.1 deg/s", "0.3 rad/s", "0.2 rad/s"]', "the nearest doubles"),
    ('rate = "0.1 rad/s"\nabout = "y"', "the decimals in the file"),
    ('rate = "0.1 rad/s"\nabout = 2\ntilt = "10 deg"', "the nearest doubles"),
    ('rate = "60 rpm"\nabout = 1', "the nearest doubles"),
])  # fmt: skip
def test_what_the_file_gives_otherwise_is_of_doubles(run, spec, spin, taken):
    result = json.loads(run("certify", spec(FREE.format(spin=spin)), "--json").out)
    assert result["taken"]["momentum"] == taken and result["taken"]["moments"] == "the decimals in the file"


def test_a_separatrix_of_decimals_is_one(run, spec):
    """0.1 · 0.6 · 0.1² = 0.2 · 0.3 · 0.1², which no doubles say."""
    text = FREE.replace("3e7 g*cm^2", "0.3 kg*m^2").replace('"1 kg', '"0.4 kg').replace('"2 kg', '"0.6 kg')
    spin = 'momentum = ["0.1 kg*m^2/s", "0.25 kg*m^2/s", "0.1 kg*m^2/s"]'
    result = run("certify", spec(text.format(spin=spin)))
    assert "regime separatrix" in result.out and "infinite" in result.out
    assert json.loads(run("certify", spec(text.format(spin=spin)), "--json").out)["period"]["value"] is None


def test_tops_and_bodies_with_shapes_are_of_doubles(run):
    for name in ("top", "t_handle"):
        result = json.loads(run("certify", EXAMPLES / f"{name}.toml", "--json", "--at", "1 s").out)
        assert result["taken"]["moments"] == "the nearest doubles" and len(result["states"]) == 7
    assert run("certify", EXAMPLES / "top.toml").out.count("axis ") >= 2


@pytest.mark.parametrize(("arguments", "words"), [
    (("euler_disk.toml",), "euler-disk has no closed form.*free-body and lagrange-top have one.*polhode.certify"),
    (("t_handle.toml", "--at", "3"), "--at needs a unit"),
    (("t_handle.toml", "--at", "3 kg"), "--at has the wrong unit"),
    (("t_handle.toml", "--digits", "0"), "digits"),
])  # fmt: skip
def test_bad_input_is_one_message(run, arguments, words):
    said = run("certify", EXAMPLES / arguments[0], *arguments[1:], code="2")
    assert re.search(words, said.err) and not said.out
