"""Limits of bodies: on either side of each, a mesh, a solid or a tensor is taken or refused."""

import warnings
from contextlib import nullcontext

import numpy as np
import pytest

from polhode.bodies import _digits, _inertia, _mesh, _mesh_edges, _mesh_gate, _mesh_repair, _pivot, _solids
from polhode.bodies.body import Body
from polhode.bodies.surface import cuboid
from polhode.errors import InvalidInput

INSIDE, OUTSIDE = 0.99, 1.01  # of a limit


def refuses(refused, match=None):
    """Expect an error if one is due."""
    return pytest.raises(InvalidInput, match=match) if refused else nullcontext()


@pytest.mark.parametrize("factor", (INSIDE, OUTSIDE))
def test_effective_moments_fall_short_by_a_third(factor):
    short = factor * _inertia.LIMITS.max_inertial_defect * 3.0
    with refuses(factor > 1.0, "I1 \\+ I2 ≥ 2/3 I3"):
        Body.from_moments((1.0, 2.0 - short, 3.0), effective=True)


@pytest.mark.parametrize("factor", (INSIDE, OUTSIDE))
def test_a_tensor_that_is_not_symmetric_was_mistyped(factor):
    inertia = np.diag([2.0, 2.5, 3.0])
    inertia[0, 1] = factor * _inertia.LIMITS.max_asymmetry * 3.0
    with refuses(factor > 1.0, "symmetric"):
        Body.from_inertia(inertia)


@pytest.mark.parametrize("factor", (INSIDE, OUTSIDE))
def test_moments_are_within_products_of_doubles(factor):
    size = factor * _inertia.LIMITS.largest
    with refuses(factor > 1.0, "1e±150"):
        Body.from_moments((size, size, size))


@pytest.mark.parametrize("gap, first", [(0.5, 0), (2.0, 1)])
def test_equal_cosines_choose_the_first_axis(gap, first):
    assert _inertia._first_largest(np.array([1.0, 1.0 + gap * _inertia.LIMITS.max_tie, 0.0])) == first


@pytest.mark.parametrize("off, digit", [(0.5, 1e-4), (2.0, 1e-5)])
def test_decimals_are_whole_multiples_of_a_digit(off, digit):
    positions = np.array([[0.0, 1.2345 + off * _digits.LIMITS.max_rounding * 1e-4, -0.5]])
    last = _digits.last_digit(positions, 1.0)
    assert (last == pytest.approx(1e-4)) == (digit == 1e-4)


@pytest.mark.parametrize("factor", (INSIDE, OUTSIDE))
def test_a_sheet_is_thin(factor):
    vertices, faces = np.array([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]), np.array([[0, 1, 2]])
    with refuses(factor > 1.0, "of the mesh's size"):
        Body.from_sheet(vertices, faces, density=1.0, thickness=factor * _mesh.LIMITS.max_thickness)


@pytest.mark.parametrize("factor", (INSIDE, OUTSIDE))
def test_coordinates_have_fifth_powers(factor):
    vertices, faces = cuboid((1.0, 1.0, 1.0))
    for size, refused in ((_mesh_gate.LIMITS.min_extent / factor, factor > 1.0),
                          (factor / _mesh_gate.LIMITS.min_extent, factor > 1.0)):  # fmt: skip
        with refuses(refused, "1e±30"):
            _mesh_gate.as_mesh(2.0 * size * np.asarray(vertices), faces)


@pytest.mark.parametrize("height, flat", [(0.5, True), (2.0, False)])
def test_a_volume_below_rounding_is_none(height, flat):
    tip = np.array([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.3, 0.3, 0.0]])
    faces = np.array([[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]])

    def corners(rise):
        return (tip + rise * np.outer([0.0, 0.0, 0.0, 1.0], [0.0, 0.0, 1.0]))[faces]

    whole = corners(1e-6)
    middle = whole - 0.5 * (whole.min(axis=(0, 1)) + whole.max(axis=(0, 1)))
    a, b, c = np.moveaxis(middle, 1, 0)
    sizes = (np.linalg.norm(a, axis=1) * np.linalg.norm(np.cross(b - a, c - a), axis=1)).sum()
    rise = height * _mesh_gate.LIMITS.min_relative_volume * sizes * 6.0  # of the volume, a sixth of the height
    assert (_mesh_gate.find_volume(corners(rise)) == 0.0) == flat


@pytest.mark.parametrize("gap, pairs", [(0.5, [(0, 1), (2, 3)]), (2.0, [(1, 0), (3, 2)])])
def test_coplanar_faces_of_an_edge_are_at_one_angle(gap, pairs):
    near = gap * _mesh_edges.LIMITS.max_angle
    angle, opens = np.array([0.0, near, 3.0, 3.0 + near]), np.array([True, False, True, False])
    matched = _mesh_edges._match_brackets(angle, opens)
    assert len(matched) == 2 and (sorted(matched) == [(0, 1), (2, 3)]) == (gap > 1.0)


@pytest.mark.parametrize("missing, closed", [(0.049, True), (0.2, False)])
def test_small_holes_are_closed(missing, closed):
    assert _mesh_repair.LIMITS.max_width == 0.05
    ring = np.array([[np.cos(a), np.sin(a)] for a in 2.0 * np.pi * np.arange(6) / 6.0])
    bottom, top = np.column_stack([ring, np.zeros(6)]), np.column_stack([0.5 * missing * ring, np.ones(6)])
    vertices = np.vstack([bottom, top, [[0.0, 0.0, 0.0]]])
    sides = [[k, (k + 1) % 6, 6 + k] for k in range(6)] + [[(k + 1) % 6, 6 + (k + 1) % 6, 6 + k] for k in range(6)]
    faces = np.array(sides + [[12, (k + 1) % 6, k] for k in range(6)])
    wide = np.ptp(top, axis=0).max() / np.ptp(vertices, axis=0).max()
    assert (wide <= _mesh_repair.LIMITS.max_width) == closed
    repaired = _mesh_repair.repair_mesh(vertices, faces, holes=True)
    assert any("closed 1 hole" in change for change in repaired.changes) == closed


@pytest.mark.parametrize("factor, free", [(0.5, True), (2.0, False)])
def test_a_body_whose_centre_is_at_the_pivot_but_for_rounding_is_free(factor, free):
    body = Body.from_points([1.0, 1.0, 1.0], [[1.0, 0.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 0.0, 0.0]])
    body = Body(3.0, np.zeros(3), np.diag([3.0, 3.0, 3.0]) + 0.0 * body.inertia)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        pivoted = _pivot.about_pivot(body, [0.0, 0.0, factor * _pivot.LIMITS.min_distance])
    assert (pivoted.mgl == 0.0) == free


@pytest.mark.parametrize("factor", (INSIDE, OUTSIDE))
def test_solids_are_of_a_size_that_bodies_have(factor):
    for size in (factor * _solids.LIMITS.largest, _solids.LIMITS.smallest / factor):
        with refuses(factor > 1.0, "1e±60"):
            _solids.positive(radius=size)
        with refuses(factor > 1.0, "1e±60"):
            _solids.lengths("size", [size] * 3)


@pytest.mark.parametrize("more", (0, 1))
def test_an_outline_has_two_thousand_corners_at_most(more):
    angle = 2.0 * np.pi * np.arange(_solids.LIMITS.max_corners + more) / (_solids.LIMITS.max_corners + more)
    with refuses(more, "3 to 2000 corners"):
        _solids._corners(np.column_stack([np.cos(angle), np.sin(angle)]))
