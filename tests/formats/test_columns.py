"""Tables of other tools by a mapping of their columns, against SciPy and numbers written out by hand."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from polhode import rotation
from polhode.errors import FormatError, InvalidInput
from polhode.formats import ColumnMapping, read_columns, read_dataset, write_dataset
from polhode.formats.plain_table import BLOCK

TURNS = Rotation.from_rotvec([[0.1, 0.2, 0.3], [0.5, -0.2, 0.4], [-0.3, 0.9, 0.1]])
XYZW = TURNS.as_quat()
RATES = "t,gx,gy,gz\n0,1,2,3\n0.5,4,5,6\n"
GYRO = ColumnMapping("t", time_unit="s", gyro="gx,gy,gz", unit="rad/s")


@pytest.fixture
def saved(tmp_path):
    def save(text, name="log.csv"):
        path = tmp_path / name
        path.write_bytes(text if isinstance(text, bytes) else text.encode())
        return path

    return save


def table(columns, delimiter=","):
    return "".join(delimiter.join(f"{x:.17g}" for x in row) + "\n" for row in np.column_stack(columns))


def refused(path, mapping, kind=FormatError):
    with pytest.raises(kind) as caught:
        read_columns(path, mapping)
    assert str(path) in str(caught.value)
    return str(caught.value)


@pytest.mark.parametrize(("header", "mapping"), [
    ("t,q_x,q_y,q_z,q_w\n", ColumnMapping("t", time_unit="s", quat="q_x,q_y,q_z,q_w")),
    ("t,q_x,q_y,q_z,q_w\n", ColumnMapping("t", time_unit="s", quat="q_w,q_x,q_y,q_z")),
    ("t,q_x,q_y,q_z,q_w\n", ColumnMapping("t", time_unit="s", quat="q_w,q_x,q_y,q_z", order="wxyz")),
    ("t,q1,q2,q3,q4\n", ColumnMapping("t", time_unit="s", quat="q1,q2,q3,q4", order="xyzw")),
    ("", ColumnMapping(1, time_unit="s", quat="5,2,3,4", order="wxyz")),
    ("# by a simulator\n% t q_x q_y q_z q_w\n", ColumnMapping("1", time_unit="s", quat=(2, 3, 4, 5), order="xyzw")),
    ("# t,q_x,q_y,q_z,q_w\n", ColumnMapping("t", time_unit="s", quat="q_x,q_y,q_z,q_w")),
])  # fmt: skip
def test_quaternions_in_any_order(saved, header, mapping):
    found = read_columns(saved(header + table([np.arange(3.0), XYZW])), mapping)
    assert found.attitude == pytest.approx(XYZW[:, [3, 0, 1, 2]], abs=1e-15) and found.angular_velocity is None
    assert found.times.tolist() == [0.0, 1.0, 2.0] and np.array_equal(found.states, found.attitude)
    vector = np.array([0.3, -1.0, 2.0])
    assert rotation.rotate(found.attitude, vector) == pytest.approx(TURNS.apply(vector), abs=1e-14)


def test_space_to_body_is_the_inverse(saved):
    mapping = ColumnMapping(1, time_unit="s", quat="2,3,4,5", order="xyzw", direction="space-to-body")
    found = read_columns(saved(table([np.arange(3.0), XYZW])), mapping)
    assert rotation.rotate(found.attitude, (1.0, 2.0, 3.0)) == pytest.approx(TURNS.inv().apply((1, 2, 3)), abs=1e-14)
    assert "space to body" in found.source.attributes["attitude"]


@pytest.mark.parametrize("sequence", ["ZYX", "ZXZ", "xyz", "YXZ"])
@pytest.mark.parametrize("unit", ["deg", "rad"])
def test_euler_angles(saved, sequence, unit):
    angles = TURNS.as_euler(sequence, unit == "deg")
    text = f"t [s],a [{unit}],b [{unit}],c [{unit}]\n" + table([np.arange(3.0), angles])
    found = read_columns(saved(text), ColumnMapping("t", euler="a,b,c", sequence=sequence))
    assert rotation.angle_between(found.attitude, rotation.from_scipy(TURNS)).max() < 1e-14
    backward = ColumnMapping("t", euler="a,b,c", sequence=sequence, direction="space-to-body", unit=unit)
    turned = read_columns(saved(text), backward).attitude
    assert rotation.angle_between(turned, rotation.from_scipy(TURNS.inv())).max() < 1e-14


@pytest.mark.parametrize(("unit", "size"), [("rad/s", 1.0), ("deg/s", np.pi / 180.0), ("rpm", np.pi / 30.0)])
def test_units_of_rates(saved, unit, size):
    text = RATES.replace("gx,gy,gz", f"gx ({unit}),gy ({unit}),gz ({unit})")
    for path, said in ((saved(text), None), (saved(RATES, "bare.csv"), unit)):
        found = read_columns(path, ColumnMapping("t", time_unit="s", gyro="gx,gy,gz", unit=said))
        assert found.angular_velocity == pytest.approx(size * np.array([[1.0, 2.0, 3.0], [4.0, 5.0, 6.0]]), rel=1e-15)
        assert found.attitude is None and found.momentum is None


@pytest.mark.parametrize(("unit", "size"), [("s", 1), ("ms", 1000), ("us", 10**6), ("ns", 10**9), ("min", 1 / 60)])
@pytest.mark.parametrize("header", ["{}", "t [{}]", "Time ({})", "time_{}"])
def test_units_of_times(saved, unit, size, header):
    """A third of a second, told by the mapping or by any way to name a unit; 1000 ms are one second to the last bit."""
    name = "t" if header == "{}" else header.format(unit)
    text = RATES.replace("t,", f"{name},").replace("0.5,", f"{3 * size:.17g},")
    mapping = ColumnMapping(name, time_unit=unit if header == "{}" else None, gyro="gx,gy,gz", unit="rad/s")
    assert read_columns(saved(text), mapping).times.tolist() == [0.0, 3.0]


@pytest.mark.parametrize("text", [
    RATES.replace(",", ";"), RATES.replace(",", "\t"), RATES.replace(",", "   "), RATES.replace("\n", "\r\n"),
    RATES.replace("\n", "\r"), "\ufeff" + RATES, RATES.rstrip(), "\n# made today\n\n" + RATES + "\n\n% the end\n",
    RATES.replace("t,gx,gy,gz", '"t", "gx", "gy","gz"'), RATES.replace("0,1", '"0", 1'), RATES.replace(",", " , "),
    "% t gx gy gz\n 0  1 2 3\n .5 4. 5e0 +6\n", "Log 17 of a phone, made in May\n" + RATES,
    RATES.replace(",", ";").replace("\n", ";\n"), "t;gx;gy;gz\n0;1;2;3;\n0.5;4;5;6;\n",
    "name,t,gx,gy,gz,note\na,0,1,2,3,\nb,0.5,4,5,6,\"one, two\"\n",
    "t,gx,gy,gz,T\n0,1,2,3,20\n0.2,,,,21\n0.3,nan,NaN,,21\n0.5,4,5,6,\n",
    "t,gx,gy,gz\n0,1,2,3\n0.5,4,5,6\n0.5,4,5,6\n",
])  # fmt: skip
def test_the_same_table_in_other_forms(saved, text):
    found = read_columns(saved(text), GYRO)
    assert found.times.tolist() == [0.0, 0.5] and found.angular_velocity.tolist() == [[1, 2, 3], [4, 5, 6]]


def test_units_in_names_between_blanks(saved):
    text = "t [s]  gx [deg/s] gy [deg/s]  gz [deg/s]\n0 0 0 180\n1 0 0 90\n"
    assert read_columns(saved(text), ColumnMapping("t", gyro="gx,gy,gz")).angular_velocity[:, 2] == pytest.approx(
        [np.pi, np.pi / 2]
    )


def test_units_in_a_line_of_their_own(saved):
    text = "log of a rig\nt,gx,gy,gz,T\n[ms],deg/s,deg/s,deg/s,degC\n0,0,0,180,20\n500,0,0,90,20\n"
    found = read_columns(saved(text), ColumnMapping("t", gyro="gx,gy,gz"))
    assert found.times.tolist() == [0.0, 0.5] and found.angular_velocity[:, 2] == pytest.approx([np.pi, np.pi / 2])
    assert found.source.attributes["time"] == "column 1 't [ms]', in ms"


def test_decimal_commas(saved):
    text = "t [s];gx;gy;gz\n0,0;1;2;3\n0,5;4,25;-5;6e-1\n"
    path = saved(text)
    mapping = ColumnMapping("t", gyro="gx,gy,gz", unit="rad/s", decimal="comma")
    assert read_columns(path, mapping).angular_velocity[1].tolist() == [4.25, -5.0, 0.6]
    assert "line 2, column 1 't [s]'" in (words := refused(path, GYRO)) and "`decimal` comma" in words
    assert "has a point" in refused(saved(text.replace("4,25", "1.004,25")), mapping)
    assert "Save it with semicolons" in refused(saved("t [s],gx,gy,gz\n0,1,2,3\n"), mapping, InvalidInput)


def test_what_is_understood_is_said(saved):
    off = XYZW * (1.0 + np.array([1e-4, -5e-4, 0.0]))[:, None]
    text = "time_ms;qx;qy;qz;qw;gx;gy;gz\n" + table([np.arange(3.0), off, np.ones((3, 3))], ";") + "3;;;;;;;\n"
    mapping = ColumnMapping("time_ms", time_unit="s", quat="qx,qy,qz,qw", gyro="gx,gy,gz", unit="rpm")
    found = read_columns(saved(text), mapping)
    assert np.linalg.norm(found.attitude, axis=1) == pytest.approx(1.0, abs=1e-15)
    said = found.source.attributes
    assert said["largest_deviation"] == pytest.approx(5e-4, rel=1e-6) and said["left_out"] == 1
    assert (said["samples"], said["first"], said["last"]) == (3, 0.0, 2.0)
    assert said["time"] == "column 1 'time_ms', in s" and said["delimiter"] == "semicolons"
    assert "w = column 5 'qw'" in said["attitude"] and "body to space" in said["attitude"]
    assert "z = column 8 'gz'" in said["angular_velocity"] and "rpm" in said["angular_velocity"]
    assert len(said["notes"]) == 1 and "ms" in said["notes"][0]


@pytest.mark.parametrize(("changed", "apart"), [
    ({}, 0.0), ({"direction": "space-to-body"}, 1.4), ({"unit": "deg/s"}, 1.0), ({"order": "wxyz"}, 1.0),
])  # fmt: skip
def test_rates_tell_whether_the_attitude_is_taken_right(saved, changed, apart):
    """A cone: spin about a moving axis, so that the inverse rotation turns with other rates along the body."""
    t = np.linspace(0.0, 2.0, 401)
    turns = Rotation.from_rotvec(t[:, None] * [0.0, 0.0, 3.0]) * Rotation.from_rotvec([0.8, 0.0, 0.0]) * (
        Rotation.from_rotvec(t[:, None] * [0.0, 0.0, 2.0]))  # fmt: skip
    spin = Rotation.from_rotvec(-t[:, None] * [0.0, 0.0, 2.0]).apply([0.0, np.sin(0.8), np.cos(0.8)])
    rates = 3.0 * spin + [0.0, 0.0, 2.0]
    words = {"time_unit": "s", "quat": "2,3,4,5", "order": "xyzw", "gyro": "6,7,8", "unit": "rad/s"} | changed
    found = read_columns(saved(table([t, turns.as_quat(), rates])), ColumnMapping(1, **words))
    assert found.source.attributes["rates_apart"] == pytest.approx(apart, abs=1e-4 if apart == 0.0 else 0.7)


@pytest.mark.parametrize("speed", [0.0, 0.05])
def test_digits_of_a_body_that_hardly_turns_are_no_disagreement(saved, speed):
    """Six decimals every millisecond are worth a thousandth of a radian per second."""
    t = np.arange(4000) * 1e-3
    quaternions = Rotation.from_rotvec(t[:, None] * [0.0, speed, 0.0]).as_quat().round(6)
    text = table([t, quaternions, np.tile([0.0, speed, 0.0], (len(t), 1))])
    mapping = ColumnMapping(1, time_unit="s", quat="2,3,4,5", order="xyzw", gyro="6,7,8", unit="rad/s")
    apart = read_columns(saved(text), mapping).source.attributes["rates_apart"]
    assert apart is None if speed == 0.0 else apart < 1e-3


WRONG_MAPPINGS = [
    ({"time": None}, ["time is missing", "no column is an attitude"]),
    ({"time": 0, "gyro": "a,b,c"}, ["time must be the name"]),
    ({"time": "t", "time_unit": "weeks", "quat": "a,b", "order": "zyxw", "gyro": "a,b,a", "unit": "Hz",
      "direction": "up", "decimal": "."},
     ["time_unit must be one of s, ms, us, ns, min, h, d, mjd, jd, gps, unix", "quat must be 4 columns",
      "order must be one of", "'Hz'",
      "gyro must be 3 different", "direction must be", "decimal must be"]),
    ({"time": "t", "quat": "a,b,c,d", "euler": "e,f,g"}, ["both are the attitude", "euler needs sequence"]),
    ({"time": "t", "gyro": "a,b,c", "order": "wxyz", "sequence": "ZYX", "direction": "body-to-space", "unit": "deg"},
     ["order is that of a quaternion", "sequence is that of Euler", "direction is that of an", "unit deg is one of"]),
    ({"time": "t", "gyro": "a,b,c", "unit": "rpm,deg/s"}, ["two units of rates"]),
    ({"time": "t", "euler": "a,b,c", "sequence": "ZZX"}, ["no two alike"]),
    ({"time": "t", "euler": "roll,pitch,yaw", "sequence": "ZYX"}, ['Write euler "yaw,pitch,roll"']),
]  # fmt: skip


@pytest.mark.parametrize(("words", "wanted"), WRONG_MAPPINGS)
def test_all_that_is_wrong_with_a_mapping_is_said_at_once(words, wanted):
    with pytest.raises(InvalidInput) as caught:
        ColumnMapping(**words)
    assert len(caught.value.args) == len(wanted)
    assert all(any(one in line for line in caught.value.args) for one in wanted)


@pytest.mark.parametrize(("text", "mapping", "wanted"), [
    (RATES, ColumnMapping("time", gyro="gx,gy,gw"), ["no column 'time'", "'gw'", "`unit` deg/s|rad/s|rpm"]),
    (RATES, ColumnMapping("t", gyro="gx,gy,gz"), ["`time_unit` s|ms|us|ns|min|h|d", "`unit` deg/s|rad/s|rpm"]),
    (RATES, ColumnMapping("T", time_unit="s", gyro="gx,gy,5", unit="rpm"), ["Did you mean 't'?", "are 1 to 4"]),
    (RATES, ColumnMapping("t", time_unit="s", gyro="gx,gy,t", unit="rpm"), ["column 1 't' is given twice"]),
    ("t,a,a,b\n0,1,2,3\n", ColumnMapping("t", time_unit="s", gyro="a,b,3", unit="rpm"), ["columns 2 and 3"]),
    ("0,1,2,3\n", ColumnMapping("t", time_unit="s", gyro="2,3,4", unit="rpm"), ["give a number from 1 to 4"]),
    ("t,q0,q1,q2,q3\n0,1,0,0,0\n", ColumnMapping("t", time_unit="s", quat="q0,q1,q2,q3"), ["`order` wxyz|xyzw"]),
    ("t,w,x,y,z\n0,1,0,0,0\n", ColumnMapping("t", time_unit="s", quat="w,x,y,z", order="xyzw"), ["named in the"]),
    ("t,gx [deg/s],gy [rad/s],gz\n0,1,2,3\n", ColumnMapping("t", time_unit="s", gyro="gx,gy,gz"), ["deg/s and rad/s"]),
    ("t [weeks],gx,gy,gz\n0,1,2,3\n", ColumnMapping("t", gyro="gx,gy,gz", unit="rpm"), ["`time_unit`"]),
])  # fmt: skip
def test_what_the_file_does_not_say_is_not_guessed(saved, text, mapping, wanted):
    with pytest.raises(InvalidInput) as caught:
        read_columns(saved(text), mapping)
    assert len(caught.value.args) == len(wanted)
    assert all(words in line for line, words in zip(caught.value.args, wanted, strict=True))


@pytest.mark.parametrize(("old", "new", "words"), [
    ("0.5,4", "0.5,four", "line 3, column 2 'gx': 'four' must be a number"),
    ("0.5,4", "0.5,1e400", "line 3, column 2 'gx': '1e400' is too large"),
    ("0.5,4", "0.5,inf", "line 3, column 2 'gx': 'inf' must be"),
    ("0.5,4", "0.5,2_5", "line 3, column 2 'gx': '2_5' must be"),
    ("0.5,4", "0.5,", "line 3, column 2 'gx': has no value"),
    ("0.5,4", "NaN,4", "line 3, column 1 't': has no value"),
    ("0.5,4", "0,4", "line 3: its time, 0 s, is the same as that of line 2"),
    ("0.5,4", "-1,4", "line 3: its time, -1 s, is before that of line 2"),
    ("0.5,4", "4", "line 3: has 3 cells, and line 2 has 4"),
    ("0.5,4", '0.5,"4', "line 3: has quotes that do not close"),
    ("gz\n", "gz,more\n", "line 1: must name the 4 columns that line 2 has; got 5"),
    ("0.5,4,5,6", "0.5,4\0,5,6", "line 3: has a NUL"),
    (RATES[11:], "", "has no line of numbers"), (RATES, "", "has no line of numbers"),
])  # fmt: skip
def test_lines_that_are_wrong_are_named(saved, old, new, words):
    assert old in RATES
    assert words in refused(saved(RATES.replace(old, new)), GYRO)


def test_quaternions_that_are_none_are_named_by_their_line(saved):
    text = "t,qw,qx,qy,qz\n0,1,0,0,0\n# a comment\n1,0.5,0.5,0.5,0.502\n2,1,0,0,0.1\n"
    words = refused(saved(text), ColumnMapping("t", time_unit="s", quat="qw,qx,qy,qz"))
    assert "line 4: a quaternion must have length 1 to 0.001; got 1.001" in words
    mapping = ColumnMapping("t", time_unit="s", quat=(2, 3, 4, 5))
    assert "line 5" in refused(saved(text.replace("0.502", "0.501")), mapping)


def test_no_values_at_all(saved):
    assert "no line has values" in refused(saved("t,gx,gy,gz,T\n0,,,,20\n1,,,,21\n"), GYRO)


@pytest.mark.sweep
def test_lines_are_counted_through_all_blocks(saved):
    """The one that is wrong stands behind a block that NumPy reads, and a comment."""
    many = BLOCK // 8
    rows = [f"{k},1,2,3\n" for k in range(many + 10)]
    rows[many + 5] = "# pause\n" + rows[many + 5].replace(",2,", ",two,")
    assert f"line {many + 8}, column 3 'gy': 'two'" in refused(saved("t,gx,gy,gz\n" + "".join(rows)), GYRO)
    rows[many + 5] = ""
    assert len(read_columns(saved("t,gx,gy,gz\n" + "".join(rows)), GYRO)) == many + 9
    found = read_columns(saved("t,gx,gy,gz\n" + "".join(rows).rstrip()), GYRO)  # no line's end at the end
    assert len(found) == many + 9 and (found.times == [k for k in range(many + 10) if k != many + 5]).all()


def test_rates_alone_are_kept_by_a_dataset(saved, tmp_path):
    found = read_columns(saved(RATES), GYRO)
    write_dataset(found, tmp_path / "rates.nc")
    back = read_dataset(tmp_path / "rates.nc")
    assert np.array_equal(back.angular_velocity, found.angular_velocity) and back.attitude is None
    assert back.layout.names == found.layout.names == ("angular_velocity",)
    assert np.array_equal(back.states, found.states)
