"""Finds indices beyond their axis in a jaxpr, for which JAX would take the nearest element, or none."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np

from polhode._base.arrays.by_numpy import BY_NUMPY, by_numbers
from polhode._base.arrays.namespaces import is_traced
from polhode._base.jaxprs import Branches, Entry, Listing, Scan, While
from polhode.errors import InvalidInput

INDICES = ("i", "u", "b")  # kinds of numbers that indices are made of


class IndexLimits(NamedTuple):
    """Numbers that decide which indices are followed."""

    max_entries: int = 100_000  # of an array of indices, of a table of neighbours; larger ones take seconds
    max_rounds: int = 10_000  # of loops in one function, times the operations in them: about 50 ms


LIMITS = IndexLimits()


class Beyond(Exception):
    """An index outside its axis."""

    def __init__(self, element: int, size: int) -> None:
        super().__init__(element, size)
        self.element, self.size = element, size


def refuse_beyond(what: str, closed: Any) -> None:
    """Refuse a jaxpr in which an index is beyond its axis.

    Args:
        what: its name, in messages.
        closed: the closed jaxpr.

    Raises:
        InvalidInput: naming the index and the size.
    """
    listing = Listing(closed)
    try:
        _follow(listing, [None] * len(listing.inputs), [LIMITS.max_rounds])
    except Beyond as beyond:
        raise InvalidInput(
            f"{what} takes element {beyond.element} of an axis with {beyond.size}, which are {-beyond.size} to "
            f"{beyond.size - 1}: JAX would quietly take the nearest one, or none. Check the index, and the order of "
            "the components."
        ) from None


def _follow(listing: Listing, given: list[Any], left: list[int]) -> list[Any]:
    """Return the outputs that can be computed, None in place of others.

    Args:
        listing: of a function or a part of one.
        given: known values of its inputs, None in place of others.
        left: how many operations within loops may still be followed.

    Raises:
        Beyond: for an index beyond its axis.
    """
    return listing.run(given, lambda entry, values: _apply(entry, values, left), _read)


def _read(number: Any) -> Any:
    """Return a number in a function, or an array that it encloses, if it can be followed."""
    kind = getattr(getattr(number, "dtype", np.dtype(float)), "kind", "")  # literals may be plain numbers
    is_single = np.ndim(number) == 0 and kind in (*INDICES, "f", "c")
    return np.asarray(number) if (is_single or _can_be_followed(number)) and not is_traced(number) else None


def _apply(entry: Entry, values: list[Any], left: list[int]) -> list[Any]:
    if look := LOOKS.get(entry.name):
        look(entry, values)
    within, unknown = entry.within, [None] * len(entry.results)
    if isinstance(within, Scan):
        return _follow_scan(within, values, left) + unknown[within.carried :]
    if isinstance(within, Branches):
        results = [_follow(branch, values[1:], left) for branch in within.each]
        return results[0] if len(results) == 1 else unknown
    if isinstance(within, While):
        of_condition, of_body, _ = within.split(values)
        _follow(within.condition, [*of_condition, *unknown], left)
        _follow(within.body, [*of_body, *unknown], left)
    elif entry.name in BY_NUMPY and all(x is not None for x in values) and all(map(_can_be_followed, entry.made)):
        return by_numbers(entry, values)
    return unknown


def _follow_scan(loop: Scan, values: list[Any], left: list[int]) -> list[Any]:
    """Return the known values of a loop's last carry.

    Every round is followed where the loop carries known numbers; elsewhere all rounds are equal, and one is enough.
    """
    constants, carry, rows = loop.split(values)
    counts, unknown = any(x is not None for x in (*carry, *rows)), [None] * loop.carried
    for k in loop.order if counts else loop.order[:1]:
        left[0] -= len(loop.body.entries)
        if left[0] < 0:
            carry, rows = unknown, [None] * len(rows)
        now = _follow(loop.body, [*constants, *carry, *(None if row is None else row[k] for row in rows)], left)
        carry = now[: loop.carried]
        if left[0] < 0:
            return unknown
    return carry if counts else unknown


def _can_be_followed(kind: Any) -> bool:
    """Return whether arrays of a shape and a type, or an array itself, are indices and not too many."""
    return getattr(getattr(kind, "dtype", None), "kind", "") in INDICES and math.prod(kind.shape) <= LIMITS.max_entries


def _in_slices(entry: Entry, values: list[Any]) -> None:
    """Check ``dynamic_slice`` and ``dynamic_update_slice``, whose starts JAX moves into the range."""
    updates = entry.name == "dynamic_update_slice"
    starts = values[2 if updates else 1 :]
    whole = entry.given[0].shape
    sizes = entry.given[1].shape if updates else entry.parameters["slice_sizes"]
    for start, count, size in zip(starts, sizes, whole, strict=True):
        if start is not None and count:
            _check(np.asarray(start), size - count, size)


def _in_gather(entry: Entry, values: list[Any]) -> None:
    """Check ``gather``: a user may have asked for clipped indices, or for a filling number.

    ``vmap`` makes one that clips of a slice that JAX moves into the range; there no axis is dropped, as a user's has.
    """
    mode, fill = _word(entry.parameters["mode"]), entry.parameters.get("fill_value")
    dropped = entry.parameters["dimension_numbers"].collapsed_slice_dims
    said = (mode == "CLIP" and len(dropped) > 0) or (mode == "FILL_OR_DROP" and fill is not None and not np.isnan(fill))
    if values[1] is None or said:
        return
    map_, sizes = entry.parameters["dimension_numbers"].start_index_map, entry.parameters["slice_sizes"]
    for k, axis in enumerate(map_):
        size = entry.given[0].shape[axis]
        if sizes[axis]:
            _check(values[1][..., k], size - sizes[axis], size)


def _in_scatter(entry: Entry, values: list[Any]) -> None:
    """Check ``scatter``, which drops indices beyond an axis: part of a table may be meant to be dropped, not all."""
    if values[1] is None or _word(entry.parameters["mode"]) == "CLIP":
        return
    numbers = entry.parameters["dimension_numbers"]
    for k, axis in enumerate(numbers.scatter_dims_to_operand_dims):
        size, indices = entry.given[0].shape[axis], values[1][..., k]
        if axis in numbers.inserted_window_dims and indices.size and ((indices < 0) | (indices >= size)).all():
            _check(indices, size - 1, size)


def _check(starts: np.ndarray, last: int, size: int) -> None:
    wrong = starts[(starts < 0) | (starts > last)]
    if wrong.size:
        index = int(wrong.flat[0])
        raise Beyond(index - size if index < 0 else index, size)  # JAX has added the size to negative ones


def _word(mode: Any) -> str:
    return getattr(mode, "name", str(mode)).rpartition(".")[-1]


LOOKS: dict[str, Callable[[Entry, list[Any]], None]] = {
    "dynamic_slice": _in_slices,
    "dynamic_update_slice": _in_slices,
    "gather": _in_gather,
    **{name: _in_scatter for name in ("scatter", "scatter-add", "scatter_add", "scatter-mul", "scatter_mul",
                                      "scatter-min", "scatter_min", "scatter-max", "scatter_max")},
}  # fmt: skip
