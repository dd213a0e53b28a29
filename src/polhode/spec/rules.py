"""What the fields of a spec ask of each other.

Rules look at the raw tables, at which keys are there: so they speak up beside wrong values, and everything is said at
once.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from polhode.spec.disk_rules import disk_rules
from polhode.spec.export import export_rules
from polhode.spec.models import MAY_BE_HOLLOW, SHAPE_KEYS
from polhode.spec.systems import SYSTEMS
from polhode.spec.units import parse_quantity

Location = tuple[str | int, ...]
Mistake = tuple[Location, str]
SOURCES = ("mesh", "moments", "inertia", "parts", "molecule", "urdf")
NO_BODY = 'is missing; say what rotates, like moments = ["1 kg*m^2", "2 kg*m^2", "2.5 kg*m^2"] under [body]'
WAYS = ("angular_velocity", "momentum", "rate")


def broken_rules(table: dict[str, Any]) -> Iterator[Mistake]:
    """Yield where a spec's tables break a rule, and how it is said."""
    body = table.get("body")
    if isinstance(body, dict):
        yield from ((("body",), text) for text in _body_rules(body))
        parts = body.get("parts")
        for k, part in enumerate(parts if isinstance(parts, list) else []):
            if isinstance(part, dict):
                yield from ((("body", "parts", k), text) for text in _part_rules(part))
    spin = table.get("spin")
    yield from _system_rules(table)
    if isinstance(spin, dict):
        yield from ((("spin",), text) for text in _spin_rules(spin))
    export = table.get("export")
    if isinstance(export, dict):
        yield from export_rules(export)


def _system_rules(table: dict[str, Any]) -> Iterator[Mistake]:
    system = table.get("system")
    kind = system.get("kind") if isinstance(system, dict) else None
    kind = kind if isinstance(kind, str) else None
    model = SYSTEMS.get(kind) if kind else None
    takes = model.takes if model else ("body", "spin", "time")
    if isinstance(system, dict) and kind == "spin-orbit":
        yield from _spin_orbit_rules(system, "body" in table)
    elif "body" in takes and "body" not in table:
        yield ("body",), NO_BODY
    for key in ("body", "spin", "time"):
        if key in table and key not in takes:
            yield (key,), f"does not go with the system {kind}, which takes its own keys in [system]; leave it out"
    spin = table.get("spin")
    if isinstance(system, dict) and "lean" in system and isinstance(spin, dict) and "attitude" in spin:
        yield ("system", "lean"), "goes without spin.attitude, which already says how the body lies; leave out one"
    body = table.get("body")
    if kind in ("heavy-top", "lagrange-top") and isinstance(body, dict) and "mass" not in body:
        if "moments" in body or "inertia" in body:
            yield ("body",), f'needs mass, like "120 g", for the weight of a {kind}'
    if isinstance(system, dict) and kind in RULES:
        yield from RULES[kind](system)


def _spin_orbit_rules(system: dict[str, Any], has_body: bool) -> Iterator[Mistake]:
    """Yield what the shape and the orbit are asked for, which each go by one way of two."""
    if has_body and "asphericity" in system:
        yield ("system", "asphericity"), "goes without [body], whose moments already give it; leave out one"
    if not has_body and "asphericity" not in system:
        yield ("body",), f"{NO_BODY}, or asphericity, √(3(B − A)/C), like 0.89 under [system]"
    axis = [key for key in ("semi_major_axis", "gravitational_parameter") if key in system]
    if "orbital_period" in system and axis:
        yield ("system", "orbital_period"), f"goes without {_listed(axis)}; leave out one or the other"
    elif "orbital_period" not in system and len(axis) != 2:
        yield ("system",), (
            'needs orbital_period, like "21.28 day", or semi_major_axis and gravitational_parameter together; '
            f"got {_listed(axis)}"
        )


