"""Limits on the numbers of a spec where a motion is computed by steps.

Squares and products of them are formed on the way, and double precision ends at 1e±308. What has a closed form is
computed at any size instead; see ``AbstractKind.reach``.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any, NamedTuple

from pydantic import BaseModel

from polhode.errors import InvalidInput
from polhode.spec.rules import Location, Mistake


class ReachLimits(NamedTuple):
    """A number beyond which the numbers of newer kinds are refused."""

    largest: float = 1e100  # in SI, and its reciprocal; everything that turns is within 1e±60


LIMITS = ReachLimits()


def numbers_in(value: Any, at: Location = ()) -> Iterator[tuple[Location, float]]:
    """Yield every real number that a table was given, in SI, with its place; neither defaults nor whole numbers.

    >>> from polhode.spec.models import TimeTable
    >>> list(numbers_in(TimeTable(until="2 min", samples=3)))
    [(('until',), 120.0)]
    """
    if isinstance(value, float):
        yield at, value
    elif isinstance(value, BaseModel):
        for name in value.model_fields_set:
            yield from numbers_in(getattr(value, name), (*at, name))
    elif isinstance(value, dict):
        for name, item in value.items():
            yield from numbers_in(item, (*at, name))
    elif isinstance(value, list | tuple):
        for k, item in enumerate(value):
            yield from numbers_in(item, (*at, k))


def beyond_reach(value: Any, at: Location, reach: float) -> Iterator[Mistake]:
    """Yield the places of numbers that are neither zero nor within reach, and the messages.

    Args:
        value: the table, as its model read it; None for none.
        at: its place in the file.
        reach: the largest size, and one over the smallest.
    """
    for location, number in numbers_in(value, at):
        if not (number == 0.0 or 1.0 / reach <= abs(number) <= reach):
            yield location, (f"must be zero or, in SI units, of a size from {1.0 / reach:g} to {reach:g}; "
                             f"got {number:g}. Check number and unit")


def check_reach(name: str, *numbers: float) -> None:
    """Refuse numbers of an option that are neither zero nor within reach.

    Args:
        name: of the option.
        numbers: in SI.

    Raises:
        InvalidInput: naming the option and the number.
    """
    for _, wrong in beyond_reach(tuple(map(float, numbers)), (), LIMITS.largest):
        raise InvalidInput(f"{name} {wrong}.")


def most_extreme(tables: dict[str, Any]) -> str:
    """Return the number of tables that is farthest from one, as "system.radius is 1e+90 in SI"; empty for none."""
    entries = [(abs(math.log10(abs(number))), location, number)
             for location, number in numbers_in(tables) if number and math.isfinite(number)]
    if not entries:
        return ""
    _, location, number = max(entries, key=lambda one: one[0])
    return f"{'.'.join(map(str, location))} is {number:g} in SI"
