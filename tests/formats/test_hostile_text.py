"""Meshes, molecules, robots, tables and messages that were made to mislead, to wait or to fill the memory."""

import base64
import io
import json
import os
import re
import struct
import zipfile

import numpy as np
import pytest

import polhode as ph
from polhode import formats, spacecraft
from polhode.errors import FormatError, InvalidInput


@pytest.fixture
def saved(tmp_path):
    def save(name, content):
        path = tmp_path / name
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
        return path

    return save


def refused(read, path):
    """Return the one message with which a reader refuses a small file."""
    assert path.stat().st_size < 1.1e6
    with pytest.raises(InvalidInput, match=path.name) as error:
        read(path)
    assert len(str(error.value)) <= 3000
    return str(error.value)


def mesh(path):
    return ph.Body.from_mesh(*formats.read_mesh(path, 1.0), mass=1.0)


TETRAHEDRON = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n"


# ---------------------------------------------------------------- meshes


@pytest.mark.parametrize(("old", "new", "words"), [
    ("v 1 0 0", "v 1e300 0 0", "no body is that large"),
    ("v 1 0 0", "v 1e400 0 0", "line 2: a corner must be three finite numbers"),
    ("v 1 0 0", "v 1_0 0 0", "line 2: a corner must be three finite numbers"),
    ("v 1 0 0", "v 1 0", "line 2: a corner must be three finite numbers"),
    ("v 1 0 0", "v １ 0 0", "line 2: a corner must be three finite numbers"),
    ("f 2 3 4", "f 2 3 5", "a face has corner 5, and there are 4"),
    ("f 2 3 4", "f 2 3 99999999999", "a face has corner 99999999999"),
    ("f 2 3 4", "f 2 3 -5", "line 8: a face must be of corners that are there; got '-5' after 4"),
    ("f 2 3 4", "f 2 3 0", "line 8: a face must be of whole numbers"),
    ("f 2 3 4", "f 2 3 1e1", "line 8: a face must be of whole numbers"),
    ("f 2 3 4", "f 2 3", "line 8: a face must have three corners"),
    (TETRAHEDRON, "", "holds no triangles"),
    ("v 0 0 0", "v 0 0 0\0", "is not text"),
])  # fmt: skip
def test_obj(saved, old, new, words):
    assert old in TETRAHEDRON
    path = saved("mesh.obj", TETRAHEDRON.replace(old, new))
    with pytest.raises(FormatError, match=f"mesh.obj.*{words}"):
        mesh(path)


def test_obj_counts_backwards_from_the_last_corner_above(saved):
    """Relative corners count from the face; trimesh counts them from the end of the file."""
    relative = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -1 -2\nv 0 0 1\nf -4 -3 -1\nf 1/7 4//2 \\\n3/1/1\nf 2 3 4 # end\n"
    a, b = (formats.read_mesh(saved(name, text), 1.0) for name, text in (("a.obj", TETRAHEDRON), ("b.obj", relative)))
    assert np.array_equal(a[0], b[0]) and np.array_equal(a[1], b[1])


@pytest.mark.parametrize("library", ["/etc/passwd", "pipe", "../../secret", "http://localhost/m.mtl"])
def test_obj_opens_no_other_file(saved, library, monkeypatch):
    path = saved("mesh.obj", f"mtllib {library}\nusemtl a\n{TETRAHEDRON}")
    expected = formats.read_mesh(saved("plain.obj", TETRAHEDRON), 1.0)
    os.mkfifo(path.parent / "pipe")
    found = formats.read_mesh(path, 1.0)
    assert np.array_equal(found[0], expected[0]) and np.array_equal(found[1], expected[1])


def test_stl_that_claims_more_than_it_has(saved):
    for count in (2**32 - 1, 2, 0):
        path = saved("mesh.stl", bytes(80) + struct.pack("<I", count) + bytes(50))
        assert f"claims {count} triangles, and has bytes for 1" in refused(mesh, path)


FACET = "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n"
ASCII_STL = "solid a\n" + 4 * FACET


