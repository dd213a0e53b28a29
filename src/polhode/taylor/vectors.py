"""Eight doubles as one value, in plain Python; ``compiled_vectors`` has them for Numba."""

from __future__ import annotations

from typing import Any

from polhode.types import Array

WIDTH = 8


def load(array: Array, index: Any) -> Array:
    return array[index : index + WIDTH]


def store(array: Array, index: Any, value: Array) -> None:
    array[index : index + WIDTH] = value


def gather(array: Array, places: Array, first: Any, base: Any) -> Array:
    return array[base + places[first : first + WIDTH]]