def _body_rules(body: dict[str, Any]) -> Iterator[str]:
    sources = [key for key in SOURCES if key in body]
    if len(sources) != 1:
        yield f"needs exactly one of mesh, moments, inertia, parts, molecule and urdf; got {_listed(sources)}"
    if "mesh" in body:
        if "mesh_unit" not in body:
            yield 'needs mesh_unit, like "mm": mesh files carry no units'
        if ("mass" in body) == ("density" in body):
            yield "needs exactly one of mass and density beside a mesh"
    elif sources:
        if extra := [key for key in ("mesh_unit", "density", "repair", "several") if key in body]:
            verb = "goes" if len(extra) == 1 else "go"
            yield f"{_listed(extra)} {verb} with a mesh, not with {sources[0]}; leave it out"
        if "mass" in body and sources[0] in ("parts", "molecule", "urdf"):
            yield f"mass follows from the {sources[0]}; leave it out"
    if "link" in body and "urdf" not in body:
        yield "link goes with a urdf; leave it out"


def _part_rules(part: dict[str, Any]) -> Iterator[str]:
    shape = part.get("shape")
    if not isinstance(shape, str) or shape not in SHAPE_KEYS:
        return
    needed = SHAPE_KEYS[shape]
    allowed = {*needed, *(("inner_radius",) if shape in MAY_BE_HOLLOW else ())}
    measures = {key for keys in SHAPE_KEYS.values() for key in keys} | {"inner_radius"}
    if missing := [key for key in needed if key not in part]:
        yield f"a {shape} needs {_listed(missing)}"
    if extra := sorted((measures & set(part)) - allowed):
        yield f"a {shape} has no {' or '.join(extra)}; it takes {', '.join(needed)}"


def _spin_rules(spin: dict[str, Any]) -> Iterator[str]:
    ways = [key for key in WAYS if key in spin]
    if len(ways) > 1 or (not ways and {"frame", "about", "tilt"} & set(spin)):
        yield f"needs exactly one of angular_velocity, momentum and rate; got {_listed(ways)}"
    if "rate" in spin:
        if "about" not in spin:
            yield 'rate needs about = 1, 2 or 3 (principal axis) or "x", "y", "z" (given axis)'
        if "frame" in spin:
            yield "frame goes with components; about already says which axis"
        if "tilt" in spin and _vanishes(spin["rate"]):
            yield "a spin of zero has no direction to tilt; give a rate, or leave tilt out"
    elif ways and ("about" in spin or "tilt" in spin):
        yield f"about and tilt go with rate, not with {ways[0]}"


def _gyrostat_rules(system: dict[str, Any]) -> Iterator[Mistake]:
    if "motor_torque" in system and system.get("rotor_drive") == "constant-rate":
        yield ("system", "motor_torque"), 'turns a rotor that is free; give rotor_drive = "free", or leave one out'


def _damped_rules(system: dict[str, Any]) -> Iterator[Mistake]:
    outer = [key for key in ("linear_drag", "quadratic_drag", "orbital_period", "eccentricity") if key in system]
    if "damping" in system and outer:
        text = f"is for losses inside, which keep L, and goes without {_listed(outer)}; leave out one or the other"
        yield ("system", "damping"), text
    elif not {"damping", "linear_drag", "quadratic_drag"} & set(system):
        text = 'needs damping, like 0.01, or linear_drag, like "0.01 N*m*s", or quadratic_drag'
        yield ("system",), f"{text}; got {_listed(outer)}"
    elif "eccentricity" in system and "orbital_period" not in system:
        yield ("system", "eccentricity"), 'goes with orbital_period; give it like "90 min", or leave eccentricity out'


RULES = {"gyrostat": _gyrostat_rules, "damped-body": _damped_rules, "euler-disk": disk_rules}


def _vanishes(rate: Any) -> bool:
    try:
        return parse_quantity(rate, "rad/s") == 0.0
    except ValueError:
        return False


def _listed(keys: list[str]) -> str:
    return " and ".join(keys) or "none"
