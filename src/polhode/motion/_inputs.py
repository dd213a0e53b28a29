"""Checks of the arguments of exact motions, and the form of their answers for a single body."""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np

from polhode._base.arrays import as_float64, compiled, is_jax, is_traced, namespace
from polhode.errors import InvalidInput
from polhode.rotation import LIMITS as ROTATION_LIMITS
from polhode.types import Array, ArrayLike, ArrayOrFloat, Float64, FloatOrArray, Integer, Real, Shaped

MOST_RADIANS = 1e27  # of a phase, which has 104 bits


class InputLimits(NamedTuple):
    """A number beyond which an inertia tensor is refused."""

    max_asymmetry: float = 1e-9  # of a matrix, relative: an inertia tensor that was typed in or computed


LIMITS = InputLimits()


class cached_unless_traced(cached_property):
    """A property with several arrays, computed once; traced ones are not kept, as they end with their function."""

    def __get__(self, instance: Any, owner: type | None = None) -> Any:
        value: Any = super().__get__(instance, owner)
        if instance is not None and is_traced(*value):
            del vars(instance)[self.attrname]
        return value


def one_of(name: str, argument: ArrayLike | None, attribute: ArrayLike | None) -> ArrayLike | None:
    """Return an argument of a motion that may also be given by the name of the attribute that keeps it.

    Args:
        name: of the argument; the attribute's has ``_at_epoch`` added.
        argument, attribute: the two; ``dataclasses.replace`` passes the second.

    Raises:
        InvalidInput: if both are given.
    """
    if argument is not None and attribute is not None:
        raise InvalidInput(f"give `{name}` or `{name}_at_epoch`, not both: they are the same.")
    return attribute if argument is None else argument


def spin_of(momentum: ArrayLike | None, angular_velocity: ArrayLike | None) -> tuple[str, ArrayLike]:
    """Return the argument that gives a body's spin, with its name.

    Raises:
        InvalidInput: unless exactly one is given.
    """
    if (angular_velocity is None) == (momentum is None):
        raise InvalidInput("give exactly one of `angular_velocity` and `momentum` to say how the body spins.")
    return ("momentum", momentum) if angular_velocity is None else ("angular_velocity", angular_velocity)


def momentum_of(moments: Float64[Array, "..."], angular_velocity: Float64[Array, "..."]) -> Float64[Array, "..."]:
    """Return IΩ along the principal axes; an overflow is refused later, with the momentum."""
    common_shape(moments=moments, angular_velocity=angular_velocity)
    with np.errstate(over="ignore", invalid="ignore"):
        return moments * angular_velocity


def refuse_tensor(moments: Float64[Array, "..."], vector: Float64[Array, "..."]) -> None:
    """Refuse an inertia tensor where principal moments belong; it would be taken for three bodies."""
    if tuple(moments.shape) != (3, 3) or vector.ndim != 1 or is_traced(moments):
        return
    matrix = np.asarray(moments)
    if not np.isfinite(matrix).all() or np.abs(matrix - matrix.T).max() > LIMITS.max_asymmetry * np.abs(matrix).max():
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
    if len(alike := set(shapes.values())) == 1:
        return alike.pop()
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
    if _is_one_fine(moments, momentum, attitude, epoch):
        return moments, momentum, attitude
    common_shape(moments=moments[..., 0], momentum=momentum[..., 0], attitude=attitude[..., 0], epoch=epoch)
    if is_traced(moments, attitude, epoch):
        return compiled(_nan_where_bad, moments)(moments, momentum, attitude)
    _refuse(*known(moments, momentum, attitude, epoch))
    return moments, momentum, attitude


def _good(xp: Any, moments: Array, attitude: Array) -> tuple[Array, Array]:
    """Return where moments are physical, and where quaternions are of unit length (…, 1)."""
    # entry by entry, as NumPy is slow along short axes
    w, x, y, z = (attitude[..., k : k + 1] for k in range(4))
    length = xp.sqrt((w * w + x * x) + (y * y + z * z))
    good = (moments > 0) & xp.isfinite(moments)
    return good[..., 0:1] & good[..., 1:2] & good[..., 2:3], xp.abs(length - 1.0) < ROTATION_LIMITS.max_length_error


def _is_one_fine(moments: Array, momentum: Array, attitude: Array, epoch: Array) -> bool:
    """Whether these are numbers of NumPy's for one body, and none is to be refused.

    A motion is often made for one state only: in plain numbers looking at them takes a fifth of the time.
    """
    if not (moments.ndim == momentum.ndim == attitude.ndim == 1 and epoch.ndim == 0):
        return False
    if not all(type(x) is np.ndarray for x in (moments, momentum, attitude, epoch)):
        return False
    w, x, y, z = attitude.tolist()
    length = math.sqrt((w * w + x * x) + (y * y + z * z))
    return (
        all(0.0 < x < math.inf for x in moments.tolist()) and all(map(math.isfinite, momentum.tolist()))
        and math.isfinite(epoch.item()) and abs(length - 1.0) < ROTATION_LIMITS.max_length_error
    )  # fmt: skip


def _nan_where_bad(moments: Array, momentum: Array, attitude: Array) -> tuple[Array, Array, Array]:
    xp = namespace(moments, momentum, attitude)
    good_moments, good_length = _good(xp, moments, attitude)
    where = lambda good, value: xp.where(good, value, math.nan)  # noqa: E731
    # traced numbers cannot be refused: they become NaN
    return where(good_moments, moments), where(good_moments, momentum), where(good_length, attitude)


