"""Stability of a top whose axis points up or hangs down, at rest or spinning."""

from __future__ import annotations

from dataclasses import replace
from typing import NamedTuple

import numpy as np

from polhode._base import check
from polhode._base.arrays import known_numbers_only
from polhode.analysis._printing import print_answer
from polhode.analysis.energy_casimir import Stability
from polhode.analysis.stability import stability
from polhode.errors import InvalidInput
from polhode.systems.heavy_top import HeavyTop

NAMES = {"|P|²": "|Γ|²", "Π·P": "Π·Γ"}  # the Casimirs of se(3)*, called by what they are here
SHORT = {"Lagrange's Π·χ": "Π·χ"}  # in sentences


class TopRests(NamedTuple):
    """Verdicts on both vertical positions of a top's axis."""

    upright: Stability
    hanging: Stability

    def __str__(self) -> str:
        verdicts = f"upright {self.upright.verdict}, hanging {self.hanging.verdict}"
        return print_answer(verdicts, upright=str(self.upright.certificate), hanging=str(self.hanging.certificate))


@known_numbers_only
def top_stability(top: HeavyTop, spin: float = 0.0) -> TopRests:
    """Return verdicts on the axis to the centre of mass upright and hanging.

    Args:
        top: with a weight.
        spin: about that axis [rad/s]; other than zero only where it is a principal axis.

    Raises:
        InvalidInput: for another system, a top without weight, or a spin about a line that is not a principal axis.

    Source: Marsden & Ratiu, *Introduction to Mechanics and Symmetry*, §15.10.

    >>> top_stability(HeavyTop((1.0, 1.0, 0.5), 1.0, (0.0, 0.0, 1.0)), 5.0).upright.verdict
    'stable'
    """
    check.instance("top", top, HeavyTop, "a HeavyTop")
    spin = check.number("spin", spin, "rad/s")
    if float(top.mgl) == 0.0:
        raise InvalidInput("`top` has no weight: its centre of mass is its fixed point, and no position is upright.")
    points = (top.upright(spin), top.upright(spin, hanging=True))
    upright, hanging = (_in_a_tops_words(stability(top, np.asarray(point))) for point in points)
    return TopRests(upright, hanging)


def _in_a_tops_words(judgement: Stability) -> Stability:
    """Return a verdict with the usual names of the Casimirs of se(3)* and of Lagrange's integral."""
    function = None if judgement.function is None else judgement.function.rename(NAMES)
    return replace(judgement, reason=judgement.reason.rename(NAMES | SHORT), function=function)
