"""What CCSDS attitude messages may not say is refused in one sentence, with the line where it is.

The rules are those of 504.0-B-2: 3.2.4 for an APM, 4.2.4 for an AEM, 5.3.4 to 5.3.6 for an ACM.
"""

import numpy as np
import pytest

from polhode.cli.main import main
from polhode.errors import FormatError, InvalidInput
from polhode.formats.labels import AttitudeLabels
from polhode.spacecraft.formats.adm_state import LIMITS, read_acm, read_apm
from polhode.spacecraft.formats.aem import write_aem
from polhode.spacecraft.formats.aem_reading import read_aem
from spacecraft.aem_specimens import message
from spacecraft.test_attitude_messages import ACM, RATES, TURN, XML, apm, saved

AEM = message("QUATERNION", "0 0 0 1")
AEM_XML = """<aem id="CCSDS_AEM_VERS" version="2.0"><header><ORIGINATOR>X</ORIGINATOR></header><body><segment><metadata>
<OBJECT_NAME>SAT</OBJECT_NAME><OBJECT_ID>1</OBJECT_ID><REF_FRAME_A>EME2000</REF_FRAME_A>
<REF_FRAME_B>SC_BODY_1</REF_FRAME_B><TIME_SYSTEM>UTC</TIME_SYSTEM>
<START_TIME>2020-01-01T00:00:00</START_TIME><STOP_TIME>2020-01-01T00:00:00</STOP_TIME>
<ATTITUDE_TYPE>QUATERNION/ANGVEL</ATTITUDE_TYPE><ANGVEL_FRAME>SC_BODY_1</ANGVEL_FRAME></metadata><data>
<attitudeState><quaternionAngVel>
<EPOCH>2020-01-01T00:00:00</EPOCH>
<quaternion><Q1>0</Q1><Q2>0</Q2><Q3>0</Q3><QC>1</QC></quaternion>
<angVel><ANGVEL_X units="deg/s">1</ANGVEL_X>
<ANGVEL_Y units="deg/s">2</ANGVEL_Y><ANGVEL_Z units="deg/s">3</ANGVEL_Z></angVel>
</quaternionAngVel></attitudeState></data></segment></body></aem>
"""
SYSTEMS = "must be one of UTC, TAI, TT, TDB, TCB, TCG, GPS to be read here; got 'UT1'. Check the file."


def refusal(tmp_path, read, text, *change):
    """Return what is said of a file, less its name, once the text is changed in one place."""
    if change:
        assert change[0] in text
        text = text.replace(*change, 1)
    path = saved(tmp_path, text)
    with pytest.raises(FormatError) as caught:
        read(path)
    said = str(caught.value)
    assert said.startswith(str(path)) and said.count(str(path)) == 1
    return said.removeprefix(str(path)).lstrip(", ")


@pytest.mark.parametrize(("read", "text", "line"), [
    (read_apm, apm(), 6), (read_acm, ACM, 19), (read_aem, AEM, 9), (read_apm, XML, 3), (read_aem, AEM_XML, 3),
])  # fmt: skip
def test_another_time_system_is_refused_once(tmp_path, read, text, line):
    old = "TIME_SYSTEM>UTC" if text.startswith("<") else "TIME_SYSTEM = UTC"
    said = refusal(tmp_path, read, text, old, old.replace("UTC", "UT1"))
    assert said == f"line {line}: TIME_SYSTEM {SYSTEMS}"


@pytest.mark.parametrize(("read", "text", "missing", "said"), [
    (read_apm, apm(), "EPOCH = 2026-03-01T12:00:00\n", "line 1: EPOCH is missing. Check the file."),
    (read_acm, ACM, "EPOCH_TZERO = 2026-03-01T12:00:00\n", "line 1: EPOCH_TZERO is missing. Check the file."),
    (read_apm, XML, "<EPOCH>2008-04-07T00:00:00.0</EPOCH>", "line 2: EPOCH is missing. Check the file."),
    (read_apm, apm(), "TIME_SYSTEM = UTC\n", "line 1: TIME_SYSTEM is missing. Check the file."),
    (read_aem, AEM_XML, "<EPOCH>2020-01-01T00:00:00</EPOCH>\n",
     "line 6: EPOCH is missing in this block attitudeState. Check the file."),
])  # fmt: skip
def test_an_epoch_that_is_missing(tmp_path, read, text, missing, said):
    assert refusal(tmp_path, read, text, missing, "") == said


