"""Evaluates closed forms over batches: with NumPy in blocks that stay in cache, with JAX at once."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np

from polhode._base.arrays import is_jax, namespace, stop_gradient
from polhode.types import Array, ArrayOrFloat, Float64, Shaped

Vectors = tuple[Float64[Array, "..."], ...]
Columns = tuple[Shaped[ArrayOrFloat, "..."], ...]  # numbers and whether something holds, for each body
Constants = Columns | Float64[np.ndarray, "constants *bodies"]  # of motions: nothing for JAX, or numbers alone
# glibc returns freed memory to the system above a threshold that it raises to the largest block freed so far; without
# this one, every block's temporaries would be faulted in again, which costs a third of the time
np.empty(4_000_000)


def columns_in_blocks(prepare: Callable[..., Columns], arguments: Vectors) -> Columns:
    """Return the columns that ``prepare`` computes from arrays (…, k), flat, for their common batch shape."""
    shape = np.broadcast_shapes(*(v.shape[:-1] for v in arguments))
    if is_jax(*arguments):
        xp = namespace(*arguments)
        return prepare(*stop_gradient(tuple(xp.broadcast_to(v, (*shape, v.shape[-1])) for v in arguments)))
    flat = [np.broadcast_to(v, (*shape, v.shape[-1])).reshape(-1, v.shape[-1]) for v in arguments]
    with np.errstate(all="ignore"):
        count = len(flat[0])
        # equal parts, large ones: set-up is thousands of calls, whose overhead outweighs the cache
        length = math.ceil(count / max(1, math.ceil(count / 16_384)))
        columns = prepare(*(v[:length] for v in flat))
        if count > length:
            first, columns = columns, tuple(np.empty(count, np.asarray(column).dtype) for column in columns)
            for start in range(0, count, length):
                part = prepare(*(v[start : start + length] for v in flat)) if start else first
                for column, values in zip(columns, part, strict=True):
                    column[start : start + length] = values
    # where all bodies are of one sort, what is common to it may be a single number
    return tuple(np.broadcast_to(np.asarray(column), count).reshape(shape) for column in columns)


def flatten_motion(motion: tuple[Any, ...]) -> Columns:
    """Return the numbers of a record, of which some stand in tuples, as one tuple."""
    return tuple(x for part in motion for x in (part if isinstance(part, tuple) else (part,)))


def units(xp: Any, shape: tuple[int, ...], sizes: tuple[int, ...]) -> list[Float64[Array, "count ..."]]:
    """Return unit changes of vectors of these sizes: one after the other along a new first axis, (N, …, size) each."""
    whole = xp.eye(sum(sizes), dtype=xp.float64)
    starts = [sum(sizes[:k]) for k in range(len(sizes))]
    parts = (whole[:, a : a + n] for a, n in zip(starts, sizes, strict=True))
    return [xp.broadcast_to(part.reshape(len(whole), *(1,) * len(shape), -1), (len(whole), *shape, part.shape[-1]))
            for part in parts]


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
    size, length = math.prod(shape), 1024  # derivatives at a time, of which each is some ten states
    flat = [x.reshape(size, *x.shape[len(shape) :]) for x in whole]
    with np.errstate(all="ignore"):
        parts = [columns(*(x[k : k + length] for x in flat)) for k in range(0, max(size, 1), length)]
    joined = np.concatenate(parts)
    return joined.reshape(*shape, *joined.shape[1:])
