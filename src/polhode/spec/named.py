"""Torques, mounts and control laws by the names that specs give them: this package's own, and those of others."""

from __future__ import annotations

import difflib
import pkgutil
from functools import cache
from importlib import import_module
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

from polhode.errors import InvalidInput, shown
from polhode.plugins import find_entry_points, load_entry_point

if TYPE_CHECKING:
    from polhode.systems.attachments import AbstractAttachment


NAMED = "name: ClassVar[str] = "  # in the file of a class that a spec may name


class Family(NamedTuple):
    """What one table of a spec may name.

    Attributes:
        word: for one of it, in messages.
        base: module and class that all derive from.
        group: of entry points.
    """

    word: str
    base: tuple[str, str]
    group: str


TORQUES = Family("torque", ("polhode.systems.torques.base", "AbstractTorque"), "polhode.torques")
MOUNTS = Family("mount", ("polhode.systems.mounts", "AbstractMounted"), "polhode.mounts")
LAWS = Family("control law", ("polhode.systems.control_laws", "AbstractControlLaw"), "polhode.control")


def part_names(family: Family) -> list[str]:
    """Return the names of all of a family; those of other packages are not imported."""
    return sorted({*_own(family), *_others(family)})


def find_part(family: Family, name: str) -> type[AbstractAttachment]:
    """Return the class of a name.

    Raises:
        InvalidInput: where there is none, with the nearest name and all there are, or one of another package that
            cannot be imported, or is not of the family.
    """
    if name in _own(family):
        return _own(family)[name]
    others = _others(family)
    if name not in others:
        names = part_names(family)
        near = difflib.get_close_matches(str(name), names, 1)
        hint = f"did you mean {near[0]}? " if near else ""
        raise InvalidInput(f"names no {family.word}: {shown(name)}; {hint}known are {', '.join(names)}")
    point = others[name]
    found = load_entry_point(point)
    if not (isinstance(found, type) and issubclass(found, _base(family))):
        raise InvalidInput(
            f"the {family.word} {name} of another package, {point.value}, is not an {family.base[1]}. Update it."
        )
    return found


def _base(family: Family) -> type[AbstractAttachment]:
    module, name = family.base
    return getattr(import_module(module), name)


@cache
def _own(family: Family) -> dict[str, type[AbstractAttachment]]:
    systems = import_module("polhode.systems")  # with JAX, which specs of other kinds do without
    base, found = _base(family), {}
    for module in pkgutil.walk_packages(systems.__path__, "polhode.systems."):
        source = find_spec(module.name)
        if source is None or source.origin is None or NAMED not in Path(source.origin).read_text("utf-8"):
            continue  # most systems are none of these, and cost time to import
        things = vars(import_module(module.name)).values()
        found |= {thing.name: thing for thing in things
                  if isinstance(thing, type) and issubclass(thing, base) and thing.name}  # fmt: skip
    return found


@cache
def _others(family: Family) -> dict[str, Any]:
    return find_entry_points(family.group, _own(family))
