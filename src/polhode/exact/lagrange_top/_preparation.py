"""From a Lagrange top and its start to the constants of its motion: rates, theta series and phases."""

from __future__ import annotations

from typing import NamedTuple

from polhode._base.arrays import barrier, compiled
from polhode.exact._array_arithmetic import for_arrays
from polhode.exact._array_states import ArrayStates
from polhode.exact._blocks import Columns, flatten_motion
from polhode.exact.lagrange_top import _formulas as formulas
from polhode.exact.lagrange_top import _formulas_integrals as formulas_integrals
from polhode.exact.lagrange_top import _formulas_rates as formulas_rates
from polhode.exact.lagrange_top import _formulas_reduction as formulas_reduction
from polhode.exact.lagrange_top import _formulas_roots as formulas_roots
from polhode.exact.lagrange_top import _formulas_setup as formulas_setup
from polhode.exact.lagrange_top._formulas_rates import Frequencies
from polhode.exact.lagrange_top._formulas_reduction import Reduction
from polhode.exact.lagrange_top._formulas_roots import TurningPoints
from polhode.exact.lagrange_top._formulas_setup import Given
from polhode.types import Array, Float64

FORMULAS = for_arrays(
    formulas, formulas_reduction, formulas_roots, formulas_rates, formulas_integrals, formulas_setup
)
STATES = ArrayStates(formulas)


class Prepared(NamedTuple):
    """The flattened ``Motion`` for evaluation, with its sources."""

    motion: Columns
    top: Reduction
    points: TurningPoints
    rates: Frequencies


def reduced(
    moments: Float64[Array, "*batch 3"],
    mgl: Float64[Array, "*batch 1"],
    momentum: Float64[Array, "*batch 3"],
    attitude: Float64[Array, "*batch 4"],
) -> tuple[Reduction, TurningPoints, Frequencies]:
    """Return invariants, turning points and frequencies of tops with arrays of one batch shape."""
    given = (_components(moments), mgl[..., 0], _components(momentum), _components(attitude))
    top = barrier(compiled(FORMULAS.reduction, moments)(*given))
    points = barrier(compiled(FORMULAS.turning_points, moments)(top))
    return top, points, barrier(compiled(FORMULAS.frequencies, moments)(top, points))


def _components(vectors: Array) -> tuple[Array, ...]:
    return tuple(vectors[..., k] for k in range(vectors.shape[-1]))


def prepare(
    moments: Float64[Array, "*batch 3"],
    mgl: Float64[Array, "*batch 1"],
    momentum: Float64[Array, "*batch 3"],
    attitude: Float64[Array, "*batch 4"],
) -> Prepared:
    """Return the constants of motion of tops with arrays (…, 3), (…, 1), (…, 3) and (…, 4) of one batch shape."""
    top, points, rates = reduced(moments, mgl, momentum, attitude)
    integrals = compiled(FORMULAS.integrals_of, moments)(top, points, rates)
    arguments = barrier(compiled(FORMULAS.arguments, moments)(top, points, rates, integrals))
    given = Given(top, points, rates, arguments, momentum[..., 2])
    motion, timing = barrier(compiled(FORMULAS.motion_without_phases, moments)(given))
    motion = compiled(FORMULAS.motion_with_phases, moments)(given, motion, timing)
    return Prepared(flatten_motion(motion), top, points, rates)
