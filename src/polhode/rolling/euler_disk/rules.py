"""Rules that the keys of a rolling disk must satisfy together."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

from polhode.errors import shown
from polhode.rolling.euler_disk.laws import law_rules
from polhode.spec.rules import Mistake
from polhode.spec.units import parse_quantity

RATES = ("precession", "spin")


def find_mistakes(tables: dict[str, Any]) -> Iterator[Mistake]:
    """Yield the places where a raw table [system] of a disk breaks a rule, and the messages."""
    system = tables["system"]
    measures = (("thickness", "m"), ("radius", "m"), ("tilt", "rad"))
    thickness, radius, tilt = (_value(system.get(key), unit) for key, unit in measures)
    if thickness is not None and radius is not None and 0.0 < 2.0 * radius < thickness:
        text = f"must be at most the diameter, {2.0 * radius:.6g} m: a disk is not thicker than wide; got "
        yield (
            ("system", "thickness"),
            f"{text}{shown(system['thickness'])}. Check whether radius is a diameter, and the units",
        )
    if thickness and tilt is not None and 0.5 * math.pi <= tilt < math.pi:
        text = f"of a thick disk must be less than 90 deg; got {shown(system['tilt'])}. Beyond it rolls on its other "
        yield ("system", "tilt"), f"{text}rim: turn it over"
    if "spin" in system and "precession" not in system:
        yield ("system", "spin"), "goes with precession, which it follows from; give precession, or both to be checked"
    if "tilt_rate" in system and (missing := [key for key in RATES if key not in system]):
        text = f"is for a start that is not steady, and needs {' and '.join(missing)} with it; leave it out otherwise"
        yield ("system", "tilt_rate"), text
    laws = system.get("dissipation")
    for k, law in enumerate(laws if isinstance(laws, list) else []):
        if isinstance(law, dict):
            yield from ((("system", "dissipation", k), text) for text in law_rules(law))


def _value(raw: Any, unit: str) -> float | None:
    """Return a quantity, None if it is missing or wrong; its field reports a wrong one."""
    try:
        return None if raw is None else parse_quantity(raw, unit)
    except ValueError:
        return None
