"""How records of formulas lie in a store: their numbers one below the other, by the annotations of their fields."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache
from itertools import accumulate
from typing import Any, get_args, get_type_hints

from polhode.exact._kernel_arithmetic import BLOCK, record


@cache
def leaves(kind: Any) -> Any:
    """Return ``float`` or ``bool``, or for a tuple its fields: what they consist of, and the class of a record."""
    if kind in (float, bool):
        return kind
    fields = get_type_hints(kind).values() if hasattr(kind, "_fields") else get_args(kind)
    return tuple((leaves(field), field if hasattr(field, "_fields") else None) for field in fields)


def load(rows: Any, i: int, kind: Any) -> Any:
    """Return the record whose numbers stand in rows of a store, as ``put_record`` stores it."""
    return _built(leaves(kind), kind, iter(record(rows, i, size_of(kind))))


def _built(part: Any, kind: Any, numbers: Iterator[float]) -> Any:
    if not isinstance(part, tuple):
        return next(numbers) != 0.0 if part is bool else next(numbers)
    parts = [_built(inner, of, numbers) for inner, of in part]
    return kind(*parts) if kind is not None and hasattr(kind, "_fields") else tuple(parts)


def size_of(kind: Any) -> int:
    """Return how many numbers a record has."""
    return _count(leaves(kind))


def _count(part: Any) -> int:
    return sum(_count(inner) for inner, _ in part) if isinstance(part, tuple) else 1


def rows_of(*kinds: Any) -> Iterator[int]:
    """Yield where records begin that follow each other in a store, and where the last one ends."""
    return accumulate((BLOCK * size_of(kind) for kind in kinds), initial=0)
