"""The operations of a jaxpr on numbers, by NumPy where it has them: JAX compiles for longer than many of them take.

A row of an array gives equal bits whatever the other rows are.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np

from polhode._base.arrays.gathering import gather, scatter, take_dynamic_slice, update_dynamic_slice
from polhode._base.jaxprs import Entry
from polhode.types import Array, Shaped


def by_numbers(entry: Entry, arguments: list[Array]) -> list[Shaped[Array, "..."]]:
    """Return the values of an operation of a jaxpr on arrays of numbers."""
    if entry.name in BY_NUMPY:  # JAX would compile each operation by itself
        with np.errstate(all="ignore"):  # JAX says nothing of infinite numbers either
            results = BY_NUMPY[entry.name](arguments, entry.parameters)
        results = results if type(results) is list else [results]
        return [np.asarray(x, kind.dtype) for x, kind in zip(results, entry.made, strict=True)]
    import jax
    import jax.numpy as jnp

    # NumPy cannot hold JAX's random keys
    return [x if jnp.issubdtype(x.dtype, jax.dtypes.extended) else np.asarray(x)
            for x in entry.bind(map(jnp.asarray, arguments))]


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
    """Return the factors of ``dot_general`` as arrays (batch, free, summed), and the result's shape."""
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
    result = np.zeros((len(left), left.shape[1], right.shape[1]), np.result_type(left, right))
    for k in range(left.shape[2]):  # BLAS sums in an order that depends on the number of rows
        result += left[:, :, None, k] * right[:, None, :, k]
    return result.reshape(shape)


def _pad(x: Array, value: Array, widths: Any) -> Array:
    """Return ``pad``: values added before, behind and between; a negative count cuts values off."""
    gained = [(max(int(low), 0), max(int(high), 0), int(between)) for low, high, between in widths]
    sizes = [n + max(n - 1, 0) * between + low + high for n, (low, high, between) in zip(x.shape, gained, strict=True)]
    padded = np.full(sizes, value, np.result_type(x, value))
    inside = zip(sizes, gained, strict=True)
    padded[tuple(slice(low, size - high, between + 1) for size, (low, high, between) in inside)] = x
    lost = zip(sizes, widths, strict=True)
    return padded[tuple(slice(max(-int(low), 0), size - max(-int(high), 0)) for size, (low, high, _) in lost)]


def _round_away(x: Array) -> Array:
    """Return values rounded to whole numbers, halves away from zero."""
    whole = np.trunc(x)
    return whole + np.copysign(np.abs(x - whole) >= 0.5, x)


def _from_end(sums: Callable[..., Any], x: Array, parameters: dict[str, Any]) -> Array:
    axis = parameters["axis"]
    return np.flip(sums(np.flip(x, axis), axis), axis) if parameters["reverse"] else sums(x, axis)


def _select(x: list[Array]) -> Array:
    """Return ``select_n``: where true, the second of two."""
    return np.where(x[0], x[2], x[1]) if x[0].dtype == bool else np.choose(x[0], x[1:])


def _along(reduce: Callable[..., Any]) -> Callable[[list[Array], dict[str, Any]], Any]:
    """Return a reduction; axes come last, as NumPy sums along others in another order where these are short."""

    def along(x: list[Array], parameters: dict[str, Any]) -> Array:
        axes = tuple(parameters["axes"])
        kept = [k for k in range(x[0].ndim) if k not in axes]
        rows = np.transpose(x[0], (*kept, *axes)).reshape(*(x[0].shape[k] for k in kept), -1)
        return reduce(np.ascontiguousarray(rows), axis=-1)

    return along


def _divide(a: Array, b: Array) -> Array:
    """Return ``div``, which rounds quotients of whole numbers towards zero, where NumPy rounds them down."""
    if np.issubdtype(a.dtype, np.inexact):
        return a / b
    down = a // b
    return down + ((down < 0) & (down * b != a))


def _convert(x: Array, kind: Any) -> Array:
    """Return an array of another type; real numbers have the real part, as in JAX, of which NumPy warns."""
    real = np.iscomplexobj(x) and (np.issubdtype(kind, np.floating) or np.issubdtype(kind, np.integer))
    return (x.real if real else x).astype(kind)


def _put(array: Array, places: tuple[Array, ...], values: Array) -> None:
    """Write values; with the ellipsis an array of one object is its element, and does not become one."""
    array[(*places, ...)] = values


