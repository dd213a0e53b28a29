"""Running closed forms over batches: NumPy in blocks that stay in cache, compiled kernels where they are worth it."""

from __future__ import annotations

import math
from collections.abc import Callable
from types import ModuleType
from typing import Any

import numpy as np

from polhode.arrays import is_jax, namespace, stop_gradient
from polhode.types import Array, ArrayOrFloat, Bool, Float64, Shaped

Vectors = tuple[Float64[Array, "..."], ...]
Columns = tuple[Shaped[ArrayOrFloat, "..."], ...]  # numbers and whether something holds, for each body
Evaluation = Callable[[Columns, Float64[Array, "block"], Float64[Array, "block"] | None], Columns]
BLOCK = 4096  # states at a time: some thirty live arrays of this length fit a second-level cache
RUN = 12500  # of one body, whose constants take no room there: the longer, the less the calls themselves cost
BODIES = 16_384  # bodies at a time: set-up is thousands of calls, whose overhead outweighs the cache
JACOBIANS = 1024  # derivatives at a time, of which each is some ten states
# glibc returns freed memory to the system above a threshold that it raises to the largest block freed so far; without
# this one, every block's temporaries would be faulted in again, which costs a third of the time
np.empty(4_000_000)
MANY = 4096  # times of one body from which a compiled kernel is worth loading
MANY_BODIES = 512  # likewise, of bodies
LONG_RUN = 256  # consecutive times of one body from which its constants are worth handling as scalars


def columns_in_blocks(prepare: Callable[..., Columns], arguments: Vectors) -> Columns:
    """Return what ``prepare`` makes of arrays (…, k), as flat columns of their common batch shape."""
    shape = np.broadcast_shapes(*(v.shape[:-1] for v in arguments))
    if is_jax(*arguments):
        xp = namespace(*arguments)
        return prepare(*stop_gradient(tuple(xp.broadcast_to(v, (*shape, v.shape[-1])) for v in arguments)))
    flat = [np.broadcast_to(v, (*shape, v.shape[-1])).reshape(-1, v.shape[-1]) for v in arguments]
    with np.errstate(all="ignore"):
        count = len(flat[0])
        length = math.ceil(count / max(1, math.ceil(count / BODIES)))  # equal parts
        columns = prepare(*(v[:length] for v in flat))
        if count > length:
            first, columns = columns, tuple(np.empty(count, np.asarray(column).dtype) for column in columns)
            for start in range(0, count, length):
                part = prepare(*(v[start : start + length] for v in flat)) if start else first
                for column, values in zip(columns, part, strict=True):
                    column[start : start + length] = values
    return tuple(np.asarray(column).reshape(shape) for column in columns)


def columns_of_many(
    set_up: Callable[..., tuple[Columns, Bool[Array, "body"]]], prepare: Callable[..., Columns], arguments: Vectors
) -> Columns:
    """Return what ``prepare`` makes of arrays (…, k), by a compiled ``set_up`` that may leave some bodies to it."""
    shape = np.broadcast_shapes(*(v.shape[:-1] for v in arguments))
    flat = tuple(np.broadcast_to(v, (*shape, v.shape[-1])).reshape(-1, v.shape[-1]) for v in arguments)
    columns, left = set_up(*flat)
    if left.any():
        of_left = columns_in_blocks(prepare, tuple(v[left] for v in flat))
        for column, values in zip(columns, of_left, strict=True):
            column[left] = values
    return tuple(column.reshape(shape) for column in columns)


def are_many(arguments: Vectors) -> bool:
    """Return whether NumPy arrays (…, k) are of so many bodies that a compiled kernel is worth loading."""
    sizes = math.prod(np.broadcast_shapes(*(v.shape[:-1] for v in arguments)))
    return sizes >= MANY_BODIES and all(isinstance(v, np.ndarray) for v in arguments)


