"""Molecules are drawn in the usual colours, with nothing but polhode installed."""

import sys
from pathlib import Path

import numpy as np
import pytest

from polhode.kinds.reading import read_spec
from polhode.spec.surfaces import surface_of_atoms

WATER = Path(__file__).parents[2] / "examples" / "water.toml"
RED, WHITE, GREY = 0xFF0D0D, 0xFFFFFF, 0x9A9A9A


def test_water_is_red_and_white_without_ase(monkeypatch):
    monkeypatch.setitem(sys.modules, "ase", None)
    surface = read_spec(WATER).surface
    counts = {color: int((surface.colors == color).sum()) for color in (RED, WHITE, GREY)}
    assert counts[WHITE] == 2 * counts[RED] and sum(counts.values()) == len(surface.vertices)


def test_colours_stay_with_their_atoms():
    positions = np.array([[0.0, 0.0, 0.0], [3e-10, 0.0, 0.0]])
    surface = surface_of_atoms(["O", "H"], positions)
    for drawn in (surface, surface.coarsened(200), surface.along(read_spec(WATER).body.frame)):
        middle = np.array([drawn.vertices[drawn.colors == color].mean(axis=0) for color in (RED, WHITE)])
        assert np.linalg.norm(middle[1] - middle[0]) == pytest.approx(3e-10, rel=0.05)
    assert len(surface.coarsened(200).faces) <= 200


def test_radii_are_those_of_ase():
    data = pytest.importorskip("ase.data")
    for symbol in ("H", "C", "O", "S", "Fe", "U"):
        size = np.ptp(surface_of_atoms([symbol], np.zeros((1, 3))).vertices[:, 2])
        assert size == pytest.approx(data.covalent_radii[data.atomic_numbers[symbol]] * 1e-10, rel=1e-12)
    assert set(surface_of_atoms(["Og"], np.zeros((1, 3))).colors) == {0xFF1493}
