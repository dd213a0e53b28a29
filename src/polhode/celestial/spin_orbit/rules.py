"""Rules that the keys of a spin on an orbit must satisfy together."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from polhode.spec.rules import NO_BODY, Mistake
from polhode.spec.words import list_words


def find_mistakes(tables: dict[str, Any]) -> Iterator[Mistake]:
    """Yield mistakes in shape and orbit, each of which is given in exactly one of two ways."""
    system, has_body = tables["system"], "body" in tables
    if has_body and "asphericity" in system:
        yield ("system", "asphericity"), "goes without [body], whose moments already give it; leave out one"
    if not has_body and "asphericity" not in system:
        yield ("body",), f"{NO_BODY}, or asphericity, √(3(B − A)/C), like 0.89 under [system]"
    axis = [key for key in ("semi_major_axis", "gravitational_parameter") if key in system]
    if "orbital_period" in system and axis:
        yield ("system", "orbital_period"), f"goes without {list_words(axis)}; leave out one or the other"
    elif "orbital_period" not in system and len(axis) != 2:
        yield ("system",), (
            'needs orbital_period, like "21.28 day", or semi_major_axis and gravitational_parameter together; '
            f"got {list_words(axis)}"
        )
