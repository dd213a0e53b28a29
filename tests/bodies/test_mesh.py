"""Meshes against exact bodies, another integrator, and the gate's refusals."""

import numpy as np
import pytest
import trimesh

import polhode as ph
from polhode.errors import FormatError, InvalidInput
from polhode.formats.mesh import read_mesh

EXACT = 1e-14
OTHER = 1e-9
"""Agreement with trimesh's own integration, whose sums are taken from the origin."""


def box(at=(0.0, 0.0, 0.0), size=(1.0, 2.0, 3.0)):
    mesh = trimesh.creation.box(size)
    return mesh.vertices + np.asarray(at), mesh.faces.copy()


def joined(*meshes):
    offsets = np.cumsum([0] + [len(v) for v, _ in meshes[:-1]])
    return np.vstack([v for v, _ in meshes]), np.vstack([f + o for (_, f), o in zip(meshes, offsets, strict=True)])


@pytest.mark.parametrize("far", [0.0, 1e5])
def test_box_is_exact_wherever_it_lies(far):
    body = ph.from_mesh(*box((far, -far, far)), mass=2.0)
    # corners far away are themselves rounded, to 1e5 · 2⁻⁵³
    allowed = EXACT * 4 + far * 2.0**-52
    assert body.inertia == pytest.approx(ph.shapes.box(2.0, (1.0, 2.0, 3.0)).inertia, abs=allowed)
    assert body.center_of_mass == pytest.approx([far, -far, far], abs=allowed)


def test_regular_tetrahedron():
    vertices = np.array([[1.0, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]])
    faces = [[0, 1, 2], [0, 3, 1], [0, 2, 3], [1, 3, 2]]
    body = ph.from_mesh(vertices, faces, mass=3.0)
    assert body.inertia == pytest.approx(3.0 * 8.0 / 20.0 * np.eye(3), abs=EXACT * 3)


def test_another_integrator_agrees():
    mesh = trimesh.creation.icosphere(subdivisions=2)
    turn = ph.rotation.as_matrix(ph.rotation.from_rotation_vector([0.1, 0.5, 0.9]))
    mesh.vertices = (mesh.vertices * [1.0, 1.5, 0.7]) @ turn.T
    body = ph.from_mesh(mesh.vertices, mesh.faces, density=2.0)
    mesh.density = 2.0
    assert body.mass == pytest.approx(mesh.mass, rel=OTHER)
    assert body.inertia == pytest.approx(mesh.moment_inertia, rel=OTHER, abs=OTHER)


def test_a_cavity_is_taken_out():
    vertices, faces = box(size=(0.5, 0.5, 0.5))
    hollow = ph.from_mesh(*joined(box(), (vertices, faces[:, ::-1])), density=1.0)
    wanted = ph.shapes.box(6.0, (1, 2, 3)).inertia - ph.shapes.box(0.125, (0.5,) * 3).inertia
    assert hollow.mass == pytest.approx(6.0 - 0.125)
    assert hollow.inertia == pytest.approx(wanted, abs=EXACT * 10)


def test_several_bodies_only_on_request():
    two = joined(box(), box((5.0, 0.0, 0.0)))
    with pytest.raises(InvalidInput, match="2 separate bodies"):
        ph.from_mesh(*two, mass=1.0)
    assert ph.from_mesh(*two, density=1.0, several=True).mass == pytest.approx(12.0)


def turned_face():
    vertices, faces = box()
    faces[0] = faces[0][::-1]
    return vertices, faces


@pytest.mark.parametrize(
    ("mesh", "words"),
    [
        ((box()[0], box()[1][:-1]), "open"),
        ((box()[0], box()[1][:, ::-1]), "inverted"),
        (turned_face(), "wound inconsistently"),
        (joined(box(), box((0.3, 0.1, 0.2))), "overlaps"),
        (joined(box(), box(size=(0.5, 0.5, 0.5))), "overlaps"),
        ((box()[0] * np.nan, box()[1]), "finite"),
        ((box()[0], box()[1] + 100), "index"),
        ((box()[0] * [1, 1, 0], box()[1]), "no volume"),
        ((box()[0], box()[1].astype(float)), "integer"),
    ],
)
def test_the_gate(mesh, words):
    with pytest.raises(InvalidInput, match=words):
        ph.from_mesh(*mesh, mass=1.0)


def test_mass_or_density():
    with pytest.raises(InvalidInput, match="exactly one"):
        ph.from_mesh(*box())
    with pytest.raises(InvalidInput, match="positive"):
        ph.from_mesh(*box(), mass=-1.0)


@pytest.mark.parametrize("ending", ["stl", "obj", "ply", "off"])
def test_reading_files(tmp_path, ending):
    path = tmp_path / f"box.{ending}"
    trimesh.creation.box((1.0, 2.0, 3.0)).export(path)
    body = ph.from_mesh(*read_mesh(path, unit=1e-3), mass=2.0)
    assert body.inertia == pytest.approx(1e-6 * ph.shapes.box(2.0, (1, 2, 3)).inertia, abs=1e-12)


def test_repair_only_on_request(tmp_path):
    path = tmp_path / "box.stl"
    mesh = trimesh.creation.box((1.0, 2.0, 3.0))
    mesh.faces = mesh.faces[:, ::-1]
    mesh.update_faces(np.arange(len(mesh.faces)) > 0)
    mesh.export(path)
    with pytest.raises(InvalidInput, match="open"):
        ph.from_mesh(*read_mesh(path, unit=1.0), mass=2.0)
    body = ph.from_mesh(*read_mesh(path, unit=1.0, repair=True), mass=2.0)
    assert body.inertia == pytest.approx(ph.shapes.box(2.0, (1, 2, 3)).inertia, abs=1e-6)


def test_files_that_are_no_meshes(tmp_path):
    with pytest.raises(InvalidInput, match="no such mesh"):
        read_mesh(tmp_path / "none.stl", unit=1.0)
    (tmp_path / "text.stl").write_text("hello")
    with pytest.raises(FormatError, match=r"text\.stl"):
        read_mesh(tmp_path / "text.stl", unit=1.0)
    with pytest.raises(InvalidInput, match="unit"):
        read_mesh(tmp_path / "text.stl", unit=0.0)
