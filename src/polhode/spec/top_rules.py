"""Rules that the tables of a top of any kind must satisfy together."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from polhode.spec.rules import Mistake


def top_rules(tables: dict[str, Any], kind: str) -> Iterator[Mistake]:
    """Yield the places where the raw tables of a file break a rule, and the messages."""
    spin, body = tables.get("spin"), tables.get("body")
    if "lean" in tables["system"] and isinstance(spin, dict) and "attitude" in spin:
        yield ("system", "lean"), "goes without spin.attitude, which already says how the body lies; leave out one"
    if isinstance(body, dict) and "mass" not in body and ("moments" in body or "inertia" in body):
        yield ("body",), f'needs mass, like "120 g", for the weight of a {kind}'
