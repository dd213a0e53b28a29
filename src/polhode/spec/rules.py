"""Rules that the fields of a spec must satisfy together.

Rules look at the raw tables, at which keys are there. So they speak up even when values are wrong, and everything is
said at once.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import Any

from polhode.spec.export import export_rules
from polhode.spec.models import LOOK_SOURCES, MAY_BE_HOLLOW, ONE_PART, SHAPE_KEYS, SystemTable
from polhode.spec.units import parse_quantity

Location = tuple[str | int, ...]
Mistake = tuple[Location, str]
SOURCES = ("mesh", "moments", "inertia", "rotational_constants", "parts", "molecule", "urdf")
NO_BODY = 'is missing; say what rotates, like moments = ["1 kg*m^2", "2 kg*m^2", "2.5 kg*m^2"] under [body]'
WAYS = ("angular_velocity", "momentum", "rate", "temperature")
OF_A_TOP = ("spin", "precession", "nutation_rate")
OF_A_CONE = ("spin", "precession", "nutation")


def find_broken_rules(table: dict[str, Any], of_system: Iterable[Mistake] = ()) -> Iterator[Mistake]:
    """Yield the places where a spec's tables break a rule, and the messages; rules of [system] come in their place."""
    body = table.get("body")
    if isinstance(body, dict):
        yield from ((("body",), text) for text in _body_rules(body))
        parts = body.get("parts")
        for k, part in enumerate(parts if isinstance(parts, list) else []):
            if isinstance(part, dict):
                yield from ((("body", "parts", k), text) for text in _part_rules(part))
    yield from of_system
    spin = table.get("spin")
    if isinstance(spin, dict):
        yield from ((("spin",), text) for text in _spin_rules(spin))
    export = table.get("export")
    if isinstance(export, dict):
        yield from export_rules(export)


def table_rules(table: dict[str, Any], kind: str, model: type[SystemTable] | None) -> Iterator[Mistake]:
    """Yield tables that are missing for a kind, and tables that do not go with it.

    Args:
        table: the raw tables.
        kind: of the spec.
        model: of its table [system]; None for a kind that is not known, which is a mistake of its own.
    """
    spin = table.get("spin")
    if model is not None and isinstance(spin, dict) and (model.cones or (not model.leans and "nutation" in spin)):
        yield from ((("spin",), text) for text in _cone_rules(spin, kind, model.cones))
    elif model is not None and model.leans and isinstance(spin, dict) and "nutation" in spin:
        yield ("spin", "nutation"), "is the angle between axis and momentum of a free body; a top takes system.lean"
    elif model is not None and not model.leans and isinstance(spin, dict):
        if keys := [key for key in OF_A_TOP if key in spin]:
            verb = "gives" if len(keys) == 1 else "give"
            yield ("spin",), (f"{list_words(keys)} {verb} the rates of a top's Euler angles, which the system {kind} "
                              f"does not take; give {list_words(WAYS, 'or')} instead")  # fmt: skip
    if model is None:
        return  # what such a system needs is not known
    if "body" in model.needs and "body" not in table:
        yield ("body",), NO_BODY
    for key in ("body", "spin", "time"):
        if key in table and key not in model.takes:
            yield (key,), f"does not go with the system {kind}, which takes its own keys in [system]; leave it out"


def _cone_rules(spin: dict[str, Any], kind: str, takes: bool) -> Iterator[str]:
    keys = [key for key in OF_A_CONE if key in spin]
    if not takes:
        yield (f"nutation is of a free symmetric body, which the system {kind} is not; give {list_words(WAYS, 'or')} "
               "instead")  # fmt: skip
    elif "nutation_rate" in spin:
        yield "nutation_rate is of a top; a free symmetric body keeps its nutation. Leave it out"
    elif keys and len(keys) != 2:
        yield f"needs two of {list_words(OF_A_CONE)}, from which the third follows; got {list_words(keys)}"
    elif spin.get("precession") in ("slow", "fast"):
        yield f'precession = "{spin["precession"]}" is of a top; a free symmetric body has one rate, like "4 rev/s"'


