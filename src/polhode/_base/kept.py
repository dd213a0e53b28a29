"""What follows from one object alone, kept while it lives: asking so costs less than comparing it by its contents."""

from __future__ import annotations

import weakref
from collections.abc import Callable, Hashable
from functools import wraps
from typing import Any, NamedTuple, TypeVar

import numpy as np

Function = TypeVar("Function", bound=Callable[..., Any])


class KeptLimits(NamedTuple):
    """How much is kept."""

    max_objects: int = 256  # as what is kept may hold the object itself, which then lives as long
    max_answers: int = 256  # of one object, of which all are dropped when there are more


LIMITS = KeptLimits()
_kept: dict[int, tuple[weakref.ref[Any], dict[Any, Any]]] = {}


def kept_of_object(function: Function) -> Function:
    """Return a function of an object and hashable arguments that is computed once for each, where neither changes.

    Of an object with arrays of NumPy that may be written to it is computed each time.
    """

    @wraps(function)
    def ask(thing: Any, *arguments: Any) -> Any:
        known = find_kept(thing)
        if known is None:
            return function(thing, *arguments)
        key = function, arguments
        try:
            return known[key]
        except KeyError:
            value = function(thing, *arguments)
        if len(known) >= LIMITS.max_answers:
            known.clear()
        known[key] = value
        return value

    return ask  # type: ignore[return-value]


def is_kept(thing: Any) -> bool:
    """Whether something is kept of an object, which then holds known numbers alone."""
    found = _kept.get(id(thing))
    return found is not None and found[0]() is thing


def find_kept(thing: Any) -> dict[Any, Any] | None:
    """Return what is kept of an object, to be added to; None of one that may change, or whose numbers are not known."""
    place = id(thing)
    found = _kept.get(place)
    if found is not None and found[0]() is thing:
        return found[1]
    if not _stays(thing):
        return None

    def forget(gone: weakref.ref[Any], kept: dict[int, Any] = _kept) -> None:  # also when Python ends
        if place in kept and kept[place][0] is gone:
            del kept[place]

    while len(_kept) >= LIMITS.max_objects:
        _kept.pop(next(iter(list(_kept))), None)
    _kept[place] = weakref.ref(thing, forget), {}
    return _kept[place][1]


def _stays(value: Any) -> bool:
    """Whether all numbers within are known, and none can be written to; what can be hashed is taken not to change."""
    import equinox as eqx
    import jax

    from polhode._base.jax_inner import Tracer

    if isinstance(value, jax.Array | Tracer):
        return not isinstance(value, Tracer)
    if isinstance(value, np.ndarray):
        return not value.flags.writeable
    if isinstance(value, tuple):
        return all(map(_stays, value))
    if isinstance(value, dict | list):  # an empty one is a default
        return not value
    if isinstance(value, eqx.Module):
        return all(map(_stays, vars(value).values()))
    return isinstance(value, Hashable)
