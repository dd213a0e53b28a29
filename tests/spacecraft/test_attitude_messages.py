"""CCSDS Attitude Parameter and Comprehensive Messages: keywords, frames of rates and counts of numbers.

The files are written by hand after 504.0-B-2, tables 3-3 and 5-2 to 5-9; SciPy turns the rates.
"""

from pathlib import Path

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from polhode import rotation
from polhode.errors import FormatError
from polhode.spacecraft.formats.adm_keywords import ACM as ACM_TABLE
from polhode.spacecraft.formats.adm_keywords import APM as APM_TABLE
from polhode.spacecraft.formats.adm_state import LIMITS, read_acm, read_apm

TURN = Rotation.from_euler("ZYX", [40.0, -20.0, 10.0], degrees=True)
"""From the body's axes to those of space."""
RATES = np.array([1.5, -2.0, 0.5])
"""Along the body's axes [deg/s]."""


def apm(along="SC_BODY_1", rates=RATES, frames=("EME2000", "SC_BODY_1"), turn=TURN, rated_against=None):
    q1, q2, q3, qc = turn.as_quat().tolist()
    rates = np.asarray(rates).tolist()
    between = f"REF_FRAME_A = {frames[0]}\nREF_FRAME_B = {frames[1]}\n"
    other = between.replace("EME2000", rated_against) if rated_against else between
    return f"""CCSDS_APM_VERS = 2.0
CREATION_DATE = 2026-03-01T00:00:00
ORIGINATOR = ME
OBJECT_NAME = SAT
OBJECT_ID = 2026-001A
TIME_SYSTEM = UTC
EPOCH = 2026-03-01T12:00:00
QUAT_START
{between}Q1 = {q1!r}
Q2 = {q2!r}
Q3 = {q3!r}
QC = {qc!r}
QUAT_STOP
ANGVEL_START
{other}ANGVEL_FRAME = {along}
ANGVEL_X = {rates[0]!r} [deg/s]
ANGVEL_Y = {rates[1]!r} [deg/s]
ANGVEL_Z = {rates[2]!r} [deg/s]
ANGVEL_STOP
"""


def saved(folder, text, name="sat.txt"):
    path = Path(folder) / name
    path.write_text(text)
    return path


@pytest.mark.parametrize("backward", [False, True])
@pytest.mark.parametrize("along", ["SC_BODY_1", "EME2000", "eme2000"])
def test_rates_along_either_frame_of_an_apm(tmp_path, along, backward):
    """Along the axes of space they are R ω; of a message from body to space they are those of space against the body.
    """
    rates = RATES if along == "SC_BODY_1" else TURN.apply(RATES)
    text = apm(along, rates)
    if backward:
        text = apm(along, -rates, ("SC_BODY_1", "EME2000"), TURN.inv())
    found = read_apm(saved(tmp_path, text))
    assert rotation.angle_between(found.attitude[0], rotation.from_scipy(TURN)) < 1e-14
    assert found.angular_velocity[0] == pytest.approx(np.radians(RATES), abs=1e-15)


@pytest.mark.parametrize(("text", "words"), [
    (apm("IMU_FRAME_1"), "must be one of the two frames, EME2000 or SC_BODY_1, to be read here; got 'IMU FRAME 1'"),
    (apm("ICRF", rated_against="ICRF"), "or the one that the attitude is relative to, EME2000; got 'ICRF'"),
])  # fmt: skip
def test_rates_along_other_axes_of_an_apm_are_refused_without_blaming_the_file(tmp_path, text, words):
    with pytest.raises(FormatError, match=words) as caught:
        read_apm(saved(tmp_path, text))
    assert "line 19: ANGVEL_FRAME" in str(caught.value)
    assert str(caught.value).endswith("Have the rates written along SC_BODY_1.")


