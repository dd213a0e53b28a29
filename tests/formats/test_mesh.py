"""Reading meshes: many forms, units, merging of corners, and repair on request only."""

import sys
import time

import numpy as np
import pytest
import trimesh

import polhode as ph
from polhode.errors import FormatError, InvalidInput
from polhode.formats.mesh import load_mesh, read_mesh
from polhode.formats.stl_mesh import read_stl

EXACT = 1e-13
"""A few roundings, relative, for files that keep double precision or numbers of few digits."""
SINGLE = 1e-6
"""What corners in single precision leave."""
SIZE = (1.0, 2.0, 3.0)


def saved(folder, mesh, name="mesh.stl"):
    path = folder / name
    mesh.export(path)
    return path


def check_box(mesh, size=SIZE, allowed=EXACT):
    wanted = ph.shapes.box(2.0, size).inertia
    found = ph.Body.from_mesh(*mesh, mass=2.0).inertia
    assert np.abs(found - wanted).max() <= allowed * np.abs(wanted).max()


@pytest.mark.parametrize("ending", ["stl", "obj", "ply", "off", "glb"])
def test_a_box_in_every_form(tmp_path, ending):
    path = saved(tmp_path, trimesh.creation.box(SIZE), f"box.{ending}")
    check_box(read_mesh(path, unit=1.0))
    check_box(read_mesh(path, unit=1e-3), np.array(SIZE) * 1e-3)


def test_text_forms(tmp_path):
    mesh = trimesh.creation.box(SIZE)
    (tmp_path / "box.stl").write_text(trimesh.exchange.stl.export_stl_ascii(mesh))
    check_box(read_mesh(tmp_path / "box.stl", unit=1.0))
    corners = "\n".join(f"v {x} {y} {z}" for x in (0, 1) for y in (0, 2) for z in (0, 3))
    quadrangles = "f 1 2 4 3\nf 5 7 8 6\nf 1 5 6 2\nf 3 4 8 7\nf 1 3 7 5\nf 2 6 8 4\n"
    (tmp_path / "box.obj").write_text(f"{corners}\n{quadrangles}")
    check_box(read_mesh(tmp_path / "box.obj", unit=1.0))


def test_scenes_are_joined_with_their_placement(tmp_path):
    scene = trimesh.Scene()
    for x in (-2.0, 2.0):
        scene.add_geometry(trimesh.creation.box(SIZE), transform=trimesh.transformations.translation_matrix((x, 0, 0)))
    vertices, faces = read_mesh(saved(tmp_path, scene, "two.glb"), unit=1.0)
    body = ph.Body.from_mesh(vertices, faces, density=1.0, several=True)
    wanted = ph.combine([ph.shapes.box(6.0, SIZE).placed(np.eye(3), (x, 0, 0)) for x in (-2.0, 2.0)])
    assert body.inertia == pytest.approx(wanted.inertia, abs=EXACT * 100)


def test_a_part_of_a_micrometre_in_a_file_in_metres_is_not_merged_away(tmp_path):
    tiny = np.array(SIZE) * 1e-9
    check_box(read_mesh(saved(tmp_path, trimesh.creation.box(tiny)), unit=1.0), tiny, SINGLE)
    check_box(read_mesh(saved(tmp_path, trimesh.creation.box(tiny)), unit=1.0, repair=True), tiny, SINGLE)


def test_negative_zeros_are_the_same_corner(tmp_path):
    mesh = trimesh.creation.box(SIZE)
    mesh.vertices += 0.5 * np.array(SIZE)
    loose = mesh.triangles.copy()
    loose[::2][loose[::2] == 0.0] = -0.0
    path = saved(tmp_path, trimesh.Trimesh(loose.reshape(-1, 3), np.arange(36).reshape(-1, 3), process=False))
    assert len(read_mesh(path, unit=1.0)[0]) == 8


def cracked(mesh, width=1e-7):
    """Return the mesh with every triangle's corners moved a little of its own."""
    corners = np.array(mesh.triangles).reshape(-1, 3)
    corners = corners + width * np.random.default_rng(0).uniform(-1, 1, corners.shape)
    return trimesh.Trimesh(corners, np.arange(len(corners)).reshape(-1, 3), process=False)


