"""Where a tensor is asked for: a point, an axis or a part of a body, as words say it."""

from __future__ import annotations

from pathlib import Path
from typing import NamedTuple

import numpy as np

from polhode.bodies.body import Body
from polhode.errors import InvalidInput, shown
from polhode.formats.numerals import read_number
from polhode.spec.assembly import name_of, turn_of
from polhode.spec.building import build_part_of
from polhode.spec.models import BodyTable
from polhode.spec.units import parse_quantity
from polhode.types import Array, Float64

THROUGH = " through "
FORMS = (
    'a point like "0 cm, 0 cm, 5 cm", an axis x, y or z of the given axes, 1, 2 or 3 of the principal ones or '
    'a direction '
    'like "1, 0, 1", each perhaps with " through " and a point, or a part by its name or like "part 2"'
)


class Place(NamedTuple):
    """Where a tensor is asked for.

    Attributes:
        label: in words.
        point: (3,) [m, given axes].
        direction: (3,) unit vector of the axis, given axes; None for a point alone.
    """

    label: str
    point: Float64[Array, "3"]
    direction: Float64[Array, "3"] | None


def find_place(text: str, body: Body, table: BodyTable, folder: Path) -> Place:
    """Return the place that words name.

    A given axis or a direction goes through the origin of the given axes, a principal axis through the centre of mass,
    unless it says through which point. A part means its own centre of mass and its own axis z.

    Args:
        text: the words.
        body: of the spec.
        table: that describes the body, for its parts.
        folder: from which its paths count.

    Raises:
        InvalidInput: for words that name no place.
    """
    words = " ".join(text.split())
    parts = table.part or []
    for k, part in enumerate(parts):
        if words in (part.name, f"part {k + 1}"):
            properties = build_part_of(table, k, folder)
            label = f"the centre of mass of {name_of(part, k)}"
            return Place(label, np.asarray(properties.center_of_mass), turn_of(part)[:, 2])
    axis, _, through = words.partition(THROUGH)
    direction = _direction(axis, body)
    if direction is None:
        if through or (point := _point(words)) is None:
            names = [name_of(part, k) for k, part in enumerate(parts)]
            has = f" Its parts are {', '.join(names[:20])}." if names else ""
            raise InvalidInput(f"`about` must be {FORMS}; got {shown(text)}.{has}")
        return Place(f"the point ({words})", point, None)
    point = np.array(body.center_of_mass) if axis in ("1", "2", "3") else np.zeros(3)
    if through and (point := _point(through)) is None:
        raise InvalidInput(f'`about`: a point is three lengths, like "0 cm, 0 cm, 5 cm"; got {shown(through)}.')
    kind = "principal axis " if axis in ("1", "2", "3") else "axis "
    where = f" through ({through})" if through else ""
    return Place(f"{kind}{axis}{where}", point, direction)


def _direction(axis: str, body: Body) -> Float64[Array, "3"] | None:
    if axis in ("x", "y", "z"):
        return np.eye(3)["xyz".index(axis)]
    if axis in ("1", "2", "3"):
        return np.array(body.principal_axes[:, int(axis) - 1])
    try:
        vector = np.array([read_number(word.strip()) for word in axis.strip("[]").split(",")])
    except ValueError:
        return None
    size = np.abs(vector).max()
    if vector.shape != (3,) or not 0.0 < size < np.inf:
        return None
    return vector / size / np.linalg.norm(vector / size)


def _point(words: str) -> Float64[Array, "3"] | None:
    pieces = [piece.strip() for piece in words.strip("()[]").split(",")]
    if len(pieces) != 3:
        return None
    try:
        return np.array([parse_quantity(piece, "m") for piece in pieces])
    except ValueError as error:
        raise InvalidInput(f"`about`: a coordinate {error}.") from None
