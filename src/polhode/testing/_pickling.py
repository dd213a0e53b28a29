"""Which part of an object cannot be pickled, as a sentence."""

from __future__ import annotations

import pickle
from collections.abc import Iterator
from typing import Any

from polhode.errors import shown

PROTOCOL = 4
REMEDY = (
    "Functions and classes are loaded again by their names in a module: define them at the top of one, and leave "
    "out what is open or can be made again by __getstate__"
)


def find_what_is_not_pickled(name: str, value: Any) -> str | None:
    """Return a sentence on the part of an object that cannot be pickled, with the remedy; None where all can.

    >>> find_what_is_not_pickled("report", {"title": "T-handle", "moments": [1.0, 2.0]})
    >>> find_what_is_not_pickled("report", {"title": "T-handle", "draw": [lambda t: t]}).split(",")[0]
    "`report['draw'][0]`"
    """
    error = _error_of(value)
    if error is None:
        return None
    visited: set[int] = set()
    while id(value) not in visited:
        visited.add(id(value))
        for part, inner in _parts(value):
            if (inner_error := _error_of(inner)) is not None:
                name, value, error = f"{name}{part}", inner, inner_error
                break
    return f"`{name}`, {shown(value)}, cannot: {str(error).rstrip('.')}. {REMEDY}"


def _error_of(value: Any) -> Exception | None:
    try:
        pickle.dumps(value, PROTOCOL)
    except Exception as error:  # PicklingError, TypeError, AttributeError, and those of any __getstate__
        return error
    return None


def _parts(value: Any) -> Iterator[tuple[str, Any]]:
    """Yield the parts of an object that are pickled, each with its path: an attribute, an index or a key."""
    if isinstance(value, dict):
        yield from ((f"[{shown(key)}]", inner) for key, inner in value.items())
        return
    fields = getattr(value, "_fields", None)
    if isinstance(value, tuple) and fields is not None:
        yield from ((f".{field}", inner) for field, inner in zip(fields, value, strict=False))
        return
    if isinstance(value, list | tuple):
        yield from ((f"[{k}]", inner) for k, inner in enumerate(value))
        return
    try:
        reduced = value.__reduce_ex__(PROTOCOL)
    except Exception:  # the object itself refuses
        return
    if isinstance(reduced, tuple):
        arguments, state = reduced[1], reduced[2] if len(reduced) > 2 else None
        states = state if isinstance(state, tuple) else (state,)  # of a class with slots: a dictionary of them too
        for attributes in states:
            if isinstance(attributes, dict):
                yield from ((f".{key}", inner) for key, inner in attributes.items())
        yield from ((f" (argument {k} of what makes it again)", inner) for k, inner in enumerate(arguments))
