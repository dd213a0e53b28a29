"""What robot descriptions share: XML without surprises, numbers in it, and links put together at a pose."""

from __future__ import annotations

import math
import warnings
import xml.etree.ElementTree as ET
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import NamedTuple

import numpy as np

from polhode import rotation
from polhode.bodies._inertia import MassProperties, digits_that_explain, take_rounded
from polhode.bodies.body import Body, combine
from polhode.errors import FormatError, InvalidInput, shown
from polhode.formats.body_file import Pose
from polhode.formats.numerals import read_number
from polhode.formats.opening import MB, read_file
from polhode.types import Array, Float64

LARGEST_FILE = 16 * MB  # robots of a thousand links take one
# places in the matrix of inertia, by attribute
ENTRIES = {f"i{'xyz'[i]}{'xyz'[j]}": (i, j) for i in range(3) for j in range(i, 3)}
FREE = (-math.inf, math.inf)  # limits of a joint that has none


class MessageLimits(NamedTuple):
    """How much a message names."""

    max_named: int = 20  # links or joints


LIMITS = MessageLimits()


class Frame(NamedTuple):
    """Axes given in others: r ↦ R r + d.

    Attributes:
        turn: R (3, 3).
        place: d (3,) [m].
    """

    turn: Float64[Array, "3 3"] = np.eye(3)
    place: Float64[Array, "3"] = np.zeros(3)

    def then(self, inner: Frame) -> Frame:
        """Compose frames: return one that is given in this frame, expressed in the outer axes."""
        return Frame(self.turn @ inner.turn, self.turn @ inner.place + self.place)

    def inverse(self) -> Frame:
        """Return the frame of the outer axes in these."""
        return Frame(self.turn.T, -self.turn.T @ self.place)


class Motion(NamedTuple):
    """The motion of a link that a joint allows.

    Attributes:
        name: of the joint, "" without one.
        unit: of its position: "rad", "m", or "" for one that cannot be set.
        axis: (3,) unit vector, in the joint's axes.
        reference: position at which the link is as described, in SI.
        follows: another joint whose position it follows, times a factor and plus an offset; None for none.
        limits: of its position, the lower first, in SI.
    """

    name: str
    unit: str
    axis: Float64[Array, "3"] = np.array([1.0, 0.0, 0.0])
    reference: float = 0.0
    follows: tuple[str, float, float] | None = None
    limits: tuple[float, float] = FREE

    def at(self, position: float) -> Frame:
        """Return the moved axes in those at the reference."""
        moved = position - self.reference
        if self.unit == "m":
            return Frame(place=moved * self.axis)
        if self.unit == "rad":
            return Frame(np.asarray(rotation.as_matrix(rotation.from_rotation_vector(moved * self.axis))))
        return Frame()


def read_xml(path: Path, kind: str, root_tag: str) -> ET.Element:
    """Return the outermost element of a robot description.

    Raises:
        InvalidInput: if the file is missing.
        FormatError: if it is not XML, declares a document type, or has another outermost element.
    """
    try:
        root = ET.fromstring(read_file(path, kind, LARGEST_FILE), ET.XMLParser(target=_NoEntities()))
    except InvalidInput:
        raise
    except (ET.ParseError, ValueError, LookupError) as error:
        raise FormatError(f"{path}: is not {kind}, which is XML: {error}. Check the file.") from None
    if root.tag != root_tag:
        raise FormatError(f"{path}: is not {kind}: its outermost element must be <{root_tag}>; got <{root.tag}>.")
    return root


class _NoEntities(ET.TreeBuilder):
    """Robots need no document type, and entities declared in one can grow without bound."""

    def doctype(self, name: str, pubid: str | None, system: str | None) -> None:
        raise ValueError("it declares a document type, which robots have no use for")


def find_child(where: str, parent: ET.Element, tag: str) -> ET.Element:
    """Return an element that must be there."""
    child = parent.find(tag)
    if child is None:
        raise FormatError(f"{where}: its <{parent.tag}> has no <{tag}>. Add it.")
    return child