def test_import_says_what_an_aem_in_xml_is_without(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    saved(tmp_path, AEM_XML.replace("<EPOCH>2020-01-01T00:00:00</EPOCH>\n", ""), "sat.xml")
    with pytest.raises(SystemExit):
        main(["import", "sat.xml", "--out", "sat.nc"])
    said = " ".join(capsys.readouterr().err.split())
    assert "sat.xml, line 6: EPOCH is missing in this block attitudeState. Check the file." in said


def old_in_xml(rates):
    """Return an AEM of version 1.0 with rates under the one name that all have there."""
    turns = "".join(f'<rotation{k} rate="{x}_Rate" units="deg/s">{k}</rotation{k}>' for k, x in enumerate("XYZ", 1))
    text = AEM_XML.replace('version="2.0"', 'version="1.0"').replace("QUATERNION/ANGVEL", rates)
    text = text.replace("<ANGVEL_FRAME>SC_BODY_1</ANGVEL_FRAME>", "<ATTITUDE_DIR>A2B</ATTITUDE_DIR>"
                        "<QUATERNION_TYPE>LAST</QUATERNION_TYPE><RATE_FRAME>REF_FRAME_B</RATE_FRAME>")  # fmt: skip
    head, tail = text.split("<angVel>")
    return f"{head}<rotationRates>{turns}</rotationRates>{tail[tail.index('</quaternionAngVel'):]}"


def test_numbers_of_an_aem_that_its_type_does_not_have(tmp_path):
    """In keyword = value form lines with more numbers than the type has are refused too."""
    said = refusal(tmp_path, read_aem, AEM_XML, "QUATERNION/ANGVEL", "QUATERNION")
    assert said == "line 9: ANGVEL_X must not be there, as ATTITUDE_TYPE is QUATERNION. Check the file."
    said = refusal(tmp_path, read_aem, AEM_XML, "</quaternion>", "</quaternion><EXTRA>1</EXTRA>")
    assert said == "line 8: EXTRA must not be there, as ATTITUDE_TYPE is QUATERNION/ANGVEL. Check the file."
    assert refusal(tmp_path, read_aem, AEM, "0 0 0 1", "0 0 0 1 1 2 3").startswith("line 15: must be an epoch and 4")
    for text in (AEM_XML, old_in_xml("QUATERNION/RATE")):
        rates = read_aem(saved(tmp_path, text)).angular_velocity[0]
        assert np.degrees(rates) == pytest.approx([1.0, 2.0, 3.0])
    said = refusal(tmp_path, read_aem, old_in_xml("QUATERNION"))
    assert said.startswith("line 9: ANGLE_1_DOT must not be there, as ATTITUDE_TYPE is QUATERNION.")


@pytest.mark.parametrize(("read", "text", "old", "new", "said"), [
    (read_aem, AEM_XML, 'X units="deg/s"', 'X unit="rad/s"',
     "line 9: unknown attribute of ANGVEL_X 'unit'; did you mean units?"),
    (read_aem, AEM_XML, "<angVel>", '<angVel unit="rad/s">', "line 9: unknown attribute of angVel 'unit'; did you"),
    (read_apm, XML, 'IXX units="kg*m**2"', 'IXX scale="1000"', "line 6: unknown attribute of IXX 'scale'; known here"),
    (read_aem, AEM_XML, 'X units="deg/s"', 'X units="rad/s"', "line 9: ANGVEL_X must be in deg/s; got 'rad/s'."),
])  # fmt: skip
def test_attributes_that_numbers_do_not_have(tmp_path, read, text, old, new, said):
    assert refusal(tmp_path, read, text, old, new).startswith(said)


AGAIN = "epochs must ascend, without repetition; this one does not come after the one before. Check the file."
TOO_LARGE = "gives a rate, an angular momentum or an energy too large for numbers. Check the file."


@pytest.mark.parametrize(("old", "new", "said"), [
    ("\n2.0 ", "\n0.5 ", f"line 40: {AGAIN}"),
    ("\n2.0 ", "\n1.0 ", f"line 40: {AGAIN}"),
    ("\n2.0 ", "\n2026-03-01T12:00:01 ", f"line 40: {AGAIN}"),
    ("-2.0 0.5\n2.0", "-2.0 1e308\n2.0", f"line 39: {TOO_LARGE}"),
    ("-2.0 0.5\n2.0", "-2.0 0.5\n2.0 1", "line 40: must be an epoch and 7 numbers, as in the first line; got"),
    ("START_TIME = 0.0", "START_TIME = 4.0", "line 23: STOP_TIME must not lie before START_TIME; got 3.0, and 4.0"),
    ("STOP_TIME = 3.0", "STOP_TIME = 2026-03-01T11:59:59", "line 23: STOP_TIME must not lie before START_TIME; got"),
    ("START_TIME = 0.0", "START_TIME = yesterday", "line 22: START_TIME must be a number in decimal digits; got 'yest"),
    ("START_TIME = 0.0", "START_TIME = 2026-03-01T25:00:00", "line 22: START_TIME has no such time of day in UTC; got"),
    ("START_TIME = 0.0", "START_TIME = 0.0 [min]", "line 22: START_TIME must be in s; got 'min'."),
])  # fmt: skip
def test_times_and_rates_of_an_acm(tmp_path, old, new, said):
    assert refusal(tmp_path, read_acm, ACM, old, new).startswith(said)


@pytest.mark.parametrize("start", ["0.0 [s]", "2026-03-01T12:00:00Z", "-1e3", "3"])
def test_spans_of_an_acm_that_may_be(tmp_path, start):
    assert len(read_acm(saved(tmp_path, ACM.replace("START_TIME = 0.0", f"START_TIME = {start}"))).times) == 4


def test_the_line_of_an_acm_that_is_no_rotation(tmp_path):
    row = ACM.split("\n")[39].split()
    said = refusal(tmp_path, read_acm, ACM, f"2.0 {row[1]}", "2.0 9.5")
    assert said.startswith("line 40: must be a quaternion of unit length; got one of length 9.5")


def test_rates_of_an_apm_that_are_too_large(tmp_path):
    inertia = "INERTIA_START\nINERTIA_REF_FRAME = SC_BODY_1\nIXX = 2000\nIYY = 3000\nIZZ = 4000\nINERTIA_STOP\n"
    said = refusal(tmp_path, read_apm, apm(rates=(1e308, 0.0, 0.0)) + inertia)
    assert said == f"line 16: {TOO_LARGE}"


@pytest.mark.parametrize(("read", "text"), [(read_apm, apm()), (read_acm, ACM)])
def test_a_time_system_in_small_letters(tmp_path, read, text):
    """Its leap seconds count as those of UTC do."""
    labels = read(saved(tmp_path, text.replace("= UTC", "= utc"))).source.labels
    assert (labels.epoch, labels.time_system) == ("2026-03-01T12:00:00", "UTC")


INERTIA = """INERTIA_START
INERTIA_REF_FRAME = SC_BODY_1
IXX = 2 [kg*m**2]
IYY = 3 [kg*m**2]
IZZ = 4 [kg*m**2]
INERTIA_STOP
"""
SPIN = """SPIN_START
REF_FRAME_A = EME2000
REF_FRAME_B = SC_BODY_1
SPIN_ALPHA = 10
SPIN_DELTA = 20
SPIN_ANGLE = 30
SPIN_ANGLE_VEL = 4
SPIN_STOP
"""
HEAD = apm()[: apm().index("QUAT_START")]
ANGVEL = apm()[apm().index("ANGVEL_START") :]


@pytest.mark.parametrize(("read", "text", "line"), [
    (read_apm, apm(), 10), (read_acm, ACM, 34), (read_aem, AEM, 8), (read_apm, XML, 5), (read_aem, AEM_XML, 3),
])  # fmt: skip
def test_an_attitude_between_a_frame_and_itself(tmp_path, read, text, line):
    tag = "REF_FRAME_B>" if text.startswith("<") else "REF_FRAME_B = "
    said = refusal(tmp_path, read, text, f"{tag}SC_BODY_1", f"{tag}eme2000")
    rule = "must be another frame than REF_FRAME_A; got 'eme2000' for both"
    assert said == f"line {line}: REF_FRAME_B {rule}. Check the file."


def test_an_aem_between_a_frame_and_itself_is_not_written(tmp_path):
    labels = AttitudeLabels(reference_frame="EME2000", body_frame="eme2000")
    with pytest.raises(InvalidInput, match="`reference_frame` and `body_frame` must be two frames; got 'eme2000' for"):
        write_aem(read_aem(saved(tmp_path, AEM)), tmp_path / "motion.aem", labels)


@pytest.mark.parametrize("name", ["PHYS", "AD", "USER"])
def test_blocks_of_which_an_acm_has_one(tmp_path, name):
    """504.0-B-2, table 5-1."""
    begin, end = ACM.index(f"{name}_START"), ACM.index(f"{name}_STOP\n") + len(f"{name}_STOP\n")
    said = refusal(tmp_path, read_acm, ACM[:end] + ACM[begin:])
    first, again = (ACM[:place].count("\n") + 1 for place in (begin, end))
    assert said == (f"line {again}: {name}_START is there already, in line {first}, and an ACM has one. Leave out one.")


@pytest.mark.parametrize(("read", "text", "old", "line", "said"), [
    (read_apm, apm() + INERTIA, "IXX = 2 [kg*m**2]\n", 24, "IXX is missing in this block INERTIA. Check the file."),
    (read_acm, ACM, "IXX = 2 [kg*m**2]\n", 43, "IXX is missing in this block PHYS. Check the file."),
    (read_apm, XML, '<IXX units="kg*m**2">2</IXX>', 6, "IXX is missing in this block INERTIA. Check the file."),
    (read_apm, apm() + INERTIA, "IZZ = 4 [kg*m**2]\n", 24, "IZZ is missing in this block INERTIA. Check the file."),
])  # fmt: skip
def test_inertias_in_part(tmp_path, read, text, old, line, said):
    assert refusal(tmp_path, read, text, old, "") == f"line {line}: {said}"


@pytest.mark.parametrize(("more", "said"), [
    ("NUTATION_PER = 70\n", "line 8: NUTATION is missing in this block SPIN. Check the file."),
    ("NUTATION = 1\nNUTATION_PHASE = 5\n", "line 8: NUTATION_PER is missing in this block SPIN. Check the file."),
    ("MOMENTUM_DELTA = 70\n", "line 8: MOMENTUM_ALPHA is missing in this block SPIN. Check the file."),
    ("NUTATION = 1\nNUTATION_VEL = 5\n",
     "line 16: NUTATION_VEL must not be with NUTATION, as a block SPIN gives the nutation in one of two ways."),
])  # fmt: skip
def test_nutations_in_part(tmp_path, more, said):
    """504.0-B-2, 3.2.4.1 e and 3.2.4.6."""
    assert len(read_apm(saved(tmp_path, HEAD + SPIN)).times) == 1
    assert refusal(tmp_path, read_apm, HEAD + SPIN, "SPIN_STOP", f"{more}SPIN_STOP").startswith(said)


def test_derivatives_in_part_are_left_out_with_a_word(tmp_path):
    """Each of them is optional by itself in 504.0-B-2, table 3-3."""
    text = apm()[: apm().index("ANGVEL_START")]
    text = text.replace("QUAT_STOP", "Q1_DOT = 0.1\nQ3_DOT = 0 [1/s]\nQUAT_STOP")
    found = read_apm(saved(tmp_path, text))
    assert found.angular_velocity is None
    assert found.outcome.message == "Q1_DOT, Q3_DOT of its block QUAT left out, as it has no Q2_DOT, QC_DOT"
    frames = "EULER_START\nREF_FRAME_A = EME2000\nREF_FRAME_B = SC_BODY_1\nEULER_ROT_SEQ = ZXZ\n"
    text = f"{HEAD}{frames}ANGLE_1 = 1\nANGLE_2 = 2\nANGLE_3 = 3\nANGLE_2_DOT = 4\nEULER_STOP\n"
    said = read_apm(saved(tmp_path, text)).outcome.message
    assert said == "ANGLE_2_DOT of its block EULER left out, as it has no ANGLE_1_DOT, ANGLE_3_DOT"


@pytest.mark.parametrize(("factor", "differs"), [(1.0, False), (1.0099, False), (1.0103, True), (-1.0, True)])
def test_blocks_of_an_apm_that_contradict_one_another_are_not_passed_over(tmp_path, factor, differs):
    """An APM may repeat any block (504.0-B-2, 3.2.4.4), and all are of one instant: the first is taken, with a word."""
    assert LIMITS.max_relative == 0.01
    rates = apm("EME2000", factor * TURN.apply(RATES))  # along the other axes
    text = apm() + rates[rates.index("ANGVEL_START") :] + INERTIA
    text += INERTIA.replace("IZZ = 4", f"IZZ = {4 * abs(factor)!r}")
    found = read_apm(saved(tmp_path, text))
    assert found.angular_velocity[0] == pytest.approx(np.radians(RATES), abs=1e-15)
    assert found.frame.moments == pytest.approx([2.0, 3.0, 4.0])
    apart = abs(factor - 1.0) * np.linalg.norm(np.radians(RATES))
    rated = f"its angular velocities differ by {apart:.3g} rad/s, and the first is taken"
    assert (rated in found.outcome.message) == differs
    assert ("its blocks of inertia differ, and the first is taken" in found.outcome.message) == (abs(factor) > 1.01)


def test_blocks_of_an_apm_about_other_frames(tmp_path):
    wheel = ANGVEL.replace("SC_BODY_1", "RW_1")
    along = ANGVEL.replace("EME2000", "LVLH")
    text = apm() + wheel + along + INERTIA.replace("SC_BODY_1", "IMU_FRAME_1") + INERTIA
    found = read_apm(saved(tmp_path, text))
    assert found.frame.moments == pytest.approx([2.0, 3.0, 4.0])
    assert found.outcome.message == ("it has the angular velocity of RW_1 against EME2000 too, which is left out; "
                                     "it has the angular velocity of SC_BODY_1 against LVLH too, which is left out")