def turned(mesh):
    faces = np.array(mesh.faces)
    flip = np.random.default_rng(0).random(len(faces)) < 0.5
    return trimesh.Trimesh(mesh.vertices, np.where(flip[:, None], faces[:, ::-1], faces), process=False)


def without(mesh, *faces):
    return trimesh.Trimesh(mesh.vertices, np.delete(mesh.faces, faces, axis=0), process=False)


BOX = trimesh.creation.box(SIZE)
TWICE = np.vstack([BOX.faces, BOX.faces[:1]])
SPOILED = {
    "inverted": (trimesh.Trimesh(BOX.vertices, BOX.faces[:, ::-1], process=False), "inverted"),
    "turned at random": (turned(BOX), "wound inconsistently"),
    "one triangle missing": (without(BOX, 0), "open"),
    "turned at random, one missing": (without(turned(BOX), 3), "open"),
    "cracked": (cracked(BOX), "open"),
    "a triangle twice": (trimesh.Trimesh(BOX.vertices, TWICE, process=False), "not a surface"),
}


@pytest.mark.parametrize("fault", SPOILED)
def test_repair_only_on_request(tmp_path, fault):
    mesh, words = SPOILED[fault]
    path = saved(tmp_path, mesh)
    with pytest.raises(InvalidInput, match=words):
        ph.Body.from_mesh(*read_mesh(path, unit=1.0), mass=2.0)
    check_box(read_mesh(path, unit=1.0, repair=True), allowed=SINGLE)


def test_repair_leaves_a_good_mesh_as_it_is(tmp_path):
    path = saved(tmp_path, trimesh.creation.torus(2.0, 0.5))
    good, same = (ph.Body.from_mesh(*read_mesh(path, unit=1.0, repair=repair), mass=1.0) for repair in (False, True))
    assert same.inertia == pytest.approx(good.inertia, abs=EXACT)


def test_repair_keeps_cavities(tmp_path):
    hollow = trimesh.util.concatenate([trimesh.creation.icosphere(2), trimesh.creation.icosphere(2, radius=0.5)])
    path = saved(tmp_path, hollow)
    with pytest.raises(InvalidInput, match="overlaps itself: 1 of its 2 pieces lie inside"):
        ph.Body.from_mesh(*read_mesh(path, unit=1.0), density=1.0)
    mass = ph.Body.from_mesh(*read_mesh(path, unit=1.0, repair=True), density=1.0).mass
    assert mass == pytest.approx(0.875 * trimesh.creation.icosphere(2).volume, rel=SINGLE)


def test_holes_too_large_to_guess_stay_open(tmp_path):
    ball = trimesh.creation.icosphere(2)
    path = saved(tmp_path, without(ball, *np.flatnonzero(ball.triangles_center[:, 2] > 0.5)))
    with pytest.raises(InvalidInput, match="open"):
        ph.Body.from_mesh(*read_mesh(path, unit=1.0, repair=True), mass=2.0)


POINTS = (
    "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\nproperty float z\nend_header\n"
    "0 0 0\n1 1 1\n"
)


