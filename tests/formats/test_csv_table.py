"""CSV: read by Python's own reader, NumPy and us, bit for bit."""

import csv
from dataclasses import replace

import numpy as np
import pytest

import polhode as ph
from polhode import formats
from polhode.errors import FormatError, InvalidInput
from polhode.motion.frame import BodyFrame

MOTION = ph.FreeMotion((1.0, 2.0, 3.0), momentum=(0.3, 1.8, 1.5), attitude=(0.5, -0.5, 0.1, 0.7))
TIMES = np.linspace(0.0, 20.0, 101)


@pytest.fixture
def trajectory():
    return MOTION.sample(TIMES)


def test_pythons_own_reader_finds_the_numbers(tmp_path, trajectory):
    path = formats.write_csv(trajectory, tmp_path / "motion.csv")
    with path.open(newline="") as file:
        rows = list(csv.DictReader(file))
    assert [float(row["time [s]"]) for row in rows] == TIMES.tolist()
    for k, part in enumerate("wxyz"):
        assert [float(row[f"q_{part}"]) for row in rows] == trajectory.attitude[:, k].tolist()
    for k in range(3):
        assert [float(row[f"L_{k + 1} [kg m2 s-1]"]) for row in rows] == trajectory.momentum[:, k].tolist()
        assert [float(row[f"omega_{k + 1} [rad s-1]"]) for row in rows] == trajectory.angular_velocity[:, k].tolist()
    assert [float(row["energy [J]"]) for row in rows] == trajectory.invariants["energy"].tolist()
    raw = path.read_bytes()
    assert raw.count(b"\r\n") == raw.count(b"\n") == len(TIMES) + 1


def test_numpy_finds_the_numbers(tmp_path, trajectory):
    path = formats.write_csv(trajectory, tmp_path / "motion.csv")
    table = np.genfromtxt(path, delimiter=",", skip_header=1)
    assert np.array_equal(table[:, 1:5], trajectory.attitude)


def test_what_is_read_is_what_was_written(tmp_path, trajectory):
    found = formats.read_csv(formats.write_csv(trajectory, tmp_path / "motion.csv"))
    for name in ("times", "states", "attitude", "momentum", "angular_velocity"):
        assert np.array_equal(getattr(found, name), getattr(trajectory, name))
    assert np.array_equal(found.invariants["energy"], trajectory.invariants["energy"])


def test_along_the_given_axes(tmp_path, trajectory):
    frame = BodyFrame((1.0, 2.0, 3.0), np.eye(3)[[2, 0, 1]], np.zeros(3), None)
    found = formats.read_csv(formats.write_csv(replace(trajectory, frame=frame), tmp_path / "motion.csv"))
    assert np.array_equal(found.momentum, trajectory.momentum @ frame.axes.T)
    assert "L_x [kg m2 s-1]" in (tmp_path / "motion.csv").read_text()
    turned = ph.rotation.rotate(found.attitude, found.momentum)
    assert turned == pytest.approx(ph.rotation.rotate(trajectory.attitude, trajectory.momentum), abs=1e-14)


def test_what_has_no_attitude(tmp_path):
    algebra = ph.algebra.SO3()
    system = ph.systems.FreeRigidBody((1.0, 2.0, 3.0))
    trajectory = ph.simulate(system, np.array([0.3, 1.8, 1.5]), np.linspace(0.0, 1.0, 5))
    assert algebra is not None
    found = formats.read_csv(formats.write_csv(trajectory, tmp_path / "motion.csv"))
    assert np.array_equal(found.momentum, trajectory.momentum) and found.attitude is None


def test_empty_trajectories(tmp_path):
    empty = ph.FreeMotion((1.0, 2.0, 3.0), momentum=(0.3, 1.8, 1.5)).sample([0.0]).select(slice(0, 0))
    found = formats.read_csv(formats.write_csv(empty, tmp_path / "empty.csv"))
    assert found.times.shape == (0,) and found.attitude.shape == (0, 4)


def test_batches_and_places_that_cannot_be_written(tmp_path, trajectory):
    batch = ph.FreeMotion((1.0, 2.0, 3.0), momentum=np.ones((4, 1, 3))).sample(TIMES)
    with pytest.raises(InvalidInput, match="one body; got a batch of shape"):
        formats.write_csv(batch, tmp_path / "motion.csv")
    with pytest.raises(InvalidInput, match="cannot be written"):
        formats.write_csv(trajectory, "/proc/motion.csv")
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(("text", "words"), [
    ("", "line 1: must name the columns"),
    ("a,a\n1,2\n", "each once"),
    ("time,q_w\n1,2\n", 'must be named "time'),
    ("time [s],q_w\n1,2\n1\n", "line 3: must have 2 numbers"),
    ("time [s],q_w\n1,2\n1,x\n", "line 3: .x. must be a number"),
    ("time [s],q_w\n1,2,3\n", "line 2: must have 2 numbers"),
])  # fmt: skip
def test_tables_that_are_wrong(tmp_path, text, words):
    (tmp_path / "bad.csv").write_text(text)
    with pytest.raises(FormatError, match=words):
        formats.read_csv(tmp_path / "bad.csv")


def test_what_is_no_text(tmp_path):
    (tmp_path / "bad.csv").write_bytes(b"\xff\xfe\x00")
    with pytest.raises(FormatError, match="not UTF-8"):
        formats.read_csv(tmp_path / "bad.csv")


def test_the_further_parts_of_states_are_along_the_axes_of_the_table(tmp_path):
    body = ph.Body(2.0, (0.1, -0.2, 0.4), ((3.0, 0.2, -0.1), (0.2, 2.0, 0.3), (-0.1, 0.3, 1.5)))
    top = ph.systems.HeavyTop.from_body(body, (0.0, 0.0, 0.0))
    start = top.pack(angular_velocity=(1.0, 2.0, 3.0), attitude=(0.5, -0.5, 0.1, 0.7))
    trajectory = replace(ph.simulate(top, start, np.linspace(0.0, 2.0, 5)), frame=body.frame)
    path = formats.write_csv(trajectory, tmp_path / "top.csv")
    with path.open(newline="") as file:
        rows = list(csv.DictReader(file))
    attitude = np.array([[float(row[f"q_{part}"]) for part in "wxyz"] for row in rows])
    linear = np.array([[float(row[f"linear_{axis}"]) for axis in "xyz"] for row in rows])
    assert np.ptp(linear, axis=0).max() > 0.1
    in_space = ph.rotation.rotate(attitude, linear)  # a vector that is fixed there
    assert in_space == pytest.approx(np.broadcast_to(in_space[0], in_space.shape), abs=1e-12)
    assert in_space[0] / np.linalg.norm(in_space[0]) == pytest.approx([0.0, 0.0, 1.0], abs=1e-12)
