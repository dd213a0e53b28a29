"""Animations taken apart by hand, by Khronos' validator and by other readers, against the motion itself."""

import json
import os
import shutil
import struct
import subprocess
from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np
import pytest
import trimesh
from pygltflib import GLTF2
from scipy.spatial.transform import Rotation, Slerp

import polhode as ph
from polhode.bodies.surface import Surface, cuboid
from polhode.errors import InvalidInput
from polhode.formats.gltf import write_gltf
from polhode.formats.labels import AttitudeLabels
from polhode.motion._trajectory import Trajectory
from polhode.motion.frame import BodyFrame

SINGLE = 2.0**-23
"""rad: rounding the four components to single precision moves a unit quaternion by half of this at most."""
EXACT = 1e-13
CLOSE = 3e-7
"""Positions in single precision, after a turn or two, relative to the largest."""
HERE = Path(__file__).parent / "gltf_validator"
EXAMPLES = Path(__file__).parents[2] / "examples"
BODY = ph.shapes.box(2.0, (0.1, 0.2, 0.3)).placed((0.8, 0.2, -0.4, 0.4), (5.0, -7.0, 11.0))
FRAME = BODY.frame
MOTION = ph.FreeMotion(BODY.principal_moments, momentum=(0.002, 0.07, 0.003), attitude=(0.5, -0.5, 0.5, 0.5))
TIMES = np.linspace(0.0, 8.0, 500)


def taken_apart(path):
    """Return the document and a function from an accessor's index to its numbers."""
    raw = path.read_bytes()
    magic, version, length = struct.unpack("<4sII", raw[:12])
    assert (magic, version, length) == (b"glTF", 2, len(raw))
    size, kind = struct.unpack("<I4s", raw[12:20])
    assert kind == b"JSON" and size % 4 == 0
    document = json.loads(raw[20 : 20 + size])
    blob_size, kind = struct.unpack("<I4s", raw[20 + size : 28 + size])
    blob = raw[28 + size :]
    assert kind == b"BIN\0" and blob_size == len(blob) == document["buffers"][0]["byteLength"]

    def numbers(index):
        accessor = document["accessors"][index]
        view = document["bufferViews"][accessor["bufferView"]]
        width = {"SCALAR": 1, "VEC3": 3, "VEC4": 4}[accessor["type"]]
        found = np.frombuffer(blob, "<f4", accessor["count"] * width, view["byteOffset"]).reshape(-1, width)
        if "min" in accessor:
            assert found.min(axis=0).tolist() == accessor["min"] and found.max(axis=0).tolist() == accessor["max"]
        return found.astype(float)

    return document, numbers


def tracks(path):
    """Return clock (K,) and what leads each node, by name and kind."""
    document, numbers = taken_apart(path)
    animation = document["animations"][0]
    found = {}
    for channel in animation["channels"]:
        sampler = animation["samplers"][channel["sampler"]]
        assert sampler["interpolation"] == "LINEAR"
        target = channel["target"]
        found[document["nodes"][target["node"]]["name"], target["path"]] = numbers(sampler["output"])
        clock = numbers(sampler["input"])[:, 0]
    return clock, found


def triangles(path, name):
    document, numbers = taken_apart(path)
    node = next(node for node in document["nodes"] if node["name"] == name)
    primitive = document["meshes"][node["mesh"]]["primitives"][0]
    corners, normals = (numbers(primitive["attributes"][key]).reshape(-1, 3, 3) for key in ("POSITION", "NORMAL"))
    return corners, normals


def node(path, name):
    return next(node for node in taken_apart(path)[0]["nodes"] if node["name"] == name)


def written(tmp_path, trajectory=None, frame=None, **options):
    trajectory = replace(MOTION.sample(TIMES) if trajectory is None else trajectory, frame=frame)
    return write_gltf(trajectory, tmp_path / "motion.glb", **options)


def check_keys(path, motion, axes, speed=1.0, start=0.0, name="BODY"):
    """The file's rotations are those of the given axes at the file's own times."""
    clock, found = tracks(path)
    keys = Rotation.from_quat(found[name, "rotation"])
    wanted = ph.rotation.as_scipy(motion.attitude(start + speed * clock)) * Rotation.from_matrix(axes).inv()
    assert (keys * wanted.inv()).magnitude().max() <= SINGLE
    return clock, found[name, "rotation"]


