"""Finds indices beyond their axis in a jaxpr, for which JAX would take the nearest element, or none."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from typing import Any, NamedTuple

import numpy as np

from polhode._base.arrays.by_numpy import BY_NUMPY, by_numbers
from polhode._base.arrays.namespaces import is_traced
from polhode._base.jaxprs import CALLED as INNER
from polhode._base.jaxprs import split_scan
from polhode.errors import InvalidInput

INDICES = ("i", "u", "b")  # kinds of numbers that indices are made of
Known = dict[Any, np.ndarray]


class IndexLimits(NamedTuple):
    """Numbers that decide which indices are followed."""

    max_entries: int = 100_000  # of an array of indices, of a table of neighbours; larger ones take seconds
    max_rounds: int = 10_000  # of loops in one function, times the operations in them: about 50 ms


LIMITS = IndexLimits()


class Beyond(NamedTuple):
    """An index outside its axis."""

    element: int
    size: int


def refuse_beyond(what: str, closed: Any) -> None:
    """Refuse a jaxpr in which an index is beyond its axis.

    Args:
        what: its name, in messages.
        closed: the closed jaxpr.

    Raises:
        InvalidInput: naming the index and the size.
    """
    for beyond in _find(closed.jaxpr, _numbers(zip(closed.jaxpr.constvars, closed.consts, strict=True))):
        raise InvalidInput(
            f"{what} takes element {beyond.element} of an axis with {beyond.size}, which are {-beyond.size} to "
            f"{beyond.size - 1}: JAX would quietly take the nearest one, or none. Check the index, and the order of "
            "the components."
        )


def _numbers(pairs: Any) -> Known:
    """Return the values of variables that can be followed."""
    return {variable: np.asarray(value) for variable, value in pairs
            if value is not None and not is_traced(value) and _can_be_followed(variable.aval)}


def _find(jaxpr: Any, known: Known, left: list[int] | None = None) -> Iterator[Beyond]:
    """Yield indices beyond their axes; values that can be computed are added to ``known``.

    Args:
        jaxpr: of a function or a part of one.
        known: values of its variables.
        left: how many operations within loops may still be followed.
    """
    left = [LIMITS.max_rounds] if left is None else left
    for equation in jaxpr.eqns:
        values = [_value(x, known) for x in equation.invars]
        if look := LOOKS.get(equation.primitive.name):
            yield from look(equation, values)
        if equation.primitive.name == "scan":
            carried, beyond = _follow_scan(equation, values, left)
            yield from beyond
            known |= _numbers(zip(equation.outvars, carried, strict=False))
        elif inner := _inner(equation, values):
            for body, given in inner:
                results, beyond = _within(body, given, left)
                yield from beyond
                if len(inner) == 1 and len(results) == len(equation.outvars):
                    known |= _numbers(zip(equation.outvars, results, strict=True))
        elif equation.primitive.name in BY_NUMPY and all(x is not None for x in values) and _can_follow(equation):
            known |= _numbers(zip(equation.outvars, by_numbers(equation, values), strict=True))


def _within(body: Any, given: Sequence[Any], left: list[int]) -> tuple[list[Any], list[Beyond]]:
    """Return the known values of the results of a closed jaxpr, and the indices beyond their axes in it."""
    own = _numbers(zip(body.jaxpr.constvars, body.consts, strict=True))
    own |= _numbers(zip(body.jaxpr.invars, given, strict=True))
    beyond = list(_find(body.jaxpr, own, left))
    return [_value(x, own) for x in body.jaxpr.outvars], beyond


def _follow_scan(equation: Any, values: list[Any], left: list[int]) -> tuple[list[Any], list[Beyond]]:
    """Return the known values of a loop's last carry, and the indices beyond their axes in any of its rounds.

    Every round is followed where the loop carries known numbers; elsewhere all rounds are equal, and one is enough.
    """
    parameters, body = equation.params, equation.params["jaxpr"]
    fixed, carried = split_scan(parameters)
    constants, carry, rows = values[:fixed], values[fixed : fixed + carried], values[fixed + carried :]
    counts = any(x is not None for x in (*carry, *rows))
    order = range(parameters["length"])[:: -1 if parameters["reverse"] else 1]
    for k in order if counts else order[:1]:
        left[0] -= len(body.jaxpr.eqns)
        if left[0] < 0:
            carry, rows = [None] * carried, [None] * len(rows)
        now, beyond = _within(body, [*constants, *carry, *(None if row is None else row[k] for row in rows)], left)
        carry = now[:carried]
        if beyond or left[0] < 0:
            return [None] * carried, beyond
    return carry if counts else [None] * carried, []


def _value(variable: Any, known: Known) -> Any:
    if hasattr(variable, "val"):  # a literal
        return np.asarray(variable.val)
    return known.get(variable)


def _can_follow(equation: Any) -> bool:
    return all(_can_be_followed(x.aval) for x in equation.outvars)


def _can_be_followed(aval: Any) -> bool:
    kind = getattr(getattr(aval, "dtype", None), "kind", "")
    return kind in INDICES and math.prod(aval.shape) <= LIMITS.max_entries


def _inner(equation: Any, values: list[Any]) -> list[tuple[Any, list[Any]]]:
    """Return the functions within an operation, each with the known values of its arguments."""
    name, parameters = equation.primitive.name, equation.params
    if name == "cond":
        return [(body, values[1:]) for body in parameters["branches"]]
    if name == "while":
        test, step = parameters["cond_nconsts"], parameters["body_nconsts"]
        bodies = (("cond_jaxpr", values[:test]), ("body_jaxpr", values[test : test + step]))
        return [(parameters[key], [*fixed, *[None] * (len(parameters[key].jaxpr.invars) - len(fixed))])
                for key, fixed in bodies]
    for key in INNER:
        body = parameters.get(key)
        if body is not None:
            body = body if hasattr(body, "jaxpr") else _closed(body)
            same = len(body.jaxpr.invars) == len(values)
            return [(body, values if same else [None] * len(body.jaxpr.invars))]
    return []


def _closed(jaxpr: Any) -> Any:
    from polhode._base.jax_inner import ClosedJaxpr

    return ClosedJaxpr(jaxpr, ())


def _in_slices(equation: Any, values: list[Any]) -> Iterator[Beyond]:
    """Check ``dynamic_slice`` and ``dynamic_update_slice``, whose starts JAX moves into the range."""
    updates = equation.primitive.name == "dynamic_update_slice"
    starts = values[2 if updates else 1 :]
    whole = equation.invars[0].aval.shape
    sizes = equation.invars[1].aval.shape if updates else equation.params["slice_sizes"]
    for start, count, size in zip(starts, sizes, whole, strict=True):
        if start is not None and count:
            yield from _beyond(np.asarray(start), size - count, size)


def _in_gather(equation: Any, values: list[Any]) -> Iterator[Beyond]:
    """Check ``gather``: a user may have asked for clipped indices, or for a filling number.

    ``vmap`` makes one that clips of a slice that JAX moves into the range; there no axis is dropped, as a user's has.
    """
    mode, fill = _word(equation.params["mode"]), equation.params.get("fill_value")
    dropped = equation.params["dimension_numbers"].collapsed_slice_dims
    said = (mode == "CLIP" and len(dropped) > 0) or (mode == "FILL_OR_DROP" and fill is not None and not np.isnan(fill))
    if values[1] is None or said:
        return
    map_, sizes = equation.params["dimension_numbers"].start_index_map, equation.params["slice_sizes"]
    for k, axis in enumerate(map_):
        size = equation.invars[0].aval.shape[axis]
        if sizes[axis]:
            yield from _beyond(values[1][..., k], size - sizes[axis], size)


def _in_scatter(equation: Any, values: list[Any]) -> Iterator[Beyond]:
    """Check ``scatter``, which drops indices beyond an axis: part of a table may be meant to be dropped, not all."""
    if values[1] is None or _word(equation.params["mode"]) == "CLIP":
        return
    numbers = equation.params["dimension_numbers"]
    for k, axis in enumerate(numbers.scatter_dims_to_operand_dims):
        size, indices = equation.invars[0].aval.shape[axis], values[1][..., k]
        if axis in numbers.inserted_window_dims and indices.size and ((indices < 0) | (indices >= size)).all():
            yield from _beyond(indices, size - 1, size)


def _beyond(starts: np.ndarray, last: int, size: int) -> Iterator[Beyond]:
    wrong = starts[(starts < 0) | (starts > last)]
    if wrong.size:
        index = int(wrong.flat[0])
        yield Beyond(index - size if index < 0 else index, size)  # JAX has added the size to negative ones


def _word(mode: Any) -> str:
    return getattr(mode, "name", str(mode)).rpartition(".")[-1]


LOOKS: dict[str, Callable[[Any, list[Any]], Iterator[Beyond]]] = {
    "dynamic_slice": _in_slices,
    "dynamic_update_slice": _in_slices,
    "gather": _in_gather,
    **{name: _in_scatter for name in ("scatter", "scatter-add", "scatter_add", "scatter-mul", "scatter_mul",
                                      "scatter-min", "scatter_min", "scatter-max", "scatter_max")},
}  # fmt: skip
