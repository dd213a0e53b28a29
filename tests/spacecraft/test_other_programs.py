"""Files in the shapes that other programs write: each is recognised, imported, compared and fitted.

Files are written here by SciPy and by format strings in the shapes of the programs' own documentation and sources,
which each case cites; messages of CCSDS are those of the standard and of Orekit's tests.
"""

import json
from pathlib import Path

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import polhode as ph
from polhode import rotation, spacecraft
from polhode.cli.main import main
from polhode.errors import FormatError, InvalidInput
from polhode.formats.form import Kernels
from polhode.formats.form_registry import forms
from polhode.measuring.attitudes import attitude_fit
from polhode.measuring.throws import study as throws
from polhode.spacecraft.formats.stk_attitude import read_stk
from polhode.studies.sources import detect_kind

MOMENTS, RATES = (1.0, 2.0, 3.0), (0.3, 0.9, 0.5)
SPEC = """[body]
moments = ["1 kg*m^2", "2 kg*m^2", "3 kg*m^2"]
[spin]
angular_velocity = ["0.3 rad/s", "0.9 rad/s", "0.5 rad/s"]
[time]
until = "12 s"
[export]
epoch = "2026-03-01T12:00:00"
"""
TIMES = np.arange(0.0, 12.0, 0.05)
MOTION = ph.FreeMotion(MOMENTS, angular_velocity=RATES)
QUATERNIONS = np.asarray(MOTION.attitude(TIMES))
TURNS = Rotation.from_quat(QUATERNIONS[:, [1, 2, 3, 0]])
OMEGA = np.asarray(MOTION.angular_velocity(TIMES))


def lines(*columns, form="{:.17g}", sign=","):
    rows = np.column_stack(columns)
    return "".join(sign.join(form.format(x) for x in row) + "\n" for row in rows)


def stk(kind, columns, keywords=()):
    """The keywords in the order of STK Help, attitude file format (*.a)."""
    head = ["stk.v.11.0", "# WrittenBy    a simulator", "BEGIN Attitude", f"NumberOfAttitudePoints {len(TIMES)}",
            "BlockingFactor 20", "InterpolationOrder 1", "CentralBody Earth",
            "ScenarioEpoch 1 Mar 2026 12:00:00.000000", "CoordinateAxes J2000", *keywords, kind, ""]  # fmt: skip
    return "\n".join(head) + "\n" + lines(TIMES, *columns, sign=" ") + "\nEND Attitude\n"


def ulog2csv():
    """pyulog 1.0, ulog2csv of vehicle_attitude; Hamilton quaternions, scalar first, microseconds since boot."""
    head = "timestamp,timestamp_sample,q[0],q[1],q[2],q[3],delta_q_reset[0],quat_reset_counter\n"
    stamps = [f"{68_497_369 + round(1e6 * t)}" for t in TIMES]
    return head + "".join(f"{stamp},{stamp},{','.join(f'{x:.9g}' for x in row)},1,2\n"
                          for stamp, row in zip(stamps, QUATERNIONS, strict=True))  # fmt: skip


def mavlogdump():
    """pymavlink, mavlogdump.py --format csv --types ATT: degrees, roll, pitch and yaw, to a hundredth."""
    yaw, pitch, roll = TURNS.as_euler("ZYX", degrees=True).T
    yaw = yaw % 360.0
    head = "timestamp,TimeUS,DesRoll,Roll,DesPitch,Pitch,DesYaw,Yaw,ErrRP,ErrYaw,AEKF\n"
    return head + "".join(
        f"{1772366400 + t:.8f},{round(1e6 * t)},0,{a:.2f},0,{b:.2f},0,{c:.2f},0.01,0.02,3\n"
        for t, a, b, c in zip(TIMES, roll, pitch, yaw, strict=True)
    )


def rostopic(prefix="field.", stamp="ns"):
    """``rostopic echo -b … -p /imu``; with another prefix and two columns of stamps, rosbag_to_csv and bagpy."""
    names = [f"orientation.{x}" for x in "xyzw"] + [f"angular_velocity.{x}" for x in "xyz"]
    clock = ["header.stamp"] if stamp == "ns" else ["header.stamp.secs", "header.stamp.nsecs"]
    head = ",".join(["%time", *(prefix + name for name in ["header.seq", *clock, "header.frame_id", *names])])
    rows = []
    for k, t in enumerate(TIMES):
        seconds, rest = divmod(1_772_366_400_123_456_789 + round(1e9 * t), 10**9)
        stamps = f"{seconds * 10**9 + rest}" if stamp == "ns" else f"{seconds},{rest}"
        numbers = ",".join(f"{x:.17g}" for x in (*QUATERNIONS[k, [1, 2, 3, 0]], *OMEGA[k]))
        rows.append(f"{seconds * 10**9 + rest + 1000},{k},{stamps},imu,{numbers}")
    return "\n".join([head, *rows]) + "\n"


