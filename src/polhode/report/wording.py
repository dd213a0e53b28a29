"""Numbers in words for people; what has no value has no words."""

from __future__ import annotations

import math
from typing import Any

from polhode.analysis.energy_casimir import Stability
from polhode.bodies.body import Body
from polhode.report.base import Listing, Section

Array = Any


def number(value: float | None, unit: str = "") -> str | None:
    """Return a number with its unit."""
    return None if value is None else f"{value:.8g} {unit}".rstrip()


def counted(count: int, thing: str) -> str:
    """Return how many there are of a thing."""
    return f"{count} {thing}" if count == 1 else f"{count} {thing}s"


def angle(value: float | None) -> str | None:
    """Return an angle [rad] in radians and degrees."""
    return None if value is None else f"{value:.8g} rad = {math.degrees(value):.6g}°"


def rate(value: float | None) -> str | None:
    """Return a rate [rad/s], with turns per minute."""
    return None if value is None else f"{value:.8g} rad/s = {value * 30.0 / math.pi:.6g} rpm"


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
    """Return drifts by name."""
    return ", ".join(f"{name.replace('_', ' ')} {float(x):.1e}" for name, x in values.items())


def body_section(body: Body) -> Section:
    """Return the mass properties."""
    size = math.sqrt(max(body.principal_moments) / body.mass) if body.mass else 0.0
    lines: list[tuple[str, str | None]] = [
        ("mass", number(body.mass, "kg")),
        ("centre of mass", vector(body.center_of_mass, "m", size)),
        ("principal moments", distinct(body.principal_moments, "kg m²")),
    ]
    return Section("Body", lines + axes_lines(body.principal_axes))


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
