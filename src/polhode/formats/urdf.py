"""Mass properties in robot descriptions (URDF): ``<inertial>`` of a link, read and written."""

from __future__ import annotations

import math
import xml.etree.ElementTree as ET
from pathlib import Path
from typing import Any

import numpy as np

from polhode.bodies.body import Body
from polhode.errors import FormatError, InvalidInput, shown
from polhode.formats.numerals import read_number
from polhode.formats.opening import MB, read_file
from polhode.formats.paths import write_whole
from polhode.types import Array

LARGEST_FILE = 16 * MB  # robots of a thousand links take one
ENTRIES = {"ixx": (0, 0), "ixy": (0, 1), "ixz": (0, 2), "iyy": (1, 1), "iyz": (1, 2), "izz": (2, 2)}


def read_urdf_inertial(path: str | Path, link: str | None = None) -> Body:
    """Return a link of a URDF file as a body, along the axes of the link's own frame: J = R J_inertial Rᵀ.

    ``<origin xyz rpy>`` places the inertial frame in the link's: the centre of mass stands at xyz, and
    R = Rz(yaw) Ry(pitch) Rx(roll), turns about fixed axes. Entries of ``<inertia>`` are those of the inertia matrix, so
    that off-diagonal ones are minus the products of inertia.

    Args:
        path: the file; xacro has to be expanded first.
        link: its name; it may be left out where only one link has an ``<inertial>``.

    Raises:
        InvalidInput: if the file is missing, or it is open which link is meant.
        FormatError: if it is not URDF, something is missing or no number, or no body has these mass properties.

    Source: ROS, *URDF XML specification*, link and joint elements.
    """
    path = Path(path)
    name, inertial = _find_inertial(path, _root(path), link)
    where = f"{path}: link {shown(name)}"
    mass = _number(where, _child(where, inertial, "mass"), "value")
    entry = _child(where, inertial, "inertia")
    matrix = np.zeros((3, 3))
    for key, (i, j) in ENTRIES.items():
        matrix[i, j] = matrix[j, i] = _number(where, entry, key)
    origin = inertial.find("origin")
    center, angles = (_three(where, origin, key) for key in ("xyz", "rpy"))
    try:
        return Body(mass, np.zeros(3), matrix).placed(_from_fixed_angles(angles), center)
    except InvalidInput as error:
        raise FormatError(f"{where}: {error}") from None


def write_urdf_inertial(body: Body, path: str | Path, name: str = "body", principal: bool = False) -> Path:
    """Write a body as a URDF file of one link, whose frame is the body's given axes.

    Numbers have 17 digits, so that they are read back as they were.

    Args:
        body: with its mass.
        path: of the file, replaced if it is there.
        name: of the link and the robot.
        principal: whether to turn the inertial frame to the principal axes, ascending, where the inertia is diagonal;
            otherwise it stays along the given axes, rpy="0 0 0", and the matrix is full.

    Raises:
        InvalidInput: for a body without mass, a name that is empty or that XML cannot hold, or a file that cannot be
            written.

    >>> import tempfile
    >>> from polhode.bodies import shapes
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     path = write_urdf_inertial(shapes.box(12.0, (1.0, 2.0, 3.0)), f"{folder}/box.urdf")
    ...     read_urdf_inertial(path).principal_moments
    array([ 5., 10., 13.])
    """
    path = Path(path)
    if body.mass is None:
        raise InvalidInput("URDF holds the mass, and this body has none; give `mass` when making it.")
    if not name.strip() or not name.isprintable():
        raise InvalidInput(f"`name` must be printable text in one line, as links are known by it; got {shown(name)}.")
    inertia, angles = body.inertia, np.zeros(3)
    if principal:
        inertia, angles = np.diag(body.principal_moments), _fixed_angles(body.principal_axes)
    robot = ET.Element("robot", name=name)
    inertial = ET.SubElement(ET.SubElement(robot, "link", name=name), "inertial")
    ET.SubElement(inertial, "origin", xyz=_list_numbers(body.center_of_mass), rpy=_list_numbers(angles))
    ET.SubElement(inertial, "mass", value=_list_numbers([body.mass]))
    ET.SubElement(inertial, "inertia", {key: _list_numbers([inertia[at]]) for key, at in ENTRIES.items()})
    ET.indent(robot)
    with write_whole(path) as draft:
        draft.write_bytes(ET.tostring(robot, encoding="utf-8", xml_declaration=True) + b"\n")
    return path