@pytest.mark.parametrize(("old", "new", "words"), [
    ("vertex 1 0 0", "vertex 1 0 x", "line 5: a corner must be three finite numbers in decimal digits; got '1 0 x'"),
    ("vertex 1 0 0", "vertex 1_0 0 0", "got '1_0 0 0'"),
    ("vertex 1 0 0", "vertex nan 0 0", "got 'nan 0 0'"),
    ("vertex 1 0 0", "vertex 1 0", "got '1 0'"),
    ("vertex 1 0 0", "vertex 1 0 0 0", "got '1 0 0 0'"),
    ("vertex 1 0 0\n", "", "three corners each"),
    ("1 0 0\nvertex 0 1 0\nendloop\nendfacet", "1 0 0\nendloop\nendfacet\nvertex 0 1 0", "three corners each"),
    ("solid a\n", "solid a\nendsolid a\nendfacet\n", "three corners each"),
])  # fmt: skip
def test_ascii_stl(saved, old, new, words):
    assert words in refused(mesh, saved("mesh.stl", ASCII_STL.replace(old, new, 1) + "endsolid a\n"))


def test_ascii_stl_without_its_end(saved):
    assert "no endsolid" in refused(mesh, saved("mesh.stl", ASCII_STL))


def test_ascii_stl_of_several_solids_in_any_spelling(saved):
    """Names may hold the words of the form, in any encoding."""
    text = f"SOLID a vertex of an endsolid\r\n{2 * FACET.upper()}EndSolid\nsolid Stück\n{2 * FACET}endsolid Stück\n"
    expected = formats.read_mesh(saved("plain.stl", f"{ASCII_STL}endsolid\n"), 1.0)
    for encoding in ("utf-8", "latin-1"):
        found = formats.read_mesh(saved("mesh.stl", text.encode(encoding)), 1.0)
        assert np.array_equal(found[0], expected[0]) and np.array_equal(found[1], expected[1])


def plain_table(path):
    return formats.read_columns(path, formats.ColumnMapping(1, time_unit="s", gyro=(2, 3, 4), unit="rad/s"))


def test_binary_garbage_as_text_is_refused_at_once(saved):
    """Its encoding would be guessed, for minutes."""
    noise = np.random.default_rng(0).integers(0, 256, 10**6, dtype=np.uint8).tobytes()
    for name, read in {"a.stl": mesh, "a.obj": mesh, "a.off": mesh, "a.ply": mesh, "a.glb": mesh,
                       "a.xyz": formats.read_molecule, "a.urdf": spacecraft.read_urdf_inertial,
                       "a.aem": spacecraft.read_aem, "a.csv": formats.read_csv,
                       "a.txt": plain_table}.items():  # fmt: skip
        refused(read, saved(name, noise))
        refused(read, saved(name, b"solid\n" + noise.replace(b"\0", b"\1")))


PLY = "ply\nformat {form} 1.0\nelement vertex {n}\nproperty float x\nproperty float y\nproperty float z\n"
PLY += "element face {m}\nproperty list uchar int vertex_indices\nend_header\n"


@pytest.mark.parametrize("count", ["1000000000000", "-1", "3_0", "１", "1e3", "99999999999999999999"])
@pytest.mark.parametrize("form", ["ascii", "binary_little_endian"])
def test_ply_that_claims_more_than_it_has(saved, count, form):
    for n, m in ((count, "1"), ("3", count)):
        path = saved("mesh.ply", PLY.format(form=form, n=n, m=m).encode() + b"0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n" * 3)
        assert "cannot be read as a mesh: it claims" in refused(mesh, path)


def test_off_that_claims_more_than_it_has(saved):
    for counts in ("1000000000000 4 0", "4 1000000000000 0", "400 4 0", "-4 4 0", "4"):
        path = saved("mesh.off", f"OFF\n{counts}\n0 0 0\n1 0 0\n0 1 0\n" + "\n" * 500)
        assert "cannot be read" in refused(mesh, path)


