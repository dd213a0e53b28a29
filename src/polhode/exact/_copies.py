"""Copies of modules of formulas, which call each other and take other words: those of Numba, or of arrays."""

from __future__ import annotations

import inspect
from collections.abc import Callable, Iterable, Mapping
from types import FunctionType, ModuleType, SimpleNamespace
from typing import Any

from polhode.arrays import namespace, nearest, split_halves
from polhode.exact import _formulas as formulas
from polhode.exact import _kernel_arithmetic as kernel_arithmetic
from polhode.special import _circular as circular
from polhode.special import _doubledouble as dd
from polhode.types import Array

Space = dict[str, Any]


def copy_modules(
    modules: Iterable[ModuleType], words: Mapping[str, Any], make: Callable[[FunctionType, str], Any]
) -> dict[str, Space]:
    """Return the names of copies of modules, by the names of the modules.

    Args:
        modules: with functions that are marked as parts of a kernel.
        words: what stands in place of such functions, by their names.
        make: function with the names of its copy, and its mark → what stands in place of any other.
    """
    spaces: dict[str, Space] = {module.__name__: dict(vars(module)) for module in modules}
    copies, named, names = dict[Any, Any](), Space(), dict[Any, str]()
    for place, space in spaces.items():
        for name, value in tuple(space.items()):
            plain = inspect.unwrap(value) if callable(value) else value  # tests wrap functions to check annotations
            mark = getattr(plain, "kernel_mark", None)
            if mark is None or plain.__module__ != place:
                continue
            if mark == "given":
                names[plain] = name
            else:
                named[name] = words[name] if name in words else make(FunctionType(plain.__code__, space, name), mark)
                copies[plain] = named[name]
    copies |= {plain: named[name] for plain, name in names.items()}
    for space in spaces.values():
        for name, value in space.items():
            plain = inspect.unwrap(value) if isinstance(value, FunctionType) else None
            if plain in copies:
                space[name] = copies[plain]
    return spaces


def for_python(modules: Iterable[ModuleType]) -> dict[str, Space]:
    """Return the names of modules of one motion, whose loops take its formulas."""
    return copy_modules(modules, {}, lambda function, _: function)


def for_arrays(*modules: ModuleType, **words: Callable[..., Any]) -> Any:
    """Return the last module's names, with functions of arrays of NumPy or JAX, elementwise with broadcasting.

    Args:
        modules: of formulas, with those they need; these of both motions come by themselves.
        words: functions in place of formulas that do not hold for all that arrays are made of.
    """
    spaces = copy_modules((kernel_arithmetic, formulas, *modules), WORDS | words, lambda function, _: function)
    return SimpleNamespace(**spaces[modules[-1].__name__])


# ---------------------------------------------------------------------- what takes the place of Python's words


def _where(condition: Array, x: Array, y: Array) -> Array:
    return namespace(condition, x, y).where(condition, x, y)


def _larger(x: Array, y: Array) -> Array:
    return namespace(x, y).maximum(x, y)


def _constant(value: dd.DoubleDouble, like: Array) -> dd.DoubleDouble:
    return value[0] + 0.0 * like, value[1] + 0.0 * like


def _phase(rate: circular.SplitRate, high: Array, low: Array) -> tuple[Array, Array, Array]:
    return circular.reduced_phase(rate, (high, low))


WORDS: dict[str, Any] = {
    "two_product": dd.two_product, "two_sum": dd.two_sum, "fast_two_sum": dd.fast_two_sum, "add": dd.add,
    "subtract": dd.subtract, "multiply": dd.multiply, "multiply_float": dd.multiply_float, "square": dd.square,
    "scale": dd.scale, "divide": dd.divide, "root": dd.sqrt, "root_or_zero": dd.sqrt,
    "choice": dd.where,
    "constant": _constant, "two_square": dd.two_square, "halves": split_halves,
    "where": _where, "larger": _larger, "nearest": nearest, "whole": nearest, "phase": _phase,
    "sine_cosine": circular.sine_cosine_turns,
    "square_root": lambda x: namespace(x).sqrt(x), "exponential": lambda x: namespace(x).exp(x),
    "floor": lambda x: namespace(x).floor(x),
}  # fmt: skip
