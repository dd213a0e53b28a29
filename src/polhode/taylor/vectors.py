"""Eight doubles as one value: Numba's where it is installed, else arrays of NumPy."""

from __future__ import annotations

from typing import Any

from polhode.taylor.compiled_vectors import WIDTH, vector_operations
from polhode.types import Array


def _load(array: Array, index: Any) -> Array:
    return array[index : index + WIDTH]


def _store(array: Array, index: Any, value: Array) -> None:
    array[index : index + WIDTH] = value


def _gather(array: Array, places: Array, first: Any, base: Any) -> Array:
    return array[base + places[first : first + WIDTH]]


load: Any
store: Any
gather: Any
try:
    load, store, gather = vector_operations()
except ImportError:
    load, store, gather = _load, _store, _gather
