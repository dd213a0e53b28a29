"""Rules that the keys of a quantum rotor must satisfy together."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from polhode.spec.rules import Mistake


def find_mistakes(tables: dict[str, Any]) -> Iterator[Mistake]:
    """Yield the places where the raw tables of a file break a rule, and the messages."""
    system = tables["system"]
    if ("constants" in system) == ("body" in tables):
        both = "constants" in system
        said = "is there, and [body] too, which has constants of its own; leave one out" if both else (
            'is missing; give three, like ["835.8 GHz", "435.4 GHz", "278.1 GHz"], or molecule = "water.xyz" under '
            "[body]"
        )
        yield ("system", "constants"), said
    if system.get("distortion"):
        for key, like in (("reduction", '"A" or "S"'), ("representation", '"Ir"')):
            if key not in system:
                yield ("system", key), (
                    f"is missing; distortion constants have a meaning only together with it. Give it as their source "
                    f"does, like {like}"
                )
