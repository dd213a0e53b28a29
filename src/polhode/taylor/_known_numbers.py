"""Operations of a jaxpr on known numbers, by NumPy where it has them, as JAX would compile each of them by itself."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import jax.numpy as jnp
import numpy as np

from polhode.types import Array, Shaped


def by_numbers(equation: Any, arguments: list[Array]) -> list[Shaped[Array, "..."]]:
    """Return the values of an operation of a jaxpr on arrays of numbers."""
    name = equation.primitive.name
    if name in BY_NUMPY:  # JAX would compile each operation by itself
        with np.errstate(all="ignore"):  # JAX says nothing of infinite numbers either
            results = BY_NUMPY[name](arguments, equation.params)
        return [np.asarray(results, equation.outvars[0].aval.dtype)]
    results = equation.primitive.bind(*[jnp.asarray(a) for a in arguments], **equation.params)
    return [np.asarray(x) for x in (results if equation.primitive.multiple_results else [results])]


def spread(x: Array, parameters: dict[str, Any]) -> Shaped[Array, "..."]:
    """Return ``broadcast_in_dim`` of an array of numbers or anything else."""
    shape = [1] * len(parameters["shape"])
    for k, axis in enumerate(parameters["broadcast_dimensions"]):
        shape[axis] = x.shape[k]
    return np.broadcast_to(x.reshape(shape), parameters["shape"])


def take_slice(x: Array, parameters: dict[str, Any]) -> Shaped[Array, "..."]:
    """Return ``slice`` of an array of numbers or anything else."""
    strides = parameters["strides"] or [1] * x.ndim
    limits = zip(parameters["start_indices"], parameters["limit_indices"], strides, strict=True)
    return x[tuple(slice(*each) for each in limits)]


def factors(
    x: list[Array], parameters: dict[str, Any]
) -> tuple[Shaped[Array, "..."], Shaped[Array, "..."], tuple[int, ...]]:
    """Return what is multiplied and summed along the last axis, (batch, free, summed) each, and the result's shape."""
    (summed_a, summed_b), (batch_a, batch_b) = parameters["dimension_numbers"]
    a, b = x
    free_a = [k for k in range(a.ndim) if k not in (*summed_a, *batch_a)]
    free_b = [k for k in range(b.ndim) if k not in (*summed_b, *batch_b)]
    size = lambda array, axes: math.prod(array.shape[k] for k in axes)  # noqa: E731
    left = np.transpose(a, (*batch_a, *free_a, *summed_a))
    right = np.transpose(b, (*batch_b, *free_b, *summed_b))
    left = left.reshape(size(a, batch_a), size(a, free_a), size(a, summed_a))
    right = right.reshape(size(b, batch_b), size(b, free_b), size(b, summed_b))
    shape = *(a.shape[k] for k in (*batch_a, *free_a)), *(b.shape[k] for k in free_b)
    return left, right, shape


def _dot(x: list[Array], parameters: dict[str, Any]) -> Array:
    left, right, shape = factors(x, parameters)
    return (left @ np.swapaxes(right, 1, 2)).reshape(shape)


def _divide(a: Array, b: Array) -> Array:
    """Return ``div``, which of whole numbers leaves out what is behind the point, where NumPy goes down."""
    if np.issubdtype(a.dtype, np.inexact):
        return a / b
    down = a // b
    return down + ((down < 0) & (down * b != a))


BY_NUMPY: dict[str, Callable[[list[Array], dict[str, Any]], Any]] = {
    "add": lambda x, p: x[0] + x[1],
    "add_any": lambda x, p: x[0] + x[1],
    "sub": lambda x, p: x[0] - x[1],
    "mul": lambda x, p: x[0] * x[1],
    "neg": lambda x, p: -x[0],
    "div": lambda x, p: _divide(x[0], x[1]),
    "integer_pow": lambda x, p: x[0] ** p["y"],
    "square": lambda x, p: x[0] * x[0],
    "sqrt": lambda x, p: np.sqrt(x[0]),
    "sin": lambda x, p: np.sin(x[0]),
    "cos": lambda x, p: np.cos(x[0]),
    "abs": lambda x, p: np.abs(x[0]),
    "max": lambda x, p: np.maximum(x[0], x[1]),
    "min": lambda x, p: np.minimum(x[0], x[1]),
    "reduce_max": lambda x, p: np.max(x[0], axis=tuple(p["axes"])),
    "reduce_sum": lambda x, p: np.sum(x[0], axis=tuple(p["axes"])),
    "dot_general": lambda x, p: _dot(x, p),
    "eq": lambda x, p: x[0] == x[1],
    "ne": lambda x, p: x[0] != x[1],
    "lt": lambda x, p: x[0] < x[1],
    "le": lambda x, p: x[0] <= x[1],
    "gt": lambda x, p: x[0] > x[1],
    "ge": lambda x, p: x[0] >= x[1],
    "and": lambda x, p: x[0] & x[1],
    "or": lambda x, p: x[0] | x[1],
    "not": lambda x, p: ~x[0],
    "iota": lambda x, p: np.indices(p["shape"])[p["dimension"]],
    "stack": lambda x, p: np.stack(x, axis=p["axis"]),
    "reshape": lambda x, p: x[0].reshape(p["new_sizes"]),
    "squeeze": lambda x, p: np.squeeze(x[0], axis=tuple(p["dimensions"])),
    "transpose": lambda x, p: np.transpose(x[0], p["permutation"]),
    "broadcast_in_dim": lambda x, p: spread(x[0], p),
    "slice": lambda x, p: take_slice(x[0], p),
    "concatenate": lambda x, p: np.concatenate(x, axis=p["dimension"]),
    "convert_element_type": lambda x, p: x[0].astype(p["new_dtype"]),
    "select_n": lambda x, p: np.choose(x[0].astype(int), x[1:]),
}
