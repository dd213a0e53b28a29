"""Eight doubles as one value, in plain Python; ``compiled_vectors`` has them for Numba."""

from __future__ import annotations

from typing import Any

from polhode.types import Array, Float64, Integer

WIDTH = 8


def load(array: Float64[Array, " many"], index: Any) -> Float64[Array, "8"]:
    return array[index : index + WIDTH]


def store(array: Float64[Array, " many"], index: Any, value: Float64[Array, "8"]) -> None:
    array[index : index + WIDTH] = value


def gather(
    array: Float64[Array, " many"], places: Integer[Array, " places"], first: Any, base: Any
) -> Float64[Array, "8"]:
    return array[base + places[first : first + WIDTH]]