ROWS = "".join(f"{t}.0 {' '.join(map(repr, TURN.as_quat().tolist()))} 1.5 -2.0 0.5\n" for t in range(4))
ACM = f"""CCSDS_ACM_VERS = 2.0
CLASSIFICATION = none
CREATION_DATE = 2026-03-01T00:00:00
ORIGINATOR = ME
MESSAGE_ID = 7
META_START
COMMENT what follows is all that table 5-3 has
OBJECT_NAME = SAT
INTERNATIONAL_DESIGNATOR = 2026-001A
CATALOG_NAME = CAT
OBJECT_DESIGNATOR = 22444
ORIGINATOR_POC = X
ORIGINATOR_POSITION = Y
ORIGINATOR_PHONE = 1
ORIGINATOR_EMAIL = a@b
ORIGINATOR_ADDRESS = c
ODM_MSG_LINK = d
CENTER_NAME = EARTH
TIME_SYSTEM = UTC
EPOCH_TZERO = 2026-03-01T12:00:00
ACM_DATA_ELEMENTS = ATT, PHYS, COV, MAN, AD, USER
START_TIME = 0.0
STOP_TIME = 3.0
TAIMUTC_AT_TZERO = 37 [s]
NEXT_LEAP_EPOCH = 2030-01-01T00:00:00
NEXT_LEAP_TAIMUTC = 38 [s]
META_STOP
ATT_START
ATT_ID = 1
ATT_PREV_ID = 0
ATT_BASIS = SIMULATED
ATT_BASIS_ID = 5
REF_FRAME_A = EME2000
REF_FRAME_B = SC_BODY_1
NUMBER_STATES = 7
ATT_TYPE = QUATERNION
RATE_TYPE = ANGVEL
{ROWS}ATT_STOP
PHYS_START
DRAG_COEFF = 2
WET_MASS = 10 [kg]
DRY_MASS = 8 [kg]
CP_REF_FRAME = SC_BODY_1
CP = 0 0 0.1 [m]
INERTIA_REF_FRAME = SC_BODY_1
IXX = 2 [kg*m**2]
IYY = 3 [kg*m**2]
IZZ = 4 [kg*m**2]
PHYS_STOP
COV_START
COV_ID = 1
COV_PREV_ID = 0
COV_BASIS = SIMULATED
COV_BASIS_ID = 5
COV_REF_FRAME = SC_BODY_1
COV_TYPE = ANGLE
0.0 1e-9 1e-9 1e-9
COV_STOP
MAN_START
MAN_ID = 1
MAN_PREV_ID = 0
MAN_PURPOSE = MOM_DESAT
MAN_BEGIN_TIME = 100.0
MAN_DURATION = 450.0
ACTUATOR_USED = ATT-THRUSTER
TARGET_MOMENTUM = 1.3 -16.4 -11.35
TARGET_MOM_FRAME = EME2000
MAN_STOP
AD_START
AD_ID = 1
AD_METHOD = EKF
ATTITUDE_SOURCE = OBC
NUMBER_STATES = 7
ATTITUDE_STATES = QUATERNION
COV_TYPE = ANGLE_GYROBIAS
REF_FRAME_A = EME2000
REF_FRAME_B = SC_BODY_1
RATE_STATES = GYRO_BIAS
SIGMA_U = 1e-7
SIGMA_V = 1e-5
SENSOR_START
SENSOR_NUMBER = 1
SENSOR_USED = AST1
SENSOR_STOP
SENSOR_START
SENSOR_NUMBER = 2
SENSOR_USED = IMU
NUMBER_SENSOR_NOISE_COVARIANCE = 2
SENSOR_NOISE_STDDEV = 0.01 0.01
SENSOR_FREQUENCY = 5.0 [Hz]
SENSOR_STOP
AD_STOP
USER_START
USER_DEFINED_OXIDIZER = viscum-album
USER_STOP
"""


