"""Samples depend on their number alone; designs give what they are for."""

import math
from pathlib import Path

import numpy as np
import pytest

from polhode.spec.keys import Number
from polhode.sweeps.distributions import Reader, read_distribution
from polhode.sweeps.sampling import Design
from polhode.sweeps.sensitivity import sobol_indices


def spread(value, length=0, unit=""):
    return read_distribution(value, Reader(Number(unit, length)), Path())


INPUTS = {"a": spread({"normal": [0.0, 1.0]}), "q": spread({"so3": "uniform"}, 4), "b": spread({"uniform": [1.0, 2.0]})}
DESIGNS = {
    "random": Design(INPUTS, 1000, 3),
    "sobol": Design(INPUTS, 1000, 3, "sobol"),
    "crossed": Design(INPUTS, 200, 3, "random", True),
    "grids": Design(INPUTS | {"g": spread({"grid": [1, 2, 3]}), "h": spread({"grid": [5, 6]})}, 7, 3),
}


@pytest.mark.parametrize("name", DESIGNS)
def test_parts_are_the_same_numbers_as_the_whole(name):
    design = DESIGNS[name]
    whole = design.values(0, design.count)
    for low, high in ((0, 1), (1, 6), (5, design.count - 1), (design.count - 1, design.count)):
        part = design.values(low, high)
        assert all(np.array_equal(part[key], whole[key][low:high]) for key in design.inputs)
    assert list(whole) == list(design.inputs) and all(len(values) == design.count for values in whole.values())


def test_seeds_and_other_inputs():
    """Another seed gives other numbers; another input leaves random ones as they are."""
    one, other = DESIGNS["random"].values(0, 50), Design(INPUTS, 1000, 4).values(0, 50)
    alone = Design({"b": INPUTS["b"]}, 1000, 3).values(0, 50)
    assert not np.isin(one["a"], other["a"]).any()
    assert np.array_equal(one["b"], alone["b"])
    assert abs(np.corrcoef(DESIGNS["random"].values(0, 1000)["a"], DESIGNS["random"].values(0, 1000)["b"])[0, 1]) < 0.1


def test_grids_are_combined_all_with_all():
    found = DESIGNS["grids"].values(0, 42)
    points = sorted({(g, h) for g, h in zip(found["g"], found["h"], strict=True)})
    assert points == [(g, h) for g in (1, 2, 3) for h in (5, 6)]
    assert [(found["g"][k], found["h"][k]) for k in (0, 6, 7, 14)] == [(1, 5), (1, 5), (1, 6), (2, 5)]
    assert len(np.unique(found["a"])) == 42


def test_sobol_points_are_evener():
    """Of 1024 points each of 1024 equal stretches has one, in each coordinate."""
    found = Design({"b": spread({"uniform": [0.0, 1.0]}), "c": spread({"uniform": [0.0, 1.0]})}, 1024, 0, "sobol")
    for values in found.values(0, 1024).values():
        assert np.array_equal(np.sort((values * 1024).astype(int)), np.arange(1024))


def test_indices_of_ishigami():
    """sin x + 7 sin² y + 0.1 z⁴ sin x has known shares (Saltelli et al., *Sensitivity Analysis in Practice*, 2004)."""
    inputs = {name: spread({"uniform": [-math.pi, math.pi]}) for name in "xyz"}
    design = Design(inputs, 2**13, 1, "random", True)
    x, y, z = design.values(0, design.count).values()
    found = sobol_indices(design, np.sin(x) + 7.0 * np.sin(y) ** 2 + 0.1 * z**4 * np.sin(x))
    assert [row.first for row in found] == pytest.approx([0.3139, 0.4424, 0.0], abs=0.02)
    assert [row.total for row in found] == pytest.approx([0.5576, 0.4424, 0.2437], abs=0.02)
    shuffled = np.random.default_rng(1).permutation(x)  # samples out of order tell nothing
    assert sobol_indices(design, shuffled)[0].first < 0.1


def test_base_points_without_values_are_left_out():
    design = Design({name: spread({"uniform": [0.0, 1.0]}) for name in "xy"}, 2048, 1, "random", True)
    x, y = design.values(0, design.count).values()
    values = np.where(x > 0.99, np.nan, 3.0 * x + 4.0 * y)
    first = [row.first for row in sobol_indices(design, values)]
    assert first == pytest.approx([0.36, 0.64], abs=0.05)
    assert sobol_indices(design, np.ones(design.count)) is None
