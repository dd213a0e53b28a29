"""Rules that the keys of a body with a rotor must satisfy together."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from polhode.spec.rules import Mistake


def find_mistakes(tables: dict[str, Any]) -> Iterator[Mistake]:
    """Yield the places where a raw table [system] breaks a rule, and the messages."""
    system = tables["system"]
    if "motor_torque" in system and system.get("rotor_drive") == "constant-rate":
        yield ("system", "motor_torque"), 'turns a rotor that is free; give rotor_drive = "free", or leave one out'