def test_all_that_the_standard_has_may_be_there(tmp_path):
    found = read_acm(saved(tmp_path, ACM))
    assert found.frame.mass == 10.0 and found.frame.moments == pytest.approx([2.0, 3.0, 4.0])
    assert found.angular_velocity == pytest.approx(np.tile(np.radians(RATES), (4, 1)), abs=1e-15)
    for count in ("+7", "007"):  # integers by 6.8.3
        text = ACM.replace("NUMBER_STATES = 7\nATT_TYPE", f"NUMBER_STATES = {count}\nATT_TYPE")
        assert len(read_acm(saved(tmp_path, text))) == 4


def test_every_keyword_of_each_table_is_known():
    """Those that the message above has, and each of a few that exclude one another."""
    explain_acm, explain_apm = ACM_TABLE.explain_keyword, APM_TABLE.explain_keyword
    assert not explain_acm("MAN", "TARGET_ATTITUDE") and not explain_acm("MAN", "MAN_END_TIME")
    assert not explain_apm("SPIN", "NUTATION_VEL") and not explain_apm("MAN", "MAN_TOR_Z")
    assert explain_acm("PHYS", "USER_DEFINED_X") and explain_apm("MAN", "MAN_TOR_1")
    assert set(APM_TABLE.blocks) == {"", "QUAT", "EULER", "ANGVEL", "SPIN", "INERTIA", "MAN"}


@pytest.mark.parametrize(("change", "words"), [
    (("WET_MASS = 10", "WETT_MASS = 10"), r"line 45: unknown keyword 'WETT_MASS'; did you mean WET_MASS\?"),
    (("WET_MASS = 10", "WET_MASS 10"), "line 45: must be keyword = value here; got 'WET_MASS 10 .kg.'"),
    (("TIME_SYSTEM = UTC", "TIMESYSTEM = UTC"), r"unknown keyword 'TIMESYSTEM'; did you mean TIME_SYSTEM\?"),
    (("DRY_MASS =", "WET_MASS = 1 [kg]\nDRY_MASS ="), "WET_MASS is there already, in line 45, and one of"),
    (("PHYS_START", "PHYSICS_START"), r"line 43: unknown block 'PHYSICS_START'; did you mean PHYS_START\?"),
    (("PHYS_STOP\n", ""), "line 43: PHYS_START has no PHYS_STOP"),
    (("MAN_PURPOSE =", "WHY ="), "unknown keyword 'WHY'; known here are MAN_ID, "),
    (("USER_DEFINED_OX", "OX"), "unknown keyword 'OXIDIZER'; "),
    (("NUMBER_STATES = 7\nATT", "NUMBER_STATES = 4\nATT"), "line 35: NUMBER_STATES must be how many numbers .* 7; got"),
    (("RATE_TYPE = ANGVEL\n", ""), "QUATERNION with RATE_TYPE NONE needs 4 numbers after the time; got 7"),
    (("RATE_TYPE = ANGVEL", "RATE_TYPE = EULER_RATE"), "the derivative of QUATERNION to be read here; got EULER_RATE"),
    (("1.5 -2.0 0.5\n1.0", "1.5 -2.0 0.5\n1.0 7"), "line 39: must be an epoch and 7 numbers, as in the first line"),
    (("1.5 -2.0 0.5\n1.0", "1.5 -2.0 0.5\none"), "line 39: the epoch must be a number in decimal digits"),
    (("1.5 -2.0 0.5\n1.0", "1.5 -2.0 O.5\n1.0"), "line 38: number 7 of the 7 must be a number .* got 'O.5'"),
    (("ATT_TYPE = QUATERNION\n", "ATT_TYPE = EULER_ANGLES\nEULER_ROT_SEQ = ZYX\n"), "needs 6 numbers after the time"),
])  # fmt: skip
def test_what_would_be_lost_without_a_word_is_refused(tmp_path, change, words):
    assert change[0] in ACM
    with pytest.raises(FormatError, match=words) as caught:
        read_acm(saved(tmp_path, ACM.replace(*change, 1)))
    assert len(caught.value.args) == 1