def scene(**changes):
    """A triangle as glTF 2.0."""
    corners = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0]], dtype="<f4").tobytes()
    uri = "data:application/octet-stream;base64," + base64.b64encode(corners).decode()
    return {
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}], "buffers": [{"byteLength": 36, "uri": uri}],
        "bufferViews": [{"buffer": 0, "byteLength": 36}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}],
    } | changes  # fmt: skip


LADDER = [{"children": [k + 1, k + 1]} for k in range(60)] + [{"mesh": 0}]


@pytest.mark.parametrize(("changes", "words"), [
    ({"accessors": [{"componentType": 5126, "count": 3, "type": "VEC3"}]}, "sparse"),
    ({"accessors": [{"bufferView": 0, "componentType": 5126, "count": 10**12, "type": "VEC3"}]}, "claims"),
    ({"buffers": [{"byteLength": 36, "uri": "/etc/passwd"}]}, "keeps its mesh in another file"),
    ({"buffers": [{"byteLength": 36, "uri": "http://localhost/a"}]}, "keeps its mesh in another file"),
    ({"extensionsUsed": ["KHR_draco_mesh_compression"]}, "is compressed"),
    ({"nodes": LADDER}, "in two places"),
    ({"nodes": [{"children": [0]}]}, "cannot be read|no triangles"),
    ({"nodes": [{"mesh": 7}]}, "not one of glTF"),
    ({"meshes": 3}, "not one of glTF"),
    ({"nodes": [{"mesh": 0}] * 20_000, "scenes": [{"nodes": list(range(20_000))}]}, "has 20000 parts"),
])  # fmt: skip
def test_gltf(saved, changes, words):
    text = json.dumps(scene(**changes)).encode()
    message = refused(mesh, saved("mesh.gltf", text))
    assert re.search(words, message), message


def test_gltf_in_one_file_is_read(saved):
    vertices, faces = formats.read_mesh(saved("mesh.gltf", json.dumps(scene())), 1.0)
    assert vertices.tolist() == [[0, 0, 0], [0, 1, 0], [1, 0, 0]] and faces.tolist() == [[0, 2, 1]]


LAUGHS = '<!DOCTYPE a [<!ENTITY a "aaaaaaaaaa">' + "".join(
    f'<!ENTITY {chr(98 + k)} "{f"&{chr(97 + k)};" * 10}">' for k in range(12)) + "]><a>&m;</a>"  # fmt: skip
"""Entities that expand to ten million million letters."""


@pytest.mark.parametrize("ending", ["zae", "3dxml", "xaml", "zip", "dxf", "svg"])
def test_what_unpacks_or_expands_is_refused_unread(saved, ending):
    assert "must end in one of stl, obj" in refused(mesh, saved(f"mesh.{ending}", LAUGHS))


@pytest.mark.parametrize(
    ("encoding", "words"), [("utf-8", "declares a document type"), ("utf-16", "must be written in UTF-8")]
)
def test_entities_of_dae_and_3mf_are_refused_unread(saved, encoding, words):
    for library in ("lxml", "networkx", "collada"):
        pytest.importorskip(library)
    model = LAUGHS.encode(encoding)
    archive = io.BytesIO()
    with zipfile.ZipFile(archive, "w") as file:
        file.writestr("3D/3dmodel.model", model)
    assert words in refused(mesh, saved("mesh.dae", model))
    assert words in refused(mesh, saved("mesh.3mf", archive.getvalue()))
    assert "no archive" in refused(mesh, saved("text.3mf", LAUGHS))


def test_repair_of_a_heap_of_corners(saved):
    """All pairs of thirty thousand corners within the merging distance would be ten gigabytes."""
    points = np.random.default_rng(0).uniform(size=(12_000, 3)) * 1e-3
    text = "".join(f"v {x:.7f} {y:.7f} {z:.7f}\n" for x, y, z in points) + "v 9999999 0 0\n"
    text += "".join(f"f {k} {k + 1} {k + 2}\n" for k in range(1, 12_000, 3))
    message = refused(lambda path: formats.read_mesh(path, 1.0, repair=True), saved("mesh.obj", text))
    assert "lie within 1e-6 of its extent of each other" in message


# ---------------------------------------------------------------- molecules


