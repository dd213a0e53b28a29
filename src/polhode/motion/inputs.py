"""What the exact motions ask of their arguments, and how they answer for one body."""

from __future__ import annotations

import math
from functools import cached_property
from typing import Any

import numpy as np

from polhode.arrays import as_float64, is_traced, known_false
from polhode.errors import InvalidInput

Array = Any
UNIT_TOLERANCE = 1e-6  # a quaternion further from unit length is taken for a mistake, not for rounding


class cached_unless_traced(cached_property):
    """A property with several arrays, computed once; traced ones are not kept, as they end with their function."""

    def __get__(self, instance: Any, owner: type | None = None) -> Any:
        value: Any = super().__get__(instance, owner)
        if instance is not None and is_traced(*value):
            del vars(instance)[self.attrname]
        return value


def checked_last_axis(name: str, value: Array, size: int) -> Array:
    """Return the array; refuse one whose last axis is not of the size."""
    if value.ndim == 0 or value.shape[-1] != size:
        raise InvalidInput(f"`{name}` must have shape (..., {size}); got {tuple(value.shape)}.")
    return value


def common_shape(**named: Array) -> tuple[int, ...]:
    """Return the shape that arrays broadcast to; refuse those that do not."""
    shapes = {name: tuple(value.shape) for name, value in named.items()}
    try:
        return tuple(np.broadcast_shapes(*shapes.values()))
    except ValueError:
        raise InvalidInput(
            f"batch axes must broadcast; got {', '.join(f'`{name}` {shape}' for name, shape in shapes.items())}. "
            "For all bodies at all times give the bodies a last batch axis of length 1: momentum (N, 1, 3), t (T,)."
        ) from None


def checked(xp: Any, moments: Array, momentum: Array, attitude: Array, epoch: Array) -> tuple[Array, Array, Array]:
    """Return moments, momentum and attitude as given; refuse bad concrete ones, turn bad traced ones to NaN."""
    for name, value, size in (("moments", moments, 3), ("momentum", momentum, 3), ("attitude", attitude, 4)):
        checked_last_axis(name, value, size)
    common_shape(moments=moments[..., 0], momentum=momentum[..., 0], attitude=attitude[..., 0], epoch=epoch)
    length = xp.sqrt(xp.sum(attitude * attitude, axis=-1, keepdims=True))
    good_moments = xp.all((moments > 0) & xp.isfinite(moments), axis=-1, keepdims=True)
    good_length = xp.abs(length - 1.0) < UNIT_TOLERANCE
    if not is_traced(good_moments, good_length, epoch):
        _refuse(xp, moments, momentum, attitude, epoch, good_moments, good_length)
    nan = math.nan
    return (
        xp.where(good_moments, moments, nan),
        xp.where(good_moments, momentum, nan),
        xp.where(good_length, attitude, nan),
    )


def _refuse(
    xp: Any, moments: Array, momentum: Array, attitude: Array, epoch: Array, good_moments: Array, good_length: Array
) -> None:
    def first(values: Array, good: Array) -> str:
        return np.array2string(np.asarray(values)[~np.asarray(good)[..., 0]][0], separator=", ")

    if not bool(xp.all(good_moments)):
        raise InvalidInput(
            f"`moments` must be positive and finite; got {first(moments, good_moments)} kg m². "
            "A body with a zero moment (a thin rod) cannot spin about that axis; check values and units."
        )
    refuse_not_finite(xp, momentum=momentum, epoch=epoch)
    if not bool(xp.all(good_length)):
        raise InvalidInput(
            f"`attitude` must be a unit quaternion (w, x, y, z); got {first(attitude, good_length)}. "
            "Divide it by its norm, and check that the scalar comes first."
        )


def refuse_not_finite(xp: Any, **named: Array) -> None:
    """Refuse concrete arrays with NaN or an infinity."""
    for name, value in named.items():
        if known_false(xp.all(xp.isfinite(value))):
            raise InvalidInput(f"`{name}` must be finite; got NaN or an infinity. Check where it comes from.")


def checked_times(xp: Any, t: Array, batch: tuple[int, ...]) -> Array:
    """Return times as float64; refuse concrete ones that are not finite, and shapes that do not fit the batch."""
    t = as_float64(xp, t, "t")
    if known_false(xp.all(xp.isfinite(t))):
        raise InvalidInput("`t` must be finite; got NaN or an infinity. Give times in seconds.")
    if t.shape and batch:
        common_shape(bodies=np.broadcast_to(0.0, batch), t=t)
    return t


def refuse_overflow(xp: Any, attitude: Array, t: Array) -> None:
    """Refuse times whose phases have left the range of numbers, as the attitude shows."""
    if known_false(xp.all(xp.isfinite(attitude[..., 0]))):
        raise InvalidInput(
            "`t` times the rate of rotation must be within the range of numbers; "
            f"got times up to {float(xp.max(xp.abs(t))):g} s. Check times and rates."
        )


def checked_sample_times(xp: Any, times: Array) -> Array:
    """Return times as a float64 array (T,)."""
    times = as_float64(xp, times, "times")
    if times.ndim != 1 or times.shape[0] == 0:
        raise InvalidInput(f"`times` must be one-dimensional and not empty; got shape {tuple(times.shape)}.")
    return times


def plain_answer(value: Array) -> Any:
    """Return a float for one concrete body, None where it is undefined; the array as it is otherwise."""
    if np.ndim(value) or is_traced(value):
        return value
    number = float(value)
    return None if math.isnan(number) else number


def finite(answer: float | None) -> float | None:
    """Return one body's answer where it is a finite number, None where it is infinite or undefined."""
    return answer if answer is not None and math.isfinite(answer) else None
