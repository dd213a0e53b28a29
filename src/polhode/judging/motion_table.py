"""Hard motions with their exact states: the table that comes with polhode, for judging any engine."""

from __future__ import annotations

import json
from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import cache
from importlib.resources import files
from math import inf
from typing import Any

import numpy as np

from polhode._base import check
from polhode.errors import FormatError, InvalidInput, shown
from polhode.types import Array, Bool, Float64

TABLE = "reference_motions.json"
FORMAT, VERSION = "polhode reference motions", 1
MODERATE = 1000.0
"""Radians of rotation that a stepping engine can follow."""


@dataclass(frozen=True, eq=False)
class ReferenceMotion:
    """One hard motion: its values at time 0, and its exact states at some times; the arrays are read-only.

    Attributes:
        name: what it is, different for every motion.
        family: of motions that are hard for the same reason.
        kind: "free body" or "Lagrange top".
        moments: (3,) principal moments, in any order; of a top (I1, I1, I3) at its fixed point [kg m²].
        momentum: (3,) at time 0, along the principal axes [kg m²/s].
        attitude: (4,) at time 0, unit quaternion (w, x, y, z), body → space.
        mgl: of a top, its weight times the distance from the fixed point to the centre of mass [N m]; 0 of a free body.
        rate: rough bound of |Ω| over the whole motion [rad/s], by which steps may be chosen.
        times: (T,) [s], those nearest to 0 first, some of them negative.
        moderate: (T,) where rate × |t| is 1000 rad at most, which an engine that takes steps can reach.
        attitudes: (T, 4) at the times, up to the sign of each quaternion.
        momenta: (T, 3) at the times [kg m²/s, body axes].
    """

    name: str
    family: str
    kind: str
    moments: Float64[Array, "3"]
    momentum: Float64[Array, "3"]
    attitude: Float64[Array, "4"]
    mgl: float
    rate: float
    times: Float64[Array, "time"]
    moderate: Bool[Array, "time"]
    attitudes: Float64[Array, "time 4"]
    momenta: Float64[Array, "time 3"]


def reference_motions(
    family: str | None = None, *, kind: str | None = None, up_to: float = inf
) -> tuple[ReferenceMotion, ...]:
    """Return the hard motions of the table, whose states were computed to 60 digits and rounded to 17.

    Args:
        family: only those of one family, such as "flips" or "top-cusps".
        kind: only those of one kind, "free body" or "Lagrange top".
        up_to: only times within so many radians of rotation, by the bound ``rate``. An engine that takes
            steps may want ``MODERATE``, 1000; at all times, up to 1e15 rad, only closed forms answer.

    Raises:
        InvalidInput: for a family or kind that the table does not have, and for ``up_to`` below 0.

    >>> motions = reference_motions("flips", up_to=1000.0)
    >>> motions[0].name, motions[0].times.shape, motions[0].attitudes.shape
    ('flips, 10 deg to the first axis', (9,), (9, 4))
    """
    up_to = check.number("up_to", up_to, "rad", least=0, infinite=True)
    motions = _load_shipped()
    for name, wanted in (("family", family), ("kind", kind)):
        if wanted is not None:
            check.one_of(name, wanted, dict.fromkeys(getattr(motion, name) for motion in _load_shipped()))
        motions = tuple(motion for motion in motions if wanted in (None, getattr(motion, name)))
    if not motions:
        raise InvalidInput(f"family {shown(family)} has no motions of kind {shown(kind)}; give one of the two.")
    return motions if up_to == inf else tuple(_cut(motion, up_to) for motion in motions)


def parse_motions(table: dict[str, Any]) -> Iterator[ReferenceMotion]:
    """Yield the motions of a table as JSON has it.

    Raises:
        FormatError: for another format or version.
    """
    header = table.get("format"), table.get("version")
    if header != (FORMAT, VERSION):
        raise FormatError(f"a table must be of format {FORMAT!s}, version {VERSION}; got {shown(header)}.")
    for entry in table["motions"]:
        arrays = {name: np.array(value) for name, value in entry.items() if isinstance(value, list)}
        for array in arrays.values():
            array.setflags(write=False)
        yield ReferenceMotion(**(entry | arrays))


def _cut(motion: ReferenceMotion, up_to: float) -> ReferenceMotion:
    within = motion.rate * np.abs(motion.times) <= up_to
    kept = {name: getattr(motion, name)[within] for name in ("times", "moderate", "attitudes", "momenta")}
    for array in kept.values():
        array.setflags(write=False)
    return replace(motion, **kept)


@cache
def _load_shipped() -> tuple[ReferenceMotion, ...]:
    text = files("polhode.judging").joinpath(TABLE).read_text(encoding="utf-8")
    return tuple(parse_motions(json.loads(text)))
