"""Rules that the keys of a spherical pendulum must satisfy together."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from polhode.kinds import Mistake


def find_mistakes(tables: dict[str, Any]) -> Iterator[Mistake]:
    """Yield the places where the raw tables of a file break a rule, and the messages."""
    if "lean" not in tables["system"] and "rate" not in tables["system"]:
        yield ("system",), 'needs lean, like "30 deg", or rate, like "2 rad/s", for it hangs at rest without'