@pytest.mark.parametrize(
    ("name", "text", "words"),
    [
        ("text.stl", "hello", "cannot be read as a mesh|no triangles"),
        ("empty.stl", "", "cannot be read as a mesh|no triangles"),
        ("points.ply", POINTS, "no triangles"),
        ("lines.obj", "v 0 0 0\nv 1 0 0\nl 1 2\n", "no triangles"),
        ("mesh.nonsense", "hello", "must end in one of"),
        ("nan.obj", "v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "line 1: a corner must be three finite numbers"),
    ],
)
def test_files_that_are_no_meshes(tmp_path, name, text, words):
    (tmp_path / name).write_text(text)
    with pytest.raises(FormatError, match=f"(?s){name}.*({words})"):
        read_mesh(tmp_path / name, unit=1.0)


def test_a_file_cut_short(tmp_path):
    path = saved(tmp_path, BOX)
    path.write_bytes(path.read_bytes()[:-60])
    with pytest.raises(InvalidInput, match=r"mesh\.stl: (cannot be read|holds no triangles)"):
        ph.Body.from_mesh(*read_mesh(path, unit=1.0), mass=1.0)


@pytest.mark.usefixtures("any_type")
def test_missing_file_and_bad_unit(tmp_path, any_type):
    with pytest.raises(InvalidInput, match="no such mesh file"):
        read_mesh(tmp_path / "none.stl", unit=1.0)
    with pytest.raises(InvalidInput, match="is a folder, not a mesh file"):
        read_mesh(tmp_path, unit=1.0)
    for unit in (0.0, -1.0, np.nan, np.ones(3), "mm"):
        with pytest.raises(InvalidInput, match="`unit` must be"):
            read_mesh(saved(tmp_path, BOX), unit=unit)


@pytest.mark.parametrize("text", [False, True])
def test_stl_is_what_trimesh_reads(tmp_path, text):
    body = trimesh.creation.icosphere(2, 0.37)
    if text:
        (tmp_path / "ball.stl").write_text(trimesh.exchange.stl.export_stl_ascii(body))
    path = tmp_path / "ball.stl" if text else saved(tmp_path, body, "ball.stl")
    other = trimesh.load(path, process=False)
    vertices, faces = read_stl(path, path.read_bytes())
    assert np.array_equal(vertices, other.vertices) and np.array_equal(faces, other.faces)
    assert not np.array_equal(vertices, body.triangles.reshape(-1, 3)) or text  # single precision, the file's


HOLES = 1e-5
"""A hole of six triangles closed flat, of a ball of 20,480: the cap has less than that of its volume."""


@pytest.mark.long
def test_repair_says_what_it_did(tmp_path):
    """A ball without the triangles about one corner, some of the others turned and one there twice."""
    mesh = trimesh.creation.icosphere(subdivisions=5)
    faces = mesh.faces[~(mesh.faces == 100).any(axis=1)]
    lost = len(mesh.faces) - len(faces)
    faces[:10] = faces[:10, ::-1]
    faces = np.vstack([faces, faces[-1:]])
    trimesh.Trimesh(mesh.vertices, faces, process=False).export(tmp_path / "ball.stl")
    read = load_mesh(tmp_path / "ball.stl", 1.0, repair=True)
    (note,) = read.notes
    assert f"closed 1 hole of up to {lost} edges" in note and "turned 10 triangles round" in note
    assert "dropped 1 triangles that lay on others (1 places)" in note
    assert ph.Body.from_mesh(read.vertices, read.faces, density=1.0).mass == pytest.approx(mesh.volume, rel=HOLES)
    whole = load_mesh(saved(tmp_path, mesh), 1.0, repair=True)
    assert whole.notes == ("repair had nothing to mend.",) and load_mesh(saved(tmp_path, mesh), 1.0).notes == ()


def test_large_holes_stay_open(tmp_path):
    mesh = trimesh.creation.icosphere(subdivisions=3)
    half = mesh.faces[mesh.vertices[mesh.faces].mean(axis=1)[:, 2] < 0.5]
    trimesh.Trimesh(mesh.vertices, half, process=False).export(tmp_path / "bowl.stl")
    read = load_mesh(tmp_path / "bowl.stl", 1.0, repair=True)
    with pytest.raises(InvalidInput, match="is open"):
        ph.Body.from_mesh(read.vertices, read.faces, density=1.0)


@pytest.mark.parametrize(("kept", "closed"), [
    (lambda n: n[:, 2] < 0.5, False),  # no lid
    (lambda n: np.abs(n[:, 2]) < 0.5, False),  # a square tube
    (lambda n: np.arange(12) != 3, True),  # one triangle of twelve
])  # fmt: skip
def test_a_box_without_its_lid_is_no_damaged_box(tmp_path, kept, closed):
    box = trimesh.creation.box((0.1, 0.1, 0.1))
    trimesh.Trimesh(box.vertices, box.faces[kept(box.face_normals)], process=False).export(tmp_path / "box.stl")
    read = load_mesh(tmp_path / "box.stl", 1.0, repair=True)
    if closed:
        assert ph.Body.from_mesh(read.vertices, read.faces, density=1000.0).mass == pytest.approx(1.0, rel=1e-6)
        return
    with pytest.raises(InvalidInput, match=r"is open: \d+ edges"):
        ph.Body.from_mesh(read.vertices, read.faces, density=1000.0)


def test_two_lost_triangles_of_a_flat_face_are_put_back(tmp_path):
    box = trimesh.creation.box((0.1, 0.1, 0.1)).subdivide()
    up = np.flatnonzero(box.face_normals[:, 2] > 0.5)
    shared = next(pair for pair in box.face_adjacency if set(pair) <= set(up))
    kept = np.setdiff1d(np.arange(len(box.faces)), shared)
    trimesh.Trimesh(box.vertices, box.faces[kept], process=False).export(tmp_path / "box.stl")
    read = load_mesh(tmp_path / "box.stl", 1.0, repair=True)
    assert ph.Body.from_mesh(read.vertices, read.faces, density=1000.0).mass == pytest.approx(1.0, rel=1e-6)
    assert "closed 1 hole of up to 4 edges" in read.notes[0]


@pytest.mark.sweep
def test_repair_of_many_pieces_is_quick(tmp_path):
    """42 balls of 1280 triangles, in each other's boxes: their nesting was asked by solid angles, for half a minute."""
    balls = []
    for k in range(42):
        ball = trimesh.creation.icosphere(subdivisions=3, radius=0.4)
        ball.apply_translation([k % 7, k // 7 % 6, 0.0])
        balls.append(ball)
    mesh = trimesh.util.concatenate(balls)
    kept = np.ones(len(mesh.faces), dtype=bool)
    kept[::997] = False
    trimesh.Trimesh(mesh.vertices, mesh.faces[kept], process=False).export(tmp_path / "many.stl")
    began = time.process_time()
    read = load_mesh(tmp_path / "many.stl", 1.0, repair=True)
    mass = ph.Body.from_mesh(read.vertices, read.faces, density=1.0, several=True).mass
    assert time.process_time() - began < 10.0  # 3.5 on the machine where it was measured, where it took 13 before
    assert mass == pytest.approx(mesh.volume, rel=1e-6)


@pytest.mark.parametrize(("ending", "unit"), [("3mf", 1e-3), ("dae", 1.0)])
def test_formats_with_a_unit(tmp_path, ending, unit):
    path = tmp_path / f"box.{ending}"
    trimesh.creation.box(SIZE).export(path)
    check_box(read_mesh(path, unit=unit), np.array(SIZE) * unit, SINGLE)
    with pytest.raises(InvalidInput, match="says itself that its unit is"):
        read_mesh(path, unit=0.0254)


def test_a_missing_library_is_named(tmp_path, monkeypatch):
    trimesh.creation.box(SIZE).export(tmp_path / "box.3mf")
    monkeypatch.setitem(sys.modules, "lxml.etree", None)
    with pytest.raises(InvalidInput, match="3MF files need lxml, which is not installed"):
        read_mesh(tmp_path / "box.3mf", unit=1e-3)


@pytest.mark.parametrize(("ending", "content", "words"), [
    ("3mf", b"not a zip", "it is no archive"), ("dae", b"<!DOCTYPE a [<!ENTITY b 'c'>]><COLLADA/>", "document type"),
    ("dae", b"<COLLADA><asset><unit meter='x'/></asset></COLLADA>", "number of metres"),
    ("dae", b"<COLLADA", "cannot be read as a mesh"),
])  # fmt: skip
def test_broken_files_with_a_unit(tmp_path, ending, content, words):
    (tmp_path / f"a.{ending}").write_bytes(content)
    with pytest.raises(FormatError, match=words):
        read_mesh(tmp_path / f"a.{ending}", unit=1.0)


def test_only_files_that_name_their_unit_need_none(tmp_path):
    """3MF counts in millimetres where it says nothing else; an STL file says nothing at all."""
    pytest.importorskip("lxml")
    box = trimesh.creation.box((1.0, 2.0, 3.0))
    vertices, _ = read_mesh(saved(tmp_path, box, "box.3mf"))
    assert np.ptp(vertices, axis=0) == pytest.approx([1e-3, 2e-3, 3e-3], rel=1e-6)
    with pytest.raises(InvalidInput, match="`unit` is missing"):
        read_mesh(saved(tmp_path, box, "box.stl"))


def test_a_thick_wall_is_no_sheet():
    ball = trimesh.creation.icosphere(2, 0.05)
    assert ph.Body.from_sheet(ball.vertices, ball.faces, density=1000.0, thickness=0.002).mass > 0.0
    with pytest.raises(InvalidInput, match=r"`thickness` of a sheet must be at most 0\.25 of the mesh's size, 0\.1 m"):
        ph.Body.from_sheet(ball.vertices, ball.faces, density=1000.0, thickness=0.08)
