"""Attitudes in specs as Euler angles and as axis and angle, against SciPy's rotations."""

import numpy as np
import pytest
from pydantic import BaseModel, ValidationError
from scipy.spatial.transform import Rotation

from polhode.spec.fields import Attitude

ANGLES = (25.0, -70.0, 130.0)
SEQUENCES = ("ZXZ", "ZYX", "XYZ", "YXY", "zxz", "zyx", "xzy", "yxy")


class Table(BaseModel):
    attitude: Attitude


def matrix(value):
    w, x, y, z = Table(attitude=value).attitude
    return Rotation.from_quat([x, y, z, w]).as_matrix()


@pytest.mark.parametrize("sequence", SEQUENCES)
def test_euler_angles_are_those_of_scipy(sequence):
    found = matrix({"sequence": sequence, "angles": [f"{x} deg" for x in ANGLES]})
    assert np.abs(found - Rotation.from_euler(sequence, ANGLES, degrees=True).as_matrix()).max() < 1e-15


def test_capitals_turn_about_the_bodys_own_axes():
    """A quarter turn about z takes the body's x to y of space; the next, about the body's own x, turns about y then."""
    own = matrix({"sequence": "ZXZ", "angles": ["90 deg", "90 deg", "0 deg"]})
    assert own @ [0.0, 0.0, 1.0] == pytest.approx([1.0, 0.0, 0.0], abs=1e-15)
    space = matrix({"sequence": "zxz", "angles": ["90 deg", "90 deg", "0 deg"]})
    assert space @ [0.0, 0.0, 1.0] == pytest.approx([0.0, -1.0, 0.0], abs=1e-15)


@pytest.mark.parametrize("axis", [[0, 0, 1], [1, -2, 0.5], [1e-200, 1e-200, 0], [3e300, 0, 3e300]])
def test_axis_and_angle(axis):
    unit = np.array(axis) / np.abs(axis).max()
    wanted = Rotation.from_rotvec(np.radians(40.0) * unit / np.linalg.norm(unit)).as_matrix()
    assert np.abs(matrix({"axis": axis, "angle": "40 deg"}) - wanted).max() < 1e-15


@pytest.mark.parametrize("turns", [2, -3, 1000])
def test_whole_turns_change_nothing(turns):
    plain, more = (matrix({"axis": [1, 2, 2], "angle": f"{angle} deg"}) for angle in (40.0, 40.0 + 360.0 * turns))
    assert np.abs(plain - more).max() < 2e-12
    assert np.isfinite(matrix({"sequence": "ZXZ", "angles": ["1e160 deg", "1e300 rad", "-1e99 deg"]})).all()


@pytest.mark.parametrize(
    ("value", "words"),
    [
        ({"sequence": "ZXx", "angles": ["1 deg"] * 3}, "capitals"),
        ({"sequence": "ZZX", "angles": ["1 deg"] * 3}, "no two alike next to each other"),
        ({"sequence": "ZX", "angles": ["1 deg"] * 3}, "three of x, y, z"),
        ({"sequence": 3, "angles": ["1 deg"] * 3}, "three of x, y, z"),
        ({"sequence": "ZXZ", "angles": ["1 deg"] * 2}, "angles must be three"),
        ({"sequence": "ZXZ", "angles": [1, 2, 3]}, "unit in quotes"),
        ({"axis": [0, 0, 0], "angle": "1 deg"}, "not all zero"),
        ({"axis": [0, 0, 1], "angle": "1 m"}, "deg"),
        ({"axis": [0, 0, 1]}, "got a table with axis"),
        ({}, "got a table with nothing"),
        ([1, 0, 0], "quaternion"),
        ("ZXZ", "quaternion"),
    ],
)
def test_what_is_no_attitude_says_what_is(value, words):
    with pytest.raises(ValidationError, match=words):
        Table(attitude=value)
