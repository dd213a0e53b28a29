"""Attitude Ephemeris Messages: against Orekit, the standard's own examples, rotations by hand, and bad files."""

import itertools
import re
from dataclasses import replace

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import polhode as ph
from polhode import rotation
from polhode.errors import FormatError, InvalidInput
from polhode.formats.labels import AttitudeLabels
from polhode.motion import Trajectory
from polhode.spacecraft.formats.adm_keywords import AEM
from polhode.spacecraft.formats.aem import LIMITS, write_aem
from polhode.spacecraft.formats.aem_reading import read_aem
from spacecraft.aem_specimens import FIGURE_G4, message, read_by_orekit, rewritten_by_orekit

DIGITS = 2e-15
"""rad, rad/s: 16 significant digits, and a few roundings."""
PRINTED = 1e-4
"""Annex F prints four decimals."""
PICOSECOND = 1e-12
FASTEST = 3.0
"""rad/s, more than any motion here: what a last digit of a time, 0.1 s and ten times that, turns it by."""
MOTION = ph.FreeMotion((1.0, 2.0, 3.0), momentum=(0.3, 1.8, 1.5), attitude=(0.5, -0.5, 0.1, 0.7))
BODY = ph.shapes.box(2.0, (1.0, 2.0, 3.0)).placed(Rotation.from_euler("zyx", (0.4, 0.3, -1.0)).as_matrix(), (0, 0, 0))
QUATERNION = (0.1, -0.5, 0.7, 0.5)
START, SPIN = np.array([0.5, -0.5, 0.1, 0.7]), np.array([0.1, 2.0, -0.3])


def read_text(tmp_path, text, segment=None):
    path = tmp_path / "read.aem"
    path.write_bytes(text.encode())
    return read_aem(path, segment)


def check_same(found, wanted, allowed=DIGITS):
    assert np.asarray(found.times) == pytest.approx(np.asarray(wanted.times), abs=PICOSECOND)
    lag = FASTEST * np.abs(np.asarray(found.times) - np.asarray(wanted.times)).max()
    assert lag < 1e-13 and rotation.angle_between(found.attitude, wanted.attitude).max() <= allowed + lag
    if found.angular_velocity is not None:
        assert np.abs(found.angular_velocity - wanted.angular_velocity).max() <= 10 * (allowed + lag)


def given_case():
    """Return a motion along the principal axes of a body that stands askew, and these axes."""
    frame = BODY.frame
    momentum = frame.axes.T @ BODY.inertia @ SPIN
    attitude = rotation.multiply(START, rotation.from_matrix(frame.axes))
    return ph.FreeMotion(frame.moments, momentum=momentum, attitude=attitude).sample(np.linspace(0.0, 20.0, 201)), frame


@pytest.mark.parametrize("rates", [None, "derivative", "angular velocity"])
def test_orekit_reads_what_we_write(tmp_path, rates):
    trajectory = MOTION.sample(np.linspace(0.0, 20.0, 201))
    path = write_aem(trajectory, tmp_path / "motion.aem", rates=rates)
    times, attitude, velocity = read_by_orekit(path)
    assert times == pytest.approx(np.asarray(trajectory.times), abs=PICOSECOND)
    lag = FASTEST * np.abs(times - np.asarray(trajectory.times)).max()
    assert lag < 1e-13 and rotation.angle_between(attitude, trajectory.attitude).max() <= DIGITS + lag
    # the measure sees a rotation the wrong way round, and a scalar in the wrong place
    assert rotation.angle_between(rotation.conjugate(attitude), trajectory.attitude).max() > 0.1
    assert rotation.angle_between(np.roll(attitude, 1, axis=-1), trajectory.attitude).max() > 0.1
    if rates:
        assert np.abs(velocity - trajectory.angular_velocity).max() <= 10 * DIGITS
    check_same(read_aem(path), trajectory)


@pytest.mark.parametrize("rates", [None, "derivative", "angular velocity"])
def test_we_read_what_orekit_writes(tmp_path, rates):
    trajectory = MOTION.sample(np.linspace(0.0, 20.0, 201))
    path = write_aem(trajectory, tmp_path / "motion.aem", rates=rates)
    check_same(read_text(tmp_path, rewritten_by_orekit(path)), trajectory)


