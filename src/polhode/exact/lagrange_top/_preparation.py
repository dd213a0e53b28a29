"""From a Lagrange top and its start to the constants of its motion: rates, theta series and phases."""

from __future__ import annotations

from typing import NamedTuple

from polhode._base.arrays import barrier, compiled
from polhode.exact._array_states import ArrayStates
from polhode.exact._blocks import Columns, flatten_motion
from polhode.exact.lagrange_top import _formulas as formulas
from polhode.exact.lagrange_top._formulas_rates import Frequencies
from polhode.exact.lagrange_top._formulas_roots import Reduction, TurningPoints
from polhode.exact.lagrange_top._formulas_setup import Given
from polhode.exact.lagrange_top._reduction import reduce_top
from polhode.exact.lagrange_top._roots import FORMULAS, turning_points
from polhode.types import Array, Float64

STATES = ArrayStates(formulas)


class Prepared(NamedTuple):
    """The flattened ``Motion`` for evaluation, with its sources."""

    motion: Columns
    top: Reduction
    points: TurningPoints
    rates: Frequencies


def prepare(
    moments: Float64[Array, "*batch 3"],
    mgl: Float64[Array, "*batch 1"],
    momentum: Float64[Array, "*batch 3"],
    attitude: Float64[Array, "*batch 4"],
) -> Prepared:
    """Return the constants of motion of tops with arrays (…, 3), (…, 1), (…, 3) and (…, 4) of one batch shape."""
    top = barrier(compiled(reduce_top, moments)(moments, mgl, momentum, attitude))
    points = barrier(compiled(turning_points, moments)(top))
    rates = barrier(compiled(FORMULAS.frequencies, moments)(top, points))
    integrals = compiled(FORMULAS.integrals_of, moments)(top, points, rates)
    arguments = barrier(compiled(FORMULAS.arguments, moments)(top, points, rates, integrals))
    given = Given(top, points, rates, arguments, momentum[..., 2])
    motion, timing = barrier(compiled(FORMULAS.motion_without_phases, moments)(given))
    motion = compiled(FORMULAS.motion_with_phases, moments)(given, motion, timing)
    return Prepared(flatten_motion(motion), top, points, rates)
