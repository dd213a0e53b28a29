"""Torques, mounts and control laws by the names that specs give them: those of wings, and those of other packages."""

from __future__ import annotations

import difflib
from functools import cache
from importlib import import_module
from typing import TYPE_CHECKING, Any, NamedTuple

from polhode._base.plugins import find_entry_points, load_entry_point
from polhode._base.plugins.wings import wing_points
from polhode.errors import InvalidInput, shown

if TYPE_CHECKING:
    from polhode.spacecraft.systems.attachments import AbstractAttachment


class Family(NamedTuple):
    """A family of parts that a table of a spec may name.

    Attributes:
        word: for one of them, in messages.
        base: module and class that all derive from.
        group: of entry points.
    """

    word: str
    base: tuple[str, str]
    group: str


TORQUES = Family("torque", ("polhode.spacecraft.torques.base", "AbstractTorque"), "polhode.torques")
MOUNTS = Family("mount", ("polhode.spacecraft.systems.mounts", "AbstractMounted"), "polhode.mounts")
LAWS = Family("control law", ("polhode.spacecraft.systems.control_laws", "AbstractControlLaw"), "polhode.control")


def part_names(family: Family) -> list[str]:
    """Return the names of all of a family; none is imported."""
    return sorted({*wing_points(family.group), *_others(family)})


def find_part(family: Family, name: str) -> type[AbstractAttachment]:
    """Return the class of a name.

    Raises:
        InvalidInput: where there is none, with the nearest name and all there are, or one of another package that
            cannot be imported, or is not of the family.
    """
    if name in wing_points(family.group):
        return wing_points(family.group)[name].load()
    others = _others(family)
    if name not in others:
        names = part_names(family)
        near = difflib.get_close_matches(str(name), names, 1)
        hint = f"did you mean {near[0]}? " if near else ""
        raise InvalidInput(f"names no {family.word}: {shown(name)}; {hint}known are {', '.join(names)}")
    point = others[name]
    part = load_entry_point(point)
    if not (isinstance(part, type) and issubclass(part, _base(family))):
        raise InvalidInput(
            f"the {family.word} {name} of another package, {point.value}, is not an {family.base[1]}. Update it."
        )
    return part


def _base(family: Family) -> type[AbstractAttachment]:
    module, name = family.base
    return getattr(import_module(module), name)


@cache
def _others(family: Family) -> dict[str, Any]:
    return find_entry_points(family.group, wing_points(family.group))
