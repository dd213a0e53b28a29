"""Which kinds there are: the folders next to this file, and those of other packages."""

from __future__ import annotations

import contextlib
import pkgutil
from functools import cache
from importlib import import_module
from importlib.metadata import EntryPoint, entry_points
from pathlib import Path
from typing import Any

from polhode.errors import InvalidInput, PolhodeError
from polhode.kinds.base import AbstractKind

GROUP = "polhode.kinds"
HOME = Path(__file__).parent
FREE_BODY = "free-body"  # of a spec without [system]


@cache
def _folders() -> dict[str, str]:
    """Return module by kind of what this package has."""
    found = (module.name for module in pkgutil.iter_modules([str(HOME)]) if module.ispkg)
    return {folder.replace("_", "-"): f"{__package__}.{folder}" for folder in found}


@cache
def _others() -> dict[str, EntryPoint]:
    return {point.name: point for point in entry_points(group=GROUP)}


def kind_names() -> list[str]:
    """Return the names of all kinds; none of them is imported."""
    return sorted({*_folders(), *_others()})


def find_kind(name: str) -> AbstractKind | None:
    """Return a kind by name, None where there is none; it alone is imported.

    Raises:
        InvalidInput: for a kind of another package that cannot be imported, or is not a kind.
    """
    if name in _folders():
        return import_module(_folders()[name]).KIND
    if name not in _others():
        return None
    point = _others()[name]
    try:
        found = point.load()
    except Exception as error:
        raise InvalidInput(
            f"the kind {name} of another package, {point.value}, cannot be imported: {error}. Update or remove it."
        ) from error
    if not isinstance(found, AbstractKind):
        raise InvalidInput(f"the kind {name} of another package, {point.value}, is not an AbstractKind. Update it.")
    return found


def known_figures() -> set[str]:
    """Return what the figures of all kinds are called that can be imported."""
    found: set[str] = set()
    for name in kind_names():
        with contextlib.suppress(PolhodeError):
            kind = find_kind(name)
            found |= set(() if kind is None else kind.figure_names)
    return found


def kind_of_source(source: Any) -> AbstractKind | None:
    """Return the kind whose pictures show what a trajectory came from; None where no kind has any of its own."""
    wanted = f"{type(source).__module__}.{type(source).__qualname__}"
    for name in kind_names():
        with contextlib.suppress(PolhodeError):
            kind = find_kind(name)
            if kind is not None and wanted in kind.sources:
                return kind
    return None
