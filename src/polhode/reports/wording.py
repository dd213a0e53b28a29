"""Numbers in words for people; what has no value has no words."""

from __future__ import annotations

import math
import re
from collections.abc import Callable
from typing import Any

import numpy as np

RAISED = str.maketrans("0123456789", "⁰¹²³⁴⁵⁶⁷⁸⁹")


def number(value: float | None, unit: str = "") -> str | None:
    """Return a number with its unit."""
    return _unless_infinite(value, lambda x: f"{x:.8g} {unit}".rstrip())


def counted(count: int, thing: str) -> str:
    """Return how many there are of a thing."""
    return f"{count} {thing}" if count == 1 else f"{count} {thing}s"


def angle(value: float | None) -> str | None:
    """Return an angle [rad] in radians and degrees."""
    return _unless_infinite(value, lambda x: f"{x:.8g} rad = {math.degrees(x):.6g}°")


def rate(value: float | None) -> str | None:
    """Return a rate [rad/s], with turns per minute."""
    return _unless_infinite(value, lambda x: f"{x:.8g} rad/s = {x * 30.0 / math.pi:.6g} rpm")


def worded(value: Any, unit: str = "") -> str | None:
    """Return a value for people, by its unit; None for None and for text that is empty.

    >>> worded(0.5, "rad"), worded((1.0, 2.0), "m"), worded("none")
    ('0.5 rad = 28.6479°', '(1, 2) m', 'none')
    """
    if value is None or isinstance(value, str):
        return value or None
    if isinstance(value, bool):
        return "yes" if value else "no"
    if np.ndim(value):
        return vector(value, unit)
    words = {"rad": angle, "rad/s": rate}.get(unit)
    return words(float(value)) if words else number(float(value), unit)


def _unless_infinite(value: float | None, words: Callable[[float], str]) -> str | None:
    if value is None:
        return None
    return "infinite" if math.isinf(value) else words(value)


def unit_in_words(unit: str) -> str:
    """Return a unit as people write it, from what CF metadata writes.

    >>> [unit_in_words(unit) for unit in ("kg m2 s-1", "s-4", "J", "1")]
    ['kg m²/s', '1/s⁴', 'J', '']
    """
    over, under = [], []
    for name, power in re.findall(r"([A-Za-z]+)(-?\d*)", unit):
        size = power.removeprefix("-")
        (under if power.startswith("-") else over).append(name + ("" if size in ("", "1") else size.translate(RAISED)))
    return " ".join(over) if not under else f"{' '.join(over) or '1'}/{' '.join(under)}"


def vector(values: Any, unit: str = "", size: float = 0.0) -> str:
    """Return components, those zero that are small compared with a size or the largest."""
    largest = max(size, *(abs(x) for x in values))
    cleaned = [0.0 if abs(x) < 1e-15 * largest else x for x in values]
    return "(" + ", ".join(f"{x:.6g}" for x in cleaned) + f") {unit}".rstrip()


def distinct(values: Any, unit: str = "") -> str:
    """Return numbers with as many digits as it takes to tell apart those that differ."""
    ways = ([f"{x:.{digits}g}" for x in values] for digits in range(6, 18))
    shown = next(way for way in ways if len(set(way)) == len({float(x) for x in values}))
    return f"({', '.join(shown)}) {unit}".rstrip()


def drifts(values: dict[str, Any]) -> str:
    """Return drifts by name, the largest where each copy has its own."""
    return ", ".join(f"{name.replace('_', ' ')} {float(np.max(x)):.1e}" for name, x in values.items())
