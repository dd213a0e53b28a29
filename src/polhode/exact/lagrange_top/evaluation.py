"""Running the Lagrange top's closed form over batches, on JAX with its derivative."""

from __future__ import annotations

from typing import Any

import numpy as np

from polhode.arrays import compiled, custom_derivative, is_jax, namespace, stack_last, stop_gradient
from polhode.exact.blocks import Columns, Vectors, columns_in_blocks, state_in_blocks
from polhode.exact.lagrange_top import geometry
from polhode.exact.lagrange_top.geometry_tangent import changed_numbers
from polhode.exact.lagrange_top.preparation import prepare
from polhode.exact.lagrange_top.series import ENTRIES, evaluate
from polhode.exact.lagrange_top.tangent import TangentData, state_tangent, tangent_data
from polhode.types import Array, Float64

NUMBERS = ENTRIES + len(TangentData._fields)  # where they begin among the columns


def motion_columns(arguments: Vectors) -> Columns:
    """Return the constants of motion of moments (…, 3), mgl (…, 1), momentum (…, 3), attitude (…, 4) as columns.

    On JAX what the derivative needs follows what evaluation needs, and then the numbers of the motion.
    """
    return columns_in_blocks(_columns_of_tops, arguments)


def _columns_of_tops(*arguments: Array) -> tuple[Array, ...]:
    prepared = prepare(*arguments)
    if not is_jax(*arguments):
        return prepared.motion
    return (*prepared.motion, *tangent_data(prepared), *geometry.characteristics_of(*prepared[1:]))


def characteristics(columns: Columns, arguments: Vectors) -> geometry.Characteristics:
    """Return the numbers of the motion."""
    xp = namespace(*arguments)
    shape = np.broadcast_shapes(*(v.shape[:-1] for v in arguments))
    spread = tuple(xp.broadcast_to(v, (*shape, v.shape[-1])) for v in arguments)
    if not is_jax(*arguments):
        with np.errstate(all="ignore"):
            return geometry.characteristics(*spread)
    columns = stop_gradient(_with_derivative(columns, arguments))
    regime, *numbers = columns[NUMBERS:]
    differentiable = custom_derivative(lambda values, *_: values, _numbers_rule)
    numbers = differentiable(tuple(numbers), columns[ENTRIES:NUMBERS], *spread)
    return geometry.Characteristics(regime, *numbers)


def _numbers_rule(primals: tuple[Any, ...], tangents: tuple[Any, ...]) -> tuple[Any, Any]:
    """The values are constants here: what they change by comes from the columns and the changes of the arguments."""
    values, columns = primals[:2]
    data = TangentData(*(namespace(v).broadcast_to(v, values[0].shape) for v in columns))
    return values, changed_numbers(data, values, tangents[2:])


def state(
    columns: Columns, arguments: Vectors, elapsed: Float64[Array, "..."], rest: Float64[Array, "..."]
) -> tuple[Float64[Array, "*batch 4"], Float64[Array, "*batch 3"]]:
    """Return attitude (…, 4) and momentum (…, 3) at the elapsed times, which broadcast against the columns."""
    if is_jax(elapsed, *columns):
        return compiled(_differentiable_state, elapsed)(columns, arguments, elapsed, rest)
    return state_in_blocks(evaluate, columns, elapsed, rest)


def _differentiable_state(columns: Columns, arguments: Vectors, elapsed: Array, rest: Array) -> tuple[Array, Array]:
    flow = custom_derivative(_stacked, _stacked_rule)
    return flow(*arguments, elapsed, rest, stop_gradient(_with_derivative(columns, arguments)))


def _with_derivative(columns: Columns, arguments: Vectors) -> tuple[Array, ...]:
    """Return the columns as they are on JAX; those of a motion made on NumPy lack what the derivative needs."""
    return columns if len(columns) > ENTRIES else motion_columns(arguments)


def _stacked(
    moments: Array, mgl: Array, momentum: Array, attitude: Array, elapsed: Array, rest: Array,
    columns: Columns,
) -> tuple[Array, Array]:  # fmt: skip
    parts = evaluate(columns[:ENTRIES], elapsed, rest)
    return stack_last(parts[:4]), stack_last(parts[4:])


def _stacked_rule(primals: tuple[Any, ...], tangents: tuple[Any, ...]) -> tuple[Any, Any]:
    """The columns are constants here: what they change by is in the tangent."""
    value = _stacked(*primals)
    shape = value[0].shape[:-1]
    xp = namespace(value[0])

    vectors = (xp.broadcast_to(v, (*shape, v.shape[-1])) for v in tangents[:4])
    data = TangentData(*(xp.broadcast_to(v, shape) for v in primals[6][ENTRIES:NUMBERS]))
    time, change = (xp.broadcast_to(v[4], shape) for v in (primals, tangents))
    return value, state_tangent(data, time, value, (*vectors, change))
