"""Attitude Ephemeris Messages to read, and how Orekit reads and writes them."""

import functools

import numpy as np
import pytest

# as printed in CCSDS 504.0-B-2, figure G-4
FIGURE_G4 = """CCSDS_AEM_VERS = 2.0
CREATION_DATE = 2002-11-04T17:22:31
ORIGINATOR = NASA/JPL
MESSAGE_ID = A7015Z3

META_START
COMMENT This file was produced by M.R. Somebody, MSOO NAV/JPL.
COMMENT It is to be used for attitude reconstruction only. The relative accuracy of these
COMMENT  attitudes is 0.1 degrees per axis.
OBJECT_NAME     = MARS GLOBAL SURVEYOR
OBJECT_ID       = 1996-062A
CENTER_NAME     = MARS BARYCENTER
REF_FRAME_A     = EME2000
REF_FRAME_B     = SC_BODY_1
TIME_SYSTEM     = UTC
START_TIME      = 1996-11-28T21:29:07.2555
USEABLE_START_TIME = 1996-11-28T22:08:02.5555
USEABLE_STOP_TIME  = 1996-11-30T01:18:02.5555
STOP_TIME       = 1996-11-30T01:28:02.5555
ATTITUDE_TYPE   = QUATERNION
INTERPOLATION_METHOD = hermite
INTERPOLATION_DEGREE = 7
META_STOP

DATA_START
1996-11-28T21:29:07.2555 0.56748  0.03146  0.45689  0.68427
1996-11-28T22:08:03.5555 0.42319  -0.45697 0.23784  0.74533
1996-11-28T22:08:04.5555 -0.84532 0.26974  -0.06532 0.45652
1996-11-30T01:28:02.5555 0.74563  -0.45375  0.36875  0.31964
DATA_STOP

META_START
COMMENT  This block begins after trajectory correction maneuver TCM-3.
OBJECT_NAME     = mars global surveyor
OBJECT_ID       = 1996-062A
CENTER_NAME     = MARS BARYCENTER
REF_FRAME_A     = EME2000
REF_FRAME_B      = SC_BODY_1
TIME_SYSTEM     = UTC
START_TIME      = 1996-12-18T12:05:00.5555
USEABLE_START_TIME = 1996-12-18T12:10:00.5555
USEABLE_STOP_TIME  = 1996-12-28T21:23:00.5555
STOP_TIME       = 1996-12-28T21:28:00.5555
ATTITUDE_TYPE   = QUATERNION
META_STOP

DATA_START
1996-12-18T12:05:00.5555 -0.64585 0.018542  -0.23854 0.72501
1996-12-18T12:10:05.5555 0.87451  -0.43475  0.13458  0.16767
1996-12-18T12:10:10.5555 0.03125  -0.65874  0.23458  0.71418
1996-12-28T21:28:00.5555 -0.25485 0.58745  -0.36845  0.67394
DATA_STOP
"""


def message(kind, values, extra="", version="2.0", frames=("EME2000", "SC_BODY_1")):
    """Return a message with one line of data."""
    return f"""CCSDS_AEM_VERS = {version}
CREATION_DATE = 2020-01-01T00:00:00
ORIGINATOR = X
META_START
OBJECT_NAME = A
OBJECT_ID = 1996-062A
REF_FRAME_A = {frames[0]}
REF_FRAME_B = {frames[1]}
{extra}TIME_SYSTEM = UTC
START_TIME = 2020-01-01T00:00:00
STOP_TIME = 2020-01-01T00:00:00
ATTITUDE_TYPE = {kind}
META_STOP
DATA_START
2020-01-01T00:00:00 {values}
DATA_STOP
"""


# International Atomic Time less UTC from 1 January or 1 July of a year on, as Bulletin C has them
STEPS = """1972-1 10 1972-7 11 1973-1 12 1974-1 13 1975-1 14 1976-1 15 1977-1 16 1978-1 17 1979-1 18 1980-1 19 1981-7 20
1982-7 21 1983-7 22 1985-7 23 1988-1 24 1990-1 25 1991-1 26 1992-7 27 1993-7 28 1994-7 29 1996-1 30 1997-7 31 1999-1 32
2006-1 33 2009-1 34 2012-7 35 2015-7 36 2017-1 37""".split()


@functools.cache
def start_orekit():
    """Start Java with Orekit; it is given its leap seconds, as it brings no data.

    Skips where Orekit is not installed: it needs Java, so it is in the extra `bench` and not in `test`; CI has both.
    """
    jpype = pytest.importorskip("jpype", reason="Orekit is not installed")
    orekit_jpype = pytest.importorskip("orekit_jpype", reason="Orekit is not installed")
    orekit_jpype.initVM()
    from java.util import ArrayList
    from org.orekit.data import DataContext
    from org.orekit.time import DateComponents, OffsetModel, UTCTAIOffsetsLoader

    def offsets():
        found = ArrayList()
        for month, count in zip(STEPS[::2], STEPS[1::2], strict=True):
            found.add(OffsetModel(DateComponents(*map(int, month.split("-")), 1), int(count)))
        return found

    loader = jpype.JProxy(UTCTAIOffsetsLoader, dict={"loadOffsets": offsets})
    DataContext.getDefault().getTimeScales().addUTCTAIOffsetsLoader(loader)


def read_by_orekit(path):
    """Return times from the first, quaternions wxyz and rates of all segments; skip without Orekit."""
    start_orekit()
    from org.orekit.data import DataSource
    from org.orekit.files.ccsds.ndm import ParserBuilder

    segments = ParserBuilder().buildAemParser().parseMessage(DataSource(str(path))).getSegments()
    found = [sample for segment in segments for sample in segment.getAngularCoordinates()]
    times = np.array([sample.getDate().durationFrom(found[0].getDate()) for sample in found])
    turns, rates = [one.getRotation() for one in found], [one.getRotationRate() for one in found]
    attitude = np.array([[q.getQ0(), q.getQ1(), q.getQ2(), q.getQ3()] for q in turns])
    return times, attitude, np.array([[w.getX(), w.getY(), w.getZ()] for w in rates])


def rewritten_by_orekit(path):
    """Return the text of a message as Orekit writes what it has read."""
    start_orekit()
    from java.io import StringWriter
    from org.orekit.data import DataSource
    from org.orekit.files.ccsds.ndm import ParserBuilder, WriterBuilder
    from org.orekit.files.ccsds.utils.generation import KvnGenerator

    read = ParserBuilder().buildAemParser().parseMessage(DataSource(str(path)))
    text = StringWriter()
    WriterBuilder().buildAemWriter().writeMessage(KvnGenerator(text, 0, "", 0.0, -1), read)
    return str(text)
