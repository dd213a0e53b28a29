"""Surfaces to draw, integrated by the mesh gate's own way, against the exact shapes they stand for."""

import numpy as np
import pytest

import polhode as ph
from polhode.bodies._turned import ball, bar, cone, revolve, torus, tube
from polhode.bodies.surface import Surface, cuboid, join_surfaces

DRAWN = 0.01
"""An inscribed polygon of 64 corners has second moments 0.32 % below its circle's; balls, flat both ways, 0.7 %."""
EXACT = 1e-13
"""A few roundings, relative."""
MASS = 3.0

ROUND = {
    "cylinder": (lambda n: tube(0.7, 1.9, sections=n), ph.shapes.cylinder(MASS, 0.7, 1.9)),
    "pipe": (lambda n: tube(0.7, 1.9, 0.4, n), ph.shapes.cylinder(MASS, 0.7, 1.9, inner_radius=0.4)),
    "cone": (lambda n: cone(0.7, 1.9, n), ph.shapes.cone(MASS, 0.7, 1.9)),
    "ball": (lambda n: ball(n), ph.shapes.sphere(MASS, 1.0)),
    "torus": (lambda n: torus(2.0, 0.5, n), ph.shapes.torus(MASS, 2.0, 0.5)),
}


def body_inside(surface):
    """The gate refuses what is open, inverted or overlapping."""
    return ph.Body.from_mesh(surface.vertices, surface.faces, mass=MASS)


def error(surface, wanted):
    inertia = body_inside(surface).inertia
    return np.abs(inertia - wanted.inertia).max() / np.abs(wanted.inertia).max()


@pytest.mark.parametrize("shape", ROUND)
def test_it_is_the_shape(shape):
    make, wanted = ROUND[shape]
    assert error(make(64), wanted) <= DRAWN
    # polygons near the circle by the square of their sections' size
    assert error(make(32), wanted) / error(make(64), wanted) == pytest.approx(4.0, rel=0.1)
    center = body_inside(make(64)).center_of_mass
    assert np.abs(center).max() <= EXACT


def test_a_horn_torus_and_a_needle_and_a_speck_are_closed():
    body_inside(tube(1e-9, 1.0))
    for scale in (1e-12, 1e9):
        surface = tube(0.7 * scale, 1.9 * scale, 0.4 * scale)
        wanted = ph.shapes.cylinder(MASS, 0.7 * scale, 1.9 * scale, inner_radius=0.4 * scale)
        assert error(surface, wanted) <= DRAWN
    vertices, faces = torus(1.0, 1.0)
    assert (np.linalg.norm(vertices[:, :2], axis=1) >= 0).all()
    assert len(faces) < 2 * 64 * 32  # those on the axis are gone


def test_a_block_is_exact():
    assert error(cuboid((1.0, 2.0, 3.0)), ph.shapes.box(MASS, (1.0, 2.0, 3.0))) <= EXACT


@pytest.mark.parametrize("end", [(0.0, 0.0, 2.0), (1.0, -2.0, 0.5), (0.0, -3.0, 0.0)])
def test_a_bar_goes_from_point_to_point(end):
    start = np.array([0.3, -0.2, 0.1])
    found = body_inside(bar(start, end, 0.05, sections=64))
    along = np.array(end) - start
    assert found.center_of_mass == pytest.approx(0.5 * (start + end), abs=EXACT * 10)
    wanted = ph.shapes.cylinder(MASS, 0.05, float(np.linalg.norm(along)))
    assert found.principal_moments == pytest.approx(np.diag(wanted.inertia)[[2, 0, 1]], rel=DRAWN)
    axis = found.principal_axes[:, 0]
    assert abs(axis @ along) == pytest.approx(np.linalg.norm(along), rel=1e-9)


def test_a_profile_the_wrong_way_round_is_noticed():
    inside_out = revolve([(0.0, 1.0), (1.0, 1.0), (1.0, -1.0), (0.0, -1.0)])
    with pytest.raises(ph.InvalidInput, match="inverted"):
        body_inside(inside_out)


def test_joined_surfaces_keep_their_triangles():
    one, two = cuboid((1.0, 1.0, 1.0)), ball(8)
    two = Surface(two.vertices + np.array([5.0, 0.0, 0.0]), two.faces)
    both = join_surfaces([one, two])
    corners = np.concatenate([one.vertices[one.faces], two.vertices[two.faces]])
    assert np.array_equal(both.vertices[both.faces], corners)