@pytest.mark.long
def test_attitudes_at_the_keys_are_exact_to_single_precision(tmp_path):
    clock, keys = check_keys(written(tmp_path, frame=FRAME), MOTION, BODY.principal_axes)
    assert clock == pytest.approx(TIMES, rel=SINGLE) and clock[0] == 0.0
    assert (np.einsum("ki,ki->k", keys[1:], keys[:-1]) > 0.9).all()
    # half-way between keys, as a viewer interpolates
    between = 0.5 * (clock[1:] + clock[:-1])
    shown = Slerp(clock, Rotation.from_quat(keys))(between)
    wanted = ph.rotation.as_scipy(MOTION.attitude(between)) * Rotation.from_matrix(BODY.principal_axes).inv()
    # the rate changes on the way: by ½ Ω̇ (Δt/2)² it goes ahead or lags
    change = np.linalg.norm(np.gradient(MOTION.angular_velocity(clock), clock, axis=0), axis=1).max()
    assert (shown * wanted.inv()).magnitude().max() <= 1.1 * change * (TIMES[1] / 2) ** 2 / 2


def test_the_bound_would_notice_a_swapped_component(tmp_path):
    path = written(tmp_path, frame=FRAME)
    with pytest.raises(AssertionError):
        check_keys(path, MOTION, np.eye(3))


def test_a_quaternion_that_changes_sign_is_made_continuous(tmp_path):
    trajectory = MOTION.sample(TIMES)
    flipped = np.where(np.arange(len(TIMES))[:, None] % 3 == 0, -1.0, 1.0) * trajectory.attitude
    samples = replace(trajectory, source=None, attitude=flipped)
    _, found = tracks(written(tmp_path, samples, frame=FRAME))
    keys = found["BODY", "rotation"]
    assert (np.einsum("ki,ki->k", keys[1:], keys[:-1]) > 0.9).all()


def test_samples_keep_their_attitudes_and_their_times_rounded(tmp_path):
    samples = replace(MOTION.sample(TIMES), source=None)
    clock, found = tracks(written(tmp_path, samples, frame=FRAME))
    assert np.array_equal(clock, TIMES.astype(np.float32).astype(float))
    wanted = ph.rotation.as_scipy(replace(samples, frame=FRAME).along("given").attitude)
    assert (Rotation.from_quat(found["BODY", "rotation"]) * wanted.inv()).magnitude().max() <= SINGLE


def test_a_trajectory_turned_to_the_given_axes_is_evaluated_along_these(tmp_path):
    principal = replace(MOTION.sample(TIMES), frame=FRAME)
    clock, found = tracks(written(tmp_path, principal.along("given")))
    turned = ph.rotation.multiply(MOTION.attitude(clock), ph.rotation.conjugate(ph.rotation.from_matrix(FRAME.axes)))
    wanted = ph.rotation.as_scipy(turned)
    assert (Rotation.from_quat(found["BODY", "rotation"]) * wanted.inv()).magnitude().max() <= SINGLE
    assert len(clock) == len(TIMES)


def test_the_mesh_is_the_body_about_its_centre(tmp_path):
    surface = Surface(cuboid((0.1, 0.2, 0.3)).vertices + [1.0, 2.0, 3.0], cuboid((1, 1, 1)).faces)  # noqa: RUF005
    body = ph.Body.from_mesh(*surface, mass=2.0)
    motion = ph.FreeMotion(body.principal_moments, momentum=(0.002, 0.07, 0.003))
    path = written(tmp_path, motion.sample(TIMES), frame=body.frame, surface=surface)
    corners, normals = triangles(path, "BODY")
    wanted = surface.vertices[surface.faces] - body.center_of_mass
    assert np.abs(corners - wanted).max() <= CLOSE
    facing = np.cross(wanted[:, 1] - wanted[:, 0], wanted[:, 2] - wanted[:, 0])
    facing /= np.linalg.norm(facing, axis=1, keepdims=True)
    assert np.abs(normals - facing[:, None]).max() <= SINGLE


def test_without_a_surface_the_box_of_the_same_inertia(tmp_path):
    corners, _ = triangles(written(tmp_path, frame=FRAME), "BODY")
    corners = np.unique(corners.reshape(-1, 3), axis=0)
    mesh = ph.Body.from_mesh(*cuboid((0.1, 0.2, 0.3)), mass=2.0)
    assert len(corners) == 8
    found = (corners - corners.mean(axis=0)).T @ (corners - corners.mean(axis=0))
    # of the eight corners ∑ r rᵀ is 2 edge², of the box ∫ r rᵀ dm is m edge²/12
    second = 0.5 * np.trace(BODY.inertia) * np.eye(3) - BODY.inertia
    assert found / 8 == pytest.approx(second / 2.0 * 3.0, abs=CLOSE) and mesh.mass == BODY.mass


