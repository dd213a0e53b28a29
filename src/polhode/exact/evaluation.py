"""Running the closed form over batches: NumPy in blocks that stay in cache, JAX compiled."""

from __future__ import annotations

import math
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
from polhode.exact import geometry
from polhode.exact.derivative import state_tangent
from polhode.exact.preparation import prepare
from polhode.exact.spinor import evaluate

Array = Any
BLOCK = 4096  # states at a time: some thirty live arrays of this length fit a second-level cache
BODIES = 16384  # bodies at a time: set-up is thousands of calls, whose overhead outweighs the cache
# glibc returns freed memory to the system above a threshold that it raises to the largest block freed so far; without
# this one, every block's temporaries would be faulted in anew, which costs a third of the time
np.empty(3_000_000)
LONG_RUN = 256  # consecutive times of one body from which its constants are worth handling as scalars


def motion_columns(moments: Array, momentum: Array, attitude: Array) -> tuple[Array, ...]:
    """Return the constants of motion as flat columns of the bodies' common batch shape."""
    if is_jax(moments, momentum, attitude):
        shape = np.broadcast_shapes(moments.shape[:-1], momentum.shape[:-1], attitude.shape[:-1])
        xp = namespace(moments, momentum, attitude)
        values = (xp.broadcast_to(v, (*shape, v.shape[-1])) for v in (moments, momentum, attitude))
        return _columns_of_bodies(*stop_gradient(tuple(values)))
    shape = np.broadcast_shapes(moments.shape[:-1], momentum.shape[:-1], attitude.shape[:-1])
    flat = [np.broadcast_to(v, (*shape, v.shape[-1])).reshape(-1, v.shape[-1]) for v in (moments, momentum, attitude)]
    with np.errstate(all="ignore"):
        parts = [_columns_of_bodies(*(v[k : k + BODIES] for v in flat)) for k in range(0, max(len(flat[0]), 1), BODIES)]
    columns = parts[0] if len(parts) == 1 else [np.concatenate(column) for column in zip(*parts, strict=True)]
    return tuple(np.asarray(column).reshape(shape) for column in columns)


def _columns_of_bodies(moments: Array, momentum: Array, attitude: Array) -> tuple[Array, ...]:
    return prepare(moments, momentum, attitude).motion


def characteristics(moments: Array, momentum: Array) -> geometry.Characteristics:
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
    numbers = forward_columns(lambda *values: tuple(geometry.characteristics(*values)[2:]))(moments, momentum)
    return geometry.Characteristics(*codes, *numbers)


def state(
    columns: tuple[Array, ...], moments: Array, momentum: Array, attitude: Array, elapsed: Array, rest: Array
) -> tuple[Array, Array]:
    """Return attitude (…, 4) and momentum (…, 3) at the elapsed times, which broadcast against the columns."""
    if is_jax(elapsed, *columns):
        return compiled(_differentiable_state, elapsed)(columns, moments, momentum, attitude, elapsed, rest)
    return _state_in_blocks(columns, elapsed, rest)


def _differentiable_state(
    columns: tuple[Array, ...], moments: Array, momentum: Array, attitude: Array, elapsed: Array, rest: Array
) -> tuple[Array, Array]:
    flow = custom_derivative(_stacked, _stacked_rule)
    return flow(moments, momentum, attitude, elapsed, rest, stop_gradient(columns))


def _stacked(
    moments: Array, momentum: Array, attitude: Array, elapsed: Array, rest: Array, columns: tuple[Array, ...]
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


def _state_in_blocks(columns: tuple[Array, ...], elapsed: Array, rest: Array) -> tuple[Array, Array]:
    batch = columns[0].shape
    shape = np.broadcast_shapes(batch, elapsed.shape)
    size, bodies = math.prod(shape), math.prod(batch)
    attitude, momentum = np.empty((size, 4)), np.empty((size, 3))
    if size == 0:
        return attitude.reshape(*shape, 4), momentum.reshape(*shape, 3)
    elapsed = np.broadcast_to(elapsed, shape).reshape(-1)
    rest = np.broadcast_to(rest, shape).reshape(-1) if np.any(rest) else None
    flat = [column.reshape(-1) for column in columns]
    run = _constant_run(batch, shape)
    scalar = bodies == 1 or run >= LONG_RUN
    index = np.broadcast_to(np.arange(bodies).reshape(batch), shape).reshape(-1) if bodies not in (1, size) else None

    def columns_of(block: slice) -> tuple[Array, ...]:
        if scalar:
            return tuple(c[0 if index is None else index[block.start]] for c in flat)
        return tuple(c[block if index is None else index[block]] for c in flat)

    with np.errstate(all="ignore"):
        for low in range(0, size, run if scalar else size):
            top = min(low + (run if scalar else size), size)
            for start in range(low, top, BLOCK):
                block = slice(start, min(start + BLOCK, top))
                values = evaluate(columns_of(block), elapsed[block], None if rest is None else rest[block])
                for k in range(4):
                    attitude[block, k] = values[k]
                for k in range(3):
                    momentum[block, k] = values[4 + k]
    return attitude.reshape(*shape, 4), momentum.reshape(*shape, 3)


def _constant_run(batch: tuple[int, ...], shape: tuple[int, ...]) -> int:
    """Return how many consecutive entries of the broadcast shape belong to one body."""
    run = 1
    padded = (1,) * (len(shape) - len(batch)) + batch
    for mine, whole in zip(reversed(padded), reversed(shape), strict=True):
        if mine != 1:
            break
        run *= whole
    return max(run, 1)
