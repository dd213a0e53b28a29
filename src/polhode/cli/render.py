"""Reports for people to read, and for programs as JSON."""

from __future__ import annotations

import json
import math
from typing import Any

from rich.console import Console
from rich.table import Table


def as_json(values: dict[str, Any]) -> str:
    """Return one JSON object; there is no NaN or infinity in it, and it would be an error if there were."""
    return json.dumps(values, indent=2, ensure_ascii=False, allow_nan=False)


def print_body(values: dict[str, Any]) -> None:
    """Print mass properties."""
    console = Console()
    console.print(f"[bold]{_escaped(values['name'])}[/bold]")
    _body_table(console, values)


def print_report(values: dict[str, Any]) -> None:
    """Print the whole report."""
    console = Console()
    console.print(f"[bold]{_escaped(values['name'])}[/bold]")
    console.print(values["summary"])
    _body_table(console, values)
    _axes_table(console, values)
    _motion_table(console, values)
    for note in values["notes"]:
        console.print(f"Note: {note}", style="yellow")
    console.print("Written:", _escaped(", ".join(values["files"])), style="dim", highlight=False)


def _escaped(text: str) -> str:
    return text.replace("[", "\\[")


def _table(title: str, *columns: str) -> Table:
    table = Table(title=title, title_justify="left", title_style="bold", box=None, padding=(0, 2, 0, 0))
    for name in columns:
        table.add_column(name, overflow="fold")
    return table


def _body_table(console: Console, values: dict[str, Any]) -> None:
    table = _table("Body", "", "")
    table.show_header = False
    table.add_row("mass", _number(values["mass"], "kg"))
    size = math.sqrt(max(values["principal_moments"]) / values["mass"]) if values["mass"] else 0.0
    table.add_row("centre of mass", _vector(values["center_of_mass"], "m", size))
    table.add_row("principal moments", _distinct(values["principal_moments"], "kg m²"))
    for k, column in enumerate(zip(*values["principal_axes"], strict=True)):
        table.add_row(f"principal axis {k + 1}", _vector(column, "") + "  (given axes)")
    console.print(table)


def _axes_table(console: Console, values: dict[str, Any]) -> None:
    table = _table("Rotation about each principal axis, at this |L|", "axis", "verdict", "rate", "because")
    for axis in values["axes"]:
        style = "green" if axis["verdict"] == "stable" else "red"
        verdict = axis["verdict"] + (f" ({axis['growth']})" if axis["growth"] == "linear" else "")
        rate = f"{axis['rate']:.4g} /s" if axis["rate"] else "–"
        table.add_row(str(axis["axis"]), f"[{style}]{verdict}[/{style}]", rate, axis["certificate"])
    console.print(table)


def _motion_table(console: Console, values: dict[str, Any]) -> None:
    table = _table("Motion", "", "")
    table.show_header = False
    rows = [
        ("regime", values["regime"]),
        ("energy", _number(values["energy"], "J")),
        ("|L|", _number(values["momentum_norm"], "kg m²/s")),
        ("polhode period T", _number(values["polhode_period"], "s")),
        ("rotation period", _number(values["rotation_period"], "s")),
        ("flip interval T/2", _number(values["flip_interval"], "s")),
        ("turn about L per flip", _angle(values["twist_per_flip"])),
        ("precession in the body", _precession(values["precession"]["body"])),
        ("precession in space", _precession(values["precession"]["space"])),
        ("precession per period", _angle(values["precession_per_period"])),
        ("geometric phase", _angle(values["geometric_phase"])),
        ("action", _number(values["action"], "J s")),
        ("tumbling periods P_φ, P_ψ", _pair(values["tumbling_periods"])),
        ("long-axis period P₁", _number(values["long_axis_period"], "s")),
        ("herpolhode radii", _radii(values["herpolhode"])),
        ("drift of energy, |L|, space L", ", ".join(f"{x:.1e}" for x in values["drift"].values())),
    ]
    for name, text in rows:
        if text != "–":
            table.add_row(name, text)
    console.print(table)


def _number(value: float | None, unit: str) -> str:
    return "–" if value is None else f"{value:.8g} {unit}".rstrip()


def _distinct(values: Any, unit: str) -> str:
    """Return numbers with as many digits as it takes to tell apart those that differ."""
    ways = ([f"{x:.{digits}g}" for x in values] for digits in range(6, 18))
    shown = next(way for way in ways if len(set(way)) == len(set(values)))
    return f"({', '.join(shown)}) {unit}"


def _vector(values: Any, unit: str, size: float = 0.0) -> str:
    largest = max(size, *(abs(x) for x in values))
    cleaned = [0.0 if abs(x) < 1e-15 * largest else x for x in values]
    return "(" + ", ".join(f"{x:.6g}" for x in cleaned) + f") {unit}".rstrip()


def _angle(value: float | None) -> str:
    return "–" if value is None else f"{value:.8g} rad = {math.degrees(value):.6g}°"


def _pair(values: dict[str, float | None]) -> str:
    if values["P_phi"] is None and values["P_psi"] is None:
        return "–"
    return ", ".join(_number(value, "s") for value in values.values())


def _precession(value: dict[str, Any] | None) -> str:
    return "–" if value is None else f"{value['rate']:.8g} rad/s {value['sense']}"


def _radii(value: dict[str, float] | None) -> str:
    if value is None:
        return "–"
    return (f"{value['inner_radius']:.6g} to {value['outer_radius']:.6g}, in a plane {value['plane_distance']:.6g} "
            "from the centre, 1/√(kg m²)")  # fmt: skip