def test_another_reader_finds_the_mesh_upright(tmp_path):
    """trimesh applies the nodes: at rest along space axes, z is up, which is y there."""
    body = ph.shapes.cone(1.0, 0.2, 0.4)
    surface = cuboid((0.1, 0.2, 0.6))
    still = Trajectory(np.array([0.0]), np.zeros((1, 3)), attitude=np.array([[1.0, 0.0, 0.0, 0.0]]))
    path = written(tmp_path, still, frame=body.frame, surface=surface)
    scene = trimesh.load(path)
    transform, geometry = scene.graph["BODY"]
    mesh = scene.geometry[geometry].copy().apply_transform(transform)
    assert mesh.extents == pytest.approx([0.1, 0.6, 0.2], rel=1e-6)
    assert mesh.volume == pytest.approx(0.012, rel=1e-6)  # positive: turned outward


def test_pygltflib_reads_it(tmp_path):
    found = GLTF2().load(str(written(tmp_path, frame=FRAME)))
    assert found.asset.version == "2.0" and len(found.animations) == 1
    assert all(node.matrix is None for node in found.nodes)
    targets = {found.nodes[channel.target.node].name for channel in found.animations[0].channels}
    assert targets == {"BODY"}  # the momentum of a free body stands still


def validator():
    for folder in (os.environ.get("GLTF_VALIDATOR"), HERE):
        if folder and shutil.which("node") and (Path(folder) / "node_modules" / "gltf-validator").is_dir():
            return folder
    return None


@pytest.mark.skipif(validator() is None, reason="needs node, and `npm install` in tests/formats/gltf_validator")
@pytest.mark.parametrize("case", ["box", "top", "rolling disk", "arrows alone", "one key", "molecule"])
def test_khronos_validator_finds_nothing(tmp_path, case):
    path = written(tmp_path, **CASES[case]())
    run = subprocess.run(["node", HERE / "validate.cjs", validator(), path], capture_output=True, text=True, check=True)
    assert json.loads(run.stdout)["issues"]["messages"] == []


def top():
    body = ph.shapes.cone(0.06, 0.03, 0.04).placed(translation=(0.0, 0.0, 0.01))
    moments = np.diag(body.about((0.0, 0.0, 0.0)))
    motion = ph.LagrangeMotion(
        moments, mgl=0.06 * 9.81 * 0.01, momentum=(0.0, 0.0, 3e-3), attitude=(np.cos(0.2), np.sin(0.2), 0.0, 0.0)
    )
    frame = BodyFrame(moments, np.eye(3), body.center_of_mass, body.mass, np.zeros(3))
    return motion, frame


def top_case():
    motion, frame = top()
    return {"trajectory": motion.sample(np.linspace(0.0, 2.0, 400)), "frame": frame}


@cache
def disk_case():
    from polhode.bodies._turned import tube
    from polhode.rolling.euler_disk.system import EulerDisk

    disk = EulerDisk(mass=0.4, radius=0.04, thickness=0.01)
    # some path of tilt, heading, spin and contact; that no disk rolls so is nothing to a picture
    times = np.linspace(0.0, 1.0, 200)
    tilt, heading, spin = 0.5 + 0.3 * np.sin(5.0 * times), 7.0 * times + 0.3, -4.0 * times**2
    states = np.column_stack([tilt, heading, heading + spin, 0.1 * times, -0.2 * times, np.zeros((200, 3))])
    turns = Rotation.from_euler("ZXZ", np.column_stack([heading, tilt, spin]))
    trajectory = Trajectory(times, states, disk.layout(states), source=disk, attitude=ph.rotation.from_scipy(turns))
    A, C = (float(x) for x in (disk.mechanics.diametral_moment, disk.mechanics.axial_moment))
    return {"trajectory": trajectory, "surface": tube(0.04, 0.01),
            "frame": BodyFrame(np.array([A, A, C]), np.eye(3), np.zeros(3), 0.4)}  # fmt: skip


def molecule_case():
    places = [[0, 0, 0], [7.6e-11, 5.9e-11, 0], [-7.6e-11, 5.9e-11, 0]]
    body = ph.Body.from_points(np.array([16, 1, 1]) * 1.66e-27, places)
    rates = np.array([1e11, 2e12, 3e11])
    motion = ph.FreeMotion(body.principal_moments, momentum=body.principal_moments * rates)
    return {"trajectory": motion.sample(np.linspace(0.0, 2e-11, 400)), "frame": body.frame}