EULER = ["".join(axes) for axes in itertools.product("XYZ", repeat=3) if axes[0] != axes[1] != axes[2]]
NUMBERS = " ".join(map(str, QUATERNION))
KINDS = [
    ("QUATERNION/ANGVEL", f"{NUMBERS} 1 2 3", "ANGVEL_FRAME = SC_BODY_1\n"),
    ("QUATERNION/DERIVATIVE", f"{NUMBERS} 0.1 0.2 0.3 0.4", ""),
    ("SPIN", "20 30 50 3", ""),
    ("SPIN/NUTATION", "20 30 50 3 5 100 10", ""),
    ("SPIN/NUTATION_MOM", "20 30 50 3 25 40 10", ""),
    ("EULER_ANGLE/ANGVEL", "20 30 50 1 2 3", "EULER_ROT_SEQ = ZXZ\nANGVEL_FRAME = SC_BODY_1\n"),
    *(("EULER_ANGLE/DERIVATIVE", "20 30 50 1 2 3", f"EULER_ROT_SEQ = {sequence}\n") for sequence in EULER),
]
OLD = [
    ("QUATERNION", NUMBERS, "QUATERNION_TYPE = LAST\n"),
    ("QUATERNION", NUMBERS, "QUATERNION_TYPE = FIRST\n"),
    ("QUATERNION/DERIVATIVE", f"{NUMBERS} 0.1 0.2 0.3 0.4", "QUATERNION_TYPE = FIRST\n"),
    ("EULER_ANGLE", "20 30 50", "EULER_ROT_SEQ = 312\n"),
    ("EULER_ANGLE", "20 30 50", "EULER_ROT_SEQ = 131\n"),
]
OLD = [(*case[:2], f"{case[2]}ATTITUDE_DIR = {way}\n") for case in OLD for way in ("A2B", "B2A")]
CASES = [(*case, "2.0") for case in KINDS] + [(*case, "1.0") for case in OLD]


@pytest.mark.parametrize(("kind", "values", "extra", "version"), CASES)
def test_every_kind_is_read_as_orekit_reads_it(tmp_path, kind, values, extra, version):
    found = read_text(tmp_path, message(kind, values, extra, version))
    _, attitude, velocity = read_by_orekit(tmp_path / "read.aem")
    assert rotation.angle_between(found.attitude, attitude).max() <= 4 * DIGITS
    if "/" in kind or kind == "SPIN":
        assert np.abs(found.angular_velocity - velocity).max() <= DIGITS
    else:
        assert found.angular_velocity is None


def test_the_quarter_turn_of_annex_f2(tmp_path):
    """Frame B after +90° about z: its x axis has the coordinates (0, 1, 0) in A."""
    found = read_text(tmp_path, message("QUATERNION", "0 0 0.70710678118654752 0.70710678118654752"))
    assert rotation.rotate(found.attitude[0], (1.0, 0.0, 0.0)) == pytest.approx((0.0, 1.0, 0.0), abs=DIGITS)
    times = np.array([0.0])
    quarter = rotation.from_axis_angle((0.0, 0.0, 1.0), np.array([np.pi / 2]))
    turned = Trajectory(times, found.attitude, attitude=quarter)
    numbers = write_aem(turned, tmp_path / "turn.aem").read_text().splitlines()[-2].split()[1:]
    assert list(map(float, numbers)) == pytest.approx([0.0, 0.0, 0.5**0.5, 0.5**0.5], abs=DIGITS)