def basilisk():
    """A recorder of scStateOutMsg with pandas: times() in ns, sigma_BN and omega_BN_B."""
    names = ["time_ns", *(f"sigma_BN_{k}" for k in "123"), *(f"omega_BN_B_{k}" for k in "123")]
    rows = lines(TURNS.as_mrp(), OMEGA).splitlines()
    stamps = (f"{round(1e9 * t)},{row}\n" for t, row in zip(TIMES, rows, strict=True))
    return ",".join(names) + "\n" + "".join(stamps)


def gmat(clock="ElapsedSecs", times=TIMES):
    """GMAT's ReportFile: columns of fixed width, quaternions with their scalar last."""
    names = [f"Sat.{name}" for name in (clock, "Q1", "Q2", "Q3", "Q4")]
    head = "".join(f"{name:<26}" for name in names)
    rows = np.column_stack([times, QUATERNIONS[:, [1, 2, 3, 0]]])
    return head + "\n" + "".join("".join(f"{x:<26.16g}" for x in row) + "\n" for row in rows)


def gmat_dates():
    """GMAT's ReportFile with UTCGregorian, whose dates have blanks: 01 Mar 2026 12:00:00.000, to milliseconds."""
    names = "".join(f"Sat.{name:<22}" for name in ("UTCGregorian", "Q1", "Q2", "Q3", "Q4"))
    rows = zip(TIMES, QUATERNIONS[:, [1, 2, 3, 0]], strict=True)
    return names + "\n" + "".join(f"01 Mar 2026 12:00:{t:06.3f}   {'   '.join(f'{x:<22.16g}' for x in q)}\n"
                                  for t, q in rows)  # fmt: skip


YPR = TURNS.as_euler("zyx", degrees=True)
CASES = {
    "stk quaternions": ("sat.a", stk("AttitudeTimeQuaternions", [QUATERNIONS[:, [1, 2, 3, 0]]]), "stk", 1e-12),
    "stk scalar first": ("sat.a", stk("AttitudeTimeQuatScalarFirst", [QUATERNIONS]), "stk", 1e-12),
    "stk with rates": ("sat.a", stk("AttitudeTimeQuatAngVels", [QUATERNIONS[:, [1, 2, 3, 0]], np.degrees(OMEGA)]),
                       "stk", 1e-12),
    "stk euler": ("sat.a", stk("AttitudeTimeEulerAngles", [TURNS.as_euler("ZXY", degrees=True)], ["Sequence 312"]),
                  "stk", 1e-12),
    "stk dcm": ("sat.a", stk("AttitudeTimeDCM", [TURNS.inv().as_matrix().reshape(-1, 9)]), "stk", 1e-12),
    "stk dcm with rates": ("sat.a", stk("AttitudeTimeDCMAngVels", [TURNS.inv().as_matrix().reshape(-1, 9),
                                                                   np.degrees(OMEGA)]), "stk", 1e-12),
    "stk ypr": ("sat.a", stk("AttitudeTimeYPRAngles", [YPR], ["Sequence 321"]), "stk", 1e-12),
    "px4": ("log_vehicle_attitude_0.csv", ulog2csv(), "px4", 1e-8),
    "ardupilot": ("att.csv", mavlogdump(), "ardupilot", 5e-4),
    "ros": ("imu.csv", rostopic(), "ros", 1e-8),
    "ros two stamps": ("imu.csv", rostopic(".", "s"), "ros", 1e-8),
    "basilisk": ("states.csv", basilisk(), "basilisk", 1e-12),
    "gmat": ("ReportFile1.txt", gmat(), "gmat", 1e-12),
    "gmat dates": ("ReportFile2.txt", gmat_dates(), "gmat", 1e-12),
    "42": ("qbn.42", lines(QUATERNIONS[:, [1, 2, 3, 0]], form="{:e}", sign=" "), "42", 3e-6),
}  # fmt: skip


@pytest.fixture
def folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "free.toml").write_text(SPEC)
    (tmp_path / "time.42").write_text("".join(f"{t:f}\n" for t in TIMES))
    (tmp_path / "wbn.42").write_text(lines(OMEGA, form="{:e}", sign=" "))
    return tmp_path


def values_of(capsys, *arguments):
    with pytest.raises(SystemExit) as end:
        main([*map(str, arguments), "--json"])
    out, err = capsys.readouterr()
    assert not end.value.code, err
    return json.loads(out)


FITTED = ("px4", "ardupilot", "42")  # to the end; of the others the attitudes are compared