CASES = {
    "box": lambda: {"frame": FRAME},
    "top": top_case,
    "rolling disk": disk_case,
    "arrows alone": dict,
    "one key": lambda: {"trajectory": MOTION.sample(np.array([3.0])), "frame": FRAME},
    "molecule": molecule_case,
}


def test_a_top_turns_about_its_pivot(tmp_path):
    case = top_case()
    surface = Surface(np.array([[0.0, 0.0, 0.0], [0.03, 0.0, 0.05], [0.0, 0.03, 0.05]]), np.array([[0, 1, 2]]))
    path = written(tmp_path, **case, surface=surface)
    corners, _ = triangles(path, "BODY")
    assert np.abs(corners[0] - surface.vertices).max() <= CLOSE * 0.05
    check_keys(path, top()[0], np.eye(3))
    clock, found = tracks(path)
    assert ("place", "translation") not in found
    # here the momentum moves: its arrow is along R L in space
    toward = Rotation.from_quat(found["angular momentum", "rotation"]).apply([0.0, 0.0, 1.0])
    motion = top()[0]
    momentum = ph.rotation.rotate(motion.attitude(clock), motion.momentum(clock))
    assert np.abs(toward - momentum / np.linalg.norm(momentum, axis=1, keepdims=True)).max() <= CLOSE


def test_a_free_body_s_momentum_stands_still(tmp_path):
    path = written(tmp_path, frame=FRAME)
    momentum = ph.rotation.rotate(MOTION.attitude(0.0), MOTION.momentum(0.0))
    toward = Rotation.from_quat(node(path, "angular momentum")["rotation"]).apply([0.0, 0.0, 1.0])
    assert toward == pytest.approx(momentum / np.linalg.norm(momentum), abs=EXACT)
    axes = Rotation.from_quat(node(path, "principal axes")["rotation"]).as_matrix()
    assert axes == pytest.approx(BODY.principal_axes, abs=EXACT)


def test_momentum_straight_down(tmp_path):
    motion = ph.FreeMotion((1.0, 2.0, 2.5), momentum=(0.0, 0.0, -1.0))
    path = written(tmp_path, motion.sample(TIMES))
    assert Rotation.from_quat(node(path, "angular momentum")["rotation"]).apply([0, 0, 1]) == pytest.approx([0, 0, -1])


@pytest.mark.long
def test_a_body_at_rest_has_no_momentum_to_show(tmp_path):
    path = written(tmp_path, ph.FreeMotion((1.0, 2.0, 2.5), momentum=(0.0, 0.0, 0.0)).sample(TIMES))
    assert not [node for node in taken_apart(path)[0]["nodes"] if node["name"] == "angular momentum"]


def test_a_rolling_disk_touches_the_plane(tmp_path):
    case = disk_case()
    path = written(tmp_path, **case)
    corners, _ = triangles(path, "BODY")
    points = np.unique(corners.reshape(-1, 3), axis=0)
    _, found = tracks(path)
    place, turn = found["place", "translation"], Rotation.from_quat(found["BODY", "rotation"]).as_matrix()
    assert np.ptp(place[:, 1]) > 0.1  # it does go somewhere
    heights = np.einsum("kj,nj->kn", turn[:, 2], points) + place[:, 2:]
    lowest = heights.min(axis=1)
    # the drawn disk's edge has 64 corners, which lie lowest by turns
    assert lowest.min() >= -CLOSE * 0.04 and lowest.max() <= 0.04 * (1.0 - np.cos(np.pi / 64)) + CLOSE


def test_an_exact_motion_sampled_too_coarsely_is_evaluated_anew(tmp_path):
    coarse = MOTION.sample(np.linspace(0.0, 8.0, 5))
    clock, _ = check_keys(written(tmp_path, coarse, frame=FRAME), MOTION, BODY.principal_axes)
    fastest = np.linalg.norm(np.asarray(MOTION.angular_velocity(clock)), axis=1).max()
    assert fastest * np.diff(clock).max() <= 1.1 * np.pi / 16.0
    with pytest.raises(InvalidInput, match=r"too far apart.*rad from one to the next"):
        written(tmp_path, replace(coarse, source=None), frame=FRAME)
    with pytest.raises(InvalidInput, match="too far apart"):
        written(tmp_path, replace(coarse, source=None, angular_velocity=None), frame=FRAME)


