"""Polhodes that correspond to quantum levels, as coloured curves on the unit sphere."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import lru_cache
from typing import NamedTuple

import numpy as np

from polhode.analysis.polhodes import polhode
from polhode.errors import InvalidInput
from polhode.exact.free_body import FreeMotion
from polhode.figures import style
from polhode.spectra._level_polhodes import LevelPolhodes, level_directions, level_polhodes
from polhode.spectra.rotor import Rotor
from polhode.types import Array, Float64

ROUND_A, ROUND_C = style.AXIS_COLOURS[0], style.AXIS_COLOURS[2]  # the axes' own colours
VIEW = (0.55, 0.68, 0.49)  # a, b and c are all visible, and the saddle at b
CROWDED = 12  # J from which on curves are thinner


class LevelCurve(NamedTuple):
    """One of the two polhodes of a level.

    Attributes:
        energy: E/h, in the unit of the constants.
        above: whether it goes round the a axis.
        unit: (T, 3) directions of L along a, b, c.
    """

    energy: float
    above: bool
    unit: Float64[Array, "time 3"]


def find_polhodes(rotor: Rotor, J: int) -> LevelPolhodes:
    """Return the levels of one J with their polhodes.

    Raises:
        InvalidInput: for a molecule of which two constants are equal, whose polhodes are circles.
    """
    polhodes = level_polhodes(rotor.constants, J)
    if polhodes is None:
        raise InvalidInput(
            "`rotor` must have three different constants, and J be at least 1: polhodes of a symmetric molecule are "
            "circles. Draw its levels by `level_diagram`."
        )
    return polhodes


def rotor_moments(rotor: Rotor) -> Float64[Array, "3"]:
    """Return the moments 1/2A, 1/2B, 1/2C of the free body whose energy is E/h."""
    return 0.5 / np.array(rotor.constants)


def level_curves(rotor: Rotor, J: int) -> Sequence[LevelCurve]:
    """Return both polhodes of each level of one J, of a rigid asymmetric rotor, |L| = J + ½."""
    return _curves(rotor.constants, J)


@lru_cache(maxsize=1)  # a report draws them in two figures
def _curves(constants: tuple[float, float, float], J: int) -> Sequence[LevelCurve]:
    rotor = Rotor(constants)
    return tuple(_iterate_curves(rotor, J, find_polhodes(rotor, J)))


def _iterate_curves(rotor: Rotor, J: int, polhodes: LevelPolhodes) -> Iterator[LevelCurve]:
    starts = level_directions(rotor.constants, J, polhodes.semiclassical)
    points = 300
    for energy, above, start in zip(polhodes.semiclassical.tolist(), polhodes.above.tolist(), starts, strict=True):
        curve = polhode(FreeMotion(rotor_moments(rotor), momentum=start), points)
        if curve is not None:
            yield LevelCurve(energy, above, curve)
            yield LevelCurve(energy, above, -curve)


def curve_width(J: int) -> float:
    """Return how wide the curves of a J's levels are drawn, so that many stay apart."""
    return 1.0 if J < CROWDED else max(0.35, CROWDED / J)


def side_colour(above: bool) -> str:
    """Return the colour of levels above or below the saddle."""
    return ROUND_A if above else ROUND_C