def test_the_spin_axis_of_annex_f5(tmp_path):
    found = read_text(tmp_path, message("SPIN/NUTATION_MOM", "0 80 45 1 0 70 0.01"))
    assert found.attitude[0] == pytest.approx((0.3812, 0.0805, 0.0334, 0.9204), abs=PRINTED)
    assert rotation.rotate(found.attitude[0], (0.0, 0.0, 1.0)) == pytest.approx((0.1736, 0.0, 0.9848), abs=PRINTED)
    # after 300 s of the model of F5.3, which turns uniformly about the momentum and about the spin axis
    momentum = np.array([np.cos(np.radians(70.0)), 0.0, np.sin(np.radians(70.0))])
    about = rotation.from_axis_angle(momentum, np.array(np.radians(3.0)))
    after = rotation.multiply(rotation.multiply(about, found.attitude[0]),
                              rotation.from_axis_angle((0.0, 0.0, 1.0), np.array(np.radians(300.0))))  # fmt: skip
    assert np.abs(after * np.sign(after[0])) == pytest.approx((0.7747, 0.0584, 0.0650, 0.6263), abs=PRINTED)
    step = 1e-4
    turn = rotation.multiply(rotation.from_axis_angle(momentum, np.array(np.radians(0.01 * step))), found.attitude[0])
    turn = rotation.multiply(turn, rotation.from_axis_angle((0.0, 0.0, 1.0), np.array(np.radians(step))))
    ahead = rotation.as_rotation_vector(rotation.multiply(rotation.conjugate(found.attitude[0]), turn)) / step
    assert found.angular_velocity[0] == pytest.approx(ahead, abs=1e-7)


def test_figure_g4_of_the_standard(tmp_path):
    found = read_text(tmp_path, FIGURE_G4)
    # each segment over its useable time: three samples of eight lie outside
    assert len(found.times) == 4
    first = AttitudeLabels("MARS GLOBAL SURVEYOR", "1996-062A", "MARS BARYCENTER", epoch="1996-11-28T21:29:07.2555",
                           originator="NASA/JPL", spice_id=None, comments=found.source.labels.comments)  # fmt: skip
    assert found.source.labels == first and found.source.labels.comments[0].startswith("This file was produced")
    assert found.times[0] == 2336.3 and found.angular_velocity is None and found.momentum is None
    alone = read_text(tmp_path, FIGURE_G4, segment=1)
    wanted = np.array([0.16767, 0.87451, -0.43475, 0.13458])
    assert alone.attitude[0] == pytest.approx(wanted / np.linalg.norm(wanted), abs=DIGITS)
    assert alone.source.labels.epoch == "1996-12-18T12:05:00.5555" and len(alone.times) == 2


def test_exact_motions_are_evaluated_at_the_printed_epochs(tmp_path):
    fast = ph.FreeMotion((1.0, 2.0, 3.0), momentum=(30.0, 180.0, 150.0))
    times = np.linspace(0.0, 1.0, 7)  # none but the ends has a place among picoseconds
    found = read_aem(write_aem(fast.sample(times), tmp_path / "fast.aem"))
    turned = rotation.angle_between(found.attitude, fast.sample(found.times).attitude)
    assert turned.max() < PICOSECOND
    # what is not evaluated again is off by the rounding of the epochs, which the bound above would not pass
    kept = replace(fast.sample(times), source=None)
    found = read_aem(write_aem(kept, tmp_path / "kept.aem"))
    assert rotation.angle_between(found.attitude, fast.sample(found.times).attitude).max() > 10 * PICOSECOND


def test_files_are_about_the_given_axes(tmp_path):
    trajectory, frame = given_case()
    found = read_aem(write_aem(replace(trajectory, frame=frame), tmp_path / "given.aem", rates="angular velocity"))
    motion = ph.FreeMotion.from_body(BODY, angular_velocity=SPIN, attitude=START)  # along the given axes
    check_same(found, motion.sample(np.asarray(trajectory.times)), 10 * DIGITS)
    assert rotation.angle_between(found.attitude, trajectory.attitude).min() > 0.1


def test_angular_velocity_along_space_axes(tmp_path):
    body = read_text(tmp_path, message("QUATERNION/ANGVEL", f"{NUMBERS} 1 2 3", "ANGVEL_FRAME = SC_BODY_1\n"))
    space = read_text(tmp_path, message("QUATERNION/ANGVEL", f"{NUMBERS} 1 2 3", "ANGVEL_FRAME = EME2000\n"))
    assert rotation.rotate(space.attitude, space.angular_velocity) == pytest.approx(body.angular_velocity, abs=DIGITS)
    old = "QUATERNION_TYPE = LAST\nATTITUDE_DIR = A2B\nRATE_FRAME = REF_FRAME_A\n"
    older = read_text(tmp_path, message("QUATERNION/RATE", f"{NUMBERS} 1 2 3", old, "1.0"))
    assert np.array_equal(older.angular_velocity, space.angular_velocity)


