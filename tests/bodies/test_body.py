"""Mass properties against quadrature, laws of composition, and deterministic axes."""

import numpy as np
import pytest
from scipy.integrate import tplquad

import polhode as ph
from polhode.errors import InvalidInput

EXACT = 1e-14
"""A few roundings on sums of some terms, relative."""
QUADRATURE = 1e-7


def inertia_by_quadrature(inside, reach):
    """Return mass-normalised diagonal second moments of a region by Monte-Carlo-free cubature on a fine grid."""
    n = 120
    edges = [np.linspace(-r, r, n + 1) for r in reach]
    middles = [0.5 * (e[1:] + e[:-1]) for e in edges]
    x, y, z = np.meshgrid(*middles, indexing="ij")
    mask = inside(x, y, z)
    return np.array([(v[mask] ** 2).mean() for v in (x, y, z)]), np.array([v[mask].mean() for v in (x, y, z)])


GRID = 6e-3
"""Relative error of second moments on a grid of 120 cells a side: about the share of surface cells squared."""


@pytest.mark.parametrize(
    ("body", "inside", "reach"),
    [
        (ph.shapes.cylinder(2.0, 0.7, 1.9), lambda x, y, z: (x**2 + y**2 < 0.49) & (abs(z) < 0.95), (0.7, 0.7, 0.95)),
        (
            ph.shapes.cylinder(2.0, 0.7, 1.9, inner_radius=0.4),
            lambda x, y, z: (x**2 + y**2 < 0.49) & (x**2 + y**2 > 0.16) & (abs(z) < 0.95),
            (0.7, 0.7, 0.95),
        ),
        (
            ph.shapes.ellipsoid(2.0, (1.0, 2.0, 3.0)),
            lambda x, y, z: x**2 + (y / 2) ** 2 + (z / 3) ** 2 < 1,
            (1, 2, 3),
        ),
        (
            ph.shapes.sphere(2.0, 1.0, inner_radius=0.5),
            lambda x, y, z: (x**2 + y**2 + z**2 < 1) & (x**2 + y**2 + z**2 > 0.25),
            (1, 1, 1),
        ),
        (
            ph.shapes.cone(2.0, 1.0, 2.0),
            lambda x, y, z: (z > -0.5) & (np.hypot(x, y) < (1.5 - z) / 2.0),
            (1.0, 1.0, 1.5),
        ),
        (
            ph.shapes.torus(2.0, 1.0, 0.3),
            lambda x, y, z: (np.hypot(x, y) - 1.0) ** 2 + z**2 < 0.09,
            (1.3, 1.3, 0.3),
        ),
    ],
)
def test_shapes_against_summation(body, inside, reach):
    squares, center = inertia_by_quadrature(inside, reach)
    assert np.abs(center).max() < GRID
    wanted = body.mass * np.array([squares[1] + squares[2], squares[0] + squares[2], squares[0] + squares[1]])
    assert np.diag(body.inertia) == pytest.approx(wanted, rel=GRID)


def test_box_against_adaptive_quadrature():
    body = ph.shapes.box(3.0, (1.0, 2.0, 0.5))
    volume = 1.0
    value, _ = tplquad(lambda z, y, x: y * y + z * z, -0.5, 0.5, -1.0, 1.0, -0.25, 0.25)
    assert body.inertia[0, 0] == pytest.approx(3.0 / volume * value, rel=QUADRATURE)


def test_flat_and_thin_limits():
    disk, rod = ph.shapes.disk(2.0, 3.0), ph.shapes.rod(2.0, 3.0)
    assert disk.principal_moments == pytest.approx([4.5, 4.5, 9.0], rel=EXACT)
    assert disk.principal_moments == pytest.approx(ph.shapes.cylinder(2.0, 3.0, 1e-9).principal_moments, rel=EXACT)
    assert rod.principal_moments == pytest.approx([0.0, 1.5, 1.5], rel=EXACT)
    shell = ph.shapes.sphere(1.0, 1.0, inner_radius=1.0 - 1e-12)
    assert shell.principal_moments == pytest.approx([2 / 3] * 3, rel=1e-11)


def test_a_box_from_its_pieces_is_the_box():
    whole = ph.shapes.box(6.0, (1.0, 2.0, 3.0))
    pieces = [ph.shapes.box(2.0, (1.0, 2.0, 1.0)).placed((1, 0, 0, 0), (5.0, 0.0, z)) for z in (-1.0, 0.0, 1.0)]
    together = ph.combine(pieces)
    assert together.inertia == pytest.approx(whole.inertia, abs=EXACT * 10)
    assert together.center_of_mass == pytest.approx([5.0, 0.0, 0.0], abs=EXACT)
    forgotten = sum(piece.inertia for piece in pieces)
    assert np.abs(forgotten - whole.inertia).max() > 1.0


