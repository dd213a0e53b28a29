"""Each distribution against its own law, told otherwise than it is drawn; and against one that is wrong."""

import math
import re
from pathlib import Path

import numpy as np
import pytest
from scipy import stats

from polhode.spec.keys import Number
from polhode.sweeps.distributions import Reader, read_distribution

COUNT = 20_000
AGREES, DIFFERS = 1e-3, 1e-9  # probability of a sample at least so far from the law
KAPPA = 7.0
RPM = 2.0 * math.pi / 60.0
UNIFORM = np.random.default_rng(20261123).random((COUNT, 3))


def drawn(value, length=0, unit="rad/s"):
    found = read_distribution(value, Reader(Number(unit, length)), Path())
    return found.values(UNIFORM[:, : found.dimensions])


def vectors(way="sphere"):
    about = {"mean": [1.0, 2.0, 2.0], "concentration": KAPPA, "length": {"uniform": ["1 rpm", "2 rpm"]}}
    return drawn({"sphere": "60 rpm"} if way == "sphere" else {"von-mises-fisher": about}, 3)


def cosines():
    values = vectors("fisher")
    return values @ (np.array([1.0, 2.0, 2.0]) / 3.0) / np.linalg.norm(values, axis=1)


def turn_angles(quaternions):
    return 2.0 * np.arccos(np.minimum(np.abs(quaternions[:, 0]), 1.0))


def fisher_law(w):
    """Return the distribution function of the cosine, from its density exp(κw) on [−1, 1]."""
    return (np.exp(KAPPA * w) - math.exp(-KAPPA)) / (math.exp(KAPPA) - math.exp(-KAPPA))


def turn_law(angle):
    """Return that of the angle of a rotation drawn by Haar's measure, whose density is (1 − cos θ)/π."""
    return (angle - np.sin(angle)) / math.pi


LAWS = {
    "normal": (lambda: drawn({"normal": ["120 rpm", "5 rpm"]}), stats.norm(120 * RPM, 5 * RPM).cdf),
    "uniform": (lambda: drawn({"uniform": ["-1 rpm", "3 rpm"]}), stats.uniform(-RPM, 4 * RPM).cdf),
    "log-uniform": (lambda: drawn({"log-uniform": ["1 rpm", "100 rpm"]}), stats.loguniform(RPM, 100 * RPM).cdf),
    "sphere x": (lambda: vectors()[:, 0], stats.uniform(-60 * RPM, 120 * RPM).cdf),
    "sphere z": (lambda: vectors()[:, 2], stats.uniform(-60 * RPM, 120 * RPM).cdf),
    "fisher": (cosines, fisher_law),
    "fisher length": (lambda: np.linalg.norm(vectors("fisher"), axis=1), stats.uniform(RPM, RPM).cdf),
    "so3": (lambda: turn_angles(drawn({"so3": "uniform"}, 4, "")), turn_law),
}


def probability(values, law):
    return stats.kstest(values, law).pvalue


@pytest.mark.parametrize("name", LAWS)
def test_values_follow_the_law(name):
    draw, law = LAWS[name]
    assert probability(draw(), law) > AGREES


def test_a_wrong_way_would_be_seen():
    """Normalised cubes, angles drawn evenly, another concentration: each differs from the law beyond chance."""
    cube = 2.0 * UNIFORM - 1.0
    cube /= np.linalg.norm(cube, axis=1, keepdims=True)
    assert probability(60 * RPM * cube[:, 0], LAWS["sphere x"][1]) < DIFFERS
    assert probability(math.pi * UNIFORM[:, 0], turn_law) < DIFFERS
    wrong = drawn({"von-mises-fisher": {"mean": [1, 2, 2], "concentration": 1.1 * KAPPA, "length": "1 rpm"}}, 3)
    assert probability(wrong @ (np.array([1.0, 2.0, 2.0]) / 3.0) / RPM, fisher_law) < DIFFERS


def test_directions_about_the_mean_are_even():
    values = vectors("fisher")
    across = values @ np.array([2.0, -2.0, 1.0]) / 3.0, values @ np.array([2.0, 1.0, -2.0]) / 3.0
    assert probability(np.arctan2(*across), stats.uniform(-math.pi, 2.0 * math.pi).cdf) > AGREES


