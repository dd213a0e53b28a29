"""Mass properties in Gazebo's robot descriptions (SDF): ``<inertial>`` of a link, or of all links at a pose."""

from __future__ import annotations

import xml.etree.ElementTree as ET
from functools import partial
from pathlib import Path

import numpy as np

from polhode import rotation
from polhode._base import check
from polhode.bodies._inertia import MassProperties
from polhode.bodies.body import Body
from polhode.errors import FormatError, InvalidInput, shown
from polhode.formats.body_file import BodyFile, Pose
from polhode.formats.paths import as_path
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
    list_names,
    make_inertial,
    make_links,
    read_limits,
    read_xml,
    unit_vector,
)

UNITS = {"revolute": "rad", "continuous": "rad", "prismatic": "m"}
OPEN = {"lower": "-inf", "upper": "inf"}  # limits where the file gives none
UNITS |= dict.fromkeys(("fixed", "ball", "screw", "universal", "revolute2", "gearbox"), "")
MODEL = ("", "__model__")


def read_sdf_inertial(path: str | Path, link: str | None = None, digits: int | None = None) -> Body:
    """Return a link of an SDF file as a body, along the axes of the link's own frame.

    ``<pose>`` in ``<inertial>`` places the centre of mass and turns the axes of the inertia by roll, pitch and yaw
    about fixed axes. Off-diagonal entries are those of the matrix.

    Args:
        path: the file, of one model.
        link: its name; it may be left out where there is one link only.
        digits: to which the entries of its inertia were rounded, see ``Body.from_inertia``.

    Raises:
        InvalidInput: if the file is missing, or the link is ambiguous.
        FormatError: if it is not SDF, the link has no ``<inertial>``, or no body has these mass properties.

    Source: Open Robotics, *SDFormat specification* 1.11, link, inertial (``auto`` and the defaults) and pose.
    """
    path = as_path("path", path)
    links = _elements_by_name(path, _model(path), "link")
    have = list_names(list(links))
    if link is None:
        if len(links) != 1:
            raise InvalidInput(f"{path}: has {len(links)} links; name one as `link`, or take all of them "
                               "together at a pose "
                               f"with `joints`: {have}.")
        link = next(iter(links))
    if link not in links:
        raise InvalidInput(f"{path}: has no link {shown(link)}; it has {have}.")
    body = _inertial(path, link, links[link], digits)
    if not isinstance(body, Body):
        why = "its inertia is zero, and a point has no attitude"
        raise FormatError(f"{path}: link {shown(link)}: {why}. Give its <inertia>.")
    return body


def read_sdf_robot(path: str | Path, pose: Pose, digits: int | None = None) -> Body:
    """Return all links of an SDF file's model as one body, along the model's axes.

    Links are where their ``<pose>`` says while every joint is at zero. A joint at another position turns or moves its
    child, and what hangs on it, about or along its axis.

    Args:
        path: the file, of one model.
        pose: positions of joints, zero for others.
        digits: to which entries of inertias were rounded, see ``Body.from_inertia``.

    Raises:
        InvalidInput: if the file is missing, or the pose does not fit its joints.
        FormatError: if it is not SDF, a link has no ``<inertial>``, or no body has their mass properties.

    Source: Open Robotics, *SDFormat specification* 1.11, joint, and *Pose frame semantics*.
    """
    path = as_path("path", path)
    model = _model(path)
    poses = _Poses(path, model)
    links, joints = _elements_by_name(path, model, "link"), _elements_by_name(path, model, "joint")
    motions = {name: _motion(path, name, element, poses) for name, element in joints.items()}
    positions = find_positions(path, pose, list(motions.values()))
    on: dict[str, tuple[str, str]] = {}
    for name, element in joints.items():
        where = f"{path}: joint {shown(name)}"
        parent, child = ((find_child(where, element, tag).text or "").strip() for tag in ("parent", "child"))
        if child not in links or parent not in {*links, "world", "__model__"}:
            raise FormatError(f"{where}: there is no link {shown(child if child not in links else parent)}.")
        if positions.get(name, 0.0) and child in on:
            raise FormatError(f"{where}: its link hangs on another joint too, so that no position follows from a pose.")
        on.setdefault(child, (name, parent))
    placed = []
    for name, element in links.items():
        frame, link, visited = poses.of(name), name, {name}
        while link in on:
            joint, link = on[link]
            if link in visited:
                raise FormatError(f"{path}: its joints make a ring through link {shown(link)}; a pose needs a tree.")
            visited.add(link)
            at = poses.of_joint(joint)
            frame = at.then(motions[joint].at(positions[joint])).then(at.inverse()).then(frame)
        placed.append((frame, partial(_inertial, path, name, element, digits)))
    return join_links(path, make_links(path, placed))


def _model(path: Path) -> ET.Element:
    root = read_xml(path, "SDF", "sdf")
    models = [*root.findall("model"), *root.findall("world/model")]
    if len(models) != 1:
        raise FormatError(f"{path}: must hold one <model>; got {len(models)}. Split the file.")
    (model,) = models
    if nested := [tag for tag in ("include", "model") if model.find(tag) is not None]:
        raise FormatError(
            f"{path}: its model has a <{nested[0]}> in it, which is not read. Put all links in one model."
        )
    return model


def _elements_by_name(path: Path, model: ET.Element, tag: str) -> dict[str, ET.Element]:
    elements = model.findall(tag)
    named = {element.get("name", ""): element for element in elements}
    if len(named) != len(elements):
        raise FormatError(f"{path}: several elements <{tag}> have the same name. Rename them.")
    return named


