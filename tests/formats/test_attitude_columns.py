"""Rotation matrices, MRPs, three-component quaternions and raw counts in tables, against SciPy."""

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.spatial.transform import Rotation

from polhode import rotation
from polhode.errors import FormatError, InvalidInput
from polhode.formats import ColumnMapping, read_columns
from polhode.formats.attitude_columns import restore_scalars
from polhode.formats.rate_scale import read_scale

TIMES = np.linspace(0.0, 6.0, 601)
RATE = np.array([0.5, -1.2, 2.0])
TURNS = Rotation.from_rotvec([0.3, 0.2, -0.4]) * Rotation.from_rotvec(TIMES[:, None] * RATE)
"""Several whole turns at one rate along the body's axes."""
XYZ = ("x", "y", "z")


@pytest.fixture
def read(tmp_path):
    def read(names, columns, **words):
        path = tmp_path / "log.csv"
        rows = np.column_stack([TIMES[: len(columns)], columns])
        text = "".join(",".join(f"{x:.17g}" for x in row) + "\n" for row in rows)
        path.write_text(f"t,{','.join(names)}\n{text}")
        return read_columns(path, ColumnMapping("t", time_unit="s", **words))

    return read


def apart(found, turns):
    return rotation.angle_between(found.attitude, rotation.from_scipy(turns)).max()


@pytest.mark.parametrize("layout", ["R{0}{1}", "m[{0}][{1}]", "C_{0}_{1}", "dcm({0},{1})"])
@pytest.mark.parametrize("by_columns", [False, True])
def test_matrices_by_the_names_of_their_entries(read, layout, by_columns):
    matrices = TURNS.as_matrix()
    names = [layout.format(i, j).replace(",", "_") for i in (1, 2, 3) for j in (1, 2, 3)]
    if by_columns:
        names, matrices = [names[k] for k in (0, 3, 6, 1, 4, 7, 2, 5, 8)], np.swapaxes(matrices, 1, 2)
    words = {"matrix": list(range(2, 11)), "direction": "body-to-space"}
    found = read(names, matrices.reshape(-1, 9), **words)
    assert apart(found, TURNS) < 1e-14 and found.source.attributes["largest_deviation"] < 1e-14
    assert "R11 = column 2" in found.source.attributes["attitude"]


@pytest.mark.parametrize("backward", [False, True])
def test_the_direction_of_a_matrix_is_shown_by_rates(read, backward):
    matrices = (TURNS.inv() if backward else TURNS).as_matrix().reshape(-1, 9)
    names = [f"R{i}{j}" for i in "123" for j in "123"] + ["wx", "wy", "wz"]
    columns = np.column_stack([matrices, np.tile(RATE, (len(TIMES), 1))])
    words = {"matrix": names[:9], "gyro": names[9:], "unit": "rad/s"}
    found = read(names, columns, **words)
    assert apart(found, TURNS) < 1e-13 and "as the angular velocity shows" in found.source.attributes["attitude"]
    with pytest.raises(InvalidInput, match="Say it by `direction` body-to-space"):
        read(names, columns, matrix=names[:9])
    with pytest.raises(InvalidInput, match="the angular velocity does not show it"):
        read(names, columns * np.array([1.0] * 9 + [3.0, -2.0, 0.4]), **words)


def test_matrices_that_are_none(read):
    names = [f"R{i}{j}" for i in "123" for j in "123"]
    words = {"matrix": names, "direction": "body-to-space"}
    matrices = TURNS.as_matrix()
    rounded = read(names, matrices.round(5).reshape(-1, 9), **words)
    assert apart(rounded, TURNS) < 1e-5 and 1e-6 < rounded.source.attributes["largest_deviation"] < 3e-5
    assert rounded.source.attributes["deviation_from"] == "RᵀR"
    wrong = matrices.copy()
    wrong[7] *= 1.01
    with pytest.raises(FormatError, match=r"line 9: a rotation matrix must be orthogonal, .* misses by 0\.0201"):
        read(names, wrong.reshape(-1, 9), **words)
    with pytest.raises(FormatError, match="line 2: the matrix is a reflection"):
        read(names, (matrices * [1.0, 1.0, -1.0]).reshape(-1, 9), **words)


