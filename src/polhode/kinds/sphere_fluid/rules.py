"""What the keys of a fluid on a sphere ask of each other."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from polhode.spec.rules import Mistake, listed

STARTS = ("random", "vortices", "waves")


def fluid_rules(system: dict[str, Any]) -> Iterator[Mistake]:
    """Yield which starts are missing or too many, and which harmonics are not resolved."""
    given = [key for key in STARTS if key in system]
    if "start_from" in system and given:
        yield ("system", "start_from"), f"goes without {listed(given)}; leave out one or the other"
    if not given and "start_from" not in system:
        yield ("system",), f"needs a start: {listed(STARTS)}, which add up, or start_from, the file of an earlier run"
    size, random, waves = system.get("resolution"), system.get("random"), system.get("waves")
    if type(size) is not int:
        return
    if isinstance(random, dict) and isinstance(degrees := random.get("degrees"), list) and len(degrees) == 2:
        if all(type(x) is int for x in degrees) and not degrees[0] <= degrees[1] < size:
            yield ("system", "random", "degrees"), (
                f"must ascend and stay below the resolution, {size}; got {degrees[0]} and {degrees[1]}"
            )
    for k, wave in enumerate(waves if isinstance(waves, list) else []):
        if not isinstance(wave, dict):
            continue
        degree, order = wave.get("degree"), wave.get("order")
        if type(degree) is int and type(order) is int and not order <= degree < size:
            yield ("system", "waves", k), (
                f"needs order ≤ degree < resolution, {size}; got degree {degree} and order {order}"
            )
