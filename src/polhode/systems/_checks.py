"""Checks of the numbers, vectors and directions that systems are made from."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import jax.numpy as jnp
import numpy as np

from polhode._base import check
from polhode._base.arrays import compiled_for_few_calls, is_jax, refuse_complex, require_doubles
from polhode.algebra.base import AbstractLieAlgebra
from polhode.errors import InvalidInput, shown
from polhode.types import Array, ArrayLike, Double, Float64, Real


class StartLimits(NamedTuple):
    """What decides that a point is on the dual, and that four numbers are a unit quaternion."""

    max_distance: float = 1e-6  # of a point's size: single precision leaves some 1e-7 of a trace
    max_length_error: float = 1e-6  # a quaternion further from unit length is a mistake, not rounding


LIMITS = StartLimits()


def checked_number(
    name: str, value: float, above: float | None = None, least: float | None = None, unit: str = ""
) -> Float64[Array, ""]:
    """Return a finite number as an array.

    Raises:
        InvalidInput: for anything else, or one out of range.
    """
    remedy = "Check its size and sign."
    return jnp.asarray(check.number(name, value, unit, above=above, least=least, remedy=remedy), float)  # not weakly


def checked_numbers(
    name: str, value: Real[ArrayLike, "*given"], count: int,
    above: float | None = None, least: float | None = None, unit: str = "",
) -> Float64[Array, "*numbers"]:
    """Return finite numbers as an array: () of one for all, or (count,) of one for each.

    Raises:
        InvalidInput: for another number of them, or one out of range.
    """
    require_doubles(**{name: value})
    numbers = as_floats(value)
    numbers = numbers.reshape(()) if numbers.size == 1 else numbers
    if numbers.shape not in ((), (count,)) or not _in_range(numbers, above, least):
        rule = f"one finite number{_range(above, least, unit)}, or one for each of {count}"
        raise InvalidInput(f"`{name}` must be {rule}; got {shown(value)}. Check their number, sizes and signs.")
    return jnp.asarray(numbers)


def checked_times(name: str, value: Real[ArrayLike, "..."]) -> np.ndarray:
    """Return finite times (P,) of one or a list.

    Raises:
        InvalidInput: otherwise.
    """
    require_doubles(**{name: value})
    times = np.atleast_1d(as_floats(value))
    if times.ndim != 1 or not times.size or not np.isfinite(times).all():
        raise InvalidInput(f"`{name}` must be a finite time [s], or a list of such; got {shown(value)}.")
    return times


def advancing_times(value: Real[ArrayLike, "time"]) -> Float64[np.ndarray, "time"]:
    """Return the `times` of a motion: at least two (T,) [s], which advance in one direction.

    Raises:
        InvalidInput: otherwise.
    """
    require_doubles(times=value)
    refuse_complex("times", value)
    try:
        times = np.asarray(value, dtype=float)
    except (TypeError, ValueError):
        raise InvalidInput(f"`times` must be numbers [s]; got {shown(value)}.") from None
    if times.ndim != 1 or len(times) < 2:
        raise InvalidInput(
            f"`times` must be at least two times (T,), the first that of the start; got shape {times.shape}."
        )
    if not (finite := np.isfinite(times)).all():
        wrong = np.flatnonzero(~finite)
        raise InvalidInput(
            f"`times` must be finite [s]; got {times[wrong[0]]} at index {wrong[0]}. Check where it comes from."
        )
    gaps = np.sign(times[1:] - times[:-1])
    if not (advances := gaps * (gaps[0] or 1.0) > 0).all():
        wrong = np.flatnonzero(~advances)
        before, here = times[wrong[0] : wrong[0] + 2].tolist()
        raise InvalidInput(
            f"`times` must advance in one direction, without repetitions; got {shown(here)} after {shown(before)} at "
            f"index {wrong[0] + 1}. Sort them, and leave out duplicates."
        )
    return times


def checked_vector(name: str, value: Real[ArrayLike, "3"]) -> Float64[Array, "3"]:
    """Return three finite numbers as an array.

    Raises:
        InvalidInput: otherwise.
    """
    return jnp.asarray(check.array(name, value, (3,)))


def checked_direction(name: str, value: Real[ArrayLike, "3"]) -> Float64[Array, "3"]:
    """Return a unit vector along a direction of any length.

    Raises:
        InvalidInput: for what is not three finite numbers, or has no direction.
    """
    direction = np.asarray(checked_vector(name, value))
    if not (largest := np.abs(direction).max()) > 0:
        raise InvalidInput(f"`{name}` must be a direction (3,); got (0, 0, 0).")
    direction = np.ldexp(direction, -np.frexp(largest)[1])  # squares of extreme lengths overflow
    return jnp.asarray(direction / np.linalg.norm(direction))


def checked_directions(name: str, value: Real[ArrayLike, "count 3"]) -> Float64[Array, "count 3"]:
    """Return unit vectors along directions of any length.

    Raises:
        InvalidInput: for what is not a list of directions.
    """
    require_doubles(**{name: value})
    rows = as_floats(value)
    if rows.ndim != 2 or rows.shape[-1] != 3 or not len(rows):
        raise InvalidInput(f"`{name}` must be a list of directions (n, 3); got {shown(value)}.")
    return jnp.asarray(np.stack([np.asarray(checked_direction(f"{name}[{k}]", row)) for k, row in enumerate(rows)]))


def as_finite_state(state: Real[ArrayLike, "*shape"], dtype: Any, length: int | None = None) -> Double[Array, "*shape"]:
    """Return a state as a new array of NumPy, or as JAX's if it is one.

    Raises:
        InvalidInput: for what is not a number, NaN or an infinity, or a last axis not of the length.
    """
    require_doubles(state=state)
    dtype = np.dtype(dtype)
    if dtype.kind != "c":
        refuse_complex("state", state)
    try:
        if not is_jax(state):
            state = np.array(state, dtype=dtype)
        elif state.dtype != dtype:
            state = jnp.asarray(state, dtype=dtype)
    except (TypeError, ValueError):
        raise InvalidInput(f"`state` must be numbers; got {shown(state)}.") from None
    if not np.logical_and.reduce(np.isfinite(np.asarray(state)), axis=None):
        raise InvalidInput("`state` must be finite; got NaN or an infinity. Check where it comes from.")
    if length is not None and state.shape[-1:] != (length,):
        raise InvalidInput(f"`state` must have shape (…, {length}); got {state.shape}.")
    return state


def check_unit_attitude(state: Float64[Array, "*batch n"]) -> Float64[Array, "*batch n"]:
    """Return states that begin with a quaternion.

    Raises:
        InvalidInput: if it is not of unit length.
    """
    off = np.abs(np.linalg.norm(np.asarray(state)[..., :4], axis=-1) - 1.0)
    if not np.logical_and.reduce(off < LIMITS.max_length_error, axis=None):
        raise InvalidInput("`state` must begin with a unit quaternion (w, x, y, z); divide it by its norm.")
    return state


def check_on_dual(algebra: AbstractLieAlgebra, state: Double[Array, "*shape"]) -> Double[Array, "*shape"]:
    """Return points of an algebra's dual.

    Raises:
        InvalidInput: if one of them does not lie there.
    """
    own = tuple(range(-len(algebra.element_shape), 0))
    points = np.asarray(state)
    size = np.max(np.abs(points), axis=own, keepdims=True, initial=0.0)
    points = points / np.where(size > 0.0, size, 1.0)  # sums of extreme sizes overflow
    off = float(np.max(np.abs(points - np.asarray(_project(algebra, points))), initial=0.0))
    if off > LIMITS.max_distance:
        raise InvalidInput(
            f"`state` must lie on the dual of {algebra.name}, whose points are {algebra.element_rule}; an entry is off "
            f"by {off:.3g} of the largest. Take the part there by `project(state)` of the algebra, or make a state "
            "by its `from_dual_vector(coordinates)`."
        )
    return state


@compiled_for_few_calls
def _project(algebra: AbstractLieAlgebra, points: Double[Array, "*shape"]) -> Double[Array, "*shape"]:
    return algebra.project(points)


def as_floats(value: Any) -> np.ndarray:
    """Return an array; of a value that is none of numbers, one that no check lets through."""
    try:
        return np.asarray(value, dtype=float)
    except (TypeError, ValueError, OverflowError):
        return np.full((1, 1, 1, 1), math.nan)


def _in_range(numbers: np.ndarray, above: float | None, least: float | None) -> bool:
    low = (above is None or (numbers > above).all()) and (least is None or (numbers >= least).all())
    return bool(np.isfinite(numbers).all() and low)


def _range(above: float | None, least: float | None, unit: str) -> str:
    words = (f" above {above:g}" if above is not None else "") + (f" not below {least:g}" if least is not None else "")
    return words + (f" [{unit}]" if unit else "")
