"""Rules that the keys of a conducting fluid on a sphere must satisfy together."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from polhode.fields.sphere.start import degree_rules, harmonic_rules
from polhode.spec.rules import Mistake
from polhode.spec.words import list_words

SUMMED = ("random", "waves", "random_field", "field_waves")
ALONE = ("alfven_wave", "start_from")


def find_mistakes(tables: dict[str, Any]) -> Iterator[Mistake]:
    """Yield missing or conflicting starts, and harmonics beyond the resolution."""
    system = tables["system"]
    summed, alone = ([key for key in keys if key in system] for keys in (SUMMED, ALONE))
    if alone and len(summed) + len(alone) > 1:
        others = [*summed, *alone[1:]]
        yield ("system", alone[0]), f"goes without {list_words(others)}; leave out one or the other"
    if not summed and not alone:
        yield ("system",), (
            f"needs a start: {list_words(SUMMED)}, which add up; alfven_wave; or start_from, the file of an earlier run"
        )
    size = system.get("resolution")
    if type(size) is not int:
        return
    for key in ("random", "random_field"):
        yield from degree_rules(size, system.get(key), key)
    for key in ("waves", "field_waves"):
        yield from harmonic_rules(size, system.get(key), key)
    wave = system.get("alfven_wave")
    if isinstance(wave, dict):
        degree, order = wave.get("degree"), wave.get("order")
        if type(degree) is int and type(order) is int and not order <= degree < size:
            yield ("system", "alfven_wave"), (
                f"needs order ≤ degree < resolution, {size}; got degree {degree} and order {order}"
            )
        elif degree == 1:
            yield ("system", "alfven_wave", "degree"), "must be at least 2: of degree 1 the fluid turns as a whole"
