"""JAX's ``gather`` and ``scatter`` as NumPy does them: windows of an array, of anything, at starts that numbers give.

The operations are those of XLA, https://openxla.org/xla/operation_semantics#gather and #scatter: each start has a
window, whose axes of length one may be left out; starts of which a window would not be inside are moved inside, or give
a value that fills, or are dropped.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, NamedTuple, SupportsIndex

import numpy as np

from polhode.types import Array, Bool, Integer, Shaped

Axes = Sequence[SupportsIndex]
"""Of an array; JAX names some by NumPy's integers."""


class _Windows(NamedTuple):
    """Where windows are in an array.

    Attributes:
        places: of each axis of the array, indices that broadcast to (batch…, window…).
        inside: (batch…) whether a window is inside as it was given.
        axes: how many the windows have.
    """

    places: list[Integer[np.ndarray, "..."]]
    inside: Bool[np.ndarray, "..."]
    axes: int


def gather(x: list[Array], parameters: dict[str, Any]) -> Shaped[Array, "..."]:
    """Return ``gather`` of an array and starts."""
    array, starts = x
    of = parameters["dimension_numbers"]
    between = of.operand_batching_dims, of.start_indices_batching_dims
    sizes, left_out = parameters["slice_sizes"], of.collapsed_slice_dims
    windows = _place(array.shape, starts, of.start_index_map, sizes, left_out, between)
    taken = array[(*windows.places, ...)]  # an array, of single numbers of any type too
    if parameters["mode"].name == "FILL_OR_DROP" and not windows.inside.all():
        inside = windows.inside.reshape(windows.inside.shape + (1,) * windows.axes)
        taken = np.where(inside, taken, _choose_filling(parameters["fill_value"], array.dtype))
    return np.transpose(taken, _axes_of(taken.ndim, of.offset_dims))


def scatter(put: Callable[[np.ndarray, Any, Any], None]) -> Callable[..., Shaped[Array, "..."]]:
    """Return a form of ``scatter`` from an array, starts, and windows to write there."""

    def compute(x: list[Array], parameters: dict[str, Any]) -> Array:
        array, starts, updates = x
        of = parameters["dimension_numbers"]
        between = of.operand_batching_dims, of.scatter_indices_batching_dims
        single = {*of.inserted_window_dims, *of.operand_batching_dims}
        lengths = iter(updates.shape[axis] for axis in of.update_window_dims)
        sizes = [1 if axis in single else next(lengths) for axis in range(array.ndim)]
        windows = _place(array.shape, starts, of.scatter_dims_to_operand_dims, sizes, of.inserted_window_dims, between)
        moved = np.transpose(updates, np.argsort(_axes_of(updates.ndim, of.update_window_dims)))
        result = np.array(array, np.result_type(array, updates))
        if parameters["mode"].name == "CLIP" or windows.inside.all():
            put(result, tuple(windows.places), moved)
        else:
            kept = np.broadcast_to(windows.inside.reshape(windows.inside.shape + (1,) * windows.axes), moved.shape)
            put(result, tuple(np.broadcast_to(one, moved.shape)[kept] for one in windows.places), moved[kept])
        return result

    return compute


def take_dynamic_slice(x: list[Array], parameters: dict[str, Any]) -> Shaped[Array, "..."]:
    """Return ``dynamic_slice`` of an array and one start for each axis."""
    return x[0][_dynamic(x[0].shape, x[1:], parameters["slice_sizes"])]


def update_dynamic_slice(x: list[Array], parameters: dict[str, Any]) -> Shaped[Array, "..."]:
    """Return ``dynamic_update_slice`` from an array, the values to write, and one start for each axis."""
    result = np.array(x[0], np.result_type(x[0], x[1]))
    result[_dynamic(result.shape, x[2:], x[1].shape)] = x[1]
    return result


def _dynamic(shape: Sequence[int], starts: Sequence[Array], sizes: Sequence[int]) -> tuple[slice, ...]:
    inside = (min(max(int(start), 0), whole - size) for whole, start, size in zip(shape, starts, sizes, strict=True))
    return tuple(slice(start, start + size) for start, size in zip(inside, sizes, strict=True))


def _place(
    shape: Sequence[int], starts: Array, named: Axes, sizes: Sequence[int], left_out: Axes, between: tuple[Axes, Axes]
) -> _Windows:
    """Return windows of some sizes; ``named`` are the axes of the array that starts (batch…, axis) are along.

    Axes of the array that belong to axes of the batch are named by ``between``; both they and those that are left out
    have length one in a window.
    """
    batch, places, inside = starts.shape[:-1], [], np.ones(starts.shape[:-1], bool)
    window = [axis for axis in range(len(shape)) if axis not in {*left_out, *between[0]}]
    for axis, (whole, size) in enumerate(zip(shape, sizes, strict=True)):
        first = np.zeros(batch, np.int64)
        if axis in named:
            given = starts[..., list(named).index(axis)].astype(np.int64)
            first = np.clip(given, 0, whole - size)
            inside &= given == first
        elif axis in between[0]:
            first = np.indices(batch)[between[1][list(between[0]).index(axis)]]
        first = np.reshape(first, (*batch, *(1,) * len(window)))
        along = [1] * len(window)
        if axis in window:
            along[window.index(axis)] = size
        places.append(first + np.arange(size).reshape(along) if axis in window else first)
    return _Windows(places, inside, len(window))


def _axes_of(count: int, of_window: Axes) -> list[int]:
    """Return the permutation of axes (batch…, window…) that puts those of windows at their places."""
    batch, order = count - len(of_window), []
    windows, rest = iter(range(batch, count)), iter(range(batch))
    for axis in range(count):
        order.append(next(windows) if axis in of_window else next(rest))
    return order


def _choose_filling(value: Any, dtype: Any) -> Any:
    """Return the filling value: NaN, or for whole numbers the extreme one of their type."""
    if value is not None:
        return np.asarray(value, dtype)
    if np.issubdtype(dtype, np.inexact) or np.issubdtype(dtype, np.object_):
        return np.asarray(np.nan, dtype)
    if np.issubdtype(dtype, np.bool_):
        return np.True_
    return np.iinfo(dtype).min if np.issubdtype(dtype, np.signedinteger) else np.iinfo(dtype).max