def test_from_body_to_space_is_the_other_way_round(tmp_path):
    """With A the body, everything is of the space frame against the body."""
    back = ("SC_BODY_1", "EME2000")
    one = read_text(tmp_path, message("QUATERNION/ANGVEL", "0.1 -0.5 0.7 0.5 1 2 3", "ANGVEL_FRAME = SC_BODY_1\n"))
    frame = "ANGVEL_FRAME = REF_FRAME_A\n"
    two = read_text(tmp_path, message("QUATERNION/ANGVEL", "-0.1 0.5 -0.7 0.5 -1 -2 -3", frame, frames=back))
    check_same(two, one)
    assert (two.source.labels.reference_frame, two.source.labels.body_frame) == ("EME2000", "SC_BODY_1")
    straight = message("QUATERNION/DERIVATIVE", "0.1 -0.5 0.7 0.5 0.1 0.2 0.3 0.4")
    conjugate = message("QUATERNION/DERIVATIVE", "-0.1 0.5 -0.7 0.5 -0.1 -0.2 -0.3 0.4", frames=back)
    check_same(read_text(tmp_path, conjugate), read_text(tmp_path, straight))
    with pytest.raises(FormatError, match="other way round"):
        read_text(tmp_path, message("SPIN", "20 30 50 3", frames=back))


def test_layout_that_does_not_matter(tmp_path):
    text = message("QUATERNION", NUMBERS)
    wanted = read_text(tmp_path, text)
    loose = text.replace("\n", "\r\n\r\n").replace(" = ", "=").replace("DATA_START", "DATA_START\nCOMMENT data")
    loose = "\ufeff" + loose.replace("2020-01-01T00:00:00 ", "  2020-001T00:00:00.000Z   ")
    found = read_text(tmp_path, loose)
    assert np.array_equal(found.attitude, wanted.attitude) and found.times[0] == 0.0
    assert found.source.labels == wanted.source.labels


def test_leap_seconds_are_counted(tmp_path):
    """2016 ended with 23:59:60 UTC, so that midnight is two seconds after 23:59:59."""
    trajectory = MOTION.sample(np.array([0.0, 0.5, 1.0, 1.25, 2.0, 3.0]))
    labels = AttitudeLabels(epoch="2016-12-31T23:59:59", time_system="UTC")
    path = write_aem(trajectory, tmp_path / "leap.aem", labels)
    epochs = [line.split()[0] for line in path.read_text().splitlines() if line.startswith("201")]
    assert [epoch[11:].rstrip("0") for epoch in epochs] == [
        "23:59:59.", "23:59:59.5", "23:59:60.", "23:59:60.25", "00:00:00.", "00:00:01.",
    ]  # fmt: skip
    assert np.array_equal(read_by_orekit(path)[0], trajectory.times)
    assert np.array_equal(read_aem(path).times, trajectory.times)
    path = write_aem(trajectory, tmp_path / "tai.aem", replace(labels, time_system="TAI"))
    assert np.array_equal(read_aem(path).times, trajectory.times) and ":60" not in path.read_text()


@pytest.mark.filterwarnings("ignore:leap seconds are known")
def test_a_century_in_utc(tmp_path):
    days = np.sort(np.random.default_rng(1).uniform(0.0, 100 * 365.25, 500))
    trajectory = MOTION.sample(np.round(days * 86400.0, 3))
    path = write_aem(trajectory, tmp_path / "long.aem", AttitudeLabels(epoch="1972-01-01T00:00:00"))
    wanted = np.asarray(trajectory.times) - trajectory.times[0]
    assert np.abs(read_by_orekit(path)[0] - wanted).max() <= 1e-6
    assert np.abs(read_aem(path).times - wanted).max() <= 1e-6