def finite_numbers(where: str, what: str, text: str | None, count: int) -> Float64[Array, "count"]:
    """Return a number of finite numbers from text.

    Raises:
        FormatError: for other words, or another number of them.
    """
    words = (text or "").split()
    try:
        values = [read_number(word) for word in words]
    except ValueError:
        hint = " Expand the xacro first." if "$" in (text or "") else " Check the file."
        raise FormatError(
            f"{where}: {what} must be finite numbers in decimal digits; got {shown(text)}.{hint}"
        ) from None
    if len(values) != count:
        number = {3: "three numbers", 1: "one number"}.get(count, f"{count} numbers")
        raise FormatError(f"{where}: {what} must be {number}; got {shown(text)}.")
    return np.array(values)


def read_limits(lower: str | None, upper: str | None, unit: float = 1.0) -> tuple[float, float]:
    """Return limits of a joint, given in a unit; none where they cannot be read, as no mass depends on them."""
    try:
        return float(lower or "") * unit, float(upper or "") * unit
    except ValueError:
        return FREE


def from_fixed_angles(angles: Float64[Array, "3"]) -> Float64[Array, "3 3"]:
    """Return Rz(yaw) Ry(pitch) Rx(roll)."""
    (a, b, c), (s, t, u) = np.cos(angles), np.sin(angles)
    return np.array([
        [c * b, c * t * s - u * a, c * t * a + u * s],
        [u * b, u * t * s + c * a, u * t * a - c * s],
        [-t, b * s, b * a],
    ])


def unit_vector(where: str, what: str, vector: Float64[Array, "3"]) -> Float64[Array, "3"]:
    """Return a direction with length one; zero is refused."""
    size = float(np.abs(vector).max())
    if not size > 0.0:
        raise FormatError(f"{where}: {what} must not be zero, as it is a direction. Check the file.")
    return vector / size / np.linalg.norm(vector / size)


def make_inertial(
    where: str, mass: float, frame: Frame, inertia: Float64[Array, "3 3"], digits: int | None
) -> Body | MassProperties:
    """Return the mass properties of a link along its axes; a link that has mass and no inertia is a point.

    Args:
        where: for messages.
        mass: [kg].
        frame: of the inertia in the link, its origin at the centre of mass.
        inertia: (3, 3) [kg m²].
        digits: to which the entries were rounded; None for exact ones.

    Raises:
        FormatError: for what no body has, with the remedy where rounding explains it.
    """
    try:
        if digits is not None and np.array_equal(inertia, inertia.T):
            inertia = take_rounded(inertia, digits)
        if mass > 0.0 and not inertia.any():
            return MassProperties(mass, frame.place, np.zeros((3, 3)))
        return Body(mass, np.zeros(3), inertia).placed(frame.turn, frame.place)
    except InvalidInput as error:
        enough = digits_that_explain(inertia) if digits is None and np.isfinite(inertia).all() else None
        remedy = f' Rounding to {enough} digits explains it: say rounding = "{enough} digits" to take the nearest ones.'
        raise FormatError(f"{where}: {error}{remedy if enough and mass > 0.0 else ''}") from None


def make_links(
    path: Path, links: Sequence[tuple[Frame, Callable[[], Body | MassProperties]]]
) -> list[tuple[Frame, Body | MassProperties]]:
    """Return links in their places, made by functions.

    Raises:
        FormatError: naming every link whose mass properties are faulty.
    """
    made, faults = [], []
    for frame, make in links:
        try:
            made.append((frame, make()))
        except FormatError as error:
            faults.append(str(error))
    if len(faults) > 1:
        more = f" And {len(faults) - LIMITS.max_named} more." if len(faults) > LIMITS.max_named else ""
        said = " ".join(fault.removeprefix(f"{path}: ") for fault in faults[: LIMITS.max_named])
        raise FormatError(f"{path}: {len(faults)} of {len(links)} links have faulty mass properties. {said}{more}")
    if faults:
        raise FormatError(faults[0])
    return made


