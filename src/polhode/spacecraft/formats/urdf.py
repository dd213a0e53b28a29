"""Mass properties in robot descriptions (URDF): ``<inertial>`` of a link, read and written."""

from __future__ import annotations

import math
import xml.etree.ElementTree as ET
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

from polhode._base import check
from polhode.bodies._inertia import MassProperties
from polhode.bodies.body import Body
from polhode.errors import FormatError, InvalidInput, shown
from polhode.formats.body_file import BodyFile, Pose
from polhode.formats.paths import as_path, write_whole
from polhode.spacecraft.formats.robot_xml import (
    ENTRIES,
    FREE,
    Frame,
    Motion,
    find_child,
    find_positions,
    finite_numbers,
    from_fixed_angles,
    join_links,
    make_inertial,
    make_links,
    read_limits,
    read_xml,
    unit_vector,
)
from polhode.types import Array, Float64

UNITS = {"revolute": "rad", "continuous": "rad", "prismatic": "m", "fixed": "", "floating": "", "planar": ""}


def read_urdf_inertial(path: str | Path, link: str | None = None, digits: int | None = None) -> Body:
    """Return a link of a URDF file as a body, along the axes of the link's own frame: J = R J_inertial Rᵀ.

    ``<origin xyz rpy>`` places the inertial frame in the link's: the centre of mass is at xyz, and
    R = Rz(yaw) Ry(pitch) Rx(roll), turns about fixed axes. Entries of ``<inertia>`` are those of the inertia matrix, so
    that off-diagonal ones are minus the products of inertia.

    Args:
        path: the file; xacro has to be expanded first.
        link: its name; it may be left out where only one link has an ``<inertial>``.
        digits: to which the entries of its inertia were rounded, see ``Body.from_inertia``.

    Raises:
        InvalidInput: if the file is missing, or the link is ambiguous.
        FormatError: if it is not URDF, something is missing or no number, or no body has these mass properties.

    Source: ROS, *URDF XML specification*, link and joint elements.
    """
    path = as_path("path", path)
    name, inertial = _find_inertial(path, read_xml(path, "URDF", "robot"), link)
    where = f"{path}: link {shown(name)}"
    body = _inertial(where, inertial, digits)
    if not isinstance(body, Body):
        raise FormatError(f"{where}: its inertia is zero, and a point has no attitude. Give its <inertia>.")
    return body


def read_urdf_robot(path: str | Path, pose: Pose, digits: int | None = None) -> Body:
    """Return all links of a URDF file as one body, along the axes of the link that is no other's child.

    A joint's frame in its parent is given by ``<origin>``; the child's frame is that, rotated about or moved along
    ``<axis>`` by the joint's position.

    Args:
        path: the file; xacro has to be expanded first.
        pose: positions of joints, zero for others; ``<mimic>`` joints follow theirs. Beyond limits it warns.
        digits: to which entries of inertias were rounded, see ``Body.from_inertia``.

    Raises:
        InvalidInput: if the file is missing, or the pose does not fit its joints.
        FormatError: if it is not URDF, its links are no tree, or no body has their mass properties.

    Source: ROS, *URDF XML specification*, link and joint elements.
    """
    path = as_path("path", path)
    root = read_xml(path, "URDF", "robot")
    names = [element.get("name", "") for element in root.findall("link")]
    if len(set(names)) != len(names):
        raise FormatError(f"{path}: several links have the same name. Rename them.")
    joints = [_joint(path, element, names) for element in root.findall("joint")]
    positions = find_positions(path, pose, [motion for _, _, _, motion in joints])
    children: dict[str, list[tuple[str, Frame]]] = {}
    for parent, child, frame, motion in joints:
        at = positions.get(motion.name, motion.reference)
        children.setdefault(parent, []).append((child, frame.then(motion.at(at))))
    below = [child for _, child, _, _ in joints]
    tops = [name for name in names if name not in below]
    reached = list(tops)
    for name in reached:  # which grows meanwhile; a link with two parents is refused
        reached += [child for child, _ in children.get(name, ())] if len(reached) <= len(names) else []
    if not names:
        raise FormatError(f"{path}: has no links. If it is written for xacro, let xacro expand it first.")
    if len(tops) != 1 or len(set(below)) != len(below) or len(reached) != len(names):
        raise FormatError(f"{path}: its joints must make one tree of its links, from one that is no other's child; got "
                          f"{len(tops)} such links.")
    inertials = {element.get("name", ""): element.find("inertial") for element in root.findall("link")}
    links: list[tuple[Frame, Callable[[], Body | MassProperties]]] = []
    waiting = [(tops[0], Frame())]
    while waiting:
        name, frame = waiting.pop()
        element = inertials[name]
        if element is not None and not _is_massless(f"{path}: link {shown(name)}", element):
            links.append((frame, partial(_inertial, f"{path}: link {shown(name)}", element, digits)))
        waiting += [(child, frame.then(inner)) for child, inner in children.get(name, ())]
    return join_links(path, make_links(path, links))


