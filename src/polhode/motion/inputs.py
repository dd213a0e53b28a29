"""What the exact motions ask of their arguments, and how they answer for one body."""

from __future__ import annotations

import math
from functools import cached_property
from typing import Any

import numpy as np

from polhode.arrays import as_float64, is_traced, known_false
from polhode.errors import InvalidInput, shown
from polhode.rotation import UNIT_TOLERANCE
from polhode.types import Array, ArrayLike, ArrayOrFloat, Float64, Real

SYMMETRY = 1e-9  # of a matrix, relative: an inertia tensor that was typed in or computed
MOST_RADIANS = 1e27  # of a phase, which has 104 bits


class cached_unless_traced(cached_property):
    """A property with several arrays, computed once; traced ones are not kept, as they end with their function."""

    def __get__(self, instance: Any, owner: type | None = None) -> Any:
        value: Any = super().__get__(instance, owner)
        if instance is not None and is_traced(*value):
            del vars(instance)[self.attrname]
        return value


def by_attributes(
    name: str, momentum: ArrayLike | None, attitude: ArrayLike, attributes: dict[str, ArrayLike]
) -> tuple[ArrayLike | None, ArrayLike, ArrayLike | None]:
    """Return momentum, attitude and axes where a motion's attributes may be given by their own names.

    Raises:
        TypeError: for other names.
        InvalidInput: for a momentum given twice.
    """
    unknown = attributes.keys() - {"momentum_at_epoch", "attitude_at_epoch", "axes"}
    if unknown:
        raise TypeError(f"{name}() got an unexpected keyword argument {shown(min(unknown))}")
    if momentum is not None and "momentum_at_epoch" in attributes:
        raise InvalidInput("give `momentum` or `momentum_at_epoch`, not both: they are the same.")
    momentum = attributes.get("momentum_at_epoch", momentum)
    return momentum, attributes.get("attitude_at_epoch", attitude), attributes.get("axes")


def spin_of(momentum: ArrayLike | None, angular_velocity: ArrayLike | None) -> tuple[str, ArrayLike]:
    """Return what says how a body spins, with its name.

    Raises:
        InvalidInput: unless exactly one is given.
    """
    if (angular_velocity is None) == (momentum is None):
        raise InvalidInput("give exactly one of `angular_velocity` and `momentum` to say how the body spins.")
    return ("momentum", momentum) if angular_velocity is None else ("angular_velocity", angular_velocity)


def momentum_of(moments: Float64[Array, "..."], angular_velocity: Float64[Array, "..."]) -> Float64[Array, "..."]:
    """Return IΩ along the principal axes; what overflows is refused with the momentum."""
    common_shape(moments=moments, angular_velocity=angular_velocity)
    with np.errstate(over="ignore", invalid="ignore"):
        return moments * angular_velocity


def refuse_tensor(moments: Float64[Array, "..."], vector: Float64[Array, "..."]) -> None:
    """Refuse an inertia tensor where principal moments belong; it would be taken for three bodies."""
    if tuple(moments.shape) != (3, 3) or vector.ndim != 1 or is_traced(moments):
        return
    matrix = np.asarray(moments)
    if not np.isfinite(matrix).all() or np.abs(matrix - matrix.T).max() > SYMMETRY * np.abs(matrix).max():
        return
    if np.linalg.eigvalsh(matrix)[0] > 0.0:
        raise InvalidInput(
            "`moments` must be the three principal moments; got a symmetric 3×3 matrix, an inertia tensor. Make a body "
            "of it, Body.from_inertia(tensor), and give that to FreeMotion.from_body, or its principal_moments. If "
            "three bodies are meant, give each its momentum."
        )


def checked_last_axis(name: str, value: Float64[Array, "..."], size: int) -> Float64[Array, "... {size}"]:
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


def checked(
    xp: Any,
    moments: Float64[Array, "..."],
    momentum: Float64[Array, "..."],
    attitude: Float64[Array, "..."],
    epoch: Float64[Array, "..."],
) -> tuple[Float64[Array, "... 3"], Float64[Array, "... 3"], Float64[Array, "... 4"]]:
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


def checked_times(xp: Any, t: Real[ArrayLike, "*shape"], batch: tuple[int, ...]) -> Float64[Array, "*shape"]:
    """Return times as float64; refuse concrete ones that are not finite, and shapes that do not fit the batch."""
    t = as_float64(xp, t, "t")
    if known_false(xp.all(xp.isfinite(t))):
        raise InvalidInput("`t` must be finite; got NaN or an infinity. Give times in seconds.")
    if t.shape and batch:
        common_shape(bodies=np.broadcast_to(0.0, batch), t=t)
    return t


def refuse_overflow(
    xp: Any, attitude: Float64[Array, "... 4"], t: Float64[Array, "..."], rates: Float64[Array, "..."]
) -> None:
    """Refuse times whose phases have left the range of numbers, as the attitude shows, or have no digits left.

    Args:
        xp: the namespace of the arrays.
        attitude: (…, 4) at the times.
        t: (…) [s].
        rates: (…) of the motion, about [rad/s].
    """
    if is_traced(attitude, t, rates) or not t.size:
        return
    with np.errstate(over="ignore", invalid="ignore"):
        lost = bool(xp.any(xp.abs(t) * rates > MOST_RADIANS))
    if lost or not bool(xp.all(xp.isfinite(attitude[..., 0]))):
        raise InvalidInput(
            f"`t` times the rate of rotation must be at most {MOST_RADIANS:.0e} rad, beyond which a phase has hardly a "
            f"digit left; got times up to {float(xp.max(xp.abs(t))):g} s. Check times and rates."
        )


def checked_sample_times(xp: Any, times: Real[ArrayLike, "time"]) -> Float64[Array, "time"]:
    """Return times as a float64 array (T,)."""
    times = as_float64(xp, times, "times")
    if times.ndim != 1 or times.shape[0] == 0:
        raise InvalidInput(f"`times` must be one-dimensional and not empty; got shape {tuple(times.shape)}.")
    return times


def plain_answer(value: Float64[ArrayOrFloat, "*batch"]) -> Float64[ArrayOrFloat, "*batch"] | None:
    """Return a float for one concrete body, None where it is undefined; the array as it is otherwise."""
    if np.ndim(value) or is_traced(value):
        return value
    number = float(value)
    return None if math.isnan(number) else number


def named_code(code: Array, names: tuple[str, ...]) -> Any:
    """Return the name of one concrete body's code; the codes as they are otherwise."""
    return code if np.ndim(code) or is_traced(code) else names[int(code)]


def finite(answer: float | None) -> float | None:
    """Return one body's answer where it is a finite number, None where it is infinite or undefined."""
    return answer if answer is not None and math.isfinite(answer) else None
