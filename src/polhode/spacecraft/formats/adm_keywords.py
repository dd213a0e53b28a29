"""CCSDS Attitude Data Messages as tables: the keywords of each block, the elements of XML, the limits of a file.

Keywords that polhode does not need are passed over. Any other is a mistake: a ``WETT_MASS`` that is passed over too is
a mass that is lost without a word.

Source: CCSDS 504.0-B-2, tables 3-1 to 3-3, 4-2, 4-3 and 5-2 to 5-9, which all say that only the keywords shown may be
used; section 7 for XML, annex J for version 1.0 of an AEM.
"""

from __future__ import annotations

import difflib
from collections.abc import Iterable
from typing import NamedTuple

from polhode.errors import shown
from polhode.formats.opening import MB

STATE = "attitudeState"
OLD_RATES = {f"ANGLE_{k}_DOT": f"ANGVEL_{axis}" for k, axis in zip((1, 2, 3), "XYZ", strict=True)}
"""In XML of version 1.0 the rates of the turns have one name, be they derivatives or velocities."""
_USER = "USER_DEFINED_"
_HEADER = ("CLASSIFICATION", "CREATION_DATE", "ORIGINATOR", "MESSAGE_ID")
_FRAMES = ("REF_FRAME_A", "REF_FRAME_B")
_INERTIA = ("INERTIA_REF_FRAME", "IXX", "IYY", "IZZ", "IXY", "IXZ", "IYZ")


class Message(NamedTuple):
    """The grammar of one kind of message.

    Attributes:
        kind: its name.
        versions: those that are read.
        blocks: the keywords of each block; "" is what stands before and between the blocks.
        elements: of XML, each with its block; empty where XML is not read.
        continues: blocks that add to another one.
        order: the block that must follow each; empty where any may.
        rows: blocks with lines of numbers.
        max_size, max_xml_size: bytes of a file.
        max_line: characters; the standard allows 254.
        once: blocks of which there may be one alone.
    """

    kind: str
    versions: tuple[str, ...]
    blocks: dict[str, tuple[str, ...]]
    elements: dict[str, str]
    continues: dict[str, str]
    order: dict[str, str]
    rows: tuple[str, ...] = ()
    max_size: int = 200 * MB
    max_xml_size: int = 200 * MB
    max_line: int = 16_384
    once: tuple[str, ...] = ()

    @property
    def version_keyword(self) -> str:
        """The keyword that a message begins with."""
        return f"CCSDS_{self.kind}_VERS"

    def explain_block(self, name: str) -> str:
        """Return what is wrong with a block of this name; "" where it may be there."""
        known = [f"{block}_START" for block in (*self.continues, *self.blocks) if block]
        return "" if f"{name}_START" in known else explain_unknown("block", f"{name}_START", dict.fromkeys(known))

    def explain_keyword(self, name: str, keyword: str) -> str:
        """Return what is wrong with a keyword in a block; "" where it may be there.

        >>> ACM.explain_keyword("PHYS", "WETT_MASS")
        "unknown keyword 'WETT_MASS'; did you mean WET_MASS?"
        """
        known = self.blocks[name]
        if keyword in known or (_USER in known and keyword.startswith(_USER)):
            return ""
        return explain_unknown("keyword", keyword, known)


def explain_unknown(what: str, word: str, known: Iterable[str]) -> str:
    """Return that a word is none of those that may be there, with the one that it resembles."""
    near = difflib.get_close_matches(word, known, n=1)
    hint = f"did you mean {near[0]}?" if near else f"known here are {', '.join(known) or 'none'}."
    return f"unknown {what} {shown(word)}; {hint}"


