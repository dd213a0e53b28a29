"""Quantities with units, as people write them in files: "60 rpm", "12 g*cm^2"."""

from __future__ import annotations

import contextlib
import math
import os
import re
import sys
from fractions import Fraction
from functools import cache, lru_cache
from pathlib import Path
from typing import Any, NamedTuple

from polhode._base.rational import read_number
from polhode.errors import InvalidInput, shown

SPEED_OF_LIGHT = 299792458.0  # m/s, exact by definition
EXAMPLES = {
    "kg": "52 g",
    "m": "12 mm",
    "s": "20 s",
    "rad": "1 deg",
    "K": "300 K",
    "1/m": "27.88 1/cm",
    "Hz": "835.8 GHz",
    "C*m": "1.857 D",
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
    "m^2/s": "1 m^2/s",
    "J": "1 meV",
    "T": "0.5 T",
    "Pa": "5e11 Pa",
    "Pa*s": "1.8e-5 Pa*s",
    "W": "2 mW",
    "W*s^2": "2e-8 W*s^2",
    "W*s^2.5": "2e-9 W*s^2.5",
}
QUANTITY = re.compile(
    r"\s*(?P<number>[+-]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]+)?|[+-]?(?:nan|inf)(?!\w))\s*\*?\s*(?P<unit>.*)",
    re.DOTALL,
)
_RAISED = str.maketrans("⁺⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "+-0123456789")
_NUMBER = r"-?\+?[0-9.]+"
# a product of names and their powers, as pint takes it: kg*m^2/s, W*s^2.5, kg/(m*s), 1/s, g cm², deg/s
_UNIT_TOKEN = re.compile(
    rf"""\s*(?:(?:(?![⁰¹²³⁴-⁹])[^\W\d_](?:(?![⁰¹²³⁴-⁹])\w)*|[°%‰)])
             (?:\s*(?:\^|\*\*)\s*(?:(?P<power>{_NUMBER})(?!\w)
                                  |\(\s*(?P<inner>{_NUMBER})\s*(?:/\s*(?P<under>{_NUMBER})\s*)?\))
               |(?P<raised>[⁺⁻]?[⁰¹²³⁴-⁹]+))?
           |1(?![0-9.])|\(|(?P<sign>[*/·⋅×.]))\s*""",
    re.VERBOSE,
)
_DOT = re.compile(r"\.(?=\s*[^\W\d])")  # a product, not a part of a number
KEPT = "POLHODE_UNITS_CACHE"  # folder where a command keeps the table of units, so as not to read it each time
ANGLES = {"radian", "degree", "turn", "arcminute", "arcsecond", "milliarcsecond", "grade", "revolutions_per_minute",
          "dps", "cpm", "revolutions_per_second"}  # fmt: skip


class QuantityLimits(NamedTuple):
    """Numbers beyond which a quantity is refused before it is parsed."""

    max_characters: int = 100
    max_power: int = 9  # of a unit; pint would compute m^9^9^9


LIMITS = QuantityLimits()


@cache
def _registry() -> Any:
    from polhode.spec.kept_units import load_registry

    folder, registry = os.environ.get(KEPT), None
    if folder:
        with contextlib.suppress(OSError):  # there is no room for temporary files
            registry = load_registry(Path(folder))
    if registry is None:
        import pint

        registry = pint.UnitRegistry()
    registry.define("rev = turn")
    registry.define("dps = degree / second")
    registry.define("cpm = turn / minute")
    return registry


def parse_quantity(value: Any, unit: str) -> float:
    """Return the value of a quantity like "60 rpm" in the given SI unit.

    Raises:
        ValueError: with the mistake and an example; pydantic collects it with the key's path.
    """
    if isinstance(value, bool) or not isinstance(value, str):
        raise ValueError(f'needs a number with its unit in quotes, like "{find_example(unit)}"; got {shown(value)}')
    return _parse(value, unit)


def parse_exactly(value: Any, unit: str) -> Fraction | None:
    """Return a quantity as the exact number of the SI unit that its decimals are; None for units such as degrees.

    A unit's factor is taken as exact if it has at most twelve digits, as that of "g*cm^2" or of "inch" has.

    Raises:
        ValueError: as ``parse_quantity`` does.
    """
    parse_quantity(value, unit)
    parts = QUANTITY.fullmatch(value)
    assert parts is not None
    one = parse_quantity(f"1 {parts['unit']}", unit)
    factor = read_number(f"{one:.12g}")
    if abs(factor - read_number(one)) > factor * read_number(4 * sys.float_info.epsilon):
        return None
    try:
        return read_number(parts["number"]) * factor
    except InvalidInput as error:
        raise ValueError(str(error).removeprefix("`number` ").rstrip(".")) from None


def find_example(unit: str) -> str:
    """Return an example of a quantity in a unit, for messages."""
    return EXAMPLES.get(unit, f"1 {unit}")


def parse_spectroscopic(value: Any) -> float:
    """Return the frequency [Hz] of a quantity given as a frequency or as a wave number.

    Raises:
        ValueError: naming the mistake and the remedy.
    """
    try:
        return parse_quantity(value, "1/m") * SPEED_OF_LIGHT
    except ValueError as error:
        try:
            return parse_quantity(value, "Hz")
        except ValueError:
            example = f'"{EXAMPLES["1/m"]}"'
            said = str(error).replace(example, f'{example} or "{EXAMPLES["Hz"]}"')
            said = said.replace("is not in 1/m or alike", "is neither a frequency nor a wave number")
            raise ValueError(said) from None


@lru_cache(maxsize=1024)
def _parse(value: str, unit: str) -> float:
    example = find_example(unit)
    unreadable = ValueError(f'cannot be read as a quantity: {shown(value)}; write it like "{example}"')
    if len(value) > LIMITS.max_characters:
        rule = f"must have at most {LIMITS.max_characters} characters"
        raise ValueError(f'{rule}; got {shown(value)}; write it like "{example}"')
    registry, parts = _registry(), QUANTITY.fullmatch(value)
    if parts is None:
        raise unreadable
    magnitude, unit_text = float(parts["number"]), parts["unit"]
    if not math.isfinite(magnitude):
        raise ValueError(f"must be finite; got {shown(value)}")
    _check_unit(unit_text, value, unreadable)
    # one number and one unit: pint alone would take "60 rpm 2" for 120 rpm
    unit_text = f"1{unit_text}" if unit_text.startswith("/") else unit_text
    unit_text = _DOT.sub("*", unit_text)  # as in "N.m", which pint from 0.26 on reads no more
    try:
        quantity = registry.Quantity(magnitude, registry.parse_units(unit_text))
    except Exception as error:  # pint raises errors of many kinds, tokenizer's and its own
        if unknown := getattr(error, "unit_names", None):
            raise ValueError(_unknown_unit(unknown, value, example)) from None
        raise unreadable from None
    names = set(dict(quantity.unit_items()))
    if unit == "rad/s":
        _refuse_cycles(value, names)
    if unit in ("1/m", "Hz") and _names_angle(names):
        raise ValueError(f'names an angle: {shown(value)}; write it without, like "{example}"')
    if unit == "K" and any(name.startswith("delta") for name in names):
        raise ValueError(f'is a difference of temperatures: {shown(value)}; write it like "{example}" or "27 degC"')
    if unit == "kg*m^2/s" and any("hertz" in name for name in names):
        raise ValueError(f'is ambiguous: {shown(value)} may mean turns or radians; write it like "{example}"')
    if not names:
        raise ValueError(f'needs a unit, like "{example}"; got {shown(value)}')
    try:
        result = float(quantity.to(unit).magnitude)
    except Exception:
        _check_declared(registry, unit)
        wrong = f'has the wrong unit: {shown(value)} is not in {unit} or alike; write it like "{example}"'
        raise ValueError(wrong) from None
    written = re.split("[eE]", parts["number"])[0].strip("+-0.")
    if not math.isfinite(result) or (written and abs(result) < sys.float_info.min):
        raise ValueError(f"is out of range: {shown(value)}; numbers go from 1e-307 to 1e308 in {unit}")
    return result


def _check_declared(registry: Any, unit: str) -> None:
    """Refuse a unit from another package that cannot be read."""
    try:
        registry.parse_units(unit)
    except Exception:
        wrong = f"is declared with a unit that cannot be read, {shown(unit)}; correct it in the package that added it"
        raise ValueError(wrong) from None


def _check_unit(text: str, value: str, unreadable: ValueError) -> None:
    """Refuse units that pint would compute for ever or misread: it gets only names, signs and small powers."""
    at, was_sign, reach = 0, False, 1.0
    while at < len(text):
        token = _UNIT_TOKEN.match(text, at)
        if token is None or (was_sign and token["sign"]):
            raise unreadable
        powers = [token[key] for key in ("power", "inner", "under") if token[key]]
        powers += [token["raised"].translate(_RAISED)] if token["raised"] else []
        try:
            sizes = [abs(float(power)) for power in powers]
        except ValueError:
            raise unreadable from None
        reach *= math.prod(max(size, 1.0) for size in sizes)  # powers of brackets multiply
        if max(sizes, default=0.0) > LIMITS.max_power or reach > LIMITS.max_power**3:
            raise ValueError(f"raises a unit to a power beyond {LIMITS.max_power}: {shown(value)}; check its powers")
        at, was_sign = token.end(), bool(token["sign"])


def _names_angle(names: set[str]) -> bool:
    plane = names - {"steradian"}
    return any(name in ANGLES or name.endswith(("radian", "degree", "turn", "rev")) for name in plane)


def _unknown_unit(names: Any, value: str, example: str) -> str:
    """Name the unknown unit, and a known one of similar spelling."""
    name = names if isinstance(names, str) else next(iter(names))
    near = next((x for x in (name.lower(), name.capitalize(), name.upper()) if x in _registry()), None)
    hint = f"did you mean {near}?" if near else f'write it like "{example}"'
    return f"names a unit that is not known, {shown(name)}, in {shown(value)}; {hint}"


def _refuse_cycles(value: str, names: set[str]) -> None:
    """An angular rate in Hz or 1/s leaves open whether turns or radians are meant, a factor of 2π."""
    if any("hertz" in name for name in names):
        raise ValueError(f'is ambiguous: {shown(value)} may mean turns or radians; write "rev/s", "rpm" or "rad/s"')
    if names and not _names_angle(names):
        raise ValueError(f'is not an angular rate: {shown(value)} names no angle; write "rad/s", "deg/s" or "rpm"')