class Arrived(Exception):
    """Stops a fit where it begins, with the attitudes that reached it."""

    def __init__(self, attitude):
        self.attitude = attitude


def stop_at(times, attitude, *rest):
    raise Arrived(attitude)


@pytest.mark.long_after(6)
@pytest.mark.long_cases("px4", "ardupilot", "42")
@pytest.mark.parametrize("case", CASES)
def test_each_goes_through_the_whole_chain(folder, capsys, monkeypatch, case):
    """Recognised without options, imported, compared with the exact motion, and fitted."""
    name, text, kind, precision = CASES[case]
    (folder / name).write_text(text)
    assert detect_kind(folder / name) == kind and not forms()[kind].write
    found = values_of(capsys, "import", name)
    assert found["samples"] == len(TIMES) and found["files"]
    compared = ph.compare("free.toml", name, offset="start")
    assert compared.comparison.largest < precision
    if case not in FITTED:
        monkeypatch.setattr(throws, "fit_attitude", stop_at)
        with pytest.raises(Arrived) as arrived:
            ph.fit(name)
        assert rotation.angle_between(arrived.value.attitude, QUATERNIONS).max() < precision
        return
    fit = ph.fit(name)
    tolerance = 1e-6 if precision < 1e-6 else 0.02
    assert np.asarray(fit.fit.ratios.value) == pytest.approx((1 / 3, 2 / 3), abs=tolerance)


def deviations(folder):
    """Return how many standard errors the ratios of moments are off, fitted to attitudes without noise."""
    name, text, _, _ = CASES["stk quaternions"]
    (folder / name).write_text(text)
    ratios = ph.fit(name).fit.ratios
    return np.abs(ratios.value - np.array([1 / 3, 2 / 3])) / np.sqrt(np.diag(ratios.covariance))


@pytest.mark.sweep
def test_a_fit_of_computed_attitudes_is_no_more_confident_than_it_is_right(folder, monkeypatch):
    """A fit that ends short of the least sum, as such sums no longer fall at half of the digits, is too sure."""
    assert deviations(folder).max() < 3.0
    monkeypatch.setattr(attitude_fit, "take_last_steps", lambda system, x, *limits: (x + 1e-12, np.zeros(len(x))))
    assert deviations(folder).max() > 5.0


@pytest.mark.parametrize("case", CASES)
def test_a_wrong_convention_would_show(folder, case):
    """Read as the inverse, or in another order, each differs from the motion by more than a tenth of a radian."""
    name, text, kind, _ = CASES[case]
    (folder / name).write_text(text)
    attitude = np.asarray(forms()[kind].read(folder / name, Kernels()).attitude)
    for wrong in (rotation.conjugate(attitude), attitude[:, [1, 2, 3, 0]], attitude[:, [0, 2, 3, 1]]):
        assert rotation.angle_between(wrong, QUATERNIONS).max() > 0.1


def test_rates_of_each_agree_with_its_attitudes(folder):
    for case in ("stk with rates", "stk dcm with rates", "ros", "basilisk", "42"):
        name, text, kind, _ = CASES[case]
        (folder / name).write_text(text)
        velocity = forms()[kind].read(folder / name, Kernels()).angular_velocity
        assert np.asarray(velocity) == pytest.approx(OMEGA, abs=1e-6)


def test_epochs_align_clocks_without_being_told(folder, capsys):
    """STK's ScenarioEpoch is that of the spec; a date of GMAT's is a fixed number of days later than JD 2430000."""
    (folder / "sat.a").write_text(CASES["stk quaternions"][1])
    assert ph.compare("free.toml", "sat.a").comparison.largest < 1e-12
    days = 61100.5 + TIMES / 86400 - 29999.5  # MJD 61100.5 is 2026-03-01T12:00:00
    (folder / "report.txt").write_text(gmat("UTCModJulian", days))
    found = values_of(capsys, "compare", "free.toml", "report.txt")
    assert "by their epochs" in found["clocks"] or "both count from" in found["clocks"]
    assert found["angle"]["largest"] < 2e-5


def test_options_overrule_what_a_table_is_known_as(folder, capsys):
    (folder / "states.csv").write_text(basilisk())
    words = ["--time", "time_ns", "--mrp", "2,3,4", "--direction", "space-to-body"]
    found = values_of(capsys, "import", "states.csv", *words)
    assert "from space to body" in found["read_as"]["attitude"]


