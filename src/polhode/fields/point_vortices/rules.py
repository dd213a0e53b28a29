"""Rules that the keys of point vortices must satisfy together."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from polhode.spec.rules import Mistake
from polhode.spec.words import list_words

IN_PLANE, ON_SPHERE = ("positions", "ring_radius"), ("coordinates", "ring_latitude")


def find_mistakes(tables: dict[str, Any]) -> Iterator[Mistake]:
    """Yield mistakes in the positions: exactly one of four keys may give them, one for each vortex."""
    system = tables["system"]
    ways = (*IN_PLANE, *ON_SPHERE)
    keys = [key for key in ways if key in system]
    if len(keys) != 1:
        yield ("system",), (
            f"needs exactly one of {list_words(ways)}: the first two put the vortices into a plane, the others on a "
            f"sphere; got {list_words(keys)}"
        )
        return
    if "sphere_radius" in system and keys[0] in IN_PLANE:
        yield ("system", "sphere_radius"), f"goes with {list_words(ON_SPHERE, 'or')}, not with {keys[0]}; leave it out"
    strengths, places = system.get("strengths"), system[keys[0]]
    if isinstance(strengths, list) and isinstance(places, list) and len(strengths) != len(places):
        yield ("system", keys[0]), (
            f"needs a place for each vortex; got {len(places)} for the {len(strengths)} strengths"
        )
