"""Formulas for arrays of NumPy or JAX, elementwise with broadcasting, in place of single numbers."""

from __future__ import annotations

from collections.abc import Callable
from types import ModuleType, SimpleNamespace
from typing import Any

from polhode._base.arrays import namespace, nearest, split_halves
from polhode._base.compiled.copying import copy_modules
from polhode.exact import _formulas as formulas
from polhode.exact import _kernel_arithmetic as kernel_arithmetic
from polhode.special import _circular as circular
from polhode.special import _doubledouble as dd
from polhode.types import Array


def for_arrays(*modules: ModuleType, **replaced: Callable[..., Any]) -> Any:
    """Return the last module's names, with functions of arrays.

    Args:
        modules: of formulas, with those they need; these of both motions come by themselves.
        replaced: functions in place of formulas that do not hold for all that arrays are made of.
    """
    parts = kernel_arithmetic, formulas, *modules
    spaces = copy_modules(parts, lambda function, _: function, FOR_ARRAYS | replaced)
    return SimpleNamespace(**spaces[modules[-1].__name__])


def _where(condition: Array, x: Array, y: Array) -> Array:
    return namespace(condition, x, y).where(condition, x, y)


def _larger(x: Array, y: Array) -> Array:
    return namespace(x, y).maximum(x, y)


def _constant(value: dd.DoubleDouble, like: Array) -> dd.DoubleDouble:
    return value[0] + 0.0 * like, value[1] + 0.0 * like


FOR_ARRAYS: dict[str, Any] = {
    "two_product": dd.two_product, "two_sum": dd.two_sum, "fast_two_sum": dd.fast_two_sum, "add": dd.add,
    "subtract": dd.subtract, "multiply": dd.multiply, "multiply_float": dd.multiply_float, "square": dd.square,
    "scale": dd.scale, "divide": dd.divide, "root": dd.sqrt, "root_or_zero": dd.sqrt,
    "choice": dd.where,
    "constant": _constant, "two_square": dd.two_square, "halves": split_halves,
    "where": _where, "larger": _larger, "nearest": nearest, "whole": nearest, "phase": circular.reduced_phase,
    "sine_cosine": circular.sine_cosine_turns,
    "square_root": lambda x: namespace(x).sqrt(x), "exponential": lambda x: namespace(x).exp(x),
    "floor": lambda x: namespace(x).floor(x),
}  # fmt: skip
