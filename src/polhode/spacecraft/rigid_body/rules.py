"""Rules that the tables of a rigid body with mounts and torques must satisfy together."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from polhode.errors import InvalidInput
from polhode.spacecraft.rigid_body.arguments import FROM_ELSEWHERE, make_model, needs
from polhode.spacecraft.rigid_body.named import LAWS, Family, find_part, part_names
from polhode.spacecraft.rigid_body.table import LISTS
from polhode.spec.rules import Mistake, list_words

SIZES = ("period", "semi_major_axis", "altitude")
OF_MOTORS = ("max_torque", "max_rate")


def find_mistakes(tables: dict[str, Any]) -> Iterator[Mistake]:
    """Yield the places where raw tables break a rule, and the messages."""
    system = tables["system"]
    for key in ("wheel", *LISTS):
        if key in system and not isinstance(system[key], list):
            yield ("system", key), f"must be written with two brackets, [[{key}]], as there may be several"
    for key, family in LISTS.items():
        for k, entry in enumerate(_tables(system, key)):
            yield from _part_rules(family, entry, "type", ("system", key, k), system)
    if isinstance(control := system.get("control"), dict):
        yield from _part_rules(LAWS, control, "law", ("system", "control"), system)
        yield from _control_rules(control, system)
    if isinstance(orbit := system.get("orbit"), dict):
        given = [key for key in SIZES if key in orbit]
        if len(given) != 1:
            yield ("system", "orbit"), f"needs exactly one of {list_words(SIZES)}; got {list_words(given)}"
        if "altitude" in orbit and "gravitational_parameter" in orbit:
            text = "counts from the Earth's radius; about another body give semi_major_axis, or leave out"
            yield ("system", "orbit", "altitude"), f"{text} gravitational_parameter"
    by_wheels = isinstance(control, dict) and control.get("by", "wheels") == "wheels"
    for k, wheel in enumerate(_tables(system, "wheel")):
        yield from _wheel_rules(wheel, ("system", "wheel", k), by_wheels)
    yield from _limit_rules([wheel for wheel in _tables(system, "wheel") if _is_controlled(wheel, by_wheels)])


def _orbit(system: dict[str, Any]) -> dict[str, Any]:
    return orbit if isinstance(orbit := system.get("orbit"), dict) else {}


def _tables(system: dict[str, Any], key: str) -> list[dict[str, Any]]:
    entries = system.get(key, [])
    return [entry if isinstance(entry, dict) else {} for entry in entries] if isinstance(entries, list) else []


def _part_rules(
    family: Family, entry: dict[str, Any], key: str, at: tuple[Any, ...], system: dict[str, Any]
) -> Iterator[Mistake]:
    name = entry.get(key)
    if not isinstance(name, str):
        got = "it is missing" if name is None else "it must be text"
        yield (*at, key), f"must be one of {', '.join(part_names(family))}; {got}"
        return
    try:
        part = find_part(family, name)
        make_model(part, name, key)
    except InvalidInput as error:
        yield (*at, key), str(error)
        return
    if "orbit" not in system and any(needs(part, what) for what in FROM_ELSEWHERE):
        yield (*at, key), f'{name} acts on an orbit; give one, like altitude = "500 km" under [orbit]'
    elif needs(part, "field") and "gravitational_parameter" in _orbit(system):
        text = "is known of the Earth's field alone; leave it out, or the orbit's gravitational_parameter"
        yield (*at, key), f"{name} {text}"


def _control_rules(control: dict[str, Any], system: dict[str, Any]) -> Iterator[Mistake]:
    by = control.get("by", "wheels")
    if control.get("target") == "nadir" and "orbit" not in system:
        text = 'nadir is along an orbit; give one, like altitude = "500 km" under [orbit]'
        yield ("system", "control", "target"), text
    if by == "wheels":
        if "limit" in control:
            yield ("system", "control", "limit"), 'goes with by = "torque"; wheels have max_torque'
        if not any(wheel.get("drive", "controlled") == "controlled" for wheel in _tables(system, "wheel")):
            yield ("system", "control"), 'works by wheels, and there is none for it; give [[wheel]], or by = "torque"'


def _is_controlled(wheel: dict[str, Any], by_wheels: bool) -> bool:
    return by_wheels and "torque" not in wheel and wheel.get("drive") in (None, "controlled")


def _limit_rules(controlled: list[dict[str, Any]]) -> Iterator[Mistake]:
    for key in OF_MOTORS:
        if 0 < (count := sum(key in wheel for wheel in controlled)) < len(controlled):
            text = f"is given for {count} of {len(controlled)} controlled wheels; give {key} for all of them, or none"
            yield ("system", "wheel"), text


def _wheel_rules(wheel: dict[str, Any], at: tuple[Any, ...], control: bool) -> Iterator[Mistake]:
    drive = wheel.get("drive")
    if "torque" in wheel and drive not in (None, "motor"):
        yield (*at, "torque"), 'is of a constant motor; leave out drive, or give drive = "motor"'
    if drive == "motor" and "torque" not in wheel:
        yield at, 'needs torque, the constant one of its motor, like "1 mN*m"'
    if drive == "controlled" and not control:
        yield (*at, "drive"), "is controlled by [control], which is missing or does not work by wheels"
    if not _is_controlled(wheel, control) and (limits := [key for key in OF_MOTORS if key in wheel]):
        yield at, f"has {list_words(limits)}, which limit a controlled wheel; leave them out, or give [control]"
    if "max_rate" in wheel and "max_torque" not in wheel:
        yield (*at, "max_rate"), "needs max_torque, the torque that falls to zero towards that rate"
    if drive == "constant-rate" and "friction" in wheel:
        yield (*at, "friction"), "is overcome by what keeps the rate constant; leave it out"
