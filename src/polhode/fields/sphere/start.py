"""Starts of flows on spheres, from tables of random fields, waves and vortices."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator
from typing import Annotated, Any

from pydantic import AfterValidator, Field, StrictInt

from polhode.spec.fields import Angle, Circulation, Latitude, PositiveRate, Rate, not_zero
from polhode.spec.models import Strict
from polhode.spec.rules import Mistake

Degree = Annotated[StrictInt, Field(ge=1, le=511)]


class Degrees(Strict):
    """Random phases, with equal energies in all degrees from the first to the last."""

    degrees: tuple[Degree, Degree] = Field(description="give the first and the last degree, like [4, 8]")
    seed: Annotated[StrictInt, Field(ge=0, le=2**63)] = 1


class RandomTable(Degrees):
    """A random vorticity."""

    vorticity: PositiveRate = Field(description='give the root mean square over the sphere, like "1 rad/s"')


class VortexTable(Strict):
    """The smallest vortex that the resolution can represent."""

    strength: Circulation = Field(description='give the circulation, like "1 m^2/s"')
    latitude: Latitude = Field(description='give it like "45 deg"')
    longitude: Angle = 0.0


class Harmonic(Strict):
    """One spherical harmonic; of order zero it is zonal."""

    degree: Degree = Field(description="give it like 4")
    order: Annotated[StrictInt, Field(ge=0, le=511)] = Field(description="give it like 3; zero is zonal")
    longitude: Angle = 0.0


class WaveTable(Harmonic):
    """A wave of the vorticity; of order zero a zonal flow."""

    vorticity: Annotated[Rate, AfterValidator(not_zero)] = Field(
        description='give the root mean square over the sphere, like "1 rad/s"'
    )


def coefficient(wave: Harmonic, size: float) -> complex:
    """Return f_lm of a function with a mean square over the sphere; zonal ones keep the sign of ``size``."""
    if wave.order == 0:
        return size * math.sqrt(4.0 * math.pi)
    return size * math.sqrt(2.0 * math.pi) * cmath.exp(-1j * wave.order * wave.longitude)


def degree_rules(size: int, table: Any, key: str) -> Iterator[Mistake]:
    """Yield mistakes in the degrees of a random field for a resolution."""
    if isinstance(table, dict) and isinstance(degrees := table.get("degrees"), list) and len(degrees) == 2:
        if all(type(x) is int for x in degrees) and not degrees[0] <= degrees[1] < size:
            yield ("system", key, "degrees"), (
                f"must ascend and stay below the resolution, {size}; got {degrees[0]} and {degrees[1]}"
            )


def harmonic_rules(size: int, waves: Any, key: str) -> Iterator[Mistake]:
    """Yield the harmonics of a list that are beyond the resolution."""
    for k, wave in enumerate(waves if isinstance(waves, list) else []):
        if not isinstance(wave, dict):
            continue
        degree, order = wave.get("degree"), wave.get("order")
        if type(degree) is int and type(order) is int and not order <= degree < size:
            yield ("system", key, k), (
                f"needs order ≤ degree < resolution, {size}; got degree {degree} and order {order}"
            )
