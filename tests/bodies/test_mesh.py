"""Homogeneous bodies from meshes: exact solids, another integrator, and laws of composition."""

from fractions import Fraction

import numpy as np
import pytest
import trimesh

import polhode as ph
from bodies.meshes import box, inside_out, joined
from polhode.bodies._mesh import volume_moments
from polhode.errors import InvalidInput

EXACT = 1e-14
"""A few roundings on sums of some terms, relative."""
MANY = 1e-13
"""The same for thousands of triangles, and for trimesh's own integration, whose sums are taken from the origin."""
TETRAHEDRON = np.array([[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])


def lumpy():
    """Return a solid of no symmetry that is not convex."""
    mesh = trimesh.creation.icosphere(subdivisions=3)
    x, y, z = np.array(mesh.vertices).T
    radius = 1.0 + 0.3 * x - 0.2 * y * z + 0.25 * x**3
    return np.array(mesh.vertices) * radius[:, None] * [1.0, 1.5, 0.7], np.array(mesh.faces)


def close(found, wanted, allowed):
    assert np.abs(found - wanted).max() <= allowed * np.abs(wanted).max()


@pytest.mark.parametrize("size", [(1.0, 2.0, 3.0), (1e-3, 1e-3, 5e-3), (70.0, 0.01, 300.0)])
def test_a_box_is_exact(size):
    body = ph.Body.from_mesh(*box(size=size), mass=2.0)
    wanted = ph.shapes.box(2.0, size)
    assert np.diag(body.inertia) == pytest.approx(np.diag(wanted.inertia), rel=EXACT, abs=0.0)
    assert body.principal_moments == pytest.approx(wanted.principal_moments, rel=EXACT, abs=0.0)


@pytest.mark.parametrize("far", [1e3, 1e6, 1e9])
def test_a_box_far_away_is_as_exact_as_its_corners(far):
    vertices, faces = box((far, -far, far))
    body = ph.Body.from_mesh(vertices, faces, mass=2.0)
    size = np.ptp(vertices, axis=0)
    close(body.inertia, ph.shapes.box(2.0, size).inertia, EXACT)
    assert body.center_of_mass == pytest.approx(0.5 * (vertices.min(axis=0) + vertices.max(axis=0)), rel=EXACT)


def test_a_regular_tetrahedron_has_moments_of_a_twentieth():
    vertices = np.array([[1.0, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]])  # edges of √8
    body = ph.Body.from_mesh(vertices, TETRAHEDRON[:, ::-1], mass=3.0)
    close(body.inertia, 3.0 * 8.0 / 20.0 * np.eye(3), EXACT)


@pytest.mark.parametrize("seed", range(10))
def test_tetrahedra_against_points_in_rational_arithmetic(seed):
    """A tetrahedron has the second moments of M/20 at each corner and 4M/5 at the centroid."""
    rng = np.random.default_rng(seed)
    vertices = rng.normal(size=(4, 3)) * 10.0 ** rng.uniform(-3, 3)
    faces = TETRAHEDRON if np.linalg.det(vertices[1:] - vertices[0]) > 0 else TETRAHEDRON[:, ::-1]
    corners = [[Fraction(x) for x in vertex] for vertex in vertices.tolist()]
    center = [sum(c[i] for c in corners) / 4 for i in range(3)]
    d = [[c[i] - center[i] for i in range(3)] for c in corners]
    inertia = [
        [float(sum((sum(x * x for x in v) if i == j else 0) - v[i] * v[j] for v in d) / 20) for j in range(3)]
        for i in range(3)
    ]
    body = ph.Body.from_mesh(vertices, faces, mass=1.0)
    close(body.inertia, np.array(inertia), EXACT)
    close(body.center_of_mass, np.array([float(x) for x in center]), EXACT)


def test_another_integrator_agrees():
    vertices, faces = lumpy()
    body = ph.Body.from_mesh(vertices, faces, density=2.0)
    other = trimesh.Trimesh(vertices, faces, process=False)
    other.density = 2.0
    assert body.mass == pytest.approx(other.mass, rel=MANY)
    close(body.center_of_mass, other.center_mass, MANY)
    close(body.inertia, other.moment_inertia, MANY)
    assert np.abs(body.inertia - ph.Body.from_mesh(vertices * 1.001, faces, density=2.0).inertia).max() > 1e-3


@pytest.mark.parametrize("thin", [1e-2, 1e-4, 1e-7])
def test_needles_and_foils_keep_their_digits(thin):
    for size in [(thin, 2 * thin, 1.0), (1.0, 2.0, thin)]:
        inertia = np.diag(ph.Body.from_mesh(*box(size=size), mass=1.0).inertia)
        assert inertia == pytest.approx(np.diag(ph.shapes.box(1.0, size).inertia), rel=EXACT, abs=0.0)


def test_a_difference_from_the_trace_would_lose_a_needle():
    vertices, faces = box(size=(1e-5, 2e-5, 1.0))
    volume, _, second = volume_moments(vertices[faces])
    lost = (np.trace(second) - second[2, 2]) / volume
    assert abs(lost / (5e-10 / 12.0) - 1.0) > 1e3 * EXACT


def test_turning_and_shifting_a_mesh_does_the_same_to_the_body():
    vertices, faces = lumpy()
    turn = ph.rotation.from_rotation_vector([0.1, 0.5, 0.9])
    still = ph.Body.from_mesh(vertices, faces, density=3.0)
    moved = ph.Body.from_mesh(vertices @ ph.rotation.as_matrix(turn).T + [1.0, -2.0, 3.0], faces, density=3.0)
    wanted = still.placed(turn, (1.0, -2.0, 3.0))
    close(moved.inertia, wanted.inertia, MANY)
    close(moved.center_of_mass, wanted.center_of_mass, MANY)
    close(moved.principal_moments, still.principal_moments, MANY)


def test_the_triangulation_does_not_matter():
    vertices, faces = lumpy()
    finer = trimesh.Trimesh(vertices, faces, process=False).subdivide()
    body, same = ph.Body.from_mesh(vertices, faces, mass=1.0), ph.Body.from_mesh(finer.vertices, finer.faces, mass=1.0)
    close(same.inertia, body.inertia, MANY)


def test_parts_that_touch_make_the_whole():
    halves = joined(box((0.0, 0.0, -0.75), (1.0, 2.0, 1.5)), box((0.0, 0.0, 0.75), (1.0, 2.0, 1.5)))
    body = ph.Body.from_mesh(*halves, density=1.0, several=True)
    close(body.inertia, ph.shapes.box(6.0, (1.0, 2.0, 3.0)).inertia, EXACT)


def test_a_cavity_is_taken_out():
    hollow = ph.Body.from_mesh(*joined(box(), inside_out(box(size=(0.5, 0.5, 0.5)))), density=1.0)
    wanted = ph.shapes.box(6.0, (1, 2, 3)).inertia - ph.shapes.box(0.125, (0.5,) * 3).inertia
    assert hollow.mass == pytest.approx(6.0 - 0.125, rel=EXACT)
    close(hollow.inertia, wanted, EXACT)


def test_a_body_may_lie_in_a_cavity():
    nested = joined(box(size=(4.0,) * 3), inside_out(box(size=(2.0,) * 3)), box(size=(1.0,) * 3))
    with pytest.raises(InvalidInput, match="2 separate bodies"):
        ph.Body.from_mesh(*nested, density=1.0)
    assert ph.Body.from_mesh(*nested, density=1.0, several=True).mass == pytest.approx(64.0 - 8.0 + 1.0, rel=EXACT)


def test_several_bodies_only_on_request():
    two = joined(box(), box((5.0, 0.0, 0.0)))
    with pytest.raises(InvalidInput, match=r"2 separate bodies.*several = true in a spec, several=True"):
        ph.Body.from_mesh(*two, mass=1.0)
    together = ph.Body.from_mesh(*two, density=1.0, several=True)
    wanted = ph.combine([ph.shapes.box(6.0, (1, 2, 3)).placed(np.eye(3), (x, 0, 0)) for x in (0.0, 5.0)])
    close(together.inertia, wanted.inertia, EXACT)


def test_without_the_gate_bad_meshes_would_pass_silently():
    vertices, faces = box((0.3, 0.2, 0.1))
    right = volume_moments(vertices[faces])[0]
    opened, overlapping = faces[:-1], joined((vertices, faces), box((0.5, 0.5, 0.5)))
    assert abs(volume_moments(vertices[opened])[0] - right) > 0.1
    assert volume_moments(overlapping[0][overlapping[1]])[0] == pytest.approx(2 * right)  # though they share a part


@pytest.mark.usefixtures("any_type")
def test_mass_or_density():
    for options in ({}, {"mass": 1.0, "density": 1.0}):
        with pytest.raises(InvalidInput, match="exactly one"):
            ph.Body.from_mesh(*box(), **options)
    for options in ({"mass": -1.0}, {"density": np.nan}, {"density": np.ones(2)}):
        with pytest.raises(InvalidInput, match="positive"):
            ph.Body.from_mesh(*box(), **options)
    assert ph.Body.from_mesh(*box(), density=2.0).mass == pytest.approx(12.0, rel=EXACT)
