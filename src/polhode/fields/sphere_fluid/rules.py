"""Rules that the keys of a fluid on a sphere must satisfy together."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from polhode.fields.sphere.start import degree_rules, harmonic_rules
from polhode.spec.rules import Mistake
from polhode.spec.words import list_words

STARTS = ("random", "vortices", "waves")


def find_mistakes(tables: dict[str, Any]) -> Iterator[Mistake]:
    """Yield missing or conflicting starts, and harmonics beyond the resolution."""
    system = tables["system"]
    starts = [key for key in STARTS if key in system]
    if "start_from" in system and starts:
        yield ("system", "start_from"), f"goes without {list_words(starts)}; leave out one or the other"
    if not starts and "start_from" not in system:
        yield ("system",), f"needs a start: {list_words(STARTS)}, which add up, or start_from, an earlier run's file"
    size = system.get("resolution")
    if type(size) is int:
        yield from degree_rules(size, system.get("random"), "random")
        yield from harmonic_rules(size, system.get("waves"), "waves")