AEM_NEEDED = ("OBJECT_NAME", "OBJECT_ID", *_FRAMES, "TIME_SYSTEM", "START_TIME", "STOP_TIME", "ATTITUDE_TYPE")
AEM = Message(
    "AEM", ("1.0", "2.0"),
    {
        "": ("CCSDS_AEM_VERS", *_HEADER),
        "META": (*AEM_NEEDED, "CENTER_NAME", "USEABLE_START_TIME", "USEABLE_STOP_TIME", "EULER_ROT_SEQ", "ANGVEL_FRAME",
                 "INTERPOLATION_METHOD", "INTERPOLATION_DEGREE", "ATTITUDE_DIR", "QUATERNION_TYPE", "RATE_FRAME"),
        "DATA": (),
    },
    {"header": "", "metadata": "META", "data": "DATA", STATE: STATE},
    {"DATA": "META"}, {"": "META", "META": "DATA", "DATA": "META"}, ("DATA",),
    2000 * MB,  # fifteen million attitudes
    500 * MB,  # a million
)
APM = Message(
    "APM", ("2.0",),
    {
        "": ("CCSDS_APM_VERS", *_HEADER, "OBJECT_NAME", "OBJECT_ID", "CENTER_NAME", "TIME_SYSTEM", "EPOCH"),
        "QUAT": (*_FRAMES, "Q1", "Q2", "Q3", "QC", "Q1_DOT", "Q2_DOT", "Q3_DOT", "QC_DOT"),
        "EULER": (*_FRAMES, "EULER_ROT_SEQ", "ANGLE_1", "ANGLE_2", "ANGLE_3", "ANGLE_1_DOT", "ANGLE_2_DOT",
                  "ANGLE_3_DOT"),
        "ANGVEL": (*_FRAMES, "ANGVEL_FRAME", "ANGVEL_X", "ANGVEL_Y", "ANGVEL_Z"),
        "SPIN": (*_FRAMES, "SPIN_ALPHA", "SPIN_DELTA", "SPIN_ANGLE", "SPIN_ANGLE_VEL", "NUTATION", "NUTATION_PER",
                 "NUTATION_PHASE", "MOMENTUM_ALPHA", "MOMENTUM_DELTA", "NUTATION_VEL"),
        "INERTIA": _INERTIA,
        "MAN": ("MAN_EPOCH_START", "MAN_DURATION", "MAN_REF_FRAME", "MAN_TOR_X", "MAN_TOR_Y", "MAN_TOR_Z",
                "MAN_DELTA_MASS"),
    },
    {"header": "", "metadata": "", "data": "", "quaternionState": "QUAT", "eulerAngleState": "EULER",
     "angularVelocity": "ANGVEL", "spin": "SPIN", "inertia": "INERTIA", "maneuverParameters": "MAN"},
    {"META": ""}, {},
)
ACM = Message(
    "ACM", ("2.0",),
    {
        # OBJECT_ID is that of an APM, which the same programs write here too; what it says is read
        "": ("CCSDS_ACM_VERS", *_HEADER, "OBJECT_NAME", "OBJECT_ID", "INTERNATIONAL_DESIGNATOR", "CATALOG_NAME",
             "OBJECT_DESIGNATOR", "ORIGINATOR_POC", "ORIGINATOR_POSITION", "ORIGINATOR_PHONE", "ORIGINATOR_EMAIL",
             "ORIGINATOR_ADDRESS", "ODM_MSG_LINK", "CENTER_NAME", "TIME_SYSTEM", "EPOCH_TZERO", "ACM_DATA_ELEMENTS",
             "START_TIME", "STOP_TIME", "TAIMUTC_AT_TZERO", "NEXT_LEAP_EPOCH", "NEXT_LEAP_TAIMUTC"),
        "ATT": ("ATT_ID", "ATT_PREV_ID", "ATT_BASIS", "ATT_BASIS_ID", *_FRAMES, "NUMBER_STATES", "ATT_TYPE",
                "EULER_ROT_SEQ", "RATE_TYPE"),
        "PHYS": ("DRAG_COEFF", "WET_MASS", "DRY_MASS", "CP_REF_FRAME", "CP", *_INERTIA),
        "COV": ("COV_ID", "COV_PREV_ID", "COV_BASIS", "COV_BASIS_ID", "COV_REF_FRAME", "COV_TYPE"),
        "MAN": ("MAN_ID", "MAN_PREV_ID", "MAN_PURPOSE", "MAN_BEGIN_TIME", "MAN_END_TIME", "MAN_DURATION",
                "ACTUATOR_USED", "TARGET_MOMENTUM", "TARGET_MOM_FRAME", "TARGET_ATTITUDE", "TARGET_SPINRATE"),
        "AD": ("AD_ID", "AD_METHOD", "ATTITUDE_SOURCE", "NUMBER_STATES", "ATTITUDE_STATES", "EULER_ROT_SEQ", "COV_TYPE",
               *_FRAMES, "RATE_STATES", "SIGMA_U", "SIGMA_V", "RATE_PROCESS_NOISE_STDDEV", "SENSOR_NUMBER",
               "SENSOR_USED", "NUMBER_SENSOR_NOISE_COVARIANCE", "SENSOR_NOISE_STDDEV", "SENSOR_FREQUENCY"),
        "USER": (_USER,),
    },
    {}, {"META": ""}, {}, ("ATT", "COV"),
    once=("PHYS", "AD", "USER"),  # table 5-1; those of an APM may be repeated, 3.2.4.4
)