def test_text_obeys_the_standard(tmp_path):
    labels = AttitudeLabels('t-handle </script> a=b "x"', "2026-001A", center="Earth", comments=("Made for a test",))
    path = write_aem(given_case()[0], tmp_path / "text.aem", labels, rates="derivative")
    lines = path.read_text("ascii").splitlines()
    assert max(map(len, lines)) <= 254 and not any("\t" in line for line in lines)
    assert "OBJECT_NAME = T-HANDLE </SCRIPT> A=B \"X\"" in lines
    number = re.compile(r"-?\d\.\d{15}e[+-]\d\d")
    data = [line.split()[1:] for line in lines if line[:2] == "20"]
    assert data and all(number.fullmatch(word) for row in data for word in row)
    assert not any(word == "-0.000000000000000e+00" for row in data for word in row)
    assert read_aem(path).source.labels.object_name == 'T-HANDLE </SCRIPT> A=B "X"'


@pytest.mark.parametrize("name", ["Größe", "two\nlines", "", "x" * 300, "tab\there"])
def test_labels_that_the_format_cannot_hold(tmp_path, name):
    with pytest.raises(InvalidInput, match="object_name"):
        write_aem(given_case()[0], tmp_path / "motion.aem", AttitudeLabels(object_name=name))
    assert list(tmp_path.iterdir()) == []


def test_the_longest_line(tmp_path):
    """254 characters with the keyword, written and read; a file that is read may have 16,384."""
    longest = LIMITS.max_length - len("OBJECT_NAME = ")
    path = write_aem(given_case()[0], tmp_path / "long.aem", AttitudeLabels(object_name="X" * longest))
    assert read_aem(path).source.labels.object_name == "X" * longest
    with pytest.raises(InvalidInput, match="`object_name` must be one line of printable ASCII, at most 254 characters"):
        write_aem(given_case()[0], path, AttitudeLabels(object_name="X" * (longest + 1)))
    head = "OBJECT_NAME = A"
    assert read_text(tmp_path, G.replace(head, f"{head}{'A' * (AEM.max_line - len(head) - 1)}"))  # with the line's end
    with pytest.raises(FormatError, match="line 5: has more than 16384 characters"):
        read_text(tmp_path, G.replace(head, f"{head}{'A' * (AEM.max_line - len(head) + 1)}"))


def test_motions_that_the_format_cannot_hold(tmp_path):
    good = MOTION.sample(np.linspace(0.0, 1.0, 3))
    batch = ph.FreeMotion((1.0, 2.0, 3.0), momentum=np.ones((4, 1, 3))).sample(np.linspace(0.0, 1.0, 3))
    cases = [
        (replace(good, attitude=None), {}, "holds attitudes"),
        (batch, {}, "holds one body"),
        (good.select(slice(0)), {}, "at least one sample"),
        (replace(good, angular_velocity=None), {"rates": "derivative"}, "angular velocity"),
        (good, {"rates": "Derivative"}, "`rates` must be"),
        (replace(good, times=np.array([0.0, 1.0, 1.0])), {}, "sample 2 does not come after sample 1"),
        (replace(good, times=np.array([0.0, 1.0, np.nan])), {}, "finite"),
        (replace(good, times=np.array([0.0, 1.0, 1.0 + 1e-13])), {}, "^samples 1 and 2 are 9.99e-14 s apart"),
        (replace(good, attitude=good.attitude * np.nan), {}, "finite"),
        (good, {"labels": AttitudeLabels(epoch="2026-02-30T00:00:00")}, "`epoch` has no such day"),
        (good, {"labels": AttitudeLabels(epoch="today")}, "`epoch` must be an epoch like"),
        (good, {"labels": AttitudeLabels(epoch="1969-07-20T20:17:40")}, "before 1972"),
        (good, {"labels": AttitudeLabels(reference_frame="SC_BODY_1", body_frame="HANDLE")}, "take one for the other"),
        (good, {"labels": AttitudeLabels(time_system="PST")}, "`time_system` must be one of"),
    ]
    for trajectory, others, words in cases:
        with pytest.raises(InvalidInput, match=words):
            write_aem(trajectory, tmp_path / "motion.aem", **others)
    with pytest.raises(InvalidInput, match="cannot be written"):
        write_aem(good, "/proc/motion.aem")
    assert list(tmp_path.iterdir()) == []


