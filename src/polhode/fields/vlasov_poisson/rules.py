"""Rules that the keys of a plasma must satisfy together."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

from polhode.spec.rules import Mistake

MOST = 4_000_000  # particles times modes: more take minutes a hundred steps
WHOLE = 1e-9  # by which shares may miss one


def find_mistakes(tables: dict[str, Any]) -> Iterator[Mistake]:
    """Yield beams whose shares do not add up to one, and runs that are too large."""
    system = tables["system"]
    beams = system.get("beams")
    if isinstance(beams, list) and all(isinstance(beam, dict) for beam in beams):
        shares = [beam.get("share", 1.0) for beam in beams]
        if all(type(x) in (int, float) and math.isfinite(x) for x in shares) and abs(sum(shares) - 1.0) > WHOLE:
            yield ("system", "beams"), f"needs shares that add up to one; got {sum(shares):g}"
    usual = {"velocities": 256, "particles_per_velocity": 32, "modes": 4}
    sizes = [system.get(key, size) for key, size in usual.items()]
    if all(type(x) is int for x in sizes) and math.prod(sizes) > MOST:
        yield ("system", "velocities"), (
            f"times particles_per_velocity times modes must be at most {MOST:.0e}; got {math.prod(sizes):.1e}"
        )
