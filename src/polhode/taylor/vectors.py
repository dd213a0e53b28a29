"""Arithmetic of a kernel on one copy, in plain Python; ``lanes`` has eight copies side by side.

``compiled_vectors`` has both for Numba. A kernel keeps all numbers in flat arrays of doubles, and sees them through
``vectors``: of one copy as they are, of eight copies each number as a vector of eight.
"""

from __future__ import annotations

import ctypes
import math
from functools import cache
from typing import Any

import numpy as np

from polhode.types import Array, Float64, Integer

WIDTH = 8  # doubles in a vector
LANES = 1  # copies side by side


def borrow(x: Any) -> Any:
    """Return arrays, or tuples of them, that somebody else keeps: Numba counts no references to them."""
    return x


_code = cache(ctypes.CFUNCTYPE(None, *[ctypes.c_void_p] * 4, ctypes.c_int64, ctypes.c_void_p))


def run_code(
    address: int, flat: Float64[np.ndarray, " many"], a: Float64[np.ndarray, " factors"],
    b: Float64[np.ndarray, " factors"], number: Float64[np.ndarray, " numbers"], order: int,
    units: Float64[np.ndarray, " lanes"],
) -> None:
    """Run the code of ``straight_line`` at an address."""
    _code(address)(flat.ctypes.data, a.ctypes.data, b.ctypes.data, number.ctypes.data, order, units.ctypes.data)


def vectors(array: Float64[Array, " many"]) -> Float64[Array, " many"]:
    """Return numbers in the type that the kernel computes with."""
    return array


def spread(x: Any) -> Any:
    """Return one number for all copies."""
    return x


def where_less(x: Any, y: Any, yes: Any, no: Any) -> Any:
    """Return the first value where x < y, the other elsewhere."""
    return yes if x < y else no


def raise_power(x: Any, exponent: Any) -> Any:
    return x**exponent


def exponential(x: Any) -> Any:
    return np.exp(x) if x > 700.0 else math.exp(x)  # math's raises an error where it overflows


def logarithm(x: Any) -> Any:
    return math.log(x) if x > 0.0 else np.log(x)


def exponential_minus_one(x: Any) -> Any:
    return np.expm1(x) if x > 700.0 else math.expm1(x)


def logarithm_of_one_plus(x: Any) -> Any:
    return math.log1p(x) if x > -1.0 else np.log1p(x)


def hyperbolic_tangent(x: Any) -> Any:
    return math.tanh(x)


def sine(x: Any) -> Any:
    return math.sin(x) if abs(x) < np.inf else np.nan


def cosine(x: Any) -> Any:
    return math.cos(x) if abs(x) < np.inf else np.nan


def repeat(x: Any) -> Float64[Array, "8"]:
    """Return a vector of equal numbers."""
    return np.full(WIDTH, float(x))


def load(array: Float64[Array, " many"], index: Any) -> Float64[Array, "8"]:
    return array[index : index + WIDTH]


def store(array: Float64[Array, " many"], index: Any, value: Float64[Array, "8"]) -> None:
    array[index : index + WIDTH] = value


def gather(
    array: Float64[Array, " many"], places: Integer[Array, " places"], first: Any, base: Any
) -> Float64[Array, "8"]:
    return array[base + places[first : first + WIDTH]]