def join_links(path: Path, links: Sequence[tuple[Frame, Body | MassProperties]]) -> Body:
    """Return links in their places as one body.

    Raises:
        FormatError: if none has mass, or they are no body together.
    """
    if not links:
        raise FormatError(f"{path}: no link has an <inertial>, so that nothing has mass.")
    placed = [
        one.placed(frame.turn, frame.place) if isinstance(one, Body)
        else one._replace(center_of_mass=frame.turn @ one.center_of_mass + frame.place)
        for frame, one in links
    ]
    try:
        return combine(placed)
    except InvalidInput as error:
        raise FormatError(f"{path}: its links together: {error}") from None


def list_names(names: Sequence[str]) -> str:
    """Return the first of some names as a list for a message."""
    return ", ".join(names[: LIMITS.max_named]) or "none"


def find_positions(path: Path, pose: Pose, motions: Sequence[Motion]) -> dict[str, float]:
    """Return the position of every joint that has a name: as given, following another one, or at its reference.

    Joints beyond their limits are warned of; links have mass properties there all the same.

    Raises:
        InvalidInput: for joints that do not exist or cannot be set, and positions in a wrong unit.
    """
    known = {motion.name: motion for motion in motions if motion.name}
    free = [name for name, motion in known.items() if motion.unit and motion.follows is None]
    for name, (_, unit) in pose.items():
        if name not in known:
            raise InvalidInput(f"{path}: has no joint {shown(name)}; those that can be set are {list_names(free)}.")
        motion = known[name]
        if motion.follows is not None:
            raise InvalidInput(f"{path}: joint {shown(name)} follows {shown(motion.follows[0])}; set that one.")
        if not motion.unit:
            raise InvalidInput(
                f"{path}: joint {shown(name)} is fixed, or has more than one coordinate, and cannot be set; "
                "leave it out."
            )
        if unit != motion.unit:
            wanted = 'an angle like "30 deg"' if motion.unit == "rad" else 'a distance like "10 cm"'
            raise InvalidInput(f"{path}: joint {shown(name)} must be at {wanted}.")
    positions = {name: pose[name][0] if name in pose else motion.reference for name, motion in known.items()}
    followed = {name: _follow(path, known, positions, name) for name in known}
    _warn_beyond_limits(path, known, followed)
    return followed


def _warn_beyond_limits(path: Path, known: Mapping[str, Motion], positions: Mapping[str, float]) -> None:
    beyond = []
    for name, motion in known.items():
        (lower, upper), position = motion.limits, positions[name]
        # exporters write 0 and 0 where they know no limits; and a position may be typed with six digits
        if lower < upper and not lower - 1e-6 * abs(lower) <= position <= upper + 1e-6 * abs(upper):
            beyond.append(f"{shown(name)} at {position:.6g} {motion.unit}, beyond {lower:.6g} to {upper:.6g}")
    if beyond:
        more = f" and {len(beyond) - LIMITS.max_named} more" if len(beyond) > LIMITS.max_named else ""
        warnings.warn(
            f"{path}: joints are beyond their limits: {'; '.join(beyond[: LIMITS.max_named])}{more}. The mass "
            "properties are those of this pose; to give another one, set them under `joints`.", stacklevel=2,
        )


def _follow(path: Path, known: Mapping[str, Motion], positions: Mapping[str, float], name: str) -> float:
    """Return the position of a joint that may follow another one, which may follow one in turn."""
    factor, offset, chain = 1.0, 0.0, [name]
    while (follows := known[chain[-1]].follows) is not None:
        leader, times, plus = follows
        if leader not in known or leader in chain:
            what = "follows itself" if leader in chain else f"follows {shown(leader)}, which is no joint that can move"
            raise FormatError(f"{path}: joint {shown(name)} {what}. Check its <mimic>.")
        factor, offset = factor * times, offset + factor * plus
        chain.append(leader)
    return factor * positions[chain[-1]] + offset
