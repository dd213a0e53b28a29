"""The seam between NumPy and JAX: the only file of the closed-form half that may touch JAX, and only once a
JAX array has come in."""

from __future__ import annotations

import sys
from collections.abc import Callable
from typing import Any

import array_api_compat
import array_api_compat.numpy as numpy_namespace
import numpy as np

from polhode.errors import InvalidInput

Array = Any


def is_jax(*values: Any) -> bool:
    """Whether any of the values is a JAX array or tracer."""
    return "jax" in sys.modules and any(array_api_compat.is_jax_array(value) for value in values)


def is_traced(*values: Any) -> bool:
    """Whether any of the values is a JAX tracer, whose numbers cannot be looked at."""
    if not is_jax(*values):
        return False
    import jax

    return any(isinstance(value, jax.core.Tracer) for value in values)


def namespace(*values: Any) -> Any:
    """Return the array namespace shared by mixed inputs: JAX if any is JAX, NumPy for scalars and lists.

    A tracer beside NumPy constants is the normal case of ``jax.grad``; everything is then lifted to JAX.
    """
    if is_jax(*values):
        import jax.numpy

        return jax.numpy
    foreign = [v for v in values if array_api_compat.is_array_api_obj(v) and not isinstance(v, np.ndarray | np.generic)]
    return array_api_compat.array_namespace(*foreign) if foreign else numpy_namespace


def as_float64(xp: Any, value: Any, name: str) -> Array:
    """Return ``value`` as a float64 array of the namespace.

    Raises:
        InvalidInput: if it is a float32 or complex array, or not numeric at all. Single precision cannot carry
            phases, so it is refused instead of silently widened.
    """
    dtype = getattr(value, "dtype", None)
    if dtype is not None and any(kind in str(dtype) for kind in ("float16", "float32", "complex")):
        hint = " and set jax.config.update('jax_enable_x64', True)" if is_jax(value) else ""
        raise InvalidInput(f"`{name}` must be real and float64; got {dtype}. Convert it to float64{hint}.")
    if xp is not numpy_namespace and is_jax(value):
        return xp.asarray(value, dtype=xp.float64)
    try:
        return xp.asarray(value if array_api_compat.is_array_api_obj(value) and xp is not numpy_namespace
                          and not isinstance(value, np.ndarray) else np.asarray(value, dtype=np.float64),
                          dtype=xp.float64)
    except (TypeError, ValueError) as error:
        raise InvalidInput(f"`{name}` must be an array of numbers; got {value!r} ({error}).") from None


def barrier(value: Any) -> Any:
    """Keep XLA from contracting ``a*b - p`` across this point; on other arrays nothing can."""
    if not is_jax(*(value if isinstance(value, tuple) else (value,))):
        return value
    import jax

    return jax.lax.optimization_barrier(value)


def stop_gradient(value: Any) -> Any:
    """Return the value as a constant of differentiation."""
    if not is_jax(*(value if isinstance(value, tuple) else (value,))):
        return value
    import jax

    return jax.lax.stop_gradient(value)


def iterate(count: int, step: Callable[[Any], Any], state: Any, like: Any) -> Any:
    """Apply ``step`` ``count`` times: a rolled loop where ``like`` is a JAX array, since unrolled loops compile slowly."""
    if not is_jax(like):
        for _ in range(count):
            state = step(state)
        return state
    import jax

    return jax.lax.fori_loop(0, count, lambda _, carried: step(carried), state)