G = message("QUATERNION", NUMBERS)
BAD = [
    ("CCSDS_AEM_VERS = 2.0", "CCSDS_OEM_VERS = 2.0", "line 1: an AEM begins with"),
    ("VERS = 2.0", "VERS = 3.0", "must be 1.0 or 2.0"),
    ("CCSDS_AEM_VERS = 2.0", "<aem>", "XML"),
    ("META_STOP", "", "line 4: META_START has no META_STOP"),
    ("DATA_STOP\n", "", "DATA_START has no DATA_STOP"),
    ("OBJECT_ID = 1996-062A\n", "", "line 4: OBJECT_ID is missing"),
    ("OBJECT_NAME", "OBJECT_NAMES", "line 5: unknown keyword 'OBJECT_NAMES'; did you mean OBJECT_NAME"),
    ("OBJECT_NAME = A", "OBJECT_NAME =", "line 5: OBJECT_NAME must have a value"),
    ("OBJECT_ID", "OBJECT_NAME = B\nOBJECT_ID", "line 6: OBJECT_NAME is there already, in line 5"),
    ("TIME_SYSTEM = UTC", "TIME_SYSTEM = MET", "TIME_SYSTEM must be one of"),
    ("= QUATERNION", "= QUATERNIONS", "ATTITUDE_TYPE must be one of"),
    ("= QUATERNION", "= EULER_ANGLE", "line 15: must be an epoch and 3 numbers"),
    (NUMBERS, "0.1 0.2 0.3", "line 15: must be an epoch and 4 numbers"),
    (NUMBERS, "0.1 -0.5 0.7 x", "line 15: number 4 of the 4 must be a number in decimal digits; got 'x'"),
    (NUMBERS, "0.1 -0.5 0.7 nan", "line 15: number 4 of the 4 must be a number in decimal digits; got 'nan'"),
    (NUMBERS, "0.1 -0.5 0.7 0.9", "line 15: must be a quaternion of unit length; got one of length"),
    (NUMBERS, "0 0 0 0", "line 15: must be a quaternion of unit length"),
    ("2020-01-01T00:00:00 ", "2020-13-01T00:00:00 ", "line 15: the epoch has no such day"),
    ("2020-01-01T00:00:00 ", "2020-366T24:00:00 ", "line 15: the epoch has no such time of day"),
    ("2020-01-01T00:00:00 ", "2019-366T00:00:00 ", "line 15: the epoch has no such day"),
    ("2020-01-01T00:00:00 ", "2020-01-01T23:59:60 ", "line 15: the epoch has no such time of day"),
    ("DATA_STOP", f"2020-01-01T00:00:00 {NUMBERS}\nDATA_STOP", "line 16: epochs must ascend"),
    ("START_TIME = 2020-01-01T00:00:00", "START_TIME = yesterday", "line 10: START_TIME must be an epoch like"),
    ("TIME_SYSTEM", "ATTITUDE_DIR = B2A\nTIME_SYSTEM", "is of version 1.0"),
    ("VERS = 2.0", "VERS = 1.0", "ATTITUDE_DIR must be A2B or B2A"),
    ("DATA_STOP\n", "DATA_STOP\nMORE = 1\n", "line 17: META_START must follow DATA_STOP"),
]


@pytest.mark.parametrize(("old", "new", "words"), BAD)
def test_files_that_are_wrong(tmp_path, old, new, words):
    assert old in G
    with pytest.raises(FormatError, match=words) as error:
        read_text(tmp_path, G.replace(old, new, 1))
    assert "read.aem" in str(error.value)