@pytest.mark.parametrize(("change", "words"), [
    (("END Attitude", ""), "has no END Attitude, so it is cut short"),
    ((f"NumberOfAttitudePoints {len(TIMES)}", "NumberOfAttitudePoints 7"), "NumberOfAttitudePoints is 7, and there"),
    (("AttitudeTimeQuaternions", "AttitudeTimeECFVector"), "AttitudeTimeECFVector is not read here"),
    (("AttitudeTimeQuaternions", "AttitudeTimeEulerAngles"), "must have 3 numbers after the time"),
    (("CentralBody Earth", "TimeFormat JDate"), "TimeFormat must be EpSec, UTCG or ISO-YMD"),
    (("1 Mar 2026", "31 Feb 2026"), "ScenarioEpoch has no such day"),
    (("AttitudeTimeQuaternions\n\n0 ", "AttitudeTimeQuaternions\n\n0 9"), "line 12: a quaternion must have length 1"),
])  # fmt: skip
def test_files_of_stk_that_are_wrong(folder, change, words):
    text = stk("AttitudeTimeQuaternions", [QUATERNIONS[:, [1, 2, 3, 0]]])
    assert change[0] in text
    (folder / "sat.a").write_text(text.replace(*change, 1))
    with pytest.raises(FormatError, match=words):
        ph.compare("free.toml", "sat.a")


def test_the_matrix_of_the_programs_own_help(folder):
    """STK Help, AttitudeTimeDCM Format (*.a) Example: its rows are the body's axes along the reference axes."""
    rows = np.array([[0.45959131992578, 0.65939233328195, 0.59496014106650],
                     [-0.09650521823583, -0.62885739983663, 0.77150833665228],
                     [0.88287176956914, -0.41199529303100, -0.22538260140960]])  # fmt: skip
    text = stk("AttitudeTimeDCM", [np.tile(rows.ravel(), (len(TIMES), 1))])
    (folder / "help.a").write_text(text)
    attitude = read_stk(folder / "help.a").attitude
    for row, axis in zip(rows, np.eye(3), strict=True):
        assert ph.rotation.rotate(attitude[0], axis) == pytest.approx(row, abs=1e-12)
    (folder / "mirror.a").write_text(stk("AttitudeTimeDCM", [np.tile((-rows).ravel(), (len(TIMES), 1))]))
    with pytest.raises(FormatError, match="line 12: the matrix is a reflection"):
        read_stk(folder / "mirror.a")


@pytest.mark.parametrize("quote", ["", '"'])
def test_dates_in_a_file_of_stk(folder, quote):
    rows = [f"{quote}1 Mar 2026 12:00:{t:06.3f}{quote} {' '.join(map(repr, q))}"
            for t, q in zip(TIMES, QUATERNIONS[:, [1, 2, 3, 0]].tolist(), strict=True)]  # fmt: skip
    text = stk("AttitudeTimeQuaternions", [QUATERNIONS], ["TimeFormat UTCG"])
    head = text[: text.index("AttitudeTimeQuaternions\n")]
    (folder / "sat.a").write_text(head + "AttitudeTimeQuaternions\n" + "\n".join(rows) + "\nEND Attitude\n")
    assert ph.compare("free.toml", "sat.a").comparison.largest < 1e-11


def test_a_quote_that_does_not_close_is_refused(folder):
    text = stk("AttitudeTimeQuaternions", [QUATERNIONS], ["NumberOfAttitudePoints 1", "TimeFormat UTCG"])
    head = text[: text.index("AttitudeTimeQuaternions\n")].replace("NumberOfAttitudePoints 240\n", "")
    (folder / "sat.a").write_text(head + 'AttitudeTimeQuaternions\n"1 Mar 2026 12:00:00.0 0 0 0 1\nEND Attitude\n')
    with pytest.raises(FormatError, match="line 12: must be a date"):
        ph.compare("free.toml", "sat.a")


@pytest.mark.long
def test_dates_between_blanks_are_columns_of_any_table(folder, capsys):
    """By options, and beside a column that was asked for already."""
    (folder / "report.txt").write_text(gmat_dates().replace("Sat.", "x"))
    words = ["--time", "xUTCGregorian", "--time-system", "UTC", "--quat", "xQ1,xQ2,xQ3,xQ4", "--order", "xyzw"]
    found = values_of(capsys, "compare", "free.toml", "report.txt", *words)
    assert found["angle"]["largest"] < 1e-12 and found["read_as"]["b"]["time"] == "column 1 'xUTCGregorian', dates"
    bare = gmat_dates().partition("\n")[2]
    (folder / "bare.txt").write_text(bare)
    words = ["--time", "1", "--time-system", "UTC", "--quat", "2,3,4,5", "--order", "xyzw"]
    assert values_of(capsys, "compare", "free.toml", "bare.txt", *words)["angle"]["largest"] < 1e-12


def test_axes_that_turn_are_said(folder, capsys):
    (folder / "sat.a").write_text(CASES["stk quaternions"][1].replace("CoordinateAxes J2000", "CoordinateAxes Fixed"))
    assert "relative to the axes Fixed" in values_of(capsys, "import", "sat.a")["notes"][0]


