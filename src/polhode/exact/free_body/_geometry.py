"""The numbers that describe a free body's motion, such as periods, precession and action, from its two frequencies."""

from __future__ import annotations

from typing import NamedTuple

from polhode._base.arrays import namespace
from polhode.exact._array_arithmetic import for_arrays
from polhode.exact.free_body import _formulas_numbers as formulas_numbers
from polhode.exact.free_body import _formulas_rates as formulas_rates
from polhode.exact.free_body import _formulas_reduction as formulas_reduction
from polhode.exact.free_body._preparation import FORMULAS, canonical_reduction
from polhode.types import Array, Float64, Integer

NUMBERS = for_arrays(formulas_reduction, formulas_rates, formulas_numbers)
REGIMES = ("rest", "spherical", "permanent", "symmetric", "short-axis", "long-axis", "separatrix")
SYMMETRIC = REGIMES.index("symmetric")

Number = Float64[Array, "*batch"]
Code = Integer[Array, "*batch"]


class Characteristics(NamedTuple):
    """Numbers of the motion, one per body; inf or NaN where there is none."""

    regime: Code  # code, index into REGIMES
    encircled_axis: Code  # index of the given principal axis that the polhode encircles; −1 where none
    modulus: Number
    period: Number
    precession_rate: Number
    precession_per_period: Number
    solid_angle: Number


def characteristics(moments: Float64[Array, "*batch 3"], momentum: Float64[Array, "*batch 3"]) -> Characteristics:
    """Return the characteristics of bodies with moments and momentum (…, 3) along the principal axes."""
    xp = namespace(moments, momentum)
    body = canonical_reduction(moments, momentum)
    regime, axis, *others = NUMBERS.numbers(body, FORMULAS.frequencies(body))
    return Characteristics(xp.asarray(regime, dtype=int), xp.asarray(axis, dtype=int), *others)