def _joint(path: Path, element: ET.Element, names: list[str]) -> tuple[str, str, Frame, Motion]:
    """Return parent, child, frame in the parent and motion of a joint."""
    name, kind = element.get("name", ""), element.get("type", "")
    where = f"{path}: joint {shown(name)}"
    check.one_of(f"{where}: its type", kind, UNITS, error=FormatError)
    ends = [find_child(where, element, tag).get("link", "") for tag in ("parent", "child")]
    if unknown := [end for end in ends if end not in names]:
        raise FormatError(f"{where}: there is no link {shown(unknown[0])}. Check the file.")
    axis, mimic, follows = element.find("axis"), element.find("mimic"), None
    direction = np.array([1.0, 0.0, 0.0])
    if axis is not None and UNITS[kind]:
        direction = unit_vector(where, "its <axis>", finite_numbers(where, "xyz of <axis>", axis.get("xyz"), 3))
    if mimic is not None and UNITS[kind]:
        factor, offset = (
            finite_numbers(where, f"{key} of <mimic>", mimic.get(key, default), 1)[0]
            for key, default in (("multiplier", "1"), ("offset", "0"))
        )
        follows = (mimic.get("joint", ""), float(factor), float(offset))
    limit = element.find("limit") if kind in ("revolute", "prismatic") else None
    limits = FREE if limit is None else read_limits(limit.get("lower", "0"), limit.get("upper", "0"))
    return ends[0], ends[1], _origin(where, element), Motion(name, UNITS[kind], direction, 0.0, follows, limits)


def _origin(where: str, parent: ET.Element) -> Frame:
    origin = parent.find("origin")
    values = {key: "0 0 0" if origin is None else origin.get(key, "0 0 0") for key in ("xyz", "rpy")}
    place, angles = (finite_numbers(where, f"{key} of <origin>", text, 3) for key, text in values.items())
    return Frame(from_fixed_angles(angles), place)


def _is_massless(where: str, inertial: ET.Element) -> bool:
    """Whether a link says that it has neither mass nor inertia, as frames without matter do."""
    return _number(where, find_child(where, inertial, "mass"), "value") == 0.0 and not _matrix(where, inertial).any()


def _inertial(where: str, inertial: ET.Element, digits: int | None) -> Body | MassProperties:
    mass = _number(where, find_child(where, inertial, "mass"), "value")
    return make_inertial(where, mass, _origin(where, inertial), _matrix(where, inertial), digits)


def _matrix(where: str, inertial: ET.Element) -> Float64[Array, "3 3"]:
    entry = find_child(where, inertial, "inertia")
    matrix = np.zeros((3, 3))
    for key, (i, j) in ENTRIES.items():
        matrix[i, j] = matrix[j, i] = _number(where, entry, key)
    return matrix


def _number(where: str, element: ET.Element, key: str) -> float:
    text = element.get(key)
    if text is None:
        raise FormatError(f"{where}: <{element.tag}> has no {key}. Add it.")
    return float(finite_numbers(where, f"{key} of <{element.tag}>", text, 1)[0])


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
    path = as_path("path", path)
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


def _find_inertial(path: Path, root: ET.Element, link: str | None) -> tuple[str, ET.Element]:
    links = root.findall("link")
    names = [element.get("name", "") for element in links]
    massive = [name for name, element in zip(names, links, strict=True) if element.find("inertial") is not None]
    if link is None:
        if not massive:
            raise FormatError(f"{path}: no link has an <inertial>; of {len(links)} links none has mass properties.")
        if len(massive) > 1:
            raise InvalidInput(
                f"{path}: has {len(massive)} links with mass; name one as `link`, or take all of them together "
                "at a pose "
                f"with `joints`: {', '.join(massive)}."
            )
        link = massive[0]
    if names.count(link) != 1:
        fault = "has no link" if link not in names else f"has {names.count(link)} links called"
        raise InvalidInput(f"{path}: {fault} {shown(link)}; those with mass are {', '.join(massive) or 'none'}.")
    inertial = links[names.index(link)].find("inertial")
    if inertial is None:
        raise FormatError(f"{path}: link {shown(link)} has no <inertial>, so no mass; links that have are "
                          f"{', '.join(massive) or 'none'}.")
    return link, inertial


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


BODY_FILE = BodyFile(read_urdf_inertial, read_urdf_robot)