def _pose(where: str, parent: ET.Element) -> tuple[Frame, str | None]:
    """Return an element's <pose>, and the name of its frame, None where it names none."""
    element = parent.find("pose")
    if element is not None and element.get("frame"):
        raise FormatError(
            f"{where}: its <pose> names another frame, as before SDF 1.7. Convert the file with Gazebo's tool."
        )
    if element is None or not (element.text or "").strip():
        return Frame(), None if element is None else element.get("relative_to")
    if element.get("rotation_format", "euler_rpy") == "quat_xyzw":
        *place, x, y, z, w = finite_numbers(where, "its <pose>", element.text, 7)
        turn = np.asarray(rotation.as_matrix(rotation.normalize(np.array([w, x, y, z]))))
    else:
        numbers = finite_numbers(where, "its <pose>", element.text, 6)
        place, angles = numbers[:3], numbers[3:]
        turn = from_fixed_angles(np.radians(angles) if element.get("degrees") == "true" else angles)
    return Frame(turn, np.array(place)), element.get("relative_to")


class _Poses:
    """The frames of a model's links, joints and frames, each given in the one that it names."""

    def __init__(self, path: Path, model: ET.Element) -> None:
        self.path = path
        self.elements = {(tag, name): element for tag in ("link", "joint", "frame")
                         for name, element in _elements_by_name(path, model, tag).items()}

    def of(self, name: str, above: tuple[str, ...] = ()) -> Frame:
        """Return an element's frame in the model."""
        if name in MODEL:
            return Frame()
        keys = [key for key in self.elements if key[1] == name]
        if len(keys) != 1 or name in above:
            unknown = f"names {shown(name)}, which is not one link, joint or frame"
            what = "goes round in circles" if name in above else unknown
            raise FormatError(f"{self.path}: a <pose> {what}. Check relative_to and attached_to.")
        (tag, _), element = keys[0], self.elements[keys[0]]
        frame, outer = _pose(f"{self.path}: {tag} {shown(name)}", element)
        if outer is None:  # of a joint the child's, of a frame that of its attachment, of a link the model's
            child, attached = (element.findtext("child") or "").strip(), element.get("attached_to", "")
            outer = {"link": "", "joint": child, "frame": attached}[tag]
        return self.of(outer, (*above, name)).then(frame)

    def of_joint(self, name: str) -> Frame:
        """Return a joint's frame in the model."""
        return self.of(name)


def _motion(path: Path, name: str, element: ET.Element, poses: _Poses) -> Motion:
    where, kind = f"{path}: joint {shown(name)}", element.get("type", "")
    check.one_of(f"{where}: its type", kind, UNITS, error=FormatError)
    if not UNITS[kind]:
        return Motion(name, "")
    xyz = find_child(where, find_child(where, element, "axis"), "xyz")
    axis = unit_vector(where, "its axis", finite_numbers(where, "its <xyz>", xyz.text, 3))
    outer = xyz.get("expressed_in")
    if (element.findtext("axis/use_parent_model_frame") or "").strip() in ("1", "true"):  # before version 1.7
        outer = ""
    if outer is not None:
        axis = poses.of_joint(name).turn.T @ poses.of(outer).turn @ axis
    limits = FREE
    if kind != "continuous":
        lower, upper = (element.findtext(f"axis/limit/{end}", default) for end, default in OPEN.items())
        limits = read_limits(lower, upper)
    mimic = element.find("axis/mimic")
    if mimic is None:
        return Motion(name, UNITS[kind], axis, limits=limits)
    factor, offset, reference = (
        float(finite_numbers(where, f"<{tag}> of <mimic>", mimic.findtext(tag) or default, 1)[0])
        for tag, default in (("multiplier", "1"), ("offset", "0"), ("reference", "0"))
    )
    follows = mimic.get("joint", ""), factor, offset - factor * reference
    return Motion(name, UNITS[kind], axis, 0.0, follows, limits)


def _inertial(path: Path, name: str, link: ET.Element, digits: int | None) -> Body | MassProperties:
    where, inertial = f"{path}: link {shown(name)}", link.find("inertial")
    if inertial is not None and inertial.get("auto", "").strip().lower() in ("true", "1"):
        raise FormatError(
            f"{where}: its <inertial> is automatic: Gazebo computes mass and inertia from its collisions and their "
            "densities, which is not done here. Write the mass, pose and inertia that Gazebo finds (gz sdf "
            "--inertial-stats) into it and take auto out, or describe the shapes as parts of a [body]."
        )
    if inertial is None or inertial.find("mass") is None or inertial.find("inertia") is None:
        missing = "inertial" if inertial is None else "mass" if inertial.find("mass") is None else "inertia"
        put = {"inertial": "1 kg and 1 kg m² about each axis", "mass": "1 kg", "inertia": "1 kg m² about each axis"}
        raise FormatError(f"{where}: has no <{missing}>, for which SDF puts {put[missing]}. Add what the link has.")
    frame, outer = _pose(f"{where}: its <inertial>", inertial)
    if outer not in (None, "", name):
        raise FormatError(f"{where}: the <pose> of its <inertial> must be in the link; got relative_to={shown(outer)}.")
    mass = float(finite_numbers(where, "<mass>", inertial.findtext("mass"), 1)[0])
    matrix = np.zeros((3, 3))
    for key, (i, j) in ENTRIES.items():
        text = inertial.findtext(f"inertia/{key}")
        default = None if i == j else "0"
        matrix[i, j] = matrix[j, i] = finite_numbers(where, f"<{key}>", text or default, 1)[0]
    return make_inertial(where, mass, frame, matrix, digits)


BODY_FILE = BodyFile(read_sdf_inertial, read_sdf_robot)