@pytest.mark.parametrize(("text", "words"), [
    ("999999999999\n\nH 0 0 0\n", "line 1: .*frame has 1 atoms, expected 999999999999"),
    ("99999999999\n\nH 0 0 0\n", "expected 99999999999"),
    ("2_0\n\nH 0 0 0\n", "must be the number of atoms; got '2_0'"),
    ("１\n\nH 0 0 0\n", "must be the number of atoms"),
    ("-1\n\nH 0 0 0\n", "must be the number of atoms"),
    ("1\n\nH 0 0 0\nrest\n", "line 4: .*must be the number of atoms; got 'rest'"),
    ("1\nProperties=species:S:1:pos:R:999999999\nH 0 0 0\n", "names more columns than a line holds"),
    ("1\n\nH 0 0 1_0\n", "'1_0' is not a number"), ("1\n\nH 0 0 nan\n", "'nan' is not a number"),
    ("1\n\nH 0 0 1e400\n", "'1e400' is not a number"), ("1\n\nH 0 0 １\n", "'１' is not a number"),
    ("1\n\nH 0 0 1e300\n", "atom 1 is not at a place within 1 m"),
    ("1\n\nH 0 0\n", "cannot be read"), ("1\n\n\0 0 0 0\n", "has a NUL byte in line 3"),
])  # fmt: skip
def test_xyz(saved, text, words):
    message = refused(formats.read_molecule, saved("molecule.xyz", text))
    assert re.search(words, message), message


@pytest.mark.parametrize("ending", ["json", "traj", "db", "gz", "xyz.gz", "py", "cif", "nonsense"])
def test_other_files_of_atoms_are_refused_unread(saved, ending):
    """ASE reads a hundred forms, some of which unpack, run or open others."""
    assert "must end in one of xyz" in refused(formats.read_molecule, saved(f"molecule.{ending}", "1\n\nH 0 0 0\n"))


@pytest.mark.parametrize("form", ["pdb", "mol", "sdf"])
def test_other_molecules_that_are_read(saved, form):
    texts = {
        "pdb": "TITLE     1_2\nATOM      1  O   HOH A   1       0.000   0.000   0.120  1.00  0.00           O\nEND\n",
        "mol": "name 1_2\n\n\n  1  0  0  0  0  0  0  0  0  0999 V2000\n"
               "    0.0000    0.0000    0.1200 O   0  0\nM  END\n",
    }
    symbols, positions, _ = formats.read_molecule(saved(f"molecule.{form}", texts.get(form, texts["mol"])))
    assert symbols == ["O"] and positions == pytest.approx(np.array([[0, 0, 1.2e-11]]), rel=1e-9)


def test_a_name_that_ase_takes_for_standard_input(saved, monkeypatch):
    path = saved("-", "1\n\nH 0 0 0\n")
    monkeypatch.chdir(path.parent)
    with pytest.raises(FormatError, match="must end in one of"):
        formats.read_molecule("-")


# ---------------------------------------------------------------- robots

ROBOT = (
    '<robot name="a"><link name="b"><inertial><mass value="2"/>'
    '<inertia ixx="1" ixy="0" ixz="0" iyy="2" iyz="0" izz="2.5"/></inertial></link></robot>'
)


@pytest.mark.parametrize("number", ["2_5", "１", "0x10", "1e400", "inf", "nan", "2.5f", "1e-400", "2,5", ""])
def test_urdf_numbers(saved, number):
    message = refused(spacecraft.read_urdf_inertial, saved("robot.urdf", ROBOT.replace('"2.5"', f'"{number}"')))
    said = "must be finite numbers in decimal digits" if number else "must be one number"
    assert f"izz of <inertia> {said}" in message