def test_42_needs_its_times(folder):
    (folder / "qbn.42").write_text(CASES["42"][1])
    (folder / "time.42").write_text("0\n1\n")
    with pytest.raises(FormatError, match=r"has 240 lines, and time\.42 has 2"):
        ph.compare("free.toml", "qbn.42")
    (folder / "time.42").unlink()
    with pytest.raises(InvalidInput, match=r"42 writes times into time\.42, which is not next to it"):
        ph.compare("free.toml", "qbn.42")


# ---------------------------------------------------------------- CCSDS

# Orekit's test file AEMExample13.xml, after the standard's schema of version 1.0: scalar first, from body to space
OLD_XML = """<?xml version="1.0" encoding="UTF-8"?>
<aem id="CCSDS_AEM_VERS" version="1.0">
  <header><CREATION_DATE>2021-04-15T13:31:24.0</CREATION_DATE><ORIGINATOR>CS GROUP</ORIGINATOR></header>
  <body><segment>
    <metadata>
      <OBJECT_NAME>OREKIT SAT</OBJECT_NAME><OBJECT_ID>2020-012A</OBJECT_ID><REF_FRAME_A>LVLH</REF_FRAME_A>
      <REF_FRAME_B>IMU_FRAME_1</REF_FRAME_B><ATTITUDE_DIR>B2A</ATTITUDE_DIR><TIME_SYSTEM>TAI</TIME_SYSTEM>
      <START_TIME>2021-04-15T13:31:20.0</START_TIME><STOP_TIME>2021-04-15T13:31:23.0</STOP_TIME>
      <ATTITUDE_TYPE>QUATERNION/DERIVATIVE</ATTITUDE_TYPE><QUATERNION_TYPE>FIRST</QUATERNION_TYPE>
    </metadata>
    <data>
      <attitudeState><quaternionDerivative><EPOCH>2021-04-15T13:31:20.0</EPOCH>
        <quaternion><QC>0.4886148886986714</QC><Q1>-0.40215690839288926</Q1>
          <Q2>0.5816278675112939</Q2><Q3>0.5111108835743206</Q3></quaternion>
        <quaternionRate><QC_DOT units="1/s">3.0077619996648645E-4</QC_DOT>
          <Q1_DOT units="1/s">2.5945771992435184E-4</Q1_DOT><Q2_DOT units="1/s">-2.8362061580605415E-4</Q2_DOT>
          <Q3_DOT units="1/s">2.393622263168597E-4</Q3_DOT></quaternionRate>
      </quaternionDerivative></attitudeState>
      <attitudeState><quaternionDerivative><EPOCH>2021-04-15T13:31:20.5</EPOCH>
        <quaternion><QC>0.4887649908329683</QC><Q1>-0.40202699245978285</Q1>
          <Q2>0.5814859890939396</Q2><Q3>0.5112309904116072</Q3></quaternion>
        <quaternionRate><QC_DOT units="1/s">3.0071481809516165E-4</QC_DOT>
          <Q1_DOT units="1/s">2.5950414011706777E-4</Q1_DOT><Q2_DOT units="1/s">-2.837152043818123E-4</Q2_DOT>
          <Q3_DOT units="1/s">2.3927581114550022E-4</Q3_DOT></quaternionRate>
      </quaternionDerivative></attitudeState>
    </data>
  </segment></body>
</aem>
"""


def test_an_aem_in_xml_of_version_1(tmp_path):
    """The attitude against SciPy; the derivative against the difference of the two attitudes, as Orekit wrote both."""
    (tmp_path / "old.xml").write_text(OLD_XML)
    found = spacecraft.read_aem(tmp_path / "old.xml")
    first = [-0.40215690839288926, 0.5816278675112939, 0.5111108835743206, 0.4886148886986714]
    wanted = Rotation.from_quat(first)  # from body to space, as ATTITUDE_DIR says: the frame's rotation is its inverse
    assert rotation.angle_between(found.attitude[0], rotation.from_scipy(wanted.inv())) < 1e-14
    turned = rotation.multiply(rotation.conjugate(found.attitude[0]), found.attitude[1])
    mean = found.angular_velocity.mean(axis=0)
    assert rotation.as_rotation_vector(turned) / 0.5 == pytest.approx(mean, abs=2e-6)
    assert found.times.tolist() == [0.0, 0.5] and found.source.labels.object_name == "OREKIT SAT"


