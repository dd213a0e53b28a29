"""What is drawn as the body has the body's inertia, and few enough triangles."""

import numpy as np
import pytest

import polhode as ph
from polhode.bodies.surface import Surface
from polhode.viewer.shapes import LIMITS, body_shape, top_shape

THIN_STEM = 0.05
"""Relative: the drawn disk is thick enough to be seen, and its stem is drawn though it has no mass."""


def sphere(rings, columns):
    """Return a sphere whose triangles each have corners of their own, as STL files have."""
    down, around = np.meshgrid(np.linspace(0.0, np.pi, rings + 1), np.linspace(0.0, 2.0 * np.pi, columns + 1))
    grid = np.stack([np.sin(down) * np.cos(around), np.sin(down) * np.sin(around), np.cos(down)], axis=-1)
    a, b, c, d = grid[:-1, :-1], grid[:-1, 1:], grid[1:, 1:], grid[1:, :-1]
    corners = np.concatenate([np.stack([a, b, c], axis=-2), np.stack([a, c, d], axis=-2)]).reshape(-1, 3)
    return Surface(corners, np.arange(len(corners)).reshape(-1, 3))


def test_box_has_the_moments():
    found, words = body_shape(np.array([1.0, 2.0, 2.5]), None)
    edges = np.ptp(found.vertices, axis=0)
    moments = ph.shapes.box(1.0, tuple(edges)).principal_moments
    assert moments / moments[0] == pytest.approx([1.0, 2.0, 2.5]) and "box" in words


@pytest.mark.parametrize("axis", [0, 1, 2])
def test_disk_on_a_stem_has_the_moments_about_the_pivot(axis):
    moments = np.roll([1.1, 1.0, 0.5], axis - 2)
    along = np.eye(3)[axis]
    found, words = top_shape(moments, along, None)
    assert "stem" in words
    disk = found.vertices[: len(found.vertices) // 2]
    height = disk[:, axis].mean()
    a, b = (np.abs(disk[:, (axis + k) % 3]).max() for k in (1, 2))
    square = np.zeros(3)
    square[[(axis + 1) % 3, (axis + 2) % 3, axis]] = 0.25 * a * a, 0.25 * b * b, height**2
    drawn = square.sum() - square
    assert drawn / drawn[axis] == pytest.approx(moments / moments[axis], rel=THIN_STEM)


@pytest.mark.parametrize("moments", [(0.1, 0.1, 0.5), (1.0, 2.0, 9.0)])
def test_tops_that_no_body_is_are_drawn_as_ellipsoids(moments):
    found, words = top_shape(np.array(moments), np.array([0.0, 0.0, 1.0]), None)
    assert found is None and "ellipsoid" in words


def test_large_meshes_are_coarsened_and_small_ones_kept():
    small, words = body_shape(None, sphere(20, 30))
    assert words == ""
    assert len(small.vertices) == 30 * 19 + 2  # corners merged, and no triangle but the empty ones at the poles lost
    assert len(small.faces) == 2 * 30 * 19
    coarse, words = body_shape(None, sphere(200, 300))
    assert len(coarse.faces) <= LIMITS.max_faces and words == "its mesh, coarsened"
    assert np.linalg.norm(coarse.vertices, axis=1) == pytest.approx(1.0, abs=0.02)
