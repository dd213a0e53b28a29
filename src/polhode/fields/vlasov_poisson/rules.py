"""Rules that the keys of a plasma must satisfy together."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any, NamedTuple

from polhode.spec.rules import Mistake


class PlasmaTableLimits(NamedTuple):
    """What the keys together must satisfy.

    Attributes:
        max_particle_modes: particles times modes: with more a hundred steps take minutes.
        max_share_error: by which the sum of the shares may miss one.
    """

    max_particle_modes: int = 4_000_000
    max_share_error: float = 1e-9


LIMITS = PlasmaTableLimits()


def find_mistakes(tables: dict[str, Any]) -> Iterator[Mistake]:
    """Yield beams whose shares do not add up to one, and runs that are too large."""
    system = tables["system"]
    beams = system.get("beams")
    if isinstance(beams, list) and all(isinstance(beam, dict) for beam in beams):
        shares = [beam.get("share", 1.0) for beam in beams]
        numbers = all(type(x) in (int, float) and math.isfinite(x) for x in shares)
        if numbers and abs(sum(shares) - 1.0) > LIMITS.max_share_error:
            yield ("system", "beams"), f"needs shares that add up to one; got {sum(shares):g}"
    usual = {"velocities": 256, "particles_per_velocity": 32, "modes": 4}
    sizes = [system.get(key, size) for key, size in usual.items()]
    if all(type(x) is int for x in sizes) and math.prod(sizes) > LIMITS.max_particle_modes:
        yield ("system", "velocities"), (
            f"times particles_per_velocity times modes must be at most {LIMITS.max_particle_modes:.0e}; got "
            f"{math.prod(sizes):.1e}"
        )
