"""Shapes against Gauss–Legendre quadrature over each body's own coordinates."""

import itertools

import numpy as np
import pytest

import polhode as ph
from polhode.errors import InvalidInput

EXACT = 1e-14
"""A few roundings on sums of some terms, relative."""
QUADRATURE = 1e-12
"""24 nodes a side integrate these polynomials and sines to rounding; the rest is the summation of 13,824 terms."""
NODES, WEIGHTS = np.polynomial.legendre.leggauss(24)


def integrated(place):
    """Return volume, centroid and inertia about the centroid per mass of the image of the unit cube under ``place``.

    The volume element is the Jacobian determinant, by complex steps, which take no differences.
    """
    nodes, weights = 0.5 * (NODES + 1.0), 0.5 * WEIGHTS
    cube = np.array([g.ravel() for g in np.meshgrid(nodes, nodes, nodes, indexing="ij")])
    weight = np.einsum("i,j,k->ijk", weights, weights, weights).ravel()
    step = 1e-30
    columns = [np.imag(place(*(cube + 1j * step * np.eye(3)[:, [k]]))) / step for k in range(3)]
    weight = weight * np.abs(np.linalg.det(np.moveaxis(np.array(columns), -1, 0)))
    volume, points = weight.sum(), np.array(np.real(place(*cube)))
    center = points @ weight / volume
    offsets = points - center[:, None]
    second = (offsets * weight) @ offsets.T / volume
    return volume, center, np.trace(second) * np.eye(3) - second


def around(radius, angle, height):
    return np.array([radius * np.cos(2 * np.pi * angle), radius * np.sin(2 * np.pi * angle), height])


def ball(radius, angle, up, a=1.0, b=1.0, c=1.0, inner=0.0):
    r = inner + (radius - inner * radius)
    z = 2.0 * up - 1.0
    across = r * np.sqrt(1.0 - z * z)
    return np.array([a * across * np.cos(2 * np.pi * angle), b * across * np.sin(2 * np.pi * angle), c * r * z])


def tube(radius, angle, around_tube, major=1.0, minor=0.3):
    r = minor * radius
    return around(major + r * np.cos(2 * np.pi * around_tube), angle, r * np.sin(2 * np.pi * around_tube))


CASES = {
    "box": (ph.shapes.box(2.0, (1.0, 2.0, 0.5)), lambda u, v, w: np.array([u, 2.0 * v, 0.5 * w])),
    "cylinder": (ph.shapes.cylinder(2.0, 0.7, 1.9), lambda u, v, w: around(0.7 * u, v, 1.9 * w)),
    "pipe": (
        ph.shapes.cylinder(2.0, 0.7, 1.9, inner_radius=0.4),
        lambda u, v, w: around(0.4 + 0.3 * u, v, 1.9 * w),
    ),
    "ellipsoid": (ph.shapes.ellipsoid(2.0, (1.0, 2.0, 3.0)), lambda u, v, w: ball(u, v, w, 1.0, 2.0, 3.0)),
    "sphere": (ph.shapes.sphere(2.0, 1.5), lambda u, v, w: 1.5 * ball(u, v, w)),
    "hollow sphere": (ph.shapes.sphere(2.0, 1.0, inner_radius=0.5), lambda u, v, w: ball(u, v, w, inner=0.5)),
    "cone": (ph.shapes.cone(2.0, 1.1, 2.0), lambda u, v, w: around(1.1 * u * (1.0 - w), v, 2.0 * w)),
    "disk": (ph.shapes.disk(2.0, 1.3), lambda u, v, w: around(1.3 * u, v, 1e-9 * w)),
    "ring": (ph.shapes.disk(2.0, 1.3, inner_radius=1.0), lambda u, v, w: around(1.0 + 0.3 * u, v, 1e-9 * w)),
    "rod": (ph.shapes.rod(2.0, 1.3), lambda u, v, w: np.array([1e-9 * u, 1e-9 * v, 1.3 * w])),
    "torus": (ph.shapes.torus(2.0, 1.0, 0.3), tube),
}