def test_modified_rodrigues_parameters_with_their_shadow(read):
    """SciPy's MRPs stay within 1; those of an integrator that does not switch do not, and mean the same."""
    inside = TURNS.as_mrp()
    square = np.sum(inside**2, axis=1, keepdims=True)
    some = square[:, 0] > 0.3
    outside = np.where(some[:, None], -inside / square, inside)
    assert np.linalg.norm(outside, axis=1).max() > 1.5
    for parameters in (inside, outside):
        assert apart(read(XYZ, parameters, mrp=XYZ), TURNS) < 1e-14
    assert apart(read(XYZ, inside, mrp=XYZ, direction="space-to-body"), TURNS.inv()) < 1e-14


@pytest.mark.parametrize("kept", ["continuous", "positive"])
def test_scalars_from_the_norm(read, kept):
    """Of a program whose quaternions are continuous, and of one that keeps scalars positive and flips vectors."""
    quaternions = TURNS.as_quat()
    if kept == "continuous":
        steps = np.sum(quaternions[1:] * quaternions[:-1], axis=1)
        quaternions[1:] *= np.cumprod(np.sign(steps))[:, None]
        quaternions *= np.sign(quaternions[0, 3])
    else:
        quaternions *= np.sign(quaternions[:, 3:])
    assert kept == "positive" or quaternions[:, 3].min() < -0.9
    found = read(XYZ, quaternions[:, :3], quat=XYZ)
    assert apart(found, TURNS) < 2e-6  # rounding of w = √(1 − v²) where w vanishes
    rounded = read(XYZ, quaternions[:, :3].round(7), quat=XYZ)
    assert apart(rounded, TURNS) < 3e-3
    assert "scalar by continuity" in found.source.attributes["attitude"]


def test_a_scalar_that_touches_zero_is_followed_through():
    angles = np.linspace(0.0, 4 * np.pi, 500)
    vectors = np.sin(angles / 2)[:, None] * np.array([[0.6, 0.0, 0.8]])
    assert restore_scalars(vectors)[:, 0] == pytest.approx(np.cos(angles / 2), abs=1e-7)


@pytest.mark.parametrize("kept", ["continuous", "positive"])
def test_turns_of_twenty_degrees_a_sample_are_followed(kept):
    """A tumbling body by Euler's equations: a straight line in the quaternion missed one sample by 0.012 rad."""
    moments = np.array([2.0, 2.5, 3.0])

    def rates(t, y):
        q, w = y[:4], y[4:]
        turning = 0.5 * np.array([-q[1:] @ w, *(q[0] * w + np.cross(q[1:], w))])
        return np.append(turning, np.cross(moments * w, w) / moments)

    times = np.arange(0.0, 60.1, 0.5)
    found = solve_ivp(rates, (0.0, 60.0), [1, 0, 0, 0, 0.3, 0.1, 0.6], "DOP853", rtol=1e-13, atol=1e-14, t_eval=times)
    q = found.y[:4].T / np.linalg.norm(found.y[:4], axis=0)[:, None]
    vectors = q[:, 1:] if kept == "continuous" else q[:, 1:] * np.sign(q[:, :1])
    assert np.abs(np.sum(restore_scalars(vectors) * q, axis=1)).min() > 1.0 - 1e-12


def test_vectors_that_are_too_long(read):
    with pytest.raises(FormatError, match=r"line 3: the vector part .* got 1\.2 .*`mrp`"):
        read(XYZ, [[0.5, 0, 0], [0, 1.2, 0]], quat=XYZ)


