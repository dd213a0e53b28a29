"""The result of building the tables of a spec: a body, and notes on how it was made."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import NamedTuple

from polhode.bodies._inertia import MassProperties
from polhode.bodies.body import Body
from polhode.errors import InvalidInput


class BuiltBody(NamedTuple):
    """A body.

    Attributes:
        body: its mass properties.
        notes: sentences on repairs, rounding and the like.
    """

    body: Body
    notes: tuple[str, ...] = ()


class BuiltPart(NamedTuple):
    """A part in its place.

    Attributes:
        properties: its mass properties along the body's axes.
        density: of its material [kg/m³], None where it is not known.
        notes: sentences on repairs, rounding and the like.
    """

    properties: Body | MassProperties
    density: float | None
    notes: tuple[str, ...] = ()


ReadBody = Callable[[Path], BuiltBody]
"""Returns the body of another spec."""


class PartsRefused(InvalidInput):
    """Parts that no body can have.

    Attributes:
        faults: number of each such part, and a phrase on its mistake.
    """

    def __init__(self, faults: Sequence[tuple[int, InvalidInput]]) -> None:
        super().__init__("; ".join(f"part.{k + 1}: {error}" for k, error in faults))
        self.faults = tuple(faults)
