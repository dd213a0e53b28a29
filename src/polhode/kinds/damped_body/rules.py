"""What the keys of a body that loses energy ask of each other."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from polhode.spec.rules import Mistake, listed


def damped_rules(system: dict[str, Any]) -> Iterator[Mistake]:
    """Yield where a raw table [system] breaks a rule, and how it is said."""
    outer = [key for key in ("linear_drag", "quadratic_drag", "orbital_period", "eccentricity") if key in system]
    if "damping" in system and outer:
        text = f"is for losses inside, which keep L, and goes without {listed(outer)}; leave out one or the other"
        yield ("system", "damping"), text
    elif not {"damping", "linear_drag", "quadratic_drag"} & set(system):
        text = 'needs damping, like 0.01, or linear_drag, like "0.01 N*m*s", or quadratic_drag'
        yield ("system",), f"{text}; got {listed(outer)}"
    elif "eccentricity" in system and "orbital_period" not in system:
        yield ("system", "eccentricity"), 'goes with orbital_period; give it like "90 min", or leave eccentricity out'
