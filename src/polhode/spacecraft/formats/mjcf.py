"""Mass properties in MuJoCo's robot descriptions (MJCF): ``<inertial>`` of a body, or of all bodies at a pose."""

from __future__ import annotations

import math
import xml.etree.ElementTree as ET
from pathlib import Path
from typing import NamedTuple

import numpy as np

from polhode import rotation
from polhode._base import check
from polhode.bodies._inertia import MassProperties
from polhode.bodies.body import Body
from polhode.errors import FormatError, InvalidInput, shown
from polhode.formats.body_file import BodyFile, Pose
from polhode.formats.paths import as_path
from polhode.spacecraft.formats.robot_xml import (
    FREE,
    Frame,
    Motion,
    find_positions,
    finite_numbers,
    join_links,
    list_names,
    make_inertial,
    read_limits,
    read_xml,
    unit_vector,
)
from polhode.types import Array, Float64

UNITS = {"hinge": "rad", "slide": "m", "ball": "", "free": ""}
CHANGE_MASS = {"inertiafromgeom": ("false", "auto"), "balanceinertia": ("false",), "settotalmass": ("-1",),
               "boundmass": ("0",), "boundinertia": ("0",)}  # fmt: skip
SAVED = 'Give its <compiler> saveinertial="true", and save it from MuJoCo by mj_saveLastXML'
ELSEWHERE = ("include", "attach", "replicate", "composite", "flexcomp")
JOINT = ("type", "axis", "pos", "ref", "range", "limited")
ORIENTATIONS = ("quat", "axisangle", "euler", "xyaxes", "zaxis")


class _Node(NamedTuple):
    """A body of the tree: its name, element, frame in its parent at the reference, joints, inertial and children."""

    name: str
    frame: Frame
    joints: list[tuple[Motion, Float64[Array, "3"]]]
    inertial: Body | MassProperties | None
    children: list[_Node]


def read_mjcf_inertial(path: str | Path, name: str | None = None, digits: int | None = None) -> Body:
    """Return a body of an MJCF file, along the axes of its own frame, without its children.

    ``<inertial>`` has the centre of mass, ``pos``, and the inertia about it, ``diaginertia`` along axes rotated by
    ``quat`` or another orientation, or ``fullinertia`` (xx, yy, zz, xy, xz, yz).

    Args:
        path: the file.
        name: of the body; it may be left out where only one has an ``<inertial>``.
        digits: to which the entries of its inertia were rounded, see ``Body.from_inertia``.

    Raises:
        InvalidInput: if the file is missing, or the body is ambiguous.
        FormatError: if it is not MJCF, its mass is not given by ``<inertial>``, or no body has it.

    Source: MuJoCo, *XML reference*, elements body and inertial.
    """
    nodes = [node for top in _Reader(Path(path), digits).tops() for node in _all_of(top)]
    massive = [node.name for node in nodes if node.inertial is not None]
    if name is None and len(massive) == 1:
        name = massive[0]
    have = list_names(massive)
    if name is None:
        raise InvalidInput(
            f"{path}: has {len(massive)} bodies with mass; name one as `link`, or take all of them together at a pose "
            f"with `joints`: {have}."
        )
    inertials = [node.inertial for node in nodes if node.name == name]
    if len(inertials) != 1 or inertials[0] is None:
        raise InvalidInput(f"{path}: has no body {shown(name)} with mass; those with mass are {have}.")
    if not isinstance(inertials[0], Body):
        why = "its inertia is zero, and a point has no attitude"
        raise FormatError(f"{path}: body {shown(name)}: {why}. Give its diaginertia or fullinertia.")
    return inertials[0]


def read_mjcf_robot(path: str | Path, pose: Pose, digits: int | None = None) -> Body:
    """Return all bodies of an MJCF file as one, along the axes of the outermost one.

    A body's joints act one after another: a hinge turns it about an axis through a point of it, a slide moves it along
    one. Joints that the pose does not name are at their reference.

    Args:
        path: the file.
        pose: positions of joints, as MuJoCo counts them, from ``ref`` at the reference.
        digits: to which entries of inertias were rounded, see ``Body.from_inertia``.

    Raises:
        InvalidInput: if the file is missing, or the pose does not fit its joints.
        FormatError: as ``read_mjcf_inertial`` does, and for several outermost bodies.

    Source: MuJoCo, *Computation*, "Kinematics"; mj_kinematics.
    """
    path = as_path("path", path)
    tops = _Reader(path, digits).tops()
    if len(tops) != 1:
        names = list_names([node.name for node in tops])
        raise FormatError(f"{path}: must have one outermost body, to be taken as one; got {len(tops)}: {names}.")
    motions = [motion for node in _all_of(tops[0]) for motion, _ in node.joints]
    positions = find_positions(path, pose, motions)
    links: list[tuple[Frame, Body | MassProperties]] = []
    waiting = [(tops[0]._replace(joints=[]), Frame(), True)]
    while waiting:
        node, outer, outermost = waiting.pop()
        frame = Frame() if outermost else outer.then(_placed_by_joints(node, positions))
        if node.inertial is not None:
            links.append((frame, node.inertial))
        waiting += [(child, frame, False) for child in node.children]
    return join_links(path, links)