def known(*values: Array) -> tuple[Shaped[Array, "..."], ...]:
    """Return JAX arrays that are not traced as NumPy's, in which nothing has to be compiled; others as they are."""
    return tuple(np.asarray(x) if is_jax(x) and not is_traced(x) else x for x in values)


def _refuse(moments: Array, momentum: Array, attitude: Array, epoch: Array) -> None:
    xp = namespace(moments, attitude)
    with np.errstate(over="ignore", invalid="ignore"):
        good_moments, good_length = _good(xp, moments, attitude)

    def first(values: Array, good: Array) -> str:
        return np.array2string(np.asarray(values)[~np.asarray(good)[..., 0]][0], separator=", ")

    if not bool(xp.all(good_moments)):
        raise InvalidInput(
            f"`moments` must be positive and finite; got {first(moments, good_moments)} kg m². "
            "A body with a zero moment (a thin rod) cannot spin about that axis; check values and units."
        )
    refuse_not_finite(momentum=momentum, epoch=epoch)
    if not bool(xp.all(good_length)):
        raise InvalidInput(
            f"`attitude` must be a unit quaternion (w, x, y, z); got {first(attitude, good_length)}. "
            "Divide it by its norm, and check that the scalar comes first."
        )


def refuse_not_finite(**named: Array) -> None:
    """Refuse concrete arrays with NaN or an infinity."""
    for name, value in named.items():
        if not all_finite(value):
            raise InvalidInput(f"`{name}` must be finite; got NaN or an infinity. Check where it comes from.")


def checked_times(xp: Any, t: Real[ArrayLike, "*shape"], batch: tuple[int, ...]) -> Float64[Array, "*shape"]:
    """Return times as float64; refuse concrete ones that are not finite, and shapes that do not fit the batch."""
    t = as_float64(xp, t, "t")
    if not all_finite(t):
        raise InvalidInput("`t` must be finite; got NaN or an infinity. Give times in seconds.")
    if t.shape and batch:
        common_shape(bodies=np.broadcast_to(0.0, batch), t=t)
    return t


def all_finite(values: Array) -> bool:
    """Whether concrete values are all finite; those of traced ones are not known, and pass."""
    (values,) = known(values)
    return is_traced(values) or bool(namespace(values).all(namespace(values).isfinite(values)))


def refuse_overflow(
    attitude: Float64[Array, "... 4"], t: Float64[Array, "..."], rates: Callable[[], Float64[Array, "..."]]
) -> None:
    """Refuse times whose phases have left the range of numbers, as the attitude shows, or have no digits left.

    Args:
        attitude: (…, 4) at the times.
        t: (…) [s].
        rates: function that returns those of the motion (…), about [rad/s].
    """
    if is_traced(attitude, t) or not t.size:
        return
    attitude, t, fastest = known(attitude, t, rates())
    if is_traced(fastest):
        return
    xp = namespace(t, fastest)
    with np.errstate(over="ignore", invalid="ignore"):
        # a phase in double-double, of 104 bits or 31 digits, has few of them left at 1e27 rad
        lost = bool(xp.any(xp.abs(t) * fastest > MOST_RADIANS))
    if lost or not all_finite(attitude[..., 0]):
        raise InvalidInput(
            f"`t` times the rate of rotation must be at most {MOST_RADIANS:.0e} rad, beyond which a phase has "
            f"hardly a digit left; got times up to {float(xp.max(xp.abs(t))):g} s. Check times and rates."
        )


def checked_sample_times(xp: Any, times: Real[ArrayLike, "time"]) -> Float64[Array, "time"]:
    """Return times as a float64 array (T,)."""
    times = as_float64(xp, times, "times")
    if times.ndim != 1 or times.shape[0] == 0:
        raise InvalidInput(f"`times` must be one-dimensional and not empty; got shape {tuple(times.shape)}.")
    return times


def plain_number(value: Float64[ArrayOrFloat, "*batch"]) -> Float64[ArrayOrFloat, "*batch"]:
    """Return a float for one concrete body; the array as it is otherwise."""
    return value if np.ndim(value) or is_traced(value) else float(value)


def plain_answer(value: Float64[ArrayOrFloat, "*batch"]) -> Float64[ArrayOrFloat, "*batch"] | None:
    """Return a float for one concrete body, None where it is undefined; the array as it is otherwise."""
    number = plain_number(value)
    return None if isinstance(number, float) and math.isnan(number) else number


def named_code(code: Integer[Array, "*batch"], names: tuple[str, ...]) -> str | Integer[Array, "*batch"]:
    """Return the name of one concrete body's code; the codes as they are otherwise."""
    return code if np.ndim(code) or is_traced(code) else names[int(code)]


def finite(answer: Float64[FloatOrArray, ""] | None) -> float | None:
    """Return one body's answer where it is a finite number, None where it is infinite or undefined."""
    return float(answer) if answer is not None and math.isfinite(answer) else None


def number_of(answer: Float64[FloatOrArray, ""] | None) -> float:
    """Return one body's answer that is known to be defined."""
    assert answer is not None
    return float(answer)


def name_of(regime: str | Integer[Array, ""]) -> str:
    """Return the name of one body's regime."""
    assert isinstance(regime, str)
    return regime
