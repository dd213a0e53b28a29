"""The numbers that describe a Lagrange top's motion: turning points, period, precession, spin and regime."""

from __future__ import annotations

from typing import NamedTuple

from polhode._base.arrays import compiled, namespace
from polhode.exact._array_arithmetic import for_arrays
from polhode.exact.lagrange_top import _formulas_numbers as formulas_numbers
from polhode.exact.lagrange_top import _formulas_rates as formulas_rates
from polhode.exact.lagrange_top import _formulas_reduction as formulas_reduction
from polhode.exact.lagrange_top import _formulas_roots as formulas_roots
from polhode.exact.lagrange_top._formulas_rates import Frequencies
from polhode.exact.lagrange_top._formulas_reduction import Reduction
from polhode.exact.lagrange_top._formulas_roots import TurningPoints
from polhode.exact.lagrange_top._preparation import reduced
from polhode.types import Array, Float64, Integer

NUMBERS = for_arrays(formulas_reduction, formulas_roots, formulas_rates, formulas_numbers)
REGIMES = (
    "rest", "sleeping", "hanging", "steady", "free", "planar", "undulating", "cusp", "loop", "separatrix",
)  # fmt: skip
Number = Float64[Array, "*batch"]
Code = Integer[Array, "*batch"]


class Characteristics(NamedTuple):
    """Numbers of the motion, one per top; inf or NaN where there is none."""

    regime: Code  # code, index into REGIMES
    lowest: Number  # of cos θ
    highest: Number
    period: Number
    precession_per_period: Number
    spin_per_period: Number
    precession_rate: Number
    spin_rate: Number


def characteristics(
    moments: Float64[Array, "*batch 3"],
    mgl: Float64[Array, "*batch 1"],
    momentum: Float64[Array, "*batch 3"],
    attitude: Float64[Array, "*batch 4"],
) -> Characteristics:
    """Return the characteristics of tops with arrays (…, 3), (…, 1), (…, 3) and (…, 4) of one batch shape."""
    return characteristics_of(*reduced(moments, mgl, momentum, attitude))


def characteristics_of(top: Reduction, points: TurningPoints, rates: Frequencies) -> Characteristics:
    """Return the characteristics of tops that have been reduced."""
    return compiled(_characteristics, top.reversed)(top, points, rates)


def _characteristics(top: Reduction, points: TurningPoints, rates: Frequencies) -> Characteristics:
    xp = namespace(top.reversed)
    regime, lowest, highest, period, precession, spin = NUMBERS.numbers(top, points, rates)
    return Characteristics(
        xp.asarray(regime, dtype=int), lowest, highest, period, precession, spin, precession / period, spin / period
    )
