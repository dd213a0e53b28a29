"""Runs the Lagrange top's closed form over batches: NumPy in blocks, JAX as one operation with its derivative.

What only JAX needs, and tops that the kernels leave, is imported there: most motions are NumPy's and are not derived.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from polhode._base.arrays import Elementwise, is_jax, namespace, stack_last
from polhode.exact._blocks import Constants, Vectors, columns_in_blocks, in_blocks, units
from polhode.exact._closed_form import ClosedForm
from polhode.exact.lagrange_top import _geometry as geometry
from polhode.types import Array, Float64

SIZES = (3, 1, 3, 4)  # of moments, mgl, momentum, attitude


def motion_columns(arguments: Vectors) -> Constants:
    """Return the constants of motion of moments (…, 3), mgl (…, 1), momentum (…, 3), attitude (…, 4) as columns.

    JAX needs none: there set-up and evaluation are one operation.
    """
    return () if is_jax(*arguments) else FORM.columns(arguments)


def _columns_of_tops(*arguments: Array) -> tuple[Array, ...]:
    from polhode.exact.lagrange_top._preparation import prepare

    return prepare(*arguments).motion


FORM = ClosedForm("polhode.exact.lagrange_top", _columns_of_tops)


def characteristics(arguments: Vectors) -> geometry.Characteristics:
    """Return the numbers of the motion."""
    return geometry.Characteristics(*_NUMBERS(*arguments))


def state(
    motion: Any, elapsed: Float64[Array, "..."], rest: Float64[Array, "..."]
) -> tuple[Float64[Array, "*batch 4"], Float64[Array, "*batch 3"]]:
    """Return attitude (…, 4) and momentum (…, 3) at the elapsed times, which broadcast against the motion's batch."""
    if is_jax(elapsed, *motion._arguments):
        return _STATE(*motion._arguments, elapsed, rest)  # type: ignore[return-value]
    return FORM.states_of(motion, elapsed, rest)


def _symmetric(moments: Array) -> Array:
    """Return moments of which the first two are their mean, as the derivatives take them: they are one quantity."""
    xp = namespace(moments)
    mean = 0.5 * (moments[..., 0] + moments[..., 1])
    return xp.stack([mean, mean, moments[..., 2]], axis=-1)


def _state(*arguments: Array) -> tuple[Array, Array]:
    moments, *vectors, elapsed, rest = arguments
    moments = _symmetric(moments)
    if not is_jax(*arguments):
        return FORM.states(FORM.columns((moments, *vectors)), elapsed, rest)
    from polhode.exact.lagrange_top._preparation import STATES

    columns = columns_in_blocks(_columns_of_tops, (moments, *vectors))
    parts = STATES.evaluate(columns, elapsed, rest)
    return stack_last(parts[:4]), stack_last(parts[4:])


def _state_jacobian(*arguments: Array) -> tuple[tuple[Array, Array], Array]:
    """The columns are of the arguments, of which the rest of the elapsed time changes nothing more."""
    from polhode.exact.lagrange_top._preparation import prepare
    from polhode.exact.lagrange_top._tangent import state_tangent, tangent_data

    value = _state(*arguments)

    def columns(*arguments: Array) -> Array:
        moments, *vectors, time, attitude, momentum = arguments
        xp = namespace(time)
        *changes, d_time = units(xp, time.shape, (*SIZES, 1))
        data = tangent_data(prepare(_symmetric(moments), *vectors))
        tangents = state_tangent(data, time, (attitude, momentum), (*changes, d_time[..., 0]))
        tangents = xp.moveaxis(xp.concat(tangents, axis=-1), 0, -1)
        return xp.concat([tangents, xp.zeros_like(tangents[..., :1])], axis=-1)

    return value, in_blocks(columns, (*arguments[:5], *value), (1, 1, 1, 1, 0, 1, 1))


def _numbers(moments: Array, *vectors: Array) -> geometry.Characteristics:
    arguments = _symmetric(moments), *vectors
    xp = namespace(*arguments)
    shape = np.broadcast_shapes(*(v.shape[:-1] for v in arguments))
    with np.errstate(all="ignore"):
        return geometry.characteristics(*(xp.broadcast_to(v, (*shape, v.shape[-1])) for v in arguments))


def _numbers_jacobian(*arguments: Array) -> tuple[geometry.Characteristics, Array]:
    from polhode.exact.lagrange_top._geometry_tangent import changed_numbers
    from polhode.exact.lagrange_top._preparation import prepare
    from polhode.exact.lagrange_top._tangent import tangent_data

    value = _numbers(*arguments)

    def columns(*arguments: Array) -> Array:
        vectors, numbers = (_symmetric(arguments[0]), *arguments[1:4]), arguments[5:]
        xp = namespace(*arguments)
        changes = tuple(units(xp, numbers[0].shape, SIZES))
        tangents = changed_numbers(tangent_data(prepare(*vectors)), numbers, changes)
        return xp.moveaxis(xp.stack(xp.broadcast_arrays(*tangents), axis=-1), 0, -1)

    return value, in_blocks(columns, (*arguments, *value), (1, 1, 1, 1, *(0 for _ in value)))


_VECTORS = tuple((n,) for n in SIZES)
_STATE = Elementwise("LagrangeMotion", _state, (*_VECTORS, (), ()), (((4,), float), ((3,), float)), _state_jacobian)
_NUMBERS = Elementwise("LagrangeMotion", _numbers, _VECTORS, (((), int), *(((), float),) * 7), _numbers_jacobian)
