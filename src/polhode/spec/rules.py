"""Rules that the fields of a spec must satisfy together.

Rules check which keys the raw tables have. So they report even when values are wrong, and everything is
said at once.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Any

from polhode.errors import shown
from polhode.formats.mesh_archives import names_its_unit
from polhode.spec.body_files import body_file_keys
from polhode.spec.export import export_rules
from polhode.spec.models import LOOK_SOURCES, ONE_PART, SystemTable
from polhode.spec.units import parse_quantity
from polhode.spec.words import list_words

Location = tuple[str | int, ...]
Mistake = tuple[Location, str]
SOURCES = ("mesh", "moments", "inertia", "rotational_constants", "part", "molecule")
NO_BODY = 'is missing; say what rotates, like moments = ["1 kg*m^2", "2 kg*m^2", "2.5 kg*m^2"] under [body]'
WAYS = ("angular_velocity", "momentum", "rate", "temperature")
OF_A_TOP = ("spin", "precession", "nutation_rate")
OF_A_CONE = ("spin", "precession", "nutation")


def body_sources() -> tuple[str, ...]:
    """Return the keys of [body] of which one must say where the body comes from."""
    return (*SOURCES, *body_file_keys())


def find_broken_rules(table: dict[str, Any], of_system: Iterable[Mistake] = ()) -> Iterator[Mistake]:
    """Yield the places where a spec's tables break a rule, and the messages; rules of [system] come in their place."""
    body = table.get("body")
    if isinstance(body, dict):
        yield from find_broken_body_rules(body)
    yield from of_system
    spin = table.get("spin")
    if isinstance(spin, dict):
        yield from ((("spin",), text) for text in _spin_rules(spin))
    export = table.get("export")
    if isinstance(export, dict):
        yield from export_rules(export)


def find_broken_body_rules(body: dict[str, Any]) -> Iterator[Mistake]:
    """Yield mistakes in a table [body] alone."""
    yield from ((("body",), text) for text in _body_rules(body))
    yield from _rules_of_parts(body)


def _rules_of_parts(body: dict[str, Any]) -> Iterator[Mistake]:
    parts = body.get("part")
    if not isinstance(parts, list):
        return
    from polhode.spec.part_rules import find_broken_part_rules

    names = [part.get("name") for part in parts if isinstance(part, dict)]
    for k, part in enumerate(parts):
        if isinstance(part, dict):
            yield from ((("body", "part", k), text) for text in find_broken_part_rules(part, "density" in body))
            if isinstance(name := part.get("name"), str) and names.count(name) > 1:
                yield ("body", "part", k, "name"), f"must differ from those of other parts; got {shown(name)} twice"
    if parts and all(isinstance(part, dict) and part.get("cut") is True for part in parts):
        yield ("body", "part"), "has cuts only, and nothing that they are cut from; add a part without cut"


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
                              f"does not take; give {list_words(WAYS, 'or')} instead")
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
               "instead")
    elif "nutation_rate" in spin:
        yield "nutation_rate is of a top; a free symmetric body keeps its nutation. Leave it out"
    elif keys and len(keys) != 2:
        yield f"needs two of {list_words(OF_A_CONE)}, from which the third follows; got {list_words(keys)}"
    elif spin.get("precession") in ("slow", "fast"):
        yield f'precession = "{spin["precession"]}" is of a top; a free symmetric body has one rate, like "4 rev/s"'


def _body_rules(body: dict[str, Any]) -> Iterator[str]:
    files = body_file_keys()
    sources = [key for key in body_sources() if key in body]
    if len(sources) != 1:
        yield f"needs exactly one of {list_words(body_sources())}; got {list_words(sources)}"
    if "mesh" in body:
        if "mesh_unit" not in body and not names_its_unit(str(body["mesh"])):
            yield 'needs mesh_unit, like "mm": such mesh files carry no unit'
        if ("mass" in body) == ("density" in body):
            yield "needs exactly one of mass and density for a mesh"
    elif sources:
        of_mesh = ("mesh_unit", "repair", "several", *(() if "part" in body else ("density",)))
        if extra := [key for key in of_mesh if key in body]:
            verb = "goes" if len(extra) == 1 else "go"
            yield f"{list_words(extra)} {verb} with a mesh, not with {sources[0]}; leave it out"
        if "mass" in body and sources[0] in ("part", "molecule", *files):
            what = "parts" if sources[0] == "part" else sources[0]
            yield f"mass follows from the {what}; leave it out"
    yield from _inertia_rules(body)
    if "allow_vibration" in body and "rotational_constants" not in body:
        yield "allow_vibration goes with rotational_constants; leave it out"
    for key in ("link", "joints"):
        if key in body and not set(files) & set(body):
            yield f"{key} goes with {list_words(files, 'or')}; leave it out"
    if "link" in body and "joints" in body:
        yield "link names one link, and joints put all of them together; leave one out"
    if isinstance(look := body.get("look"), str) and len(sources) == 1:
        yield from _look_rules(look, sources[0], body)


def _inertia_rules(body: dict[str, Any]) -> Iterator[str]:
    """Yield mistakes in the keys that go with known moments or a tensor."""
    of_inertia = {"center_of_mass": ("inertia", "moments"), "about": ("inertia",),
                  "rounding": ("inertia", "moments", *body_file_keys())}  # fmt: skip
    for key, wanted in of_inertia.items():
        if key in body and not set(wanted) & set(body):
            yield f"{key} goes with {list_words(wanted, 'or')}; leave it out"
    if "about" in body and "inertia" in body and "mass" not in body:
        yield "about needs mass, to take the inertia from there to the centre of mass"


def _look_rules(look: str, source: str, body: dict[str, Any]) -> Iterator[str]:
    wanted, parts = LOOK_SOURCES.get(look, (source,)), body.get("part")
    plain = [part for part in parts if isinstance(part, dict)] if isinstance(parts, list) else []
    strange = [k for k, part in enumerate(plain) if "shape" not in part or {"cut", "shell", "thickness"} & set(part)]
    strange += [k for k, part in enumerate(plain) if part.get("shape") == "point"]
    if source not in wanted:
        yield f'look = "{look}" goes with {list_words(wanted, "or")}, not with {source}; leave it out'
    elif strange and look != "metal":
        yield f'look = "{look}" paints parts that are solid shapes alone, not part[{strange[0]}]; leave it out'
    elif look in ONE_PART and isinstance(parts, list):
        shapes = [part.get("shape") for part in parts if isinstance(part, dict)]
        if shapes != [ONE_PART[look]]:
            yield f'look = "{look}" paints one part, a {ONE_PART[look]}; got {len(parts)} parts; leave it out'


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