@pytest.mark.parametrize(("old", "new", "words"), [
    ("<robot", '<!DOCTYPE a [<!ENTITY x SYSTEM "file:///etc/passwd">]><robot', "declares a document type"),
    ("<robot", '<!DOCTYPE a SYSTEM "http://localhost/a.dtd"><robot', "declares a document type"),
    ('value="2"', 'value="1e308"', "robot.urdf"), ('ixx="1"', 'ixx="1e308"', "robot.urdf"),
    ("<robot", "<a>" * 100_000 + "<robot", "is not URDF"),
    ('name="b"', 'name="b' + "\u202e" * 2000 + '"', "robot.urdf"),
    ('izz="2.5"', 'izz="x"', "'b'"),
])  # fmt: skip
def test_urdf(saved, old, new, words):
    text = ROBOT.replace(old, new).replace('izz="2.5"', 'izz="25"')
    assert words in refused(spacecraft.read_urdf_inertial, saved("robot.urdf", text))


# ---------------------------------------------------------------- tables and messages

TABLE = "time [s],q_w,q_x,q_y,q_z,energy [J]\r\n0,1,0,0,0,5\r\n1,1,0,0,0,5\r\n"


@pytest.mark.parametrize(("old", "new", "words"), [
    ("0,5\r\n1", "0,5_0\r\n1", "line 2: '5_0' must be a number"),
    ("0,5\r\n1", "0,nan\r\n1", "line 2: 'nan' must be a number"),
    ("0,5\r\n1", "0,1e400\r\n1", "line 2: '1e400' is too large"),
    ("0,5\r\n1", "0,1e-400\r\n1", "line 2: '1e-400' is so small"),
    ("0,5\r\n1", "0,５\r\n1", "line 2: '５' must be a number"),
    ("0,5\r\n1", "0,0x10\r\n1", "line 2: '0x10' must be a number"),
    ("0,5\r\n1", "0,5\0\r\n1", r"line 2: '5\x00' must be a number"),
    ("0,5\r\n1", "0\r\n1", "line 2: must have 6 numbers"),
    ("0,5\r\n1", "0,5" + "0" * 10**6 + "\r\n1", "line 2: has more than 1000000 characters"),
    ("0,5\r\n1", "0,5" + "0" * 999_000 + "\r\n1", "line 2: '5000"),
    ("0,5\r\n1", "0,5\r\r\r\n1,1\r1", "line 5: must have 6 numbers"),
    ("q_z", "q_a", "has no column q_z"), ("energy [J]", "q_z", "each once"), ("energy [J]", "e\0", "printable"),
    ("q_z,energy [J]", "q_z,energy [J],energy [erg]", "'energy' is there twice"),
    ("0,1,0,0,0,5", "0,2,0,0,0,5", "the attitude of sample 0 is not a unit quaternion"),
])  # fmt: skip
def test_tables(saved, old, new, words):
    assert old in TABLE
    text = TABLE.replace(old, new).replace("0,0,0,5\r\n", "0,0,0,5,5\r\n" if "erg]" in new else "0,0,0,5\r\n")
    assert words in refused(formats.read_csv, saved("motion.csv", text))


def test_tables_of_other_line_ends(saved):
    expected = formats.read_csv(saved("motion.csv", TABLE))
    spaced = TABLE.partition("\r\n")
    spaced = spaced[0] + "\n" + spaced[2].replace(",", " , ")
    for text in (TABLE.replace("\r\n", "\n"), TABLE.replace("\r\n", "\r"), TABLE.rstrip(),
                 "\ufeff" + TABLE + "\r\n\r\n", TABLE.replace("5\r\n1", "5\n\n1"), spaced):  # fmt: skip
        found = formats.read_csv(saved("other.csv", text))
        assert np.array_equal(found.attitude, expected.attitude) and np.array_equal(found.times, expected.times)


AEM = """CCSDS_AEM_VERS = 2.0
CREATION_DATE = 2026-01-01T00:00:00
ORIGINATOR = A
META_START
OBJECT_NAME = BOX
OBJECT_ID = 2026-001A
REF_FRAME_A = EME2000
REF_FRAME_B = SC_BODY_1
TIME_SYSTEM = UTC
START_TIME = 2026-03-01T00:00:00
STOP_TIME = 2026-03-01T00:00:02
ATTITUDE_TYPE = QUATERNION/ANGVEL
ANGVEL_FRAME = SC_BODY_1
META_STOP
DATA_START
2026-03-01T00:00:00 0 0 0 1 1 2 3
2026-03-01T00:00:01 0 0 0 1 1 2 3
DATA_STOP
"""