@pytest.mark.parametrize("name", CASES)
def test_shapes_against_quadrature(name):
    body, place = CASES[name]
    _, _, inertia = integrated(place)
    assert body.inertia / body.mass == pytest.approx(inertia, abs=QUADRATURE * np.abs(inertia).max())
    assert body.center_of_mass.tolist() == [0.0, 0.0, 0.0]


@pytest.mark.parametrize(("one", "other"), list(itertools.permutations(["cylinder", "cone", "sphere", "torus"], 2)))
def test_the_quadrature_tells_shapes_apart(one, other):
    _, _, inertia = integrated(CASES[other][1])
    assert np.abs(CASES[one][0].inertia / 2.0 - inertia).max() > 1e-2


def test_the_cone_is_centred_a_quarter_above_its_base():
    _, center, _ = integrated(CASES["cone"][1])
    assert center == pytest.approx([0.0, 0.0, 2.0 / 4.0], abs=QUADRATURE)


def test_hollow_limits_are_thin_shells():
    assert ph.shapes.sphere(3.0, 2.0, inner_radius=2.0).principal_moments == pytest.approx([8.0] * 3, rel=EXACT)
    shell = ph.shapes.sphere(1.0, 1.0, inner_radius=1.0 - 1e-12).principal_moments
    assert shell == pytest.approx([2 / 3] * 3, rel=2e-12)  # the thickness itself
    assert ph.shapes.disk(3.0, 2.0, inner_radius=2.0).principal_moments == pytest.approx([6, 6, 12], rel=EXACT)
    hoop = ph.shapes.torus(3.0, 2.0, 1e-9).principal_moments
    assert hoop == pytest.approx([6.0, 6.0, 12.0], rel=EXACT)


def test_a_pipe_is_a_cylinder_without_its_core():
    whole, core = ph.shapes.cylinder(9.0, 3.0, 2.0), ph.shapes.cylinder(4.0, 2.0, 2.0)
    pipe = ph.shapes.cylinder(5.0, 3.0, 2.0, inner_radius=2.0)
    assert pipe.inertia == pytest.approx(whole.inertia - core.inertia, rel=EXACT)


def test_flat_and_thin_limits():
    disk, rod = ph.shapes.disk(2.0, 3.0), ph.shapes.rod(2.0, 3.0)
    assert disk.principal_moments == pytest.approx([4.5, 4.5, 9.0], rel=EXACT)
    assert rod.principal_moments.tolist() == [0.0, 1.5, 1.5]


@pytest.mark.parametrize(
    ("make", "words"),
    [
        (lambda: ph.shapes.sphere(1.0, -1.0), "`radius` must be positive"),
        (lambda: ph.shapes.sphere(0.0, 1.0), "`mass` must be positive"),
        (lambda: ph.shapes.sphere([1.0, 2.0], 1.0), "`mass` must be one number"),
        (lambda: ph.shapes.sphere(None, 1.0), "`mass` must be"),
        (lambda: ph.shapes.rod(1.0, "long"), "`length` must be"),
        (lambda: ph.shapes.box(1.0, (1.0, 2.0)), "`size` must be three"),
        (lambda: ph.shapes.box(1.0, (1.0, 2.0, np.nan)), "finite"),
        (lambda: ph.shapes.ellipsoid(1.0, 3.0), "`semi_axes` must be three"),
        (lambda: ph.shapes.torus(1.0, 1.0, 2.0), "minor_radius"),
        (lambda: ph.shapes.cylinder(1.0, 1.0, 1.0, inner_radius=2.0), "inner_radius"),
        (lambda: ph.shapes.sphere(1.0, 1.0, inner_radius="half"), "inner_radius"),
        (lambda: ph.shapes.disk(1.0, 1.0, inner_radius=-0.5), "inner_radius"),
        (lambda: ph.shapes.disk(1.0, 1.0, inner_radius=np.nan), "inner_radius"),
        (lambda: ph.shapes.sphere(1.0, 1e200), "finite"),
    ],
)
@pytest.mark.usefixtures("any_type")
def test_bad_input(make, words):
    with pytest.raises(InvalidInput, match=words):
        make()
