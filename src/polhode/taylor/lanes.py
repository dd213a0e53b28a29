"""Arithmetic of a kernel on eight copies side by side, in plain Python; see ``vectors``."""

from __future__ import annotations

from typing import Any

import numpy as np

from polhode.taylor import vectors as one
from polhode.types import Array, Float64

LANES = one.WIDTH


def borrow(x: Any) -> Any:
    return x


def run_code(*arguments: Any) -> None:
    one.run_code(*arguments)


def vectors(array: Float64[Array, " many"]) -> Float64[Array, "numbers 8"]:
    return array.reshape(-1, LANES)


def spread(x: Any) -> Float64[Array, "8"]:
    return np.full(LANES, float(x))


def where_less(x: Any, y: Any, yes: Any, no: Any) -> Float64[Array, "8"]:
    return np.where(x < y, yes, no)


def raise_power(x: Any, exponent: Any) -> Float64[Array, "8"]:
    return np.array([one.raise_power(value, exponent) for value in x])


def exponential(x: Any) -> Float64[Array, "8"]:
    return np.array([one.exponential(value) for value in x])


def logarithm(x: Any) -> Float64[Array, "8"]:
    return np.array([one.logarithm(value) for value in x])


def exponential_minus_one(x: Any) -> Float64[Array, "8"]:
    return np.array([one.exponential_minus_one(value) for value in x])


def logarithm_of_one_plus(x: Any) -> Float64[Array, "8"]:
    return np.array([one.logarithm_of_one_plus(value) for value in x])


def hyperbolic_tangent(x: Any) -> Float64[Array, "8"]:
    return np.array([one.hyperbolic_tangent(value) for value in x])


def sine(x: Any) -> Float64[Array, "8"]:
    return np.array([one.sine(value) for value in x])


def cosine(x: Any) -> Float64[Array, "8"]:
    return np.array([one.cosine(value) for value in x])
