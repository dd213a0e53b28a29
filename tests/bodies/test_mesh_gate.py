"""The gate of meshes: what it refuses, what it lets through, and what repair mends."""

import numpy as np
import pytest
import trimesh

import polhode as ph
from bodies.meshes import box, inside_out, joined
from polhode.bodies._mesh_crossing import find_crossing_faces
from polhode.errors import InvalidInput

EXACT = 1e-13
"""Roundings of sums over some hundred triangles, relative."""
SINGLE = 1e-6
"""What corners in single precision leave."""


def cylinder(at=0.0, sections=64, radius=1.0):
    mesh = trimesh.creation.cylinder(radius, 2.0, sections=sections)
    return np.array(mesh.vertices) + np.array([0.0, 0.0, at]), np.array(mesh.faces)


def ball(radius=1.0, at=(0.0, 0.0, 0.0), subdivisions=2):
    mesh = trimesh.creation.icosphere(subdivisions=subdivisions, radius=radius)
    return np.array(mesh.vertices) + np.asarray(at), np.array(mesh.faces)


def welded(*meshes):
    vertices, faces = joined(*meshes)
    vertices, index = np.unique(vertices, axis=0, return_inverse=True)
    return vertices, index.reshape(-1)[faces]


def one_face_turned():
    vertices, faces = box()
    faces[0] = faces[0][::-1]
    return vertices, faces


def pierced_by_its_own_spike():
    vertices, faces = ball()
    vertices[np.argmax(vertices[:, 2])] = [0.05, 0.02, -3.0]
    return vertices, faces


def walled():
    """Return a box with a whole wall inside it, from edge to edge."""
    vertices, faces = box()
    low, high = (np.flatnonzero((vertices[:, 0] * vertices[:, 1] > 0) & (vertices[:, 2] * s > 0)) for s in (-1, 1))
    return vertices, np.vstack([faces, [[low[0], low[1], high[0]], [low[1], high[1], high[0]]]])


