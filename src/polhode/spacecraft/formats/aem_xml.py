"""The XML form of Attitude Ephemeris Messages, taken apart into the same segments as keyword = value.

Source: CCSDS 504.0-B-2, section 7 and table 7-5; CCSDS 505.0, Navigation Data Messages XML specification.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np

from polhode.errors import shown
from polhode.formats.epochs import read_epoch
from polhode.formats.numerals import read_number
from polhode.formats.opening import MB
from polhode.formats.xml_nodes import Node, read_xml
from polhode.spacecraft.formats.aem_segments import (  # fmt: skip
    HEADER,
    NEEDED,
    OPTIONAL,
    Segment,
    check_metadata,
    keep_data,
    refuse,
)

LARGEST_FILE = 500 * MB  # a million attitudes
QUATERNION, DERIVATIVE = ("Q1", "Q2", "Q3", "QC"), ("Q1_DOT", "Q2_DOT", "Q3_DOT", "QC_DOT")
ANGLES, ANGLE_RATES = ("ANGLE_1", "ANGLE_2", "ANGLE_3"), ("ANGLE_1_DOT", "ANGLE_2_DOT", "ANGLE_3_DOT")
VELOCITY = ("ANGVEL_X", "ANGVEL_Y", "ANGVEL_Z")
SPIN = ("SPIN_ALPHA", "SPIN_DELTA", "SPIN_ANGLE", "SPIN_ANGLE_VEL")
TAGS = {
    "QUATERNION": QUATERNION,
    "QUATERNION/DERIVATIVE": QUATERNION + DERIVATIVE,
    "QUATERNION/ANGVEL": QUATERNION + VELOCITY,
    "EULER_ANGLE": ANGLES,
    "EULER_ANGLE/DERIVATIVE": ANGLES + ANGLE_RATES,
    "EULER_ANGLE/ANGVEL": ANGLES + VELOCITY,
    "SPIN": SPIN,
    "SPIN/NUTATION": (*SPIN, "NUTATION", "NUTATION_PER", "NUTATION_PHASE"),
    "SPIN/NUTATION_MOM": (*SPIN, "MOMENTUM_ALPHA", "MOMENTUM_DELTA", "NUTATION_VEL"),
}
"""Elements of each type of attitude, in the order of the columns of keyword = value."""
UNITS = ("deg", "deg/s", "1/s", "s", "")


def read_xml_segments(path: Path) -> list[Segment]:
    """Return the segments of an AEM in XML, alone or in a combined message.

    Raises:
        InvalidInput: where the file is missing.
        FormatError: naming the line, if it is no AEM.
    """
    root = read_xml(path, "AEM", LARGEST_FILE)
    messages = [node for node in root.walk() if node.tag == "aem"]
    if len(messages) != 1:
        what = f"has {len(messages)} AEMs in it. Leave one" if messages else "is XML, and no AEM. It is another file"
        refuse(path, root.line, what)
    message = messages[0]
    version = message.attributes.get("version", "")
    if version not in ("1.0", "2.0"):
        refuse(path, message.line, f"version must be 1.0 or 2.0; got {shown(version)}. Have it written in version 2.0")
    header, places = {}, {}
    if (head := message.find("header")) is not None:
        _take(path, head, HEADER, header, places)
    body = message.find("body")
    segments = [_read_segment(path, node, version == "1.0", header, places)
                for node in (body.find_all("segment") if body is not None else ())]  # fmt: skip
    if not segments:
        refuse(path, message.line, "holds no segment. Get it whole")
    return segments


def _take(
    path: Path, node: Node, known: tuple[str, ...], values: dict[str, str], places: dict[str, int]
) -> list[str]:
    """Put the elements of a header or of metadata into values, and return the comments."""
    comments = []
    for child in node.children:
        text = child.text.strip()
        if child.tag == "COMMENT":
            comments.append(text)
            continue
        if child.tag not in known:
            refuse(path, child.line, f"unknown keyword {shown(child.tag)}; known here are {', '.join(known)}")
        if child.tag in values:
            refuse(path, child.line, f"{child.tag} is there already, in line {places[child.tag]}. Leave out one")
        if not text:
            refuse(path, child.line, f"{child.tag} must have a value")
        values[child.tag], places[child.tag] = text, child.line
    return comments


def _read_segment(path: Path, node: Node, old: bool, header: dict[str, str], places: dict[str, int]) -> Segment:
    metadata, data = node.find("metadata"), node.find("data")
    if metadata is None or data is None:
        refuse(path, node.line, "a segment must have metadata and data. Get the file whole")
    one = Segment(path, old, dict(header), places | {"META_START": metadata.line}, [])
    one.comments += _take(path, metadata, NEEDED + OPTIONAL, one.values, one.lines)
    check_metadata(one)
    kind, time_system = one.kind, one.time_system
    states = [child for state in data.find_all("attitudeState") for child in state.children]
    if not states:
        refuse(path, data.line, "there are no attitudes in the data")
    instants = np.zeros((len(states), 2), dtype=np.int64)
    rows = []
    for k, state in enumerate(states):
        epoch = state.find("EPOCH")
        if epoch is None:
            refuse(path, state.line, "an attitude must have an EPOCH")
        try:
            instants[k] = read_epoch(epoch.text.strip(), time_system)
        except ValueError as error:
            refuse(path, epoch.line, f"the epoch {error}")
        rows.append(_numbers(path, state, kind))
    if one.old and "QUATERNION_TYPE" in one.values:
        one.values["QUATERNION_TYPE"] = "LAST"  # as the elements are taken by their names
    elif one.old and kind.startswith("QUATERNION"):
        one.values["QUATERNION_TYPE"], one.lines["QUATERNION_TYPE"] = "LAST", metadata.line
    lines = np.array([state.line for state in states], dtype=np.int64)
    keep_data(one, instants[:, 0], instants[:, 1], np.array(rows), lines)
    return one


def _numbers(path: Path, state: Node, kind: str) -> list[float]:
    found = dict(_named_leaves(state))
    row = []
    for tag in TAGS[kind]:
        leaf = found.get(tag)
        if leaf is None:
            refuse(path, state.line, f"has no {tag}, as ATTITUDE_TYPE {kind} wants it; got {', '.join(found)}")
        if leaf.attributes.get("units", "") not in UNITS:
            refuse(path, leaf.line, f"{tag} must be in degrees; got {shown(leaf.attributes['units'])}")
        try:
            row.append(read_number(leaf.text.strip()))
        except ValueError as error:
            refuse(path, leaf.line, f"{tag} {error}; got {shown(leaf.text.strip())}")
    return row


def _named_leaves(state: Node) -> list[tuple[str, Node]]:
    """Return the numbers of an attitude by the names of version 2.0.

    In version 1.0 angles and rates are rotation1 to rotation3 in the order of the turns; its rates are velocities.
    """
    found = []
    for part in state.children:
        for leaf in part.children or [part]:
            if leaf.tag.startswith("rotation") and leaf.tag[-1:] in ("1", "2", "3"):
                k = int(leaf.tag[-1])
                names = (ANGLE_RATES, VELOCITY) if part.tag == "rotationRates" else (ANGLES,)
                found += [(name[k - 1], leaf) for name in names]
            else:
                found.append((leaf.tag, leaf))
    return found
