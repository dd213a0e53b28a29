"""Curves on the momentum sphere lie on levels of the energy."""

import numpy as np
import pytest

import polhode as ph
from polhode.analysis.polhodes import level_segments, polhode, polhode_family, saddle_energies, separatrix

ON_LEVEL = 1e-5
"""Of the energy's range: twelve bisections of an edge of 0.06 rad."""
MOMENTS = np.array([1.0, 2.0, 3.0])


def kinetic(unit, moments=MOMENTS):
    return 0.5 * np.sum(unit**2 / moments, axis=-1)


def test_family_and_separatrix():
    for curve in polhode_family(MOMENTS):
        assert np.ptp(kinetic(curve)) < 1e-14 and np.abs(np.linalg.norm(curve, axis=1) - 1.0).max() < 1e-14
    for circle in separatrix(MOMENTS):
        assert np.abs(kinetic(circle) - 0.25).max() < 1e-15
    assert len(polhode_family(MOMENTS)) == 16 and not separatrix(np.array([1.0, 1.0, 2.0]))
    assert not polhode_family(np.array([2.0, 2.0, 2.0]))


def test_own_polhode_has_even_steps_where_time_has_not_and_no_corners():
    motion = ph.FreeMotion(MOMENTS, momentum=(1e-4, 1.0, 1e-4))
    curve = polhode(motion, 500)
    steps = np.linalg.norm(np.diff(curve, axis=0), axis=1)
    assert np.ptp(kinetic(curve)) < 1e-14 and steps.max() < 2.5 * steps.mean()
    turns = np.diff(curve, axis=0) / steps[:, None]
    assert np.linalg.norm(np.diff(turns, axis=0), axis=1).max() < 0.1
    uneven = np.linalg.norm(np.diff(motion.momentum(np.linspace(0.0, motion.period, 501)), axis=0), axis=1)
    assert uneven.max() > 3.0 * uneven.mean()
    assert polhode(ph.FreeMotion(MOMENTS, momentum=(0.0, 0.0, 1.0)), 10) is None


@pytest.mark.parametrize("rotor", [(0.0, 0.0, 0.0), (0.1, 0.2, 0.4), (0.0, 0.0, 0.6)])
def test_levels_of_a_gyrostat(rotor):
    def energy(unit):
        return kinetic(unit - np.array(rotor))

    pieces = level_segments(energy, [0.3])
    assert len(pieces) and np.abs(energy(pieces) - 0.3).max() < ON_LEVEL
    assert np.linalg.norm(pieces[:, 1] - pieces[:, 0], axis=-1).max() < 0.1
    # every end is met by another piece: levels are closed
    ends = pieces.reshape(-1, 3)
    gaps = np.linalg.norm(ends[:, None] - ends[None], axis=-1) + 9.0 * np.eye(len(ends))
    assert gaps.min(axis=1).max() < ON_LEVEL


@pytest.mark.long
def test_saddles_separate():
    assert saddle_energies(MOMENTS, np.zeros(3), 2.0) == pytest.approx([1.0], rel=1e-12)
    rotor = np.array([0.1, 0.2, 0.4])
    grid = np.moveaxis(np.mgrid[0 : np.pi : 1500j, 0 : 2 * np.pi : 3000j], 0, -1)
    unit = np.stack([np.sin(grid[..., 0]) * np.cos(grid[..., 1]), np.sin(grid[..., 0]) * np.sin(grid[..., 1]),
                     np.cos(grid[..., 0])], axis=-1)  # fmt: skip
    height = kinetic(unit - rotor)[1:-1, :-1]
    ring = np.stack([np.roll(height[1 + i : height.shape[0] - 1 + i], -j, axis=1) - height[1:-1] for i, j in (
        (-1, -1), (-1, 0), (-1, 1), (0, 1), (1, 1), (1, 0), (1, -1), (0, -1))])  # fmt: skip
    changes = np.sum((ring > 0) != np.roll(ring > 0, 1, axis=0), axis=0)
    saddles = height[1:-1][changes >= 4]
    found = saddle_energies(MOMENTS, rotor, 1.0)
    assert found and all(np.abs(saddles - value).min() < 1e-5 for value in found)
    assert all(np.abs(np.array(found) - value).min() < 1e-5 for value in saddles)
    # a fast rotor leaves no saddle: one minimum and one maximum
    assert saddle_energies(MOMENTS, np.array([0.0, 0.0, 5.0]), 1.0) == []


def test_sphere_has_no_levels():
    assert level_segments(lambda unit: np.sum(unit**2, axis=-1)).shape == (0, 2, 3)
