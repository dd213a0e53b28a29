"""Shapes against Gauss–Legendre quadrature over each body's own coordinates."""

import itertools

import mpmath
import numpy as np
import pytest
import trimesh

import polhode as ph
from polhode.bodies import _solids as solids
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
    "box with walls": (ph.shapes.box_shell(2.0, (1.0, 2.0, 0.5), thickness=0.5), lambda u, v, w: np.array(
        [1.5 * u, 2.5 * v, 1.0 * w])),
    "pipe with a wall": (ph.shapes.cylinder_shell(2.0, 0.55, 1.9, 0.3, open_ends=True),
                         lambda u, v, w: around(0.4 + 0.3 * u, v, 1.9 * w)),
    "hollow ball": (ph.shapes.sphere_shell(2.0, 0.75, 0.5), lambda u, v, w: ball(u, v, w, inner=0.5)),
}  # fmt: skip
"""The box's walls are so thick that they meet, and fill it."""


MP_DIGITS = 40


def moments_by_mpmath(outline):
    """Return area, centroid and mean of r rᵀ about it of a polygon cut into triangles from its first corner."""
    with mpmath.workdps(MP_DIGITS):
        points = [(mpmath.mpf(x), mpmath.mpf(y)) for x, y in outline]
        area, first, second = mpmath.mpf(0), [mpmath.mpf(0)] * 2, [[mpmath.mpf(0)] * 2 for _ in range(2)]
        (ax, ay) = points[0]
        for (bx, by), (cx, cy) in itertools.pairwise(points[1:]):
            part = ((bx - ax) * (cy - ay) - (by - ay) * (cx - ax)) / 2
            corners = [(ax, ay), (bx, by), (cx, cy)]
            # three points half way along the sides integrate quadratics exactly
            middles = [tuple((p + q) / 2 for p, q in zip(corners[k - 1], corners[k], strict=True)) for k in range(3)]
            area += part
            for i in range(2):
                first[i] += part * sum(m[i] for m in middles) / 3
                for j in range(2):
                    second[i][j] += part * sum(m[i] * m[j] for m in middles) / 3
        c = [x / area for x in first]
        mean = [[second[i][j] / area - c[i] * c[j] for j in range(2)] for i in range(2)]
        return float(abs(area)), [float(x) for x in c], np.array([[float(x) for x in row] for row in mean])


OUTLINES = {
    "L": [(0, 0), (2, 0), (2, 1), (1, 1), (1, 3), (0, 3)],
    "clockwise L far away": [(x + 1e6, y - 3e6) for x, y in [(0, 3), (1, 3), (1, 1), (2, 1), (2, 0), (0, 0)]],
    "arrow": [(0.1, 0), (2.3, 1.7), (0.1, 0.9), (-1.1, 2.0)],
}


@pytest.mark.parametrize("name", OUTLINES)
def test_prisms_on_outlines(name):
    area, center, mean = moments_by_mpmath(OUTLINES[name])
    body = ph.shapes.prism(3.0, 0.7, outline=OUTLINES[name])
    along = 0.7**2 / 12
    expected = np.array([[mean[1, 1] + along, -mean[0, 1], 0], [-mean[0, 1], mean[0, 0] + along, 0],
                         [0, 0, mean[0, 0] + mean[1, 1]]])  # fmt: skip
    assert body.inertia / 3.0 == pytest.approx(expected, rel=1e-13, abs=1e-14)
    assert body.center_of_mass == pytest.approx([*center, 0.0], rel=1e-15, abs=1e-15)
    assert solids.prism(0.7, outline=OUTLINES[name]).volume == pytest.approx(0.7 * area, rel=1e-14)


def test_regular_prisms_are_the_outline_s():
    for sides in (3, 5, 6, 40):
        angles = 2 * np.pi / sides * np.arange(sides)
        outline = 1.3 * np.column_stack([np.cos(angles), np.sin(angles)])
        one, other = ph.shapes.prism(2.0, 1.0, sides=sides, radius=1.3), ph.shapes.prism(2.0, 1.0, outline=outline)
        assert one.inertia == pytest.approx(other.inertia, rel=1e-14, abs=1e-15)
        volumes = [solids.prism(1.0, **kind).volume for kind in ({"sides": sides, "radius": 1.3}, {"outline": outline})]
        assert volumes[0] == pytest.approx(volumes[1], rel=1e-14)


def test_a_capsule_is_a_cylinder_and_two_half_balls():
    """Half a ball from its own quadrature: ⟨z⟩ = 3r/8 above its base."""
    radius, length = 0.4, 1.7
    _, center, inertia = integrated(lambda u, v, w: hemisphere(radius, u, v, w))
    assert center[2] == pytest.approx(3 * radius / 8, rel=1e-12)
    middle, cap = np.pi * radius**2 * length, 2 / 3 * np.pi * radius**3
    half = ph.Body(cap, center, cap * inertia)
    up = half.placed(translation=(0, 0, length / 2))
    down = half.placed(rotation=(0, 1, 0, 0), translation=(0, 0, -length / 2))
    whole = ph.combine([ph.shapes.cylinder(middle, radius, length), up, down])
    capsule = ph.shapes.capsule(whole.mass, radius, length)
    assert capsule.inertia == pytest.approx(whole.inertia, rel=1e-12, abs=1e-13)
    assert solids.capsule(radius, length).volume == pytest.approx(whole.mass, rel=1e-14)