@pytest.mark.parametrize(("names", "quat", "why"), [
    ("qw qx qy qz", "qw,qx,qy", "their names end in w, x, y"),
    ("qx qy qz qw", "qy,qz,qw", "their names end in y, z, w"),
    ("x z y s", "x,z,y", "their names end in x, z, y"),
    ("q.s q.x q.y q.z", "2,3,4", "their names end in s, x, y"),
    ("q0 q1 q2 q3", "q0,q1,q2", "the table has a fourth of them, q3"),
    ("q[0] q[1] q[2] q[3]", "2,3,4", "the table has a fourth of them, q[3]"),
    ("q1 q2 q3 q4", "q1,q2,q3", "the table has a fourth of them, q4"),
    ("q1 q2 q3 q4", "q1,q3,q4", "their names end in 1, 3, 4"),
])  # fmt: skip
def test_three_columns_that_are_named_otherwise_are_no_vector_part(read, names, quat, why):
    with pytest.raises(InvalidInput) as caught:
        read(names.split(), TURNS.as_quat(), quat=quat)
    assert len(caught.value.args) == 1 and "which are its vector part x, y, z, and " + why in str(caught.value)
    assert "Give four, w, x, y, z, or the vector part alone." in str(caught.value)


@pytest.mark.parametrize(("names", "quat"), [
    ("qx qy qz qw", "qx,qy,qz"), ("q1 q2 q3 other", "q1,q2,q3"), ("q1 q2 q3 q0", "q1,q2,q3"),
    ("q2 q3 q4 q1", "q2,q3,q4"), ("q[0] q[1] q[2] w", "2,3,4"), ("a b c d", "a,b,c"), ("c2 c3 c4 c5", "c2,c3,c4"),
])  # fmt: skip
def test_three_columns_that_may_be_the_vector_part(read, names, quat):
    assert apart(read(names.split(), TURNS[:20].as_quat(), quat=quat), TURNS[:20]) < 1e-7


@pytest.mark.parametrize(("scale", "degrees"), [
    ("131 LSB/(deg/s)", 1 / 131), ("16.4 LSB/dps", 1 / 16.4), ("8.75 mdps/LSB", 8.75e-3), ("0.07 dps/digit", 0.07),
    ("131 counts per deg/s", 1 / 131), ("0.00762939453125 deg/s per count", 250 / 32768),
])  # fmt: skip
def test_raw_counts_with_the_scale_of_a_data_sheet(read, scale, degrees):
    """MPU-6050 (131, 16.4), L3GD20 (8.75, 70 mdps), and a range of ±250 deg/s in sixteen bits."""
    found = read(XYZ, [[2252, 6755, 3753], [-2, 1, 0]], gyro=XYZ, scale=scale)
    assert found.angular_velocity[0] == pytest.approx(np.radians([2252, 6755, 3753]) * degrees, rel=1e-14)
    assert f"counts at {scale}" in found.source.attributes["angular_velocity"]


@pytest.mark.parametrize("scale", ["131", "131 LSB", "0 LSB/dps", "x LSB/dps", "131 LSB/Hz", "1e40 LSB/dps"])
def test_scales_that_are_none(scale):
    with pytest.raises(ValueError, match="131 LSB"):
        read_scale(scale)
    with pytest.raises(InvalidInput, match="scale must be counts a rate"):
        ColumnMapping("t", time_unit="s", gyro=(2, 3, 4), scale=scale)


def test_counts_are_never_taken_for_rates(read):
    with pytest.raises(InvalidInput, match="or of raw counts by `scale`"):
        read(XYZ, [[2252, 6755, 3753], [1, 2, 3]], gyro=XYZ)
    with pytest.raises(InvalidInput, match="Leave one out"):
        ColumnMapping("t", gyro=XYZ, scale="131 LSB/dps", unit="deg/s")
    with pytest.raises(InvalidInput, match="gyro is not given"):
        ColumnMapping("t", mrp=XYZ, scale="131 LSB/dps")
