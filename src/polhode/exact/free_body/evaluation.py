"""Running the free body's closed form over batches, on JAX with its derivative."""

from __future__ import annotations

from typing import Any

import numpy as np

from polhode.arrays import (
    compiled,
    custom_derivative,
    forward_columns,
    is_jax,
    namespace,
    stack_last,
    stop_gradient,
)
from polhode.exact.blocks import Columns, Vectors, columns_in_blocks, state_in_blocks
from polhode.exact.free_body import geometry
from polhode.exact.free_body.derivative import state_tangent
from polhode.exact.free_body.preparation import prepare
from polhode.exact.free_body.spinor import evaluate
from polhode.types import Array, Float64


def motion_columns(arguments: Vectors) -> Columns:
    """Return the constants of motion of moments (…, 3), momentum (…, 3), attitude (…, 4) as columns."""
    return columns_in_blocks(_columns_of_bodies, arguments)


def _columns_of_bodies(moments: Array, momentum: Array, attitude: Array) -> tuple[Array, ...]:
    return prepare(moments, momentum, attitude).motion


def characteristics(
    moments: Float64[Array, "*#batch 3"], momentum: Float64[Array, "*#batch 3"]
) -> geometry.Characteristics:
    """Return the numbers of the motion for arrays (…, 3)."""
    if is_jax(moments, momentum):
        return compiled(_differentiable_characteristics, moments)(moments, momentum)
    with np.errstate(all="ignore"):
        return geometry.characteristics(*np.broadcast_arrays(moments, momentum))


def _differentiable_characteristics(moments: Array, momentum: Array) -> geometry.Characteristics:
    shape = np.broadcast_shapes(moments.shape, momentum.shape)
    xp = namespace(moments, momentum)
    moments, momentum = xp.broadcast_to(moments, shape), xp.broadcast_to(momentum, shape)
    codes = geometry.characteristics(*stop_gradient((moments, momentum)))[:2]
    numbers = forward_columns(lambda *x: tuple(geometry.characteristics(*x)[2:]), "FreeMotion")(moments, momentum)
    return geometry.Characteristics(*codes, *numbers)


def state(
    columns: Columns, arguments: Vectors, elapsed: Float64[Array, "..."], rest: Float64[Array, "..."]
) -> tuple[Float64[Array, "*batch 4"], Float64[Array, "*batch 3"]]:
    """Return attitude (…, 4) and momentum (…, 3) at the elapsed times, which broadcast against the columns."""
    if is_jax(elapsed, *columns):
        return compiled(_differentiable_state, elapsed)(columns, arguments, elapsed, rest)
    return state_in_blocks(evaluate, columns, elapsed, rest)


def _differentiable_state(columns: Columns, arguments: Vectors, elapsed: Array, rest: Array) -> tuple[Array, Array]:
    flow = custom_derivative(_stacked, _stacked_rule)
    return flow(*arguments, elapsed, rest, stop_gradient(columns))


def _stacked(
    moments: Array, momentum: Array, attitude: Array, elapsed: Array, rest: Array, columns: Columns
) -> tuple[Array, Array]:
    parts = evaluate(columns, elapsed, rest)
    return stack_last(parts[:4]), stack_last(parts[4:])


def _stacked_rule(primals: tuple[Any, ...], tangents: tuple[Any, ...]) -> tuple[Any, Any]:
    """The columns are constants here: what they change by is in the exact tangent."""
    value = _stacked(*primals)
    shape = value[0].shape[:-1]
    xp = namespace(value[0])

    def spread(values: tuple[Array, ...]) -> tuple[Array, ...]:
        vectors = (xp.broadcast_to(v, (*shape, v.shape[-1])) for v in values[:3])
        return (*vectors, xp.broadcast_to(values[3], shape))

    return value, state_tangent(spread(primals), value, spread(tangents))