def hemisphere(radius, u, v, w):
    across = radius * u * np.sqrt(1.0 - w * w)
    return np.array([across * np.cos(2 * np.pi * v), across * np.sin(2 * np.pi * v), radius * u * w])


SHELLS = {
    "box": (lambda t: solids.box_shell((1.0, 2.0, 3.0), t), lambda s: solids.box((1 + s, 2 + s, 3 + s))),
    "sphere": (lambda t: solids.sphere_shell(2.0, t), lambda s: solids.sphere(2.0 + s / 2)),
    "can": (lambda t: solids.cylinder_shell(2.0, 3.0, t), lambda s: solids.cylinder(2.0 + s / 2, 3.0 + s)),
    "pipe": (lambda t: solids.cylinder_shell(2.0, 3.0, t, True), lambda s: solids.cylinder(2.0 + s / 2, 3.0)),
}


@pytest.mark.parametrize("name", SHELLS)
def test_walls_are_what_lies_between_two_solids(name):
    shell, solid = SHELLS[name]
    outer, inner, wall = solid(0.25), solid(-0.25), shell(0.25)
    assert wall.volume == pytest.approx(outer.volume - inner.volume, rel=1e-14)
    between = (outer.volume * outer.second - inner.volume * inner.second) / (outer.volume - inner.volume)
    assert wall.second == pytest.approx(between, rel=1e-13)
    # and without a thickness the limit, to the square of it
    assert shell(0.0).second == pytest.approx(shell(1e-5).second, rel=1e-9)
    assert shell(0.0).volume is None


def test_thin_shells_as_textbooks_have_them():
    assert ph.shapes.sphere_shell(3.0, 2.0).principal_moments == pytest.approx([8.0] * 3, rel=EXACT)
    assert ph.shapes.box_shell(18.0, (1, 1, 1)).principal_moments == pytest.approx([5.0] * 3, rel=EXACT)
    can = ph.shapes.cylinder_shell(1.0, 1.0, 2.0, open_ends=True)
    assert np.diag(can.inertia) == pytest.approx([0.5 + 4 / 12, 0.5 + 4 / 12, 1.0], rel=EXACT)


def test_a_sheet_is_a_shell_s_limit():
    """A box of triangles with mass on them, and one plate as textbooks have it."""
    mesh = trimesh.creation.box((1.0, 2.0, 3.0))
    sheet = ph.Body.from_sheet(mesh.vertices, mesh.faces, density=10.0, thickness=1e-3)
    assert sheet.mass == pytest.approx(10.0 * 1e-3 * 22.0, rel=1e-14)
    shell = ph.shapes.box_shell(sheet.mass, (1.0, 2.0, 3.0))
    assert sheet.inertia == pytest.approx(shell.inertia, rel=1e-14, abs=1e-16)
    plate = ph.Body.from_sheet([[5, 0, 0], [7, 0, 0], [7, 3, 0], [5, 3, 0]], [[0, 1, 2], [0, 2, 3]], mass=12.0)
    assert plate.principal_moments == pytest.approx([4.0, 9.0, 13.0], rel=1e-14)
    assert plate.center_of_mass.tolist() == [6.0, 1.5, 0.0]


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
        (lambda: ph.shapes.sphere([1.0, 2.0], 1.0), "`mass` must be positive and finite"),
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
        (lambda: ph.shapes.prism(1.0, 1.0), "either `sides` and `radius` or an `outline`"),
        (lambda: ph.shapes.prism(1.0, 1.0, sides=2, radius=1.0), "`sides` must be a whole number from 3"),
        (lambda: ph.shapes.prism(1.0, 1.0, sides=5), "both `sides` and `radius`"),
        (lambda: ph.shapes.prism(1.0, 1.0, outline=[(0, 0), (1, 1), (1, 0), (0, 1)]), "must not cross or touch itself"),
        (lambda: ph.shapes.prism(1.0, 1.0, outline=[(0, 0), (1, 0), (2, 0)]), "must not cross or touch itself"),
        (lambda: ph.shapes.prism(1.0, 1.0, outline=[(0, 0), (1, 0)]), "3 to 2000 corners"),
        (lambda: ph.shapes.capsule(1.0, 1.0, 0.0), "`length` must be positive"),
        (lambda: ph.shapes.box_shell(1.0, (1, 1, 1), thickness=1.1), "`thickness` must be from 0 to 1 "),
        (lambda: ph.shapes.sphere_shell(1.0, 1.0, thickness=-1.0), "`thickness` must be from 0 to 2 "),
        (lambda: ph.shapes.point(0.0), "`mass` must be positive"),
        (lambda: ph.combine([ph.shapes.point(1.0)]), "must not all vanish"),
        (lambda: ph.combine([ph.shapes.sphere(1.0, 1.0)], cut=[ph.shapes.sphere(1.0, 1.0)]), "nothing is left"),
        (lambda: ph.combine([ph.shapes.sphere(2.0, 1.0)], cut=[ph.shapes.sphere(1.0, 3.0)]), "cuts leave is no body"),
        (lambda: ph.Body.from_sheet([[0, 0, 0], [1, 0, 0], [2, 0, 0]], [[0, 1, 2]], mass=1.0), "no area"),
        (lambda: ph.Body.from_sheet([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]], density=1.0), "with `thickness`"),
    ],
)
@pytest.mark.usefixtures("any_type")
def test_bad_input(make, words):
    with pytest.raises(InvalidInput, match=words):
        make()