def folded():
    """Return a path of five unit cubes, welded face to face, of which the last touches the first along an edge."""
    path = ((0, 0, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (1, 1, 0))
    return welded(*(box(at, (1, 1, 1)) for at in path))


def flapped():
    """Return a box with a flap of two triangles, back to back, on one of its edges."""
    vertices, faces = box()
    edge = faces[0][:2]
    vertices = np.vstack([vertices, [2.0, 3.0, 4.0]])
    return vertices, np.vstack([faces, [[*edge, 8]], [[*edge[::-1], 8]]])


def twisted(degrees):
    """Return a box whose one end is turned round; its triangles' diagonals bulge one way and cave in the other."""
    vertices, faces = box()
    turn = ph.rotation.as_matrix(ph.rotation.from_axis_angle([0.0, 0.0, 1.0], np.deg2rad(degrees)))
    return np.where(vertices[:, 2:] > 0, vertices @ turn.T, vertices), faces


def klein_bottle(n=12):
    index = np.arange(n * n).reshape(n, n)
    quads = []
    for i in range(n):
        for j in range(n):
            down, right = (i + 1) % n, (j + 1) % n
            across = (lambda k: (-k) % n) if i + 1 == n else (lambda k: k)
            a, b = index[i, j], index[i, right]
            c, d = index[down, across(right)], index[down, across(j)]
            quads += [[a, b, c], [a, c, d]]
    return np.random.default_rng(1).normal(size=(n * n, 3)), np.array(quads)


BROKEN = {
    "a face missing": ((box()[0], box()[1][:-1]), "open: 3 edges"),
    "two triangles": ((box()[0], box()[1][:2]), "open"),
    "turned inward": (inside_out(box()), "inverted: .* volume is -6 m³"),
    "one face turned": (one_face_turned(), "wound inconsistently"),
    "a face twice": ((box()[0], np.vstack([box()[1], box()[1][:1]])), "not a surface"),
    "a wall inside": (walled(), "open|not a surface: . edges border more than two"),
    "a body welded in a body": (welded(box(), box((-0.25, 0, 0), (0.5, 1, 3))), "overlaps"),
    "the same body twice, welded": (welded(box(), box()), "12 of its triangles are there more than once"),
    "a corner repeated": ((box()[0], np.vstack([box()[1], [[0, 0, 1]]])), "repeated corner"),
    "flat": ((box()[0] * [1, 1, 0], box()[1]), "no volume"),
    "flat and tilted": ((box()[0] @ [[0.3, 0.1, 0.7], [0.2, 0.9, 0.4], [0, 0, 0]], box()[1]), "no volume"),
    "a body across another": (joined(box(), box((0.3, 0.1, 0.2))), "overlaps itself: two of its 2 pieces"),
    "balls across each other": (joined(ball(), ball(at=(1.7, 0.3, 0.1))), "overlaps itself"),
    "a body in a body": (joined(box(), box(size=(0.5, 0.5, 0.5))), "overlaps itself: 1 of its 2 pieces lie inside"),
    "aligned boxes": (joined(box(), box((0.0, 0.0, 1.5))), "overlaps itself.*partly inside"),
    "aligned cylinders": (joined(cylinder(), cylinder(1.5)), "overlaps itself.*partly inside"),
    "the same body twice": (joined(box(), box()), "same place"),
    "bodies through a common corner": (
        welded(box((0.5, 0.5, 0.5), (1, 1, 1)), box((0.25, 0.25, 1.0), (0.5, 0.5, 2.0))),
        "overlaps itself",
    ),
    "a spike through itself": (pierced_by_its_own_spike(), "its surface passes through itself"),
    "a box twisted through itself": (twisted(-150.0), "its surface passes through itself"),
    "one of two turned inward": (joined(box(), inside_out(box((5, 0, 0), (1, 1, 1)))), "inverted in part"),
    "a cavity outside": (joined(box(), inside_out(box((1.0, 0, 0), (1, 1, 1)))), "inverted in part"),
    "a cavity through the wall": (joined(box(), inside_out(box((0.5, 0.1, 0.2), (0.5, 0.5, 0.5)))), "overlaps"),
    "a corner that is NaN": ((np.where(box()[0] > 1.4, np.nan, box()[0]), box()[1]), "finite"),
    "an index too large": ((box()[0], box()[1] + 100), "index the 8 vertices"),
    "an index below zero": ((box()[0], box()[1] - 1), "index the 8 vertices"),
    "indices that are no integers": ((box()[0], box()[1].astype(float)), "integer"),
    "quadrangles": ((box()[0], np.zeros((6, 4), dtype=int)), "triangles only"),
    "words": (([["a", "b", "c"]], box()[1]), "numbers"),
    "ragged faces": ((box()[0], [[0, 1, 2], [0, 1]]), "numbers"),
    "complex corners": ((box()[0] * 1j, box()[1]), "real"),
}


@pytest.mark.parametrize("fault", BROKEN)
def test_broken_meshes_are_refused(fault):
    mesh, words = BROKEN[fault]
    with pytest.raises(InvalidInput, match=words):
        ph.Body.from_mesh(*mesh, mass=1.0, several=True)


ICOSAHEDRON = trimesh.creation.icosahedron().volume
WHOLE = {
    "a box": (box(), 6.0),
    "a ball": (ball(subdivisions=3), trimesh.creation.icosphere(subdivisions=3).volume),
    "bodies face on face": (joined(box(), box((1.0, 0, 0))), 12.0),
    "bodies face on part of a face": (joined(box(), box((0.75, 0.1, 0.3), (0.5, 0.5, 0.5))), 6.125),
    "bodies edge on edge": (joined(box(), box((1.0, 2.0, 0))), 12.0),
    "bodies corner on corner": (joined(box(), box((1.0, 2.0, 3.0))), 12.0),
    "bodies welded at an edge": (welded(box(size=(1, 1, 1)), box((1, 1, 0), (1, 1, 1))), 2.0),
    "bodies welded at a face": (welded(box(size=(1, 1, 1)), box((1, 0, 0), (1, 1, 1))), 2.0),
    "four bodies welded about an edge": (
        welded(*(box((x, y, 0), (1, 1, 1)) for x in (0, 1) for y in (0, 1))), 4.0,
    ),
    "a body that touches itself along an edge": (folded(), 5.0),
    "a flap": (flapped(), 6.0),
    "bodies welded at a corner": (welded(box(), box((1.0, 2.0, 3.0))), 12.0),
    "edge on face": (
        joined(box(size=(2, 2, 2)), ball(0.5, (0, 0, 1 + ball(0.5, subdivisions=0)[0][:, 2].max()), 0)),
        8.0 + ICOSAHEDRON / 8.0,
    ),
    "coaxial cylinders": (joined(cylinder(), cylinder(2.0)), 2 * trimesh.creation.cylinder(1, 2, sections=64).volume),
    "a cavity that touches the wall": (joined(box(), inside_out(box((0.25, 0, 0), (0.5, 1, 1)))), 5.5),
    "cavity, body, cavity": (
        joined(*(m if k % 2 == 0 else inside_out(m) for k, m in enumerate(box(size=(s,) * 3) for s in (4, 3, 2, 1)))),
        64.0 - 27.0 + 8.0 - 1.0,
    ),
}


@pytest.mark.parametrize("name", WHOLE)
def test_whole_meshes_pass(name):
    (vertices, faces), volume = WHOLE[name]
    turn = ph.rotation.as_matrix(ph.rotation.from_rotation_vector([0.3, 0.7, -0.4]))
    assert ph.Body.from_mesh(vertices, faces, density=1.0, several=True).mass == pytest.approx(volume, rel=EXACT)
    for moved in (vertices @ turn.T, 1e-6 * vertices, (vertices @ turn.T).astype(np.float32)):
        body = ph.Body.from_mesh(moved, faces, density=1.0, several=True)
        scale = np.ptp(moved[:, 0]) / np.ptp((vertices @ turn.T if moved.max() > 1e-3 else vertices)[:, 0])
        assert body.mass == pytest.approx(volume * scale**3, rel=SINGLE)


@pytest.mark.long
def test_crossings_are_found_wherever_they_are():
    """One small ball after another is put across the wall of a fine one."""
    large, small = ball(subdivisions=3), ball(0.02, subdivisions=0)
    rng = np.random.default_rng(2)
    for _ in range(20):
        direction = rng.normal(size=3)
        place = direction / np.linalg.norm(direction)
        found = find_crossing_faces(*joined(large, (small[0] + place, small[1])))
        assert found is not None
        assert min(found) < len(large[1]) <= max(found)
        assert find_crossing_faces(*joined(large, (small[0] + 1.1 * place, small[1]))) is None


def windings(mesh, count=2000):
    """Return how often a closed mesh winds around random points, by summed solid angles."""
    vertices, faces = mesh
    low, high = vertices.min(axis=0), vertices.max(axis=0)
    points = np.random.default_rng(0).uniform(low, high, size=(count, 3))
    total = np.zeros(count)
    for triangle in vertices[faces]:
        a, b, c = (corner - points for corner in triangle)
        la, lb, lc = (np.linalg.norm(side, axis=1) for side in (a, b, c))
        dots = (a * b).sum(1) * lc + (b * c).sum(1) * la + (c * a).sum(1) * lb
        total += np.arctan2((a * np.cross(b, c)).sum(1), la * lb * lc + dots) / (2.0 * np.pi)
    return set(np.rint(total).astype(int).tolist())


@pytest.mark.parametrize("degrees", [-150.0, -90.0, 0.0, 90.0, 170.0])
def test_a_twist_is_refused_just_where_volume_counts_wrongly(degrees):
    wrong = not windings(twisted(degrees)) <= {0, 1}
    assert wrong == (degrees < 0)
    assert (find_crossing_faces(*twisted(degrees)) is not None) == wrong


def test_rough_surfaces_that_pass_wind_once():
    rng = np.random.default_rng(1)
    verdicts = []
    for _ in range(40):
        vertices, faces = ball(subdivisions=1)
        vertices += rng.normal(size=vertices.shape) * rng.choice([0.05, 0.15, 0.3])
        verdicts.append(find_crossing_faces(vertices, faces) is None)
        if verdicts[-1]:
            assert windings((vertices, faces), 500) <= {0, 1}
    assert 10 <= sum(verdicts) <= 30


def scrambled(mesh, seed=0):
    vertices, faces = mesh
    turned = np.random.default_rng(seed).random(len(faces)) < 0.5
    return vertices, np.where(turned[:, None], faces[:, ::-1], faces)


@pytest.mark.parametrize("name", WHOLE)
def test_repair_turns_faces_right(name):
    mesh, volume = WHOLE[name]
    welded_in_part = any(words in name for words in ("welded at a", "along an edge", "about an edge", "flap"))
    # around an edge that bodies share, turned faces do not say which of them belong together
    for spoiled in (mesh,) if welded_in_part else (inside_out(mesh), scrambled(mesh), mesh):
        repaired = ph.Body.from_mesh(*spoiled, density=1.0, several=True, repair=True)
        assert repaired.mass == pytest.approx(volume, rel=EXACT)
    with pytest.raises(InvalidInput, match=r"wound inconsistently|not a surface"):
        ph.Body.from_mesh(*scrambled(mesh), density=1.0, several=True)


def test_repair_drops_triangles_with_repeated_corners():
    vertices, faces = box()
    needle = np.vstack([faces, [[0, 0, 1]]])
    assert ph.Body.from_mesh(vertices, needle, density=1.0, repair=True).mass == pytest.approx(6.0)


@pytest.mark.parametrize(
    ("mesh", "words"),
    [
        ((box()[0], box()[1][:-1]), "open"),
        (joined(box(), box((0.3, 0.1, 0.2))), "overlaps"),
        (walled(), "open|not a surface"),
        (klein_bottle(), "only one side"),
        ((box()[0] * [1, 1, 0], box()[1]), "no volume"),
        ((box()[0], np.zeros((12, 3), dtype=int)), "open"),
    ],
)
def test_what_repair_cannot_mend_is_still_refused(mesh, words):
    with pytest.raises(InvalidInput, match=words):
        ph.Body.from_mesh(*mesh, mass=1.0, repair=True)