NEW_STATES = {
    "QUATERNION": ("quaternionEphemeris", "<quaternion>{Q1}{Q2}{Q3}{QC}</quaternion>", ()),
    "QUATERNION/ANGVEL": ("quaternionAngVel", "<quaternion>{Q1}{Q2}{Q3}{QC}</quaternion><angVel>{w}</angVel>",
                          ("ANGVEL_FRAME",)),
    "EULER_ANGLE": ("eulerAngle", "{e}", ("EULER_ROT_SEQ",)),
}  # fmt: skip


@pytest.mark.parametrize("kind", NEW_STATES)
def test_an_aem_in_xml_of_version_2(tmp_path, kind):
    """Elements by the schema ndmxml-4.0.0-aem-2.0."""
    element, inside, more = NEW_STATES[kind]
    angles = TURNS.as_euler("ZYX", degrees=True)
    states = []
    for k in range(4):
        tags = {name: f"<{name}>{x!r}</{name}>" for name, x in zip(("QC", "Q1", "Q2", "Q3"), QUATERNIONS[k].tolist(),
                                                                  strict=True)}  # fmt: skip
        tags["w"] = "".join(f'<ANGVEL_{x} units="deg/s">{w!r}</ANGVEL_{x}>'
                            for x, w in zip("XYZ", np.degrees(OMEGA[k]).tolist(), strict=True))  # fmt: skip
        tags["e"] = "".join(f'<ANGLE_{i} units="deg">{a!r}</ANGLE_{i}>' for i, a in enumerate(angles[k].tolist(), 1))
        states.append(f"<attitudeState><{element}><EPOCH>2026-03-01T12:00:{TIMES[k]:06.3f}</EPOCH>"
                      f"{inside.format(**tags)}</{element}></attitudeState>")  # fmt: skip
    extra = {"ANGVEL_FRAME": "SC_BODY_1", "EULER_ROT_SEQ": "ZYX"}
    metadata = {"OBJECT_NAME": "BOX", "OBJECT_ID": "1", "REF_FRAME_A": "EME2000", "REF_FRAME_B": "SC_BODY_1",
                "TIME_SYSTEM": "UTC", "START_TIME": "2026-03-01T12:00:00", "STOP_TIME": "2026-03-01T12:00:12",
                "ATTITUDE_TYPE": kind} | {name: extra[name] for name in more}  # fmt: skip
    head = "".join(f"<{name}>{value}</{name}>" for name, value in metadata.items())
    text = ('<?xml version="1.0" encoding="UTF-8"?><ndm><aem id="CCSDS_AEM_VERS" version="2.0"><header><ORIGINATOR>X'
            f"</ORIGINATOR></header><body><segment><metadata>{head}</metadata><data>{''.join(states)}</data></segment>"
            "</body></aem></ndm>")  # fmt: skip
    (tmp_path / "new.xml").write_text(text)
    assert detect_kind(tmp_path / "new.xml") == "aem"
    found = spacecraft.read_aem(tmp_path / "new.xml")
    assert rotation.angle_between(found.attitude, QUATERNIONS[:4]).max() < 1e-14
    assert found.times == pytest.approx(TIMES[:4], abs=1e-15)
    if "ANGVEL" in kind:
        assert found.angular_velocity == pytest.approx(OMEGA[:4], abs=1e-15)


@pytest.mark.parametrize(("change", "words"), [
    (("<QC>0.4886148886986714</QC>", ""), "line 12: QC is missing in this block attitudeState"),
    (("<QC>0.4886148886986714</QC>", "<QC>half</QC>"), "line 13: QC must be a number"),
    (('<QC_DOT units="1/s">3.0077', '<QC_DOT units="rad/s">3.0077'), "line 15: QC_DOT must be in 1/s; got 'rad/s'"),
    (("</aem>", ""), "is not well-formed XML"),
    (('version="1.0">\n  <header>', 'version="3.0">\n  <header>'), "line 2: CCSDS_AEM_VERS must be 1.0 or 2.0"),
    (("<OBJECT_ID>2020-012A</OBJECT_ID>", ""), "OBJECT_ID is missing in this block META"),
    (("<aem ", '<!DOCTYPE aem [<!ENTITY a "b">]><aem '), "has a DOCTYPE"),
    (("13:31:20.5</EPOCH>", "13:31:19.5</EPOCH>"), "epochs must ascend"),
    (("13:31:20.5</EPOCH>", "25:31:20.5</EPOCH>"), "the epoch has no such time of day"),
])  # fmt: skip
def test_messages_in_xml_that_are_wrong(tmp_path, change, words):
    assert change[0] in OLD_XML
    (tmp_path / "wrong.xml").write_text(OLD_XML.replace(*change, 1))
    with pytest.raises(FormatError, match=words):
        spacecraft.read_aem(tmp_path / "wrong.xml")