def _body_rules(body: dict[str, Any]) -> Iterator[str]:
    sources = [key for key in SOURCES if key in body]
    if len(sources) != 1:
        yield f"needs exactly one of {list_words(SOURCES)}; got {list_words(sources)}"
    if "mesh" in body:
        if "mesh_unit" not in body:
            yield 'needs mesh_unit, like "mm": mesh files carry no units'
        if ("mass" in body) == ("density" in body):
            yield "needs exactly one of mass and density for a mesh"
    elif sources:
        if extra := [key for key in ("mesh_unit", "density", "repair", "several") if key in body]:
            verb = "goes" if len(extra) == 1 else "go"
            yield f"{list_words(extra)} {verb} with a mesh, not with {sources[0]}; leave it out"
        if "mass" in body and sources[0] in ("parts", "molecule", "urdf"):
            yield f"mass follows from the {sources[0]}; leave it out"
    if "allow_vibration" in body and "rotational_constants" not in body:
        yield "allow_vibration goes with rotational_constants; leave it out"
    if "link" in body and "urdf" not in body:
        yield "link goes with a urdf; leave it out"
    if isinstance(look := body.get("look"), str) and len(sources) == 1:
        yield from _look_rules(look, sources[0], body)


def _look_rules(look: str, source: str, body: dict[str, Any]) -> Iterator[str]:
    wanted, parts = LOOK_SOURCES.get(look, (source,)), body.get("parts")
    if source not in wanted:
        yield f'look = "{look}" goes with {list_words(wanted, "or")}, not with {source}; leave it out'
    elif look in ONE_PART and isinstance(parts, list):
        shapes = [part.get("shape") for part in parts if isinstance(part, dict)]
        if shapes != [ONE_PART[look]]:
            yield f'look = "{look}" paints one part, a {ONE_PART[look]}; got {len(parts)} parts; leave it out'


def _part_rules(part: dict[str, Any]) -> Iterator[str]:
    shape = part.get("shape")
    if not isinstance(shape, str) or shape not in SHAPE_KEYS:
        return
    needed = SHAPE_KEYS[shape]
    allowed = {*needed, *(("inner_radius",) if shape in MAY_BE_HOLLOW else ())}
    measures = {key for keys in SHAPE_KEYS.values() for key in keys} | {"inner_radius"}
    if missing := [key for key in needed if key not in part]:
        yield f"a {shape} needs {list_words(missing)}"
    if extra := sorted((measures & set(part)) - allowed):
        yield f"a {shape} has no {' or '.join(extra)}; it takes {', '.join(needed)}"


def _spin_rules(spin: dict[str, Any]) -> Iterator[str]:
    ways, of_a_top = [key for key in WAYS if key in spin], [key for key in (*OF_A_TOP, "nutation") if key in spin]
    ways += of_a_top[:1]
    if len(ways) > 1 or (not ways and {"frame", "about", "tilt"} & set(spin)):
        known = f"{list_words(WAYS)}, or of a top {list_words(OF_A_TOP)} together"
        yield f"needs exactly one of {known}; got {list_words(ways)}"
    if spin.get("precession") in ("slow", "fast") and "nutation_rate" in spin:
        yield f'precession = "{spin["precession"]}" keeps the tilt; leave nutation_rate out'
    if "rate" in spin:
        if "about" not in spin:
            yield 'rate needs about = 1, 2 or 3 (principal axis) or "x", "y", "z" (given axis)'
        if "tilt" in spin and _vanishes(spin["rate"]):
            yield "a spin of zero has no direction to tilt; give a rate, or leave tilt out"
    if "frame" in spin and ways and ways[0] not in ("angular_velocity", "momentum"):
        yield "frame goes with the components of angular_velocity or momentum; leave it out"
    if "rate" not in spin and ways and ("about" in spin or "tilt" in spin):
        yield f"about and tilt go with rate, not with {ways[0]}"


def _vanishes(rate: Any) -> bool:
    try:
        return parse_quantity(rate, "rad/s") == 0.0
    except ValueError:
        return False


def list_words(keys: Sequence[str], last: str = "and") -> str:
    """Return keys in words.

    >>> list_words(["a", "b", "c"]), list_words(["a", "b"], "or"), list_words([])
    ('a, b and c', 'a or b', 'none')
    """
    return f" {last} ".join(filter(None, (", ".join(keys[:-1]), *keys[-1:]))) or "none"
