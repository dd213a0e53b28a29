"""The meaning of the numbers in a packed state."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, NamedTuple

from polhode.errors import shown


class StatePart(NamedTuple):
    """A part of a packed state.

    Attributes:
        name: of the part.
        size: how many components of the last axis it takes.
        unit: of the components, as CF metadata writes units; "" where that depends on the system.
        meaning: in a few words.
        frame: "body" or "space" for components of a vector along these axes, "given" for the body's given axes where
            its momentum is along the principal ones, "" otherwise.
    """

    name: str
    size: int = 1
    unit: str = ""
    meaning: str = ""
    frame: str = ""


class Quantity(NamedTuple):
    """Unit and meaning of a conserved or balanced quantity, for files and tables.

    Attributes:
        unit: as CF metadata writes units; "" where it depends on the system.
        meaning: in a few words.
        of_copies: whether the last axis of the values counts the copies of a batch, not components of a vector.
    """

    unit: str = ""
    meaning: str = ""
    of_copies: bool = False


ATTITUDE = StatePart("attitude", 4, "1", "attitude quaternion, scalar first, body to space")
MOMENTUM = StatePart("momentum", 3, "kg m2 s-1", "angular momentum", "body")
LINEAR = StatePart("linear", 3, "", "linear momentum, or a vector fixed in space", "body")
ANGULAR_VELOCITY = StatePart("angular_velocity", 3, "rad s-1", "angular velocity", "body")
"""The state of a recording that has nothing else, as a gyroscope's."""


ENERGY = Quantity("J", "energy")
MOMENTUM_NORM = Quantity("kg m2 s-1", "magnitude of the angular momentum")
MOMENTUM_SPACE = Quantity("kg m2 s-1", "angular momentum along the space axes")
MOMENTUM_SQUARED = Quantity("kg2 m4 s-2", "squared angular momentum")


@dataclass(frozen=True)
class StateLayout:
    """The parts of a packed state (…, n), in their order along the last axis.

    Attributes:
        parts: in order; none where a state is one matrix, or a point of a dual whose components have no names.
        axes: how many of a state's last axes are its own.

    >>> layout = StateLayout((ATTITUDE, MOMENTUM, StatePart("rotor_momentum", 1, "kg m2 s-1")))
    >>> layout.part(list(range(8)), "rotor_momentum"), layout.names
    (7, ('attitude', 'momentum', 'rotor_momentum'))
    """

    parts: tuple[StatePart, ...] = ()
    axes: int = 1

    @property
    def names(self) -> tuple[str, ...]:
        """The parts by name."""
        return tuple(part.name for part in self.parts)

    @property
    def scalars(self) -> dict[str, StatePart]:
        """The parts that are one component each, by name."""
        return {part.name: part for part in self.parts if part.size == 1}

    def place(self, name: str) -> slice:
        """Return the slice of a part along the last axis.

        Raises:
            KeyError: for a part that the state does not have.
        """
        begin = 0
        for part in self.parts:
            if part.name == name:
                return slice(begin, begin + part.size)
            begin += part.size
        raise KeyError(f"a state has no part {shown(name)}; its parts are {', '.join(self.names) or 'not named'}")

    def part(self, states: Any, name: str) -> Any:
        """Return a part of packed states: (…) of one component, else (…, size).

        Raises:
            KeyError: for a part that the state does not have.
        """
        place = self.place(name)
        if isinstance(states, list | tuple):
            return states[place.start] if place.stop - place.start == 1 else states[place]
        return states[..., place.start] if place.stop - place.start == 1 else states[..., place]
