"""Numbers in words for people; what has no value has no words."""

from __future__ import annotations

import math
import re
from collections.abc import Callable
from typing import Any

import numpy as np

from polhode.analysis.energy_casimir import Stability
from polhode.bodies.body import Body
from polhode.motion.trajectory import Trajectory
from polhode.reports.base import Listing, Section

Array = Any
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
    """Return components, those zero that are small beside a size or the largest."""
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


def accuracy_lines(trajectory: Trajectory, words: str = "drift") -> list[tuple[str, str | None]]:
    """Return how well the motion keeps what it should, and how far its states may be from the true ones."""
    error = trajectory.error_estimate
    return [
        (words, drifts(trajectory.drift)),
        ("state error estimate, relative", None if error is None or not np.isfinite(error) else f"{float(error):.1e}"),
    ]


def body_section(body: Body) -> Section:
    """Return the mass properties."""
    size = math.sqrt(max(body.principal_moments) / body.mass) if body.mass else 0.0
    lines: list[tuple[str, str | None]] = [
        ("mass", number(body.mass, "kg")),
        ("centre of mass", vector(body.center_of_mass, "m", size)),
        ("principal moments", distinct(body.principal_moments, "kg m²")),
    ]
    return Section("Body", lines + axes_lines(body.principal_axes))


def body_summary(body: Body) -> dict[str, Any]:
    """Return the mass properties alone, as arrays."""
    return {
        "mass": body.mass,
        "center_of_mass": body.center_of_mass,
        "principal_moments": body.principal_moments,
        "principal_axes": body.principal_axes,
    }


def axes_lines(axes: Array) -> list[tuple[str, str | None]]:
    """Return axes, by columns, a line each."""
    columns = enumerate(zip(*axes.tolist(), strict=True))
    return [(f"principal axis {k + 1}", vector(column) + "  (given axes)") for k, column in columns]


def verdicts(title: str, head: str, found: dict[str, Stability]) -> Listing:
    """Return verdicts by what they are on."""
    rows = []
    for name, verdict in found.items():
        word = verdict.verdict + (f" ({verdict.growth})" if verdict.growth == "linear" else "")
        speed = f"{verdict.rate:.4g} /s" if verdict.rate else "–"
        rows.append((name, word, speed, verdict.certificate))
    return Listing(title, (head, "verdict", "rate", "because"), rows)


def stability_values(found: Stability) -> dict[str, Any]:
    """Return a verdict as values by name."""
    return {
        "verdict": found.verdict,
        "rate": found.rate,
        "growth": found.growth,
        "direction": found.direction,
        "exponents": [[float(x.real), float(x.imag)] for x in found.spectrum],
        "certificate": found.certificate,
    }
