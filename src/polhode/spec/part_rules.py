"""Rules that the keys of one part of a body must satisfy together."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from polhode.formats.mesh_archives import names_its_unit
from polhode.spec.models import MAY_HAVE, PART_SOURCES, SHAPE_KEYS, WITHOUT_VOLUME
from polhode.spec.words import list_words

OF_A_MESH = ("mesh_unit", "repair", "several", "shell", "thickness")
OF_INERTIA = ("about", "center_of_mass", "rounding")
OF_SHAPES = {key for keys in (*SHAPE_KEYS.values(), *MAY_HAVE.values()) for key in keys}


def find_broken_part_rules(part: dict[str, Any], density_of_all: bool = False) -> Iterator[str]:
    """Yield the rules that a part's raw table breaks.

    Args:
        part: the table.
        density_of_all: whether [body] gives a density for parts that have none of their own.
    """
    sources = [key for key in PART_SOURCES if key in part]
    if len(sources) != 1:
        yield (f"needs exactly one of {list_words(PART_SOURCES)}, for what it is; got {list_words(sources)}. "
               'Give a shape like "box", or known mass and inertia')
        return
    (source,) = sources
    if "axis" in part and "attitude" in part:
        yield "axis and attitude both turn the part; give one of them"
    if source == "shape":
        yield from _of_shape(part, density_of_all)
        return
    own = {"mesh": OF_A_MESH, "spec": (), "inertia": OF_INERTIA}[source]
    known = {*OF_SHAPES, *OF_A_MESH, *OF_INERTIA} - set(own)
    if extra := sorted(known & set(part)):
        verb = "does" if len(extra) == 1 else "do"
        yield f"{list_words(extra)} {verb} not go with {source}; leave it out"
    if source == "mesh":
        if "mesh_unit" not in part and not names_its_unit(str(part["mesh"])):
            yield 'needs mesh_unit, like "mm": such mesh files carry no unit'
        yield from _of_amount(part, density_of_all, "a mesh", _is_shell(part))
    elif source == "spec":
        if taken := [key for key in ("mass", "density") if key in part]:
            yield f"{list_words(taken)} of another spec's body is given in that spec; leave it out"
    else:
        if "density" in part:
            yield "density says nothing where inertia is known; give mass"
        elif "mass" not in part:
            yield 'mass is missing; give it like "30 g"'


def _of_shape(part: dict[str, Any], density_of_all: bool) -> Iterator[str]:
    shape = part["shape"]
    if not isinstance(shape, str) or shape not in SHAPE_KEYS:
        return
    needed, more = SHAPE_KEYS[shape], MAY_HAVE.get(shape, ())
    measures = OF_SHAPES | set(OF_A_MESH) | set(OF_INERTIA)
    if missing := [key for key in needed if key not in part]:
        yield f"a {shape} needs {list_words(missing)}"
    if extra := sorted((measures & set(part)) - {*needed, *more}):
        yield f"a {shape} has no {' or '.join(extra)}; it takes {', '.join(needed + more) or 'no measures'}"
    if shape == "prism":
        regular = [key for key in ("sides", "radius") if key in part]
        if ("outline" in part) == (len(regular) == 2) or ("outline" in part and regular):
            yield "a prism needs either sides and radius, of a regular polygon, or an outline"
    hollow = _is_shell(part)
    if hollow and "inner_radius" in part:
        yield "inner_radius makes it a tube already; leave out shell and thickness, or it"
    if part.get("open_ends") and not hollow:
        yield "open_ends goes with shell = true or a thickness; leave it out"
    if shape in WITHOUT_VOLUME:
        if "density" in part:
            yield f"a {shape} has no volume, so that no mass follows from density; give mass"
        elif "mass" not in part:
            yield 'mass is missing; give it like "30 g"'
        return
    yield from _of_amount(part, density_of_all, f"a {shape}", hollow)


def _is_shell(part: dict[str, Any]) -> bool:
    return part.get("shell") is True or "thickness" in part


def _of_amount(part: dict[str, Any], density_of_all: bool, what: str, hollow: bool) -> Iterator[str]:
    """Yield mistakes in the amount of material."""
    given = [key for key in ("mass", "density") if key in part]
    if len(given) == 2:
        yield f"needs one of mass and density for {what}; got both"
    elif not given and not density_of_all and part.get("cut") is not True:
        yield f'mass is missing; give it like "30 g", or density like "2700 kg/m^3", for {what}'
    if hollow and "mass" not in part and "thickness" not in part:
        yield "a shell has the mass of its wall: give mass, or thickness and density"
    if "mesh" in part and "thickness" in part and "mass" in part:
        yield "thickness says nothing about a mesh's shell of known mass; say shell = true instead"
