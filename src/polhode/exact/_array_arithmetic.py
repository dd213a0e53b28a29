"""Formulas for arrays of NumPy or JAX, elementwise with broadcasting, in place of single numbers."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from types import ModuleType, SimpleNamespace
from typing import Any

import numpy as np

from polhode._base import arrays
from polhode._base.arrays import is_jax, namespace, nearest, split_halves
from polhode._base.compiled.copying import copy_modules
from polhode.exact import _formulas as formulas
from polhode.exact import _kernel_arithmetic as kernel_arithmetic
from polhode.special import _circular as circular
from polhode.special import _doubledouble as dd
from polhode.types import Array


def for_arrays(*modules: ModuleType, **replaced: Callable[..., Any]) -> Any:
    """Return the names of modules, with functions of arrays.

    Args:
        modules: of formulas, with those they need; these of both motions come by themselves.
        replaced: functions in place of formulas that do not hold for all that arrays are made of.
    """
    parts = kernel_arithmetic, formulas, *modules
    spaces = copy_modules(parts, lambda function, _: function, FOR_ARRAYS | replaced)
    return SimpleNamespace(**{name: x for module in modules for name, x in spaces[module.__name__].items()})


def _where(condition: Array, x: Array, y: Array) -> Array:
    return namespace(condition, x, y).where(condition, x, y)


def _larger(x: Array, y: Array) -> Array:
    return namespace(x, y).maximum(x, y)


def _smaller(x: Array, y: Array) -> Array:
    return namespace(x, y).minimum(x, y)


def _binary_exponent(x: Array) -> Array:
    xp = namespace(x)
    return xp.frexp(x)[1].astype(xp.float64)


def _times_power(x: Array, n: Array) -> Array:
    xp = namespace(x, n)
    return xp.ldexp(xp.asarray(x, dtype=xp.float64), xp.asarray(n).astype(xp.int32))


def _flat(values: Any) -> tuple[Any, ...]:
    return tuple(x for part in values for x in _flat(part)) if isinstance(values, tuple) else (values,)


def _shaped(numbers: Iterator[Any], like: Any) -> Any:
    """Return the next numbers as a nest of tuples and records like another."""
    if not isinstance(like, tuple):
        return next(numbers)
    parts = [_shaped(numbers, part) for part in like]
    return type(like)(*parts) if hasattr(like, "_fields") else tuple(parts)


def _choose(condition: Array, when_true: Callable[[Any], Any], when_false: Callable[[Any], Any], values: Any) -> Any:
    shape: list[Any] = []

    def flat(function: Callable[[Any], Any]) -> Callable[..., tuple[Any, ...]]:
        def computed(*numbers: Array) -> tuple[Any, ...]:
            shape[:] = [function(_shaped(iter(numbers), values))]
            return _flat(shape[0])

        return computed

    chosen = arrays.choose(condition, flat(when_true), flat(when_false), *_flat(values))
    return _shaped(iter(chosen), shape[0])


def _iterate(count: int, step: Callable[[Any], Any], state: Any) -> Any:
    return arrays.iterate(count, step, state, like=next((x for x in _flat(state) if is_jax(x)), None))


def _iterate_until(
    step: Callable[[Any], Any], finished: Callable[[Any], Array], state: Any, at_once: int, most: int
) -> Any:
    flat_step = lambda *numbers: _flat(step(_shaped(iter(numbers), state)))  # noqa: E731
    flat_finished = lambda *numbers: finished(_shaped(iter(numbers), state))  # noqa: E731
    return _shaped(iter(arrays.iterate_until(flat_step, flat_finished, _flat(state), at_once, most)), state)


def _of(name: str) -> Callable[..., Array]:
    return lambda *operands: getattr(namespace(*operands), name)(*operands)


def _of_libm(single: Callable[..., float], name: str) -> Callable[..., Array]:
    """Return a function that takes NumPy's arrays by that of single numbers, JAX's by the one of this name.

    All else is rounded alike everywhere. NumPy's functions have other last bits, which then depended on who computes.
    """

    def computed(*operands: Array) -> Array:
        own = getattr(namespace(*operands), name)
        if is_jax(*operands):
            return own(*operands)
        whole = np.broadcast_arrays(*operands)
        rows = [x.ravel().tolist() for x in whole]
        try:
            found = np.fromiter(map(single, *rows), float, len(rows[0]))
        except (ArithmeticError, ValueError):  # beyond doubles, of one number at least
            found = np.array([_by_either(single, own, numbers) for numbers in zip(*rows, strict=True)], float)
        return found.reshape(whole[0].shape)[()]

    return computed


def _by_either(single: Callable[..., float], own: Callable[..., Array], numbers: tuple[float, ...]) -> Any:
    try:
        return single(*numbers)
    except (ArithmeticError, ValueError):
        return own(*map(np.float64, numbers))


def _sine_cosine(x: Array) -> tuple[Array, Array]:
    """Return ``kernel_arithmetic.sine_cosine``, to the same bits for NumPy."""
    if is_jax(x):
        return circular.sine_cosine_turns(x)
    quarter = np.rint(4.0 * x)
    r = x - 0.25 * quarter
    z = r * r
    s, c = r * _horner(kernel_arithmetic.SINE, z), _horner(kernel_arithmetic.COSINE, z)
    n = quarter - 4.0 * np.floor(0.25 * quarter)
    odd = (n == 1.0) | (n == 3.0)
    a, b = np.where(odd, c, s), np.where(odd, s, c)
    return np.where(n >= 2.0, -a, a), np.where((n == 1.0) | (n == 2.0), -b, b)


def _horner(coefficients: Sequence[float], z: Array) -> Array:
    *others, last = coefficients
    value = z * last
    for a in reversed(others[1:]):
        value += a
        value *= z
    return value + others[0]


def _constant(value: dd.DoubleDouble, like: Array) -> dd.DoubleDouble:
    return value[0] + 0.0 * like, value[1] + 0.0 * like


exponential = _of_libm(math.exp, "exp")
FOR_ARRAYS: dict[str, Any] = {
    "two_product": dd.two_product, "two_sum": dd.two_sum, "fast_two_sum": dd.fast_two_sum, "add": dd.add,
    "subtract": dd.subtract, "multiply": dd.multiply, "multiply_float": dd.multiply_float, "square": dd.square,
    "scale": dd.scale, "divide": dd.divide, "root": dd.sqrt, "root_or_zero": dd.sqrt,
    "choice": dd.where,
    "constant": _constant, "two_square": dd.two_square, "halves": split_halves,
    "where": _where, "larger": _larger, "nearest": nearest, "whole": nearest, "phase": circular.reduced_phase,
    "sine_cosine": _sine_cosine,
    "square_root": _of("sqrt"), "exponential": exponential, "floor": _of("floor"),
    "arctangent": _of_libm(math.atan, "atan"), "angle_of": _of_libm(math.atan2, "atan2"),
    "logarithm": _of_libm(math.log, "log"), "hyperbolic_sine": _of_libm(math.sinh, "sinh"),
    "area_of_sine": _of_libm(math.asinh, "asinh"), "smaller": _smaller, "negation": lambda condition: ~condition,
    "as_sum": tuple, "join": lambda x, y: (*x, *y), "negated": lambda x: tuple(-term for term in x),
    "multiply_terms": dd.multiply_terms, "compress": dd.compress, "distil": dd.distil,
    "binary_exponent": _binary_exponent, "times_power": _times_power,
    "choose": _choose, "iterate": _iterate, "iterate_until": _iterate_until,
}  # fmt: skip