@pytest.mark.parametrize(("old", "new", "words"), [
    ("0 0 0 1 1 2 3\nD", "0 0 0 1 1 2 3_0\nD", "line 17: number 7 of the 7"),
    ("0 0 0 1 1 2 3\nD", "0 0 0 1 1 2 ３\nD", "line 17: number 7 of the 7"),
    ("0 0 0 1 1 2 3\nD", "0 0 0 1 1 2 0x3\nD", "line 17: number 7 of the 7"),
    ("0 0 0 1 1 2 3\nD", "0 0 0 1e308 1 2 3\nD", "line 17: must be a quaternion of unit length"),
    ("0 0 0 1 1 2 3\nD", "0 0 0 1 1 2 3" + " " * 20_000 + "\nD", "line 17: has more than 16384 characters"),
    ("0 0 0 1 1 2 3\nD", "1 2 3\nD", "line 17: must be an epoch and 7 numbers"),
    ("= BOX", "= B\0X", "line 5: must be printable text"), ("= BOX", "= \x1b[31mX", "line 5: must be printable text"),
    ("= BOX", "= " + "B" * 10**6, "line 5: has more than"),
    ("00:00:01 0", "24:00:00 0", "no such time of day"), ("00:00:01 0", "00:00:60 0", "no such time of day"),
    ("2026-03-01T00:00:01", "2026-02-30T00:00:01", "no such day"),
    ("2026-03-01T00:00:01", "0001-01-01T00:00:00", "1972"),
    ("2026-03-01T00:00:01", "2026-000T00:00:00", "no such day"),
    ("2026-03-01T00:00:01", "2026-366T00:00:00", "no such day"),
    ("2026-03-01T00:00:01", "0000-01-01T00:00:00", "no such day"),
    ("2026-03-01T00:00:01", "٢٠٢٦-03-01T00:00:01", "epoch like"),
    ("2026-03-01T00:00:01 0", "2026-03-01T00:00:00 0", "line 17: epochs must ascend"),
    ("META_STOP\n", "META_STOP\nMETA_START\n", "DATA_START must follow META_STOP"),
    ("META_STOP\n", "OBJECT_NAME = A\nMETA_STOP\n", "OBJECT_NAME is there already"),
    ("DATA_STOP\n", "", "DATA_START has no DATA_STOP"), ("DATA_STOP", "DATA_STO", "has no DATA_STOP"),
    ("TIME_SYSTEM = UTC", "TIME_SYSTEM = MET", "TIME_SYSTEM must be one of"),
])  # fmt: skip
def test_messages(saved, old, new, words):
    assert AEM.count(old) == 1
    assert words in refused(spacecraft.read_aem, saved("motion.aem", AEM.replace(old, new)))


def test_messages_at_the_ends_of_the_calendar(saved):
    for year in ("0001", "9999"):
        text = AEM.replace("2026-03-01", f"{year}-12-31").replace("= UTC", "= TAI").replace("00:00:0", "23:59:5")
        found = spacecraft.read_aem(saved("motion.aem", text))
        assert found.times.tolist() == [0.0, 1.0] and found.source.labels.epoch.startswith(year)


def test_a_spin_too_fast_for_numbers(saved):
    text = AEM.replace("QUATERNION/ANGVEL", "SPIN/NUTATION").replace("0 0 0 1 1 2 3", "10 20 30 1 5 5e-324 3")
    text = text.replace("ANGVEL_FRAME = SC_BODY_1\n", "")
    assert "line 15: gives a rotation or a rate too large" in refused(spacecraft.read_aem, saved("motion.aem", text))


def test_text_in_utf_16(saved):
    for name, text, read in (("a.aem", AEM, spacecraft.read_aem), ("a.csv", TABLE, formats.read_csv)):
        for encoding in ("utf-16", "utf-16-le", "utf-32"):
            refused(read, saved(name, text.encode(encoding)))
