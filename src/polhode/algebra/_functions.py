"""Checks of functions that users give, such as Hamiltonians and Casimirs, before anything is built on them."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Any

import jax
import jax.numpy as jnp
import numpy as np

from polhode._base.arrays import in_jax_numpy
from polhode._base.arrays.traced_checks import check_traced
from polhode.errors import InvalidInput, PolhodeError, shown
from polhode.types import Array, Double, Float64

Function = Callable[[Double[Array, "..."]], Float64[Array, "..."]]


def check_functions(name: str, value: Any, shape: tuple[int, ...], dtype: Any) -> tuple[Function, ...]:
    """Return a list of functions; refuse what is not one, and functions as ``check_scalar`` does."""
    if callable(value) or not isinstance(value, Iterable):
        got = shown(value)
        raise InvalidInput(f"`{name}` must be a list of functions of one point; got {got}. Put it in brackets.")
    functions = tuple(value)
    for k, function in enumerate(functions):
        check_scalar(f"{name}[{k}]", function, shape, dtype)
    return functions


def check_scalar(name: str, function: Function, shape: tuple[int, ...], dtype: Any) -> None:
    """Refuse a function that does not give one real number at one point of a shape.

    Raises:
        InvalidInput: with what it gave, or how it failed.
    """
    try:
        with in_jax_numpy(f"functions such as `{name}`"):
            value = jax.eval_shape(function, jax.ShapeDtypeStruct(shape, dtype))
    except PolhodeError:
        raise
    except Exception as error:
        raise InvalidInput(
            f"`{name}` cannot be evaluated at a point of shape {shape}: {error}. Write it with jax.numpy for one point."
        ) from error
    got, kind = getattr(value, "shape", None), getattr(value, "dtype", np.dtype(object))
    if got != () or not jnp.issubdtype(kind, jnp.floating):
        raise InvalidInput(f"`{name}` must be a real scalar at one point; got shape {got} of {kind}.")
    traced = jax.make_jaxpr(function)(jax.ShapeDtypeStruct(shape, dtype))
    check_traced(f"`{name}`", traced)
