"""Where surfaces stand, the box of the same inertia, and coarser copies of fine meshes."""

import numpy as np
import pytest

import polhode as ph
from polhode.bodies._turned import ball, torus
from polhode.bodies.surface import Surface, box_in_place, box_of_same_inertia, cuboid, join_surfaces
from polhode.motion.frame import BodyFrame

EXACT = 1e-13
"""A few roundings, relative."""
PLACED = ph.shapes.box(2.0, (1.0, 2.0, 3.0)).placed((0.8, 0.2, -0.4, 0.4), (5.0, -7.0, 11.0))


def test_a_frame_turns_about_its_centre_of_mass_or_its_pivot():
    frame = PLACED.frame
    assert frame.mass == 2.0 and np.array_equal(frame.origin, PLACED.center_of_mass)
    assert np.array_equal(frame._replace(pivot=np.array([1.0, 2.0, 3.0])).origin, [1.0, 2.0, 3.0])


def test_along_a_frame_a_body_has_diagonal_inertia_about_the_origin():
    axes = PLACED.principal_axes
    standing = Surface(cuboid((1.0, 2.0, 3.0)).vertices @ axes[:, ::-1].T + PLACED.center_of_mass,
                       cuboid((1.0, 2.0, 3.0)).faces)  # fmt: skip
    along = standing.along(PLACED.frame)
    # the longest edge is along the axis of least inertia
    assert np.abs(along.vertices) == pytest.approx(np.tile([1.5, 1.0, 0.5], (8, 1)), abs=EXACT * 100)


def test_about_a_pivot_the_fixed_point_is_the_origin():
    pivot = np.array([5.0, -7.0, 9.0])
    frame = PLACED.frame._replace(pivot=pivot)
    surface = Surface(np.array([pivot, pivot + frame.axes[:, 1]]), np.zeros((0, 3), dtype=int))
    assert surface.along(frame).vertices == pytest.approx(np.array([[0, 0, 0], [0, 1, 0]]), abs=EXACT)


@pytest.mark.parametrize("size", [(1.0, 2.0, 3.0), (0.1, 0.1, 4.0), (2.0, 2.0, 2.0)])
def test_the_box_has_the_inertia(size):
    body = ph.shapes.box(2.0, size)
    found = box_of_same_inertia(np.diag(body.inertia), body.mass)
    assert np.ptp(found.vertices, axis=0) == pytest.approx(size, rel=EXACT * 10)
    assert ph.Body.from_mesh(*found, mass=2.0).inertia == pytest.approx(body.inertia, rel=EXACT * 10, abs=EXACT)


def test_the_box_of_other_moments():
    assert np.ptp(box_of_same_inertia([1.0, 2.0, 2.5]).vertices, axis=0).max() == pytest.approx(1.0, rel=EXACT)
    assert np.ptp(box_of_same_inertia([1.0, 2.0, 3.0]).vertices, axis=0)[2] == 0.0  # flat
    assert box_of_same_inertia([1.0, 2.0, 3.5]) is None and box_of_same_inertia([0.0, 0.0, 0.0]) is None


@pytest.mark.parametrize("pivot", [None, (5.0, -7.0, 9.0), (0.0, 0.0, 0.0)])
def test_the_box_in_place_has_the_body_s_inertia_and_place(pivot):
    frame = PLACED.frame
    if pivot is not None:
        moments, axes = np.linalg.eigh(PLACED.about(pivot))
        frame = BodyFrame(moments, axes, PLACED.center_of_mass, PLACED.mass, np.array(pivot))
    found = ph.Body.from_mesh(*box_in_place(frame), mass=2.0)
    assert found.center_of_mass == pytest.approx(PLACED.center_of_mass, rel=EXACT * 10)
    # moments about a point 14 m away are 100 times those about the centre
    assert found.inertia == pytest.approx(PLACED.inertia, rel=EXACT * 1000, abs=EXACT * 1000)


def test_no_box_where_nothing_says_its_size_or_no_body_is():
    frame = PLACED.frame
    assert box_in_place(frame._replace(mass=None, pivot=np.zeros(3))) is None
    assert box_in_place(frame._replace(moments=np.array([1.0, 1.0, 3.0]))) is None
    assert box_in_place(frame._replace(mass=None)) is not None


@pytest.mark.parametrize("most", [12, 100, 1000, 3000])
def test_a_coarser_surface_has_few_triangles_and_the_shape(most):
    fine = join_surfaces([ball(128), Surface(torus(4.0, 0.5).vertices, torus(4.0, 0.5).faces)])
    coarse = fine.coarsened(most)
    assert most // 10 <= len(coarse.faces) <= most  # a coarse grid on a symmetric surface leaves out many numbers
    assert set(coarse.faces.ravel()) == set(range(len(coarse.vertices)))
    # every corner is a mean of near ones, so no further out; cells are about the size of a triangle
    assert (np.abs(coarse.vertices) <= np.abs(fine.vertices).max(axis=0) * (1 + EXACT)).all()
    cell = 9.0 * np.sqrt(20.0 / most)
    assert np.abs(np.ptp(coarse.vertices, axis=0) - np.ptp(fine.vertices, axis=0)).max() <= cell


def test_a_coarser_ball_is_still_turned_outward():
    coarse = ball(256).coarsened(1000)
    corners = coarse.vertices[coarse.faces]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    assert (np.einsum("ij,ij->i", normals, corners.mean(axis=1)) > 0).mean() > 0.99
    volume = np.einsum("ij,ij->i", corners[:, 0], np.cross(corners[:, 1], corners[:, 2])).sum() / 6.0
    assert volume == pytest.approx(4.0 * np.pi / 3.0, rel=0.05)


def test_a_surface_with_few_triangles_stays_as_it_is():
    small = cuboid((1.0, 2.0, 3.0))
    assert small.coarsened(12) is small
    with pytest.raises(ph.InvalidInput, match="`most` must be a whole number of triangles, at least 12"):
        small.coarsened(11)


def test_many_triangles_in_one_place_are_thinned_too():
    """Copies of one triangle, and a speck beside a large triangle, fill no finer grid."""
    corners = np.eye(3)
    copies = Surface(np.tile(corners, (100, 1)), np.arange(300).reshape(-1, 3))
    assert len(copies.coarsened(12).faces) == 1
    flat = Surface(ball(64).vertices * [1.0, 1.0, 0.0], ball(64).faces)
    assert len(flat.coarsened(500).faces) <= 500
    point = Surface(np.zeros((3, 3)), np.tile([0, 1, 2], (20, 1)))
    assert len(point.coarsened(12).faces) == 0