def test_parallel_axis():
    ball = ph.shapes.sphere(2.0, 1.0)
    assert ball.about((0.0, 0.0, 3.0))[0, 0] == pytest.approx(0.8 + 18.0, rel=EXACT)
    assert ball.about((0.0, 0.0, 3.0))[2, 2] == pytest.approx(0.8, rel=EXACT)


def test_points_are_a_body():
    masses, positions = [1.0, 2.0, 3.0], np.array([[0.0, 0, 0], [1, 0, 0], [0, 2, 1]])
    body = ph.from_points(masses, positions + 1e3)
    center = np.average(positions, axis=0, weights=masses)
    inertia = sum(m * (r @ r * np.eye(3) - np.outer(r, r)) for m, r in zip(masses, positions - center, strict=True))
    assert body.inertia == pytest.approx(inertia, rel=1e-12, abs=1e-12)


def test_turning_a_body_turns_its_axes():
    body = ph.shapes.box(1.0, (1.0, 2.0, 3.0))
    q = ph.rotation.from_rotation_vector([0.3, -0.4, 0.5])
    turned = body.placed(q, (1.0, 2.0, 3.0))
    assert turned.principal_moments == pytest.approx(body.principal_moments, rel=EXACT)
    rebuilt = turned.principal_axes @ np.diag(turned.principal_moments) @ turned.principal_axes.T
    assert rebuilt == pytest.approx(turned.inertia, abs=EXACT)


@pytest.mark.parametrize(
    "inertia",
    [
        np.diag([3.0, 1.0, 2.0]),
        np.diag([2.0, 2.0, 1.0]),
        np.diag([1.0, 1.0, 1.0]),
        np.array([[2.0, 1e-17, 0], [1e-17, 2.0, 0], [0, 0, 3.0]]),
        np.array([[2.0, 0.3, 0.1], [0.3, 2.5, -0.2], [0.1, -0.2, 3.0]]),
    ],
)
def test_axes_are_right_handed_and_deterministic(inertia):
    axes = ph.Body(1.0, (0, 0, 0), inertia).principal_axes
    assert np.linalg.det(axes) == pytest.approx(1.0)
    assert axes.T @ axes == pytest.approx(np.eye(3), abs=EXACT)
    noise = 1e-16 * np.array([[0.0, 1, -1], [1, 0, 1], [-1, 1, 0]])
    again = ph.Body(1.0, (0, 0, 0), inertia + noise).principal_axes
    assert again == pytest.approx(axes, abs=1e-12)


def test_given_order_of_moments_is_kept_as_axes():
    body = ph.Body.from_moments(3.0, 1.0, 2.5)
    assert body.principal_moments.tolist() == [1.0, 2.5, 3.0]
    assert np.abs(body.principal_axes).tolist() == [[0, 0, 1], [1, 0, 0], [0, 1, 0]]


@pytest.mark.parametrize(
    ("make", "words"),
    [
        (lambda: ph.Body.from_moments(1.0, 1.0, 3.0), "I1 \\+ I2 ≥ I3"),
        (lambda: ph.Body.from_moments(-1.0, 2.0, 2.0), "negative"),
        (lambda: ph.Body.from_moments(np.nan, 2.0, 2.0), "finite"),
        (lambda: ph.Body.from_moments(0.0, 0.0, 0.0), "vanish"),
        (lambda: ph.Body(-1.0, (0, 0, 0), np.eye(3)), "mass"),
        (lambda: ph.Body(1.0, (0, 0, 0), [[1, 1, 0], [0, 1, 0], [0, 0, 1]]), "symmetric"),
        (lambda: ph.Body.from_moments(1, 1, 1).about((0, 0, 1)), "mass"),
        (lambda: ph.combine([]), "at least one"),
        (lambda: ph.shapes.sphere(1.0, -1.0), "positive"),
        (lambda: ph.shapes.torus(1.0, 1.0, 2.0), "minor_radius"),
        (lambda: ph.shapes.cylinder(1.0, 1.0, 1.0, inner_radius=2.0), "inner_radius"),
        (lambda: ph.from_points([1.0], [[0.0, 0, 0]]), "vanish"),
        (lambda: ph.from_points([1.0, -1.0], [[0.0, 0, 0], [1, 0, 0]]), "positive"),
        (lambda: ph.from_atoms(["Xx"], [[0.0, 0, 0]]), "chemical"),
    ],
)
def test_bad_input(make, words):
    with pytest.raises(InvalidInput, match=words):
        make()


def test_flat_bodies_are_physical_to_rounding():
    assert ph.Body.from_moments(0.1, 0.2, 0.1 + 0.2).principal_moments[2] > 0.3