# Orekit's APMExample12.txt, after the example of the standard, 504.0-B-2, figure 3-9
APM = """CCSDS_APM_VERS = 2.0
CREATION_DATE  = 2023-02-05T12:00:00
ORIGINATOR  = GSFC
COMMENT          SPINNING
OBJECT_NAME    = MMS1
OBJECT_ID      = 2015-011A
CENTER_NAME    = EARTH
TIME_SYSTEM    = TAI
EPOCH          = 2023-01-01T00:00:00.0000
EULER_START
REF_FRAME_A          = EME2000
REF_FRAME_B          = SC_BODY_1
EULER_ROT_SEQ        = ZXZ
ANGLE_1              = 10 [deg]
ANGLE_2              = 20 [deg]
ANGLE_3              = 0 [deg]
EULER_STOP
SPIN_START
REF_FRAME_A          = EME2000
REF_FRAME_B          = SC_BODY_1
SPIN_ALPHA           = -80 [deg]
SPIN_DELTA           = 70 [deg]
SPIN_ANGLE           = 0 [deg]
SPIN_ANGLE_VEL       = 1 [deg/s]
SPIN_STOP
INERTIA_START
INERTIA_REF_FRAME  = SC_BODY_1
IXX                = 1443.1 [kg*m**2]
IYY                = 1445.2 [kg*m**2]
IZZ                = 1760.2 [kg*m**2]
IXY                = -86.4 [kg*m**2]
IXZ                = 0.0 [kg*m**2]
IYZ                = -0.09 [kg*m**2]
INERTIA_STOP
MAN_START
MAN_EPOCH_START    = 2023-01-01T01:00:00.0000
MAN_DURATION       = 1 [s]
MAN_STOP
"""


def test_an_apm_becomes_a_spec(folder, capsys):
    """Its inertia, spin and attitude, by NumPy and SciPy, and a report of the motion that follows."""
    (folder / "mms.apm").write_text(APM)
    found = values_of(capsys, "import", "mms.apm")
    matrix = np.array([[1443.1, -86.4, 0.0], [-86.4, 1445.2, -0.09], [0.0, -0.09, 1760.2]])
    assert found["principal_moments"] == pytest.approx(np.linalg.eigvalsh(matrix), rel=1e-12)
    assert found["files"] == ["mms_imported.toml"] and "minus the products of inertia" in found["notes"][0]
    spec = ph.read_spec("mms_imported.toml")
    assert spec.body.inertia == pytest.approx(matrix, abs=1e-10)
    given = spec.motion().trajectory.along("given")
    assert np.asarray(given.angular_velocity)[0] == pytest.approx([0.0, 0.0, np.radians(1.0)], abs=1e-12)
    wanted = Rotation.from_euler("ZXZ", [10, 20, 0], degrees=True)
    assert rotation.angle_between(np.asarray(given.attitude)[0], rotation.from_scipy(wanted)) < 1e-14
    assert spec.labels.epoch == "2023-01-01T00:00:00" and spec.labels.object_name == "MMS1"


def test_an_apm_in_xml(folder, capsys):
    """The shape of Orekit's APM-quaternion-angvel.xml."""
    text = """<?xml version="1.0" encoding="UTF-8"?>
<apm id="CCSDS_APM_VERS" version="2.0"><header><ORIGINATOR>OREKIT</ORIGINATOR></header><body><segment><metadata>
<OBJECT_NAME>OREKIT_SAT</OBJECT_NAME><OBJECT_ID>2002-999Z</OBJECT_ID><TIME_SYSTEM>UTC</TIME_SYSTEM></metadata><data>
<EPOCH>2008-04-07T00:00:00.0</EPOCH><quaternionState><REF_FRAME_A>EME2000</REF_FRAME_A>
<REF_FRAME_B>SC_BODY_1</REF_FRAME_B><quaternion><Q1>-0.6447327809733585</Q1><Q2>-0.3463409538535587</Q2>
<Q3>-0.28613054916357517</Q3><QC>0.6184633325084984</QC></quaternion></quaternionState><angularVelocity>
<REF_FRAME_A>EME2000</REF_FRAME_A><REF_FRAME_B>SC_BODY_1</REF_FRAME_B><ANGVEL_FRAME>SC_BODY_1</ANGVEL_FRAME>
<ANGVEL_X units="deg/s">0.0031504176144069016</ANGVEL_X><ANGVEL_Y units="deg/s">-0.0596101304816182</ANGVEL_Y>
<ANGVEL_Z units="deg/s">2.9095159008651856E-4</ANGVEL_Z></angularVelocity></data></segment></body></apm>"""
    (folder / "sat.xml").write_text(text)
    found = forms()["apm"].read(Path("sat.xml"), Kernels())
    wanted = Rotation.from_quat([-0.6447327809733585, -0.3463409538535587, -0.28613054916357517, 0.6184633325084984])
    assert rotation.angle_between(found.attitude[0], rotation.from_scipy(wanted)) < 1e-14
    assert found.angular_velocity[0] == pytest.approx(np.radians([0.0031504176144069016, -0.0596101304816182,
                                                                  2.9095159008651856e-4]))  # fmt: skip
    assert values_of(capsys, "import", "sat.xml")["files"] == ["sat_imported.nc"]