MOVES: dict[str, Callable[[list[Array], dict[str, Any]], Any]] = {
    "stop_gradient": lambda x, p: x[0],
    "copy": lambda x, p: x[0],
    "rev": lambda x, p: np.flip(x[0], axis=tuple(p["dimensions"])),
    "expand_dims": lambda x, p: np.expand_dims(x[0], tuple(p["dimensions"])),
    "stack": lambda x, p: np.stack(x, axis=p["axis"]),
    "reshape": lambda x, p: x[0].reshape(p["new_sizes"]),
    "squeeze": lambda x, p: np.squeeze(x[0], axis=tuple(p["dimensions"])),
    "transpose": lambda x, p: np.transpose(x[0], p["permutation"]),
    "broadcast_in_dim": lambda x, p: spread(x[0], p),
    "pad": lambda x, p: _pad(x[0], x[1], p["padding_config"]),
    "tile": lambda x, p: np.tile(x[0], p["reps"]),
    "slice": lambda x, p: take_slice(x[0], p),
    "split": lambda x, p: np.split(x[0], np.cumsum(p["sizes"])[:-1], p["axis"]),
    "unstack": lambda x, p: list(np.moveaxis(np.asarray(x[0]), p["axis"], 0)),
    "concatenate": lambda x, p: np.concatenate(x, axis=p["dimension"]),
    "select_n": lambda x, p: _select(x),
    "gather": gather,
    "scatter": scatter(_put),
    "dynamic_slice": take_dynamic_slice,
    "dynamic_update_slice": update_dynamic_slice,
}
"""Operations that compute nothing: elements of arrays, which may be anything, come to other places."""

BY_NUMPY: dict[str, Callable[[list[Array], dict[str, Any]], Any]] = {
    **MOVES,
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
    "tan": lambda x, p: np.tan(x[0]),
    "asin": lambda x, p: np.arcsin(x[0]),
    "acos": lambda x, p: np.arccos(x[0]),
    "atan": lambda x, p: np.arctan(x[0]),
    "atan2": lambda x, p: np.arctan2(x[0], x[1]),
    "sinh": lambda x, p: np.sinh(x[0]),
    "cosh": lambda x, p: np.cosh(x[0]),
    "tanh": lambda x, p: np.tanh(x[0]),
    "exp": lambda x, p: np.exp(x[0]),
    "expm1": lambda x, p: np.expm1(x[0]),
    "log": lambda x, p: np.log(x[0]),
    "log1p": lambda x, p: np.log1p(x[0]),
    "cbrt": lambda x, p: np.cbrt(x[0]),
    "rsqrt": lambda x, p: 1.0 / np.sqrt(x[0]),
    "pow": lambda x, p: x[0] ** x[1],
    "floor": lambda x, p: np.floor(x[0]),
    "ceil": lambda x, p: np.ceil(x[0]),
    "round": lambda x, p: np.round(x[0]) if int(p["rounding_method"]) else _round_away(x[0]),
    "abs": lambda x, p: np.abs(x[0]),
    "is_finite": lambda x, p: np.isfinite(x[0]),
    "real": lambda x, p: np.real(x[0]),
    "imag": lambda x, p: np.imag(x[0]),
    "conj": lambda x, p: np.conj(x[0]),
    "complex": lambda x, p: x[0] + 1j * x[1],
    "max": lambda x, p: np.maximum(x[0], x[1]),
    "min": lambda x, p: np.minimum(x[0], x[1]),
    "reduce_max": _along(np.max),
    "reduce_min": _along(np.min),
    "reduce_sum": _along(np.sum),
    "reduce_prod": _along(np.prod),
    "reduce_and": _along(np.all),
    "reduce_or": _along(np.any),
    "argmax": lambda x, p: np.argmax(x[0], axis=p["axes"][0]),
    "argmin": lambda x, p: np.argmin(x[0], axis=p["axes"][0]),
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
    "shift_left": lambda x, p: x[0] << x[1],
    "shift_right_arithmetic": lambda x, p: x[0] >> x[1],
    "bitcast_convert_type": lambda x, p: x[0].copy().view(p["new_dtype"]),
    "cumsum": lambda x, p: _from_end(np.cumsum, x[0], p),
    "clamp": lambda x, p: np.minimum(np.maximum(x[1], x[0]), x[2]),
    "rem": lambda x, p: np.fmod(x[0], x[1]),
    "sign": lambda x, p: np.where(x[0] == 0, x[0], np.sign(x[0])),
    "exp2": lambda x, p: np.exp2(x[0]),
    "xor": lambda x, p: x[0] ^ x[1],
    "iota": lambda x, p: np.indices(p["shape"])[p["dimension"]],
    "convert_element_type": lambda x, p: _convert(x[0], p["new_dtype"]),
    "scatter-add": scatter(np.add.at),
    "scatter_add": scatter(np.add.at),
}
