"""Rules that the keys of a body that loses energy must satisfy together."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from polhode.spec.rules import Mistake
from polhode.spec.words import list_words


def find_mistakes(tables: dict[str, Any]) -> Iterator[Mistake]:
    """Yield the places where a raw table [system] breaks a rule, and the messages."""
    system = tables["system"]
    outer = [key for key in ("linear_drag", "quadratic_drag", "orbital_period", "eccentricity") if key in system]
    inside = [key for key in ("damping", "damping_time", "loss_rate") if key in system]
    if len(inside) > 1:
        text = f"goes without {inside[0]}, as either says how strong the losses are; leave out one"
        yield ("system", inside[1]), text
    elif inside and outer:
        text = f"is for losses inside, which keep L, and goes without {list_words(outer)}; leave out one or the other"
        yield ("system", inside[0]), text
    elif not inside and not {"linear_drag", "quadratic_drag"} & set(system):
        text = (
            'needs damping, like 0.01, damping_time, like "30 min", or loss_rate, like "2 mW"; or linear_drag, like '
            '"0.01 N*m*s", or quadratic_drag'
        )
        if "orbital_period" in system:
            text += "; without any, gravity's gradient is a [[torque]] of the kind that takes [orbit]"
        yield ("system",), f"{text}; got {list_words(outer)}"
    elif "eccentricity" in system and "orbital_period" not in system:
        yield ("system", "eccentricity"), 'goes with orbital_period; give it like "90 min", or leave eccentricity out'
