"""From bodies to the constants of their motion, for arrays of NumPy or JAX: the steps of ``formulas_setup``."""

from __future__ import annotations

from typing import Any, NamedTuple

from polhode._base.arrays import compiled, namespace
from polhode.exact._array_arithmetic import for_arrays
from polhode.exact._array_states import ArrayStates
from polhode.exact._blocks import Columns, flatten_motion
from polhode.exact.free_body import _formulas as formulas
from polhode.exact.free_body import _formulas_rates as formulas_rates
from polhode.exact.free_body import _formulas_reduction as formulas_reduction
from polhode.exact.free_body import _formulas_setup as formulas_setup
from polhode.exact.free_body._formulas_rates import Frequencies
from polhode.exact.free_body._formulas_reduction import Reduction
from polhode.exact.free_body._formulas_setup import Given
from polhode.types import Array, Float64

FORMULAS = for_arrays(formulas, formulas_reduction, formulas_rates, formulas_setup)
STATES = ArrayStates(formulas)
Number = Float64[Array, "*batch"]
Triple = tuple[Number, Number, Number]


class Prepared(NamedTuple):
    """The flattened ``Motion`` for evaluation, with the reduction and frequencies it came from."""

    motion: Columns
    body: Reduction
    frequencies: Frequencies


def prepare(
    moments: Float64[Array, "*batch 3"], momentum: Float64[Array, "*batch 3"], attitude: Float64[Array, "*batch 4"]
) -> Prepared:
    """Return the constants of motion of bodies with arrays (…, 3), (…, 3) and (…, 4) of one batch shape."""
    body = canonical_reduction(moments, momentum)
    rates = compiled(FORMULAS.frequencies, moments)(body)
    given = Given(_components(moments), _components(momentum), _components(attitude), body, rates)
    return Prepared(flatten_motion(compiled(FORMULAS.motion_of, moments)(given)), body, rates)


def canonical_reduction(moments: Float64[Array, "*batch 3"], momentum: Float64[Array, "*batch 3"]) -> Reduction:
    """Return the canonical form of bodies with moments and momentum (…, 3), any order, any scale.

    On JAX each stage is compiled by itself: as one kernel XLA would compute S again for everything that uses it.
    """
    body = compiled(FORMULAS.scaled, moments)(_components(moments), _components(momentum))
    sums = compiled(FORMULAS.sums_of, moments)(body)
    distance = compiled(FORMULAS.signed_distance, moments)(body, sums)
    return compiled(FORMULAS.reduced, moments)(body, sums, distance)


def _components(vectors: Array) -> tuple[Any, ...]:
    return tuple(vectors[..., k] for k in range(vectors.shape[-1]))


def as_sorted(body: Reduction, vector: Float64[Array, "*batch 3"]) -> Triple:
    """Return the components (…, 3) in the given axes along the sorted ones, as a proper rotation turns them."""
    first, second, third = FORMULAS.axes_of(body)
    x, y, z = _components(vector)
    return _between(body, *(first[j] * x + second[j] * y + third[j] * z for j in range(3)))


def from_sorted(body: Reduction, components: Triple) -> Triple:
    """Return components along the given axes; the inverse of ``as_sorted``."""
    x, y, z = _between(body, *components)
    a, b, c = (row[0] * x + row[1] * y + row[2] * z for row in FORMULAS.axes_of(body))
    return a, b, c


def _between(body: Reduction, x: Array, y: Array, z: Array) -> Triple:
    """Undo (or do) mirror and half turn, which commute and are their own inverses."""
    xp = namespace(body.long_axis, x)
    return body.half_turn * xp.where(body.long_axis, z, x), y, body.half_turn * xp.where(body.long_axis, x, z)
