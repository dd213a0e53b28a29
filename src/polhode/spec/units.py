"""Quantities with units, as people write them in files: "60 rpm", "12 g*cm^2"."""

from __future__ import annotations

import math
import re
from functools import cache
from typing import Any

EXAMPLES = {
    "kg": "52 g",
    "m": "12 mm",
    "s": "20 s",
    "rad": "1 deg",
    "rad/s": "60 rpm",
    "kg*m^2": "1.2 g*cm^2",
    "kg*m^2/s": "0.3 kg*m^2/s",
    "kg/m^3": "2700 kg/m^3",
    "m/s^2": "9.81 m/s^2",
    "N*m": "0.1 N*m",
    "N*m*s": "0.01 N*m*s",
    "N*m*s^2": "0.01 N*m*s^2",
    "m^3/s^2": "3.986e14 m^3/s^2",
    "m/s": "1 m/s",
    "Pa*s": "1.8e-5 Pa*s",
    "W*s^2": "2e-8 W*s^2",
    "W*s^2.5": "2e-9 W*s^2.5",
}
QUANTITY = re.compile(
    r"\s*(?P<number>[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?|[+-]?(?:nan|inf)(?!\w))\s*\*?\s*(?P<unit>.*)", re.DOTALL
)
ANGLES = {"radian", "degree", "turn", "arcminute", "arcsecond", "milliarcsecond", "grade", "revolutions_per_minute",
          "dps", "cpm", "revolutions_per_second"}  # fmt: skip


@cache
def _registry() -> Any:
    import pint

    registry = pint.UnitRegistry()
    registry.define("rev = turn")
    registry.define("dps = degree / second")
    registry.define("cpm = turn / minute")
    return registry


def parse_quantity(value: Any, unit: str) -> float:
    """Return the value of a quantity like "60 rpm" in the given SI unit.

    Raises:
        ValueError: with what is wrong and what would be right; pydantic collects it with the key's path.
    """
    example = EXAMPLES[unit]
    if isinstance(value, bool) or not isinstance(value, str):
        raise ValueError(f'needs a number with its unit in quotes, like "{example}"; got {value!r}')
    registry, parts = _registry(), QUANTITY.match(value)
    try:
        if parts is None:
            raise ValueError
        magnitude = float(parts["number"])
        # one number and one unit: pint alone would take "60 rpm 2" for 120 rpm
        unit_text = parts["unit"]
        unit_text = f"1{unit_text}" if unit_text.startswith("/") else unit_text
        quantity = registry.Quantity(magnitude, registry.parse_units(unit_text))
    except Exception as error:  # pint raises errors of many kinds, tokenizer's and its own
        if unknown := getattr(error, "unit_names", None):
            raise ValueError(_unknown_unit(unknown, value, example)) from None
        raise ValueError(f'cannot be read as a quantity: {value!r}; write it like "{example}"') from None
    if not math.isfinite(magnitude):
        raise ValueError(f"must be finite; got {value!r}")
    names = set(dict(quantity.unit_items()))
    if unit == "rad/s":
        _refuse_cycles(value, names)
    if unit == "kg*m^2/s" and any("hertz" in name for name in names):
        raise ValueError(f'is ambiguous: {value!r} may mean turns or radians; write it like "{example}"')
    if not names:
        raise ValueError(f'needs a unit, like "{example}"; got {value!r}')
    try:
        result = float(quantity.to(unit).magnitude)
    except Exception:
        wrong = f'has the wrong unit: {value!r} is not in {unit} or alike; write it like "{example}"'
        raise ValueError(wrong) from None
    if not math.isfinite(result):
        raise ValueError(f"is out of range: {value!r}")
    return result


def _unknown_unit(names: Any, value: str, example: str) -> str:
    """Say which unit is not known, and which one spelt alike is."""
    name = names if isinstance(names, str) else next(iter(names))
    near = next((x for x in (name.lower(), name.capitalize(), name.upper()) if x in _registry()), None)
    hint = f"did you mean {near}?" if near else f'write it like "{example}"'
    return f"names a unit that is not known, {name!r}, in {value!r}; {hint}"


def _refuse_cycles(value: str, names: set[str]) -> None:
    """An angular rate in Hz or 1/s leaves open whether turns or radians are meant, a factor of 2π."""
    if any("hertz" in name for name in names):
        raise ValueError(f'is ambiguous: {value!r} may mean turns or radians; write "rev/s", "rpm" or "rad/s"')
    plane = names - {"steradian"}
    if names and not any(name in ANGLES or name.endswith(("radian", "degree", "turn", "rev")) for name in plane):
        raise ValueError(f'is not an angular rate: {value!r} names no angle; write "rad/s", "deg/s" or "rpm"')