def test_rate_and_speed(tmp_path):
    path = written(tmp_path, frame=FRAME, rate=60.0, speed=0.5)
    clock, _ = check_keys(path, MOTION, BODY.principal_axes, speed=0.5)
    assert len(clock) == 961 and clock[-1] == 16.0
    extras = taken_apart(path)[0]["asset"]["extras"]
    assert extras == {"seconds_per_second": 0.5, "metres_per_unit": 1.0, "seconds_at_start": TIMES[0]}
    later = written(tmp_path, MOTION.sample(TIMES + 1e6), frame=FRAME)
    check_keys(later, MOTION, BODY.principal_axes, start=1e6)
    assert taken_apart(later)[0]["asset"]["extras"]["seconds_at_start"] == TIMES[0] + 1e6


def test_a_molecule_is_shown_large_and_slow_and_a_planet_small_and_fast(tmp_path):
    case = molecule_case()
    path = written(tmp_path, **case)
    extras = taken_apart(path)[0]["asset"]["extras"]
    assert extras.pop("seconds_at_start") == 0.0
    assert extras == {"seconds_per_second": pytest.approx(1e-12), "metres_per_unit": pytest.approx(1e-10, rel=2.0)}
    assert 0.5 <= np.abs(triangles(path, "BODY")[0]).max() <= 10.0
    clock, _ = check_keys(path, case["trajectory"].source, case["frame"].axes, speed=extras["seconds_per_second"])
    assert clock[-1] == pytest.approx(20.0)
    planet = ph.FreeMotion((8.01e37, 8.01e37, 8.04e37), momentum=(0.0, 1e32, 5.8e33))
    path = written(tmp_path, planet.sample(np.linspace(0.0, 5e6, 2000)))
    assert taken_apart(path)[0]["asset"]["extras"]["seconds_per_second"] == 1e5
    assert tracks(path)[0][-1] == 50.0


def test_samples_that_single_precision_cannot_tell_apart_are_one_key(tmp_path):
    apart = TIMES.astype(np.float32).astype(float)
    times = np.sort(np.concatenate([apart, apart[1:] + 1e-10]))
    clock, _ = tracks(written(tmp_path, replace(MOTION.sample(times), source=None), frame=FRAME))
    assert len(clock) == len(TIMES) and (np.diff(clock) > 0).all()


@pytest.mark.parametrize("name", ["</script><!--", 'quote " back \\ slash', "line\nbreak\0", "Трёхосный 陀螺 🪀"])
def test_any_name(tmp_path, name):
    document, _ = taken_apart(written(tmp_path, labels=AttitudeLabels(object_name=name)))
    assert document["nodes"][2]["name"] == name


def test_a_flat_surface_and_triangles_without_area(tmp_path):
    corners = np.array([[0.0, 0, 0], [1, 0, 0], [0, 1, 0], [2, 0, 0]])
    sliver = Surface(corners, np.array([[0, 1, 2], [0, 1, 3], [1, 1, 2]]))
    assert len(triangles(written(tmp_path, surface=sliver), "BODY")[0]) == 1
    nothing = Surface(np.zeros((3, 3)), np.array([[0, 1, 2]]))
    assert "mesh" not in node(written(tmp_path, surface=nothing), "BODY")


@pytest.mark.usefixtures("any_type")
def test_what_cannot_be_shown(tmp_path):
    batch = ph.FreeMotion((1.0, 2.0, 2.5), momentum=np.ones((2, 1, 3))).sample(TIMES)
    good = MOTION.sample(TIMES)
    bad = np.array(good.attitude)
    bad[3] = np.nan
    cases = {
        "this motion has none": replace(good, attitude=None),
        "holds one body": batch,
        "needs at least one sample": replace(good, times=TIMES[:0], attitude=bad[:0]),
        "not all of these are": replace(good, attitude=bad),
        "times that increase": replace(good, times=TIMES[::-1]),
    }
    for words, trajectory in cases.items():
        with pytest.raises(InvalidInput, match=words):
            written(tmp_path, trajectory)
    for options, words in (({"rate": -1.0}, "`rate` must be positive"), ({"speed": np.inf}, "`speed` must be"),
                           ({"rate": 1e6}, "is more than the 1000000 that viewers bear")):  # fmt: skip
        with pytest.raises(InvalidInput, match=words):
            written(tmp_path, **options)
    with pytest.raises(InvalidInput, match="`rate` is for exact motions"):
        written(tmp_path, replace(good, source=None), rate=10.0)
    assert not list(tmp_path.iterdir())


def test_places_where_no_file_can_be(tmp_path):
    with pytest.raises(InvalidInput, match="is a folder, where a file has to go"):
        write_gltf(MOTION.sample(TIMES), tmp_path)
    with pytest.raises(InvalidInput, match="is not a folder"):
        write_gltf(MOTION.sample(TIMES), tmp_path / "none" / "motion.glb")
