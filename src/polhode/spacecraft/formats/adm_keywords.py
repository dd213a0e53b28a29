"""The keywords that CCSDS Attitude Parameter and Comprehensive Messages may have, block by block.

Those that polhode does not need are passed over. Any other is a mistake: a ``WETT_MASS`` that is passed over too is a
mass that is lost without a word.

Source: CCSDS 504.0-B-2, tables 3-1 to 3-3 and 5-2 to 5-9, which all say that only the keywords shown may be used.
"""

from __future__ import annotations

import difflib

from polhode.errors import shown

_HEADER = ("CLASSIFICATION", "CREATION_DATE", "ORIGINATOR", "MESSAGE_ID")
_FRAMES = ("REF_FRAME_A", "REF_FRAME_B")
_INERTIA = ("INERTIA_REF_FRAME", "IXX", "IYY", "IZZ", "IXY", "IXZ", "IYZ")
_APM = {
    "": ("CCSDS_APM_VERS", *_HEADER, "OBJECT_NAME", "OBJECT_ID", "CENTER_NAME", "TIME_SYSTEM", "EPOCH"),
    "QUAT": (*_FRAMES, "Q1", "Q2", "Q3", "QC", "Q1_DOT", "Q2_DOT", "Q3_DOT", "QC_DOT"),
    "EULER": (*_FRAMES, "EULER_ROT_SEQ", "ANGLE_1", "ANGLE_2", "ANGLE_3", "ANGLE_1_DOT", "ANGLE_2_DOT", "ANGLE_3_DOT"),
    "ANGVEL": (*_FRAMES, "ANGVEL_FRAME", "ANGVEL_X", "ANGVEL_Y", "ANGVEL_Z"),
    "SPIN": (*_FRAMES, "SPIN_ALPHA", "SPIN_DELTA", "SPIN_ANGLE", "SPIN_ANGLE_VEL", "NUTATION", "NUTATION_PER",
             "NUTATION_PHASE", "MOMENTUM_ALPHA", "MOMENTUM_DELTA", "NUTATION_VEL"),
    "INERTIA": _INERTIA,
    "MAN": ("MAN_EPOCH_START", "MAN_DURATION", "MAN_REF_FRAME", "MAN_TOR_X", "MAN_TOR_Y", "MAN_TOR_Z",
            "MAN_DELTA_MASS"),
}  # fmt: skip
_ACM = {
    # OBJECT_ID is that of an APM, which the same programs write here too; what it says is read
    "": ("CCSDS_ACM_VERS", *_HEADER, "OBJECT_NAME", "OBJECT_ID", "INTERNATIONAL_DESIGNATOR", "CATALOG_NAME",
         "OBJECT_DESIGNATOR", "ORIGINATOR_POC", "ORIGINATOR_POSITION", "ORIGINATOR_PHONE", "ORIGINATOR_EMAIL",
         "ORIGINATOR_ADDRESS", "ODM_MSG_LINK", "CENTER_NAME", "TIME_SYSTEM", "EPOCH_TZERO", "ACM_DATA_ELEMENTS",
         "START_TIME", "STOP_TIME", "TAIMUTC_AT_TZERO", "NEXT_LEAP_EPOCH", "NEXT_LEAP_TAIMUTC"),
    "ATT": ("ATT_ID", "ATT_PREV_ID", "ATT_BASIS", "ATT_BASIS_ID", *_FRAMES, "NUMBER_STATES", "ATT_TYPE",
            "EULER_ROT_SEQ", "RATE_TYPE"),
    "PHYS": ("DRAG_COEFF", "WET_MASS", "DRY_MASS", "CP_REF_FRAME", "CP", *_INERTIA),
    "COV": ("COV_ID", "COV_PREV_ID", "COV_BASIS", "COV_BASIS_ID", "COV_REF_FRAME", "COV_TYPE"),
    "MAN": ("MAN_ID", "MAN_PREV_ID", "MAN_PURPOSE", "MAN_BEGIN_TIME", "MAN_END_TIME", "MAN_DURATION", "ACTUATOR_USED",
            "TARGET_MOMENTUM", "TARGET_MOM_FRAME", "TARGET_ATTITUDE", "TARGET_SPINRATE"),
    "AD": ("AD_ID", "AD_PREV_ID", "AD_METHOD", "ATTITUDE_SOURCE", "NUMBER_STATES", "ATTITUDE_STATES", "EULER_ROT_SEQ",
           "COV_TYPE", *_FRAMES, "RATE_STATES", "SIGMA_U", "SIGMA_V", "RATE_PROCESS_NOISE_STDDEV", "SENSOR_NUMBER",
           "SENSOR_USED", "NUMBER_SENSOR_NOISE_COVARIANCE", "SENSOR_NOISE_STDDEV", "SENSOR_FREQUENCY"),
    "USER": (),
}  # fmt: skip
KEYWORDS = {"APM": _APM, "ACM": _ACM}
"""Of each kind of message: block → its keywords; "" is header and metadata, and in an APM the epoch."""
WITH_ROWS = ("ATT", "COV")
"""Blocks with lines of numbers."""
_OF_USERS = "USER_DEFINED_"


def explain_block(kind: str, name: str) -> str:
    """Return what is wrong with a block of this name in a message; "" where it may be there."""
    blocks = [f"{block}_START" for block in ("META", *KEYWORDS[kind]) if block]
    return "" if f"{name}_START" in blocks else _explain("block", f"{name}_START", blocks)


def explain_keyword(kind: str, name: str, keyword: str) -> str:
    """Return what is wrong with a keyword in a block of a message; "" where it may be there.

    >>> explain_keyword("ACM", "PHYS", "WETT_MASS")
    "unknown keyword 'WETT_MASS'; did you mean WET_MASS?"
    """
    known = KEYWORDS[kind][name]
    if keyword in known or (name == "USER" and keyword.startswith(_OF_USERS)):
        return ""
    return _explain("keyword", keyword, known or [f"{_OF_USERS}x"])


def explain_element(tag: str, known: tuple[str, ...]) -> str:
    """Return what is wrong with an element of XML that is none of those that stand for blocks."""
    return _explain("element", tag, known)


def _explain(what: str, word: str, known: tuple[str, ...] | list[str]) -> str:
    near = difflib.get_close_matches(word, known, n=1)
    hint = f"did you mean {near[0]}?" if near else f"known here are {', '.join(known)}."
    return f"unknown {what} {shown(word)}; {hint}"