def test_rotations_are_alike_after_any_turn():
    """Haar's measure is invariant: turned by a fixed quaternion, the angles have the same law."""
    w, x, y, z = drawn({"so3": "uniform"}, 4, "").T
    assert probability(turn_angles(((w - x - y - z) / 2.0)[:, None]), turn_law) > AGREES
    assert np.abs(w * w + x * x + y * y + z * z - 1.0).max() < 1e-15


def test_sharp_concentrations_keep_their_digits():
    value = {"mean": [0, 0, 1], "concentration": 1e12, "length": "1 rad/s"}
    tilt = np.linalg.norm(drawn({"von-mises-fisher": value}, 3)[:, :2], axis=1)
    assert probability(tilt * 1e6, stats.rayleigh().cdf) > AGREES


@pytest.mark.parametrize(
    ("value", "points"),
    [
        (["1 rpm", "5 rpm"], [1, 5]),
        ({"from": "1 rpm", "to": "9 rpm", "count": 5}, [1, 3, 5, 7, 9]),
        ({"from": "1 rpm", "to": "100 rpm", "count": 3, "spacing": "log"}, [1, 10, 100]),
    ],
)
def test_grids(value, points):
    grid = read_distribution({"grid": value}, Reader(Number("rad/s")), Path())
    assert grid.at(np.arange(grid.count)) == pytest.approx(np.array(points) * RPM, rel=1e-15)


def test_tables_are_read_by_column_and_unit(tmp_path):
    (tmp_path / "runs.csv").write_text("run, rate ,T\n1,60,20\n2,30,25.5\n")
    of_rate = {"table": "runs.csv", "column": "rate", "unit": "rpm"}
    rates = read_distribution(of_rate, Reader(Number("rad/s")), tmp_path)
    assert rates.at(np.array([1, 0])) == pytest.approx([30 * RPM, 60 * RPM], rel=1e-15)
    of_heat = {"table": "runs.csv", "column": "T", "unit": "degC"}
    assert read_distribution(of_heat, Reader(Number("K")), tmp_path).at(np.array([1])) == pytest.approx([298.65])


@pytest.mark.parametrize(
    ("value", "length", "words"),
    [
        ("120 rpm", 0, "one of normal, uniform, log-uniform"),
        ({"normal": ["1 rpm"]}, 0, "[mean, standard deviation]"),
        ({"normal": ["1 rpm", "0 rpm"]}, 0, "positive standard deviation"),
        ({"normal": ["1 rpm", "1 Hz"]}, 0, "ambiguous"),
        ({"uniform": ["2 rpm", "1 rpm"]}, 0, "smaller to a larger"),
        ({"log-uniform": ["0 rpm", "1 rpm"]}, 0, "positive value"),
        ({"normal": ["1 rpm", "1 rpm"], "uniform": ["1 rpm", "2 rpm"]}, 0, "one of"),
        ({"normal": ["1 rpm", "1 rpm"], "seed": 1}, 0, "more keys"),
        ({"sphere": "1 rpm"}, 0, "vector of three, and one number"),
        ({"normal": ["1 rpm", "1 rpm"]}, 3, "one number, and a vector"),
        ({"sphere": "0 rpm"}, 3, "positive length"),
        ({"sphere": {"sphere": "1 rpm"}}, 3, "one of normal, uniform, log-uniform,"),
        ({"von-mises-fisher": {"mean": [0, 0, 0], "concentration": 1, "length": "1 rpm"}}, 3, "a direction"),
        ({"grid": {"from": "1 rpm", "to": "2 rpm"}}, 0, "count = 5"),
        ({"grid": {"from": "0 rpm", "to": "2 rpm", "count": 3, "spacing": "log"}}, 0, "positive values"),
        ({"table": "none.csv", "column": "rate", "unit": "rpm"}, 0, "none.csv"),
        ({"table": "none.csv", "column": "rate"}, 0, "keys column, table, unit"),
    ],
)
def test_mistakes_in_words(value, length, words, tmp_path):
    with pytest.raises(ValueError, match=re.escape(words)):
        read_distribution(value, Reader(Number("rad/s", length)), tmp_path)


@pytest.mark.parametrize(
    ("text", "words"),
    [("rate\n", "no rows"), ("a,b\n1,2\n", "one column 'rate'"), ("rate\n1\nx\n", "line 3"), ("rate\ninf\n", "finite")],
)
def test_wrong_tables(text, words, tmp_path):
    (tmp_path / "t.csv").write_text(text)
    with pytest.raises(ValueError, match=words):
        read_distribution({"table": "t.csv", "column": "rate", "unit": "rpm"}, Reader(Number("rad/s")), tmp_path)