def state_by_kernel(
    load: Callable[[], ModuleType], columns: Columns, elapsed: Float64[Array, "..."], rest: Float64[Array, "..."]
) -> tuple[Float64[Array, "*batch 4"], Float64[Array, "*batch 3"]] | None:
    """Return what ``state_in_blocks`` does, by a compiled kernel; None where it is not worth it."""
    batch = np.shape(columns[0])
    shape = np.broadcast_shapes(batch, elapsed.shape)
    one = math.prod(batch) == 1
    many = isinstance(elapsed, np.ndarray | np.generic) and math.prod(shape) >= (MANY if one else MANY_BODIES)
    if not many:
        return None
    kernel = load()
    times, rests = (
        np.ascontiguousarray(np.broadcast_to(x, shape), dtype=float).reshape(-1) for x in (elapsed, rest)
    )
    if one:
        found = kernel.states_of_one(tuple(np.asarray(column).item() for column in columns), times, rests)
    else:
        bodies = np.broadcast_to(np.arange(math.prod(batch)).reshape(batch), shape).reshape(-1)
        found = kernel.states_of_many(tuple(np.ravel(column) for column in columns), bodies, times, rests)
    return found[0].reshape(*shape, 4), found[1].reshape(*shape, 3)


def state_in_blocks(
    evaluate: Evaluation, columns: Columns, elapsed: Float64[Array, "..."], rest: Float64[Array, "..."]
) -> tuple[Float64[Array, "*batch 4"], Float64[Array, "*batch 3"]]:
    """Return attitude (…, 4) and momentum (…, 3) at the elapsed times, which broadcast against the columns."""
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

    def columns_of(block: slice) -> Columns:
        if scalar:
            which = 0 if index is None else index[block.start]
            return tuple(c[which, ...] for c in flat)  # arrays without axes: NumPy takes twice as long to read a scalar
        return tuple(c[block if index is None else index[block]] for c in flat)

    length = RUN if scalar else BLOCK
    with np.errstate(all="ignore"):
        for low in range(0, size, run if scalar else size):
            top = min(low + (run if scalar else size), size)
            for start in range(low, top, length):
                block = slice(start, min(start + length, top))
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


def units(xp: Any, shape: tuple[int, ...], sizes: tuple[int, ...]) -> list[Float64[Array, "count ..."]]:
    """Return unit changes of vectors of these sizes: one after the other along a new first axis, (N, …, size) each."""
    whole = xp.eye(sum(sizes), dtype=xp.float64)
    starts = [sum(sizes[:k]) for k in range(len(sizes))]
    parts = (whole[:, a : a + n] for a, n in zip(starts, sizes, strict=True))
    return [xp.broadcast_to(part.reshape(len(whole), *(1,) * len(shape), -1), (len(whole), *shape, part.shape[-1]))
            for part in parts]  # fmt: skip


def in_blocks(
    columns: Callable[..., Array], arguments: Columns, cores: tuple[int, ...]
) -> Float64[Array, "*batch values inputs"]:
    """Return columns (batch…, M, N) of arguments that broadcast, of which NumPy takes a block at a time.

    Args:
        columns: function of the arguments, all with the batch's shape.
        arguments: arrays with ``cores`` trailing axes each.
        cores: 0 or 1 for each argument.
    """
    xp = namespace(*arguments)
    shape = np.broadcast_shapes(*(x.shape[: x.ndim - core] for x, core in zip(arguments, cores, strict=True)))
    whole = [xp.broadcast_to(x, (*shape, *x.shape[x.ndim - core :])) for x, core in zip(arguments, cores, strict=True)]
    if is_jax(*arguments):
        return columns(*whole)
    size = math.prod(shape)
    flat = [x.reshape(size, *x.shape[len(shape) :]) for x in whole]
    with np.errstate(all="ignore"):
        parts = [columns(*(x[k : k + JACOBIANS] for x in flat)) for k in range(0, max(size, 1), JACOBIANS)]
    found = np.concatenate(parts)
    return found.reshape(*shape, *found.shape[1:])
