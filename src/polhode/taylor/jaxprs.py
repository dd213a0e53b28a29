"""Properties of a jaxpr, JAX's list of the operations of a function, needed before it is evaluated."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import jax
import numpy as np

from polhode._base.jaxprs import Entry, Listing, Scan, numbers_within


def write_jaxpr(function: Callable[..., Any], *shapes: tuple[int, ...]) -> Any:
    """Return the jaxpr of a function of real arrays of given shapes."""
    return jax.make_jaxpr(function)(*[jax.ShapeDtypeStruct(shape, float) for shape in shapes])


def numbers_in(closed: Any) -> list[float]:
    """Return the real numbers that a jaxpr contains, each once, but those by which doubles are multiplied exactly."""
    numbers: set[float] = set()
    for value in numbers_within(closed):
        if np.issubdtype(np.result_type(value), np.inexact):
            flat: Any = np.ravel(np.asarray(value))
            numbers.update(x for part in (flat.real, flat.imag) for x in part.tolist() if not is_power_of_two(x))
    return sorted(numbers)


def is_power_of_two(x: float) -> bool:
    """Return whether a number is zero, infinite or none, or by its size a power of two."""
    return abs(math.frexp(x)[0]) == 0.5 or x == 0.0 or not math.isfinite(x)


def operations_on(closed: Any, moving: tuple[int, ...]) -> int:
    """Return about how many operations on single numbers a jaxpr makes of those arguments that move."""
    listing = Listing(closed)
    return _count(listing, [k in moving for k in range(len(listing.inputs))])


def _count(listing: Listing, moving: list[bool]) -> int:
    counts: list[int] = []

    def mark(entry: Entry, moves: list[bool]) -> list[bool]:
        does = any(moves)
        if does and isinstance(entry.within, Scan):
            counts.append(len(entry.within.order) * _count(entry.within.body, moves))
        elif does:
            counts.append(_terms(entry) * sum(math.prod(kind.shape) for kind in entry.made))
        return [does] * len(entry.results)

    listing.run(moving, mark, lambda number: False)
    return sum(counts)


def _terms(entry: Entry) -> int:
    """Return how many terms a number of the result of an operation has: a product of matrices has a row of them."""
    if entry.name != "dot_general":
        return 1
    shape = entry.given[0].shape
    return math.prod(shape[k] for k in entry.parameters["dimension_numbers"][0][0])