class _NoEntities(ET.TreeBuilder):
    """Robots need no document type, and entities declared in one can grow without bound."""

    def doctype(self, name: str, pubid: str | None, system: str | None) -> None:
        raise ValueError("it declares a document type, which URDF has no use for")


def _root(path: Path) -> ET.Element:
    try:
        root = ET.fromstring(read_file(path, "URDF", LARGEST_FILE), ET.XMLParser(target=_NoEntities()))
    except InvalidInput:
        raise
    except (ET.ParseError, ValueError, LookupError) as error:
        raise FormatError(f"{path}: is not URDF, which is XML: {error}. Check the file.") from None
    if root.tag != "robot":
        raise FormatError(f"{path}: is not URDF: its outermost element must be <robot>; got <{root.tag}>.")
    return root


def _find_inertial(path: Path, root: ET.Element, link: str | None) -> tuple[str, ET.Element]:
    links = root.findall("link")
    names = [element.get("name", "") for element in links]
    massive = [name for name, element in zip(names, links, strict=True) if element.find("inertial") is not None]
    if link is None:
        if not massive:
            raise FormatError(f"{path}: no link has an <inertial>; of {len(links)} links none has mass properties.")
        if len(massive) > 1:
            raise InvalidInput(f"{path}: has {len(massive)} links with mass; name one as `link`: {', '.join(massive)}.")
        link = massive[0]
    if names.count(link) != 1:
        fault = "has no link" if link not in names else f"has {names.count(link)} links called"
        raise InvalidInput(f"{path}: {fault} {shown(link)}; those with mass are {', '.join(massive) or 'none'}.")
    inertial = links[names.index(link)].find("inertial")
    if inertial is None:
        raise FormatError(f"{path}: link {shown(link)} has no <inertial>, so no mass; links that have are "
                          f"{', '.join(massive) or 'none'}.")  # fmt: skip
    return link, inertial


def _child(where: str, parent: ET.Element, tag: str) -> ET.Element:
    child = parent.find(tag)
    if child is None:
        raise FormatError(f"{where}: its <inertial> has no <{tag}>. Add it.")
    return child


def _number(where: str, element: ET.Element, key: str) -> float:
    text = element.get(key)
    if text is None:
        raise FormatError(f"{where}: <{element.tag}> has no {key}. Add it.")
    return _finite(where, f"{key} of <{element.tag}>", [text])[0]


def _three(where: str, origin: ET.Element | None, key: str) -> Array:
    text = None if origin is None else origin.get(key)
    values = [0.0, 0.0, 0.0] if text is None else _finite(where, f"{key} of <origin>", text.split())
    if len(values) != 3:
        raise FormatError(f"{where}: {key} of <origin> must be three numbers; got {shown(text)}.")
    return np.array(values)


def _finite(where: str, what: str, texts: list[str]) -> list[float]:
    try:
        return [read_number(text) for text in texts]
    except ValueError:
        came = " ".join(texts)
    hint = " Expand the xacro first." if "$" in came else " Check the file."
    raise FormatError(f"{where}: {what} must be finite numbers in decimal digits; got {shown(came)}.{hint}")


def _from_fixed_angles(angles: Array) -> Array:
    """Return Rz(yaw) Ry(pitch) Rx(roll)."""
    (a, b, c), (s, t, u) = np.cos(angles), np.sin(angles)
    return np.array([
        [c * b, c * t * s - u * a, c * t * a + u * s],
        [u * b, u * t * s + c * a, u * t * a - c * s],
        [-t, b * s, b * a],
    ])  # fmt: skip


def _fixed_angles(R: Array) -> Array:
    """Return roll, pitch, yaw of a rotation matrix.

    Pitch and roll are taken from Rz(−yaw) R = Ry(pitch) Rx(roll): where the pitch is a quarter turn any yaw goes with
    some roll, and this one matches the yaw that was taken.
    """
    yaw = math.atan2(R[1, 0], R[0, 0])
    c, s = math.cos(yaw), math.sin(yaw)
    left = np.array([[c, s, 0.0], [-s, c, 0.0], [0.0, 0.0, 1.0]]) @ R
    return np.array([math.atan2(-left[1, 2], left[1, 1]), math.atan2(-left[2, 0], left[0, 0]), yaw])


def _list_numbers(values: Any) -> str:
    return " ".join(repr(float(value) + 0.0) for value in values)