@pytest.mark.parametrize(("kind", "extra", "version", "words"), [
    ("EULER_ANGLE", "", "2.0", "EULER_ROT_SEQ must be three axes"),
    ("EULER_ANGLE", "EULER_ROT_SEQ = XXZ\n", "2.0", "EULER_ROT_SEQ must be three axes"),
    ("QUATERNION/ANGVEL", "", "2.0", "ANGVEL_FRAME must be one of the two frames"),
    ("QUATERNION/ANGVEL", "ANGVEL_FRAME = ICRF\n", "2.0", "ANGVEL_FRAME must be one of the two frames"),
    ("QUATERNION", "ATTITUDE_DIR = A2B\n", "1.0", "QUATERNION_TYPE must be FIRST or LAST"),
    ("QUATERNION/RATE", "QUATERNION_TYPE = LAST\nATTITUDE_DIR = B2A\nRATE_FRAME = REF_FRAME_B\n", "1.0", "leaves open"),
])  # fmt: skip
def test_files_that_leave_open_what_they_mean(tmp_path, kind, extra, version, words):
    count = {"EULER_ANGLE": "1 2 3", "QUATERNION": NUMBERS}.get(kind, f"{NUMBERS} 1 2 3")
    with pytest.raises(FormatError, match=words):
        read_text(tmp_path, message(kind, count, extra, version))


def test_segments_that_do_not_fit_together(tmp_path):
    other = FIGURE_G4.replace("mars global surveyor", "PHOBOS")
    with pytest.raises(FormatError, match="different objects"):
        read_text(tmp_path, other)
    assert read_text(tmp_path, other, segment=1).source.labels.object_name == "PHOBOS"
    with pytest.raises(InvalidInput, match="from 0 to 1"):
        read_text(tmp_path, other, segment=2)
    with pytest.raises(FormatError, match="overlap in time"):
        read_text(tmp_path, G + G[G.index("META_START") :].replace("2020", "2019"))
    late = re.sub("(USEABLE_ST[A-Z]*_TIME *= )1996-1", r"\g<1>1999-1", FIGURE_G4)
    with pytest.raises(FormatError, match="no sample lies within"):
        read_text(tmp_path, late)
    with pytest.raises(FormatError, match="line 15: must have a nutation period"):
        read_text(tmp_path, message("SPIN/NUTATION", "20 30 50 3 5 0 10"))
    twice = G + G[G.index("META_START") :]
    assert len(read_text(tmp_path, twice).times) == 1


def test_a_segment_alone_is_cut_to_its_useable_time_too(tmp_path):
    found = read_text(tmp_path, FIGURE_G4, segment=0)
    assert found.times.tolist() == [2336.3, 2337.3] and "2 samples" in found.outcome.message
    whole = re.sub("USEABLE.*\n", "", FIGURE_G4)
    assert len(read_text(tmp_path, whole, segment=0).times) == 4


@pytest.mark.parametrize("keyword", ["STOP_TIME", "USEABLE_STOP_TIME"])
def test_times_that_end_before_they_begin(tmp_path, keyword):
    text = re.sub(rf"^{keyword}( *)=.*", rf"{keyword}\1= 1990-01-01T00:00:00", FIGURE_G4, flags=re.MULTILINE)
    with pytest.raises(FormatError, match=f"{keyword} must not lie before"):
        read_text(tmp_path, text)


def test_what_is_no_file_of_text(tmp_path):
    with pytest.raises(InvalidInput, match="no such AEM file"):
        read_aem(tmp_path / "missing.aem")
    with pytest.raises(InvalidInput, match="is a folder"):
        read_aem(tmp_path)
    (tmp_path / "binary.aem").write_bytes(bytes(range(256)))
    with pytest.raises(FormatError, match="not text"):
        read_aem(tmp_path / "binary.aem")
    (tmp_path / "empty.aem").touch()
    with pytest.raises(FormatError, match="begins with CCSDS_AEM_VERS"):
        read_aem(tmp_path / "empty.aem")


@pytest.mark.sweep
def test_a_million_samples(tmp_path):
    trajectory = MOTION.sample(np.linspace(0.0, 1e5, 1_000_001))
    found = read_aem(write_aem(trajectory, tmp_path / "large.aem", rates="angular velocity"))
    assert np.abs(found.times - trajectory.times).max() <= 1e-12  # epochs have picoseconds
    assert rotation.angle_between(found.attitude, MOTION.attitude(found.times)).max() <= DIGITS