def _all_of(top: _Node) -> list[_Node]:
    nodes = [top]
    for node in nodes:
        nodes += node.children
    return nodes


def _placed_by_joints(node: _Node, positions: dict[str, float]) -> Frame:
    """Return a body's frame in its parent: each joint turns it about its anchor or moves it along its axis."""
    frame = node.frame
    for motion, anchor in node.joints:
        step = motion.at(positions.get(motion.name, motion.reference))
        frame = frame.then(Frame(place=anchor)).then(step).then(Frame(place=-anchor))
    return frame


class _Reader:
    """Reads the tree of bodies, with the file's units of angles and defaults of joints."""

    def __init__(self, path: Path, digits: int | None) -> None:
        self.path, self.digits = path, digits
        root = read_xml(path, "MJCF", "mujoco")
        if elsewhere := [element.tag for element in root.iter() if element.tag in ELSEWHERE]:
            raise FormatError(
                f"{path}: has an <{elsewhere[0]}>, whose bodies are not in the file as they stand. Save the compiled "
                "model from MuJoCo, by mj_saveLastXML, and take that file."
            )
        compilers = root.findall("compiler")
        options = {key: value for compiler in compilers for key, value in compiler.attrib.items()}
        for key, harmless in CHANGE_MASS.items():
            if key in options and options[key].rstrip(".0" if key.startswith("bound") else "") not in (*harmless, ""):
                raise FormatError(
                    f"{path}: its <compiler> has {key}={shown(options[key])}, which changes masses and inertias that "
                    f'the file gives. {SAVED}, and take {key} out of that file.'
                )
        if (unit := options.get("angle", "degree")) not in ("degree", "radian"):
            raise FormatError(f"{path}: angle of <compiler> must be degree or radian; got {shown(unit)}.")
        self.per_angle = math.radians(1.0) if unit == "degree" else 1.0
        self.sequence = options.get("eulerseq", "xyz")
        self.limited = "true" if options.get("autolimits", "true") == "true" else "false"  # where a range is given
        self.from_geoms = options.get("inertiafromgeom", "auto")
        self.defaults: dict[str, dict[str, str]] = {"main": {}}
        for element in root.findall("default"):
            self._read_defaults(element, {})
        self.root = root

    def _read_defaults(self, element: ET.Element, above: dict[str, str]) -> None:
        own = dict(above)
        for joint in element.findall("joint"):
            own |= joint.attrib
        name = element.get("class", "main")
        self.defaults[name] = own
        for inner in element.findall("default"):
            self._read_defaults(inner, own)

    def tops(self) -> list[_Node]:
        """Return the outermost bodies, each with those on it."""
        worlds = self.root.findall("worldbody")
        return [node for world in worlds for node in self._read_children(world, Frame(), "main")]

    def _read_children(self, element: ET.Element, frame: Frame, kind: str) -> list[_Node]:
        """Return the bodies in an element; a <frame> only places what is in it."""
        nodes = []
        for inner in element:
            if inner.tag == "body":
                nodes.append(self._body(inner, frame, inner.get("childclass", kind)))
            elif inner.tag == "frame":
                within = frame.then(self._frame(f"{self.path}: a <frame>", inner))
                nodes += self._read_children(inner, within, inner.get("childclass", kind))
        return nodes

    def _body(self, element: ET.Element, outer: Frame, kind: str) -> _Node:
        name = element.get("name", "")
        where = f"{self.path}: body {shown(name)}"
        frame = outer.then(self._frame(where, element))
        joints = [self._joint(where, joint, kind) for joint in element.findall("joint")]
        joints += [(Motion(joint.get("name", ""), ""), np.zeros(3)) for joint in element.findall("freejoint")]
        inertial = element.find("inertial")
        if inertial is None and (element.find("geom") is not None or element.find("frame/geom") is not None):
            raise FormatError(
                f"{where}: has no <inertial>, and MuJoCo takes its mass from its geoms, which are not read. {SAVED}, "
                "or add it."
            )
        own = None if inertial is None else self._inertial(where, inertial)
        return _Node(name, frame, joints, own, self._read_children(element, Frame(), kind))

    def _inertial(self, where: str, element: ET.Element) -> Body | MassProperties | None:
        where = f"{where}: its <inertial>"
        mass = float(finite_numbers(where, "mass", element.get("mass"), 1)[0])
        frame = self._frame(where, element)
        full, diagonal = element.get("fullinertia"), element.get("diaginertia")
        if (full is None) == (diagonal is None):
            raise FormatError(
                f"{where}: must have one of diaginertia and fullinertia; got {'both' if full else 'neither'}."
            )
        if diagonal is not None:
            matrix = np.diag(finite_numbers(where, "diaginertia", diagonal, 3))
        else:
            if any(key in element.attrib for key in ORIENTATIONS):
                raise FormatError(f"{where}: has fullinertia and an orientation, of which MuJoCo takes one alone.")
            xx, yy, zz, xy, xz, yz = finite_numbers(where, "fullinertia", full, 6)
            matrix = np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
        if mass == 0.0 and not matrix.any():  # a frame without matter
            return None
        return make_inertial(where, mass, frame, matrix, self.digits)

    def _joint(self, where: str, element: ET.Element, kind: str) -> tuple[Motion, Float64[Array, "3"]]:
        name = element.get("name", "")
        where = f"{where}: joint {shown(name)}"
        wanted = element.get("class", kind)
        if wanted not in self.defaults:
            raise FormatError(f"{where}: there is no default class {shown(wanted)}.")
        said = {key: value for key, value in (self.defaults[wanted] | element.attrib).items() if key in JOINT}
        type_ = said.get("type", "hinge")
        check.one_of(f"{where}: its type", type_, UNITS, error=FormatError)
        axis = unit_vector(where, "axis", finite_numbers(where, "axis", said.get("axis", "0 0 1"), 3))
        anchor = finite_numbers(where, "pos", said.get("pos", "0 0 0"), 3)
        reference = float(finite_numbers(where, "ref", said.get("ref", "0"), 1)[0])
        unit = UNITS[type_]
        per = self.per_angle if unit == "rad" else 1.0
        ends, limited = said.get("range", "").split(), said.get("limited", "auto").replace("auto", self.limited)
        limits = read_limits(ends[0], ends[1], per) if len(ends) == 2 and limited == "true" else FREE
        return Motion(name, unit, axis, reference * per, limits=limits), anchor

    def _frame(self, where: str, element: ET.Element) -> Frame:
        """Return an element's frame: its pos, and its orientation in one of five forms."""
        place = finite_numbers(where, "pos", element.get("pos", "0 0 0"), 3)
        ways = [key for key in ORIENTATIONS if key in element.attrib]
        if len(ways) > 1:
            raise FormatError(f"{where}: says its orientation {len(ways)} times, by {' and '.join(ways)}; leave one.")
        return Frame(self._turn(where, ways[0], element.get(ways[0])) if ways else np.eye(3), place)

    def _turn(self, where: str, way: str, text: str | None) -> Float64[Array, "3 3"]:
        if way == "quat":
            quaternion = finite_numbers(where, way, text, 4)
            if not quaternion.any():
                raise FormatError(f"{where}: quat must not be zero.")
            return np.asarray(rotation.as_matrix(rotation.normalize(quaternion)))
        if way == "axisangle":
            *axis, angle = finite_numbers(where, way, text, 4)
            vector = unit_vector(where, "axis of axisangle", np.array(axis)) * angle * self.per_angle
            return np.asarray(rotation.as_matrix(rotation.from_rotation_vector(vector)))
        if way == "euler":
            # small letters turn about axes that turn along, capitals about fixed ones: the other way round than here
            angles = finite_numbers(where, way, text, 3) * self.per_angle
            try:
                return np.asarray(rotation.as_matrix(rotation.from_euler_angles(angles, self.sequence.swapcase())))
            except InvalidInput as error:
                raise FormatError(f"{where}: eulerseq {shown(self.sequence)}: {error}") from None
        if way == "xyaxes":
            numbers = finite_numbers(where, way, text, 6)
            x = unit_vector(where, "x of xyaxes", numbers[:3])
            y = unit_vector(where, "y of xyaxes", numbers[3:] - (numbers[3:] @ x) * x)
            return np.column_stack([x, y, np.cross(x, y)])
        z = unit_vector(where, "zaxis", finite_numbers(where, way, text, 3))
        return np.asarray(rotation.as_matrix(rotation.shortest_between((0.0, 0.0, 1.0), z)))


BODY_FILE = BodyFile(read_mjcf_inertial, read_mjcf_robot)