@pytest.mark.parametrize(("change", "words"), [
    (("CCSDS_APM_VERS = 2.0", "CCSDS_APM_VERS = 1.0"), "must be 2.0 to be read here"),
    (("ANGLE_1              = 10 [deg]", "ANGLE_1              = 10 [rad]"), "line 14: ANGLE_1 must be in deg"),
    (("IXX                = 1443.1", "IXX                = 14430000"), "line 26: "),
    (("EULER_ROT_SEQ        = ZXZ", "EULER_ROT_SEQ        = ZZX"), "EULER_ROT_SEQ must be three axes"),
    (("INERTIA_STOP\n", ""), "has no INERTIA_STOP"),
    (("IZZ                = 1760.2 [kg*m**2]\n", ""), "IZZ is missing in this block INERTIA"),
    (("TIME_SYSTEM    = TAI", "TIME_SYSTEM    = SCLK"), "TIME_SYSTEM must be one of"),
])  # fmt: skip
def test_parameter_messages_that_are_wrong(folder, change, words):
    assert change[0] in APM
    (folder / "mms.apm").write_text(APM.replace(*change, 1))
    with pytest.raises(FormatError, match=words):
        forms()["apm"].read(Path("mms.apm"), Kernels())


def acm(kind, rate, columns, extra=""):
    """Blocks in the order of 504.0-B-2, section 5; the first lines as in Orekit's ACMExample01.txt."""
    rows = lines(TIMES, *columns, sign=" ")
    return f"""CCSDS_ACM_VERS           = 2.0
CREATION_DATE            = 1998-11-06T09:23:57
ORIGINATOR               = JAXA
META_START
OBJECT_NAME              = BOX
INTERNATIONAL_DESIGNATOR = 2000-052A
TIME_SYSTEM              = UTC
EPOCH_TZERO              = 2026-03-01T12:00:00
META_STOP

ATT_START
COMMENT                    a history
REF_FRAME_A              = EME2000
REF_FRAME_B              = SC_BODY_1
{extra}NUMBER_STATES            = {np.column_stack(columns).shape[1]}
ATT_TYPE                 = {kind}
RATE_TYPE                = {rate}
{rows}ATT_STOP

PHYS_START
WET_MASS                 = 12 [kg]
INERTIA_REF_FRAME        = SC_BODY_1
IXX                      = 1 [kg*m**2]
IYY                      = 2 [kg*m**2]
IZZ                      = 3 [kg*m**2]
PHYS_STOP
"""


@pytest.mark.parametrize("kind", ["quaternion", "euler"])
def test_an_acm_has_motion_and_inertia_in_one_file(folder, capsys, kind):
    """Energy and momentum follow from the file alone, and are conserved as those of the exact motion."""
    text = acm("QUATERNION", "ANGVEL", [QUATERNIONS[:, [1, 2, 3, 0]], np.degrees(OMEGA)])
    if kind == "euler":
        text = acm("EULER_ANGLES", "NONE", [TURNS.as_euler("ZYX", degrees=True)], "EULER_ROT_SEQ = ZYX\n")
    (folder / "box.acm").write_text(text)
    assert ph.compare("free.toml", "box.acm").comparison.largest < 1e-12
    found = values_of(capsys, "import", "box.acm")
    assert found["principal_moments"] == pytest.approx([1.0, 2.0, 3.0]) and found["mass"] == 12.0
    if kind == "quaternion":
        assert found["momentum_norm"] == pytest.approx(np.linalg.norm(np.multiply(MOMENTS, RATES)), rel=1e-12)
        assert max(found["drift"].values()) < 1e-12
        values_of(capsys, "import", "box.acm", "--out", "box_again.toml")
        assert ph.compare("free.toml", "box_again.toml").comparison.largest < 1e-12
    else:
        with pytest.raises(SystemExit):
            main(["import", "box.acm", "--out", "box_again.toml"])
        assert "a spec needs attitude, inertia and angular velocity" in capsys.readouterr().err


def test_messages_on_spin_without_attitude_are_refused(folder):
    (folder / "box.acm").write_text(acm("DCM", "NONE", [TURNS.as_matrix().reshape(-1, 9)]))
    with pytest.raises(FormatError, match="ATT_TYPE must be QUATERNION or EULER_ANGLES"):
        ph.compare("free.toml", "box.acm")