def test_rates_of_an_acm_are_along_frame_b(tmp_path):
    """Table 5-4, RATE_TYPE. From body to space it is the frame of space, against the body."""
    row = " ".join(map(repr, [*TURN.inv().as_quat().tolist(), *(-TURN.apply(RATES)).tolist()]))
    text = ACM.replace(ROWS, f"0.0 {row}\n1.0 {row}\n")
    text = text.replace("A = EME2000\nREF_FRAME_B = SC_BODY_1", "A = SC_BODY_1\nREF_FRAME_B = EME2000", 1)
    found = read_acm(saved(tmp_path, text))
    assert rotation.angle_between(found.attitude[0], rotation.from_scipy(TURN)) < 1e-14
    assert found.angular_velocity[0] == pytest.approx(np.radians(RATES), abs=1e-15)


XML = """<?xml version="1.0" encoding="UTF-8"?>
<apm id="CCSDS_APM_VERS" version="2.0"><header><ORIGINATOR>X</ORIGINATOR></header><body><segment><metadata>
<OBJECT_NAME>SAT</OBJECT_NAME><OBJECT_ID>1</OBJECT_ID><TIME_SYSTEM>UTC</TIME_SYSTEM></metadata><data>
<EPOCH>2008-04-07T00:00:00.0</EPOCH><quaternionState><REF_FRAME_A>EME2000</REF_FRAME_A>
<REF_FRAME_B>SC_BODY_1</REF_FRAME_B><quaternion><Q1>0</Q1><Q2>0</Q2><Q3>0</Q3><QC>1</QC></quaternion></quaternionState>
<inertia><INERTIA_REF_FRAME>SC_BODY_1</INERTIA_REF_FRAME><IXX units="kg*m**2">2</IXX><IYY units="kg*m**2">3</IYY>
<IZZ units="kg*m**2">4</IZZ></inertia></data></segment></body></apm>
"""


@pytest.mark.parametrize(("changes", "words"), [
    ((("<IZZ units", "<I_ZZ units"), ("</IZZ>", "</I_ZZ>")), "line 7: unknown keyword 'I_ZZ'; did you mean IZZ"),
    ((("<inertia>", "<inertial>"), ("</inertia>", "</inertial>")), "line 6: unknown element 'inertial'; did you mean"),
])  # fmt: skip
def test_elements_that_the_schema_does_not_have(tmp_path, changes, words):
    text = XML
    assert read_apm(saved(tmp_path, text)).frame.moments == pytest.approx([2.0, 3.0, 4.0])
    for change in changes:
        assert change[0] in text
        text = text.replace(*change)
    with pytest.raises(FormatError, match=words):
        read_apm(saved(tmp_path, text))


@pytest.mark.parametrize(("angle", "differs"), [(0.0099, False), (0.0101, True)])
def test_attitudes_of_one_instant_that_differ_by_more_than_rounding(tmp_path, angle, differs):
    assert LIMITS.max_angle == 0.01
    text, other = apm(), apm(turn=TURN * Rotation.from_rotvec([0.0, angle, 0.0]))
    block = other[other.index("QUAT_START") : other.index("ANGVEL_START")]
    found = read_apm(saved(tmp_path, text.replace("ANGVEL_START", f"{block}ANGVEL_START")))
    assert ("its attitudes differ by" in found.outcome.message) == differs


def test_text_keeps_its_brackets_and_numbers_lose_their_units(tmp_path):
    found = read_apm(saved(tmp_path, apm().replace("OBJECT_NAME = SAT", "OBJECT_NAME = SAT [7]")))
    assert found.source.labels.object_name == "SAT [7]"


def test_a_file_with_two_messages_is_refused(tmp_path):
    one = XML[XML.index("<apm") :]
    with pytest.raises(FormatError, match="has 2 APMs in it"):
        read_apm(saved(tmp_path, f"<ndm>{one}{one}</ndm>"))
